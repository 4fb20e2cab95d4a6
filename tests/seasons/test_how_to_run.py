"""What the docs say of clusters can be read by what it is written for, and names what is there."""

from __future__ import annotations

import re
import shutil
import subprocess
from importlib import import_module
from importlib.metadata import entry_points
from pathlib import Path

from distributed.cli import dask_scheduler, dask_worker

GUIDE = (Path(__file__).parents[2] / "docs" / "users" / "analyst.md").read_text("utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", GUIDE, re.DOTALL)


def test_the_job_for_slurm_is_bash_with_options_that_dask_knows() -> None:
    (job,) = blocks("bash")
    if shutil.which("bash"):
        subprocess.run(["bash", "-n"], input=job, text=True, check=True)
    options = [*dask_scheduler.main.params, *dask_worker.main.params]
    names = {name for option in options for name in option.opts}
    lines = [line for line in job.splitlines() if "dask " in line]
    assert len(lines) > 1 and set(re.findall(r"--[a-z-]+", " ".join(lines))) <= names


def test_the_manifest_for_kubernetes_is_one_cluster_whose_parts_fit() -> None:
    cluster = import_module("yaml").safe_load(blocks("yaml")[0])
    assert cluster["kind"] == "DaskCluster" and {"worker", "scheduler"} == set(cluster["spec"])
    worker = cluster["spec"]["worker"]["spec"]
    assert {one["name"] for one in worker["containers"][0]["volumeMounts"]} == {
        one["name"] for one in worker["volumes"]
    }
    commands = {one.name: one.load() for one in entry_points(group="dask_cli")}
    for part in ("scheduler", "worker"):
        program, name, *given = cluster["spec"][part]["spec"]["containers"][0]["args"]
        assert program == "dask" and name == part
        known = {option for one in commands[name].params for option in one.opts}
        assert {word for word in given if word.startswith("--")} <= known
    service = cluster["spec"]["scheduler"]["service"]
    assert service["selector"]["dask.org/cluster-name"] == cluster["metadata"]["name"]
    assert service["ports"][0]["port"] == 8786
