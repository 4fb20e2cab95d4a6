"""The time step of a hit, from how fast ball and struck surface swing against each other."""

from __future__ import annotations

import math

from sweetspot.collision.contact_law import loading_force, unloading_exponent
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball

SPEED = 30.0
"""m/s on a rigid wall, where the ball's steepness is taken; it changes little with speed."""
PHASE = 0.3
"""Largest step times the contact's angular frequency; q is then within 1e-4 on every face of the catalogue."""


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
