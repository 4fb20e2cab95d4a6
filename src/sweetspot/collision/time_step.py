"""The time step of a hit, from how fast ball and struck surface swing against each other."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.collision.contact_law import loading_force, unloading_exponent
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball

SPEED = 30.0
"""m/s on a rigid wall, where the ball's steepness is taken; it changes little with speed."""
PHASE = 0.3
"""Largest step times the contact's angular frequency; q is then within 1e-4 on every face of the catalogue."""
PLACES = np.linspace(0.4, 1.0, 25)
"""Parts of the length at which the surface is asked how light it is."""


def contact_step(modes: Modes, ball: Ball, *, longest: float) -> float:
    """Return the step in s: ``longest``, or less where a light face and a steep ball swing faster than a bat's barrel.

    The ball's steepest slope F' = p F / u, at the peak, and the mass 1 / (1/m + sum s^2) that ball and surface show
    each other swing at omega^2 = F' / (1 + C F') (1/m + sum s^2); the step is no longer than `PHASE` / omega.
    """
    places = modes.shapes.ends[0] + PLACES * (modes.shapes.ends[-1] - modes.shapes.ends[0])
    inverse_mass = 1 / ball.mass + float((modes.shape_at(places) ** 2).sum(axis=-1).max())
    peak = ((ball.exponent + 1) * ball.mass * SPEED**2 / 2 / ball.stiffness) ** (1 / (ball.exponent + 1))
    slope = unloading_exponent(ball, peak) * loading_force(ball, peak) / peak
    slope /= 1 + float(modes.compliance_at(places).min()) * slope
    return min(longest, PHASE / math.sqrt(slope * inverse_mass))
