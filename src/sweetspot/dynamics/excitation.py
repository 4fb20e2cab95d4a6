"""Up to which frequency a quick contact beside a striking face excites the shaft behind it."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.dynamics.modes import Modes, joined
from sweetspot.equipment.ball import Ball, peak_compression

AHEAD = 2.0
"""Highest bending mode over the frequency at which ball and face swing against each other: q is then within 2e-4 of
that with eighty modes on a badminton racket, the slowest to converge."""
MOST_MODES = 48
WALL_SPEED = 30.0
"""m/s on a rigid wall, where the ball's steepness is taken; it changes little with speed."""
PLACES = np.linspace(0.4, 1.0, 25)
"""Parts of the length at which the surface is asked how light it is."""


def excited_frequency(bending: Modes, face: Modes, ball: Ball) -> float:
    """Return the frequency in Hz that the highest bending mode must reach beside this face.

    A hard ball of a few grams on light strings is over before a slender shaft's twelfth mode has swung once.

    Parameters
    ----------
    bending : the lowest `MODES`, and the rigid motions.
    """
    together = joined(bending, face)
    places = PLACES * bending.shapes.ends[-1]
    inverse_mass = 1 / ball.mass + float((together.shape_at(places) ** 2).sum(axis=-1).max())
    return AHEAD * math.sqrt(_steepness(ball) * inverse_mass) / (2 * math.pi)


def _steepness(ball: Ball) -> float:
    """Return dF/du in N/m where the ball turns, on a rigid wall at `WALL_SPEED`: n k U^(n-1)."""
    peak = peak_compression(ball, WALL_SPEED)
    return float(ball.exponent * ball.stiffness * peak ** (ball.exponent - 1))
