"""The bats of a file, each against each: what the model expects, what was measured, and whether the data can tell."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import sure_sign
from sweetspot.numerics.interval import Interval
from sweetspot.player.goal import Goal
from sweetspot.player.posterior import interval
from sweetspot.player.swung import FEWEST_OF_A_BAT, Swung


@dataclass(frozen=True)
class Pair:
    """Two bats that the player swung.

    Parameters
    ----------
    better, other : names of the bats; the model expects more of the first.
    gain : of the goal, what the model expects of the first beyond the other, over what the data allow.
    chance : part of what the data allow in which the first is better by more than nothing.
    measured : m/s, the difference of the mean exit speeds as they were measured; None: not measured with both.
    goal : what is wanted; where it is exit speed, ``measured`` may gainsay ``gain``.
    """

    better: str
    other: str
    gain: Interval
    chance: float
    measured: Interval | None
    goal: Goal

    @property
    def goal_is_speed(self) -> bool:
        """Whether what was measured is what is wanted."""
        return self.goal.name == "exit-speed"

    @property
    def verdict(self) -> Literal["better", "better by the model", "cannot tell", "gainsaid"]:
        """What can be said of the two.

        "gainsaid" where what was measured surely says the opposite of the model; "better" where measured difference
        and model are both surely above zero; "better by the model" where the model is and what was measured, if it
        was, is not below zero.
        """
        nothing = self.goal.nothing
        measured = self.measured if self.goal_is_speed else None
        sign = 0 if measured is None else sure_sign(measured.low, measured.high, nothing=nothing)
        if sign < 0 < self.gain.value:
            return "gainsaid"
        expected = sure_sign(self.gain.low, self.gain.high, nothing=nothing)
        if expected <= 0 or (measured is not None and measured.value < 0):
            return "cannot tell"
        return "better" if sign > 0 else "better by the model"


def bat_pairs(
    swung: Sequence[Swung], gained: Mapping[str, Array], *, goal: Goal
) -> tuple[tuple[Pair, ...], tuple[str, ...]]:
    """Return every two of the bats that were swung, and the names of those swung too seldom to be compared.

    Parameters
    ----------
    swung : the bats of the file.
    gained : of every bat by name, the expected goal for every draw, shape (draws,), with the same draws and swings.
    goal : what is wanted.
    """
    known = [one for one in swung if one.count >= FEWEST_OF_A_BAT and one.bat.name in gained]
    known.sort(key=lambda one: -float(np.median(gained[one.bat.name])))
    pairs = []
    for first, second in combinations(known, 2):
        more = gained[first.bat.name] - gained[second.bat.name]
        pairs.append(
            Pair(
                first.bat.name, second.bat.name, interval(more), float(np.mean(more > goal.nothing)),
                difference(first.exit_speed, second.exit_speed), goal,
            )
        )  # fmt: skip
    return tuple(pairs), tuple(one.bat.name for one in swung if one.count < FEWEST_OF_A_BAT)


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
