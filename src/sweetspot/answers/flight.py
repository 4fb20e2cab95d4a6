"""One flight through given air: how the ball leaves, how far and how long it flies, and where it was in between."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, TypeVar

import numpy as np

from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.records import INTERNAL, Angle, Distance, Speed, Spin, Time
from sweetspot.catalog.aerodynamic_laws import drag_spread
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import landing
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import BallMotion, BallMotions, launch_angles
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.sources import DRAWS, Source, Sources
from sweetspot.units.dimensions import DISTANCE, TIME

Flown = TypeVar("Flown", bound="FlightAnswer")


@dataclass(frozen=True, kw_only=True)
class BallLeaving:
    """How a ball leaves the bat.

    ``launch_angle``, ``spray``: above the level, and from centre field, positive to right field. ``height``: above the
    ground.
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

    ``motion``: the ball as it leaves the bat. ``sources``: what is not known, see `flight_sources`; None: no intervals
    are asked for. ``draws``: how many answers the intervals come from, a power of two.
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
    return with_draws(plain, drawn, sources, of="carry")


DRAG, LAUNCH_SPEED, LAUNCH_ANGLE = "drag of the ball", "exit speed", "launch angle"
OTHER_BALLS = 0.03
"""One sigma of the drag's logarithm: months and seasons of balls differ by 0.01 of 0.33 [savant_2022rays]."""


def drag_source(law: Aerodynamics) -> Source:
    """Return a law's drag as a source, as a part of itself; never surer than balls of one kind are alike."""
    spread = float(np.hypot(drag_spread(law), OTHER_BALLS))
    return Source(DRAG, spread, "the catalogue's spread, and that of seasons of balls")


def written_errors(errors: Mapping[str, float]) -> tuple[Source, ...]:
    """Return values that were written with an error as sources, one standard deviation each, SI; 0: exact."""
    return tuple(Source(name, error, "as it was written") for name, error in errors.items() if error > 0)


def flight_sources(law: Aerodynamics, *, speed_error: float = 0.0, angle_error: float = 0.0) -> Sources:
    """Return the unknowns of a flight.

    ``law``: of drag, which balls of one kind do not share exactly. ``speed_error``, ``angle_error``: one standard
    deviation of exit speed and launch angle, m/s and rad; 0: exact.
    """
    written = written_errors({LAUNCH_SPEED: speed_error, LAUNCH_ANGLE: angle_error})
    return Sources(NO_DOUBT, (drag_source(law), *written))


def draws_of_sources(sources: Sources, count: int) -> tuple[Array, Array]:
    """Return standard normal numbers and deviations of every draw, shapes (count + 1, n); the first is none."""
    normal = np.vstack([np.zeros((1, len(sources.names))), sources.normal(count)])
    off = sources.deviations(normal)
    off[0] = 0.0
    return normal, off


def drawn_flight(left: BallMotion, flying: FlightConditions, sources: Sources, *, count: int) -> DrawnAnswer:
    """Return the sampled answers to one flight.

    ``left``: the ball as it leaves the bat. ``sources``: see `flight_sources`. ``count``: how many draws, a power of
    two.
    """
    normal, off = draws_of_sources(sources, count)
    speed = np.maximum(left.speed + sources.of(LAUNCH_SPEED, off), 0.0)
    angle = left.launch_angle + sources.of(LAUNCH_ANGLE, off)
    level = np.stack(
        [math.sin(left.spray) * np.cos(angle), math.cos(left.spray) * np.cos(angle), np.sin(angle)], axis=1
    )
    velocity = speed[:, None] * level
    balls = BallMotions(velocity=velocity, spin=np.asarray(left.spin), position=np.asarray(left.position))
    open_values = {LAUNCH_SPEED: ("exit_speed", speed), LAUNCH_ANGLE: ("launch_angle", angle)}
    launch = dict(column for name, column in open_values.items() if name in sources.names)
    return DrawnAnswer(normal, {**flight_columns(balls, flying, sources.of(DRAG, off)), "launch": launch})


def launch_columns(velocity: Array) -> dict[str, Array]:
    """Return speed and directions of balls that leave with these velocities, shape (n, 3)."""
    right, out, up = velocity.T
    return {
        "exit_speed": np.linalg.norm(velocity, axis=1),
        "launch_angle": np.arctan2(up, np.hypot(right, out)),
        "spray": np.arctan2(right, out),
    }


def spin_columns(velocity: Array, spin: Array) -> dict[str, Array]:
    """Return the parts of the spins of balls that leave with these velocities, shape (n, 3)."""
    _, _, (back, side, gyro) = launch_angles(velocity, np.broadcast_to(spin, velocity.shape))
    return {"backspin": back, "sidespin": side, "gyrospin": gyro}


def dragged(flying: FlightConditions, off: float) -> FlightConditions:
    """Return the same conditions with another drag, ``off`` the logarithm of it over the law's."""
    law = flying.aerodynamics
    return replace(flying, aerodynamics=law.replaced(drag=law.drag * float(np.exp(off))))


def flight_columns(left: BallMotions, flying: FlightConditions, drag: Array) -> dict[str, Array]:
    """Return flights, each with its own drag, by the fields of `FlightNumbers`.

    ``left``: balls as they leave, n of them. ``drag``: logarithm of each drag over the law's, shape (n,).
    """
    size = float(np.std(drag))
    flown = _flown(flights(left, flying))
    if size == 0:
        return flown
    up, down = (_flown(flights(left, dragged(flying, sign * size))) for sign in (1.0, -1.0))
    return {name: value + drag / size * (up[name] - down[name]) / 2 for name, value in flown.items()}


def _flown(flown: Flights) -> dict[str, Array]:
    return {
        "carry": flown.carry,
        "hang_time": flown.hang_time,
        "apex": flown.apex_height,
        "landing_speed": np.linalg.norm(flown.landing_velocity, axis=1),
        "landing_angle": flown.landing_angle,
    }
