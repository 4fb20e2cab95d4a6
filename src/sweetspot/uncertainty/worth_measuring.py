"""What to measure on an implement so that an answer becomes surer: how much of its doubt each measurement would leave.

With z the independent standard normal numbers behind the implement's deviations, an answer off by g z, and measured
values off by A z + e with errors e of covariance E, the variance that a measurement leaves is
g g^T - (A g^T)^T (A A^T + E)^-1 (A g^T): what a linear answer keeps once z is known from the measured values.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.measurements import MeasuredKind, Measurement
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.uncertainty.implement_doubt import ImplementDoubt, beam_of, usual_measurement, values_by_numbers, written

WORKSHOP: tuple[tuple[MeasuredKind, ...], ...] = (("mass",), ("mass", "balance_point"), ("mass", "moi"))
"""What people can measure with a scale, an edge and a stopwatch, the least work first; a balance point or a moment of
inertia needs the weight too."""


@dataclass(frozen=True)
class Narrowing:
    """What one standard deviation of an answer becomes once these are measured.

    ``of``: the implements that lack any of them, by their number.
    """

    measured: tuple[MeasuredKind, ...]
    of: tuple[int, ...]
    error: float


def narrowings(
    implements: Sequence[tuple[Implement, ImplementDoubt]], slopes: Mapping[Hashable, float], *, others: float
) -> tuple[Narrowing, ...]:
    """Return the measurements that implements still lack and what they would leave of an answer, least work first.

    Parameters
    ----------
    implements : with what is not known of them.
    slopes : of the answer by the numbers behind these doubts.
    others : standard deviation of the answer by all else.
    """
    steep, columns = np.array(list(slopes.values())), {number: column for column, number in enumerate(slopes)}
    beams = [beam_of(tool) if doubt.unknowns else None for tool, doubt in implements]
    lacking = [[] if beam is None else _lacking(tool, beam) for beam, (tool, _) in zip(beams, implements, strict=True)]
    rows, errors, whose = [], [], []
    for number, ((_, doubt), beam, measurements) in enumerate(zip(implements, beams, lacking, strict=True)):
        if beam is not None and measurements:
            row = np.zeros((len(measurements), len(columns)))
            row[:, [columns[each] for each in doubt.behind]] = values_by_numbers(doubt, beam, measurements)
            rows.append(row)
            errors += [each.error for each in measurements]
            whose += [(number, each.kind) for each in measurements]
    if not rows:
        return ()
    by_numbers, found = np.vstack(rows), dict[tuple[tuple[int, MeasuredKind], ...], Narrowing]()
    for kinds in WORKSHOP:
        new = tuple(each for each in whose if each[1] in kinds)
        chosen = [whose.index(each) for each in new]
        seen, about = by_numbers[chosen], by_numbers[chosen] @ steep
        learned = float(about @ np.linalg.solve(seen @ seen.T + np.diag(np.array(errors)[chosen] ** 2), about))
        error = float(np.hypot(max(float(steep @ steep) - learned, 0.0) ** 0.5, others))
        measured = tuple(kind for kind in kinds if any(kind == each for _, each in new))
        if new:
            found.setdefault(new, Narrowing(measured, tuple(sorted({number for number, _ in new})), error))
    return tuple(found.values())


def _lacking(tool: Implement, beam: BeamModel) -> list[Measurement]:
    """Return the measurements that a workshop can make and that an implement's file does not have."""
    in_file = {each.kind for each in written(tool)}
    kinds = [kind for kind in dict.fromkeys(kind for kinds in WORKSHOP for kind in kinds) if kind not in in_file]
    if not kinds:
        return []
    body = rigid_body(beam)
    values = {"mass": body.mass, "balance_point": body.balance_point, "moi": body.moi(tool.moi_axis)}
    return [usual_measurement(tool, kind, values[kind]) for kind in kinds]
