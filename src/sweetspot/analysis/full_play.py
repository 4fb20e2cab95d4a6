"""From the pitch to the ground in one call: bat and ball meet in space, then the ball flies."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.collision.hit_in_space import Contact, Strike, Strikes, strike, strikes
from sweetspot.collision.oblique_contact import USUAL_FRICTION, Friction
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath, Swings


@dataclass(frozen=True)
class Play:
    """One pitch hit: the strike, and the flight where the ball left the bat."""

    strike: Strike
    flight: Flight | None


@dataclass(frozen=True)
class Plays:
    """Many pitches hit; rows without a meaning are nan (see the outcomes of `strikes` and `flights`)."""

    strikes: Strikes
    flights: Flights


def play(
    reduced: ReducedBat[Bat],
    conditions: FlightConditions,
    *,
    swing: Swing,
    path: SwingPath,
    pitch: BallMotion,
    contact: Contact,
    friction: Friction = USUAL_FRICTION,
) -> Play:
    """Return where a pitch goes that is met at one place of the bat.

    Parameters
    ----------
    reduced : the bat, from `sweetspot.dynamics.reduction.reduced_bat`.
    conditions : ball, drag law, air and wind.
    swing, path : how fast the bat moves, and where to.
    pitch : the ball where the bat meets it, in the field's frame; the flight starts there.
    contact : where they meet.
    """
    struck = strike(
        reduced, ball=conditions.ball, swing=swing, path=path, pitch=pitch, contact=contact, friction=friction
    )
    if struck.launched is None:
        return Play(struck, None)
    return Play(struck, fly(struck.launched, conditions))


def plays(
    reduced: ReducedBat[Bat],
    conditions: FlightConditions,
    *,
    swings: Swings,
    pitches: BallMotion | BallMotions,
    contact: Contact,
    friction: Friction = USUAL_FRICTION,
    threads: int | None = None,
) -> Plays:
    """Return many plays with one bat, by the compiled kernels of collision and flight.

    Parameters
    ----------
    conditions : ball, drag law, air and wind.
    swings, contact : as in `sweetspot.collision.hit_in_space.strikes`.
    pitches : the balls where they are met, in the field's frame; the flights start there.
    threads : workers; None: one per core, and one only for small batches.
    """
    struck = strikes(
        reduced,
        ball=conditions.ball,
        swings=swings,
        pitches=pitches,
        contact=contact,
        friction=friction,
        threads=threads,
    )
    left = BallMotions(velocity=struck.velocity, spin=struck.spin, position=pitches.position)
    return Plays(struck, flights(left, conditions, threads=threads))
