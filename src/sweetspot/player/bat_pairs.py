"""The bats of a file: their means as measured, and each against each, expected, measured, and whether data can tell."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, Interval, sure_sign
from sweetspot.player.best_bat import width_ratio
from sweetspot.player.goal import Goal
from sweetspot.player.model import PlayerModel
from sweetspot.player.posterior import NOTHING_LEARNED, interval

FEWEST_OF_A_BAT = 3
"""Swings below which the mean of a bat has no interval."""


@dataclass(frozen=True)
class MeasuredBat:
    """One bat of a file.

    ``bat_speed``, ``exit_speed``: m/s, mean of its swings with its 90 % interval; None: too few were measured.
    """

    bat: Bat
    count: int
    bat_speed: Interval | None
    exit_speed: Interval | None


def measured_bats(model: PlayerModel) -> tuple[MeasuredBat, ...]:
    """Return the bats that were swung, the player's own first, with the means of what was measured."""
    swung = []
    for index, table in enumerate(model.bats):
        swings = [swing for swing, bat in zip(model.swings, model.bat_of, strict=True) if bat == index]
        if swings:
            swung.append(
                MeasuredBat(
                    table.bat,
                    len(swings),
                    mean_with_interval([swing.bat_speed for swing in swings]),
                    mean_with_interval([swing.exit_speed for swing in swings]),
                )
            )
    return tuple(swung)


def mean_with_interval(values: Sequence[float | None]) -> Interval | None:
    """Return the mean of what was measured with its 90 % interval, None of fewer than three values.

    mean +- t s / sqrt(n), with Student's t of n - 1 degrees of freedom.

    >>> mean_with_interval([1.0, 2.0, 3.0, None])  # t = 2.920, s = 1
    Interval(value=2.0, low=0.3141..., high=3.6858...)
    """
    from scipy.special import stdtrit

    measured = np.array([value for value in values if value is not None])
    if len(measured) < FEWEST_OF_A_BAT:
        return None
    half = float(stdtrit(len(measured) - 1, ENDS[1])) * float(measured.std(ddof=1)) / math.sqrt(len(measured))
    middle = float(measured.mean())
    return Interval(middle, middle - half, middle + half)


@dataclass(frozen=True)
class BatPair:
    """Two bats that the player swung.

    ``better``, ``other``: names of the bats; the model expects more of the first. ``gain``: of the goal, what the model
    expects of the first beyond the other, over what the data allow. ``chance``: part of what the data allow in which
    the first is better by more than nothing. ``measured``: m/s, the difference of the mean exit speeds as they were
    measured; None: not measured with both. ``goal``: what is wanted; where it is exit speed, ``measured`` may gainsay
    ``gain``. ``width_ratio``: of the gain, see `sweetspot.player.best_bat.width_ratio`.
    """

    better: str
    other: str
    gain: Interval
    chance: float
    measured: Interval | None
    goal: Goal
    width_ratio: float = 0.0

    @property
    def goal_is_speed(self) -> bool:
        """Whether what was measured is what is wanted."""
        return self.goal.name == "exit-speed"

    @property
    def verdict(self) -> Literal["better", "better by the model", "cannot tell", "gainsaid"]:
        """What can be said of the two.

        "gainsaid" where what was measured surely says the opposite of the model; "better" where measured difference
        and model are both surely above zero; "better by the model" where the model is by the player's own swings and
        what was measured, if it was, is not below zero.
        """
        nothing = self.goal.nothing
        measured = self.measured if self.goal_is_speed else None
        sign = 0 if measured is None else sure_sign(measured.low, measured.high, nothing=nothing)
        if sign < 0 < self.gain.value:
            return "gainsaid"
        expected = sure_sign(self.gain.low, self.gain.high, nothing=nothing)
        if expected <= 0 or (measured is not None and measured.value < 0):
            return "cannot tell"
        if sign > 0:
            return "better"
        return "better by the model" if self.width_ratio < NOTHING_LEARNED else "cannot tell"


def compared_pairs(
    swung: Sequence[MeasuredBat], gained: Mapping[str, Array], usual: Mapping[str, Array], *, goal: Goal
) -> tuple[tuple[BatPair, ...], tuple[str, ...]]:
    """Return every two of the bats that were swung, and the names of those swung too seldom to be compared.

    ``gained``, ``usual``: of every bat by name, the goal expected of the player and of anybody for every draw, shapes
    (draws,) and (others,), with the same draws and swings.
    """
    comparable = [bat for bat in swung if bat.count >= FEWEST_OF_A_BAT and bat.bat.name in gained]
    comparable.sort(key=lambda bat: -float(np.median(gained[bat.bat.name])))
    pairs = []
    for first, second in combinations(comparable, 2):
        more = gained[first.bat.name] - gained[second.bat.name]
        pairs.append(
            BatPair(
                first.bat.name,
                second.bat.name,
                interval(more),
                float(np.mean(more > goal.nothing)),
                difference(first.exit_speed, second.exit_speed),
                goal,
                width_ratio(more, usual[first.bat.name] - usual[second.bat.name]),
            )
        )
    return tuple(pairs), tuple(bat.bat.name for bat in swung if bat.count < FEWEST_OF_A_BAT)


def difference(first: Interval | None, second: Interval | None) -> Interval | None:
    """Return the difference of two means with its 90 % interval, None where one of them is not known.

    The half widths of the two intervals add as squares, as errors of independent means do.

    >>> difference(Interval(41.0, 40.625, 41.375), Interval(40.0, 39.5, 40.5))
    Interval(value=1.0, low=0.375, high=1.625)
    """
    if first is None or second is None:
        return None
    more = first.value - second.value
    half = math.hypot(first.high - first.value, second.high - second.value)
    return Interval(more, more - half, more + half)
