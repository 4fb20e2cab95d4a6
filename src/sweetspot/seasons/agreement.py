"""How a season's answers agree with what its tables tell: home runs and tracked distances, by kinds of balls."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from sweetspot.seasons.home_run_table import HomeRunsOf
from sweetspot.seasons.season_drag import LeftOver
from sweetspot.units import FOOT
from sweetspot.units.dimensions import DISTANCE

PART, DEVIATIONS, APART = 0.1, 2.0, 5 * FOOT
"""Part of the home runs, standard deviations of chance, and m of distance, within which a kind of balls agrees."""
LAUNCHED = ("launch_angle", "pull")
"""Kinds that home runs are compared by; by their own chance stands in a table of its own."""


@dataclass(frozen=True)
class Agreement:
    """Kinds of balls whose answers agree with the tables.

    Parameters
    ----------
    home_run_kinds, home_runs_agree : kinds by launch angle and direction, and how many have as many home runs as
        expected, within a tenth or two standard deviations of chance.
    distance_kinds, distances_agree : the same of tracked distances, within 5 ft or two standard errors.
    distance_above : mean tracked distance less the carry computed; None: no table tells.
    """

    home_run_kinds: int
    home_runs_agree: int
    distance_kinds: int
    distances_agree: int
    distance_above: Annotated[float | None, DISTANCE]


def agreement_of(
    home_runs: Mapping[str, Sequence[HomeRunsOf]], distances: Mapping[str, Sequence[LeftOver]]
) -> Agreement:
    """Return how home runs and tracked distances agree, by what they are compared by.

    >>> home_runs = {"launch_angle": [HomeRunsOf(0.4, 0.5, 100, 9.0, 12, 2.0), HomeRunsOf(0.5, 0.6, 100, 9.0, 20, 2.0)]}
    >>> agreement_of(home_runs, {}).home_runs_agree
    1
    """
    kinds = [group for name in LAUNCHED for group in home_runs.get(name, ()) if group.hit or group.expected >= 1]
    agree = [
        abs(group.hit - group.expected) <= max(PART * group.hit, DEVIATIONS * group.chance_spread) for group in kinds
    ]
    groups = [group for name, found in distances.items() if name != "park" for group in found]
    near = [abs(group.mean) <= max(APART, DEVIATIONS * group.error) for group in groups]
    return Agreement(len(kinds), sum(agree), len(groups), sum(near), _mean(distances.get("launch_angle", ())))


def _mean(groups: Iterable[LeftOver]) -> float | None:
    """Return the mean over all balls of groups; None of none."""
    pairs = [(group.mean, group.balls) for group in groups]
    return sum(mean * balls for mean, balls in pairs) / sum(balls for _, balls in pairs) if pairs else None
