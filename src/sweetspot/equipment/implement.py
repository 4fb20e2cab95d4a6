"""What a player hits the ball with, in any sport: the little that the physics asks of it.

Positions are metres from the end that the hand holds (the knob or butt end) to the tip; the axis figure in the docs
fixes origin and directions.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import Literal, NamedTuple, Self, cast

from numpy.typing import ArrayLike
from pydantic import model_validator

from sweetspot.equipment.base import Name, NonNegative, Positive, Validated
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import CrossSection
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.plausibility import insisted
from sweetspot.units import format_length

Look = Literal["wood", "metal", "filler", "laminate"]


class Lump(NamedTuple):
    """Mass at one place.

    Parameters
    ----------
    position, mass : m from the butt end and kg; slightly negative for a knob smaller than drawn.
    moi, roll_moi : kg m^2 of its own, about the axis across the line and about the line.
    """

    position: float
    mass: float
    moi: float = 0.0
    roll_moi: float = 0.0


class AddedMass(Validated):
    """A small weight fixed to an implement after it was measured, such as lead tape.

    Parameters
    ----------
    position : m from the butt end.
    mass : kg.
    lateral : m beside the middle line; 0: on it. It counts in the twist about the line.
    """

    position: NonNegative
    mass: Positive
    lateral: float = 0.0


class DensityRange(NamedTuple):
    """Density in kg/m^3 that a body has by the catalogue, and the least and most that its material can have."""

    usual: float
    lightest: float
    heaviest: float


UNMEASURED = {"mass": None, "balance_point": None, "moi": None}
"""What was measured on an implement no longer holds when it is changed."""


class Implement(ShownInNotebooks, Validated, ABC):
    """A bat, racket, club or stick: a line with sections, perhaps with a face of its own.

    Parameters
    ----------
    name : what people call it.
    length : m.
    sport : catalogue name of the sport it is made for.
    mass, balance_point : measured, kg and m from the butt end; None when not measured.
    moi : measured moment of inertia in kg m^2 about ``moi_axis`` (m from the butt end).
    fitted : names of those of the three that were not measured but follow from what was.
    choke : m the grip is moved up from the butt end; shifts the default pivot and hands.
    added : small weights that were fixed to it after it was measured.
    original : what it was before it was changed; None: it was not. What was measured on that one tells what this one is
        made of.
    calibrated : whether what was measured counts even where the drawing has it only at an unusual density.
    """

    name: Name
    length: Positive
    sport: str = "baseball"
    mass: Positive | None = None
    balance_point: Positive | None = None
    moi: Positive | None = None
    moi_axis: float = STANDARD_AXIS
    fitted: tuple[str, ...] = ()
    choke: NonNegative = 0.0
    added: tuple[AddedMass, ...] = ()
    original: Implement | None = None
    calibrated: bool = False

    @model_validator(mode="after")
    def _weights_are_on_it(self) -> Self:
        for weight in self.added:
            if weight.position > self.length:
                raise ValueError(
                    f"a weight was put {format_length(weight.position)} from the {self.grip_end}, off {self.name}, "
                    f"which is {format_length(self.length)} long"
                )
        return self

    @property
    @abstractmethod
    def made_of(self) -> str:
        """Material, in a few words."""

    @property
    def materials(self) -> tuple[Material, ...]:
        """Its materials, as far as it is described by them."""
        return ()

    @property
    @abstractmethod
    def look(self) -> Look:
        """What a picture of it should look like."""

    @property
    @abstractmethod
    def damping_ratio(self) -> float:
        """Fraction of critical damping of its bending modes when hung freely."""

    @property
    def grip_end(self) -> str:
        """What people call the end that the hand holds."""
        return "butt end"

    @property
    def swing_axis(self) -> float:
        """Axis in m from the butt end about which its moment of inertia is given, and taken to be measured."""
        return self.moi_axis

    @abstractmethod
    def breakpoints(self) -> tuple[float, ...]:
        """Return the positions in m, 0 and length included, between which everything about it is smooth."""

    @abstractmethod
    def section_at(self, position: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m, with the body's own density ``scale`` times the catalogue's."""

    @abstractmethod
    def width_at(self, position: ArrayLike) -> Array:
        """Return the width of its outline in m at positions in m, as the ball sees it."""

    @property
    def density_range(self) -> DensityRange | None:
        """Usual density and its limits; None where the sections already hold measured values."""
        return None

    @property
    def frequency(self) -> float | None:
        """Measured frequency in Hz of its first bending mode, to which its stiffness is scaled; None: not known."""
        return None

    @property
    def face(self) -> Face | None:
        """The striking surface where it deflects by itself or is flat; None for a round solid body."""
        return None

    @property
    def outline(self) -> FaceOutline | None:
        """The hitting area; None: all of it beyond the hands."""
        return None

    def as_drawn(self) -> Implement:
        """Return it as its file draws it; see `Bat.as_drawn`."""
        return self

    def as_measured(self) -> Self:
        """Return the implement that the measured values belong to: this one, or what it was before it was changed."""
        if self.original is None or not (self.mass is self.balance_point is self.moi is None):
            return self
        return cast("Self", self.original)  # a thing is changed from one of its kind

    def lineage(self) -> Iterator[Implement]:
        """Yield this implement, then what it was changed from, and so on back to the piece that it was made from."""
        ancestor: Implement | None = self
        while ancestor is not None:
            yield ancestor
            ancestor = ancestor.original

    def before_changes(self) -> Implement:
        """Return it as it was before it was changed, held at the bottom of its grip; what is as it was, itself.

        What was measured itself, or is of another length, is an implement of its own.
        """
        measured = self.as_measured()
        piece = measured if measured.length == self.length else self
        return piece.replaced(choke=0.0) if piece.choke else piece

    def is_measured(self, name: Literal["mass", "balance_point", "moi"]) -> bool:
        """Return whether a value was measured, on it or on what it was before it was changed."""
        return any(getattr(each, name) is not None and name not in each.fitted for each in self.lineage())

    def check_position(self, position: float, what: str = "position") -> None:
        """Refuse a position (m) that is not on the bat; ``what`` names it in the message."""
        if not (math.isfinite(position) and 0 <= position <= self.length):
            raise InputError(
                f"{what} is {format_length(position)} from the {self.grip_end}, off the bat; "
                f"{self.name} reaches from 0 to {format_length(self.length)}"
            )

    def check_on_face(self, position: float, what: str = "position") -> None:
        """Refuse a position (m) where the ball would meet the grip or the frame; any is allowed on a round bat."""
        face = self.outline
        if face is not None and not face.start <= position <= face.end and not insisted():
            raise InputError(
                f"{what} is {format_length(position)} from the {self.grip_end}, off the face of {self.name}, which "
                f"reaches from {format_length(face.start)} to {format_length(face.end)}; the ball meets grip or frame "
                "there. Give a place on the face, or add --force if it is intended"
            )

    def check_lateral(self, position: float, lateral: float) -> None:
        """Refuse a place beside the line that is not on the face: ``lateral`` m across it at ``position`` m."""
        if lateral == 0:
            return
        if self.face is None or self.outline is None:
            raise InputError(
                f"{self.name} is round: a hit has no place beside its line. Leave it out, or give an implement with a "
                "face"
            )
        face = self.outline
        if not (math.isfinite(lateral) and face.holds(position, lateral)):
            raise InputError(
                f"the hit is {format_length(abs(lateral))} beside the line at {format_length(position)}, off the face; "
                f"the face of {self.name} is {format_length(face.width)} wide and reaches from "
                f"{format_length(face.start)} to {format_length(face.end)}"
            )

    def lumps(self) -> tuple[Lump, ...]:
        """Return the point masses that are not part of the sections."""
        return ()


class OfMaterial(Implement, ABC):
    """An implement whose body is of one material.

    Parameters
    ----------
    material : what the body is made of.
    """

    material: Material

    @property
    def made_of(self) -> str:
        """Name of its material."""
        return self.material.name

    @property
    def materials(self) -> tuple[Material, ...]:
        """Its material."""
        return (self.material,)

    @property
    def look(self) -> Look:
        """Family of its material."""
        return self.material.family

    @property
    def damping_ratio(self) -> float:
        """Its material's."""
        return self.material.damping_ratio

    @property
    def density_range(self) -> DensityRange | None:
        """Of its material."""
        light, heavy = self.material.density_range or (self.material.density, self.material.density)
        return DensityRange(self.material.density, light, heavy)
