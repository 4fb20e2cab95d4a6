"""Measurements from shots at known places of a bat: the collision efficiency q there, with its error.

A wrong modulus, wall or weight moves q differently along the bat; a livelier ball moves it everywhere. The ball's
restitution is therefore one more unknown, as wide as the catalogue allows for its kind, or as the shots tell where
every ball was measured on a rigid wall. That is done at 60 mph, as `certify` reads it; what a ball loses from there to
the speed of the shots stays as little known as the catalogue has it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sweetspot.analysis.certification.shot_statistics import COR_SPEED
from sweetspot.analysis.certification.shots import Shot
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, Shooting
from sweetspot.calibration.posterior import OF_BALL
from sweetspot.calibration.unknowns import Unknown
from sweetspot.catalog.balls import ball_spreads
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.interval import REACH

ONE_PLACE = 0.0064
"""m; shots within a quarter of an inch are at one place."""
ONE_SHOT = 0.01
"""One sigma of q of a single shot at least (assumed): each speed to half a per cent."""
MEASURED_BALLS = 0.01
"""One sigma of the restitution's logarithm at 60 mph where every ball was measured (assumed)."""


def of_shots(shots: Sequence[Shot], ball: Ball) -> list[Measurement]:
    """Return the mean q of the shots at each place, with the error of the mean."""
    groups: list[list[Shot]] = []
    for shot in sorted(shots, key=lambda entry: entry.position):
        if groups and shot.position - groups[-1][0].position <= ONE_PLACE:
            groups[-1].append(shot)
        else:
            groups.append([shot])
    return [_mean(group, ball) for group in groups]


def _mean(group: Sequence[Shot], ball: Ball) -> Measurement:
    values = np.array([shot.collision_efficiency for shot in group])
    scatter = max(float(np.std(values, ddof=1)), ONE_SHOT) if len(group) > 2 else ONE_SHOT
    closing = float(np.mean([shot.closing_speed for shot in group]))
    place = float(np.mean([shot.position for shot in group]))
    return Measurement(
        "efficiency",
        Measured(float(values.mean()), scatter / math.sqrt(len(group))),
        shooting=Shooting(place, closing, _as_measured(ball, group)),
    )


def _as_measured(ball: Ball, group: Sequence[Shot]) -> Ball:
    """Return the ball with the mean restitution and mass of those that were shot, as far as they were measured."""
    cors = [shot.ball_cor for shot in group if shot.ball_cor is not None]
    masses = [shot.ball_mass for shot in group if shot.ball_mass is not None]
    if len(cors) == len(group):
        law = ball.restitution
        off = float(np.mean(cors)) - law.at(COR_SPEED)
        ball = ball.replaced(restitution=law.replaced(reference=law.reference + off))
    if len(masses) == len(group):
        ball = ball.replaced(mass=float(np.mean(masses)))
    return ball


def shot_ball_unknown(shots: Sequence[Shot], ball: Ball) -> Unknown:
    """Return the unknown of the shot balls' restitution: its logarithm over that of their law."""
    spreads, law = ball_spreads(ball), ball.restitution
    measured = all(shot.ball_cor is not None for shot in shots)
    known_at = COR_SPEED if measured else law.reference_speed
    spread = MEASURED_BALLS if measured else spreads.get("restitution", 0.05) / REACH / law.reference
    faster = float(np.mean([shot.closing_speed for shot in shots])) - known_at
    by_slope = spreads.get("restitution_slope", 0.0) / REACH * faster / law.reference
    return Unknown(OF_BALL, math.hypot(spread, by_slope))
