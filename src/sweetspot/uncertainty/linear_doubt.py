"""How sure an exit speed or a comparison is without draws: every source one standard deviation up and down.

An answer is taken as straight in each source, so that the variances of independent ones add up, and what a source adds
is its part. Draws of the same sources say it with the bends: for every bat, racket, club and stick of the catalogue the
half width is theirs to within 7 %, but not how much farther it reaches to one side.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.comparison import Comparison
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.comparison_draws import DrawnComparison, drawn_comparison, drawn_names
from sweetspot.uncertainty.drawn_hits import draws_of, hits_along
from sweetspot.uncertainty.intervals import Reach
from sweetspot.uncertainty.sources import Sources


@dataclass(frozen=True)
class SpeedDoubt:
    """What is not known of an exit speed.

    ``error``: one standard deviation, m/s. ``shares``: part of the variance that every source adds, by its name, the
    greatest first.
    """

    error: float
    shares: Mapping[str, float]


def speed_doubt(analysis: Analysis[Implement], sources: Sources) -> SpeedDoubt | None:
    """Return the uncertainty of the best hit's exit speed; None without a best hit, or without effect of any source.

    The place stays that of the bat as described.
    """
    count = len(sources.names)
    draws = draws_of(analysis.beam, analysis.conditions, sources, count=2 * count, normal=_one_by_one(count))
    hit = hits_along(draws, np.array([analysis.sweet_spots.max_exit_speed]))
    if not np.isfinite(hit.exit_speed).all():
        return None
    up, down = hit.exit_speed[1:].reshape(2, count)
    variances = dict.fromkeys(sources.names, 0.0)
    for name, half in zip(sources.names, ((up - down) / 2).tolist(), strict=True):
        variances[name] += half**2
    whole = sum(variances.values())
    if not whole > 0:
        return None
    ranked = sorted(variances.items(), key=lambda variance: -variance[1])
    return SpeedDoubt(whole**0.5, {name: part / whole for name, part in ranked})


def linear_comparison(comparison: Comparison[Implement], sources: Sequence[Sources]) -> DrawnComparison:
    """Return the answers to a comparison with one source off at a time; `linear_reach` makes intervals of them.

    ``sources``: of every bat; see `drawn_comparison`.
    """
    return drawn_comparison(comparison, sources, normal=_one_by_one(len(drawn_names(comparison, sources))))


def _one_by_one(count: int) -> Array:
    """Return every source one standard deviation up, then every one down, shape (2 * count, count)."""
    return np.vstack([np.eye(count), -np.eye(count)])


def linear_reach(values: Array) -> Reach:
    """Return the half widths of the interval of an answer that is linear in every source.

    ``values``: as described, then with every source one standard deviation up, then down, shape (1 + 2 * count, ...).
    """
    up, down = np.split(values[1:], 2)
    half = REACH * np.sqrt((((up - down) / 2) ** 2).sum(axis=0))
    return Reach(half, half)
