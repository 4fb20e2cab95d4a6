"""Flight: where a batted ball goes in a chosen park and weather, and in how many parks it is out."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated, Literal, NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.answers.flight import BallLeaving, FlightPath, ball_leaving
from sweetspot.answers.records import Angle, Distance, Speed, Time
from sweetspot.catalog.aerodynamic_laws import aerodynamics_in
from sweetspot.catalog.sports import aerodynamics_of_ball
from sweetspot.equipment.ball import Ball
from sweetspot.flight.air import Air, Wind
from sweetspot.flight.bearing import launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import PATH_POINTS
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import BallMotion, batted_ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Number
from sweetspot.reports.page_words import (
    above_words,
    bat_speed_words,
    chance_words,
    leaving_words,
    margin_words,
    missed_words,
    outcome_words,
    parks_words,
    side_words,
)
from sweetspot.units import FOOT, INCH_OF_MERCURY, MPH, RPM
from sweetspot.units.dimensions import DENSITY, DISTANCE
from sweetspot.web.bats import ball_of, described, swung, usual
from sweetspot.web.documents import ReadDocument, Sentences, in_both_systems, page_document
from sweetspot.web.drawings import BatPicture
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import (
    Ask,
    ball_source,
    bat_source,
    bat_text,
    lines_of,
    options_of,
    place_option,
    swing_options,
)
from sweetspot.web.view import View
from sweetspot.web.views.flight_parks import (
    CarryMap,
    DrawnPark,
    FenceOutline,
    OutcomeInParks,
    carries,
    drawn_park,
    in_parks,
    outlines,
    parks_of,
)
from sweetspot.web.views.flight_state import FlightState
from sweetspot.web.views.flight_swing import FORWARD, SwungAt, met, space, struck

SHOWN = 2
"""Every how many points of a path are handed out."""


@dataclass(frozen=True, kw_only=True)
class ToTheGround:
    """A flight to the ground, as if there were no fence."""

    carry: Distance
    hang_time: Time
    apex: Distance
    landing_speed: Speed
    landing_angle: Angle
    landing_direction: Angle


@dataclass(frozen=True)
class DrawnPath(FlightPath):
    """The ball's path, and its distance over the ground from home plate."""

    distance: Annotated[Array, DISTANCE]


@dataclass(frozen=True, kw_only=True)
class MissedBall:
    """A swing that misses the ball, or from which it does not come off."""

    start: Literal["ball", "swing"]
    missed: Literal[True] = True
    swing: SwungAt | None
    bat: BatPicture | None = None
    park: DrawnPark
    usual_park: str
    headline: Sentences


@dataclass(frozen=True, kw_only=True)
class FlownBall(OutcomeInParks):
    """The path, its end at the fence of the chosen park, and the outcome in every park.

    Parameters
    ----------
    swing, bat : of a ball that is hit.
    headline, leaves : what becomes of it, and how it leaves, in sentences.
    margin : by how much it passes the fence's top, where it reaches that.
    side, above : what the pictures show.
    """

    start: Literal["ball", "swing"]
    missed: Literal[False] = False
    swing: SwungAt | None
    bat: BatPicture | None = None
    launch: BallLeaving
    flight: ToTheGround
    without_air: ToTheGround
    path: DrawnPath
    path_without_air: DrawnPath
    park: DrawnPark
    usual_park: str
    air_density: Annotated[Number, DENSITY]
    elevation: Distance
    headline: Sentences
    leaves: Sentences
    margin: Sentences
    side: Sentences
    above: Sentences


@dataclass(frozen=True)
class Fences:
    """The fences of every park."""

    parks: tuple[FenceOutline, ...]


def answer(state: FlightState) -> FlownBall | MissedBall:
    """Return the path, its end at the fence of the chosen park, and the outcome in every park."""
    start = _start(state)
    park, conditions, usual_park = start.park, start.conditions, usual(described(state)).park
    if start.motion is None:
        return MissedBall(
            start=state.start,
            swing=start.swing,
            bat=start.bat,
            park=drawn_park(park),
            usual_park=usual_park,
            headline=in_both_systems([missed_words()]),
        )
    flown = _flown(start.motion, conditions)
    own_elevation = state.own_elevation and state.elevation_ft is None  # a chosen elevation is that of every park
    outcome = in_parks(
        start.motion,
        flown.positions[0],
        parks_of(described(state)),
        conditions=conditions,
        here=park,
        own_elevation=own_elevation,
    )
    leaving, ground = ball_leaving(start.motion), _to_the_ground(flown, 0)
    apex, carry = float(ground.apex), float(ground.carry)
    words = [
        outcome_words(outcome.end, carry=carry, chance=float(outcome.chance)),
        *chance_words(float(outcome.chance)),
        parks_words(outcome.out_in, outcome.of),
    ]
    swung_at = [] if start.swing is None else [bat_speed_words(float(start.swing.bat_speed))]
    return FlownBall(
        **vars(outcome),
        start=state.start,
        swing=start.swing,
        bat=start.bat,
        launch=leaving,
        flight=ground,
        without_air=_to_the_ground(flown, 1),
        path=_path(flown, 0),
        path_without_air=_path(flown, 1),
        park=drawn_park(park),
        usual_park=usual_park,
        air_density=conditions.one_air.density,
        elevation=conditions.one_air.elevation,
        headline=in_both_systems(words),
        leaves=in_both_systems([leaving_words(leaving), *swung_at]),
        margin=in_both_systems(margin_words(outcome.end)),
        side=in_both_systems([side_words(outcome.end, apex=apex, carry=carry)]),
        above=in_both_systems([above_words(outcome.end)]),
    )


def carry_map(state: FlightState) -> CarryMap:
    """Return carries over exit speed and launch angle, for this ball's spin and direction in this park and weather."""
    start = _start(state)
    if start.motion is None:
        raise FieldError("offset_in", "the bat misses the ball; there is nothing to map")
    return carries(start.motion, conditions=start.conditions, park=start.park)


def sure(state: FlightState) -> ReadDocument:
    """Return the play, or the flight of a ball with its own numbers, with an interval beside each number."""
    from sweetspot.answers.flight import FlightQuestion, flight_answer, flight_sources
    from sweetspot.answers.play import PlayQuestion, play_answer, play_sources
    from sweetspot.reports.flight.document import flight_document
    from sweetspot.reports.play import play_document
    from sweetspot.web.how_sure import PAGE_DRAWS, sources_for

    start = _start(state)
    if start.motion is None:
        raise FieldError("offset_in", "the bat misses the ball; there is nothing to be sure of")
    flying = start.conditions
    if state.start == "ball":
        question = FlightQuestion(start.motion, flying, flight_sources(flying.aerodynamics), PAGE_DRAWS)
        return page_document(flight_document(flight_answer(question)))
    free_bat, conditions, path, pitch, contact = met(state, ball_of(state))
    sources = play_sources(sources_for(state, free_bat.bat, conditions), flying.aerodynamics)
    model = free_bat.held(conditions.hands)
    asked = PlayQuestion(model, conditions, flying, path, pitch, contact, sources=sources, draws=PAGE_DRAWS)
    return page_document(play_document(play_answer(asked)))


def fences(state: FlightState) -> Fences:
    """Return the fences of every park."""
    return Fences(outlines(parks_of(described(state))))


class _Start(NamedTuple):
    """The ball's launch, the conditions, and the place; the motion is None where the bat misses it."""

    park: Park
    conditions: FlightConditions
    motion: BallMotion | None
    swing: SwungAt | None = None
    bat: BatPicture | None = None


def _start(state: FlightState) -> _Start:
    with about("park"):
        park = catalog.park(swung(state).park or "")
    ball = ball_of(state)
    conditions = _conditions(state, park, ball)
    if state.start == "swing":
        return _Start(park, conditions, *struck(state, ball))
    return _Start(park, conditions, launched_by(state, conditions))


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
    return batted_ball(speed=speed, launch_angle=up, spray=spray, backspin=spins[0], sidespin=spins[1], position=place)


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
    law = aerodynamics_in(park, aerodynamics_of_ball(ball))
    return FlightConditions(ball=ball, aerodynamics=law, air=air, wind=wind)


def _flown(motion: BallMotion, conditions: FlightConditions) -> Flights:
    """Return the flight in this air, and in none."""
    airs = replace(conditions, air=np.array([conditions.one_air.density, 0.0]))
    return flights(motion, airs, path_points=PATH_POINTS)


def _to_the_ground(flown: Flights, row: int) -> ToTheGround:
    place, velocity = flown.landing_position[row], flown.landing_velocity[row]
    return ToTheGround(
        carry=float(flown.carry[row]),
        hang_time=float(flown.hang_time[row]),
        apex=float(flown.apex_height[row]),
        landing_speed=float(np.linalg.norm(velocity)),
        landing_angle=float(flown.landing_angle[row]),
        landing_direction=float(np.arctan2(place[0], place[1])),
    )


def _path(flown: Flights, row: int) -> DrawnPath:
    right, out, up = flown.positions[row, ::SHOWN].T
    columns = (flown.times[row, ::SHOWN], right, out, up, np.hypot(right, out))
    return DrawnPath(*(np.round(values, 4) for values in columns))


def recipe(state: FlightState) -> dict[str, str]:
    """Return command line and Python line, and the bat's file where a bat is swung."""
    air = options_of(state, "temperature_degf", "pressure_inhg", "elevation_ft", "wind_speed_mph")
    wind = options_of(state, "wind_direction_deg") if state.wind_speed_mph else {}
    weather = {"park": swung(state).park, **options_of(state, humidity="relative_humidity"), **air, **wind}
    at = {**options_of(state, "height_ft"), "forward": "2ft"}
    if state.start == "ball":
        direction = "bearing" if state.direction == "landing" else "spray"
        ball = options_of(
            state, "exit_speed_mph", "launch_angle_deg", "backspin_rpm", "sidespin_rpm", **{direction: "spray_deg"}
        )
        other = ball_source(swung(state))
        return lines_of(Ask("fly", options=ball | {"ball": None if other == "baseball" else other} | at | weather))
    path = options_of(state, "attack_angle_deg", "attack_direction_deg", "tilt_deg", bats="batter")
    pitch = options_of(state, "pitch_backspin_rpm", approach_angle="pitch_angle_deg")
    contact = place_option(state) | options_of(state, "offset_in") | path | pitch
    ask = Ask("play", (bat_source(state),), contact | at | swing_options(state) | weather)
    return {**lines_of(ask), "toml": bat_text(state)}


VIEW = View(
    "flight",
    "Flight",
    FlightState,
    answer,
    recipe,
    asides={"map": carry_map, "fences": fences, "space": space, "sure": sure},
)
