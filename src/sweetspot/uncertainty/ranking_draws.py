"""Exit speeds of sampled bats of one model, the ball the same for all, a player swinging heavy ones more slowly.

v = q v_ball + (1 + q) v_bat, with q of `EfficiencyResponse` and v_bat ~ I^-n of the swing law, whose moment of inertia
is exponential in what is not known: d ln I per unknown is taken as constant.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.posterior import BatPosterior
from sweetspot.calibration.unknowns import Unknown, deviated
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.sources import Sources, sources_of_ball


@dataclass(frozen=True)
class EfficiencyResponse:
    """The linear response of q along a bat to n unknowns, the bat's first, then the ball's.

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
    """Return the quantities along a bat on which q depends (``positions``: m from the knob end, shape (m,))."""
    count = len(unknowns)
    of_ball = Sources(NO_DOUBT, sources_of_ball(conditions.ball))
    spreads = np.array([*(unknown.spread for unknown in unknowns), *(1.0 for _ in of_ball.others)])

    def efficiency(deviations: Array) -> Array:
        other = deviated(beam, unknowns, deviations[:count]) if count else beam
        (with_ball,) = of_ball.balls(conditions.ball, deviations[None, count:])
        given = conditions.replaced(ball=with_ball)
        return scan(ReducedBat.of_beam(other, with_ball), given, positions).collision_efficiency

    base = efficiency(np.zeros(len(spreads)))
    moved = [(efficiency(step), efficiency(-step), size) for step, size in zip(np.diag(spreads), spreads, strict=True)]
    slopes = np.array([(up - down) / (2 * size) for up, down, size in moved])
    bends = np.array([(up + down - 2 * base) / (2 * size**2) for up, down, size in moved])
    return EfficiencyResponse(positions, spreads, base, slopes, bends)


STEPS_IN_SPREAD = 10
"""Steps of the derivatives of the moment of inertia in one spread of an unknown."""


@dataclass(frozen=True)
class SpeedResponse:
    """The linear response of exit speeds along a bat.

    Parameters
    ----------
    efficiency : of q: the unknowns of the bat, then those of the ball.
    law : of bat speed against moment of inertia; None: all bats are swung as fast.
    moi : of the bat as described, about the law's axis, kg m^2.
    slopes : derivative of ln moi by every unknown of the bat, shape (n,).
    """

    efficiency: EfficiencyResponse
    conditions: Conditions
    law: SwingLaw | None
    moi: float
    slopes: Array

    def at(self, deviations: Array) -> Array:
        """Return m/s along bats that deviate, shape (bats, places) for deviations of shape (bats, unknowns)."""
        efficiency, swing = self.efficiency.at(deviations), self.conditions.swing
        bat = swing.angular_speed * (self.efficiency.position - swing.pivot)
        ratio = np.ones(len(deviations))
        if self.law is not None:
            moments = self.moi * np.exp(deviations[:, : len(self.slopes)] @ self.slopes)
            ratio = np.array([self.law.speed_ratio(float(moi), reference_moi=self.moi) for moi in moments])
        return np.asarray(efficiency * self.conditions.pitch.speed + (1 + efficiency) * ratio[:, None] * bat)


def response_of_speed(
    beam: BeamModel, conditions: Conditions, *, unknowns: Sequence[Unknown], positions: Array, law: SwingLaw | None
) -> SpeedResponse:
    """Return the quantities along a bat on which exit speeds depend.

    ``positions``: m from the knob end, shape (m,). ``law``: of bat speed against moment of inertia; None: all are swung
    as fast.
    """
    wanted = [Measurement("moi", Measured(1, 1), axis=0.0 if law is None else law.axis)]

    def log_moi(deviations: Array) -> float:
        return math.log(predicted(deviated(beam, unknowns, deviations), wanted)[0])

    sizes = np.array([unknown.spread for unknown in unknowns]) / STEPS_IN_SPREAD
    steps = np.diag(sizes)
    slopes = [(log_moi(step) - log_moi(-step)) / (2 * size) for step, size in zip(steps, sizes, strict=True)]
    efficiency = response_of_efficiency(beam, conditions, unknowns=unknowns, positions=positions)
    return SpeedResponse(efficiency, conditions, law, math.exp(log_moi(0 * sizes)), np.array(slopes))


DRAWS = 4000
"""A probability of 1/2 is then known to 0.008."""


@dataclass(frozen=True)
class DrawnSpeeds:
    """Exit speeds of one bat as it may be, the ball the same for all bats.

    ``with_ball``: m/s at the best place of every draw, the ball as it may be too, shape (draws,). ``exit_speed``:
    median and standard deviation of the same with the mean ball, m/s. ``best``: index of the place best on average.
    """

    with_ball: Array
    exit_speed: Measured
    best: int


@dataclass(frozen=True)
class DrawnRanking:
    """Bats by name, and the standard deviation in m/s of bats of their model before any is measured."""

    bats: Mapping[str, DrawnSpeeds]
    by_nature: float

    def chances(self, names: Sequence[str]) -> dict[str, float]:
        """Return the part of the draws in which each of some bats is the fastest."""
        won = np.argmax(np.array([self.bats[name].with_ball for name in names]), axis=0)
        return dict(zip(names, (np.bincount(won, minlength=len(names)) / len(won)).tolist(), strict=True))


def drawn_ranking(posteriors: Mapping[str, BatPosterior], response: SpeedResponse, *, seed: int) -> DrawnRanking:
    """Return the exit speeds of draws of bats, all of one description, and of the ball."""
    generator = np.random.default_rng(seed)
    of_bat, of_ball = np.split(response.efficiency.spreads, [len(response.slopes)])
    ball = generator.standard_normal((DRAWS, len(of_ball))) * of_ball
    bats = {name: _drawn(posterior.draws(DRAWS, generator), ball, response) for name, posterior in posteriors.items()}
    wood = generator.standard_normal((DRAWS, len(of_bat))) * of_bat
    return DrawnRanking(bats, float(response.at(np.hstack([wood, 0 * ball])).max(axis=1).std()))


def _drawn(deviations: Array, ball: Array, response: SpeedResponse) -> DrawnSpeeds:
    curves = response.at(np.hstack([deviations, 0 * ball]))
    best = curves.max(axis=1)
    speed = Measured(float(np.median(best)), float(best.std()))
    with_ball = response.at(np.hstack([deviations, ball])).max(axis=1)
    return DrawnSpeeds(with_ball, speed, int(np.argmax(curves.mean(axis=0))))
