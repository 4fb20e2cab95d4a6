"""What a bat does with a ball, tabled once so that millions of swings can be read off.

Two tables: collision efficiency along the bat at two closing speeds, from the coupled collision; and, for a ball met
above or below the bat's axis, the part of the exit speed that is left and how far the launch angle leaves the bat's
path, from the oblique collision in space.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes, steep_enough
from sweetspot.numerics.arrays import Array
from sweetspot.player.prior import fixed, priors
from sweetspot.units import INCH

REACH, PLACES = 16 * INCH, 65
"""m from the tip that are tabled, every quarter of an inch: beyond them a bat is hit by accident."""
SLOW, FAST = 40.0, 75.0
"""m/s; closing speeds between which collision efficiency is a straight line, and beyond which it goes on."""
BARREL = 6.5 * INCH
"""m from the tip where the off-centre table is made."""
BAT_SPEED = 31.0
"""m/s there."""
RATIOS = np.array([0.0, 0.4, 0.8, 1.2, 1.6])
"""Pitch speed over bat speed; 0: a tee."""
STEEPER = math.radians(7)
"""By how much steeper and flatter swings are tried for the turning."""
FARTHEST, OFFSETS = 0.97, 121
"""Largest offset as a part of both radii together, and how many offsets from one side to the other."""

KEPT_TABLES = 256
"""Tables that a process keeps: a league's batters swing the same few bats."""


@dataclass(frozen=True, eq=False)
class ContactTable:
    """One bat's answers; the same object for the same bat, so it is compared and kept by what it is.

    Parameters
    ----------
    bat : the bat.
    moi : kg m^2 about the swing law's axis.
    from_tip : m, increasing, evenly spaced.
    efficiency, efficiency_slope : q at no closing speed, as the straight line would have it, and its change per m/s;
        shape of ``from_tip``.
    offset : m of the ball's centre above the bat's axis, increasing, evenly spaced.
    kept : part of the head-on exit speed that is left, shape (ratios, offsets).
    deflection : rad, launch angle minus attack angle at the usual attack angle, same shape.
    turning : rad per rad that the swing is steeper by, what the deflection grows by, shape (ratios,).
    """

    bat: Bat
    moi: float
    from_tip: Array
    efficiency: Array
    efficiency_slope: Array
    offset: Array
    kept: Array
    deflection: Array
    turning: Array


def contact_table(bat: Bat, *, ball: Ball, axis: float, like: ContactTable | None = None) -> ContactTable:
    """Return the tables of a bat.

    Parameters
    ----------
    axis : where the swing law takes the moment of inertia, m from the bottom of the grip.
    like : table of another bat whose off-centre hits are taken over, for they hang on the barrel's width alone; None:
        worked out.

    Raises
    ------
    InputError
        when the bat is no heavier than the ball, or does not send it back anywhere on the barrel.
    """
    return _made(bat, ball, axis, like)


@lru_cache(maxsize=KEPT_TABLES)
def _made(bat: Bat, ball: Ball, axis: float, like: ContactTable | None) -> ContactTable:
    model = reduced_bat(bat, ball=ball)
    if ball.mass >= model.body.mass:
        raise InputError(
            f"{bat.name} weighs {model.body.mass:.4g} kg and the ball {ball.mass:.4g} kg; allowed is a ball lighter "
            "than the bat"
        )
    from_tip = np.linspace(0.0, REACH, PLACES)
    slow, fast = (_efficiency(model, ball, from_tip, speed) for speed in (SLOW, FAST))
    slope = (fast - slow) / (FAST - SLOW)
    if like is None:
        offset, kept, deflection, turning = _off_centre(model, ball)
    else:
        offset, kept, deflection, turning = like.offset, like.kept, like.deflection, like.turning
    return ContactTable(
        bat=bat, moi=model.body.moi(bat.choke + axis), from_tip=from_tip, efficiency=slow - slope * SLOW,
        efficiency_slope=slope, offset=offset, kept=kept, deflection=deflection, turning=turning,
    )  # fmt: skip


def _efficiency(model: ReducedBat[Bat], ball: Ball, from_tip: Array, speed: float) -> Array:
    place = model.bat.length - np.minimum(from_tip, 0.6 * model.bat.length)
    done = hits(model.modes, ball=ball, position=place, closing_speed=speed)
    known = np.isfinite(done.collision_efficiency)
    if known.sum() < PLACES // 2:
        raise InputError(f"{model.bat.name} does not send the ball back on most of its barrel; check its wall")
    return np.interp(from_tip, from_tip[known], done.collision_efficiency[known])


def _off_centre(model: ReducedBat[Bat], ball: Ball) -> tuple[Array, Array, Array, Array]:
    """Return offsets and, for every ratio of speeds, the part of exit speed kept, the deflection and its turning.

    The swing has the usual tilt, the pitch the usual descent and backspin; the answers hardly depend on these.
    A steeper swing meets the ball at a greater angle, so what leaves is turned further: by half as much again as the
    swing, for usual speeds.
    """
    reach = ball.radius + float(model.bat.diameter_at(model.bat.length - BARREL)) / 2
    offset = np.linspace(-FARTHEST * reach, FARTHEST * reach, OFFSETS)
    usual = priors()["attack_angle"].centre
    speed, launch = _turned(model, ball, offset, usual)
    middle = OFFSETS // 2
    ends = [_turned(model, ball, np.zeros(1), usual + step)[1][:, 0] - step for step in (-STEEPER, STEEPER)]
    return offset, speed / speed[:, middle : middle + 1], launch - usual, (ends[1] - ends[0]) / (2 * STEEPER)


def _turned(model: ReducedBat[Bat], ball: Ball, offset: Array, attack: float) -> tuple[Array, Array]:
    """Return exit speed and launch angle for every ratio of speeds and every offset, shape (ratios, offsets)."""
    descent, count = fixed("pitch_descent"), len(offset)
    lifting = np.array([-fixed("pitch_backspin"), 0.0, 0.0])  # of a ball that comes in along -y
    axes = path_axes(attack, 0.0, tilt=steep_enough(fixed("swing_tilt"), attack), left=False)
    pitch = np.repeat(RATIOS * BAT_SPEED, count)[:, None] * np.array([0.0, -math.cos(descent), -math.sin(descent)])
    done = strikes(
        model,
        ball=ball,
        swings=Swings(BAT_SPEED, axes),
        pitches=BallMotions(velocity=pitch, spin=np.repeat(RATIOS > 0, count)[:, None] * lifting),
        contact=Contact(model.bat.length - BARREL, np.tile(offset, len(RATIOS))),
    )
    across = np.hypot(done.velocity[:, 0], done.velocity[:, 1])
    launch = np.arctan2(done.velocity[:, 2], across)
    return done.exit_speed.reshape(len(RATIOS), count), launch.reshape(len(RATIOS), count)


def farthest_offset(table: ContactTable) -> float:
    """Return the largest offset in m of a hit that is counted: up to it, every inch turns the ball further.

    Beyond it the ball is only grazed and goes foul; files of batted balls do not hold it.
    """
    ends = []
    for row in table.deflection:
        ends += [table.offset[int(np.argmax(row))], -table.offset[int(np.argmin(row))]]
    return float(min(ends))
