"""Optimal launches: the best launch angle for an exit speed, and the slowest ball that leaves a park."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import ArrayLike

from sweetspot.errors import InputError
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import Park, fence_at
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotions, batted_ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.units import DEGREE, MPH

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
    exit_speed: float,
    conditions: FlightConditions,
    *,
    backspin: float,
    sidespin: float = 0.0,
    spray: float = 0.0,
) -> BestLaunch:
    """Return the launch angle that carries farthest at one exit speed and spin, with the carry.

    Parameters
    ----------
    exit_speed : m/s, > 0.
    conditions : ball, drag law, air and wind.
    backspin, sidespin : rad/s, the same at every angle.
    spray : rad from centre field, positive to right field.

    >>> from sweetspot import catalog
    >>> from sweetspot.flight.air import Air
    >>> usual = FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(), air=Air())
    >>> best = best_launch(44.704, usual, backspin=230.0)
    >>> 28 < math.degrees(best.launch_angle) < 29  # 100 mph, 2200 rpm
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

    Parameters
    ----------
    conditions : ball, drag law and the air of the park (`catalog.conditions_in` gives its own), without wind.
    backspin : rad/s.
    directions : rad from centre field, that may be hit to.

    Raises
    ------
    InputError
        when no ball below `SPEEDS`' greatest clears the fence, or for a wind.
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
