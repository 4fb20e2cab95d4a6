"""Home runs expected and hit, of balls of like launch angle, direction or chance: whether chances hold."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import polars as pl

from sweetspot.numerics.arrays import Array
from sweetspot.seasons.ball_maps import is_home_run
from sweetspot.units import DEGREE

FEWEST_BALLS = 20
"""Balls of a kind below which nothing is said."""
EDGES: Mapping[str, Array] = {
    "launch_angle": np.arange(10.0, 56.0, 5.0) * DEGREE,
    "pull": np.arange(-45.0, 46.0, 15.0) * DEGREE,
    "home_run_here": np.array([0.0, 0.01, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0]),
}
"""Ends of the kinds, SI: by launch angle, by landing direction to the pull side, and by the chance itself."""
UNSURE = 0.15
"""Part by which sums of chances may be wrong, one standard deviation [our choice]: weather and what an unknown park or
ball adds; sums over whole seasons of all clubs are within 0.02."""


@dataclass(frozen=True)
class HomeRunsOf:
    """Home runs of balls of one kind.

    ``low``, ``high``: ends of the kind, SI. ``expected``, ``hit``: how many. ``chance_spread``: standard deviation of
    ``hit`` by chance alone.
    """

    low: float
    high: float
    balls: int
    expected: float
    hit: int
    chance_spread: float


def home_runs_by(counted: pl.LazyFrame, kind: str) -> tuple[HomeRunsOf, ...]:
    """Return home runs expected and hit of each kind of at least `FEWEST_BALLS` balls whose end is known.

    ``kind``: a key of `EDGES`.
    """
    if not {kind, "event", "home_run_here"} <= set(counted.collect_schema().names()):
        return ()
    edges = EDGES[kind]
    value, chance = pl.col(kind).cast(pl.Float64), pl.col("home_run_here").cast(pl.Float64)
    below = pl.sum_horizontal((value >= float(edge)).cast(pl.Int32) for edge in edges[:-1])
    inside = value.is_between(float(edges[0]), float(edges[-1]))
    groups = (
        counted.filter(inside & pl.col("event").is_not_null() & chance.is_not_null())
        .group_by(number=below - 1)
        .agg(
            balls=pl.len(),
            expected=chance.sum(),
            hit=is_home_run(pl.col("event")).fill_null(value=False).sum(),
            variance=(chance * (1 - chance)).sum(),
        )
        .filter(pl.col("balls") >= FEWEST_BALLS)
        .sort("number")
        .collect(engine="streaming")
    )
    lows, highs = edges[:-1].tolist(), edges[1:].tolist()
    return tuple(
        HomeRunsOf(lows[number], highs[number], balls, expected, hit, variance**0.5)
        for number, balls, expected, hit, variance in groups.iter_rows()
    )


def home_run_tail(hit: int, expected: float) -> float:
    """Return the probability of so few home runs or fewer, or so many or more, whichever is smaller.

    Their number is Poisson distributed about a mean that is gamma distributed about the expected one with the relative
    standard deviation `UNSURE`, so it has the negative binomial distribution.

    >>> home_run_tail(0, 11.1) < 1e-4, home_run_tail(85, 113) > 0.02
    (True, True)
    """
    from scipy.special import betainc

    shape = UNSURE**-2
    success = shape / (shape + expected)
    few = float(betainc(shape, hit + 1.0, success))
    many = 1.0 if hit == 0 else float(betainc(float(hit), shape, 1 - success))
    return min(few, many)
