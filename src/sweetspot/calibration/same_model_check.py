"""Checks that the measurements of a bat are plausible for the model given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sweetspot.calibration.measurements import Measurement
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import pendulum_period, rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.plausibility import insisted
from sweetspot.plausibility.implements import SAME_MODEL


def check_same_model(
    bats: Mapping[str, Sequence[Measurement]], model: Implement, *, axis: float = STANDARD_AXIS
) -> None:
    """Refuse measurements that no bat of a model comes near: in another unit, or in another column.

    ``axis``: m from the knob end, of moments of inertia and pendulums.
    """
    beam = beam_model(model)
    body, modes = rigid_body(beam), bending_modes(beam)
    of_model: dict[str, float] = {
        "mass": body.mass,
        "balance_point": body.balance_point,
        "moi": body.moi(axis),
        "period": pendulum_period(body.moi(axis), mass=body.mass, balance_point=body.balance_point, pivot=axis),
    }
    bending = [float(modes.frequency[index]) for index in modes.of_family("bending")]
    for name, measured in bats.items():
        for measurement in measured:
            mode = measurement.mode
            expected = of_model.get(measurement.kind)
            if mode is not None:
                modelled = mode.family == "bending" and mode.harmonic <= len(bending)
                expected = bending[mode.harmonic - 1] if modelled else None
            if expected is None or insisted():
                continue
            factor = measurement.value.value / expected
            if not 1 / SAME_MODEL[measurement.kind] < factor < SAME_MODEL[measurement.kind]:
                what = str(mode) if mode is not None else measurement.kind.replace("_", " ")
                raise InputError(
                    f"{name}: the {what} is {factor:.3g} times that of {model.name}; bats of one model come within a "
                    f"factor of {SAME_MODEL[measurement.kind]:g}. Check the unit and the column, or add --force if it "
                    "is meant"
                )
