"""Paddles: a sandwich plate of a soft core between two stiff skins, with a rim and a handle.

Positions are metres from the butt end of the handle; the far edge of the head is the tip.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import NonNegative, Positive, Validated
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.implement import Implement, Look, Lump
from sweetspot.equipment.laminate import Laminate, laminate_stiffness
from sweetspot.equipment.section import CrossSection
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.gauss_legendre import quadrature
from sweetspot.units import format_mass

LENGTH_RANGE = (0.3, 0.6)
HANDLE_ROWS, THROAT_ROWS, HEAD_ROWS, CORNER_ROWS = 5, 4, 21, 8
"""Rows of elements along each part; the middle of the head has rows of about a centimetre."""
HANDLE_STIFFER = 3.0
"""Factor on the sandwich's stiffness in the handle, which is wrapped and thicker (assumed): 1.5 to 10 times moves the
lowest tone by 12 % each way and the rebound from the middle of the face by 0.002 of the incoming speed."""


class SoftSpot(Validated):
    """A round part of the core that has been crushed, so that it is softer in shear.

    Parameters
    ----------
    position : m from the butt end, of its middle, on the line.
    radius : m.
    factor : its shear stiffness over that of the sound core, in (0, 1].
    """

    position: Positive
    radius: Positive
    factor: Annotated[float, Field(gt=0, le=1)]


class Paddle(Implement):
    """A paddle without strings: pickleball, padel.

    The plate weighs what core, skins and glue weigh; the rest of the measured mass lies in the rim and in the handle,
    divided between them so that the swing weight is the measured one. The twist weight follows. Where it was measured
    too, it says how much of the rim lies round the tip, with its corners, and how much along the sides.

    Raises `InputError` without mass or swing weight, where rim or handle would weigh less than nothing, or when the
    parts do not fit the length.

    Parameters
    ----------
    name, length, sport, choke : as for every `Implement`.
    mass : kg, needed. moi : swing weight about ``moi_axis``, kg m^2, needed.
    twist_moi : measured twist weight about its own axis, kg m^2; None: it follows.
    handle_length, handle_width : m; the handle is as wide all along.
    throat : m over which the handle widens to the head, a quarter of an ellipse.
    head_width : m.
    corner_radius : m, of the two corners at the tip.
    core_thickness, core_density, core_shear : m, kg/m^3 and Pa. The shear modulus decides how much the face deflects.
    core_modulus : Pa, through the thickness; for the deflection of the face under a small tip only.
    skin : one of the two, outwards; angle 0 along the handle.
    glue : kg/m^2, glue and paint together.
    rim_at_tip : mass per length of the rim round the tip over that along the sides; with ``twist_moi`` it follows.
    soft_spot : where the core is crushed; None: nowhere.
    patch : m, radius of the round patch through which the ball pushes.
    damping : fraction of critical damping of its vibrations, in [0, 0.5).
    friction, tangential_restitution : of the ball on the face; None: those on a bat.
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    handle_length: Positive
    handle_width: Positive
    throat: Positive
    head_width: Positive
    corner_radius: Positive
    core_thickness: Positive
    core_density: Positive
    core_shear: Positive
    core_modulus: Positive
    skin: Laminate
    glue: NonNegative = 0.0
    twist_moi: Positive | None = None
    rim_at_tip: Positive = 1.0
    soft_spot: SoftSpot | None = None
    patch: Positive
    damping: Annotated[float, Field(ge=0, lt=0.5)] = 0.02
    friction: NonNegative | None = None
    tangential_restitution: Annotated[float, Field(ge=-1, le=1)] | None = None

    @model_validator(mode="after")
    def _holds_together(self) -> Paddle:
        if self.mass is None or self.moi is None:
            raise ValueError(f"{self.name} needs mass and swing weight (moi); measure both")
        if self.balance_point is not None:
            raise ValueError(f"the balance point of {self.name} follows from mass and swing weight; leave it out")
        if not self.handle_length + self.throat + self.corner_radius < self.length:
            raise ValueError(
                f"handle, throat and corners are {self.handle_length + self.throat + self.corner_radius:.4g} m long "
                f"and the paddle {self.length:.4g} m; leave room for the face"
            )
        if not max(self.handle_width, 2 * self.corner_radius) < self.head_width:
            raise ValueError(f"the head is {self.head_width:.4g} m wide; allowed is more than handle and two corners")
        sides, tip, handle = self._weights
        if min(sides, tip, handle) < 0:
            others = "swing weight" if self.twist_moi is None else "swing weight and twist weight"
            raise ValueError(
                f"with {format_mass(self.mass)} and this {others} the rim of {self.name} would weigh "
                f"{format_mass(sides)} along its sides and {format_mass(tip)} round its tip, and the handle, beyond "
                f"its part of the plate, {format_mass(handle)}; check mass, {others.replace(' and ', ', ')}, width of "
                "the head and core"
            )
        return self

    @property
    def made_of(self) -> str:
        """Core and skins."""
        return f"sandwich, core {1e3 * self.core_thickness:.3g} mm"

    @property
    def look(self) -> Look:
        """Drawn like a laminate."""
        return "laminate"

    @property
    def damping_ratio(self) -> float:
        """As given."""
        return self.damping

    @property
    def face(self) -> Face:
        """A flat face; how it deflects is that of the whole plate."""
        return Face(friction=self.friction, tangential_restitution=self.tangential_restitution)

    @property
    def outline(self) -> FaceOutline:
        """The head beyond the throat."""
        start = self.handle_length + self.throat
        return FaceOutline(start=start, end=self.length, width=self.head_width, shape="oblong")

    @property
    def thickness(self) -> float:
        """Core and skins, m."""
        return self.core_thickness + 2 * self.skin.thickness

    @property
    def areal_mass(self) -> float:
        """Mass of the plate per area, kg/m^2."""
        return 2 * self.skin.density * self.skin.thickness + self.core_density * self.core_thickness + self.glue

    @property
    def areal_inertia(self) -> float:
        """Rotary inertia of the plate per area, kg: skins c/2 + t/2 from the middle, and a solid core."""
        arm = (self.core_thickness + self.skin.thickness) / 2
        return 2 * self.skin.density * self.skin.thickness * arm**2 + self.core_density * self.core_thickness**3 / 12

    @cached_property
    def bending(self) -> Array:
        """Bending stiffness per width in N m, shape (3, 3): two skins at c/2 + t/2, D = A (c + t)^2 / 2 [jones1999]."""
        arm = self.core_thickness + self.skin.thickness
        return laminate_stiffness(self.skin).stretching * arm**2 / 2

    @property
    def shear(self) -> float:
        """Shear stiffness per width of the sound plate in N/m, S = G (c + t)^2 / c [zenkert1997]."""
        return self.core_shear * (self.core_thickness + self.skin.thickness) ** 2 / self.core_thickness

    @property
    def rim_mass(self) -> float:
        """Mass of the rim round the head, kg."""
        return self._weights[0] + self._weights[1]

    @property
    def handle_mass(self) -> float:
        """Mass of the handle beyond its part of the plate, kg."""
        return self._weights[2]

    def rim_per_length(self, position: ArrayLike) -> Array:
        """Return the mass of the rim per length of the edge in kg/m, at places in m from the butt end."""
        sides, tip, _ = self._weights
        (along, round_tip), corner = self._edge_lengths, self.length - self.corner_radius
        return np.where(np.asarray(position, float) < corner, sides / along, tip / round_tip)

    def breakpoints(self) -> tuple[float, ...]:
        """Return the ends of the pieces, between which the outline is straight; closer where it turns."""
        return self._stations

    @cached_property
    def _stations(self) -> tuple[float, ...]:
        neck, shoulder = self.handle_length, self.handle_length + self.throat
        corner = self.length - self.corner_radius
        turned = np.sin(np.linspace(0, math.pi / 2, CORNER_ROWS + 1))
        rises = 1 - np.cos(np.linspace(0, math.pi / 2, THROAT_ROWS + 1))
        parts = (
            np.linspace(0.0, neck, HANDLE_ROWS + 1)[:-1],
            (neck + self.throat * rises)[:-1],
            np.linspace(shoulder, corner, HEAD_ROWS + 1)[:-1],
            corner + self.corner_radius * turned,
        )
        return tuple(np.concatenate(parts).tolist())

    @cached_property
    def _widths(self) -> Array:
        """Width of the outline at its breakpoints, m."""
        places = np.array(self._stations)
        into_throat = np.clip((self.handle_length + self.throat - places) / self.throat, 0.0, 1.0)
        into_corner = np.clip((places - self.length + self.corner_radius) / self.corner_radius, 0.0, 1.0)
        wider = (self.head_width - self.handle_width) * np.sqrt(1 - into_throat**2)
        cut = 2 * self.corner_radius * (1 - np.sqrt(1 - into_corner**2))
        return self.handle_width + wider - cut

    def width_at(self, position: ArrayLike) -> Array:
        """Return the width of handle, throat or head in m."""
        return np.asarray(np.interp(np.asarray(position, float), self._stations, self._widths))

    def section_at(self, position: Array, scale: Array) -> CrossSection:  # noqa: ARG002 - its mass is measured, not scaled
        """Return the sections at positions in m of the plate as a beam of its width, with rim and handle."""
        width = self.width_at(position)
        in_hand = np.where(position < self.handle_length, 1.0, 0.0)
        rim, handle = (
            self.rim_per_length(position) * 2 * self._edge(position),
            self.handle_mass / self.handle_length * in_hand,
        )
        stiffer = np.where(in_hand > 0, HANDLE_STIFFER, 1.0)
        mass = width * self.areal_mass + rim + handle
        rotary = width * self.areal_inertia
        roll = width**3 / 12 * self.areal_mass + rotary + rim * width**2 / 4 + handle * width**2 / 12
        return CrossSection(
            mass, rotary, width * stiffer * float(self.bending[0, 0]), width * stiffer * self.shear, roll
        )

    def lumps(self) -> tuple[Lump, ...]:
        """Return the part of the rim that crosses the tip."""
        width, per_edge = float(self._widths[-1]), float(self.rim_per_length(self.length))
        return (Lump(self.length, per_edge * width, roll_moi=per_edge * width**3 / 12),)

    def _edge(self, position: Array) -> Array:
        """Return the length of one edge of the head per length of the line; 0 beside the handle."""
        places, widths = np.array(self._stations), self._widths
        steep = np.diff(widths) / np.diff(places) / 2
        piece = np.clip(np.searchsorted(places, position, side="right") - 1, 0, len(steep) - 1)
        return np.where(position < self.handle_length, 0.0, np.sqrt(1 + steep[piece] ** 2))

    @cached_property
    def _edge_lengths(self) -> tuple[float, float]:
        """Lengths of the head's edge in m: along both sides, and round the tip with its corners."""
        places, weights = quadrature(self._stations)
        edge, beside = 2 * weights * self._edge(places), places < self.length - self.corner_radius
        return float(np.sum(edge[beside])), float(np.sum(edge[~beside]) + self._widths[-1])

    @cached_property
    def _weights(self) -> tuple[float, float, float]:
        """Masses in kg of the rim along the sides and round the tip and of the handle that give what was measured.

        Three linear equations for mass, swing weight and twist weight; without the last, the two parts of the rim are
        in the given proportion.
        """
        assert self.mass is not None and self.moi is not None  # refused at construction
        places, weights = quadrature(self._stations)
        width, arm = self.width_at(places), places - self.moi_axis
        tip_width, tip_arm = float(self._widths[-1]), self.length - self.moi_axis
        edge, beside = 2 * weights * self._edge(places), places < self.length - self.corner_radius
        along, round_tip = self._edge_lengths

        def of_edge(edge: Array, tip: float, length: float) -> Array:
            turning, twisting = np.sum(edge * arm**2) + tip * tip_arm**2, np.sum(edge * width**2) / 4
            return np.array([length, turning, twisting + tip * tip_width**2 / 12]) / length

        of_sides = of_edge(np.where(beside, edge, 0.0), 0.0, along)
        of_tip = of_edge(np.where(beside, 0.0, edge), tip_width, round_tip)
        ends = ((0.0 - self.moi_axis) ** 3, (self.handle_length - self.moi_axis) ** 3)
        of_handle = np.array([1.0, (ends[1] - ends[0]) / (3 * self.handle_length), self.handle_width**2 / 12])
        of_plate = np.array([np.sum(weights * part) for part in (width, width * arm**2, width**3 / 12)])
        rotary = float(np.sum(weights * width)) * self.areal_inertia
        rest = np.array([self.mass, self.moi - rotary, (self.twist_moi or 0.0) - rotary]) - self.areal_mass * of_plate
        if self.twist_moi is None:
            part = self.rim_at_tip * round_tip / (along + self.rim_at_tip * round_tip)
            of_rim = (1 - part) * of_sides + part * of_tip
            rim, handle = np.linalg.solve(np.stack([of_rim, of_handle], axis=1)[:2], rest[:2])
            return float((1 - part) * rim), float(part * rim), float(handle)
        sides, tip, handle = np.linalg.solve(np.stack([of_sides, of_tip, of_handle], axis=1), rest)
        return float(sides), float(tip), float(handle)

    def with_its_rim(self) -> Paddle:
        """Return the paddle with the rim that its twist weight says, so that the twist follows what is changed."""
        if self.twist_moi is None:
            return self
        at_tip, beside = self.rim_per_length(self.length), self.rim_per_length(self.handle_length)
        return self.replaced(rim_at_tip=float(at_tip / beside), twist_moi=None)
