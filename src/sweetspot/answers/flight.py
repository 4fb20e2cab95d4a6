"""One flight through given air: how the ball leaves, how far and how long it flies, and where it was in between."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated, TypeVar

import numpy as np

from sweetspot.answers.answer import Answer, Uncertainty, uncertainty_of
from sweetspot.answers.flight_draws import drawn_flight
from sweetspot.answers.records import INTERNAL, Angle, Columns, Distance, Speed, Spin, Time, with_intervals
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import landing
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.intervals import reach_of_draws
from sweetspot.uncertainty.sources import DRAWS, Sources
from sweetspot.units.dimensions import DISTANCE, TIME

Flown = TypeVar("Flown", bound="FlightAnswer")


@dataclass(frozen=True, kw_only=True)
class BallLeaving:
    """How a ball leaves the bat.

    Parameters
    ----------
    launch_angle, spray : above the level, and from centre field, positive to right field.
    height : above the ground.
    """

    exit_speed: Speed
    launch_angle: Angle
    spray: Angle
    backspin: Spin
    sidespin: Spin
    gyrospin: Spin
    height: Distance


def ball_leaving(motion: BallMotion) -> BallLeaving:
    """Return how a ball leaves the bat."""
    return BallLeaving(
        exit_speed=motion.speed,
        launch_angle=motion.launch_angle,
        spray=motion.spray,
        backspin=motion.backspin,
        sidespin=motion.sidespin,
        gyrospin=motion.gyrospin,
        height=float(motion.position[2]),
    )


@dataclass(frozen=True)
class FlightPath:
    """Where the ball was at every step, shape (steps,): to the right of centre field, towards it, and up."""

    time: Annotated[Array, TIME]
    right: Annotated[Array, DISTANCE]
    out: Annotated[Array, DISTANCE]
    up: Annotated[Array, DISTANCE]


@dataclass(frozen=True, kw_only=True)
class FlightNumbers:
    """One flight; see `Flight`.

    Parameters
    ----------
    flight : it itself.
    outcome : how it ended, for programs.
    carry : over the ground from home plate.
    bearing : of the place where it comes down, from centre field, positive to right field.
    landing_angle : below the level.
    """

    flight: Annotated[Flight, INTERNAL]
    outcome: str
    carry: Distance
    bearing: Angle
    hang_time: Time
    apex: Distance
    apex_time: Time
    landing_speed: Speed
    landing_angle: Angle
    path: FlightPath


def flight_numbers(flight: Flight) -> FlightNumbers:
    """Return a flight as people ask for it."""
    return FlightNumbers(
        flight=flight,
        outcome=flight.outcome.name.lower(),
        carry=flight.carry,
        bearing=flight.bearing,
        hang_time=flight.hang_time,
        apex=flight.apex_height,
        apex_time=flight.apex_time,
        landing_speed=flight.landing.speed,
        landing_angle=flight.landing_angle,
        path=FlightPath(flight.times, *flight.positions.T),
    )


def carry_from_the_hit(flight: Flight) -> float:
    """Return m over the ground from where the ball was hit to where it lands, for sports without a home plate."""
    start, end = flight.launch.position, flight.landing.position
    return math.hypot(end[0] - start[0], end[1] - start[1])


@dataclass(frozen=True)
class FlightEnd:
    """Where a flight ends in a park; see `sweetspot.flight.fence.Landing`."""

    park: str
    outcome: str
    direction: Angle
    distance: Distance
    height: Distance
    clearance: Distance | None


def flight_end(flight: Flight, park: Park) -> FlightEnd:
    """Return the end of a flight in a park."""
    end = landing(flight.positions, park)
    return FlightEnd(park.name, end.outcome, end.direction, end.distance, end.height, end.clearance)


@dataclass(frozen=True)
class FlightQuestion:
    """One flight that is asked for.

    Parameters
    ----------
    motion : the ball as it leaves the bat.
    sources : what is not known, see `flight_sources`; None: no intervals are asked for.
    draws : how many answers the intervals come from, a power of two.
    """

    motion: BallMotion
    conditions: FlightConditions
    sources: Sources | None = None
    draws: int = DRAWS


@dataclass(frozen=True, kw_only=True)
class FlightAnswer(FlightNumbers, Answer):
    """One flight with how the ball left.

    Parameters
    ----------
    uncertainty : what the intervals come from; None: there are none.
    """

    launch: BallLeaving
    uncertainty: Uncertainty | None = None


def flight_answer(question: FlightQuestion) -> FlightAnswer:
    """Return one flight.

    Raises
    ------
    InputError
        for a start below the ground.
    """
    return flight_with_intervals(flight_of(fly(question.motion, question.conditions)), question)


def flight_of(flight: Flight) -> FlightAnswer:
    """Return a flight that was flown already as an answer, without intervals."""
    return FlightAnswer(launch=ball_leaving(flight.launch), **vars(flight_numbers(flight)))


def flight_with_intervals(plain: Flown, question: FlightQuestion) -> Flown:
    """Return an answer with intervals, where they are asked for."""
    sources = question.sources
    if sources is None:
        return plain
    drawn = drawn_flight(question.motion, question.conditions, sources, count=question.draws)
    sampled = uncertainty_of(
        np.asarray(drawn.flight["carry"]),
        of="carry",
        normal=drawn.normal,
        names=sources.names,
        sources=sources.described,
    )
    columns: Columns = {**drawn.flight, "launch": drawn.launch}
    return with_intervals(replace(plain, uncertainty=sampled), columns, reach_of_draws)
