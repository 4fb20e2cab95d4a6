"""How q along a barrel answers to what is not known of bat and ball: its value, slope and bend for each of them.

Each is moved one sigma up and down and the bat hit again; a sum of slopes and bends is the answer for any bat and ball
that might be meant, as quick as a ranking of many bats wants. An interval beside a number comes from `draws`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.unknowns import Unknown, deviated
from sweetspot.catalog.balls import ball_spreads
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.mode_assembly import all_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import REACH


@dataclass(frozen=True)
class EfficiencyResponse:
    """What q along a bat depends on: n unknowns, the bat's first, then the ball's.

    Parameters
    ----------
    position : m from the knob end, shape (m,).
    spreads : one standard deviation of each unknown, before anything was measured, shape (n,).
    values : q of the bat as described, shape (m,).
    slopes, bends : first derivative by every unknown, and half the second, shape (n, m).
    """

    position: Array
    spreads: Array
    values: Array
    slopes: Array
    bends: Array

    def at(self, deviations: Array) -> Array:
        """Return q along bats that deviate, shape (bats, m) for deviations of shape (bats, n)."""
        return np.asarray(self.values + deviations @ self.slopes + deviations**2 @ self.bends)


def response_of_efficiency(
    beam: BeamModel, conditions: Conditions, *, unknowns: Sequence[Unknown], positions: Array
) -> EfficiencyResponse:
    """Return what q along a bat depends on.

    Parameters
    ----------
    beam : its beam, as it was described.
    conditions : of the hits.
    positions : m from the knob end, shape (m,).
    """
    count = len(unknowns)
    ball = {name: size / REACH for name, size in ball_spreads(conditions.ball).items()}
    spreads = np.array([*(one.spread for one in unknowns), *ball.values()])

    def efficiency(deviations: Array) -> Array:
        other = deviated(beam, unknowns, deviations[:count]) if count else beam
        with_ball = conditions.ball.deviated(dict(zip(ball, deviations[count:].tolist(), strict=True)))
        given = conditions.replaced(ball=with_ball)
        modes, body = all_modes(other, with_ball), rigid_body(other)
        return scan(other.bat, body=body, modes=modes, conditions=given, positions=positions).collision_efficiency

    base = efficiency(np.zeros(len(spreads)))
    moved = [(efficiency(step), efficiency(-step), size) for step, size in zip(np.diag(spreads), spreads, strict=True)]
    slopes = np.array([(up - down) / (2 * size) for up, down, size in moved])
    bends = np.array([(up + down - 2 * base) / (2 * size**2) for up, down, size in moved])
    return EfficiencyResponse(positions, spreads, base, slopes, bends)
