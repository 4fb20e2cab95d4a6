"""The time step of a hit, from how fast ball and struck surface swing against each other."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from sweetspot.collision.contact_law import loading_force, unloading_exponent
from sweetspot.dynamics.modes import WALL_SPEED, Modes
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.numerics.arrays import Array

PHASE = 0.48
"""Largest step times the contact's angular frequency; q is then within 1e-4 on every face of the catalogue."""
TERMS, HALVINGS = 10, 48
KEPT = 8192
"""Exponents whose first kick is kept: a few times the draws of one answer."""


def contact_step(modes: Modes, ball: Ball, *, longest: float) -> float:
    """Return the step in s: ``longest``, or less where a light face and a steep ball swing faster than a bat's barrel.

    The ball's steepest slope F' = p F / u, at the peak, and the mass 1 / (1/m + sum s^2) that ball and surface show
    each other swing at omega^2 = F' / (1 + C F') (1/m + sum s^2); the step is no longer than `PHASE` / omega.
    """
    lightness, give = modes.liveliest
    inverse_mass = 1 / ball.mass + lightness
    peak = peak_compression(ball, WALL_SPEED)
    slope = unloading_exponent(ball, peak) * loading_force(ball, peak) / peak
    slope /= 1 + give * slope
    return min(longest, PHASE / math.sqrt(slope * inverse_mass))


@lru_cache(maxsize=KEPT)
def first_kick_after_touch(exponent: float) -> float:
    """Return the steps from touch to the first kick, chosen so that the kicks of a force t^n add up to its integral.

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


def impulse_of_the_turn(shift: float, bend: float, stiffening: float, step: float) -> float:
    """Return the impulse in N s that kicks leave out where the ball turns from loading to unloading.

    There F'' jumps by J = (dF/dw after - dF/dw before) w'', and by Euler's and Maclaurin's sum kicks a step h apart
    give J h^3 B3(x) / 6 less than the integral of F, B3(x) = x (x - 1/2) (x - 1), if the first kick after the turn
    comes x h later.

    Plain arithmetic, which the kernel compiles.

    Parameters
    ----------
    shift : when the approach w is greatest, in steps after the last kick but one.
    bend : h^2 w'', second difference of the approaches at the last three kicks, m.
    stiffening : by how much dF/dw grows there, N/m.
    step : h in s.

    >>> round(impulse_of_the_turn(0.75, -1e-4, 5e6, 20e-6), 8), abs(impulse_of_the_turn(0.5, -1e-4, 5e6, 20e-6))
    (-7.813e-05, 0.0)
    """
    late = 1 - shift
    return stiffening * bend * step * late * (late - 0.5) * (late - 1) / 6


def give_of_steps(angular_frequency: Array, step: float) -> Array:
    """Return the deficit of a mode's deflection at kicks from that under the same continuous force, per squared shape.

    Kicks F h move a mode that follows its force by s F h cot(omega h / 2) / (2 omega) at the kicks, which is
    (1 - y cot y) / omega^2 less than s F / omega^2, y = omega h / 2; h^2 / 12 for slow modes and for the ball. Beyond
    y = pi / 2, where kicks come too seldom for a mode, it is a spring instead (`with_quick_modes_as_springs`).

    Parameters
    ----------
    angular_frequency : omega in rad/s, shape (...).
    step : h in s.

    Returns
    -------
    Array
        s^2, shape (...).

    >>> (give_of_steps(np.array([0.0, 5e4]), 20e-6) * 12 / 20e-6**2).round(4)
    array([1.    , 1.0171])
    """
    half = np.clip(angular_frequency * step / 2, 1e-3, math.pi / 2)
    return np.asarray((1 - half / np.tan(half)) * (step / 2) ** 2 / half**2)


def with_quick_modes_as_springs(
    shapes: Array, give: Array, angular_frequency: Array, step: float
) -> tuple[Array, Array]:
    """Return shapes and give of places with those modes as springs that swing more than half a time in a step.

    Kicks come too seldom for them: what they see of such a mode would be its vibration at a few odd moments. Over a
    contact of many steps it follows its force, and deflects by s^2 / omega^2.

    Parameters
    ----------
    shapes : (..., modes), 1/sqrt(kg).
    give : (...), m/N, instantaneous compliance.
    angular_frequency : omega in rad/s, any shape that broadcasts with ``shapes``.
    step : s.

    >>> shapes, give = with_quick_modes_as_springs(np.array([1.0, 2.0]), np.array(1e-9), np.array([1e4, 2e5]), 20e-6)
    >>> print(shapes, f"{give:.2e}")
    [1. 0.] 1.10e-09
    """
    quick = angular_frequency * step > math.pi
    if not quick.any():
        return shapes, give
    springs = np.where(quick, shapes / np.where(quick, angular_frequency, 1.0), 0.0)
    return np.where(quick, 0.0, shapes), np.asarray(give + np.sum(springs**2, axis=-1))


def _zeta(power: float, part: float) -> float:
    """Return Hurwitz's zeta(-n, x) by Euler's and Maclaurin's sum."""
    end = TERMS + part
    rest = end**power * (0.5 - end / (power + 1) - power / 12 / end + power * (power - 1) * (power - 2) / 720 / end**3)
    return float(np.sum((np.arange(TERMS) + part) ** power) + rest)
