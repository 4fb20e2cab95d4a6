"""Optimal swings for carry: how far below the ball's middle, how steeply upwards, and with which part of the barrel.

Carry is a smooth function of these, so it is searched on a coarse grid and then climbed to the top by Nelder and
Mead's method.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sweetspot.analysis.full_play import Plays, plays
from sweetspot.collision.hit_in_space import Contact
from sweetspot.collision.oblique_contact import USUAL_FRICTION, Friction, contact_frame
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPlane, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, INCH

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

    Parameters
    ----------
    conditions : ball, drag law, air and wind.
    swing : how fast the bat turns.
    pitch : the ball where the bat meets it, in the field's frame.
    plane : what fixes the bat's path but for its attack angle.
    held : place and attack angle that are not searched.

    Raises
    ------
    InputError
        for an attack angle outside these limits, or when no contact of the grid makes the ball fly.
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
        shortfall, none, method="Nelder-Mead",
        options={"xatol": SHARP, "fatol": SHARP, "maxiter": MOST_STEPS, "initial_simplex": simplex},
    )  # fmt: skip
    return placed(minimum.x)
