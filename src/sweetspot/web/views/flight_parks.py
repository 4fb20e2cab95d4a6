"""What one batted ball does in every park, and balls hit harder and higher in the chosen one."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache
from itertools import compress
from typing import Any

import numpy as np

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import STILL_AIR
from sweetspot.equipment.bat import Bat
from sweetspot.flight.all_parks import PATH_POINTS
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import landing
from sweetspot.flight.home_runs import THIN, home_run_chances
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.motion.ball_motion import BallMotion, BallMotions, spin_axes
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, MPH

FENCE_POINTS = 91
FENCE_STEP = DEGREE / 4
FENCE_DIRECTIONS = np.linspace(-FOUL_LINE, FOUL_LINE, 361)
"""Where a path is held against the fences, every `FENCE_STEP` from foul line to foul line."""
SPEEDS = np.arange(50.0, 121.0, 3.0) * MPH
ANGLES = np.arange(-5.0, 66.0, 3.0) * DEGREE
"""Exit speeds and launch angles of the map."""


def parks_of(bat: Bat) -> tuple[Park, ...]:
    """Return where such bats are swung: the fields of the sport, or every big park."""
    fields = catalog.sport(bat.sport).fields
    return tuple(catalog.park(name) for name in fields) or catalog.parks()


def park_json(park: Park) -> dict[str, Any]:
    """Return a park with its fence."""
    return _park_json(park)


@lru_cache(maxsize=64)
def _park_json(park: Park) -> dict[str, Any]:
    directions = np.linspace(-FOUL_LINE, FOUL_LINE, FENCE_POINTS)
    distance, height = fence_at(park, directions)
    return {
        "name": park.name,
        "team": park.team,
        "city": park.city,
        "roof": park.roof,
        "elevation_m": park.elevation,
        "direction_rad": np.round(directions, 5),
        "right_m": np.round(distance * np.sin(directions), 2),
        "out_m": np.round(distance * np.cos(directions), 2),
        "distance_m": np.round(distance, 2),
        "height_m": np.round(height, 2),
    }


def in_parks(
    motion: BallMotion,
    path: Array,
    parks: tuple[Park, ...],
    *,
    conditions: FlightConditions,
    here: Park,
    own_elevation: bool,
) -> dict[str, Any]:
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
    own = float(home_run_chances(motion, outdoors, parks=(here,), own_elevation=False).chance[0, 0])
    end = landing(path, here)
    rows = []
    for index, (park, direction) in enumerate(zip(parks, _directions(paths, parks).tolist(), strict=True)):
        distance, height = (float(one) for one in fence_at(park, direction))
        foul, above = abs(direction) > FOUL_LINE, float(clearance[index])
        over, reached = above > 0 and not foul, math.isfinite(above) and above > -height and not foul
        rows.append(
            {
                "park": park.name,
                "team": park.team,
                "outcome": "foul" if foul else "home run" if over else "off the wall" if reached else "in play",
                "clearance_m": above if reached else None,
                "carry_m": float(carry[index]),
                "fence_m": None if foul else distance,
                # in its own air, not between those of all the parks
                "chance": 0.0 if foul else own if park.name == here.name else float(chance[index]),
            }
        )
    return {
        "parks": rows,
        "out_in": sum(row["outcome"] == "home run" for row in rows),
        "of": len(rows),
        "expected_out_in": sum(row["chance"] for row in rows),
        "chance": 0.0 if end.outcome == "foul" else own,
        "end": {
            "outcome": end.outcome,
            "direction_rad": end.direction,
            "distance_m": end.distance,
            "height_m": end.height,
            "clearance_m": end.clearance,
        },
    }


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
    density = np.array([one.one_air.density for one in there])
    for law in {one.aerodynamics for one in there}:
        those = np.array([one.aerodynamics == law for one in there])
        found = flights(motion, replace(there[0], aerodynamics=law, air=density[those]), path_points=PATH_POINTS)
        carry[those], paths[those] = found.carry, found.positions
    return carry, paths


def _directions(paths: Array, parks: tuple[Park, ...]) -> Array:
    """Return where each path passes its park's fence, or comes down: rad from centre field, shape (parks,)."""
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


def carries(
    motion: BallMotion, *, conditions: FlightConditions, park: Park, own_elevation: bool = False
) -> dict[str, Any]:
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
    return {
        "exit_speed_m_s": SPEEDS,
        "launch_angle_rad": ANGLES,
        "carry_m": np.round(flown.carry.reshape(shape), 2),
        "chance": np.round(chance.reshape(shape), 4),
    }


def outlines(parks: tuple[Park, ...]) -> list[dict[str, Any]]:
    """Return the fences of parks as seen from above."""
    return [{name: park_json(park)[name] for name in ("name", "right_m", "out_m")} for park in parks]
