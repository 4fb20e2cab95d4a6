"""The outcome of one batted ball in every park, and of balls hit harder and higher in the chosen one."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import compress
from typing import Annotated, Literal

import numpy as np

from sweetspot import catalog
from sweetspot.answers.flight import FlightEnd
from sweetspot.answers.records import GRID, Distance, Ratio
from sweetspot.catalog.aerodynamic_laws import STILL_AIR
from sweetspot.equipment.bat import Bat
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import PATH_POINTS, landing
from sweetspot.flight.home_runs import THIN, home_run_chances
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.motion.ball_motion import BallMotion, BallMotions, spin_axes
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, MPH
from sweetspot.units.dimensions import ANGLE, DISTANCE, SPEED

FENCE_POINTS = 91
FENCE_STEP = DEGREE / 4
FENCE_DIRECTIONS = np.linspace(-FOUL_LINE, FOUL_LINE, 361)
"""Directions in which a path is compared with the fences, every `FENCE_STEP` from foul line to foul line."""
SPEEDS = np.arange(50.0, 121.0, 3.0) * MPH
ANGLES = np.arange(-5.0, 66.0, 3.0) * DEGREE
"""Exit speeds and launch angles of the map."""


def parks_of(bat: Bat) -> tuple[Park, ...]:
    """Return the fields on which such bats are swung: those of the sport, or every big park."""
    fields = catalog.sport(bat.sport).fields
    return tuple(catalog.park(name) for name in fields) or catalog.parks()


@dataclass(frozen=True)
class FenceOutline:
    """A park's fence from above, shape (n,): to the right of home plate, and towards centre field."""

    name: str
    right: Annotated[Array, DISTANCE]
    out: Annotated[Array, DISTANCE]


@dataclass(frozen=True, kw_only=True)
class DrawnPark(FenceOutline):
    """A park and its fence, by direction from centre field."""

    team: str
    city: str
    roof: str
    elevation: Distance
    direction: Annotated[Array, ANGLE]
    distance: Annotated[Array, DISTANCE]
    height: Annotated[Array, DISTANCE]


@dataclass(frozen=True, kw_only=True)
class OutcomeInPark:
    """One ball in one park.

    Parameters
    ----------
    clearance : above the fence's top; None: it does not reach it.
    carry : to the ground, as if there were no fence.
    fence : how far it is there; None: the ball is foul.
    """

    park: str
    team: str
    outcome: Literal["foul", "home run", "off the wall", "in play"]
    clearance: Distance | None
    carry: Distance
    fence: Distance | None
    chance: Ratio


@dataclass(frozen=True, kw_only=True)
class OutcomeInParks:
    """One ball in every park, and where it ends in the chosen one.

    Parameters
    ----------
    out_in, of, expected_out_in : how many parks it leaves, of how many, and how many on average with its scatter.
    chance : of a home run in the chosen park.
    """

    parks: tuple[OutcomeInPark, ...]
    out_in: int
    of: int
    expected_out_in: float
    chance: Ratio
    end: FlightEnd


@dataclass(frozen=True)
class CarryMap:
    """Carry, and chance of a home run, of balls hit harder and higher; rows by launch angle."""

    exit_speed: Annotated[Array, SPEED]
    launch_angle: Annotated[Array, ANGLE]
    carry: Annotated[Array, DISTANCE, GRID]
    chance: Annotated[Array, GRID]


@lru_cache(maxsize=64)
def drawn_park(park: Park) -> DrawnPark:
    """Return a park with its fence."""
    directions = np.linspace(-FOUL_LINE, FOUL_LINE, FENCE_POINTS)
    distance, height = fence_at(park, directions)
    return DrawnPark(
        name=park.name,
        right=np.round(distance * np.sin(directions), 2),
        out=np.round(distance * np.cos(directions), 2),
        team=park.team,
        city=park.city,
        roof=park.roof,
        elevation=park.elevation,
        direction=np.round(directions, 5),
        distance=np.round(distance, 2),
        height=np.round(height, 2),
    )


def in_parks(
    motion: BallMotion,
    path: Array,
    parks: tuple[Park, ...],
    *,
    conditions: FlightConditions,
    here: Park,
    own_elevation: bool,
) -> OutcomeInParks:
    """Return one ball's outcome and carry in every park, in how many it is out, and chances with the flights' scatter.

    Parameters
    ----------
    path : m, shape (points, 3), of this very flight, which says where it ends in the park ``here``.
    parks : that are asked.
    """
    outdoors = _outdoors(conditions)
    there = [catalog.conditions_in(park, outdoors, own_elevation=own_elevation) for park in parks]
    chance, clearance = _everywhere(motion, outdoors, parks, own_elevation)
    carry, paths = _flown(motion, there)
    chance_here = float(home_run_chances(motion, outdoors, parks=(here,), own_elevation=False).chance[0, 0])
    end = landing(path, here)
    rows = []
    for index, (park, direction) in enumerate(zip(parks, _directions(paths, parks).tolist(), strict=True)):
        distance, height = (float(side) for side in fence_at(park, direction))
        foul, above = abs(direction) > FOUL_LINE, float(clearance[index])
        over, reached = above > 0 and not foul, math.isfinite(above) and above > -height and not foul
        # in its own air, not between those of all the parks
        likely = chance_here if park.name == here.name else float(chance[index])
        rows.append(
            OutcomeInPark(
                park=park.name,
                team=park.team,
                outcome="foul" if foul else "home run" if over else "off the wall" if reached else "in play",
                clearance=above if reached else None,
                carry=float(carry[index]),
                fence=None if foul else distance,
                chance=0.0 if foul else likely,
            )
        )
    return OutcomeInParks(
        parks=tuple(rows),
        out_in=sum(row.outcome == "home run" for row in rows),
        of=len(rows),
        expected_out_in=sum(float(row.chance) for row in rows),
        chance=0.0 if end.outcome == "foul" else chance_here,
        end=FlightEnd(park=here.name, **vars(end)),
    )


def _everywhere(
    motion: BallMotion, outdoors: FlightConditions, parks: tuple[Park, ...], own_elevation: bool
) -> tuple[Array, Array]:
    """Return chances and clearances in every park: in thin air apart, and under a roof the clearance of still air."""
    chance, clearance = np.empty((2, len(parks)))
    thin = np.array([own_elevation and park.elevation > THIN for park in parks])
    for those in (thin, ~thin):
        if those.any():
            found = home_run_chances(
                motion, outdoors, parks=compress(parks, those.tolist()), own_elevation=own_elevation
            )
            chance[those], clearance[those] = found.chance[0], found.clearance[0]
    for place, park in enumerate(parks):
        law = catalog.aerodynamics_in(park, outdoors.aerodynamics)
        if law != outdoors.aerodynamics:  # chances know by themselves what a roof does
            still = replace(outdoors, aerodynamics=law)
            found = home_run_chances(motion, still, parks=(park,), own_elevation=own_elevation)
            clearance[place] = found.clearance[0, 0]
    return chance, clearance


def _flown(motion: BallMotion, there: list[FlightConditions]) -> tuple[Array, Array]:
    """Return carries and paths, (parks, points, 3), of one ball in the airs of many parks, all of a law at once."""
    carry, paths = np.empty(len(there)), np.empty((len(there), PATH_POINTS, 3))
    density = np.array([conditions.one_air.density for conditions in there])
    for law in {conditions.aerodynamics for conditions in there}:
        those = np.array([conditions.aerodynamics == law for conditions in there])
        found = flights(motion, replace(there[0], aerodynamics=law, air=density[those]), path_points=PATH_POINTS)
        carry[those], paths[those] = found.carry, found.positions
    return carry, paths


def _directions(paths: Array, parks: tuple[Park, ...]) -> Array:
    """Return the direction of each path at its park's fence, or where it lands: rad from centre, shape (parks,)."""
    far, way = np.hypot(paths[..., 0], paths[..., 1]), np.arctan2(paths[..., 0], paths[..., 1])
    step = np.rint((way + FOUL_LINE) / FENCE_STEP).astype(int).clip(0, len(FENCE_DIRECTIONS) - 1)
    beyond = far > np.take_along_axis(_fences(parks), step, axis=1)
    at = np.where(beyond.any(axis=1), beyond.argmax(axis=1), -1)
    return np.asarray(way[np.arange(len(parks)), at])


@lru_cache(maxsize=64)
def _fences(parks: tuple[Park, ...]) -> Array:
    return np.array([fence_at(park, FENCE_DIRECTIONS)[0] for park in parks])


def _outdoors(conditions: FlightConditions) -> FlightConditions:
    """Return the same in the open: the scatter of chances knows by itself what a roof does."""
    if conditions.aerodynamics != catalog.aerodynamics(STILL_AIR):
        return conditions
    return replace(conditions, aerodynamics=catalog.aerodynamics())


def carries(motion: BallMotion, *, conditions: FlightConditions, park: Park, own_elevation: bool = False) -> CarryMap:
    """Return carry, and chance of a home run in a park, of balls hit harder and higher with this spin and direction.

    Parameters
    ----------
    own_elevation : whether chances are those at the park's elevation, whatever that of the conditions.
    """
    speed, angle = (axis.ravel() for axis in np.meshgrid(SPEEDS, ANGLES))
    axes = spin_axes(angle, motion.spray)
    many = BallMotions(
        velocity=speed[:, None] * axes[2],
        spin=motion.backspin * axes[0] + motion.sidespin * axes[1],
        position=motion.position,
    )
    shape = (len(ANGLES), len(SPEEDS))
    flown = flights(many, conditions)
    chance = home_run_chances(many, _outdoors(conditions), parks=(park,), own_elevation=own_elevation).chance
    return CarryMap(SPEEDS, ANGLES, np.round(flown.carry.reshape(shape), 2), np.round(chance.reshape(shape), 4))


def outlines(parks: tuple[Park, ...]) -> tuple[FenceOutline, ...]:
    """Return the fences of parks as seen from above."""
    return tuple(FenceOutline(park.name, park.right, park.out) for park in map(drawn_park, parks))
