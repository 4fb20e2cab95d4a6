"""A calibrated bat as a bat file: every value with its interval, and whether it was measured, fitted or assumed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from sweetspot.calibration.calibrated_values import fitted_names, material_values, properties
from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.posterior import OF_BALL, Posterior
from sweetspot.calibration.unknowns import Unknown, UnknownName
from sweetspot.catalog.files.write import bat_table
from sweetspot.catalog.files.write_implement import implement_table
from sweetspot.dynamics.beam import GRADIENT_LIMIT
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS

SOURCE = "own_measurement"


def calibrated_bat(posterior: Posterior, damping: Measured | None) -> Bat:
    """Return the most likely bat: its outline, material, weight, balance and moment of inertia are the fitted ones.

    Raises
    ------
    InputError
        where its density would have to change along it more than any bat's does.
    """
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
        name=f"{bat.name}, calibrated", material=material, mass=body.mass, balance_point=body.balance_point,
        moi=body.moi(STANDARD_AXIS), moi_axis=STANDARD_AXIS, fitted=fitted_names(posterior), density_gradient=gradient,
        calibrated=True,
    )  # fmt: skip


def calibrated_table(posterior: Posterior, damping: Measured | None) -> dict[str, Any]:
    """Return the content of a bat file with half widths of 90 % intervals, and the covariance of what is not known."""
    if not isinstance(posterior.beam.bat, Bat):
        return _implement_table(posterior, damping)
    table = bat_table(calibrated_bat(posterior, damping))
    units = {"mass": "kg", "balance_point": "m", "moi": "kg*m^2"}
    for name, one in properties(posterior).items():
        table[name] = _record(table[name], one, units[name])
    material = table["material"] if isinstance(table["material"], dict) else {"like": table["material"]}
    units = {"longitudinal_modulus": "Pa", "shear_modulus": "Pa", "density": "kg/m^3"}
    for name, one in material_values(posterior).items():
        written = material.get(name, f"{one.value.value!r} {units[name]}")
        material[name] = _record(written, one, units[name])
    if damping is not None:
        material["damping_ratio"] = _record(damping.value, CalibratedValue(damping, "measured"), "")
    table["material"] = material
    return {**table, "calibration": _calibration_table(posterior)}


def _calibration_table(posterior: Posterior) -> dict[str, Any]:
    """Return what a file keeps of a calibration: what was measured, and the covariance of what is not known of the bat.

    The ball's part is left out: it belongs to the balls that were shot.
    """
    own = [index for index, one in enumerate(posterior.unknowns) if one.name != OF_BALL]
    return {
        "measured": [one.name for one in posterior.measurements],
        "value": [_measurement_table(one) for one in posterior.measurements if one.shooting is None],
        "unknowns": [posterior.unknowns[index].name for index in own],
        "covariance": posterior.covariance[np.ix_(own, own)].tolist(),
    }


def _measurement_table(one: Measurement) -> dict[str, Any]:
    """Return a measurement as a file has it; see `bat_folder.measured_of`."""
    of_mode = {} if one.mode is None else {"family": one.mode.family, "harmonic": one.mode.harmonic}
    of_axis = {"axis": one.axis} if one.kind in ("moi", "period") else {}
    return {"quantity": one.kind, "measured": one.value.value, "error": one.value.error, **of_axis, **of_mode}


def _implement_table(posterior: Posterior, damping: Measured | None) -> dict[str, Any]:
    """Return the content of the file of a racket, club or stick; a club has head and grip for its weight."""
    own = posterior.beam.bat
    table = implement_table(own.replaced(name=f"{own.name}, calibrated", fitted=fitted_names(posterior)))
    units = {"mass": "kg", "balance_point": "m", "moi": "kg*m^2", "first_frequency": "Hz"}
    for name, one in {**properties(posterior), **material_values(posterior)}.items():
        if name in table:
            table[name] = _record(f"{one.value.value!r} {units[name]}", one, units[name])
    if damping is not None and "damping" in table:
        table["damping"] = _record(damping.value, CalibratedValue(damping, "measured"), "")
    if isinstance(own, GolfClub):
        for holder, name, unknown in ((table["head"], "mass", "end_mass"), (table, "grip_mass", "knob_mass")):
            mass = own.head.mass if name == "mass" else own.grip_mass
            error = mass * posterior.deviation(unknown).error
            holder[name] = _record(f"{mass!r} kg", CalibratedValue(Measured(mass, error), "fitted"), "kg")
    return {**table, "calibration": _calibration_table(posterior)}


def _record(written: Any, value: CalibratedValue, unit: str) -> dict[str, Any]:
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
