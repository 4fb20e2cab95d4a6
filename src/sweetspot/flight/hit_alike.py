"""How far apart balls come down that were hit alike."""

from __future__ import annotations

from dataclasses import replace

from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import USUAL
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotion


def carry_spread(motion: BallMotion, conditions: FlightConditions, *, drag_scatter: float = USUAL.open) -> float:
    """Return the standard deviation of the carry of baseballs hit alike, m.

    Balls differ in drag, spin about the usual line, and the breeze is not known. All is told as one scatter of the drag
    coefficient, as for home runs: half of what the carry changes from one standard deviation less to one more.

    Parameters
    ----------
    motion : as the ball leaves the bat.
    conditions : what it flies through.
    drag_scatter : part of the drag coefficient, 0 to less than 1 [savant_2022rays].
    """
    less, more = (
        fly(motion, replace(conditions, aerodynamics=conditions.aerodynamics.with_drag(1 + sign * drag_scatter))).carry
        for sign in (-1, 1)
    )
    return (less - more) / 2
