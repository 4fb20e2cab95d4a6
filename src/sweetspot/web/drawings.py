"""A bat and a ball as numbers for a drawing and for their controls."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.records import Length, Mass, MomentOfInertia, Ratio
from sweetspot.answers.setups import SwungWith
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import RigidBody, moi_doubt, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import REACH
from sweetspot.reports.notebook import effort_words
from sweetspot.units.dimensions import LENGTH, System
from sweetspot.web.bat_bounds import Range, bounds
from sweetspot.web.bats import UsualHit, bought_ball, changed_bat, conditions_of, usual
from sweetspot.web.controls import BatState, SwungState
from sweetspot.web.documents import in_either_system, in_one_system

POINTS = 120
"""Places along a bat whose outline is a formula."""


@dataclass(frozen=True)
class DrawnOutline:
    """Diameters along a bat, from the knob end, shape (n,)."""

    position: Annotated[Array, LENGTH]
    diameter: Annotated[Array, LENGTH]


@dataclass(frozen=True)
class Station:
    """One diameter of a bat that is drawn by stations."""

    position: Length
    diameter: Length


@dataclass(frozen=True)
class DrawnBore:
    """A hole from the tip, between two places from the knob end; ``fill`` names what it is filled with."""

    diameter: Length
    start: Length
    stop: Length
    fill: str | None


@dataclass(frozen=True)
class DrawnCup:
    """A hollow turned into the tip."""

    diameter: Length
    depth: Length


@dataclass(frozen=True)
class DrawnWeight:
    """A weight fixed to the bat."""

    position: Length
    mass: Mass


@dataclass(frozen=True, kw_only=True)
class BatShape:
    """The data of a bat's drawing to scale; ``wall`` is of a hollow bat, at the places of its outline."""

    outline: DrawnOutline
    stations: tuple[Station, ...]
    hollow: bool
    wall: Annotated[Array | None, LENGTH]
    bores: tuple[DrawnBore, ...]
    cup: DrawnCup | None
    weights: tuple[DrawnWeight, ...]
    material: str
    remark: Mapping[System, str]


@dataclass(frozen=True, kw_only=True)
class BenchBat(BatShape, MassProperties):
    """A bat: its facts, its shape, and how far its controls may go."""

    bounds: Mapping[str, Range]


@dataclass(frozen=True, kw_only=True)
class BatPicture(BenchBat):
    """A bat as `BenchBat` has it, and what is usual in its sport.

    Parameters
    ----------
    moi_6in_half : half the 90 % interval of ``moi_6in``; 0: it was measured.
    swung : how a changed bat is swung, in a sentence; None: nothing was changed of it.
    """

    moi_6in_half: MomentOfInertia
    sport: str
    usual: UsualHit
    swung: Mapping[System, str] | None


@dataclass(frozen=True)
class BallPicture:
    """A ball's size, and the values of its controls while they have not been moved."""

    radius: Length
    mass: Mass
    cor: Ratio
    humidity: Ratio
    temperature_degf: float


def bench_bat(state: BatState, bat: Bat) -> BenchBat:
    """Return a state's bat without what is usual in its sport."""
    masses = mass_properties(bat, rigid_body(beam_model(bat)))
    return BenchBat(**vars(masses), **vars(outline(bat)), bounds=bounds(state, bat))


def bat_picture(state: BatState, reduced: ReducedBat) -> BatPicture:
    """Return the picture of a state's bat."""
    return BatPicture(
        **vars(mass_properties(reduced.bat, reduced.body)),
        **vars(outline(reduced.bat)),
        moi_6in_half=moi_half(reduced.bat, reduced.body),
        bounds=bounds(state, reduced.bat),
        sport=reduced.bat.sport,
        usual=usual(reduced.bat),
        swung=_how_swung(state, reduced.bat) if isinstance(state, SwungState) else None,
    )


def _how_swung(state: SwungState, bat: Bat) -> dict[System, str] | None:
    changed = changed_bat(state)
    if changed is None:
        return None
    swung_with = SwungWith.of(changed, conditions_of(state, bat), same_speed=state.same == "speed")
    return in_either_system(effort_words(swung_with))


def moi_half(bat: Bat, body: RigidBody) -> float:
    """Return half the 90 % interval of a bat's swing weight in kg m^2; 0: it was measured."""
    return REACH * moi_doubt(bat, body, STANDARD_AXIS)


def ball_picture(state: SwungState, ball: Ball) -> BallPicture:
    """Return the picture of a ball."""
    listed = bought_ball(state)
    warm = listed.reference_temperature * 1.8 + 32
    return BallPicture(ball.radius, ball.mass, listed.restitution.reference, listed.reference_humidity, warm)


def outline(bat: Bat) -> BatShape:
    """Return the shape of a bat and what is inside it."""
    edges = np.asarray(bat.breakpoints())
    places = edges if bat.profile is not None else np.union1d(edges, np.linspace(0, bat.length, POINTS))
    return BatShape(
        outline=DrawnOutline(places, bat.diameter_at(places)),
        stations=tuple(Station(place, width) for place, width in bat.profile or ()),
        hollow=bat.shell is not None,
        wall=None if bat.shell is None else bat.wall_at(places),
        bores=tuple(
            DrawnBore(
                diameter=bore.diameter,
                start=bat.length - bore.depth,
                stop=bat.length - bore.plug,
                fill=None if bore.fill is None else bore.fill.name,
            )
            for bore in bat.bores
        ),
        cup=None if bat.cup is None else DrawnCup(bat.cup.diameter, bat.cup.depth),
        weights=tuple(DrawnWeight(weight.position, weight.mass) for weight in bat.point_masses),
        material=bat.material.name,
        remark=in_one_system(bat.remark),
    )
