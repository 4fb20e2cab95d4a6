"""Uncertainty of a carry: scatter of drag and spin between balls, and the errors of the measured launch.

What a carry does when exit speed, launch angle or backspin are a little more is tabled once in some air, with the
flight kernel; what it does with more drag is known ball by ball. All four are independent.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import CALM, Air
from sweetspot.flight.batted_spin import TRACKED as TRACKED_SPIN
from sweetspot.flight.batted_spin import USUAL_ANGLES, SpinLine, backspin_scatter, batted_ball_spin
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import USUAL
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, BallMotions, spin_axes
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, MPH

SPEEDS: Array = np.arange(30.0, 131.0, 10.0) * MPH
ANGLES: Array = np.arange(-30.0, 76.0, 2.5) * DEGREE
"""Nodes of the table; beyond them the nearest counts."""
HOME_RUN = (103.8 * MPH, 28.1 * DEGREE)
"""Mean exit speed and launch angle of home runs [savant_2019homeruns]: the ball whose scatter of drag was given, with
everything else in it."""
MORE_DRAG = 0.1
"""Part of drag that the second flight has more, to learn what drag does to carry."""


class LaunchErrors(NamedTuple):
    """Measuring errors of a launch, as standard deviations: of the exit speed in m/s, of the launch angle in rad."""

    exit_speed: float
    launch_angle: float


TRACKED = LaunchErrors(1.0 * MPH, 1.0 * DEGREE)
"""Of tracked balls, stated: none are published."""


@dataclass(frozen=True)
class CarryErrors:
    """Scatter of carries apart from drag, m, at nodes of exit speed and launch angle.

    ``variances``: m^2, of measuring errors and spin together, shape (speeds, angles). ``home_run``: the same of the
    average tracked home run over what drag does to it, squared: it is in what home runs scatter by.
    """

    variances: Array
    home_run: float

    def spread(self, exit_speed: Array, launch_angle: Array, *, per_drag: Array, scatter: Array) -> Array:
        """Return the standard deviation of carries, m.

        ``scatter`` has everything in it that makes home runs scatter. What measuring errors and spin have in that is
        taken away before those of this launch are added.

        ``exit_speed``, ``launch_angle``: as measured, m/s and rad, shape (n,). ``per_drag``: m by which the carry grows
        with the logarithm of drag, shape (n,). ``scatter``: of home runs, all expressed as drag, shape (n,); see
        `flight.home_runs.CarryScatter`.
        """
        row, along = _between(SPEEDS, exit_speed)
        column, across = _between(ANGLES, launch_angle)
        slower, faster = (
            (1 - across) * self.variances[at, column] + across * self.variances[at, column + 1] for at in (row, row + 1)
        )
        here = (1 - along) * slower + along * faster
        return np.sqrt(drag_alone(per_drag * scatter, per_drag=per_drag, home_run=self.home_run) + here)


def _between(nodes: Array, values: Array) -> tuple[NDArray[np.intp], Array]:
    """Return the even node before each value and the part of the way to the next; beyond the ends the nearest."""
    at = np.clip((np.nan_to_num(values) - nodes[0]) / (nodes[1] - nodes[0]), 0, len(nodes) - 1)
    before = np.minimum(at.astype(np.intp), len(nodes) - 2)
    return before, at - before


def drag_alone(by_drag: Array, *, per_drag: Array, home_run: float) -> Array:
    """Return the variance of the carry that drag alone causes, m^2, from a scatter of home runs with all causes in it.

    ``by_drag``: m, what carries would scatter by if all of it were drag. ``per_drag``: m by which the carry grows with
    the logarithm of drag. ``home_run``: see `CarryErrors`.
    """
    return np.asarray(np.maximum(np.square(by_drag) - np.square(per_drag) * home_run, 0.0))


def carry_errors(
    ball: Ball, aerodynamics: Aerodynamics, air: Air, *, errors: LaunchErrors, spin_scatter: float | None = None
) -> CarryErrors:
    """Return the scatter of carries in given air.

    ``errors``: of the measurements. ``spin_scatter``: standard deviation of backspin about the usual line, rad/s; None:
    the usual one of each launch angle.
    """
    through = FlightConditions(ball=ball, aerodynamics=aerodynamics, air=air)
    speeds, angles = np.meshgrid(SPEEDS, ANGLES, indexing="ij")
    variances = _variances(speeds.ravel(), angles.ravel(), through, errors, spin_scatter).reshape(speeds.shape)
    return CarryErrors(np.nan_to_num(variances), home_run_share(through))


def home_run_share(conditions: FlightConditions) -> float:
    """Return the ``home_run`` of `CarryErrors`: what errors and spin have in the scatter of tracked home runs.

    Those were hit in the winds of a season, from both sides of the plate; one in still air stands for them.

    ``conditions``: ball, law and air of the flights; their wind does not count.
    """
    conditions = replace(conditions, wind=CALM)
    fast, far = (np.array([value]) for value in HOME_RUN)
    law = braked(conditions.aerodynamics)
    more = _carried(fast, far, replace(conditions, aerodynamics=law)) - _carried(fast, far, conditions)
    per_drag = more / np.log1p(MORE_DRAG)
    return float((_variances(fast, far, conditions, TRACKED, None) / np.square(per_drag))[0])


def _carried(speed: Array, angle: Array, conditions: FlightConditions, spin: float | Array = 0.0) -> Array:
    launch = usual_launch(speed, angle, np.zeros(len(speed)), left=np.zeros(len(speed), bool), more_spin=spin)
    return flights(launch, conditions).carry


def _variances(
    speed: Array, angle: Array, conditions: FlightConditions, errors: LaunchErrors, spin: float | None
) -> Array:
    """Return the variance of carries from launch errors and spin, m^2.

    The scatter of spin is no small step for a liner: its part is by Gauss's and Hermite's rule of three nodes, exact
    where the carry is a parabola in the spin.
    """
    fast, steep = errors
    steps = (
        _carried(speed + fast, angle, conditions) - _carried(speed - fast, angle, conditions),
        _carried(speed, angle + steep, conditions) - _carried(speed, angle - steep, conditions),
    )
    more = math.sqrt(3) * (backspin_scatter(angle) if spin is None else spin)
    low, middle, high = (_carried(speed, angle, conditions, sign * more) for sign in (-1, 0, 1))
    return np.asarray(sum(np.square(step / 2) for step in steps) + _spread_squared(low, middle, high))


def _spread_squared(low: Array | float, middle: Array | float, high: Array | float) -> Array:
    """Return the variance of a function of a normal variable from its values at -sqrt 3, 0 and sqrt 3 deviations.

    >>> float(_spread_squared(-np.sqrt(3.0), 0.0, np.sqrt(3.0)).round(12))
    1.0
    """
    slope, bend = (high - low) / 2, (high + low) / 2 - middle
    return np.asarray(np.square(slope) / 3 + np.square(bend) * 2 / 9)


def usual_launch(
    speed: Array,
    angle: Array,
    spray: Array,
    *,
    left: NDArray[np.bool_],
    more_spin: float | Array = 0.0,
    line: SpinLine = TRACKED_SPIN,
) -> BallMotions:
    """Return balls with their usual spin; beyond the angles it is known for, the spin of the nearest.

    ``speed``, ``angle``, ``spray``: m/s and rad, shape (n,). ``left``: whether each was hit from the left side.
    ``more_spin``: backspin beyond the usual, rad/s. ``line``: of the usual spin.
    """
    axes = spin_axes(angle, spray)
    usual = np.clip(angle, USUAL_ANGLES[0] * DEGREE, USUAL_ANGLES[1] * DEGREE)
    back, side = batted_ball_spin(usual, spray, bats=np.where(left, "left", "right"), line=line)
    spin = (back + more_spin)[:, None] * axes[0] + side[:, None] * axes[1]
    return BallMotions(velocity=speed[:, None] * axes[2], spin=spin, position=USUAL_CONTACT)


def braked(law: Aerodynamics) -> Aerodynamics:
    """Return a law with a little more drag."""
    return law.with_drag(1 + MORE_DRAG)


def carry_spread(
    motion: BallMotion,
    conditions: FlightConditions,
    *,
    drag_scatter: float = USUAL.open,
    spin_scatter: float | None = None,
) -> float:
    """Compute the standard deviation of the carry of baseballs hit alike, m.

    A launch without measuring errors: balls differ in drag and in backspin about the usual line, and the breeze is not
    known, which counts as drag.

    Parameters
    ----------
    motion : as the ball leaves the bat.
    conditions : what it flies through.
    drag_scatter : part of the drag coefficient that home runs scatter by, with all in it, 0 to less than 1.
    spin_scatter : standard deviation of backspin, rad/s; 0 where the spin was measured; None: the usual one.
    """
    less, more = (
        _carries(motion, replace(conditions, aerodynamics=conditions.aerodynamics.with_drag(1 + sign * drag_scatter)))
        for sign in (-1, 1)
    )
    right, out, up = (float(part) for part in motion.velocity)
    angle = math.atan2(up, math.hypot(right, out))
    deviation = math.sqrt(3) * (backspin_scatter(angle) if spin_scatter is None else spin_scatter)
    added = deviation * np.asarray(spin_axes(angle, math.atan2(right, out))[0])
    carries = (np.array(_carries(motion, conditions, spin=sign * added)) for sign in (-1, 0, 1))
    by_drag = np.array((less - more) / 2)
    per_drag = by_drag / drag_scatter if drag_scatter else by_drag
    drag = drag_alone(by_drag, per_drag=per_drag, home_run=home_run_share(conditions))
    return float(np.sqrt(drag + _spread_squared(*carries)))


def _carries(motion: BallMotion, conditions: FlightConditions, *, spin: Array | float = 0.0) -> float:
    changed = BallMotions(
        velocity=np.asarray(motion.velocity), spin=np.asarray(motion.spin) + spin, position=motion.position
    )
    return float(flights(changed, conditions).carry[0])
