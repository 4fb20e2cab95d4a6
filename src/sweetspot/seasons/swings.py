"""Swing and pitch of each ball in the plane across the bat's axis, which is all that a bat's table asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.equipment.ball import Ball
from sweetspot.flight.carry_scatter import TRACKED
from sweetspot.motion.swing_path import path_axes, steep_enough
from sweetspot.numerics.arrays import Array, vectors
from sweetspot.seasons.balls import Balls
from sweetspot.seasons.plane_hits import RATIOS, SLANTS, SPEEDS, BatInPlane
from sweetspot.units import DEGREE, MPH

LEAST = 0.25 * MPH
"""m/s, least scatter and least mean loss."""
LOSS_CUTOFF = 25 * MPH
"""m/s, beyond which a loss counts no more."""


@dataclass(frozen=True)
class SwingSpeeds:
    """The distribution of bat speeds: full swings about one speed, and the loss of swings that are broken off.

    A bat speed is that of a full swing, normal about its mean, less what was lost, which falls off exponentially:
    few swings lose much. What was read then tells how much of either there was, on average. It matters because the
    two are not alike: readings of full swings scatter to both sides, so those far above the mean were mostly read
    too fast, while most slow ones really were slow; and who breaks a swing off meets the ball elsewhere.

    ``full_speed``: mean of full swings, m/s. ``full_spread``: standard deviation of full swings, m/s. ``lost_speed``:
    mean of what is lost, m/s.
    """

    full_speed: float
    full_spread: float
    lost_speed: float

    def parts(self, bat_speed: Array) -> tuple[Array, Array]:
        """Return the expected excess of full swings over the usual and the expected loss, m/s; NaN where not known.

        The first has the mean 0 over all swings, the second the mean ``lost_speed``. Given what was read, what was lost
        is normal about ``full_speed - bat_speed - full_spread^2 / lost_speed``, cut off at 0: the product of both
        densities.

        >>> faster, lost = USUAL_SPEEDS.parts(np.array([50.0, 80.0]) * MPH)
        >>> (faster / MPH).round(1).tolist(), (lost / MPH).round(1).tolist()
        ([-4.7, 6.3], [20.4, 1.4])
        """
        from scipy.special import log_ndtr

        middle = self.full_speed - bat_speed - self.full_spread**2 / self.lost_speed
        ratio = middle / self.full_spread
        bell = np.exp(-0.5 * ratio**2 - log_ndtr(ratio)) / np.sqrt(2 * np.pi)
        lost = np.clip(middle + self.full_spread * bell, 0, LOSS_CUTOFF)
        return np.maximum(bat_speed + lost - self.full_speed, -(self.full_spread**2) / self.lost_speed), lost


USUAL_SPEEDS = SwingSpeeds(75.1 * MPH, 4.1 * MPH, 3.6 * MPH)
"""Of 20,074 tracked swings of at least 40 mph [sure2026]."""


def likeliest_speeds(bat_speed: Array) -> SwingSpeeds:
    """Return the spread that makes bat speeds most likely.

    ``bat_speed``: m/s, shape (n,).
    """
    from scipy.optimize import minimize
    from scipy.special import log_ndtr

    middle, width = float(np.mean(bat_speed)), float(np.std(bat_speed))

    def unlikely(numbers: Array) -> float:
        full, scatter, lost = numbers[0], *np.exp(numbers[1:])
        below = full - bat_speed
        each = (
            -np.log(lost) + 0.5 * (scatter / lost) ** 2 - below / lost + log_ndtr((below - scatter**2 / lost) / scatter)
        )
        return -float(each.mean())

    usual = max(width, 2 * LEAST)
    start = np.array([middle + 0.5 * usual, np.log(0.8 * usual), np.log(0.5 * usual)])
    ends = [(None, None), *[(np.log(LEAST), np.log(4 * usual))] * 2]
    found = minimize(unlikely, start, bounds=ends, method="L-BFGS-B").x
    return SwingSpeeds(float(found[0]), float(np.exp(found[1])), float(np.exp(found[2])))


OUTCOMES = ("ok", "no bat speed", "no launch angle", "not a full swing", "out of the swing's plane", "grazed")
"""The outcomes of a ball's contact; "grazed": no place of the barrel sends a ball off so."""
FULL_SWING = 40 * MPH
"""m/s; slower bats were checked or bunted, and the tables do not reach down to them."""
USUAL_ATTACK, ATTACK_SPREAD = np.radians(8.6), np.radians(7.0)
"""Mean of 20,023 swings, and what swings of one batter scatter by [sure2026]."""
USUAL_PITCH, PITCH_SPREAD = 82.0 * MPH, 5.0 * MPH
"""At the plate: mean of 2,507 pitches, and what kinds of pitches differ by [savant_2020day]."""
PER_PITCH_SPEED = 0.22
"""Exit speed gained per pitch speed, the efficiency of a bat at its best [statcast]."""
USUAL_TILT = np.radians(32.0)
"""Mean of 20,023 swings [sure2026]."""
STEEPEST = np.radians(79.0)
LAUNCH_LEVERAGE, ATTACK_LEVERAGE = 1.16, 1.80
"""By how much errors of launch and attack angle move the offset, over one of the angle turned in the bat's plane;
medians of differences on a made-up season. The plane is tilted, and the attack angle turns the bat's own way too."""


@dataclass(frozen=True)
class Errors:
    """Measuring errors, as standard deviations; all are parameters, none is fitted.

    ``exit_speed``, ``bat_speed``: m/s. ``launch_angle``, ``attack_angle``: rad. ``axial_offset``: m, where it was
    measured.
    """

    exit_speed: float = TRACKED.exit_speed
    bat_speed: float = 1.0 * MPH
    launch_angle: float = TRACKED.launch_angle
    attack_angle: float = 3.0 * DEGREE
    axial_offset: float = 0.0127


USUAL_ERRORS = Errors()


@dataclass(frozen=True)
class InPlane:
    """The inputs of a bat's table, every array of shape (n,).

    Parameters
    ----------
    outcome : index into `OUTCOMES`.
    bat_speed : m/s where it is measured.
    ahead, up, along : m/s of the pitch along the bat's path, square to it upwards, and along the bat to the tip.
    tangent : m/s, the pitch's spin about the bat's axis times the ball's radius.
    exit_speed : m/s of the ball in the plane.
    turned : rad by which the ball left the bat's path.
    angle_error : rad, standard deviation of the latter.
    speed_error : m/s, of the exit speed, for a pitch speed that is not known.
    """

    outcome: NDArray[np.int64]
    bat_speed: Array
    ahead: Array
    up: Array
    along: Array
    tangent: Array
    exit_speed: Array
    turned: Array
    angle_error: Array
    speed_error: Array


def in_plane(balls: Balls, surface: BatInPlane, errors: Errors, *, ball: Ball) -> InPlane:
    """Return swings and pitches in the plane across the bat's axis.

    Where attack angle, direction, tilt or pitch speed were not measured the usual ones stand in, with their errors. An
    attack angle that was read far from the usual was on average not quite so far: what is taken is its mean, given the
    reading, its error and what swings scatter by.
    """
    measured = np.isfinite(balls.attack_angle)
    share = ATTACK_SPREAD**2 / (ATTACK_SPREAD**2 + errors.attack_angle**2)
    attack = USUAL_ATTACK + np.where(measured, share * (balls.attack_angle - USUAL_ATTACK), 0.0)
    attack = np.clip(attack, -STEEPEST, STEEPEST)
    direction = np.nan_to_num(balls.attack_direction)
    tilt = np.minimum(steep_enough(np.where(np.isfinite(balls.tilt), balls.tilt, USUAL_TILT), attack), 1.5)
    axes = path_axes(attack, direction, tilt=tilt, left=balls.left)
    thrown = np.isfinite(balls.plate_speed)
    pitched = np.where(thrown, balls.plate_speed, USUAL_PITCH)
    level = pitched * np.cos(balls.descent)
    pitch = vectors(level * np.sin(balls.crossing), -level * np.cos(balls.crossing), -pitched * np.sin(balls.descent))
    ahead, up, along = (np.sum(pitch * axis, axis=-1) for axis in axes)
    slid = surface.along[0] * along + surface.along[1] * balls.bat_speed
    fast = np.sqrt(np.maximum(balls.exit_speed**2 - slid**2, 1.0))
    sine = (balls.exit_speed * np.sin(balls.launch_angle) - slid * axes.tip[:, 2]) / fast
    rise, lift = axes.forward[:, 2], axes.up[:, 2]
    size = np.hypot(rise, lift)
    with np.errstate(invalid="ignore"):
        turned = np.arcsin(np.clip(sine / size, -1, 1)) - np.arctan2(rise, lift)
    outcome = np.zeros(len(balls), np.int64)
    outcome[np.abs(sine) > size * 1.02] = OUTCOMES.index("out of the swing's plane")
    outcome[balls.bat_speed < FULL_SWING] = OUTCOMES.index("not a full swing")
    for name, values in (("no launch angle", balls.launch_angle), ("no bat speed", balls.bat_speed)):
        outcome[~np.isfinite(values)] = OUTCOMES.index(name)
    tangent = ball.radius * np.sum(balls.spin * axes.tip, axis=-1)
    unsteady = ATTACK_LEVERAGE * np.where(measured, math.sqrt(share) * errors.attack_angle, ATTACK_SPREAD)
    angle_error = np.hypot(LAUNCH_LEVERAGE * errors.launch_angle, unsteady)
    speed_error = np.where(thrown, 0.0, PER_PITCH_SPEED * PITCH_SPREAD)
    swing = (outcome, balls.bat_speed, ahead, up, along, tangent)
    return InPlane(*swing, fast, turned, angle_error, speed_error)


def ceilings(plane: InPlane, surface: BatInPlane) -> tuple[Array, Array]:
    """Return the greatest exit speed of each swing with a bat in m/s, and the place where it is, m from the tip."""
    coming = np.hypot(plane.ahead, plane.up)
    swung = np.where(plane.bat_speed > 1, plane.bat_speed, np.nan)
    asked = (swung, coming / swung, np.arctan2(-plane.up, -plane.ahead))
    where = [
        np.clip(np.interp(values, nodes, np.arange(len(nodes))), 0, len(nodes) - 1.000001)
        for values, nodes in zip(asked, (SPEEDS, RATIOS, SLANTS), strict=True)
    ]
    where = [np.nan_to_num(values) for values in where]
    low = [values.astype(np.int64) for values in where]
    top, place = np.zeros((2, len(coming)))
    for corner in np.ndindex(2, 2, 2):
        weight = np.ones(len(coming))
        for at, start, step in zip(where, low, corner, strict=True):
            weight = weight * ((at - start) if step else 1 - (at - start))
        index = tuple(start + step for start, step in zip(low, corner, strict=True))
        top += weight * surface.ceiling[index]
        place += weight * surface.best_place[index]
    measured = np.isfinite(coming) & np.isfinite(swung)
    return np.where(measured, np.hypot(top * plane.bat_speed, surface.along[0] * plane.along), np.nan), np.where(
        measured, place, np.nan
    )
