"""The time step of a hit, from how fast ball and struck surface swing against each other."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from sweetspot.collision.contact_law import loading_force, unloading_exponent
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball

SPEED = 30.0
"""m/s on a rigid wall, where the ball's steepness is taken; it changes little with speed."""
PHASE = 0.4
"""Largest step times the contact's angular frequency; q is then within 1e-4 on every face of the catalogue."""
TERMS, HALVINGS = 10, 48


def contact_step(modes: Modes, ball: Ball, *, longest: float) -> float:
    """Return the step in s: ``longest``, or less where a light face and a steep ball swing faster than a bat's barrel.

    The ball's steepest slope F' = p F / u, at the peak, and the mass 1 / (1/m + sum s^2) that ball and surface show
    each other swing at omega^2 = F' / (1 + C F') (1/m + sum s^2); the step is no longer than `PHASE` / omega.
    """
    lightness, give = modes.liveliest
    inverse_mass = 1 / ball.mass + lightness
    peak = ((ball.exponent + 1) * ball.mass * SPEED**2 / 2 / ball.stiffness) ** (1 / (ball.exponent + 1))
    slope = unloading_exponent(ball, peak) * loading_force(ball, peak) / peak
    slope /= 1 + give * slope
    return min(longest, PHASE / math.sqrt(slope * inverse_mass))


@cache
def first_kick_after_touch(exponent: float) -> float:
    """Return how many steps after touch the first kick comes, so that the kicks of a force t^n add up to its integral.

    Kicks at t = (j + x) h, j = 0, 1, ..., give h^(n+1) zeta(-n, x) more than the integral of t^n, a term of Hurwitz's
    zeta function that falls more slowly with h than the leapfrog's own error. It is zero at x = 1/2 - sqrt(1/12) for
    n = 1, at 1/2 for n = 2, and at 1/2 + 0.26 for n = 3.

    Parameters
    ----------
    exponent : n of the ball's force; beyond 1 to 3 as there.
    """
    power = min(max(exponent, 1.0), 3.0)
    expected = 0.5 + (power - 2) * (0.289 if power < 2 else 0.26)
    low, high = expected - 0.1, expected + 0.1
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if _zeta(power, middle) * _zeta(power, low) > 0 else (low, middle)
    return (low + high) / 2


def _zeta(power: float, part: float) -> float:
    """Return Hurwitz's zeta(-n, x) by Euler's and Maclaurin's sum."""
    end = TERMS + part
    rest = end**power * (0.5 - end / (power + 1) - power / 12 / end + power * (power - 1) * (power - 2) / 720 / end**3)
    return float(np.sum((np.arange(TERMS) + part) ** power) + rest)
