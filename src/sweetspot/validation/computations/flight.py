"""Flights: of batted baseballs and what changes their carry, of pitches to the plate, after the best swing."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any, Literal

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import exit_speed_of, hit_at
from sweetspot.analysis.optimum import BestSwing, best_launch, best_swing
from sweetspot.catalog.aerodynamic_laws import aerodynamics, usual_spin_line
from sweetspot.catalog.deliveries import usual_height
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.oblique_contact import FRICTION, TANGENTIAL_RESTITUTION, Friction
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.aerodynamics import drag_and_lift
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.pitch import MIDDLE, PitchFlight, aimed
from sweetspot.flight.sweep import BattedBall
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.units import DEGREE, FOOT, INCH_OF_MERCURY, MPH, RPM
from sweetspot.validation.computations import shared

USUAL = BattedBall(
    exit_speed=100 * MPH,
    launch_angle=28 * DEGREE,
    temperature=38 / 1.8,
    humidity=0.5,
    pressure=29.92 * INCH_OF_MERCURY,
    elevation=15 * FOOT,
)
"""A fly ball of 403 ft to center field with the spin that such balls usually have, in the sheet's own weather."""


@cache
def _path(hit: BattedBall, law: str) -> Flight:
    return fly(
        hit.motion,
        FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(law), air=hit.air, wind=hit.wind),
    )


def _hit(changes: Mapping[str, Any], law: str = "baseball") -> BattedBall:
    return replace(USUAL, line=usual_spin_line(law), **changes)


def fly_ball(*, law: str = "baseball", **changes: Any) -> Flight:
    """Return the flight of a fly ball.

    ``law``: name of the law of drag and lift. ``changes``: fields of `BattedBall` that differ from `USUAL`, SI.
    """
    return _path(_hit(changes, law), law)


def carry_gain(*, by: dict[str, float], law: str = "baseball", **changes: Any) -> float:
    """Return the gain of carry of a fly ball by a change.

    ``by``: change of a field of `BattedBall`: temperature in K, elevation in ft, humidity, pressure in Pa, exit_speed
    and wind_speed in mph, sidespin and backspin in rpm.
    """
    units = {"elevation": FOOT, "exit_speed": MPH, "wind_speed": MPH, "sidespin": RPM, "backspin": RPM}
    before = _hit(changes, law)
    motion = before.motion
    spinning = replace(before, backspin=motion.backspin, sidespin=motion.sidespin)
    moved = {name: getattr(spinning, name) + change * units.get(name, 1.0) for name, change in by.items()}
    return _path(replace(spinning, **moved), law).carry - _path(spinning, law).carry


def carry_gain_of_drag(*, less: float, law: str = "baseball", **changes: Any) -> float:
    """Return the gain of carry of a fly ball from a drag coefficient smaller by ``less``."""
    hit, usual = _hit(changes, law), catalog.aerodynamics(law)
    slick = FlightConditions(
        ball=catalog.ball(), aerodynamics=usual.replaced(drag=usual.drag - less), air=hit.air, wind=hit.wind
    )
    return fly(hit.motion, slick).carry - _path(hit, law).carry


def lift_at(*, spin_factor: float, law: str = "baseball") -> float:
    """Return the lift coefficient at a spin factor S = R omega / v."""
    return catalog.aerodynamics(law).lift_coefficient(spin_factor)


def wind_asymmetry(*, wind_speed: float, law: str = "baseball") -> float:
    """Return the gain of carry by a wind out minus the loss by the same wind in."""
    still = _path(_hit({}, law), law).carry
    out = _path(_hit({"wind_speed": wind_speed}, law), law).carry
    head = _path(_hit({"wind_speed": wind_speed, "wind_direction": np.pi}, law), law).carry
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
    coefficients = catalog.aerodynamics(law)
    pushes = drag_and_lift(
        hit.motion.velocity,
        spin=hit.motion.spin,
        ball=catalog.ball(),
        aerodynamics=coefficients,
        density=hit.air.density,
    )
    return float(pushes[("drag", "lift").index(part)][("right", "out", "up").index(along)])


def coefficient(*, part: str, law: str = "baseball", **changes: Any) -> float:
    """Return Cd or Cl or the spin factor S at the start of a flight."""
    motion, coefficients = _hit(changes, law).motion, catalog.aerodynamics(law)
    across = float(np.linalg.norm(np.cross(motion.spin, motion.velocity))) / motion.speed
    factor = catalog.ball().radius * across / motion.speed
    if part == "drag":
        return coefficients.drag_coefficient(factor, spin=float(np.linalg.norm(motion.spin)))
    return coefficients.lift_coefficient(factor) if part == "lift" else factor


def flight_place(*, time: float, along: str, law: str = "baseball", **changes: Any) -> float:
    """Return the ball's position after a time: out or up."""
    place = _path(_hit(changes, law), law).at(time).position
    return float(place[("right", "out", "up").index(along)])


def carry_gain_of_hit(*, bat: str, **changes: float) -> float:
    """Return the gain of carry of a bat's best hit with a ball ``warmer`` by some K, or a pitch ``faster``."""
    return _carry(bat, **changes) - _carry(bat)


def _carry(bat: str, *, warmer: float = 0.0, faster: float = 0.0) -> float:
    analysis = shared.standard(bat)
    usual = analysis.conditions
    conditions = usual.replaced(
        ball=usual.ball.conditioned(temperature=usual.ball.reference_temperature + warmer),
        pitch=usual.pitch.replaced(speed=usual.pitch.speed + faster),
    )
    impact = hit_at(analysis.sweet_spots.max_exit_speed, modes=analysis.modes, conditions=conditions)
    return fly_ball(exit_speed=exit_speed_of(impact, conditions)).carry


DAY = Air(temperature=22.2, elevation=290 * FOOT)
"""What the drag was fitted with: 72 degF (assumed) at the mean elevation of the day's parks."""
DAY_DRAG = 0.2905
"""Of the law of pitches: the day's own level [savant_2020day]; balls differ from year to year."""


@cache
def pitch_flight(pitch: str) -> PitchFlight:
    """Return the flight of a catalogue pitch to its usual place over the plate, by the day's drag."""
    return aimed(
        catalog.delivery(pitch),
        ball=catalog.ball(),
        aerodynamics=aerodynamics("pitched-baseball").replaced(drag=DAY_DRAG),
        air=DAY,
        target=(MIDDLE[0], usual_height(pitch)),
    )


def pitch_mean_speed_ratio(*, pitches: dict[str, int]) -> float:
    """Return the mean ratio over a mix of pitches, given how often each was thrown."""
    total = sum(count * pitch_flight(pitch).speed_ratio for pitch, count in pitches.items())
    return total / sum(pitches.values())


BAT = "r161-ash"
SHEET = Air(temperature=21.11, humidity=0.5, elevation=15 * FOOT)
PITCHES = {"fastball": (85.4, 2347, -4.9), "curve": (72.1, -2549, -9.8), "knuckleball": (72.1, 0, -9.0)}
"""Speed at the plate in mph, backspin in rpm, all of it active, and approach angle in degrees."""
Model = Literal["measured", "rolling"]


@cache
def best_swing_at(pitch: str, model: Model, friction: float = FRICTION) -> BestSwing:
    """Return the best level swing at a pitch.

    "measured": friction gives a part of the sliding back and drag grows with spin; "rolling": the ball leaves rolling
    on the bat and its drag does not know of its spin.
    """
    bat, ball = catalog.bat(BAT), catalog.ball()
    speed, backspin, fall = PITCHES[pitch]
    arriving = batted_ball(
        speed=speed * MPH, launch_angle=fall * DEGREE, spray=math.pi, backspin=backspin * RPM, position=(0.0, 0.6, 0.9)
    )
    law = catalog.aerodynamics()
    return best_swing(
        reduced_bat(bat, ball=ball),
        FlightConditions(
            ball=ball, aerodynamics=law if model == "measured" else law.replaced(drag_per_active_spin=0.0), air=SHEET
        ),
        swing=standard_conditions(bat).swing,
        pitch=arriving,
        friction=Friction(
            coefficient=friction, tangential_restitution=TANGENTIAL_RESTITUTION if model == "measured" else 0.0
        ),
    )


def best_carry_gain(*, pitch: str, other_pitch: str, model: Model) -> float:
    """Return the best carry of a pitch minus that of another."""
    return best_swing_at(pitch, model).carry - best_swing_at(other_pitch, model).carry


def best_carry_change_by_friction(*, pitch: str, friction: float) -> float:
    """Return the change of the best carry by another coefficient of friction."""
    return best_swing_at(pitch, "measured", friction).carry - best_swing_at(pitch, "measured").carry


def best_launch_angle(*, exit_speed: float, backspin: float, law: str = "baseball") -> float:
    """Return the launch angle of the greatest carry."""
    conditions = FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(law), air=SHEET)
    return best_launch(exit_speed, conditions, backspin=backspin).launch_angle
