"""What the benchmarks run on, how they time, and what they hand to the table at the end."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sweetspot import Ball, BeamModel, beam_model, bending_modes, catalog
from sweetspot.dynamics.modes import Modes

Array = NDArray[np.float64]

QUICK = os.environ.get("SWEETSPOT_BENCH_QUICK", "") not in ("", "0")
"""Small sizes and few rounds: enough to see that everything runs."""
ROUNDS = 3 if QUICK else 20
MANY = 20_000 if QUICK else 1_000_000
PLACE, CLOSING = 0.70, 71.5
"""m from the knob end and m/s (160 mph): the one hit that everybody computes."""
PITCH = 40.0


@dataclass(frozen=True)
class Figure:
    """One row of the table: what was done, how it went, the project's goal, and the rival with its ratio."""

    job: str
    figure: str
    goal: str = ""
    rival: str = ""
    ratio: str = ""


@cache
def beam() -> BeamModel:
    """Return the bat: an ash one with 18 stations."""
    return beam_model(catalog.bat("r161-ash"))


@cache
def modes() -> Modes:
    """Return its two rigid motions and twelve bending modes."""
    return bending_modes(beam())


@cache
def ball() -> Ball:
    """Return the ball."""
    return catalog.ball()


def game_hits(count: int) -> tuple[Array, Array]:
    """Return random positions (m) and closing speeds (m/s) of hits on the barrel at game speed."""
    generator = np.random.default_rng(20)
    return generator.uniform(0.60, 0.82, count), generator.uniform(60.0, 80.0, count)


def exit_speed(efficiency: Array, closing: Array) -> Array:
    """Return exit speeds in m/s for a 40 m/s pitch."""
    return np.asarray(efficiency * PITCH + (1 + efficiency) * (closing - PITCH))


def best(function: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Return the shortest of several times in s: other work on the machine only ever adds to a time."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def measured(benchmark: Any, function: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Return the shortest time in s, measured by pytest-benchmark unless that is switched off."""
    benchmark.pedantic(function, rounds=rounds, iterations=1, warmup_rounds=1)
    return float(benchmark.stats.stats.min) if benchmark.stats else best(function, 1)


def child(code: str) -> float:
    """Return the number that a fresh Python prints last."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(done.stdout.split()[-1])


def duration(seconds: float) -> str:
    """Return a time as people read it."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def machine() -> list[str]:
    """Return lines that say what the figures were measured on."""
    processor = platform.processor() or platform.machine()
    about = Path("/proc/cpuinfo")
    if about.exists():
        names = [row.split(":", 1)[1].strip() for row in about.read_text().splitlines() if row.startswith("model name")]
        processor = names[0] if names else processor
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    load = f", load {os.getloadavg()[0]:.1f} at the end" if hasattr(os, "getloadavg") else ""
    versions = ", ".join(f"{name} {_version(name)}" for name in ("numpy", "scipy", "numba", "scikit-fem", "mujoco"))
    return [
        f"{processor}, {cores} cores{load}; {platform.system()} {platform.machine()}",
        f"Python {platform.python_version()}, {versions}",
        "quick run: sizes are cut, figures mean little" if QUICK else f"times are the best of {ROUNDS} rounds or fewer",
    ]


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "absent"
