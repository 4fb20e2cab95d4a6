"""What a longer time step buys, and what it costs in exit speed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.cases import MANY, QUICK, ball, best, exit_speed, game_hits, measured, modes
from sweetspot import hits
from sweetspot.collision import kernel

STEPS = (4, 8, 12, 16, 20, 26, 32, 40)
"""us."""


def test_error_against_rate(
    benchmark: Any, record: Callable[..., None], record_table: Callable[[list[str]], None]
) -> None:
    count, timed = (500, 5000) if QUICK else (20_000, MANY // 10)
    places, closing = game_hits(timed)
    few = slice(0, count)

    def run(step: float, rows: slice = slice(None)) -> Any:
        return hits(modes(), ball=ball(), position=places[rows], closing_speed=closing[rows], step=step, threads=2)

    def exit_speeds(step: float) -> Any:
        return exit_speed(run(step, few).collision_efficiency, closing[few])

    converged = exit_speeds(0.5e-6)
    lines = [
        f"step against error of the exit speed ({count:,} hits) and rate (2 threads)",
        "  us     max       rms       hits/s",
    ]
    for micro in STEPS:
        errors = np.abs(exit_speeds(micro * 1e-6) / converged - 1)
        rate = timed / best(lambda step=micro * 1e-6: run(step), 2 if QUICK else 4)  # type: ignore[misc]
        rms = float(np.sqrt(np.mean(errors**2)))
        lines.append(
            f"  {micro:2d}  {errors.max():.1e}   {rms:.1e}  {rate:>10,.0f}"
            + ("  default" if micro == round(kernel.STEP * 1e6) else "")
        )
    record_table(lines)
    measured(benchmark, lambda: run(kernel.STEP), 2)
    at_default = np.abs(exit_speeds(kernel.STEP) / converged - 1)
    record("exit-speed error at the default step", f"max {at_default.max():.1e}", goal="1e-4")
    assert at_default.max() < 1e-4
