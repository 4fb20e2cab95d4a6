"""Flights against measured hang times: a glove cuts a distance short, and not what a ball does until then.

Where a table has hang times, the computed ball is stopped after each and asked how far it is: caught or not, it should
be where the tracked one was.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.flight.carry_scatter import usual_launch
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.numerics.arrays import Array
from sweetspot.seasons.balls import Balls, balls_of, fields_of
from sweetspot.seasons.flight_columns import GLOVE, FlightSetting, flown_balls
from sweetspot.units import DEGREE, FOOT, MPH

BARS: Mapping[str, float] = {"hang_bias": 0.05, "distance_bias": 2 * FOOT, "distance_spread": 12 * FOOT}
"""s, m and m; the most that means and standard deviation may be."""
POINTS = 121
"""Of a path; between them a straight line is right to a centimetre."""
ANGLES, SPEED = (15 * DEGREE, 45 * DEGREE), 80 * MPH
"""Balls that are compared."""
FEW = 30


@dataclass(frozen=True)
class HangCheck:
    """What computed flights have more than measured ones.

    Parameters
    ----------
    balls : that were compared.
    hang_bias, hang_spread : mean and standard deviation of the time to the glove or to the ground, s.
    distance_bias, distance_spread : of the distance at the measured hang time, m.
    sixths : the same mean by sixths of the field, from the far pull side to the far opposite one, m; NaN for few balls.
    """

    balls: int
    hang_bias: float
    hang_spread: float
    distance_bias: float
    distance_spread: float
    sixths: tuple[float, ...]

    @property
    def missed(self) -> tuple[str, ...]:
        """Return which of the `BARS` are missed."""
        return tuple(name for name, most in BARS.items() if abs(getattr(self, name)) > most)


def hang_check(rows: pl.DataFrame, setting: FlightSetting, *, caught: NDArray[np.bool_]) -> HangCheck | None:
    """Return how flights agree with measured hang times; None where there are too few.

    Parameters
    ----------
    rows : that went through `rows_of` and are used.
    setting : of the flights.
    caught : which balls ended in a glove, taken at 5 ft; the others on the ground, shape (n,).
    """
    if "hang_time" not in rows.columns:
        return None
    measured = rows["hang_time"].fill_null(np.nan).to_numpy()
    balls = balls_of(rows)
    here = np.isfinite(measured) & (measured > 0) & (balls.distance > 0) & (balls.exit_speed >= SPEED)
    here &= (balls.launch_angle >= ANGLES[0]) & (balls.launch_angle <= ANGLES[1])
    fields = fields_of(rows["home_team"] if "home_team" in rows.columns else [None] * len(rows), balls.season)
    airs = fields.airs(setting.air, rows)
    flown = flown_balls(balls, fields, setting, airs=airs)
    here &= np.isfinite(flown.launch_direction) & np.isfinite(flown.hang_time)
    if here.sum() < FEW:
        return None
    far, sinking = np.empty((2, len(rows)))
    for law, those in fields.laws(setting.aerodynamics):
        mine = those[here[those]]
        launch = usual_launch(
            balls.exit_speed[mine],
            balls.launch_angle[mine],
            flown.launch_direction[mine],
            left=balls.left[mine],
            line=setting.line,
        )
        conditions = FlightConditions(ball=setting.ball, aerodynamics=setting.dragged(law), air=airs.at(mine))
        paths = flights(launch, conditions, path_points=POINTS)
        far[mine] = _distance_at(measured[mine], paths.times, paths.positions)
        sinking[mine] = -paths.landing_velocity[:, 2]
    apart = far[here] - balls.distance[here]
    hang = flown.hang_time[here] - caught[here] * GLOVE / sinking[here] - measured[here]
    return HangCheck(
        int(here.sum()), float(hang.mean()), float(hang.std()), float(apart.mean()), float(apart.std()),
        _by_sixths(balls, here, apart),
    )  # fmt: skip


def _distance_at(time: Array, times: Array, positions: Array) -> Array:
    """Return how far over the ground balls are at a moment, m; after the landing as they went just before."""
    step = times[:, 1]
    low = np.clip((time / step).astype(np.int64), 0, times.shape[1] - 2)
    row = np.arange(len(time))
    part = (time / step - low)[:, None]
    place = positions[row, low] + part * (positions[row, low + 1] - positions[row, low])
    return np.asarray(np.hypot(place[:, 0], place[:, 1]))


def _by_sixths(balls: Balls, here: NDArray[np.bool_], apart: Array) -> tuple[float, ...]:
    pulled = np.where(balls.left, 1.0, -1.0)[here] * balls.bearing[here]
    edges = np.linspace(45, -45, 7) * DEGREE
    groups = [(pulled <= high) & (pulled > low) for high, low in pairwise(edges)]
    return tuple(float(apart[group].mean()) if group.sum() >= FEW else float("nan") for group in groups)
