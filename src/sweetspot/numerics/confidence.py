"""How sure every interval of the package is: one level for all of them.

A difference whose interval leaves zero out is called sure. As the interval is central, the chance that the difference
has the other sign is then at most (1 - `LEVEL`) / 2, one in twenty.
"""

from __future__ import annotations

from sweetspot.units import MPH

LEVEL = 0.9
"""Probability that the true value lies inside an interval."""
REACH = 1.6448536269514722
"""Half width of a normal distribution's interval of that level in standard deviations."""
ENDS = (0.05, 0.95)
"""Parts of a distribution that lie below the interval's two ends."""
ROBUST_SCALE = 1.4826
"""Standard deviation of a normal distribution over its median absolute deviation, one over its upper quartile."""
NO_SPEED = 0.05 * MPH
"""m/s that is told as 0.0 mph: no gain, no loss; an interval that begins there leaves the sign open."""


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
