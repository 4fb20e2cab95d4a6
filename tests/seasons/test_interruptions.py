"""Ctrl-C, a full disk and a lost scheduler lose nothing: --resume goes on, and the bytes are the same."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import distributed
import pytest

from sweetspot.cli import main
from sweetspot.errors import InputError
from sweetspot.seasons import cluster
from sweetspot.seasons.cluster import run_on_cluster
from sweetspot.seasons.plan import Plan, do_task
from sweetspot.seasons.season_table import Season, analyse_season
from tests.full_disk import no_file_beyond
from tests.seasons.conftest import files_of, made_up

ROOT = Path(__file__).parents[2]
INTERRUPTED = 130
STOPS = """
import os, signal, sys
from functools import partial
from sweetspot.seasons import season_table

def stops(done, rows):
    if done < rows:
        os.killpg(os.getpgrp(), signal.SIGINT)

real = season_table.analyse_season
season_table.analyse_season = lambda *given, **named: real(*given, **(named | {"progress": stops}))
if __name__ == "__main__":
    from sweetspot.cli import main
    main(sys.argv[1:])
"""
"""The command, and a Ctrl-C to it and all its workers, as a terminal sends it, as soon as a task is done."""
WRITES = """
import sys, time
from pathlib import Path
from sweetspot.numerics.whole_files import written_whole

with written_whole(Path(sys.argv[1])) as file:
    file.write(b"half")
    file.flush()
    print("half written", flush=True)
    sys.stdin.read()
    file.write(b" and whole")
"""
"""A process that is in the middle of a file until its input ends."""


def season(*arguments: object) -> int:
    with pytest.raises(SystemExit) as ended:
        main(["season", *map(str, arguments), "--flight-only"])
    return int(ended.value.code or 0)


def done_in(folder: Path) -> dict[str, int]:
    """Return when the balls of every task were written whose last file is there: others may be half done."""
    names = [f"{path.stem}.parquet" for path in (folder / "done").glob("[0-9]*.json")]
    return {name: (folder / "balls" / name).stat().st_mtime_ns for name in names}


@pytest.fixture(scope="module")
def months(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Tables of four months; the last one is larger."""
    folder = tmp_path_factory.mktemp("months")
    paths = [folder / f"{number}.parquet" for number in range(4)]
    for number, path in enumerate(paths):
        made_up(3000 if number == 3 else 30, seed=number).write_parquet(path)
    return paths


@pytest.fixture(scope="module")
def whole(months: list[Path], tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What they give when nothing happens."""
    folder = tmp_path_factory.mktemp("whole")
    assert season(*months, "--out", folder) == 0
    return files_of(folder)


def test_ctrl_c_keeps_what_is_done(
    months: list[Path],
    whole: dict[str, str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A real SIGINT to this process, as soon as a task is done."""

    def stops(done: int, rows: int) -> None:
        if done < rows:
            signal.raise_signal(signal.SIGINT)

    out = tmp_path / "out"
    with monkeypatch.context() as stopped:
        stopped.setattr("sweetspot.answers.season.analyse_season", partial(stopping, stops))
        assert season(*months, "--out", out) == INTERRUPTED
    go_on(capsys.readouterr().err, months, out, whole)


def test_ctrl_c_to_workers_too_keeps_what_is_done(months: list[Path], whole: dict[str, str], tmp_path: Path) -> None:
    script, out = tmp_path / "stops.py", tmp_path / "out"
    script.write_text(STOPS)
    command = [sys.executable, script, "season", *months, "--out", out, "--flight-only", "--workers", 2]
    ended = subprocess.run(
        [*map(str, command)], capture_output=True, text=True, cwd=ROOT, start_new_session=True, check=False
    )
    assert ended.returncode == INTERRUPTED, ended.stderr
    go_on(ended.stderr, months, out, whole)


def stopping(stops: Callable[[int, int], None], *given: Any, **named: Any) -> Season:
    """Analyse a season, but tell its progress to what stops it."""
    return analyse_season(*given, **(named | {"progress": stops}))


def go_on(stderr: str, months: list[Path], out: Path, whole: dict[str, str]) -> None:
    """Demand that what an interrupted run has done is said and kept, and that the rest is done by another."""
    assert f"sweetspot: interrupted; what is done lies in {out}, and --resume goes on" in stderr
    assert "Traceback" not in stderr
    done = done_in(out)
    assert done
    assert season(*months, "--out", out, "--resume") == 0
    assert files_of(out) == whole and done.items() <= done_in(out).items()


@pytest.fixture
def writers() -> Iterator[Callable[[Path], subprocess.Popen[bytes]]]:
    """Return what starts a process that holds a file half written."""
    started: list[subprocess.Popen[bytes]] = []

    def start(path: Path) -> subprocess.Popen[bytes]:
        process = subprocess.Popen(
            [sys.executable, "-c", WRITES, str(path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            cwd=ROOT,
            env={**os.environ, "PYTHONPATH": str(ROOT / "src")},
        )
        started.append(process)
        assert process.stdout is not None and process.stdout.readline() == b"half written\n"
        return process

    yield start
    for process in started:
        process.kill()
        process.communicate()


def test_what_a_killed_process_left_is_swept_and_what_a_living_one_writes_is_not(
    months: list[Path], whole: dict[str, str], tmp_path: Path, writers: Callable[[Path], subprocess.Popen[bytes]]
) -> None:
    """A real SIGKILL in the middle of a file, and another process in the middle of one while --resume goes on."""
    assert season(*months, "--out", tmp_path) == 0
    balls = tmp_path / "balls"
    missing = balls / "0001-0000000000.parquet"
    missing.unlink()
    dead, living = writers(missing), writers(balls / "0009-0000000000.parquet")
    dead.kill()
    dead.wait()
    assert len(list(balls.glob(".*"))) == 2 and not missing.exists()
    assert season(*months, "--out", tmp_path, "--resume") == 0
    assert [path.name.split(".")[1] for path in tmp_path.rglob(".*")] == ["0009-0000000000"]
    assert files_of(tmp_path) == whole
    living.communicate(b"")
    assert (balls / "0009-0000000000.parquet").read_bytes() == b"half and whole"
    assert not list(tmp_path.rglob(".*"))


@pytest.mark.parametrize("workers", [0, 2])
def test_a_full_disk_keeps_what_is_done(
    months: list[Path], whole: dict[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str], workers: int
) -> None:
    """Workers are refused by the system as this process is; whichever is the first, no file is left half written."""
    with no_file_beyond(200_000):
        assert season(*months, "--out", tmp_path, "--workers", workers) == 2
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1 and "cannot be written: file too large" in said[0] and "--resume" in said[0]
    written = sorted(path.name for path in (tmp_path / "balls").iterdir())
    small = [f"000{number}-0000000000.parquet" for number in range(3)]
    assert written == small if not workers else set(written) <= set(small)
    assert season(*months, "--out", tmp_path, "--resume") == 0
    assert files_of(tmp_path) == whole


def test_no_room_for_the_copy_of_a_csv_file_is_not_the_file_s_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Said in one line, whichever of several tables it is; nothing of the copies is left to fill the disk."""
    tables, out = [tmp_path / "small.csv", tmp_path / "large.csv"], tmp_path / "out"
    made_up(30).write_csv(tables[0])
    made_up(3000).write_csv(tables[1])
    with no_file_beyond(100_000):
        assert season(*tables, "--out", out) == 2
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1 and said[0].startswith(f"sweetspot: {tables[1]} is copied to {out}"), said
    assert "cannot be written: file too large; make room" in said[0]
    assert not out.exists()
    assert season(*tables, "--out", out) == 0


def test_a_disk_that_is_really_full_keeps_what_is_done(
    months: list[Path], whole: dict[str, str], tmp_path: Path
) -> None:
    """A disk in memory of 400 kB, in a namespace of its own; the run goes on from a copy on a larger one."""
    small = tmp_path / "small"
    small.mkdir()
    command = " ".join(
        shlex.quote(str(part))
        for part in (sys.executable, "-m", "sweetspot", "season", *months, "--flight-only", "--out", small / "out")
    )
    script = (
        f"mount -t tmpfs -o size=400k tmpfs {small} || exit 77; {command} > /dev/null; test $? = 2 || exit 3; "
        f"cp -r {small}/out {tmp_path}/kept"
    )
    if shutil.which("unshare") is None:
        pytest.skip("no unshare here")
    ended = subprocess.run(
        ["unshare", "-rm", "sh", "-c", script], capture_output=True, text=True, cwd=ROOT, check=False
    )
    if ended.returncode in (1, 77) and "sweetspot" not in ended.stderr:
        pytest.skip("this system lets nobody mount a disk of their own")
    assert ended.returncode == 0, ended.stderr
    told = r"/\d{4}-0000000000.parquet cannot be written: no space left on device; make room"
    assert re.search(told, ended.stderr), ended.stderr  # which of them depends on who of the threads is first
    assert season(*months, "--out", tmp_path / "kept", "--resume") == 0
    assert files_of(tmp_path / "kept") == whole


def kills(scheduler: Path, plan: Plan, task: object) -> int:
    """Do a task; after the first one the scheduler dies by a real SIGKILL."""
    rows = do_task(plan, task)  # type: ignore[arg-type]
    if scheduler.exists():
        number = int(scheduler.read_text())
        scheduler.unlink()
        os.kill(number, signal.SIGKILL)
    return rows


def hasty(make: Any, *given: Any, **named: Any) -> Any:
    """Return a client that soon gives a lost scheduler up."""
    client = make(*given, **named)
    client._timeout = 1
    return client


def test_a_lost_scheduler_costs_nothing(
    compute: Callable[..., Season], alone: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told, number = tmp_path / "scheduler.json", tmp_path / "number"
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    start = partial(subprocess.Popen[bytes], stderr=subprocess.DEVNULL, env=environment, cwd=ROOT)
    head = [sys.executable, "-m"]
    scheduler = start([*head, "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
                       "--dashboard-address", "127.0.0.1:0", "--scheduler-file", told])  # fmt: skip
    worker = start([*head, "distributed.cli.dask_worker", "--scheduler-file", told, "--no-nanny", "--nthreads", "1",
                    "--no-dashboard", "--death-timeout", "600"])  # fmt: skip
    try:
        deadline = time.monotonic() + 600
        while not told.exists() or not told.read_text():
            assert time.monotonic() < deadline
            time.sleep(0.05)
        address = json.loads(told.read_text())["address"]
        number.write_text(str(scheduler.pid))
        monkeypatch.setattr(cluster, "_do", partial(kills, number))
        monkeypatch.setattr(distributed, "Client", partial(hasty, distributed.Client))
        with pytest.raises(InputError, match="was lost; what is done is kept, --resume goes on"):
            compute(tmp_path / "out", partial(run_on_cluster, scheduler=address))
    finally:
        for process in (worker, scheduler):
            process.kill()
            process.wait()
    done = done_in(tmp_path / "out")
    assert 1 <= len(done) < 9
    compute(tmp_path / "out", resume=True)
    assert files_of(tmp_path / "out") == alone and done.items() <= done_in(tmp_path / "out").items()
