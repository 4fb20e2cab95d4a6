"""The best way to hit: how to swing for carry, how high to send the ball, and the easiest way out of a park.

Carry is a smooth function of the swing: searched on a coarse grid, then climbed to the top by Nelder and Mead.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import ArrayLike

from sweetspot.analysis.full_play import Plays, plays
from sweetspot.collision.hit_in_space import Contact
from sweetspot.collision.oblique_contact import USUAL_FRICTION, Friction, contact_frame
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import Park, fence_at
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, BallMotions, batted_ball
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPlane, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.units import DEGREE, INCH, MPH

LAUNCH_ANGLES = (5 * DEGREE, 60 * DEGREE)
SPEEDS = np.arange(60.0, 131.0, 2.0) * MPH
ANGLES = np.arange(16.0, 56.1, 1.0) * DEGREE
DIRECTIONS = np.arange(-45.0, 45.1, 0.5) * DEGREE
"""The flights and directions that a park is searched with."""
PATH_POINTS = 161
ROUGHLY, AROUND = 15, np.arange(-2.0, 2.1, 1.0) * DEGREE
"""Angles that the best one is looked for among, and those about it through whose carries a polynomial goes: its top is
within 1e-7 of the carry."""
REFINED = 3 * DEGREE
"""Half width of the last search."""


@dataclass(frozen=True)
class BestLaunch:
    """The launch angle that carries an exit speed farthest: rad, and the carry in m."""

    launch_angle: float
    carry: float


def best_launch(
    exit_speed: float, conditions: FlightConditions, *, backspin: float, sidespin: float = 0.0, spray: float = 0.0
) -> BestLaunch:
    """Return the launch angle that carries farthest at one exit speed and spin, with the carry.

    ``exit_speed``: m/s, > 0. ``backspin``, ``sidespin``: rad/s, the same at every angle. ``spray``: rad from centre
    field, positive to right field.

    >>> from sweetspot import catalog
    >>> from sweetspot.flight.air import Air
    >>> usual = FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(), air=Air())
    >>> best = best_launch(44.704, usual, backspin=230.0)
    >>> 29.5 < math.degrees(best.launch_angle) < 30.5  # 100 mph, 2200 rpm
    True
    """

    def carries(angles: Array) -> Array:
        balls_left = batted_ball(
            speed=exit_speed,
            launch_angle=angles,
            spray=spray,
            backspin=backspin,
            sidespin=sidespin,
            position=USUAL_CONTACT,
        )
        return flights(balls_left, conditions).carry

    if not (math.isfinite(exit_speed) and exit_speed > 0):
        raise InputError(f"exit_speed is {exit_speed:g} m/s; allowed is a number above zero")
    lowest, highest = LAUNCH_ANGLES
    rough = np.linspace(lowest, highest, ROUGHLY)
    index, shift, _ = top(carries(rough))
    about = float(rough[index] + shift * (rough[1] - rough[0]))
    near = min(max(about, lowest + AROUND[-1]), highest - AROUND[-1]) + AROUND
    curve = Polynomial.fit(near, carries(near), len(near) - 1)
    turns = [float(at.real) for at in curve.deriv().roots() if at.imag == 0 and near[0] < at.real < near[-1]]
    carry, angle = max((float(curve(at)), at) for at in (float(near[0]), *turns, float(near[-1])))
    return BestLaunch(angle, carry)


@dataclass(frozen=True)
class EasiestHomeRun:
    """The slowest ball that leaves a park.

    ``exit_speed``, ``launch_angle``: m/s and rad, the best angle for it. ``direction``: rad from centre field, where
    the fence asks least. ``distance``, ``height``: m, of the fence there.
    """

    park: Park
    exit_speed: float
    launch_angle: float
    direction: float
    distance: float
    height: float


def easiest_home_run(
    park: Park, conditions: FlightConditions, *, backspin: float, directions: ArrayLike = DIRECTIONS
) -> EasiestHomeRun:
    """Return the slowest ball that clears a park's fence, where it does so, and at which launch angle.

    Without wind and side spin a path is the same in every direction, so one family of flights (speeds by launch
    angles) shows where the fence asks least; there the least speed is a minimum over the launch angle of the root
    at which the ball just clears the top.

    ``backspin``: rad/s. ``directions``: rad from centre field, that may be hit to.
    """
    from scipy.optimize import brentq, minimize_scalar

    if conditions.one_wind.speed:
        raise InputError("the easiest home run is searched without wind; leave the wind out")

    def over(speed: Array, angle: Array, far: Array) -> Array:
        return _heights(speed, angle, far, backspin=backspin, conditions=conditions)

    wanted = np.atleast_1d(np.asarray(directions, float))
    distance, height = fence_at(park, wanted)
    needed = _least_speeds(over, distance, height)
    best = np.unravel_index(np.argmin(needed), needed.shape)
    rough, near, at = float(needed[best]), float(ANGLES[best[0]]), int(best[1])
    if not math.isfinite(rough):
        raise InputError(f"no ball slower than {SPEEDS[-1] / MPH:.0f} mph clears the fence of {park.name} there")

    def least(angle: float) -> float:
        def clearance(speed: float) -> float:
            return float(over(np.array([speed]), np.array([angle]), distance[at : at + 1])[0, 0] - height[at])

        return float(brentq(clearance, 0.9 * rough, 1.2 * rough, xtol=1e-6))

    minimum = minimize_scalar(least, bounds=(near - REFINED, near + REFINED), method="bounded", options={"xatol": 1e-4})
    return EasiestHomeRun(
        park, float(minimum.fun), float(minimum.x), float(wanted[at]), float(distance[at]), float(height[at])
    )


def _least_speeds(over: Callable[[Array, Array, Array], Array], distance: Array, height: Array) -> Array:
    """Return the speed that just clears each fence, by straight lines between `SPEEDS`, shape (angles, fences)."""
    speed, angle = (axis.ravel() for axis in np.meshgrid(SPEEDS, ANGLES, indexing="ij"))
    above = (over(speed, angle, distance) - height).reshape(len(SPEEDS), len(ANGLES), len(distance))
    first = (above > 0).argmax(axis=0)
    low, high = (np.take_along_axis(above, at[None], axis=0)[0] for at in (np.maximum(first - 1, 0), first))
    share = np.divide(-low, high - low, out=np.zeros(low.shape), where=first > 0)
    return np.where(first > 0, SPEEDS[first - 1] + share * (SPEEDS[1] - SPEEDS[0]), np.inf)


def _heights(speed: Array, angle: Array, distance: Array, *, backspin: float, conditions: FlightConditions) -> Array:
    """Return the heights of flights at some distances, shape (flights, distances); negative where they fell short."""
    nothing = np.zeros_like(speed)
    leaving = np.stack([nothing, speed * np.cos(angle), speed * np.sin(angle)], axis=-1)
    motions = BallMotions(velocity=leaving, spin=[backspin, 0.0, 0.0], position=USUAL_CONTACT)
    flown = flights(motions, conditions, path_points=PATH_POINTS)
    out, up = flown.positions[..., 1], flown.positions[..., 2]
    reached = np.array([np.interp(distance, way, rise) for way, rise in zip(out, up, strict=True)])
    fall = (up[:, -1] - up[:, -2]) / (out[:, -1] - out[:, -2])
    return reached + fall[:, None] * np.maximum(distance - out[:, -1:], 0.0)


Tried = Callable[[Array, Array, Array], Plays]

ATTACK_ANGLES = np.arange(-10.0, 41.0, 5.0) * DEGREE
OFFSETS = np.arange(0.0, 0.051, 0.005)
FROM_TIP = np.array([4.0, 5.0, 6.0, 7.0, 8.0]) * INCH
"""The coarse grid: rad, m by which the ball's centre lies above the bat's axis, and m from the tip."""
STEEPEST, DEEPEST = (-20 * DEGREE, 60 * DEGREE), (-0.03, 0.065)
NEAREST, FARTHEST = 1 * INCH, 12 * INCH
"""Limits of the climb: attack angle, offset, and m from the tip."""
UNITS = np.array([DEGREE, 1e-3, INCH])
"""Sizes of a small step in attack angle, offset and place."""
SHARP, MOST_STEPS = 1e-3, 400
"""When the climb ends: steps in `UNITS` and mm of carry below a thousandth, or as many steps."""


class Held(NamedTuple):
    """Variables that are given instead of searched.

    ``position``: m from the knob end; None: the best place too is searched, 1 to 12 in from the tip. ``attack_angle``:
    rad; None: searched, -20 to 60 deg.
    """

    position: float | None = None
    attack_angle: float | None = None


NOTHING_HELD, LEVEL = Held(), SwingPlane()


@dataclass(frozen=True)
class BestSwing:
    """The contact that carries farthest.

    Parameters
    ----------
    attack_angle : rad, of the barrel's path above the level.
    offset : m by which the ball's centre lies above the bat's axis, square to the barrel's path.
    undercut : m by which it lies above the bat's axis straight up, whatever the path.
    position : m from the knob end.
    carry, hang_time : m and s.
    """

    attack_angle: float
    offset: float
    undercut: float
    position: float
    carry: float
    hang_time: float
    launched: BallMotion


def best_swing(
    model: ReducedBat[Bat],
    conditions: FlightConditions,
    *,
    swing: Swing,
    pitch: BallMotion,
    plane: SwingPlane = LEVEL,
    held: Held = NOTHING_HELD,
    friction: Friction = USUAL_FRICTION,
) -> BestSwing:
    """Return the offset, attack angle and place on the barrel that send a pitch farthest [sawicki2003].

    The bat turns as fast at every angle: swinging up costs no speed.

    ``pitch``: the ball where the bat meets it, in the field's frame. ``plane``: what fixes the bat's path but for its
    attack angle.
    """
    if held.attack_angle is not None and not STEEPEST[0] <= held.attack_angle <= STEEPEST[1]:
        raise InputError(f"attack angle is {held.attack_angle / DEGREE:.4g} deg; allowed is -20 to 60 deg")

    def tried(angle: Array, offset: Array, place: Array) -> Plays:
        return plays(
            model,
            conditions,
            swings=Swings(swing.angular_speed * (place - swing.pivot), plane.axes(angle), swing.pivot),
            pitches=pitch,
            contact=Contact(place, offset),
            friction=friction,
        )

    best = _climbed(tried, length=model.bat.length, held=held)
    flown = tried(*best[:, None])
    reach = conditions.ball.radius + float(model.bat.diameter_at(best[2])) / 2
    normal = contact_frame(*plane.axes(best[0]), lift=np.arcsin(best[1] / reach)).normal
    return BestSwing(
        attack_angle=float(best[0]),
        offset=float(best[1]),
        undercut=reach * float(normal[2]),
        position=float(best[2]),
        carry=float(flown.flights.carry[0]),
        hang_time=float(flown.flights.hang_time[0]),
        launched=BallMotion(pitch.position, flown.strikes.velocity[0], flown.strikes.spin[0]),
    )


def _climbed(tried: Tried, *, length: float, held: Held) -> Array:
    """Return the best (attack angle, offset, place); those that are given stay."""
    from scipy.optimize import minimize

    position, attack_angle = held
    angles = ATTACK_ANGLES if attack_angle is None else np.array([attack_angle])
    places = length - FROM_TIP if position is None else np.array([position])
    grid = [axis.ravel() for axis in np.meshgrid(angles, OFFSETS, places, indexing="ij")]
    carries = np.nan_to_num(tried(*grid).flights.carry)
    if not carries.max() > 0:
        raise InputError("no contact with this bat, swing and pitch makes the ball fly; is the bat fast enough?")
    start = np.array([axis[carries.argmax()] for axis in grid])
    limits = np.array([STEEPEST, DEEPEST, (length - FARTHEST, length - NEAREST)])
    moving = np.flatnonzero([attack_angle is None, True, position is None])

    def placed(steps: Array) -> Array:
        point = start.copy()
        point[moving] = np.clip(start[moving] + steps * UNITS[moving], *limits[moving].T)
        return point

    def shortfall(steps: Array) -> float:
        return -1e3 * float(np.nan_to_num(tried(*placed(steps)[:, None]).flights.carry[0]))

    none = np.zeros(len(moving))
    simplex = np.vstack([none, 2 * np.eye(len(moving))])
    minimum = minimize(
        shortfall,
        none,
        method="Nelder-Mead",
        options={"xatol": SHARP, "fatol": SHARP, "maxiter": MOST_STEPS, "initial_simplex": simplex},
    )
    return placed(minimum.x)
