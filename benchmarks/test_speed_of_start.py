"""What a user waits for: import, help, a report; and memory."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from benchmarks.cases import MANY, QUICK, child, duration, measured

Record = Callable[..., None]
RUNS = 2 if QUICK else 5
STATUS = Path("/proc/self/status")
PEAK = f"print(next(row.split()[1] for row in open('{STATUS}') if row.startswith('VmHWM')))"
"""Prints kB; `resource.getrusage` would count what the parent held before the child began."""
BAT = (
    "from sweetspot import analyse, bending_modes, catalog, hits, beam_model, standard_conditions; "
    "b = catalog.bat('r161-ash'); "
)


def command(*arguments: str) -> list[str]:
    """Return the command line, as installed if it is; skip when there is none."""
    if importlib.util.find_spec("sweetspot.cli") is None:
        pytest.skip("the command line is not there")
    script = Path(sys.executable).parent / "sweetspot"
    start = [str(script)] if script.exists() else [sys.executable, "-c", "from sweetspot.cli import main; main()"]
    return [*start, *arguments]


def test_import(benchmark: Any, record: Record) -> None:
    code = "import time; start = time.perf_counter(); import sweetspot; print(time.perf_counter() - start)"
    times = [child(code) for _ in range(RUNS)]
    whole = measured(benchmark, lambda: child(code), RUNS)
    record("import sweetspot", duration(min(times)), goal="250 ms", rival=f"with Python's own start: {duration(whole)}")


def test_help(benchmark: Any, record: Record) -> None:
    words = command("--help")
    seconds = measured(benchmark, lambda: subprocess.run(words, capture_output=True, check=True), RUNS)
    record("sweetspot --help", duration(seconds), goal="300 ms")


def test_report(benchmark: Any, record: Record, tmp_path: Path) -> None:
    words = command("report", "r161-ash", "--out", str(tmp_path))
    if subprocess.run(words, capture_output=True, check=False).returncode:
        pytest.skip("the report does not run here")
    seconds = measured(benchmark, lambda: subprocess.run(words, capture_output=True, check=True), min(3, RUNS))
    record("sweetspot report, picture and page", duration(seconds))


@pytest.mark.parametrize(
    ("job", "code"),
    [
        ("one analysis", BAT + "analyse(b, standard_conditions(b)); "),
        (
            f"{MANY:,} hits",
            BAT + "import numpy as np; m = bending_modes(beam_model(b)); "
            f"hits(m, ball=catalog.ball(), position=np.linspace(.6, .8, {MANY}), closing_speed=70.0); ",
        ),
    ],
    ids=["analysis", "hits"],
)
def test_memory(benchmark: Any, record: Record, job: str, code: str) -> None:
    if not STATUS.exists():
        pytest.skip("this system does not tell a process its greatest memory")
    kilobytes = child(code + PEAK)
    measured(benchmark, lambda: child(code + PEAK), 1)
    record(f"greatest memory, {job}", f"{kilobytes / 1024:.0f} MiB")


@pytest.mark.parametrize(
    ("words", "goal"), [(("--help",), "250 ms"), (("report", "r161-ash"), "600 ms")], ids=["help", "report"]
)
def test_work_of_a_start(benchmark: Any, record: Record, words: tuple[str, ...], goal: str) -> None:
    """Seconds of the processor, which tell on a busy machine too."""
    line = command(*words)
    code = (
        "import os, subprocess; "
        f"subprocess.run({line!r}, capture_output=True, check=True); times = os.times(); "
        "print(times.children_user + times.children_system)"
    )
    child(code)
    work = [child(code) for _ in range(RUNS)]
    measured(benchmark, lambda: child(code), 1)
    record(f"sweetspot {' '.join(words)}, processor time", duration(min(work)), goal=goal)
