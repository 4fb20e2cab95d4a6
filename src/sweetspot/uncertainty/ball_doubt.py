"""How sure an exit speed is for the ball alone: balls of a kind differ."""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.balls import ball_spreads
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.confidence import REACH


def speed_by_ball(analysis: Analysis[Implement]) -> Measured | None:
    """Return the best hit's exit speed in m/s with what the ball alone leaves open; None where no spread is known."""
    conditions, place = analysis.conditions, analysis.sweet_spots.max_exit_speed
    error = error_by_ball(analysis.bat, body=analysis.body, modes=analysis.modes, conditions=conditions, position=place)
    return None if error is None else Measured(exit_speed_of(analysis.best, conditions), error)


def error_by_ball(
    bat: Implement, *, body: RigidBody, modes: Modes, conditions: Conditions, position: float
) -> float | None:
    """Return the standard deviation in m/s that the ball alone leaves to an exit speed; None: no spread is known.

    Balls of a kind differ, and what one returns at game speed is not known better; the bat's modes are as they are.

    Parameters
    ----------
    position : where the ball is met head-on, m from the knob end.
    """
    place, spreads = np.array([position]), ball_spreads(conditions.ball)
    if not spreads:
        return None

    def speed(name: str, off: float) -> float:
        with_ball = conditions.replaced(ball=conditions.ball.deviated({name: off}))
        hit = scan(bat, body=body, modes=modes, conditions=with_ball, positions=place)
        return float(hit.exit_speed[0])

    halves = [(speed(name, size / REACH) - speed(name, -size / REACH)) / 2 for name, size in spreads.items()]
    return float(np.linalg.norm(halves))
