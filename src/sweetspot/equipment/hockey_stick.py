"""Field-hockey sticks: an oval composite tube that thickens to a flat-faced head with a hook.

Positions are metres from the top of the handle to the lowest point of the head.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import NonNegative, Positive
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.implement import Lump, OfMaterial
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import CrossSection, evenly, of_oval_tube
from sweetspot.equipment.shell import Stations, between, check_along
from sweetspot.numerics.arrays import Array

LENGTH_RANGE = (0.6, 1.1)


class HockeyStick(OfMaterial):
    """A hockey stick. Raises `InputError` when stations cross or a wall is not above zero.

    Parameters
    ----------
    name, length, sport, mass, balance_point, moi, moi_axis, choke : as for every `Implement`.
    material : of the tube.
    width, depth, wall : (position, size) stations over the whole length: of the tube across the ball's path, along it,
        and of its wall; where the wall reaches the middle the stick is solid.
    face_start : m from the top of the handle, where the playing face begins.
    grip_mass, grip_length : kg and m of what is wrapped round the handle.
    hook_mass, hook_reach : kg of the head's hook and m from the stick's line to its middle.
    first_frequency : Hz, measured, of bending mode 1 hung freely; None: as the materials have it.
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    material: Material
    width: Stations
    depth: Stations
    wall: Stations
    face_start: Positive
    grip_mass: NonNegative = 0.0
    grip_length: Positive = 0.3
    hook_mass: NonNegative = 0.0
    hook_reach: NonNegative = 0.0
    first_frequency: Positive | None = None

    @model_validator(mode="after")
    def _holds_together(self) -> HockeyStick:
        for stations, what in ((self.width, "width"), (self.depth, "depth"), (self.wall, "wall")):
            check_along(stations, what, start=0.0, end=self.length)
        if not self.grip_length < self.face_start < self.length:
            raise ValueError(
                f"the grip ends at {self.grip_length:.4g} m and the face begins at {self.face_start:.4g} m of a "
                f"{self.length:.4g} m stick; allowed is one after the other"
            )
        return self

    @property
    def frequency(self) -> float | None:
        """As measured, if it was."""
        return self.first_frequency

    @property
    def face(self) -> Face:
        """Flat and rigid."""
        return Face()

    @property
    def outline(self) -> FaceOutline:
        """From where the face begins to where the head's end rounds off: half a width before it."""
        widest = max(size for place, size in self.width if place >= self.face_start)
        end = self.length - self.width[-1][1] / 2
        return FaceOutline(start=self.face_start, end=end, width=widest, shape="oblong")

    def breakpoints(self) -> tuple[float, ...]:
        """Return the ends of all conical pieces and of the grip."""
        edges = {0.0, self.grip_length, self.length}
        for stations in (self.width, self.depth, self.wall):
            edges.update(position for position, _ in stations)
        return tuple(sorted(edges))

    def width_at(self, position: ArrayLike) -> Array:
        """Return the width of the tube in m."""
        return between(self.width, np.asarray(position, float))

    def section_at(self, position: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m, the grip around them."""
        width, depth = between(self.width, position), between(self.depth, position)
        tube = of_oval_tube(self.material, width=width, depth=depth, wall=between(self.wall, position), scale=scale)
        grip = np.where(position <= self.grip_length, self.grip_mass / self.grip_length, 0.0)
        return evenly(grip, (width + depth) / 4, tube)

    def lumps(self) -> tuple[Lump, ...]:
        """Return the hook, beside the line: it weighs at the head's end and turns with the stick."""
        if not self.hook_mass:
            return ()
        return (Lump(self.length, self.hook_mass, roll_moi=self.hook_mass * self.hook_reach**2),)
