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
from sweetspot.numerics.notebook_display import ShownInNotebooks


@dataclass(frozen=True)
class Play(ShownInNotebooks):
    """One pitch hit: the strike, and the flight where the ball left the bat."""

    strike: Strike
    flight: Flight | None


@dataclass(frozen=True)
class Plays(ShownInNotebooks):
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
    """Return the hit and the flight of a pitch struck at one place of the bat.

    ``pitch``: the ball where the bat meets it, in the field's frame; the flight starts there.

    Returns
    -------
    Play
        ``strike`` and ``flight``; no flight where bat and ball miss each other.

    >>> from math import radians
    >>> from sweetspot import BallMotion, Contact, SwingPath, catalog, standard_conditions, standard_flight
    >>> from sweetspot.analysis.full_play import play
    >>> from sweetspot.dynamics.reduction import reduced_bat
    >>> bat, flying = catalog.bat("r161-ash"), standard_flight()
    >>> pitch = BallMotion(position=(0, 0.5, 0.9), velocity=(0, -37.0, -3.0), spin=(-200.0, 0, 0))
    >>> done = play(reduced_bat(bat, ball=flying.ball), flying, swing=standard_conditions(bat).swing,
    ...             path=SwingPath(attack_angle=radians(9)), pitch=pitch, contact=Contact(bat.length - 0.15, 0.018))
    >>> round(done.flight.carry)  # m
    115
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

    >>> from math import radians
    >>> from sweetspot import BallMotion, Contact, Swings, catalog, plays, standard_flight
    >>> from sweetspot.dynamics.reduction import reduced_bat
    >>> from sweetspot.motion.swing_path import path_axes
    >>> bat, ball = catalog.bat("r161-ash"), catalog.ball()
    >>> swings = Swings([28.0, 31.0], path_axes(radians(9), 0.0, tilt=radians(35), left=False))
    >>> pitch = BallMotion(position=(0, 0.5, 0.9), velocity=(0, -37.0, -3.0), spin=(-200.0, 0, 0))
    >>> met = Contact([bat.length - 0.15] * 2, [0.018] * 2)
    >>> reduced, flying = reduced_bat(bat, ball=ball), standard_flight()
    >>> plays(reduced, flying, swings=swings, pitches=pitch, contact=met).flights.carry.round()  # m
    array([101., 110.])
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
