"""Which of several bats is best for a player, with the chance of each, and whether the player's own swings say so.

Whether swings say anything is measured as it is of parameters: by the width of what they allow over the width of what
holds for anybody, a player of whom no swing is known.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Interval
from sweetspot.player.posterior import NOTHING_LEARNED, interval

NAMED = 0.8
"""Chance from which a bat is named the best. Our choice: four times in five it is."""


def width_ratio(gains: Array, usual: Array) -> float:
    """Return the standard deviation of what a player's swings allow over that of what holds for anybody.

    ``gains``, ``usual``: of one gain over the draws of the player, shape (draws,), and of anybody, (others,). Where
    anybody has the same there is nothing to learn: 1.

    >>> width_ratio(np.array([0.0, 1.0]), np.array([0.0, 4.0])), width_ratio(np.array([1.0, 1.0]), np.array([2.0, 2.0]))
    (0.25, 1.0)
    """
    spread = float(np.std(usual))
    return float(np.std(gains)) / spread if spread > 0 else 1.0


@dataclass(frozen=True)
class BatChance:
    """One of several bats: how likely it is the best of them for this player, and for anybody."""

    name: str
    chance: float
    usual: float


@dataclass(frozen=True)
class BatChoice:
    """Several bats, the likeliest best first.

    ``lead``: of the goal, the first's gain over the second. ``width_ratio``: of that lead, see `width_ratio`.
    """

    bats: tuple[BatChance, ...]
    lead: Interval
    width_ratio: float

    @property
    def own(self) -> bool:
        """Whether the player's own swings say which of the first two is better."""
        return self.width_ratio < NOTHING_LEARNED

    @property
    def best(self) -> BatChance | None:
        """The bat that is named the best; None: the swings cannot tell."""
        return self.bats[0] if self.own and self.bats[0].chance >= NAMED else None


def bat_choice(gained: Mapping[str, Array], usual: Mapping[str, Array]) -> BatChoice | None:
    """Return which of several bats is best, None of fewer than two.

    ``gained``, ``usual``: by bat, what is expected with it over the draws of the player, and of anybody; the same draws
    for every bat.

    >>> gained = {"a": np.zeros(10), "b": np.linspace(-1, 8, 10)}
    >>> bat_choice(gained, {"a": np.zeros(2), "b": np.array([-9, 9])}).best
    BatChance(name='b', chance=0.8, usual=0.5)
    """
    if len(gained) < 2:
        return None
    chances, usually = _chances(gained), _chances(usual)
    ranked = sorted(gained, key=lambda name: (-chances[name], -float(np.median(gained[name]))))
    first, second = ranked[:2]
    lead = gained[first] - gained[second]
    return BatChoice(
        tuple(BatChance(name, chances[name], usually[name]) for name in ranked),
        interval(lead),
        width_ratio(lead, usual[first] - usual[second]),
    )


def _chances(gained: Mapping[str, Array]) -> dict[str, float]:
    """Return the part of the draws in which each bat is the best."""
    best = np.argmax(np.array(list(gained.values())), axis=0)
    return {name: float(np.mean(best == index)) for index, name in enumerate(gained)}
