"""Flight: where a batted ball goes in a chosen park and weather, and in how many parks it is out."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.equipment.ball import Ball
from sweetspot.flight.air import Air, Wind
from sweetspot.flight.all_parks import PATH_POINTS, landings_everywhere
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import landing
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.motion.ball_motion import BallMotion, launched
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.units import FOOT, INCH, INCH_OF_MERCURY, MPH, RPM
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.drawings import bat_picture
from sweetspot.web.errors import FieldError, about
from sweetspot.web.view import View
from sweetspot.web.views.flight_recipe import flight_lines
from sweetspot.web.views.flight_state import FlightState

"""Pa."""
FORWARD = 2 * FOOT
"""m in front of the plate's tip where ball and bat meet."""
SHOWN = 2
"""Every how many points of a path are handed out."""
FENCE_POINTS = 91


@dataclass(frozen=True)
class Weather:
    """What the ball flies through: the air at the chosen field, and the wind."""

    air: Air
    wind: Wind


def answer(state: FlightState) -> dict[str, Any]:
    """Return the path, its end at the fence of the chosen park, and the outcome in every park."""
    with about("park"):
        park = catalog.park(state.park)
    weather, ball = _weather(state, park), ball_of(state)
    struck = _struck(state, ball) if state.start == "swing" else None
    ball_motion = launched_by(state) if struck is None else struck["motion"]
    if ball_motion is None:
        return {"start": state.start, "missed": True, **_swung(struck), "park": _park(park), "parks": []}
    flown = _flown(ball_motion, ball=ball, weather=weather)
    end = landing(flown.positions[0], park)
    return {
        "start": state.start,
        "missed": False,
        **_swung(struck),
        "launch": _launch(ball_motion),
        "flight": _flight(flown, 0),
        "without_air": _flight(flown, 1),
        "path": _path(flown, 0),
        "path_without_air": _path(flown, 1),
        "park": _park(park),
        "end": {
            "outcome": end.outcome,
            "direction_rad": end.direction,
            "distance_m": end.distance,
            "height_m": end.height,
            "clearance_m": end.clearance,
        },
        **_parks(ball_motion, ball=ball, weather=weather, own_elevation=_own_elevation(state)),
        "air_density_kg_m3": weather.air.density,
        "elevation_m": weather.air.elevation,
    }


def _own_elevation(state: FlightState) -> bool:
    """Say whether each park counts with its own air; an elevation that was chosen is that of every park."""
    return state.own_elevation and state.elevation_ft is None


def launched_by(state: FlightState) -> BallMotion:
    """Return the ball as the controls say that it leaves the bat."""
    return launched(
        speed=state.exit_speed_mph * MPH,
        launch_angle=math.radians(state.launch_angle_deg),
        spray=math.radians(state.spray_deg),
        backspin=state.backspin_rpm * RPM,
        sidespin=state.sidespin_rpm * RPM,
        position=(0.0, FORWARD, state.height_ft * FOOT),
    )


def _weather(state: FlightState, park: Park) -> Weather:
    elevation = park.elevation if state.elevation_ft is None else state.elevation_ft * FOOT
    with about("pressure_inhg"):
        return Weather(
            Air(
                temperature=(state.temperature_degf - 32) / 1.8,
                pressure=state.pressure_inhg * INCH_OF_MERCURY,
                humidity=state.relative_humidity,
                elevation=elevation,
            ),
            Wind(speed=state.wind_speed_mph * MPH, direction=math.radians(state.wind_direction_deg)),
        )


def _struck(state: FlightState, ball: Ball) -> dict[str, Any]:
    """Return the hit in space that the swing's controls describe, by the compiled collision."""
    found = reduced(state, ball)
    bat, conditions = found.bat, conditions_of(state, found.bat)
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
    model = found.held(conditions.hands)
    bat_speed = conditions.swing.speed_at(place)
    done = strikes(
        model,
        ball=ball,
        swings=Swings(bat_speed, path.axes, conditions.swing.pivot),
        pitches=pitch,
        contact=Contact(place, state.offset_in * INCH),
    )
    hit = bool(np.isfinite(done.velocity).all())
    return {
        "motion": BallMotion(pitch.position, done.velocity[0], done.spin[0]) if hit else None,
        "bat": bat_picture(state, found),
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


def _flown(motion: BallMotion, *, ball: Ball, weather: Weather) -> Flights:
    """Return the flight in this air, and in none."""
    return flights(
        motion,
        FlightConditions(
            ball=ball, aerodynamics=aerodynamics(), air=np.array([weather.air.density, 0.0]), wind=weather.wind
        ),
        path_points=PATH_POINTS,
    )


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
    return {
        "time_s": flown.times[row, ::SHOWN],
        "right_m": place[:, 0],
        "out_m": place[:, 1],
        "up_m": place[:, 2],
        "distance_m": np.hypot(place[:, 0], place[:, 1]),
    }


def _park(park: Park) -> dict[str, Any]:
    directions = np.linspace(-FOUL_LINE, FOUL_LINE, FENCE_POINTS)
    distance, height = fence_at(park, directions)
    return {
        "name": park.name,
        "team": park.team,
        "city": park.city,
        "roof": park.roof,
        "elevation_m": park.elevation,
        "direction_rad": directions,
        "right_m": distance * np.sin(directions),
        "out_m": distance * np.cos(directions),
        "distance_m": distance,
        "height_m": height,
    }


def _parks(motion: BallMotion, *, ball: Ball, weather: Weather, own_elevation: bool) -> dict[str, Any]:
    """Return the outcome in every park, and in how many the ball is out."""
    parks = catalog.parks()
    ends = landings_everywhere(
        motion,
        FlightConditions(ball=ball, aerodynamics=aerodynamics(), air=weather.air, wind=weather.wind),
        parks=parks,
        own_elevation=own_elevation,
    )
    rows = [
        {
            "park": park.name,
            "team": park.team,
            "outcome": str(end.outcome.flat[0]),
            "clearance_m": float(end.clearance.flat[0]),
            "distance_m": float(end.distance.flat[0]),
        }
        for park, end in zip(parks, ends, strict=True)
    ]
    return {"parks": rows, "out_in": sum(row["outcome"] == "home run" for row in rows), "of": len(rows)}


VIEW = View("flight", "Flight", FlightState, answer, flight_lines)
