"""Laminates: plies of fibre-reinforced material, one on the other, each with its own angle."""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import Field, model_validator

from sweetspot.material import Material
from sweetspot.thing import Positive, Thing


class Ply(Thing):
    """One layer of a laminate.

    Parameters
    ----------
    material : with its longitudinal axis along the fibres.
    angle : rad from the bat's axis to the fibres, -pi/2 to pi/2; turning from axial towards hoop is positive.
    thickness : m, > 0; only its share of the laminate counts where a wall's thickness is given.
    """

    material: Material
    angle: Annotated[float, Field(ge=-math.pi / 2 - 1e-9, le=math.pi / 2 + 1e-9)] = 0.0
    thickness: Positive


class Laminate(Thing):
    """Plies bonded to each other, listed from the inside of the barrel outwards.

    Raises
    ------
    InputError
        when there is no ply.
    """

    plies: tuple[Ply, ...]

    @model_validator(mode="after")
    def _has_plies(self) -> Laminate:
        if not self.plies:
            raise ValueError("a laminate has no plies; give at least one with material, angle and thickness")
        return self

    @property
    def thickness(self) -> float:
        """Sum of the plies' thicknesses in m."""
        return math.fsum(ply.thickness for ply in self.plies)

    @property
    def density(self) -> float:
        """Mean density in kg/m^3, by thickness."""
        return math.fsum(ply.material.density * ply.thickness for ply in self.plies) / self.thickness
