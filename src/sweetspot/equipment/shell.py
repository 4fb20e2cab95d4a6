"""Parts of a hollow bat: wall, inner sleeve, handle of another material, cap and knob.

Positions are metres from the knob end.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from pydantic import model_validator

from sweetspot.equipment.base import NonNegative, Positive, Validated
from sweetspot.equipment.laminate import Laminate
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import format_length


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
        """Its start and end, m from the knob end."""
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


Stations = tuple[tuple[float, float], ...]
"""(position, size) pairs in m, positions increasing."""


class WallPart(NamedTuple):
    """One wall at an array of positions: thickness 0 where it is not.

    Parameters
    ----------
    material, laminate : what it is made of; a laminate goes before the material.
    outer, thickness : outer radius and thickness in m.
    """

    material: Material
    laminate: Laminate | None
    outer: Array
    thickness: Array

    @property
    def inner(self) -> Array:
        """Inner radius in m."""
        return self.outer - self.thickness

    @property
    def middle(self) -> Array:
        """Radius of the wall's middle in m."""
        return self.outer - self.thickness / 2

    @property
    def density(self) -> float:
        """Density in kg/m^3 as the catalogue has it."""
        return self.material.density if self.laminate is None else self.laminate.density


class InnerWall(Validated):
    """A sleeve inside the barrel: the second wall of a double-wall bat.

    Parameters
    ----------
    wall : (position, thickness) stations in m, from where the sleeve starts to where it stops.
    material : of the sleeve.
    laminate : plies it is laid up of; their thicknesses scale with the wall. None: the material itself.
    gap : m between the outer wall and the sleeve; 0: they touch.
    bonded : whether the walls are glued to each other; without, they slide on each other.
    """

    wall: Stations
    material: Material
    laminate: Laminate | None = None
    gap: NonNegative = 0.0
    bonded: bool = False

    @model_validator(mode="after")
    def _holds_together(self) -> InnerWall:
        check_order(self.wall, "inner_wall")
        for position, thickness in self.wall:
            if thickness <= 0:
                raise ValueError(f"inner wall is {thickness * 1e3:.3g} mm at {position:.4g} m; allowed is more than 0")
        if self.bonded and self.gap:
            raise ValueError(f"inner wall is bonded but has a gap of {self.gap * 1e3:.3g} mm; leave out one of them")
        return self

    def thickness_at(self, position: Array) -> Array:
        """Return the sleeve's thickness in m at positions in m: 0 beyond its ends, and at the very start."""
        here = (position > self.wall[0][0]) & (position <= self.wall[-1][0])
        return np.where(here, between(self.wall, position), 0.0)


USUAL_KNOB_DEPTH, USUAL_CAP_DEPTH = 0.020, 0.010
"""m along the bat that a knob and an end cap fill where they were not measured: the thick part of a knob as the
catalogue's outlines draw it, and a plug's face with the skirt glued into the barrel (both assumed)."""


class Shell(Validated):
    """A hollow bat: wall thickness along the axis, what the walls are made of, and what closes the ends.

    Parameters
    ----------
    wall : (position, thickness) stations in m over the whole length.
    laminate : plies of the wall; their thicknesses scale with the wall. None: the bat's own material.
    inner_wall : a sleeve inside; None: a single wall.
    rings : flat rings and discs inside the barrel, fixed to the innermost wall.
    handle_material : of a two-piece bat, from the knob end to ``joint``; None: one piece.
    joint : m from the knob end, where the handle ends.
    joint_mass : kg of whatever joins the pieces, at ``joint``.
    end_cap_mass, knob_mass : kg, of solid cylinders that begin at the tip and at the knob end.
    end_cap_depth, knob_depth : m along the bat that those fill, from the end inwards; None: not measured, and
        `USUAL_CAP_DEPTH` and `USUAL_KNOB_DEPTH` are assumed.
    """

    wall: Stations
    laminate: Laminate | None = None
    inner_wall: InnerWall | None = None
    rings: tuple[Ring, ...] = ()
    handle_material: Material | None = None
    joint: Positive | None = None
    joint_mass: NonNegative = 0.0
    end_cap_mass: NonNegative = 0.0
    knob_mass: NonNegative = 0.0
    end_cap_depth: NonNegative | None = None
    knob_depth: NonNegative | None = None

    @model_validator(mode="after")
    def _pieces_belong_together(self) -> Shell:
        if (self.handle_material is None) != (self.joint is None):
            raise ValueError("a two-piece bat needs both handle_material and joint; give both or neither")
        if self.joint_mass and self.joint is None:
            raise ValueError("joint_mass needs a joint; say where the handle ends")
        return self

    @property
    def depths(self) -> tuple[float, float]:
        """How much of the bat's length knob and end cap fill, m; the usual depths where they were not measured."""
        knob, cap = self.knob_depth, self.end_cap_depth
        return USUAL_KNOB_DEPTH if knob is None else knob, USUAL_CAP_DEPTH if cap is None else cap

    @property
    def bonded(self) -> bool:
        """Whether there are two walls that act as one."""
        return self.inner_wall is not None and self.inner_wall.bonded

    def wall_at(self, position: Array) -> Array:
        """Return the thickness of the outer wall in m at positions in m."""
        return between(self.wall, position)

    def scaled(self, factor: float) -> Shell:
        """Return the shell with outer wall and sleeve ``factor`` times as thick, > 0; outside and gap stay."""
        if not factor > 0:
            raise InputError(f"walls were to be {factor:g} times as thick; allowed is more than 0")
        sleeve = self.inner_wall
        if sleeve is not None:
            sleeve = sleeve.unchecked(wall=tuple((place, factor * size) for place, size in sleeve.wall))
        return self.unchecked(wall=tuple((place, factor * size) for place, size in self.wall), inner_wall=sleeve)

    def edges(self) -> tuple[float, ...]:
        """Return the positions in m where a wall bends, begins or ends."""
        inner = () if self.inner_wall is None else self.inner_wall.wall
        joint = () if self.joint is None else (self.joint,)
        return (*(position for position, _ in (*self.wall, *inner)), *joint, *(ring.position for ring in self.rings))

    def bore_at(self, position: float, radius: float) -> float:
        """Return the radius in m that the innermost wall leaves open where the bat's own radius is ``radius`` m."""
        place = np.array([position])
        open_radius = radius - float(self.wall_at(place)[0])
        if self.inner_wall is not None and self.inner_wall.thickness_at(place)[0] > 0:
            open_radius -= self.inner_wall.gap + float(self.inner_wall.thickness_at(place)[0])
        return open_radius

    def parts(self, position: Array, radius: Array, material: Material) -> list[WallPart]:
        """Return the walls at positions in m, the outer one of radius ``radius`` m and of ``material`` first."""
        wall = self.wall_at(position)
        walls = []
        if self.handle_material is None or self.joint is None:
            walls.append(WallPart(material, self.laminate, radius, wall))
        else:
            handle = position <= self.joint
            walls.append(WallPart(material, self.laminate, radius, np.where(handle, 0.0, wall)))
            walls.append(WallPart(self.handle_material, None, radius, np.where(handle, wall, 0.0)))
        if self.inner_wall is not None:
            sleeve = self.inner_wall
            outside = radius - wall - sleeve.gap
            walls.append(WallPart(sleeve.material, sleeve.laminate, outside, sleeve.thickness_at(position)))
        return walls


def between(stations: Stations, position: Array | float) -> Array:
    """Return the size in m at positions in m on straight lines between stations, constant beyond them."""
    places, sizes = zip(*stations, strict=True)
    return np.asarray(np.interp(np.asarray(position, float), places, sizes))


MOST_STATIONS = 150
"""Each is the end of a beam element, and the time of a bending analysis grows with the cube of their number."""


def check_order(stations: Stations, what: str) -> None:
    """Refuse stations that are too few or go backwards; ``what`` names them in the message."""
    if len(stations) < 2:
        raise ValueError(f"{what} has {len(stations)} station; allowed is two or more")
    check_count(stations, what)
    for (before, _), (after, _) in pairwise(stations):
        if after <= before:
            raise ValueError(
                f"{what} goes back from {format_length(before)} to {format_length(after)}; "
                "list the stations from the knob end outwards, each once"
            )


def check_count(stations: Sequence[object], what: str) -> None:
    """Refuse more stations than an analysis can use."""
    if len(stations) > MOST_STATIONS:
        raise InputError(f"{what} has {len(stations)} stations; allowed is up to {MOST_STATIONS}: thin them out")


def check_along(stations: Stations, what: str, *, start: float, end: float) -> None:
    """Refuse stations that do not run from ``start`` to ``end`` (m), or have a size that is not above zero."""
    check_order(stations, what)
    if abs(stations[0][0] - start) > 1e-9 or abs(stations[-1][0] - end) > 1e-6:
        raise ValueError(
            f"{what} runs from {stations[0][0]:.4g} m to {stations[-1][0]:.4g} m; allowed is from {start:.4g} m to "
            f"{end:.4g} m, with a station at each end"
        )
    if min(size for _, size in stations) <= 0:
        raise ValueError(f"{what} has a size that is not above zero")
