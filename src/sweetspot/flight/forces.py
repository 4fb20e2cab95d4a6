"""What acts on a ball in flight: weight, drag against its way through the air, and the lift of its spin.

Only spin across the path lifts; the part along the path (gyro spin) does nothing but tire.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import VISCOSITY, Aerodynamics
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY

SLOWEST = 1e-9
"""m/s; slower than this through the air there is neither drag nor lift."""


def acceleration(velocity: Array, *, spin: Array, ball: Ball, aerodynamics: Aerodynamics, density: float) -> Array:
    """Return the acceleration of a ball in m/s^2, shape (3,).

    a = -g z - k Cd u u_vector + k Cl u^2 (spin x u_vector) / |spin x u_vector|, k = rho pi R^2 / (2 m)
    [nathan_calculator]. With S = R |spin x u_vector| / u^2 the lift is k (Cl / S) R (spin x u_vector), which stays
    finite where nothing spins.

    Parameters
    ----------
    velocity : through the air (the ball's less the wind's), m/s, shape (3,).
    spin : rad/s, shape (3,).
    density : of the air, kg/m^3, >= 0.
    """
    push = drag_and_lift(velocity, spin=spin, ball=ball, aerodynamics=aerodynamics, density=density)
    return np.array([0.0, 0.0, -STANDARD_GRAVITY]) + push[0] + push[1]


def drag_and_lift(
    velocity: Array, *, spin: Array, ball: Ball, aerodynamics: Aerodynamics, density: float
) -> tuple[Array, Array]:
    """Return the accelerations by drag and by lift in m/s^2, each of shape (3,); see `acceleration`."""
    speed = math.sqrt(float(velocity @ velocity))
    if speed < SLOWEST:  # no direction to push in
        return np.zeros(3), np.zeros(3)
    across = np.array(
        [
            spin[1] * velocity[2] - spin[2] * velocity[1],
            spin[2] * velocity[0] - spin[0] * velocity[2],
            spin[0] * velocity[1] - spin[1] * velocity[0],
        ]
    )
    spin_factor = ball.radius * math.sqrt(float(across @ across)) / speed**2
    strength = density * math.pi * ball.radius**2 / (2 * ball.mass)
    reynolds = 2 * density * ball.radius * speed / VISCOSITY
    active = spin_factor * speed / ball.radius
    drag = (
        aerodynamics.drag_coefficient(
            spin_factor, spin=math.sqrt(float(spin @ spin)), active_spin=active, reynolds=reynolds
        )
        if density > 0
        else 0.0
    )
    lift = aerodynamics.lift_over_spin_factor(spin_factor) * ball.radius
    return -strength * drag * speed * velocity, strength * lift * across
