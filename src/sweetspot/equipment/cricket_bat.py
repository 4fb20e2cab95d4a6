"""Cricket bats: a blade of willow with a spine, a round handle of cane spliced into it, a rubber grip.

Positions are metres from the top of the handle to the toe.
"""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import NonNegative, Positive
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.implement import OfMaterial
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import FLAT_SHEAR, CrossSection, shear_coefficient
from sweetspot.equipment.shell import Stations, between, check_along, check_order
from sweetspot.numerics.arrays import Array

LENGTH_RANGE = (0.5, 1.0)
ACROSS = np.polynomial.legendre.leggauss(12)
SLOPE_PIECES = 4
"""Pieces of the splice, whose share of cane falls along it."""


class CricketBat(OfMaterial):
    """A cricket bat.

    The blade's back is h(y) = edge + (spine - edge) (1 - 2 |y| / width)^concavity above its flat face. Where the handle
    is spliced in, cane has the part of the blade's width that a wedge from the shoulders to nothing has.

    Raises `InputError` when stations cross or a spine is thinner than its edges.

    Parameters
    ----------
    name, length, sport, mass, balance_point, moi, moi_axis, choke : as for every `Implement`.
    material, handle_material : of blade and handle.
    handle : (position, diameter) stations from the top to the shoulders.
    width, spine, edge : (position, size) stations from the shoulders to the toe: of the blade's width, its depth in the
        middle and at its edges.
    concavity : 1 for a back of two planes, more for one that was scooped out.
    splice : m that the handle reaches into the blade.
    grip_mass : kg of rubber, twine and glue on the handle, spread evenly.
    first_frequency : Hz, measured, of bending mode 1 hung freely; None: as the materials have it.
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    material: Material
    handle_material: Material
    handle: Stations
    width: Stations
    spine: Stations
    edge: Stations
    concavity: Annotated[float, Field(ge=1, le=4)] = 1.5
    splice: Positive
    grip_mass: NonNegative = 0.0
    first_frequency: Positive | None = None

    @model_validator(mode="after")
    def _holds_together(self) -> CricketBat:
        check_order(self.handle, "handle")  # its end is where the others begin
        for stations, what in (
            (self.handle, "handle"),
            (self.width, "width"),
            (self.spine, "spine"),
            (self.edge, "edge"),
        ):
            start, end = (0.0, self.shoulder) if what == "handle" else (self.shoulder, self.length)
            check_along(stations, what, start=start, end=end)
        if self.shoulder + self.splice >= self.length:
            raise ValueError(f"the splice is {self.splice:.4g} m deep, beyond the toe; make it shorter")
        for place in self.breakpoints():
            if place > self.shoulder and between(self.spine, place) < between(self.edge, place):
                raise ValueError(f"the spine is thinner than the edges at {place:.4g} m; check spine and edge")
        return self

    @property
    def shoulder(self) -> float:
        """Position in m where the blade begins."""
        return self.handle[-1][0]

    @property
    def made_of(self) -> str:
        """Both materials."""
        return f"{self.material.name}, handle of {self.handle_material.name}"

    @property
    def materials(self) -> tuple[Material, ...]:
        """Of blade and handle."""
        return self.material, self.handle_material

    @property
    def frequency(self) -> float | None:
        """As measured, if it was."""
        return self.first_frequency

    @property
    def face(self) -> Face:
        """Flat, without a motion of its own; its wood is dented (`dynamics.local_compliance.blade_compliance`)."""
        return Face()

    @property
    def outline(self) -> FaceOutline:
        """All of the blade."""
        return FaceOutline(
            start=self.shoulder, end=self.length, width=max(size for _, size in self.width), shape="oblong"
        )

    def breakpoints(self) -> tuple[float, ...]:
        """Return the ends of all conical pieces, of the splice and of parts of it."""
        edges = {0.0, self.length}
        for stations in (self.handle, self.width, self.spine, self.edge):
            edges.update(position for position, _ in stations)
        edges.update((self.shoulder + self.splice * np.linspace(0, 1, SLOPE_PIECES + 1)).tolist())
        return tuple(sorted(edges))

    def width_at(self, position: ArrayLike) -> Array:
        """Return the diameter of the handle or the width of the blade in m."""
        places = np.asarray(position, float)
        return np.where(places <= self.shoulder, between(self.handle, places), between(self.width, places))

    def section_at(self, position: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m (at the shoulders that of the handle)."""
        handle, blade = self._handle_section(position), self._blade_section(position, scale)
        above = position <= self.shoulder
        return CrossSection(*(np.where(above, getattr(handle, name), getattr(blade, name)) for name in SECTION_FIELDS))

    def _handle_section(self, position: Array) -> CrossSection:
        radius = between(self.handle, position) / 2
        area, second, cane = math.pi * radius**2, math.pi * radius**4 / 4, self.handle_material
        grip = self.grip_mass / self.shoulder
        rotary = cane.density * second + grip * radius**2 / 2
        stiff = float(shear_coefficient(np.array(0.0), cane.poisson))
        return CrossSection(
            cane.density * area + grip,
            rotary,
            cane.longitudinal_modulus * second,
            stiff * cane.shear * area,
            2 * rotary,
        )

    def _blade_section(self, position: Array, scale: Array) -> CrossSection:
        nodes, weights = ACROSS
        part = (nodes + 1) / 2  # of half the width, from the middle out
        half, edge = between(self.width, position)[..., None] / 2, between(self.edge, position)[..., None]
        rise = np.maximum(between(self.spine, position)[..., None] - edge, 0.0)
        height = edge + rise * (1 - part) ** self.concavity
        area, first, second, roll = (
            (half * weights * values).sum(axis=-1)
            for values in (height, height**2 / 2, height**3 / 3, height * (half * part) ** 2)
        )
        about_middle = second - first**2 / area
        share = self._cane_share(position)
        willow, cane = self.material, self.handle_material
        density = (1 - share) * willow.density * scale + share * cane.density
        modulus = (1 - share) * willow.longitudinal_modulus + share * cane.longitudinal_modulus
        shear = (1 - share) * willow.shear + share * cane.shear
        return CrossSection(
            density * area,
            density * about_middle,
            modulus * about_middle,
            FLAT_SHEAR * shear * area,
            density * (about_middle + roll),
        )

    def _cane_share(self, position: Array) -> Array:
        """Return the part of the blade's width that is handle, 0 to 1."""
        left = np.clip(1 - (position - self.shoulder) / self.splice, 0.0, 1.0)
        return np.minimum(left * self.handle[-1][1] / between(self.width, position), 1.0)


SECTION_FIELDS = ("mass", "rotary_inertia", "bending_stiffness", "shear_stiffness", "roll_inertia")
