"""The unknowns of an implement, by the independent numbers behind it: a changed one shares those of its parent.

A bat and the same bat with tape on it are one piece of wood. Whatever that is, it is in both, and most of it cancels
where they are compared. So what is not known is that of the piece at the beginning, after what was measured on it. What
was measured anew on a changed one takes the place of what the piece says: with H the slope of the measured values by
the deviations x of the piece, C their covariance and e the new errors, its deviations are x + G (e - H x), with
G = C H^T (H C H^T)^-1, so that its own values are off by e and all else stays as it goes with x.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import MeasuredKind, Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import Unknown, as_described, described, deviated, unknowns_of
from sweetspot.catalog.bats import other_files
from sweetspot.catalog.implements import implement
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.rigid import moi_doubt, outline_doubts, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS

USUAL: Mapping[MeasuredKind, float] = {"mass": 0.003, "moi": 0.01, "frequency": 0.03}
BALANCED = 0.0025
"""One sigma of a weight, a moment of inertia and a first frequency, as parts of them, and of a balance point in m, that
are given without an error: 0.1 oz of 31, 1 %, 3 %, 0.1 in (assumed; a frequency may come from a shop's stiffness)."""
WRITTEN: tuple[MeasuredKind, ...] = ("mass", "balance_point", "moi", "frequency")
"""What a file can say that was measured."""
STEP = 0.05
"""Of a spread, in the differences by which measured values go with deviations."""
Known = tuple[Sequence[Unknown], Array]
"""Unknowns of an implement, and their covariance."""


@dataclass(frozen=True)
class ImplementDoubt:
    """What is not known of an implement.

    ``factor``: of the deviations by independent standard normal numbers, shape (unknowns, numbers). ``behind``: whose
    each of these numbers is; implements that share one are off alike by it.
    """

    unknowns: tuple[Unknown, ...]
    factor: Array
    behind: tuple[Hashable, ...]

    @property
    def covariance(self) -> Array:
        """Of the deviations, shape (unknowns, unknowns)."""
        return np.asarray(self.factor @ self.factor.T)


NO_DOUBT = ImplementDoubt((), np.zeros((0, 0)), ())
"""An implement that is just as described."""


def doubt_of(tool: Implement, calibration: Known | None = None) -> ImplementDoubt:
    """Return the unknowns of an implement.

    ``calibration``: of the piece that it was made from, as `sweetspot calibrate` left it; None: what the catalogue
    allows for its kind, after the weight, balance point and moment of inertia in its file.
    """
    *changed, piece = tool.lineage()
    unknowns, covariance = expected_deviations(piece) if calibration is None else calibration
    doubt = doubt_of_piece(piece, *_with_outline(piece, unknowns, covariance))
    for each in reversed(changed):
        doubt = _measured_anew(doubt, each)
    return doubt


def doubt_of_piece(piece: Hashable, unknowns: Sequence[Unknown], covariance: Array) -> ImplementDoubt:
    """Return the unknowns of a piece from the covariance of its deviations."""
    covariance = np.asarray(covariance, dtype=np.float64)
    values, vectors = np.linalg.eigh(covariance)
    whose = (piece, tuple(unknowns), covariance.tobytes())
    behind = tuple((whose, index) for index in range(len(unknowns)))
    return ImplementDoubt(tuple(unknowns), vectors * np.sqrt(np.maximum(values, 0.0)), behind)


def _measured_anew(doubt: ImplementDoubt, tool: Implement) -> ImplementDoubt:
    """Return the doubt of an implement that was changed from one of this doubt, after what was measured on it."""
    given = written(tool)
    if not given or not doubt.unknowns:
        return doubt
    before = values_by_numbers(doubt, beam_of(tool), given)
    gain = doubt.factor @ np.linalg.pinv(before, rcond=1e-9)
    errors = gain * np.array([each.error for each in given])
    behind = (*doubt.behind, *((tool, each.name) for each in given))
    return ImplementDoubt(doubt.unknowns, np.hstack([doubt.factor - gain @ before, errors]), behind)


def beam_of(tool: Implement) -> BeamModel:
    """Return the beam that the deviations of an implement are counted from."""
    return beam_model(tool) if isinstance(tool, Bat) else as_described(tool)


def values_by_numbers(doubt: ImplementDoubt, beam: BeamModel, measurements: Sequence[Measurement]) -> Array:
    """Return the slopes of measured values by the numbers behind a doubt, shape (measurements, numbers)."""
    steps = STEP * np.diag(np.sqrt(np.diag(doubt.covariance)))

    def values(deviations: Array) -> Array:
        return predicted(deviated(beam, doubt.unknowns, deviations), measurements)

    sizes = np.maximum(np.diag(steps), 1e-12)
    slopes = np.array([(values(step) - values(-step)) / (2 * size) for step, size in zip(steps, sizes, strict=True)]).T
    return np.asarray(slopes @ doubt.factor)


def _with_outline(bat: Implement, unknowns: Sequence[Unknown], covariance: Array) -> tuple[tuple[Unknown, ...], Array]:
    """Return unknowns and covariance with what a bat's outline leaves open of a moment that was not measured.

    Nothing but the outline tells the radius of gyration about the balance point, and the balance point itself where
    that was not measured either: then it is off by so much that both together are the doubt of `moi_doubt`.
    """
    if not isinstance(bat, Bat) or bat.is_measured("moi") or not unknowns:
        return tuple(unknowns), covariance
    of_centre, _ = outline_doubts(bat)
    more = [Unknown("gyration", of_centre / 2)]
    if not bat.is_measured("balance_point"):
        body = rigid_body(beam_model(bat))
        rest = moi_doubt(bat, body, STANDARD_AXIS) ** 2 - (of_centre * body.moi_cm) ** 2
        moved = max(rest, 0.0) ** 0.5 / (2 * body.mass * (body.balance_point - STANDARD_AXIS))  # I_cm + M (x - axis)^2
        more.append(Unknown("balance_point", moved / body.balance_point))
    spreads = [unknown.spread for unknown in more]
    return (*unknowns, *more), np.pad(covariance, (0, len(more))) + np.diag([*np.zeros(len(unknowns)), *spreads]) ** 2


def expected_deviations(bat: Implement) -> tuple[tuple[Unknown, ...], Array]:
    """Return the unknowns of an uncalibrated bat, given the measurements in its file.

    What is laid up of plies has none: its doubt is not modelled.
    """
    try:
        unknowns = unknowns_of(bat)
    except InputError:
        return (), np.zeros((0, 0))
    given = written(bat)
    if not given:
        return unknowns, np.diag([unknown.spread**2 for unknown in unknowns])
    return unknowns, calibrate(described(bat), unknowns, given).covariance


def written(tool: Implement) -> list[Measurement]:
    """Return the measurements in a file that were made on the implement itself, not on the one it was changed from.

    Of a racket, club or stick the catalogue's own values were not measured.
    """
    others = () if isinstance(tool, Bat) else map(implement, other_files())
    usual = tool.original or next((other for other in others if other.sport == tool.sport), None)
    values = {
        name: None
        if name in tool.fitted or (usual and getattr(tool, name) == getattr(usual, name))
        else getattr(tool, name)
        for name in WRITTEN
    }
    return [usual_measurement(tool, name, value) for name, value in values.items() if value is not None]


def usual_measurement(tool: Implement, kind: MeasuredKind, value: float) -> Measurement:
    """Return a value in SI, measured on an implement as well as people usually can."""
    if kind == "balance_point":
        return Measurement(kind, Measured(value, BALANCED))
    mode = ModeName("bending", 1) if kind == "frequency" else None
    return Measurement(kind, Measured(value, USUAL[kind] * value), axis=tool.moi_axis, mode=mode)
