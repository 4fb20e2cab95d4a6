"""Compute every case and judge it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, RPM, Kind
from sweetspot.validation.cases import CASES, Case, Result, Row, sources
from sweetspot.validation.computations.registry import COMPUTATIONS

UNITS = {
    "": 1.0, "%": 0.01, "m": 1.0, "cm": 0.01, "in": INCH, "ft": FOOT, "cm^3": 1e-6, "kg": 1.0, "oz": OUNCE,
    "kg m^2": 1.0, "kg cm^2": 1e-4, "m/s": 1.0, "yd": 3 * FOOT, "s": 1.0,
    "oz in^2": OUNCE_INCH_SQUARED, "mph": MPH, "rad/s": 1.0, "ms": 1e-3, "Hz": 1.0, "ft/s^2": FOOT, "kg/m^3": 1.0,
    "kN": 1e3, "rpm": RPM, "rpm/deg": RPM / DEGREE, "deg": DEGREE, "GPa": 1e9, "mph per mph": 1.0,
}  # fmt: skip
"""Units of printed values, each in SI."""

NAMES_OF_INPUTS: dict[Kind, str] = {
    "speed": "ball_speed bat_speed exit_speed speed other_speed closing_speed wind_speed",
    "ratio": "efficiency besr restitution recoil bat_restitution ball_restitution share within humidity poisson_ratio",
    "length": "length pivot axis from_tip distance measured_at bore_diameter bore_depth plug balance_point elevation "
    "height diameter thinner wall bar_length bar_width bar_thickness inward outward",
    "mass": "mass ball_mass added_mass bar_mass",
    "moi": "moi other_moi",
    "time": "contact_time time",
    "angle": "launch_angle deflection other_deflection spray wind_direction",
    "angular speed": "backspin sidespin",
    "temperature": "temperature",
    "pressure": "modulus",
    "frequency": "frequency",
    "density": "density",
}
INPUT_KINDS: dict[str, Kind] = {name: kind for kind, names in NAMES_OF_INPUTS.items() for name in names.split()}
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
