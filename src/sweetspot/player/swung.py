"""The bats of a file side by side as they were measured: no model, only means and how sure they are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.numerics.confidence import ENDS
from sweetspot.numerics.interval import Interval
from sweetspot.player.model import PlayerModel

FEWEST_OF_A_BAT = 3
"""Swings below which the mean of a bat has no interval."""


@dataclass(frozen=True)
class Swung:
    """One bat of a file.

    Parameters
    ----------
    bat : the bat.
    count : swings with it.
    bat_speed, exit_speed : m/s, mean of its swings with its 90 % interval; None: too few were measured.
    """

    bat: Bat
    count: int
    bat_speed: Interval | None
    exit_speed: Interval | None


def swung_bats(model: PlayerModel) -> tuple[Swung, ...]:
    """Return the bats that were swung, the player's own first, with the means of what was measured."""
    swung = []
    for index, table in enumerate(model.bats):
        swings = [swing for swing, bat in zip(model.swings, model.bat_of, strict=True) if bat == index]
        if swings:
            swung.append(
                Swung(
                    table.bat, len(swings), mean_with_interval([one.bat_speed for one in swings]),
                    mean_with_interval([one.exit_speed for one in swings]),
                )
            )  # fmt: skip
    return tuple(swung)


def mean_with_interval(values: Sequence[float | None]) -> Interval | None:
    """Return the mean of what was measured with its 90 % interval, None of fewer than three values.

    mean +- t s / sqrt(n), with Student's t of n - 1 degrees of freedom.

    >>> mean_with_interval([1.0, 2.0, 3.0, None])  # t = 2.920, s = 1
    Interval(value=2.0, low=0.3141..., high=3.6858...)
    """
    from scipy.special import stdtrit

    known = np.array([value for value in values if value is not None])
    if len(known) < FEWEST_OF_A_BAT:
        return None
    half = float(stdtrit(len(known) - 1, ENDS[1])) * float(known.std(ddof=1)) / math.sqrt(len(known))
    middle = float(known.mean())
    return Interval(middle, middle - half, middle + half)
