"""Compute every case and judge it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, RPM, Kind
from sweetspot.validation.cases import CASES, Case, Row, sources
from sweetspot.validation.computations.registry import COMPUTATIONS
from sweetspot.validation.result import Result

UNITS = {
    "": 1.0, "%": 0.01, "m": 1.0, "cm": 0.01, "in": INCH, "ft": FOOT, "cm^3": 1e-6, "kg": 1.0, "oz": OUNCE,
    "kg m^2": 1.0, "kg cm^2": 1e-4, "m/s": 1.0, "yd": 3 * FOOT, "s": 1.0,
    "oz in^2": OUNCE_INCH_SQUARED, "mph": MPH, "rad/s": 1.0, "ms": 1e-3, "Hz": 1.0, "ft/s^2": FOOT, "kg/m^3": 1.0,
    "kN": 1e3, "rpm": RPM, "rpm/deg": RPM / DEGREE, "deg": DEGREE, "GPa": 1e9, "mph per mph": 1.0,
}  # fmt: skip
"""Units of printed values, each in SI."""

INPUT_KINDS: dict[str, Kind] = {
    "ball_speed": "speed", "bat_speed": "speed", "exit_speed": "speed", "speed": "speed", "other_speed": "speed",
    "closing_speed": "speed", "efficiency": "ratio", "besr": "ratio", "restitution": "ratio", "recoil": "ratio",
    "bat_restitution": "ratio", "ball_restitution": "ratio", "share": "ratio", "within": "ratio",
    "length": "length", "pivot": "length", "axis": "length", "from_tip": "length", "distance": "length",
    "measured_at": "length", "bore_diameter": "length", "bore_depth": "length", "plug": "length",
    "balance_point": "length", "mass": "mass", "ball_mass": "mass", "added_mass": "mass",
    "moi": "moi", "other_moi": "moi", "contact_time": "time",
    "launch_angle": "angle", "backspin": "angular speed", "deflection": "angle", "other_deflection": "angle",
    "spray": "angle", "sidespin": "angular speed", "temperature": "temperature", "humidity": "ratio",
    "elevation": "length", "wind_speed": "speed", "wind_direction": "angle", "height": "length", "time": "time",
    "diameter": "length", "thinner": "length", "wall": "length",
    "modulus": "pressure", "frequency": "frequency", "bar_length": "length", "bar_width": "length",
    "bar_thickness": "length", "bar_mass": "mass",
    "inward": "length", "outward": "length", "density": "density", "poisson_ratio": "ratio",
}  # fmt: skip
"""What the inputs of computations are; inputs with other names (bats, mode numbers) are passed on as they stand."""


def results(folder: Path = CASES) -> tuple[Result, ...]:
    """Return every published case computed and judged, source by source."""
    return tuple(judged(row, case) for case in sources(folder) for row in case.rows)


def passed(verdicts: Iterable[Result]) -> bool:
    """Return whether nothing missed but as explained."""
    return all(result.passed for result in verdicts)


def judged(row: Row, case: Case) -> Result:
    """Compute one row and compare it with what is printed."""
    if row.computation not in COMPUTATIONS:
        raise InputError(f"{case.source}, {row.name}: no computation {row.computation!r}")
    if row.unit not in UNITS:
        raise InputError(f"{case.source}, {row.name}: unit {row.unit!r} is not one of {', '.join(UNITS)}")
    inputs = {name: _in_si(name, value) for name, value in row.inputs.items()}
    computed = COMPUTATIONS[row.computation](**inputs) / UNITS[row.unit]
    low, high = row.allowed
    return Result(
        source=case.source,
        name=row.name,
        quantity=row.quantity,
        printed=row.printed,
        computed=computed,
        unit=row.unit,
        tolerance=tolerance_text(row),
        reason=row.reason,
        kind=row.kind,
        tag=row.tag,
        ok=bool(low <= computed <= high),
        comment=row.comment,
        evidence=row.evidence,
        expected_miss=row.expected_miss,
        ours=row.ours,
        ours_tolerance=row.ours_tolerance,
    )


def tolerance_text(row: Row) -> str:
    """Return what is allowed in words: ``± 0.5 %`` or ``4 to 6, ± 0.5``."""
    slack = f"± {row.tolerance_percent:g} %" if row.tolerance_percent else f"± {row.tolerance:g}"
    if row.value is not None:
        return slack
    band = f"{row.low:g} to {row.high:g}"
    return f"{band}, {slack}" if row.tolerance else band


def _in_si(name: str, value: Any) -> Any:
    return parse(value, INPUT_KINDS[name], name) if name in INPUT_KINDS else value
