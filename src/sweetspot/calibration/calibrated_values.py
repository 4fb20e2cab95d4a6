"""What a calibrated bat is: weight, balance point, moment of inertia, moduli and density, each with its error.

Each says where it comes from: a measurement that tells it by itself, the fit to all of them, or what was assumed.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sweetspot.calibration.deviation_batch import deviated_bodies
from sweetspot.calibration.measured import CalibratedValue, Measured, ValueKind
from sweetspot.calibration.measurements import Measurement, predicted, said_of_body
from sweetspot.calibration.posterior import Posterior
from sweetspot.calibration.unknowns import deviated
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS

TOLD = 0.7
"""Error after over before, below which measurements have told something about an unknown (our choice)."""
MEASURING = {"mass": ("mass",), "balance_point": ("balance_point",), "moi": ("moi", "period")}
"""Kinds of measurement that measure a written property."""
STEP = 1e-3
"""Of an unknown's spread, in the derivatives of weight, balance point and moment of inertia."""


def properties(posterior: Posterior) -> dict[str, CalibratedValue]:
    """Return mass, balance point and moment of inertia about the swing axis, with errors of the whole posterior.

    A bat's moment of inertia that was not measured is in doubt by as much as outlines tell it, `moi_doubt`.
    """
    wanted = [Measurement("mass", Measured(1, 1)), Measurement("balance_point", Measured(1, 1)),
              Measurement("moi", Measured(1, 1), axis=posterior.beam.bat.swing_axis)]  # fmt: skip
    values = predicted(posterior.beam, wanted)
    slopes = _slopes(posterior, wanted)
    errors = np.sqrt(np.einsum("ji,jk,ki->i", slopes, posterior.covariance, slopes))
    errors[2] = max(errors[2], _doubt_of_moi(posterior))
    not_measured = fitted_names(posterior)
    return {
        one.kind: CalibratedValue(
            Measured(float(value), float(error)), "fitted" if one.kind in not_measured else "measured"
        )
        for one, value, error in zip(wanted, values, errors, strict=True)
    }


def fitted_names(posterior: Posterior) -> tuple[str, ...]:
    """Return which of a written weight, balance point and moment of inertia no measurement tells by itself."""
    kinds = {one.kind for one in posterior.measurements}
    return tuple(name for name, measuring in MEASURING.items() if not kinds & set(measuring))


def _doubt_of_moi(posterior: Posterior) -> float:
    """Return by how much the moment of inertia may be off that was not measured, kg m^2; see `moi_doubt`."""
    own = posterior.beam.bat
    if not isinstance(own, Bat):
        return 0.0
    body, not_measured = rigid_body(posterior.beam), fitted_names(posterior)
    as_kept = own.replaced(
        balance_point=body.balance_point, moi=body.moi(STANDARD_AXIS), mass=body.mass, fitted=not_measured
    )
    return moi_doubt(as_kept, body, STANDARD_AXIS)


def _slopes(posterior: Posterior, wanted: Sequence[Measurement]) -> Array:
    """Return what every unknown changes of what is wanted, shape (unknowns, wanted)."""
    beam, unknowns = posterior.beam, posterior.unknowns
    steps = STEP * np.array([one.spread for one in unknowns])
    places = np.vstack([np.diag(steps), -np.diag(steps)])
    bodies = deviated_bodies(beam, unknowns, places)
    if bodies is None:
        said = np.array([predicted(deviated(beam, unknowns, place), wanted) for place in places])
    else:
        said = np.array([[said_of_body(body, one) for one in wanted] for body in bodies])
    ahead, behind = np.split(said, 2)
    return np.asarray((ahead - behind) / (2 * steps[:, None]))


def material_values(posterior: Posterior) -> dict[str, CalibratedValue]:
    """Return moduli and density of the calibrated bat; of a racket, club or stick the first frequency."""
    bat = posterior.beam.bat
    if not isinstance(bat, Bat):
        frequency = bat.frequency
        assert frequency is not None  # guaranteed by implement_unknowns
        error = posterior.deviation("first_frequency").error
        rung = any(one.mode is not None for one in posterior.measurements)
        return {
            "first_frequency": CalibratedValue(
                Measured(frequency, frequency * error), "measured" if rung else "assumed"
            )
        }
    centre = {
        "modulus": ("longitudinal_modulus", bat.material.longitudinal_modulus),
        "shear_modulus": ("shear_modulus", bat.material.shear),
        "density": ("density", bat.material.density * posterior.beam.density_factor),
    }
    values = {}
    for unknown in posterior.unknowns:
        if unknown.name in centre:
            field, value = centre[unknown.name]
            error = posterior.deviation(unknown.name).error
            told: ValueKind = "fitted" if error < TOLD * unknown.spread else "assumed"
            values[field] = CalibratedValue(Measured(value, value * error), told)
    return values
