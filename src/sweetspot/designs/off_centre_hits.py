"""What a hit above or below the axis keeps of the exit speed, by the angle of the line of centres.

That angle alone counts, sin = offset / (radius of ball + radius of barrel): a barrel that is thinner where the ball is
met is a little harder to hit well, and that is all that its width does here.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.designs.batter import Batter
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE

ATTACK, TILT, DESCENT = 9 * DEGREE, 35 * DEGREE, 6 * DEGREE
"""Usual attack angle and tilt of the swing and descent of the pitch; the part kept hardly depends on them (assumed)."""
SINES = np.linspace(0.0, 0.97, 33)
WIDTHS = np.linspace(0.0, 0.15, 301)
"""m; places thicker than that keep what the thickest keeps. No barrel is; a flat face keeps everything at any width."""
REACH = 2.0
"""Standard deviations of the offset that are looked at; contacts farther off are not counted."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)
"""Of the mean over offsets on one side of the axis."""


def off_centre(bat: Bat, ball: Ball, batter: Batter) -> tuple[Array, Array]:
    """Return sines of the line of centres' angle, and the part of the head-on exit speed that is left at each.

    Parameters
    ----------
    bat : the present one, met at this batter's mean place.
    """
    place = bat.length - batter.mean_contact
    reach = ball.radius + float(bat.diameter_at(place)) / 2
    both = np.concatenate([SINES, -SINES])
    axes = path_axes(ATTACK, 0.0, tilt=TILT, left=False)
    pitch = max(batter.pitch_speed, 1e-6) * np.array([0.0, -math.cos(DESCENT), -math.sin(DESCENT)])
    speed = batter.bat_speed
    struck = strikes(
        _reduced(bat, ball),
        ball=ball,
        swings=Swings(speed, axes),
        pitches=BallMotions(velocity=pitch, spin=np.zeros(3)),
        contact=Contact(place, both * reach),
    )
    left = np.asarray(struck.exit_speed).reshape(2, len(SINES))
    left = np.where(np.isfinite(left), left, 0.0).mean(axis=0)
    return SINES, left / left[0]


@lru_cache(maxsize=32)
def _reduced(bat: Bat, ball: Ball) -> ReducedBat[Bat]:
    """Return the present bat's beam and modes, which no batter changes."""
    return reduced_bat(bat, ball=ball)


def retained_at_widths(sine: Array, retained: Array, *, batter: Batter, ball: Ball) -> Array:
    """Return the part of the exit speed that a batter's scatter about the axis leaves at `WIDTHS`.

    The mean over offsets within `REACH` standard deviations, by quadrature on either side of the axis up to the last
    sine: what is farther out is a miss. So the mean follows the width without steps.

    Parameters
    ----------
    sine, retained : sines of angles and the parts retained there; see `off_centre`.
    """
    from scipy.interpolate import PchipInterpolator

    part = PchipInterpolator(sine, retained)
    farthest = sine[-1] * (ball.radius + WIDTHS / 2) if sine[-1] < 1 else np.full(len(WIDTHS), np.inf)
    ends = batter.offset + batter.offset_spread * np.array([-REACH, REACH])
    averages = np.zeros(len(WIDTHS))
    for low, high in ((ends[0], min(0.0, ends[1])), (max(0.0, ends[0]), ends[1])):
        first, last = np.clip(low, -farthest, farthest), np.clip(high, -farthest, farthest)
        half = np.maximum(last - first, 0.0) / 2
        offset = ((first + last) / 2)[:, None] + half[:, None] * NODES
        density = np.exp(-(((offset - batter.offset) / batter.offset_spread) ** 2) / 2)
        angle = np.abs(offset) / (ball.radius + WIDTHS / 2)[:, None]
        averages += half * ((part(angle) * density) @ WEIGHTS)
    return np.asarray(averages / (batter.offset_spread * math.sqrt(2 * math.pi) * math.erf(REACH / math.sqrt(2))))
