"""How the air pushes a ball: coefficients of drag and lift as functions of spin."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from sweetspot.thing import NonNegative, Positive, Thing

SMALLEST_SPIN_FACTOR = 1e-9
"""Below this spin factor a law with an exponent under one is taken at it, where its force has long been nothing."""


class Aerodynamics(Thing):
    """Coefficients of drag and lift of one kind of ball.

    With the spin factor S = R w_perp / v, w_perp the part of the spin across the path, w the whole spin and v the
    speed through the air,

        Cd = drag + drag_per_spin w + drag_per_spin_factor S
        Cl = lift_scale S^n / (lift_offset + lift_slope S^n)
        dw/dt = -(v / spin_decay_speed) w / spin_decay_time

    Several published laws are this one with other numbers: Nathan's for the baseball (1.120 S / (0.583 + 2.333 S))
    [nathan_calculator], 1 / (2 + v / (R w)) of tennis (scale 1, offset 1, slope 2), a S^0.4 of golf, and a body
    without lift (scale 0).

    Parameters
    ----------
    name : what people call it.
    drag : Cd without spin, >= 0.
    drag_per_spin : s, >= 0.
    drag_per_spin_factor : >= 0.
    lift_scale, lift_offset, lift_slope : >= 0, the offset > 0.
    lift_exponent : n, above 0 to 2.
    spin_decay_time : s, in which the spin falls to 1/e at the decay speed; None: the spin stays.
    spin_decay_speed : m/s, > 0.
    """

    name: str = "no name"
    drag: NonNegative
    drag_per_spin: NonNegative = 0.0
    drag_per_spin_factor: NonNegative = 0.0
    lift_scale: NonNegative = 0.0
    lift_offset: Positive = 1.0
    lift_slope: NonNegative = 0.0
    lift_exponent: Annotated[float, Field(gt=0, le=2)] = 1.0
    spin_decay_time: Positive | None = None
    spin_decay_speed: Positive = 44.704

    @property
    def spin_decay_rate(self) -> float:
        """Part of the spin lost per metre of way through the air, 1/m; 0 where the spin stays."""
        return 0.0 if self.spin_decay_time is None else 1 / (self.spin_decay_time * self.spin_decay_speed)

    def drag_coefficient(self, spin_factor: float, *, spin: float) -> float:
        """Return Cd.

        Parameters
        ----------
        spin_factor : S, >= 0.
        spin : w, rad/s, >= 0, the whole spin.
        """
        return self.drag + self.drag_per_spin * spin + self.drag_per_spin_factor * spin_factor

    def lift_coefficient(self, spin_factor: float) -> float:
        """Return Cl for a spin factor S >= 0."""
        return spin_factor * self.lift_over_spin_factor(spin_factor)

    def lift_over_spin_factor(self, spin_factor: float) -> float:
        """Return Cl / S, which has a value also where there is no spin."""
        factor = max(spin_factor, SMALLEST_SPIN_FACTOR)
        power = float(factor**self.lift_exponent)
        return self.lift_scale * power / factor / (self.lift_offset + self.lift_slope * power)
