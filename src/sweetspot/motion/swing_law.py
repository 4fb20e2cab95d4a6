"""Swing speed of the same player with another bat: bat speed against moment of inertia.

Players who were measured with several bats swing slower with the larger moment of inertia, not with the larger
mass: omega goes as I^-n. n = 0 would be the same speed with any bat, n = 1/2 the same energy of rotation in any bat.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sweetspot.errors import InputError
from sweetspot.motion.swing import Swing
from sweetspot.numerics.interval import REACH, Interval

GREATEST_EXPONENT = 0.5
"""A player who gives every bat the same energy; more would mean that a heavier bat gets less [nathan_slides]."""


@dataclass(frozen=True)
class SwingLaw:
    """The published law of one study.

    Raises `InputError` for an exponent outside 0 to 1/2, a negative spread, or a moment of inertia that is not above
    zero.

    Parameters
    ----------
    name : of the law in the catalogue.
    exponent : n, 0 to 1/2.
    exponent_spread : standard deviation of n.
    axis : m from the bottom of the grip towards the tip, where the study takes the moment of inertia.
    lightest_moi : kg m^2 about that axis, of the lightest bats that the power law is known for.
    """

    name: str
    exponent: float
    exponent_spread: float
    axis: float
    lightest_moi: float

    def __post_init__(self) -> None:
        check_exponent(self.exponent)
        if not (math.isfinite(self.exponent_spread) and self.exponent_spread >= 0):
            raise InputError(f"exponent_spread is {self.exponent_spread:g}; allowed is zero or more")
        if not (math.isfinite(self.lightest_moi) and self.lightest_moi > 0):
            raise InputError(f"lightest_moi is {self.lightest_moi:g} kg m^2; allowed is a number above zero")

    @property
    def exponents(self) -> Interval:
        """The exponent with its 90 % interval, cut off at 0 and 1/2."""
        reach = REACH * self.exponent_spread
        low, high = max(0.0, self.exponent - reach), min(GREATEST_EXPONENT, self.exponent + reach)
        return Interval(self.exponent, low, high)

    def speed_ratio(self, moi: float, *, reference_moi: float, exponent: float | None = None) -> float:
        """Return omega / omega_0 of a bat against the bat that the player's swing is known with.

        omega = omega_0 (I / I_0)^-n for bats as heavy as the study's [nathan2011comparative; smith2003swing].

        A power law would let the bat move infinitely fast as I goes to 0, but the player's arms and body have
        inertia too. Below ``lightest_moi`` (I_L) body and bat share a fixed energy instead,
        omega ~ (I + I_body)^(-1/2) with I_body = I_L (1 / (2 n) - 1): there value and slope are the power law's.

        Parameters
        ----------
        moi, reference_moi : kg m^2 about the law's axis, > 0.
        exponent : n in place of the law's own, 0 to 1/2.

        >>> law = SwingLaw("example", exponent=0.29, exponent_spread=0.04, axis=0.0, lightest_moi=0.27)
        >>> round(law.speed_ratio(0.30, reference_moi=0.33), 4)  # (0.33 / 0.30)^0.29
        1.028
        >>> law.speed_ratio(0.30, reference_moi=0.33, exponent=0.0)
        1.0
        """
        power = self.exponent if exponent is None else check_exponent(exponent)
        for value, what in ((moi, "moi"), (reference_moi, "reference_moi")):
            if not (math.isfinite(value) and value > 0):
                raise InputError(f"{what} is {value:g} kg m^2; allowed is a number above zero")
        if moi == reference_moi:
            return 1.0
        return self._relative(moi, power) / self._relative(reference_moi, power)

    def _relative(self, moi: float, exponent: float) -> float:
        """Return omega over that with a bat of ``lightest_moi``."""
        part = moi / self.lightest_moi
        if part >= 1:
            return float(part**-exponent)
        return 1 / math.sqrt(1 - 2 * exponent * (1 - part))


def check_exponent(exponent: float) -> float:
    """Return an exponent between 0 and 1/2, or refuse it."""
    if not 0 <= exponent <= GREATEST_EXPONENT:
        raise InputError(
            f"exponent is {exponent:g}; allowed is 0 (the same speed with any bat) to {GREATEST_EXPONENT:g} "
            "(the same energy in any bat)"
        )
    return exponent


def turned_faster(swing: Swing, ratio: float, *, measured_at: float, pivot: float) -> Swing:
    """Return a swing whose angular speed is ``ratio`` times another's, given at another place of another bat.

    Parameters
    ----------
    measured_at, pivot : of the new swing, m from the knob end of its bat.
    """
    speed = ratio * swing.angular_speed * (measured_at - pivot)
    same_place = (measured_at, pivot) == (swing.measured_at, swing.pivot)
    return swing.replaced(
        bat_speed=ratio * swing.bat_speed if same_place else speed, measured_at=measured_at, pivot=pivot
    )
