"""Aerodynamic forces on a ball: coefficients of drag and lift as functions of spin.

What acts on a ball in flight: weight, drag against its way through the air, and the lift of its spin.

Only spin across the path lifts; the part along the path (gyro spin) only decays.
"""

from __future__ import annotations

import math
from typing import Annotated, Protocol, Self

import numpy as np
from pydantic import Field, model_validator

from sweetspot.equipment.ball import Ball
from sweetspot.equipment.base import NonNegative, Positive, Validated
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY

SMALLEST_SPIN_FACTOR = 1e-9
"""Below this spin factor a law with an exponent under one is taken at it, where its force has long been nothing."""

REFERENCE_REYNOLDS = 2e5
"""Re_0, about that of a baseball at 90 mph by the sea."""
VISCOSITY = 1.82e-5
"""Pa s, of air at 21 degC, 1.458e-6 T^1.5 / (T + 110.4) with T in K [standard_atmosphere1976]."""


class SpinLaw(Protocol):
    """The numbers of an `Aerodynamics`; the compiled flight has them in a record of its own."""

    @property
    def drag(self) -> float: ...
    @property
    def drag_per_spin(self) -> float: ...
    @property
    def drag_per_active_spin(self) -> float: ...
    @property
    def drag_per_spin_factor(self) -> float: ...
    @property
    def lift_scale(self) -> float: ...
    @property
    def lift_offset(self) -> float: ...
    @property
    def lift_slope(self) -> float: ...


def drag_with_spin(law: SpinLaw, spin_factor: float, spin: float, active_spin: float) -> float:
    """Return Cd but for its part with Reynolds's number; see `Aerodynamics`. Plain arithmetic, which kernels compile.

    ``spin_factor``, ``spin``, ``active_spin``: S, w and w_perp, rad/s, >= 0.
    """
    return (
        law.drag
        + law.drag_per_spin * spin
        + law.drag_per_active_spin * active_spin
        + law.drag_per_spin_factor * spin_factor
    )


def lift_by_power(law: SpinLaw, raised: float, steepness: float) -> float:
    """Return Cl / S from S^n and S^n / S; see `Aerodynamics`. Plain arithmetic, which kernels compile.

    ``raised``, ``steepness``: S^n and S^n / S.
    """
    return law.lift_scale * steepness / (law.lift_offset + law.lift_slope * raised)


class Aerodynamics(Validated):
    """Coefficients of drag and lift of one kind of ball.

    With the spin factor S = R w_perp / v, w_perp the part of the spin across the path, w the whole spin and v the
    speed through the air,

        Cd = drag + drag_per_spin w + drag_per_active_spin w_perp + drag_per_spin_factor S + Cd_Re
        Cd_Re = drag_per_inverse_reynolds (Re_0 / Re - 1)
        Cl = lift_scale S^n / (lift_offset + lift_slope S^n)
        dw/dt = -(v / spin_decay_speed) w / spin_decay_time

    where Re = 2 rho R v / mu is Reynolds's number, Re_0 `REFERENCE_REYNOLDS`, and mu `VISCOSITY`. The part with 1 / Re
    is a force linear in the speed and alike in thin air and thick, so it has a limit for a ball at rest.

    Several published laws are this one with other numbers: Nathan's for the baseball (1.120 S / (0.583 + 2.333 S))
    [nathan_calculator], 1 / (2 + v / (R w)) of tennis (scale 1, offset 1, slope 2), a S^0.4 of golf, and a body
    without lift (scale 0).

    Parameters
    ----------
    name : what people call it.
    drag : Cd without spin, >= 0.
    drag_per_spin : s, >= 0, for the whole spin.
    drag_per_active_spin : s, >= 0, for the spin across the path.
    drag_per_spin_factor : >= 0.
    drag_per_inverse_reynolds : >= 0, at most the drag; what Cd gains when Reynolds's number falls to half of Re_0.
    lift_scale, lift_offset, lift_slope : >= 0, the offset > 0.
    lift_exponent : n, above 0 to 2.
    spin_decay_time : s, in which the spin falls to 1/e at the decay speed; None: the spin stays.
    spin_decay_speed : m/s, > 0.
    """

    name: str = "no name"
    drag: NonNegative
    drag_per_spin: NonNegative = 0.0
    drag_per_active_spin: NonNegative = 0.0
    drag_per_spin_factor: NonNegative = 0.0
    drag_per_inverse_reynolds: NonNegative = 0.0
    lift_scale: NonNegative = 0.0
    lift_offset: Positive = 1.0
    lift_slope: NonNegative = 0.0
    lift_exponent: Annotated[float, Field(gt=0, le=2)] = 1.0
    spin_decay_time: Positive | None = None
    spin_decay_speed: Positive = 44.704

    @model_validator(mode="after")
    def _never_pulls(self) -> Self:
        if self.drag_per_inverse_reynolds > self.drag:
            raise ValueError(
                f"drag_per_inverse_reynolds is {self.drag_per_inverse_reynolds:g}, more than the drag of "
                f"{self.drag:g}: a fast ball would be pulled along; give a smaller one"
            )
        return self

    @property
    def spin_decay_rate(self) -> float:
        """Part of the spin lost per metre of way through the air, 1/m; 0 where the spin stays."""
        return 0.0 if self.spin_decay_time is None else 1 / (self.spin_decay_time * self.spin_decay_speed)

    @property
    def lift_power(self) -> float | None:
        """Exponent of the lift, None for 1: kernels then need no power."""
        return None if self.lift_exponent == 1 else self.lift_exponent

    def drag_coefficient(
        self, spin_factor: float, *, spin: float, active_spin: float = 0.0, reynolds: float = REFERENCE_REYNOLDS
    ) -> float:
        """Return Cd.

        ``spin_factor``: S, >= 0. ``spin``, ``active_spin``: w and w_perp, rad/s, >= 0. ``reynolds``: Re, > 0.
        """
        viscous = self.drag_per_inverse_reynolds * (REFERENCE_REYNOLDS / reynolds - 1)
        return drag_with_spin(self, spin_factor, spin, active_spin) + viscous

    def with_drag(self, factor: float) -> Aerodynamics:
        """Return the law of a ball with so much times the drag, every part of it; its lift stays.

        >>> Aerodynamics(drag=0.3, drag_per_spin=1e-4).with_drag(1.1).drag
        0.33
        """
        parts = ("drag", "drag_per_spin", "drag_per_active_spin", "drag_per_spin_factor", "drag_per_inverse_reynolds")
        return self.replaced(**{name: round(factor * getattr(self, name), 12) for name in parts})

    def viscous_rate(self, *, radius: float, mass: float) -> float:
        """Return the braking by the part of drag that is linear in speed, Cd rho A v / (2 m) at Cd = c Re_0 / Re, 1/s.

        ``radius``, ``mass``: of the ball, m and kg, > 0.
        """
        return self.drag_per_inverse_reynolds * REFERENCE_REYNOLDS * VISCOSITY * math.pi * radius / (4 * mass)

    def lift_coefficient(self, spin_factor: float) -> float:
        """Return Cl for a spin factor S >= 0."""
        return spin_factor * self.lift_over_spin_factor(spin_factor)

    def lift_over_spin_factor(self, spin_factor: float) -> float:
        """Return Cl / S, which has a value also where there is no spin."""
        factor = max(spin_factor, SMALLEST_SPIN_FACTOR)
        power = float(factor**self.lift_exponent)
        return lift_by_power(self, power, power / factor)


SLOWEST = 1e-9
"""m/s; slower than this through the air there is neither drag nor lift."""


def acceleration(velocity: Array, *, spin: Array, ball: Ball, aerodynamics: Aerodynamics, density: float) -> Array:
    """Return the acceleration of a ball in m/s^2, shape (3,).

    a = -g z - k Cd u u_vector + k Cl u^2 (spin x u_vector) / |spin x u_vector|, k = rho pi R^2 / (2 m)
    [nathan_calculator]. With S = R |spin x u_vector| / u^2 the lift is k (Cl / S) R (spin x u_vector), which stays
    finite where nothing spins.

    ``velocity``: through the air (the ball's less the wind's), m/s, shape (3,). ``spin``: rad/s, shape (3,).
    ``density``: of the air, kg/m^3, >= 0.
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
