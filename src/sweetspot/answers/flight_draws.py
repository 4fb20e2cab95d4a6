"""Flights for drags, exit speeds and launch angles that may be meant, by the fields of `FlightNumbers`.

Drag moves all that a flight is asked for as much as it does one standard deviation up and down.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.catalog.aerodynamic_laws import drag_spread
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.motion.ball_motion import BallMotion, BallMotions, launch_angles
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.sources import Source, Sources

DRAG, LAUNCH_SPEED, LAUNCH_ANGLE = "drag of the ball", "exit speed", "launch angle"
OTHER_BALLS = 0.03
"""One sigma of the drag's logarithm: months and seasons of balls differ by 0.01 of 0.33 [savant_2022rays]."""


@dataclass(frozen=True)
class DrawnFlight:
    """What draws answer to a flight.

    Parameters
    ----------
    normal : standard normal numbers behind every draw, shape (draws, n).
    launch, flight : by the fields of `BallLeaving`, of those that are open, and of `FlightNumbers`, shapes (draws,).
    """

    normal: Array
    launch: Mapping[str, Array]
    flight: Mapping[str, Array]


def drag_source(law: Aerodynamics) -> Source:
    """Return a law's drag as a source, as a part of itself; never surer than balls of one kind are alike."""
    spread = float(np.hypot(drag_spread(law), OTHER_BALLS))
    return Source(DRAG, spread, "the catalogue's spread, and that of seasons of balls")


def written_errors(errors: Mapping[str, float]) -> tuple[Source, ...]:
    """Return values that were written with an error as sources, one standard deviation each, SI; 0: exact."""
    return tuple(Source(name, error, "as it was written") for name, error in errors.items() if error > 0)


def flight_sources(law: Aerodynamics, *, speed_error: float = 0.0, angle_error: float = 0.0) -> Sources:
    """Return the unknowns of a flight.

    Parameters
    ----------
    law : of drag, which balls of one kind do not share exactly.
    speed_error, angle_error : one standard deviation of exit speed and launch angle, m/s and rad; 0: exact.
    """
    written = written_errors({LAUNCH_SPEED: speed_error, LAUNCH_ANGLE: angle_error})
    return Sources(NO_DOUBT, (drag_source(law), *written))


def draws_of_sources(sources: Sources, count: int) -> tuple[Array, Array]:
    """Return standard normal numbers and deviations of every draw, shapes (count + 1, n); the first is none."""
    normal = np.vstack([np.zeros((1, len(sources.names))), sources.normal(count)])
    off = sources.deviations(normal)
    off[0] = 0.0
    return normal, off


def drawn_flight(left: BallMotion, flying: FlightConditions, sources: Sources, *, count: int) -> DrawnFlight:
    """Return the sampled answers to one flight.

    Parameters
    ----------
    left : the ball as it leaves the bat.
    sources : see `flight_sources`.
    count : how many draws, a power of two.
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
    return DrawnFlight(normal, launch, flight_columns(balls, flying, sources.of(DRAG, off)))


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

    Parameters
    ----------
    left : balls as they leave, n of them.
    drag : logarithm of each drag over the law's, shape (n,).
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
