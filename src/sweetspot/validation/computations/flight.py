"""Flights of baseballs, and what changes them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import usual_spin_line
from sweetspot.flight.aerodynamics import drag_and_lift
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.sweep import BattedBall
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.units import DEGREE, FOOT, INCH_OF_MERCURY, MPH, RPM

"""Pa."""

USUAL = BattedBall(
    exit_speed=100 * MPH,
    launch_angle=28 * DEGREE,
    temperature=38 / 1.8,
    humidity=0.5,
    pressure=29.92 * INCH_OF_MERCURY,
    elevation=15 * FOOT,
)
"""A fly ball of 403 ft to centre field with the spin that such balls usually have, in the sheet's own weather."""


@cache
def _flown(hit: BattedBall, law: str) -> Flight:
    return fly(
        hit.motion,
        FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(law), air=hit.air, wind=hit.wind),
    )


def _hit(changes: dict[str, Any], law: str = "baseball") -> BattedBall:
    return replace(USUAL, line=usual_spin_line(law), **changes)


def fly_ball(*, answer: str, law: str = "baseball", **changes: Any) -> float:
    """Return carry, hang_time, apex_height, landing_angle or landing_speed of a fly ball.

    Parameters
    ----------
    law : name of the law of drag and lift.
    changes : fields of `BattedBall` that differ from `USUAL`, SI.
    """
    flight = _flown(_hit(changes, law), law)
    return flight.landing.speed if answer == "landing_speed" else float(getattr(flight, answer))


def carry_gain(*, by: dict[str, float], law: str = "baseball", **changes: Any) -> float:
    """Return how much farther a fly ball carries when something changes.

    Parameters
    ----------
    by : change of a field of `BattedBall`: temperature in K, elevation in ft, humidity, pressure in Pa, exit_speed and
        wind_speed in mph, sidespin and backspin in rpm.
    """
    units = {"elevation": FOOT, "exit_speed": MPH, "wind_speed": MPH, "sidespin": RPM, "backspin": RPM}
    before = _hit(changes, law)
    motion = before.motion
    known = replace(before, backspin=motion.backspin, sidespin=motion.sidespin)
    moved = {name: getattr(known, name) + change * units.get(name, 1.0) for name, change in by.items()}
    return _flown(replace(known, **moved), law).carry - _flown(known, law).carry


def carry_gain_of_drag(*, less: float, law: str = "baseball", **changes: Any) -> float:
    """Return how much farther a fly ball carries when its drag coefficient is smaller by ``less`` all the way."""
    hit, usual = _hit(changes, law), catalog.aerodynamics(law)
    slick = FlightConditions(
        ball=catalog.ball(), aerodynamics=usual.replaced(drag=usual.drag - less), air=hit.air, wind=hit.wind
    )
    return fly(hit.motion, slick).carry - _flown(hit, law).carry


def lift_at(*, spin_factor: float, law: str = "baseball") -> float:
    """Return the lift coefficient at a spin factor S = R omega / v."""
    return catalog.aerodynamics(law).lift_coefficient(spin_factor)


def wind_asymmetry(*, wind_speed: float, law: str = "baseball") -> float:
    """Return what a wind out gives less what the same wind in takes."""
    still = _flown(_hit({}, law), law).carry
    out = _flown(_hit({"wind_speed": wind_speed}, law), law).carry
    head = _flown(_hit({"wind_speed": wind_speed, "wind_direction": np.pi}, law), law).carry
    return (out - still) - (still - head)


def air_density_of(**changes: Any) -> float:
    """Return the density of the air."""
    return _hit(changes).air.density


def air_density_ratio(*, elevation: float) -> float:
    """Return the density of the air at an elevation over that at the sea."""
    return _hit({"elevation": elevation}).air.density / _hit({"elevation": 0.0}).air.density


def push_of_air(*, part: str, along: str, law: str = "baseball", **changes: Any) -> float:
    """Return the acceleration by drag or lift at the start, along one axis: right, out or up."""
    hit = _hit(changes, law)
    pushes = drag_and_lift(
        hit.motion.velocity, spin=hit.motion.spin, ball=catalog.ball(), aerodynamics=catalog.aerodynamics(law),
        density=hit.air.density,
    )  # fmt: skip
    return float(pushes[("drag", "lift").index(part)][("right", "out", "up").index(along)])


def coefficient(*, part: str, law: str = "baseball", **changes: Any) -> float:
    """Return Cd or Cl or the spin factor S at the start of a flight."""
    motion = _hit(changes, law).motion
    known, factor = catalog.aerodynamics(law), _spin_factor(motion)
    values = {
        "spin factor": factor,
        "drag": known.drag_coefficient(factor, spin=float(np.linalg.norm(motion.spin))),
        "lift": known.lift_coefficient(factor),
    }
    return values[part]


def _spin_factor(motion: BallMotion) -> float:
    across = float(np.linalg.norm(np.cross(motion.spin, motion.velocity))) / motion.speed
    return catalog.ball().radius * across / motion.speed


def flight_place(*, time: float, along: str, law: str = "baseball", **changes: Any) -> float:
    """Return where the ball is after a time: out or up."""
    place = _flown(_hit(changes, law), law).at(time).position
    return float(place[("right", "out", "up").index(along)])


COMPUTATIONS = (
    fly_ball,
    carry_gain,
    carry_gain_of_drag,
    lift_at,
    wind_asymmetry,
    air_density_of,
    air_density_ratio,
    push_of_air,
    coefficient,
    flight_place,
)
