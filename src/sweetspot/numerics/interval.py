"""A number with its 90 % interval, and a curve with the interval of each of its points.

How sure every interval of the package is: one level for all of them.

A difference whose interval leaves zero out is called sure. As the interval is central, the chance that the difference
has the other sign is then at most (1 - `LEVEL`) / 2, one in twenty.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.units import MPH


@dataclass(frozen=True)
class Interval:
    """A value and the ends of its 90 % interval, ``low`` <= ``value`` <= ``high``, all in the same unit.

    A number that is known exactly may be subtracted, or the interval from it:

    >>> 1.0 - Interval(0.75, 0.5, 0.875)
    Interval(value=0.25, low=0.125, high=0.5)
    """

    value: float
    low: float
    high: float

    @property
    def half_width(self) -> float:
        """Half the distance between its ends.

        >>> Interval(1.0, 0.5, 2.0).half_width
        0.75
        """
        return (self.high - self.low) / 2

    def shifted(self, distance: float) -> Interval:
        """Return the interval moved by ``distance``."""
        return Interval(self.value + distance, self.low + distance, self.high + distance)

    def __float__(self) -> float:
        return self.value

    def __neg__(self) -> Interval:
        return Interval(-self.value, -self.high, -self.low)

    def __sub__(self, exact: float) -> Interval:
        return self.shifted(-exact)

    def __rsub__(self, exact: float) -> Interval:
        return (-self).shifted(exact)

    def __rmul__(self, exact: float) -> Interval:
        ends = sorted((exact * self.low, exact * self.high))
        return Interval(exact * self.value, *ends)


@dataclass(frozen=True)
class Band:
    """A curve and the ends of the 90 % interval at each of its points, arrays of one shape (n,) in the same unit."""

    value: Array
    low: Array
    high: Array

    def __getitem__(self, index: int) -> Number:
        value, low, high = (float(side[index]) for side in (self.value, self.low, self.high))
        return Interval(value, low, high) if math.isfinite(low) and math.isfinite(high) else value


Number = float | Interval
"""A number, with its interval where one is known."""
Curve = Array | Band
"""A curve, with its interval where one is known."""


def interval_of(number: Number) -> Interval:
    """Return a number with its interval, of no width where none is known."""
    return number if isinstance(number, Interval) else Interval(number, number, number)


def values_of(curve: Curve) -> Array:
    """Return a curve without its intervals."""
    return curve.value if isinstance(curve, Band) else curve


def interpolated(curve: Curve, places: Array, at: float) -> Number:
    """Return a curve's number between its points, with its interval, where the curve has one."""
    if isinstance(curve, Band):
        return Interval(*(float(np.interp(at, places, side)) for side in (curve.value, curve.low, curve.high)))
    return float(np.interp(at, places, curve))


LEVEL = 0.9
"""Probability that the true value lies inside an interval."""
REACH = 1.6448536269514722
"""Half width of a normal distribution's interval of that level in standard deviations."""
ENDS = (0.05, 0.95)
"""Parts of a distribution that lie below the interval's two ends."""
ROBUST_SCALE = 1.4826
"""Standard deviation of a normal distribution over its median absolute deviation, one over its upper quartile."""
NO_SPEED = 0.05 * MPH
"""m/s that is reported as 0.0 mph: no gain, no loss; an interval that begins there leaves the sign open."""


def chance_above(limit: float, of: Interval) -> float:
    """Return the probability that a number is above a limit: half a normal law on each side of its value.

    >>> round(chance_above(0.0, Interval(1.0, 0.0, 3.0)), 2), chance_above(0.0, Interval(0.0, -1.0, 1.0))
    (0.95, 0.5)
    """
    side = of.value - of.low if limit < of.value else of.high - of.value
    if side <= 0:
        return float(of.value > limit)
    return math.erfc((limit - of.value) / (side / REACH) / math.sqrt(2)) / 2


def sure_sign(low: float, high: float, *, nothing: float) -> int:
    """Return 1 for a difference that is surely a gain, -1 for one that is surely a loss, 0 where the sign is open.

    Parameters
    ----------
    low, high : ends of its interval.
    nothing : in the same unit, the greatest difference that counts as none.

    Examples
    --------
    >>> sure_sign(0.1, 0.9, nothing=0.05), sure_sign(0.01, 0.9, nothing=0.05), sure_sign(-0.9, -0.1, nothing=0.05)
    (1, 0, -1)
    """
    return 1 if low > nothing else -1 if high < -nothing else 0
