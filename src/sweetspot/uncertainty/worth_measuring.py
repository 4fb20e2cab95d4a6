"""What to measure on an implement so that an answer becomes surer: how much of its doubt each measurement would leave.

With z the independent standard normal numbers behind the implement's deviations, an answer off by g z, and measured
values off by A z + e with errors e of covariance E, the variance that a measurement leaves is
g g^T - (A g^T)^T (A A^T + E)^-1 (A g^T): what a linear answer keeps once z is known from the measured values.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.measurements import MeasuredKind
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.implement_doubt import ImplementDoubt, beam_of, usual_measurement, values_by_numbers, written

WORKSHOP: tuple[tuple[MeasuredKind, ...], ...] = (("mass",), ("mass", "balance_point"), ("mass", "moi"))
"""What people can measure with a scale, an edge and a stopwatch, the least work first; a balance point or a moment of
inertia needs the weight too."""


@dataclass(frozen=True)
class Narrowing:
    """What one standard deviation of an answer becomes once these are measured."""

    measured: tuple[MeasuredKind, ...]
    error: float


def narrowings(tool: Implement, doubt: ImplementDoubt, *, slopes: Array, others: float) -> tuple[Narrowing, ...]:
    """Return the measurements that an implement still lacks and what they would leave of an answer, least work first.

    Parameters
    ----------
    slopes : of the answer by the numbers behind the implement's doubt, shape (numbers,).
    others : standard deviation of the answer by all else.
    """
    return tuple(_narrowings(tool, doubt, slopes=slopes, others=others))


def _narrowings(tool: Implement, doubt: ImplementDoubt, *, slopes: Array, others: float) -> Iterator[Narrowing]:
    if not doubt.unknowns:
        return
    in_file = {each.kind for each in written(tool)}
    missing = [kind for kind in dict.fromkeys(kind for kinds in WORKSHOP for kind in kinds) if kind not in in_file]
    if not missing:
        return
    beam = beam_of(tool)
    body = rigid_body(beam)
    values = {"mass": body.mass, "balance_point": body.balance_point, "moi": body.moi(tool.moi_axis)}
    measurements = [usual_measurement(tool, kind, values[kind]) for kind in missing]
    by_numbers = values_by_numbers(doubt, beam, measurements)
    errors = np.array([each.error for each in measurements])
    tried: set[Sequence[MeasuredKind]] = set()
    for kinds in WORKSHOP:
        new = tuple(kind for kind in kinds if kind in missing)
        if new and new not in tried:
            tried.add(new)
            rows = [missing.index(kind) for kind in new]
            seen = by_numbers[rows]
            about = seen @ slopes
            learned = float(about @ np.linalg.solve(seen @ seen.T + np.diag(errors[rows] ** 2), about))
            yield Narrowing(new, float(np.hypot(max(float(slopes @ slopes) - learned, 0.0) ** 0.5, others)))
