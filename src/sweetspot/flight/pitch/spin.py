"""The spin of a pitch: from rate and axis, or from the way it moves."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.motion.swing_path import Side
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY


def pitch_spin(
    spin_rate: float, *, axis: float, direction: ArrayLike, efficiency: float = 1.0, throws: Side = "right"
) -> Array:
    """Return the spin vector of a pitch in rad/s, shape (3,).

    Statcast's axis lies in the plane that the catcher sees: pi is backspin, 0 topspin, and the ball is pushed along
    (sin axis, 0, -cos axis). What is not active is gyro spin along the path, forwards for a right-handed pitcher.

    Parameters
    ----------
    spin_rate : rad/s, of the whole spin.
    axis : rad.
    direction : of the motion, shape (3,), of any length above zero.
    efficiency : active part of the spin, 0 to 1.
    throws : "right" or "left", the pitcher's hand.

    >>> back = pitch_spin(240.0, axis=math.pi, direction=[0.0, -1.0, 0.0])
    >>> np.cross(back, [0.0, -40.0, 0.0]).round(6).tolist()  # spin x velocity: the push, upwards
    [0.0, 0.0, 9600.0]
    """
    ahead = np.asarray(direction, float) / np.linalg.norm(direction)
    across = np.array([math.cos(axis), 0.0, math.sin(axis)])
    across = across - (across @ ahead) * ahead
    gyro = math.sqrt(1 - efficiency**2) * (1.0 if throws == "right" else -1.0)
    return np.asarray(spin_rate * (efficiency * across / np.linalg.norm(across) + gyro * ahead))


def spin_from_movement(
    velocity: ArrayLike, *, acceleration: ArrayLike, ball: Ball, aerodynamics: Aerodynamics, density: ArrayLike
) -> Array:
    """Return the active spin that makes pitches move as they do, rad/s, shape (..., 3).

    What is left of the acceleration without weight and across the path is lift, k Cl v^2; the lift law is solved for
    the spin factor [nathan_calculator]. Gyro spin does not show.

    ``velocity``, ``acceleration``: m/s and m/s^2, shape (..., 3), best in the middle of the way. ``density``: of the
    air, kg/m^3, > 0.

    Returns
    -------
    NaN for a ball that is pushed more than the law allows at any spin.
    """
    moving = np.asarray(velocity, float)
    speed = np.linalg.norm(moving, axis=-1, keepdims=True)
    ahead = moving / speed
    push = np.asarray(acceleration, float) + np.array([0.0, 0.0, STANDARD_GRAVITY])
    push = push - np.sum(push * ahead, axis=-1, keepdims=True) * ahead
    strength = np.asarray(density, float)[..., None] * math.pi * ball.radius**2 / (2 * ball.mass)
    size = np.linalg.norm(push, axis=-1, keepdims=True)
    lift = size / (strength * speed**2)
    room = aerodynamics.lift_scale - aerodynamics.lift_slope * lift
    factor = (lift * aerodynamics.lift_offset / np.where(room > 0, room, np.nan)) ** (1 / aerodynamics.lift_exponent)
    rate = factor * speed / ball.radius
    return np.asarray(rate * np.cross(ahead, push / np.where(size > 0, size, 1.0)))
