"""Flight: where a batted ball goes in a chosen park and weather, and in how many parks it is out."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics_in
from sweetspot.catalog.sports import aerodynamics_of_ball
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import Air, Wind
from sweetspot.flight.all_parks import PATH_POINTS
from sweetspot.flight.bearing import launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, launched
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.units import FOOT, INCH, INCH_OF_MERCURY, MPH, RPM
from sweetspot.web.bats import ball_of, conditions_of, described, reduced, swung, usual
from sweetspot.web.documents import ReadDocument, told
from sweetspot.web.drawings import bat_picture
from sweetspot.web.errors import FieldError, about
from sweetspot.web.view import View
from sweetspot.web.views.flight_parks import carries, in_parks, outlines, park_json, parks_of
from sweetspot.web.views.flight_recipe import flight_lines
from sweetspot.web.views.flight_state import FlightState

FORWARD = USUAL_CONTACT[1]
"""m in front of the plate's tip where ball and bat meet."""
SHOWN = 2
"""Every how many points of a path are handed out."""


def answer(state: FlightState) -> dict[str, Any]:
    """Return the path, its end at the fence of the chosen park, and the outcome in every park."""
    start = _start(state)
    park, conditions, usual_park = start.park, start.conditions, usual(described(state)).park
    if start.motion is None:
        return {"start": state.start, "missed": True, **_swung(start.struck), "park": park_json(park), "parks": [],
                "usual_park": usual_park}  # fmt: skip
    flown = _flown(start.motion, conditions)
    own_elevation = state.own_elevation and state.elevation_ft is None  # a chosen elevation is that of every park
    return {
        "start": state.start,
        "missed": False,
        **_swung(start.struck),
        "launch": _launch(start.motion),
        "flight": _flight(flown, 0),
        "without_air": _flight(flown, 1),
        "path": _path(flown, 0),
        "path_without_air": _path(flown, 1),
        "park": park_json(park),
        "usual_park": usual_park,
        **in_parks(
            start.motion,
            flown.positions[0],
            parks_of(described(state)),
            conditions=conditions,
            here=park,
            own_elevation=own_elevation,
        ),
        "air_density_kg_m3": conditions.one_air.density,
        "elevation_m": conditions.one_air.elevation,
    }


def carry_map(state: FlightState) -> dict[str, Any]:
    """Return carries over exit speed and launch angle, for this ball's spin and direction in this park and weather."""
    start = _start(state)
    if start.motion is None:
        raise FieldError("offset_in", "the bat misses the ball; there is nothing to map")
    return carries(start.motion, conditions=start.conditions, park=start.park)


def sure(state: FlightState) -> ReadDocument:
    """Return the play, or the flight of a ball with its own numbers, with an interval beside each number."""
    from sweetspot.answers.flight import FlightQuestion, flight_answer
    from sweetspot.answers.flight_draws import flight_sources
    from sweetspot.answers.play import play_answer
    from sweetspot.answers.play_draws import play_sources
    from sweetspot.answers.play_question import PlayQuestion
    from sweetspot.report.flight.document import flight_document
    from sweetspot.report.play.document import play_document
    from sweetspot.web.how_sure import PAGE_DRAWS, sources_for

    start = _start(state)
    if start.motion is None:
        raise FieldError("offset_in", "the bat misses the ball; there is nothing to be sure of")
    flying = start.conditions
    if state.start == "ball":
        question = FlightQuestion(start.motion, flying, flight_sources(flying.aerodynamics), PAGE_DRAWS)
        return told(flight_document(flight_answer(question)))
    free_bat, conditions, path, pitch, contact = _met(state, ball_of(state))
    known = play_sources(sources_for(state, free_bat.bat, conditions), flying.aerodynamics)
    model = free_bat.held(conditions.hands)
    asked = PlayQuestion(model, conditions, flying, path, pitch, contact, sources=known, draws=PAGE_DRAWS)
    return told(play_document(play_answer(asked)))


def fences(state: FlightState) -> dict[str, Any]:
    """Return the fences of every park."""
    return {"parks": outlines(parks_of(described(state)))}


class _Start(NamedTuple):
    """How the ball leaves, into what, and where; the motion is None where the bat misses it."""

    park: Park
    conditions: FlightConditions
    struck: dict[str, Any] | None
    motion: BallMotion | None


def _start(state: FlightState) -> _Start:
    with about("park"):
        park = catalog.park(swung(state).park or "")
    ball = ball_of(state)
    conditions = _conditions(state, park, ball)
    struck = _struck(state, ball) if state.start == "swing" else None
    motion = launched_by(state, conditions) if struck is None else struck["motion"]
    return _Start(park, conditions, struck, motion)


def launched_by(state: FlightState, conditions: FlightConditions) -> BallMotion:
    """Return the ball as the controls say that it leaves the bat."""
    speed, up, spins = state.exit_speed_mph * MPH, math.radians(state.launch_angle_deg), _spins(state)
    place, spray = (0.0, FORWARD, state.height_ft * FOOT), math.radians(state.spray_deg)
    if state.direction == "landing":
        aim, _ = launched_to(
            spray, exit_speed=speed, launch_angle=up, conditions=conditions, spins=spins, position=place
        )
        if not math.isfinite(aim[0]):
            raise FieldError("spray_deg", "no launch direction brings this ball down there; ask for another one")
        spray = float(aim[0])
    return launched(
        speed=speed, launch_angle=up, spray=spray, backspin=spins[0], sidespin=spins[1], position=place
    )  # fmt: skip


def _spins(state: FlightState) -> tuple[float, float]:
    return state.backspin_rpm * RPM, state.sidespin_rpm * RPM


def _conditions(state: FlightState, park: Park, ball: Ball) -> FlightConditions:
    elevation = park.elevation if state.elevation_ft is None else state.elevation_ft * FOOT
    with about("pressure_inhg"):
        air = Air(
            temperature=(state.temperature_degf - 32) / 1.8,
            pressure=state.pressure_inhg * INCH_OF_MERCURY,
            humidity=state.relative_humidity,
            elevation=elevation,
        )
    wind = Wind(speed=state.wind_speed_mph * MPH, direction=math.radians(state.wind_direction_deg))
    with about("ball"):
        law = aerodynamics_in(park, aerodynamics_of_ball(swung(state).ball or ""))
    return FlightConditions(ball=ball, aerodynamics=law, air=air, wind=wind)


class _Meeting(NamedTuple):
    """A pitch and the swing that meets it."""

    free_bat: ReducedBat[Bat]
    conditions: Conditions
    path: SwingPath
    pitch: BallMotion
    contact: Contact


def _met(state: FlightState, ball: Ball) -> _Meeting:
    """Return the pitch and the swing that the controls describe."""
    free_bat = reduced(state, ball)
    bat, conditions = free_bat.bat, conditions_of(state, free_bat.bat)
    with about("tilt_deg"):
        path = SwingPath(
            attack_angle=math.radians(state.attack_angle_deg),
            attack_direction=math.radians(state.attack_direction_deg),
            tilt=math.radians(state.tilt_deg),
            bats=state.batter,
        )
    place = bat.length - state.impact_from_tip_in * INCH
    if place < conditions.hands.position:
        raise FieldError("impact_from_tip_in", "the ball would meet the hands; meet it nearer to the tip")
    pitch = launched(
        speed=conditions.pitch.speed,
        launch_angle=math.radians(state.pitch_angle_deg),
        spray=math.pi,
        backspin=state.pitch_backspin_rpm * RPM,
        position=(0.0, FORWARD, state.height_ft * FOOT),
    )
    return _Meeting(free_bat, conditions, path, pitch, Contact(place, state.offset_in * INCH))


def _struck(state: FlightState, ball: Ball) -> dict[str, Any]:
    """Return the hit in space that the swing's controls describe, by the compiled collision."""
    free_bat, conditions, path, pitch, contact = _met(state, ball)
    place = float(np.asarray(contact.position))
    bat_speed = conditions.swing.speed_at(place)
    done = strikes(
        free_bat.held(conditions.hands),
        ball=ball,
        swings=Swings(bat_speed, path.axes, conditions.swing.pivot),
        pitches=pitch,
        contact=contact,
    )
    hit = bool(np.isfinite(done.velocity).all())
    picture, tilt = bat_picture(state, free_bat), state.tilt_deg
    plane = {"attack_angle_deg": (-tilt, tilt), "tilt_deg": (abs(state.attack_angle_deg), 90.0)}  # no path is steeper
    return {
        "motion": BallMotion(pitch.position, done.velocity[0], done.spin[0]) if hit else None,
        "bat": replace(picture, bounds={**picture.bounds, **plane}),
        "position_m": place,
        "bat_speed_m_s": bat_speed,
        "collision_efficiency": float(done.collision_efficiency[0]),
    }


def _swung(struck: dict[str, Any] | None) -> dict[str, Any]:
    """Return the swing's part of the answer, and its bat; nothing for a ball that starts with its own numbers."""
    if struck is None:
        return {"swing": None}
    swing = {name: value for name, value in struck.items() if name not in ("motion", "bat")}
    return {"swing": swing, "bat": struck["bat"]}


def _flown(motion: BallMotion, conditions: FlightConditions) -> Flights:
    """Return the flight in this air, and in none."""
    airs = replace(conditions, air=np.array([conditions.one_air.density, 0.0]))
    return flights(motion, airs, path_points=PATH_POINTS)


def _launch(motion: BallMotion) -> dict[str, float]:
    return {
        "exit_speed_m_s": motion.speed,
        "launch_angle_rad": motion.launch_angle,
        "spray_rad": motion.spray,
        "backspin_rad_s": motion.backspin,
        "sidespin_rad_s": motion.sidespin,
        "gyrospin_rad_s": motion.gyrospin,
    }


def _flight(flown: Flights, row: int) -> dict[str, float]:
    """Return a flight to the ground, as if there were no fence."""
    place, velocity = flown.landing_position[row], flown.landing_velocity[row]
    return {
        "carry_m": float(flown.carry[row]),
        "hang_time_s": float(flown.hang_time[row]),
        "apex_m": float(flown.apex_height[row]),
        "landing_speed_m_s": float(np.linalg.norm(velocity)),
        "landing_angle_rad": float(flown.landing_angle[row]),
        "landing_direction_rad": float(np.arctan2(place[0], place[1])),
    }


def _path(flown: Flights, row: int) -> dict[str, Any]:
    place = flown.positions[row, ::SHOWN]
    columns = {
        "time_s": flown.times[row, ::SHOWN],
        "right_m": place[:, 0],
        "out_m": place[:, 1],
        "up_m": place[:, 2],
        "distance_m": np.hypot(place[:, 0], place[:, 1]),
    }
    return {name: np.round(values, 4) for name, values in columns.items()}


VIEW = View(
    "flight", "Flight", FlightState, answer, flight_lines, asides={"map": carry_map, "fences": fences, "sure": sure}
)
