"""Table-tennis rackets: a blade of plies with a handle, and a rubber on either side.

Positions are metres from the butt end of the handle; the blade's far edge is the tip.
"""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import NonNegative, Positive, Validated
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.implement import DensityRange, Implement, Look
from sweetspot.equipment.laminate import Laminate, effective_moduli, laminate_stiffness
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import FLAT_SHEAR, CrossSection
from sweetspot.numerics.arrays import Array

LENGTH_RANGE = (0.2, 0.35)
NARROWEST = 0.02
"""m: the rounded tip is cut off where it is this narrow, so that sections do not vanish (drawing, not physics)."""
PIECES = 16


class Rubber(Validated):
    """One covering of a blade, sponge and sheet together.

    Parameters
    ----------
    name : what people call its kind.
    thickness : m, with the glue; the rules allow 4.0 mm, 2.0 mm without sponge.
    areal_density : kg/m^2.
    stiffness : N/m under the ball, sponge and sheet pressed in together.
    moving_mass : kg that moves with the ball there.
    restitution : part of its speed that a hard ball without losses keeps on the rubber glued to something rigid.
    friction, tangential_restitution : of the ball on it; what makes spin.
    """

    name: str
    thickness: Annotated[float, Field(gt=0, le=0.006)]
    areal_density: Positive
    stiffness: Positive
    moving_mass: Positive
    restitution: Annotated[float, Field(gt=0, le=1)]
    friction: NonNegative
    tangential_restitution: Annotated[float, Field(ge=-1, le=1)]

    @property
    def face(self) -> Face:
        """The rubber as a face that gives the same everywhere."""
        return Face(
            stiffness=self.stiffness,
            moving_mass=self.moving_mass,
            restitution=self.restitution,
            edge="layer",
            friction=self.friction,
            tangential_restitution=self.tangential_restitution,
        )


class TableTennisRacket(Implement):
    """A table-tennis racket, hit on its front.

    Raises `InputError` without a rubber on the front, or when handle and blade do not fit the length.

    Parameters
    ----------
    name, length, sport, mass, balance_point, moi, moi_axis, choke : as for every `Implement`.
    blade : plies from one side to the other; 0 is the direction of the handle.
    blade_length, blade_width : m.
    handle_width, handle_thickness : m, thickness with the blade between the scales.
    handle_material : of the scales.
    front, back : rubbers; None: bare wood, which may not be played with.
    damping : fraction of critical damping of its bending modes, in [0, 0.5).
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    blade: Laminate
    blade_length: Positive
    blade_width: Positive
    handle_width: Positive
    handle_thickness: Positive
    handle_material: Material
    front: Rubber | None = None
    back: Rubber | None = None
    damping: Annotated[float, Field(ge=0, lt=0.5)] = 0.02

    @model_validator(mode="after")
    def _holds_together(self) -> TableTennisRacket:
        if self.front is None:
            raise ValueError(f"{self.name} has no rubber on its front; bare wood may not hit the ball: give one")
        if self.blade_length >= self.length:
            raise ValueError(
                f"the blade is {self.blade_length:.4g} m long and the racket {self.length:.4g} m; leave room for the "
                "handle"
            )
        if self.handle_thickness <= self.blade.thickness:
            raise ValueError(
                f"the handle is {1e3 * self.handle_thickness:.3g} mm thick, no thicker than the blade of "
                f"{1e3 * self.blade.thickness:.3g} mm"
            )
        return self

    @property
    def neck(self) -> float:
        """Position in m where the handle's scales end and the blade is free."""
        return self.length - self.blade_length

    @property
    def rubbers(self) -> tuple[Rubber, ...]:
        """Those it has, the front's first."""
        return tuple(rubber for rubber in (self.front, self.back) if rubber is not None)

    @property
    def made_of(self) -> str:
        """Plies and rubbers."""
        names = [rubber.name for rubber in self.rubbers]
        alike = len(names) == 2 and names[0] == names[1]
        return f"{len(self.blade.plies)} plies, " + (f"{names[0]} on both sides" if alike else " and ".join(names))

    @property
    def materials(self) -> tuple[Material, ...]:
        """Of plies and scales."""
        return (*(ply.material for ply in self.blade.plies), self.handle_material)

    @property
    def look(self) -> Look:
        """Drawn like wood."""
        return "wood"

    @property
    def damping_ratio(self) -> float:
        """As given: rubber and sponge damp more than wood."""
        return self.damping

    @property
    def density_range(self) -> DensityRange:
        """Of the plies: veneers vary as woods do."""
        low = min(
            (ply.material.density_range or (ply.material.density,))[0] / ply.material.density
            for ply in self.blade.plies
        )
        high = max(
            (ply.material.density_range or (ply.material.density,))[-1] / ply.material.density
            for ply in self.blade.plies
        )
        usual = self.blade.density
        return DensityRange(usual, low * usual, high * usual)

    @property
    def face(self) -> Face:
        """The front rubber."""
        assert self.front is not None  # refused at construction
        return self.front.face

    @property
    def outline(self) -> FaceOutline:
        """The blade."""
        return FaceOutline(start=self.neck, end=self.length, width=self.blade_width)

    def breakpoints(self) -> tuple[float, ...]:
        """Return the ends of the pieces: closer together where the blade's outline bends most."""
        angles = np.linspace(0, np.pi, PIECES + 1)
        return (0.0, *(self.outline.middle - self.blade_length / 2 * np.cos(angles)).tolist())

    def width_at(self, position: ArrayLike) -> Array:
        """Return the width of handle or blade in m."""
        places = np.asarray(position, float)
        along = (places - self.outline.middle) / (self.blade_length / 2)
        blade = self.blade_width * np.sqrt(np.maximum(1 - along**2, 0.0))
        narrowest = np.where(along > 0, NARROWEST, self.handle_width)
        return np.where(places <= self.neck, self.handle_width, np.maximum(blade, narrowest))

    def section_at(self, position: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m; the wood's density is scaled, rubber's and scales' are not.

        The blade bends as a wide strip that is free to curl: EI = width / d_11, d the inverse of its bending stiffness
        (both with the plies' order). Rubbers add mass and no stiffness; the scales are a box around the blade.
        """
        width = self.width_at(position)
        in_hand = np.where(position <= self.neck, 1.0, 0.0)
        wood = self.blade.density * self.blade.thickness * scale
        covers = sum(rubber.areal_density for rubber in self.rubbers) * (1 - in_hand)
        scales = self.handle_material
        box = in_hand * self.handle_width
        added_area = box * (self.handle_thickness - self.blade.thickness)
        added_second = box * (self.handle_thickness**3 - self.blade.thickness**3) / 12
        mass = width * (wood + covers) + scales.density * added_area
        rotary = width * wood * self.blade.thickness**2 / 12 + scales.density * added_second
        bending, shear = self._strip
        return CrossSection(
            mass,
            rotary,
            width * bending + scales.longitudinal_modulus * added_second,
            FLAT_SHEAR * (width * shear + scales.shear * added_area),
            mass * width**2 / 12 + rotary,
        )

    @cached_property
    def _strip(self) -> tuple[float, float]:
        """Bending stiffness in N m and shear stiffness in N/m of the blade per width."""
        bending = laminate_stiffness(self.blade).bending
        return float(1 / np.linalg.inv(bending)[0, 0]), effective_moduli(self.blade).shear * self.blade.thickness
