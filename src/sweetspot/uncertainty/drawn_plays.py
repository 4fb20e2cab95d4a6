"""One play or one flight, for bats, balls and speeds that may be meant.

Along the line of centres every draw has its own collision; what friction does to the ball there is that of the bat as
described, at the speeds of the draw. Drag moves all that a flight is asked for as much as it does one standard
deviation up and down.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.oblique_contact import contact_frame
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.motion.ball_motion import BallMotion, BallMotions, launch_angles
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.drawn_hits import draws_of
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.intervals import DrawnAnswers
from sweetspot.uncertainty.sources import DRAWS, Source, Sources

DRAG, LAUNCH_SPEED, LAUNCH_ANGLE = "drag of the ball", "exit speed", "launch angle"
PLACE, OFFSET = "place along the bat", "bat under the ball"
OTHER_BALLS = 0.03
"""One sigma of the drag's logarithm: months and seasons of balls differ by 0.01 of 0.33 [savant_2022rays]."""


def drag_source(spread: float) -> Source:
    """Return the drag as a source, as a part of itself; never surer than balls of one kind are alike.

    Parameters
    ----------
    spread : that the catalogue knows the mean to, as a part of it.
    """
    return Source(DRAG, float(np.hypot(spread, OTHER_BALLS)), "the catalogue's spread, and that of seasons of balls")


def meeting_sources(place: float, offset: float) -> tuple[Source, ...]:
    """Return where bat and ball meet as sources, one standard deviation in m of each; 0: exactly as given."""
    written = "as it was written"
    return tuple(Source(name, error, written) for name, error in ((PLACE, place), (OFFSET, offset)) if error > 0)


@dataclass(frozen=True)
class PlayAsked:
    """A play as it is described; see `sweetspot.analysis.full_play.play`."""

    reduced: ReducedBat[Bat]
    conditions: Conditions
    flying: FlightConditions
    path: SwingPath
    pitch: BallMotion
    contact: Contact


def drawn_play(asked: PlayAsked, sources: Sources, *, count: int = DRAWS) -> DrawnAnswers:
    """Return the answers of draws to a play, by their names in its data.

    Parameters
    ----------
    sources : of the hit, `drag_source` and `meeting_sources`.
    """
    reduced, conditions, pitch = asked.reduced, asked.conditions, asked.pitch
    draws = draws_of(reduced.line, conditions, sources, count=count)
    off = sources.deviations(draws.normal)
    off[0] = 0.0
    place, offset = (
        float(np.asarray(value)) + sources.of(name, off)
        for value, name in zip(asked.contact, (PLACE, OFFSET), strict=True)
    )
    place = np.clip(place, conditions.hands.position, reduced.bat.length)
    faster = draws.pitch_speed / draws.pitch_speed[0] if draws.pitch_speed[0] > 0 else np.ones(len(draws))
    swing, thrown = conditions.swing, faster[:, None] * np.asarray(pitch.velocity)
    speed = draws.bat_speed * (place - swing.pivot) / (swing.measured_at - swing.pivot)
    axes = asked.path.axes
    met = strikes(
        reduced, ball=conditions.ball, swings=Swings(speed, axes, swing.pivot),
        pitches=BallMotions(velocity=thrown, spin=np.asarray(pitch.spin), position=np.asarray(pitch.position)),
        contact=Contact(place, offset),
    )  # fmt: skip
    closing = np.nan_to_num(met.closing_speed, nan=1.0)[:, None]
    own = draws.struck(place[:, None], closing).collision_efficiency[:, 0]
    reach = conditions.ball.radius + reduced.bat.diameter_at(place) / 2
    normal = contact_frame(*axes, lift=np.arcsin(np.clip(offset / reach, -1.0, 1.0))).normal
    more = (own - met.collision_efficiency) * met.closing_speed
    velocity = met.velocity + more[:, None] * np.asarray(normal)
    left = BallMotions(velocity=velocity, spin=met.spin, position=np.asarray(pitch.position))
    values = {
        "position_m": place, "offset_m": offset,
        "bat_speed_m_s": speed, "pitch_speed_m_s": draws.pitch_speed, "closing_speed_m_s": met.closing_speed,
        "collision_efficiency": own, **launch_values(velocity), **_spins(velocity, met.spin),
        **{f"flight.{name}": value for name, value in drawn_flights(left, asked.flying, sources.of(DRAG, off)).items()},
    }  # fmt: skip
    return DrawnAnswers(draws.normal, sources.names, values)


def drawn_flight(
    left: BallMotion,
    flying: FlightConditions,
    *,
    spread: float,
    speed_error: float,
    angle_error: float,
    count: int = DRAWS,
) -> tuple[DrawnAnswers, Sources]:
    """Return the answers of draws to one flight, by their names in its data, and what was drawn.

    Parameters
    ----------
    left : the ball as it leaves the bat.
    spread : that the catalogue knows the mean drag to, as a part of it; see `drag_source`.
    speed_error, angle_error : one standard deviation of its speed and its launch angle, m/s and rad; 0: exact.
    """  # fmt: skip
    given = [(LAUNCH_SPEED, speed_error), (LAUNCH_ANGLE, angle_error)]
    written = tuple(Source(name, error, "as it was written") for name, error in given if error > 0)
    sources = Sources(NO_DOUBT, (drag_source(spread), *written))
    normal = np.vstack([np.zeros((1, len(sources.names))), sources.normal(count)])
    off = sources.deviations(normal)
    speed = np.maximum(left.speed + sources.of(LAUNCH_SPEED, off), 0.0)
    angle = left.launch_angle + sources.of(LAUNCH_ANGLE, off)
    level = np.stack(
        [math.sin(left.spray) * np.cos(angle), math.cos(left.spray) * np.cos(angle), np.sin(angle)], axis=1
    )
    velocity = speed[:, None] * level
    balls = BallMotions(velocity=velocity, spin=np.asarray(left.spin), position=np.asarray(left.position))
    values = {**launch_values(velocity), **drawn_flights(balls, flying, sources.of(DRAG, off))}
    return DrawnAnswers(normal, sources.names, values), sources


def _spins(velocity: Array, spin: Array) -> dict[str, Array]:
    _, _, (back, side, gyro) = launch_angles(velocity, np.broadcast_to(spin, velocity.shape))
    return {"backspin_rad_s": back, "sidespin_rad_s": side, "gyrospin_rad_s": gyro}


def launch_values(velocity: Array) -> dict[str, Array]:
    """Return speed and directions of balls that leave with these velocities, shape (n, 3)."""
    right, out, up = velocity.T
    return {
        "exit_speed_m_s": np.linalg.norm(velocity, axis=1), "launch_angle_rad": np.arctan2(up, np.hypot(right, out)),
        "spray_rad": np.arctan2(right, out),
    }  # fmt: skip


def dragged(flying: FlightConditions, off: float) -> FlightConditions:
    """Return the same conditions with another drag, ``off`` the logarithm of it over the law's."""
    law = flying.aerodynamics
    return replace(flying, aerodynamics=law.replaced(drag=law.drag * float(np.exp(off))))


def drawn_flights(left: BallMotions, flying: FlightConditions, drag: Array) -> dict[str, Array]:
    """Return what flights are asked for, each with its own drag.

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


def _flown(flights: Flights) -> dict[str, Array]:
    speed = np.linalg.norm(flights.landing_velocity, axis=1)
    steep = np.arctan2(-flights.landing_velocity[:, 2], np.hypot(*flights.landing_velocity[:, :2].T))
    return {
        "carry_m": flights.carry, "hang_time_s": flights.hang_time, "apex_m": flights.apex_height,
        "landing_speed_m_s": speed, "landing_angle_rad": steep,
    }  # fmt: skip
