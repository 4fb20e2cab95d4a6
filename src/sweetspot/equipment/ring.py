"""A ring or a disc inside a hollow barrel, which keeps it round."""

from __future__ import annotations

import math

from pydantic import model_validator

from sweetspot.equipment.base import Positive, Validated
from sweetspot.equipment.material import Material


class Ring(Validated):
    """A flat ring fixed to the innermost wall of a barrel, across its axis.

    Parameters
    ----------
    position : m from the knob end, of its middle.
    width : m along the bat.
    depth : m from the wall inwards; None: to the axis, a solid disc.
    material : of the ring, alike in all directions of its plane.
    """

    position: Positive
    width: Positive
    depth: Positive | None = None
    material: Material

    @model_validator(mode="after")
    def _lies_on_the_bat(self) -> Ring:
        if self.position <= self.width / 2:
            raise ValueError(f"the ring at {self.position:.4g} m, {self.width:.4g} m wide, reaches beyond the knob")
        return self

    @property
    def ends(self) -> tuple[float, float]:
        """Where it begins and ends, m from the knob end."""
        return self.position - self.width / 2, self.position + self.width / 2

    def hole(self, outer: float) -> float:
        """Return the radius in m of the hole in its middle, for a ring of outer radius ``outer`` m."""
        return 0.0 if self.depth is None else max(outer - self.depth, 0.0)

    def inertia(self, outer: float) -> tuple[float, float, float]:
        """Return mass in kg and its own moments of inertia across the bat and about it, kg m^2, for an outer radius."""
        hole = self.hole(outer)
        mass = self.material.density * math.pi * (outer**2 - hole**2) * self.width
        square = outer**2 + hole**2
        return mass, mass * (square / 4 + self.width**2 / 12), mass * square / 2
