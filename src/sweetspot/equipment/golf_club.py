"""Golf clubs: a tapered tube with a grip, and a heavy head with its own moments of inertia and a springy face.

Positions are metres from the butt end down the shaft; the head's height closes the line.
"""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import NonNegative, Positive, Validated
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.implement import Lump, OfMaterial
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import CrossSection, evenly, of_oval_tube
from sweetspot.equipment.shell import Stations, between, check_along
from sweetspot.numerics.arrays import Array

LENGTH_RANGE = (0.7, 1.3)
RIGID = 300.0
"""How many times stiffer than the shaft's tip the head's part of the line is: its bending is none."""
THIN = 1e-3
"""kg/m of the head's part of the line, whose mass sits in its middle."""
PENDULUM = 0.749
"""kg, the square of a face's characteristic time times its stiffness: the reduced mass of pendulum and head, times pi^2
and the square of the part of their contact that is timed. None of these is published: it is fitted to the limits 239 us
and 0.822 [usga_ct, usga_impact] with the catalogue's driver. The limits 257 us and 0.830 [dlancegolf] are a prediction:
0.830, and 0.827 or 0.829 with half more or half less mass of the face, for which it is fitted anew."""


class ClubHead(Validated):
    """The head of a club.

    Parameters
    ----------
    mass : kg.
    height, face_width : m, of the face along the shaft's line and across it.
    moi : kg m^2 about the axis from heel to toe, for hits above and below the middle.
    roll_moi : kg m^2 about the shaft's direction, for hits towards heel and toe.
    depth : m from the face back to the center of gravity.
    bulge : m, radius of the face from heel to toe; None: flat.
    face : its give under the ball.
    characteristic_time : s, as a pendulum test read it; None: it was not read.
    """

    mass: Positive
    height: Positive
    face_width: Positive
    moi: Positive
    roll_moi: Positive
    depth: NonNegative = 0.0
    bulge: Positive | None = None
    face: Face
    characteristic_time: Positive | None = None

    @property
    def contact_of_pendulum(self) -> float:
        """Characteristic time in s: as read, else from the face's stiffness; 0 for a rigid face."""
        if self.characteristic_time is not None:
            return self.characteristic_time
        return 0.0 if self.face.stiffness is None else math.sqrt(PENDULUM / self.face.stiffness)


def stiffness_by_pendulum(characteristic_time: float) -> float:
    """Return the stiffness in N/m of a face by the time in s that a pendulum test read; see `PENDULUM`.

    >>> f"{stiffness_by_pendulum(239e-6) / 1e6:.1f} MN/m"
    '13.1 MN/m'
    """
    return PENDULUM / characteristic_time**2


class GolfClub(OfMaterial):
    """A golf club.

    Raises `InputError` when the shaft does not reach the head, or weight, balance or moment of inertia are given
    besides the parts.

    Parameters
    ----------
    name, length, sport, choke : as for every `Implement`; length to the sole. Weight, balance and moment of inertia
        follow from the parts.
    material : of the shaft.
    diameter, wall : (position, size) stations of the shaft, from the butt to where the head begins.
    head : at the end of the shaft. Its balance point is taken to lie on the shaft's line.
    grip_mass, grip_length : kg and m.
    first_frequency : Hz, measured, of bending mode 1 hung freely; None: as the materials have it.
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    material: Material
    diameter: Stations
    wall: Stations
    head: ClubHead
    grip_mass: NonNegative = 0.05
    grip_length: Positive = 0.27
    first_frequency: Positive | None = None

    @model_validator(mode="after")
    def _holds_together(self) -> GolfClub:
        if self.mass is not None or self.balance_point is not None or self.moi is not None:
            raise ValueError("a club is weighed by its parts; leave out mass, balance_point and moi, give the head's")
        for stations, what in ((self.diameter, "diameter"), (self.wall, "wall")):
            check_along(stations, what, start=0.0, end=self.shaft_end)
        if self.grip_length >= self.shaft_end:
            raise ValueError(f"the grip is {self.grip_length:.4g} m long, longer than the shaft")
        return self

    @property
    def shaft_end(self) -> float:
        """Position in m where the head begins."""
        return self.length - self.head.height

    @property
    def density_range(self) -> None:
        """None: the club is weighed by its parts."""
        return None

    @property
    def frequency(self) -> float | None:
        """As measured, if it was."""
        return self.first_frequency

    @property
    def face(self) -> Face:
        """The head's."""
        return self.head.face

    @property
    def outline(self) -> FaceOutline:
        """The head's face."""
        return FaceOutline(start=self.shaft_end, end=self.length, width=self.head.face_width)

    def breakpoints(self) -> tuple[float, ...]:
        """Return the ends of all conical pieces, of the grip, and the head's middle."""
        edges = {0.0, self.grip_length, self.length - self.head.height / 2, self.length}
        edges.update(position for stations in (self.diameter, self.wall) for position, _ in stations)
        return tuple(sorted(edges))

    def width_at(self, position: ArrayLike) -> Array:
        """Return the diameter of the shaft, or the width of the face in m."""
        places = np.asarray(position, float)
        along = (places - self.outline.middle) / (self.head.height / 2)
        head = self.head.face_width * np.sqrt(np.maximum(1 - along**2, 0.0))
        return np.where(places <= self.shaft_end, between(self.diameter, places), head)

    def section_at(self, position: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m; the head's part of the line is stiff and has no weight to speak of."""
        size, wall = between(self.diameter, position), between(self.wall, position)
        tube = of_oval_tube(self.material, width=size, depth=size, wall=wall, scale=scale)
        grip = np.where(position <= self.grip_length, self.grip_mass / self.grip_length, 0.0)
        shaft = evenly(grip, size / 2, tube)
        inside = position > self.shaft_end
        return CrossSection(
            np.where(inside, THIN, shaft.mass),
            np.where(inside, THIN * size**2, shaft.rotary_inertia),
            np.where(inside, RIGID, 1.0) * shaft.bending_stiffness,
            np.where(inside, RIGID, 1.0) * shaft.shear_stiffness,
            np.where(inside, 0.0, shaft.roll_inertia),
        )

    def lumps(self) -> tuple[Lump, ...]:
        """Return the head in the middle of its height."""
        head = self.head
        return (Lump(self.length - head.height / 2, head.mass, moi=head.moi, roll_moi=head.roll_moi),)
