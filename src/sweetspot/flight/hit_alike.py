"""How far apart balls come down that were hit alike."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from sweetspot.flight.carry_scatter import SPIN_SCATTER, drag_alone, home_run_share
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import USUAL
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import BallMotion, BallMotions, spin_axes
from sweetspot.numerics.arrays import Array


def carry_spread(
    motion: BallMotion,
    conditions: FlightConditions,
    *,
    drag_scatter: float = USUAL.open,
    spin_scatter: float = SPIN_SCATTER,
) -> float:
    """Return the standard deviation of the carry of baseballs hit alike, m.

    The rule is that of `carry_scatter`, for a launch without measuring errors: balls differ in drag and in backspin
    about the usual line, and the breeze is not known, which is told as drag.

    Parameters
    ----------
    motion : as the ball leaves the bat.
    conditions : what it flies through.
    drag_scatter : part of the drag coefficient that home runs scatter by, with all in it, 0 to less than 1.
    spin_scatter : standard deviation of backspin, rad/s; 0 where the spin was measured.
    """
    less, more = (
        _carries(motion, replace(conditions, aerodynamics=conditions.aerodynamics.with_drag(1 + sign * drag_scatter)))
        for sign in (-1, 1)
    )
    right, out, up = (float(part) for part in motion.velocity)
    backwards = np.asarray(spin_axes(math.atan2(up, math.hypot(right, out)), math.atan2(right, out))[0])
    low, high = (_carries(motion, conditions, spin=sign * spin_scatter * backwards) for sign in (-1, 1))
    by_drag = np.array((less - more) / 2)
    per_drag = by_drag / drag_scatter if drag_scatter else by_drag
    drag = drag_alone(by_drag, per_drag=per_drag, home_run=home_run_share(conditions))
    return float(np.sqrt(drag + ((high - low) / 2) ** 2))


def _carries(motion: BallMotion, conditions: FlightConditions, *, spin: Array | float = 0.0) -> float:
    changed = BallMotions(
        velocity=np.asarray(motion.velocity), spin=np.asarray(motion.spin) + spin, position=motion.position
    )
    return float(flights(changed, conditions).carry[0])
