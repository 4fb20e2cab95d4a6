"""The properties of a calibrated bat: weight, balance point, moment of inertia, moduli and density, with errors.

Each says where it comes from: a measurement that tells it by itself, the fit to all of them, or what was assumed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sweetspot.calibration.measured import CalibratedValue, Measured, ValueKind
from sweetspot.calibration.measurements import FACE_TONE, Measurement, predicted
from sweetspot.calibration.posterior import BatPosterior
from sweetspot.calibration.unknowns import OF_BALL, OF_PADDLE, Unknown, UnknownName, deviated
from sweetspot.catalog.files.implement import ClubHeadTable
from sweetspot.catalog.files.write import bat_table, implement_table, written
from sweetspot.catalog.records import TomlTable, TomlValue
from sweetspot.dynamics.beam import GRADIENT_LIMIT
from sweetspot.dynamics.rigid import moi_doubt, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS

INFORMATIVE = 0.7
"""Error after over before, below which the measurements are informative about an unknown (our choice)."""
MEASURING = {"mass": ("mass",), "balance_point": ("balance_point",), "moi": ("moi", "period")}
"""Kinds of measurement that measure a written property."""
STEP = 1e-3
"""Of an unknown's spread, in the derivatives of weight, balance point and moment of inertia."""


def properties(posterior: BatPosterior) -> dict[str, CalibratedValue]:
    """Return mass, balance point and moment of inertia about the swing axis, with errors of the whole posterior.

    A bat's moment of inertia that was not measured is in doubt by as much as outlines tell it, `moi_doubt`.
    """
    wanted = [
        Measurement("mass", Measured(1, 1)),
        Measurement("balance_point", Measured(1, 1)),
        Measurement("moi", Measured(1, 1), axis=posterior.beam.bat.swing_axis),
    ]
    values = predicted(posterior.beam, wanted)
    slopes = _slopes(posterior, wanted)
    errors = np.sqrt(np.einsum("ji,jk,ki->i", slopes, posterior.covariance, slopes))
    errors[2] = max(errors[2], _doubt_of_moi(posterior))
    not_measured = fitted_names(posterior)
    return {
        entry.kind: CalibratedValue(
            Measured(float(value), float(error)), "fitted" if entry.kind in not_measured else "measured"
        )
        for entry, value, error in zip(wanted, values, errors, strict=True)
    }


def fitted_names(posterior: BatPosterior) -> tuple[str, ...]:
    """Return those of a written weight, balance point and moment of inertia that no measurement gives by itself."""
    kinds = {measurement.kind for measurement in posterior.measurements}
    return tuple(name for name, measuring in MEASURING.items() if not kinds & set(measuring))


def _doubt_of_moi(posterior: BatPosterior) -> float:
    """Return one sigma of a moment of inertia that was not measured, kg m^2; see `moi_doubt`."""
    bat = posterior.beam.bat
    if not isinstance(bat, Bat):
        return 0.0
    body, not_measured = rigid_body(posterior.beam), fitted_names(posterior)
    as_kept = bat.replaced(
        balance_point=body.balance_point, moi=body.moi(STANDARD_AXIS), mass=body.mass, fitted=not_measured
    )
    return moi_doubt(as_kept, body, STANDARD_AXIS)


def _slopes(posterior: BatPosterior, wanted: Sequence[Measurement]) -> Array:
    """Return the derivatives of the wanted quantities with respect to every unknown, shape (unknowns, wanted)."""
    beam, unknowns = posterior.beam, posterior.unknowns
    steps = STEP * np.array([unknown.spread for unknown in unknowns])
    ahead, behind = (
        [predicted(deviated(beam, unknowns, way * step), wanted) for step in np.diag(steps)] for way in (1, -1)
    )
    return (np.array(ahead) - np.array(behind)) / (2 * steps[:, None])


def material_values(posterior: BatPosterior) -> dict[str, CalibratedValue]:
    """Return moduli and density of the calibrated bat; of a racket, club or stick the first frequency."""
    bat = posterior.beam.bat
    if isinstance(bat, Paddle):
        return _paddle_values(posterior, bat)
    if not isinstance(bat, Bat):
        frequency = bat.frequency
        assert frequency is not None  # guaranteed by as_described
        error = posterior.deviation("first_frequency").error
        rung = any(measurement.mode is not None for measurement in posterior.measurements)
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
            kind: ValueKind = "fitted" if error < INFORMATIVE * unknown.spread else "assumed"
            values[field] = CalibratedValue(Measured(value, value * error), kind)
    return values


def _paddle_values(posterior: BatPosterior, paddle: Paddle) -> dict[str, CalibratedValue]:
    """Return twist weight, core, and stiffness and tone of the face of a calibrated paddle."""
    unit = Measured(1, 1)
    wanted = {
        "twist_weight": Measurement("twist_weight", unit),
        "face_stiffness": Measurement("face_stiffness", unit),
        "face_tone": Measurement("frequency", unit, mode=FACE_TONE),
    }
    names = [unknown.name for unknown in posterior.unknowns]
    of_core = posterior.covariance[names.index("core_shear"), names.index("core_shear")] ** 0.5
    values, slopes = (
        predicted(posterior.beam, list(wanted.values())),
        _slopes(posterior, list(wanted.values())),
    )
    errors = np.sqrt(np.einsum("ji,jk,ki->i", slopes, posterior.covariance, slopes))
    given = {measurement.name for measurement in posterior.measurements}
    found = {
        name: CalibratedValue(
            Measured(float(value), float(error)), "measured" if measurement.name in given else "fitted"
        )
        for (name, measurement), value, error in zip(wanted.items(), values, errors, strict=True)
    }
    kind: ValueKind = "fitted" if of_core < INFORMATIVE * OF_PADDLE["core_shear"] else "assumed"
    found["core_shear"] = CalibratedValue(Measured(paddle.core_shear, paddle.core_shear * of_core), kind)
    return found


SOURCE = "own_measurement"
UNITS = {
    **{"mass": "kg", "balance_point": "m", "moi": "kg*m^2", "first_frequency": "Hz"},
    **{"longitudinal_modulus": "Pa", "shear_modulus": "Pa", "density": "kg/m^3", "core_shear": "Pa"},
}
"""Of the values that a calibrated file has."""


def calibrated_bat(posterior: BatPosterior, damping: Measured | None) -> Bat:
    """Return the most likely bat: its outline, material, weight, balance and moment of inertia are the fitted ones."""
    bat, gradient = posterior.beam.bat, posterior.beam.density_gradient
    assert isinstance(bat, Bat)  # only bats are calibrated
    if abs(gradient) > GRADIENT_LIMIT:
        raise InputError(
            f"{bat.name}: what was measured takes a density that {'grows' if gradient > 0 else 'falls'} by "
            f"{abs(gradient):.0%} from the middle to the tip; allowed is up to {GRADIENT_LIMIT:.0%}. Check whether the "
            "measurements are this bat's: weight, balance point and outline"
        )
    body = rigid_body(posterior.beam)
    material = bat.material.of_density(bat.material.density * posterior.beam.density_factor)
    if damping is not None:
        material = material.replaced(damping_ratio=damping.value)
    return bat.replaced(
        name=f"{bat.name}, calibrated",
        material=material,
        mass=body.mass,
        balance_point=body.balance_point,
        moi=body.moi(STANDARD_AXIS),
        moi_axis=STANDARD_AXIS,
        fitted=fitted_names(posterior),
        density_gradient=gradient,
        calibrated=True,
    )


def calibrated_table(posterior: BatPosterior, damping: Measured | None) -> TomlTable:
    """Return the content of a bat file with half widths of 90 % intervals, and the covariance of the unknowns."""
    if not isinstance(posterior.beam.bat, Bat):
        return _implement_table(posterior, damping)
    table = dict(bat_table(calibrated_bat(posterior, damping)))
    for name, found in properties(posterior).items():
        table[name] = _record(table[name], found, UNITS[name])
    wood = table["material"]
    material: dict[str, TomlValue] = dict(wood) if isinstance(wood, Mapping) else {"like": wood}
    for name, found in material_values(posterior).items():
        material[name] = _record(material.get(name, f"{found.value.value!r} {UNITS[name]}"), found, UNITS[name])
    if damping is not None:
        material["damping_ratio"] = _record(damping.value, CalibratedValue(damping, "measured"), "")
    return {**table, "material": material, "calibration": _calibration_table(posterior)}


def _calibration_table(posterior: BatPosterior) -> TomlTable:
    """Return the measurements and the covariance of the unknowns, but the ball's: it belongs to the balls shot."""
    of_bat = [index for index, entry in enumerate(posterior.unknowns) if entry.name != OF_BALL]
    values: list[TomlValue] = []
    for measurement in posterior.measurements:
        if measurement.shooting is None:
            value: dict[str, TomlValue] = {"quantity": measurement.kind, "measured": measurement.value.value}
            value["error"] = measurement.value.error
            if measurement.kind in ("moi", "period"):
                value["axis"] = measurement.axis
            if measurement.mode is not None:
                value |= {"family": measurement.mode.family, "harmonic": measurement.mode.harmonic}
            values.append(value)
    return {
        "measured": [measurement.name for measurement in posterior.measurements],
        "value": values,
        "unknowns": [posterior.unknowns[index].name for index in of_bat],
        "covariance": posterior.covariance[np.ix_(of_bat, of_bat)].tolist(),
    }


def _implement_table(posterior: BatPosterior, damping: Measured | None) -> TomlTable:
    """Return the content of the file of a racket, club or stick; a club has head and grip for its weight."""
    implement = posterior.beam.bat
    fitted = [name for name in fitted_names(posterior) if getattr(implement, name) is not None]
    named = implement.replaced(name=f"{implement.name}, calibrated", fitted=tuple(fitted))
    table = dict(implement_table(named))
    for name, found in {**properties(posterior), **material_values(posterior)}.items():
        if name in table:
            table[name] = _record(f"{found.value.value!r} {UNITS[name]}", found, UNITS[name])
    if damping is not None and "damping" in table:
        table["damping"] = _record(damping.value, CalibratedValue(damping, "measured"), "")
    if isinstance(implement, GolfClub):
        weights = (("end_mass", implement.head.mass), ("knob_mass", implement.grip_mass))
        masses = [Measured(mass, mass * posterior.deviation(name).error) for name, mass in weights]
        head, grip = (_record(f"{mass.value!r} kg", CalibratedValue(mass, "fitted"), "kg") for mass in masses)
        of_head = written(ClubHeadTable, implement.head, implement.head.face)
        table |= {"head": {**of_head, "mass": head}, "grip_mass": grip}
    return {**table, "calibration": _calibration_table(posterior)}


def _record(written: TomlValue, value: CalibratedValue, unit: str) -> TomlTable:
    half = value.value.half_width
    spread = f"{half:.6g} {unit}" if unit else float(f"{half:.6g}")
    where = "`sweetspot calibrate`: half width of the 90 % interval"
    return {"value": written, "spread": spread, "source": SOURCE, "where": where, "kind": value.kind}


def known_deviations(table: Mapping[str, Any]) -> tuple[tuple[Unknown, ...], Array] | None:
    """Return the unknowns and their covariance that a bat file's table holds; None: it was not calibrated."""
    calibration = table.get("calibration")
    if calibration is None:
        return None
    covariance = np.array(calibration["covariance"], float)
    names: list[UnknownName] = calibration["unknowns"]
    spreads = np.sqrt(np.diag(covariance))
    return tuple(Unknown(name, float(spread)) for name, spread in zip(names, spreads, strict=True)), covariance
