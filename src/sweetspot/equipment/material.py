"""Materials of bats: density, elastic moduli, damping."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from sweetspot.equipment.base import Positive, Validated

TRANSVERSE_LIMIT = 50.0
"""No known material is this many times stiffer across than along; axes or units are mixed up (assumed)."""
DEFAULT_POISSON = 0.3
"""Of a material that states no Poisson ratio (assumed)."""


class Material(Validated):
    """A material with its axes along the bat (longitudinal) and across it (transverse).

    Wood is orthotropic: give ``longitudinal_modulus`` and ``shear_modulus``. Metal, foam and rubber
    are isotropic: give ``longitudinal_modulus`` (Young's modulus) and ``poisson_ratio``, and the
    shear modulus follows as G = E / (2 (1 + nu)).

    Parameters
    ----------
    name : what people call it.
    laminated : whether wood of it is glued from several pieces, as bamboo always is; False: one piece.
    density : kg/m^3, > 0.
    longitudinal_modulus : Pa, along the bat, > 0.
    shear_modulus : Pa, in the plane of the axis and a diameter, > 0; None for isotropic materials.
    transverse_modulus : Pa, across the bat or the fibres, > 0; None: the same as along.
    poisson_ratio : in (-1, 0.5), of the stretch along to the contraction across.
    damping_ratio : of a freely hung bat's bending modes, fraction of critical, in [0, 0.5).
    density_range : kg/m^3, the lightest and the heaviest piece that can be had; None: only ``density``.
    strength : Pa, in bending along the bat; None when no source gives it.
    """

    name: str
    family: Literal["wood", "metal", "filler", "laminate"] = "wood"
    laminated: bool = False
    density: Positive
    longitudinal_modulus: Positive
    shear_modulus: Positive | None = None
    transverse_modulus: Positive | None = None
    poisson_ratio: Annotated[float, Field(gt=-1, lt=0.5)] | None = None
    damping_ratio: Annotated[float, Field(ge=0, lt=0.5)] = 0.0
    density_range: tuple[Positive, Positive] | None = None
    strength: Positive | None = None

    @model_validator(mode="after")
    def _enough_and_not_too_much(self) -> Material:
        if self.shear_modulus is None and self.poisson_ratio is None:
            raise ValueError(f"{self.name} has neither a shear_modulus nor a poisson_ratio; give one of them")
        self._check_moduli()
        if self.density_range and not self.density_range[0] <= self.density <= self.density_range[1]:
            low, high = self.density_range
            raise ValueError(
                f"{self.name} has density {self.density:g} kg/m^3 outside its own range {low:g} to {high:g} kg/m^3"
            )
        return self

    def _check_moduli(self) -> None:
        along, across = self.longitudinal_modulus, self.transverse_modulus or self.longitudinal_modulus
        if across > TRANSVERSE_LIMIT * along:
            raise ValueError(
                f"{self.name} is {across / along:.3g} times stiffer across than along; allowed is up to "
                f"{TRANSVERSE_LIMIT:g} times. Check the units, and that the longitudinal axis is that of the fibres"
            )
        if self.poisson_ratio is not None and self.poisson_ratio**2 * across >= along:
            raise ValueError(
                f"{self.name} has poisson_ratio {self.poisson_ratio:g} with moduli {along:.3g} Pa along and "
                f"{across:.3g} Pa across: such a material would give energy away when pulled. Allowed is a "
                f"poisson_ratio below {math.sqrt(along / across):.3g} in size"
            )

    @property
    def shear(self) -> float:
        """Shear modulus in Pa: the given one, or E / (2 (1 + nu)) of an isotropic material."""
        if self.shear_modulus is not None:
            return self.shear_modulus
        assert self.poisson_ratio is not None  # guaranteed at construction
        return self.longitudinal_modulus / (2 * (1 + self.poisson_ratio))

    @property
    def poisson(self) -> float:
        """Poisson's ratio: the given one, or the usual one."""
        return DEFAULT_POISSON if self.poisson_ratio is None else self.poisson_ratio

    @property
    def across(self) -> float:
        """Young's modulus across the bat in Pa: the given one, or that along it."""
        return self.transverse_modulus or self.longitudinal_modulus

    def of_density(self, density: float) -> Material:
        """Return the material as a piece of it that has this density in kg/m^3, its range widened to it if need be."""
        reach = self.density_range and (min(self.density_range[0], density), max(self.density_range[1], density))
        return self.replaced(density=density, density_range=reach)
