"""From the pitch to the ground in one call: bat and ball meet in space, then the ball flies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.collision.hit_in_space import Strike, Strikes, strike, strikes
from sweetspot.collision.oblique_contact import FRICTION, TANGENTIAL_RESTITUTION
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import CALM, Air, Wind
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import PathAxes, SwingPath
from sweetspot.numerics.arrays import Array


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
    *,
    ball: Ball,
    swing: Swing,
    path: SwingPath,
    pitch: BallMotion,
    position: float,
    offset: float = 0.0,
    aerodynamics: Aerodynamics,
    air: Air,
    wind: Wind = CALM,
    friction: float = FRICTION,
    tangential_restitution: float = TANGENTIAL_RESTITUTION,
) -> Play:
    """Return where a pitch goes that is met at one place of the bat.

    Parameters
    ----------
    reduced : the bat, from `sweetspot.dynamics.reduction.reduced_bat`.
    swing, path : how fast the bat moves, and where to.
    pitch : the ball where the bat meets it, in the field's frame; the flight starts there.
    position, offset : m from the knob end, and m by which the ball's centre lies above the bat's axis.
    """
    struck = strike(
        reduced,
        ball=ball,
        swing=swing,
        path=path,
        pitch=pitch,
        position=position,
        offset=offset,
        friction=friction,
        tangential_restitution=tangential_restitution,
    )
    if struck.launched is None:
        return Play(struck, None)
    return Play(struck, fly(struck.launched, ball=ball, aerodynamics=aerodynamics, air=air, wind=wind))


def plays(
    reduced: ReducedBat[Bat],
    *,
    ball: Ball,
    bat_speed: ArrayLike,
    axes: PathAxes,
    pitch_velocity: ArrayLike,
    pitch_spin: ArrayLike,
    position: ArrayLike,
    offset: ArrayLike = 0.0,
    pivot: float = 0.0,
    start: ArrayLike = (0.0, 0.6, 0.9),
    aerodynamics: Aerodynamics,
    air: Air,
    wind: Wind = CALM,
    friction: float = FRICTION,
    tangential_restitution: float = TANGENTIAL_RESTITUTION,
    threads: int | None = None,
) -> Plays:
    """Return many plays with one bat, by the compiled kernels of collision and flight.

    Parameters
    ----------
    bat_speed : m/s at the point of impact, shape (n,).
    axes, pitch_velocity, pitch_spin, position, offset, pivot : as in `sweetspot.collision.hit_in_space.strikes`.
    start : m, where the balls are met, in the field's frame; 2 ft in front of the plate's tip and 3 ft up.
    threads : workers; None: one per core, and one only for small batches.
    """
    struck = strikes(
        reduced,
        ball=ball,
        bat_speed=bat_speed,
        axes=axes,
        pitch_velocity=pitch_velocity,
        pitch_spin=pitch_spin,
        position=position,
        offset=offset,
        pivot=pivot,
        friction=friction,
        tangential_restitution=tangential_restitution,
        threads=threads,
    )
    begin: Array = np.asarray(start, float)
    flown = flights(
        begin, struck.velocity, struck.spin, ball=ball, aerodynamics=aerodynamics, air=air, wind=wind, threads=threads
    )
    return Plays(struck, flown)
