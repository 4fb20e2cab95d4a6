"""One play for bats, balls, speeds, drags and contacts that may be meant, by the fields of `PlayAnswer`.

Along the line of centres every draw has its own collision; what friction does to the ball there is that of the bat as
described, at the speeds of the draw.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sweetspot.answers.flight_draws import (
    DRAG,
    drag_source,
    flight_columns,
    launch_columns,
    spin_columns,
    written_errors,
)
from sweetspot.answers.play_question import PlayQuestion
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.oblique_contact import contact_frame
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.drawn_hits import draws_of
from sweetspot.uncertainty.sources import Sources

PLACE, OFFSET = "place along the bat", "bat under the ball"


@dataclass(frozen=True)
class DrawnPlay:
    """What draws answer to a play.

    Parameters
    ----------
    normal : standard normal numbers behind every draw, shape (draws, n).
    contact, flight : by the fields of `PlayAnswer` and `FlightNumbers`, shapes (draws,).
    """

    normal: Array
    contact: Mapping[str, Array]
    flight: Mapping[str, Array]


def play_sources(of_hit: Sources, law: Aerodynamics, *, place_error: float = 0.0, offset_error: float = 0.0) -> Sources:
    """Return the unknowns of a play.

    Parameters
    ----------
    of_hit : of bat, ball and speeds, see `sources_of`.
    law : of the ball's drag.
    place_error, offset_error : one standard deviation in m of where bat and ball meet; 0: exactly as given.
    """
    sources = of_hit.with_source(drag_source(law))
    for error in written_errors({PLACE: place_error, OFFSET: offset_error}):
        sources = sources.with_source(error)
    return sources


def drawn_play(asked: PlayQuestion, sources: Sources) -> DrawnPlay:
    """Return the sampled answers to a play.

    Parameters
    ----------
    sources : see `play_sources`.
    """
    reduced, conditions, pitch = asked.reduced, asked.hit_conditions, asked.pitch
    draws = draws_of(reduced.beam, conditions, sources, count=asked.draws)
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
    rebound = strikes(
        reduced,
        ball=conditions.ball,
        swings=Swings(speed, axes, swing.pivot),
        pitches=BallMotions(velocity=thrown, spin=np.asarray(pitch.spin), position=np.asarray(pitch.position)),
        contact=Contact(place, offset),
    )
    closing = np.nan_to_num(rebound.closing_speed, nan=1.0)[:, None]
    efficiency = draws.struck(place[:, None], closing).collision_efficiency[:, 0]
    reach = conditions.ball.radius + reduced.bat.diameter_at(place) / 2
    normal = contact_frame(*axes, lift=np.arcsin(np.clip(offset / reach, -1.0, 1.0))).normal
    more = (efficiency - rebound.collision_efficiency) * rebound.closing_speed
    velocity = rebound.velocity + more[:, None] * np.asarray(normal)
    left = BallMotions(velocity=velocity, spin=rebound.spin, position=np.asarray(pitch.position))
    contact = {
        "position": place,
        "offset": offset,
        "bat_speed": speed,
        "pitch_speed": draws.pitch_speed,
        "closing_speed": rebound.closing_speed,
        "collision_efficiency": efficiency,
        **launch_columns(velocity),
        **spin_columns(velocity, rebound.spin),
    }
    return DrawnPlay(draws.normal, contact, flight_columns(left, asked.flying, sources.of(DRAG, off)))
