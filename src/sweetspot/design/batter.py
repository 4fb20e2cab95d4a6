"""Who the bat is for: where and how high the ball is met, how fast the swing is, and how it depends on the bat."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sweetspot.design.contacts import FROM_TIP, ContactPlaces
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.units import INCH

RARE = 0.02
"""Part of the contacts on either side that is left out: the farthest of a scatter would be met once in a career."""
USUAL_PLACES = 8


@dataclass(frozen=True)
class Batter:
    """A batter with the present bat.

    Parameters
    ----------
    weight : part of the contacts at every place of `FROM_TIP`, shape (places,), summing to 1.
    offset, offset_spread : mean and standard deviation of the ball's centre above the bat's axis, m.
    bat_speed : m/s with the present bat, ``speed_from_tip`` m from its tip.
    pitch_speed : m/s at the plate; 0: a tee.
    law : of bat speed against moment of inertia; None: every bat is swung alike.
    doubt : standard deviation in m of where the mean contact lies, beyond what ``sample`` leaves open.
    speed_from_tip : m.
    sample : what balls tell of the contacts, and leave open; None: the contacts were told by somebody.
    """

    weight: Array
    offset: float
    offset_spread: float
    bat_speed: float
    pitch_speed: float
    law: SwingLaw | None
    doubt: float
    speed_from_tip: float = 6 * INCH
    sample: ContactPlaces | None = None

    @property
    def mean_contact(self) -> float:
        """Mean place of contact, m from the tip."""
        return float(self.weight @ FROM_TIP)

    def moved(self, distance: float) -> Batter:
        """Return the same batter who meets every ball ``distance`` m nearer the hands; what leaves the bat is lost."""
        weight = np.interp(FROM_TIP - distance, FROM_TIP, self.weight, left=0.0, right=0.0)
        return replace(self, weight=weight / weight.sum())


def usual_places(batter: Batter) -> IntArray:
    """Return which of `FROM_TIP` lie evenly among all but the rarest of a batter's contacts, shape (places,)."""
    before = np.cumsum(batter.weight) - batter.weight
    inside = np.flatnonzero((before + batter.weight > RARE) & (before < 1 - RARE))
    return np.asarray(inside[np.unique(np.linspace(0, len(inside) - 1, USUAL_PLACES).round().astype(int))])
