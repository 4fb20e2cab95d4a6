"""How bat speeds of a table are spread: full swings about one speed, and what swings that are broken off have lost.

A bat speed is that of a full swing, normal about its mean, less what was lost, which falls off exponentially: few
swings lose much. What was read then tells how much of either there was, on average. It matters because the two are not
alike: readings of full swings scatter to both sides, so those far above the mean were mostly read too fast, while most
slow ones really were slow; and who breaks a swing off meets the ball elsewhere.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.units import MPH

LEAST = 0.25 * MPH
"""m/s, least scatter and least mean loss."""
MOST_LOST = 25 * MPH
"""m/s, beyond which a loss counts no more."""


@dataclass(frozen=True)
class SwingSpeeds:
    """How bat speeds are spread.

    Parameters
    ----------
    full_speed : mean of full swings, m/s.
    full_spread : standard deviation of full swings, m/s.
    lost_speed : mean of what is lost, m/s.
    """

    full_speed: float
    full_spread: float
    lost_speed: float

    def parts(self, bat_speed: Array) -> tuple[Array, Array]:
        """Return how much faster than usual full swings were on average, and what was lost, m/s; NaN where not known.

        The first has the mean 0 over all swings, the second the mean ``lost_speed``. Given what was read, what was lost
        is normal about ``full_speed - bat_speed - full_spread^2 / lost_speed``, cut off at 0: the product of both
        densities.

        >>> faster, lost = USUAL_SPEEDS.parts(np.array([50.0, 80.0]) * MPH)
        >>> (faster / MPH).round(1).tolist(), (lost / MPH).round(1).tolist()
        ([-4.7, 6.3], [20.4, 1.4])
        """
        from scipy.special import log_ndtr

        middle = self.full_speed - bat_speed - self.full_spread**2 / self.lost_speed
        ratio = middle / self.full_spread
        bell = np.exp(-0.5 * ratio**2 - log_ndtr(ratio)) / np.sqrt(2 * np.pi)
        lost = np.clip(middle + self.full_spread * bell, 0, MOST_LOST)
        return np.maximum(bat_speed + lost - self.full_speed, -(self.full_spread**2) / self.lost_speed), lost


USUAL_SPEEDS = SwingSpeeds(75.1 * MPH, 4.1 * MPH, 3.6 * MPH)
"""Of 20,074 tracked swings of at least 40 mph [sure2026]."""


def likeliest_speeds(bat_speed: Array) -> SwingSpeeds:
    """Return the spread that makes bat speeds most likely.

    Parameters
    ----------
    bat_speed : m/s, shape (n,).
    """
    from scipy.optimize import minimize
    from scipy.special import log_ndtr

    middle, width = float(np.mean(bat_speed)), float(np.std(bat_speed))

    def unlikely(numbers: Array) -> float:
        full, scatter, lost = numbers[0], *np.exp(numbers[1:])
        below = full - bat_speed
        each = (
            -np.log(lost) + 0.5 * (scatter / lost) ** 2 - below / lost + log_ndtr((below - scatter**2 / lost) / scatter)
        )
        return -float(each.mean())

    usual = max(width, 2 * LEAST)
    start = np.array([middle + 0.5 * usual, np.log(0.8 * usual), np.log(0.5 * usual)])
    ends = [(None, None), *[(np.log(LEAST), np.log(4 * usual))] * 2]
    found = minimize(unlikely, start, bounds=ends, method="L-BFGS-B").x
    return SwingSpeeds(float(found[0]), float(np.exp(found[1])), float(np.exp(found[2])))
