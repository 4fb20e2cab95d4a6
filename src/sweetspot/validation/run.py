"""Compute every case and judge it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields
from operator import attrgetter
from pathlib import Path
from typing import Any

from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, RPM, Kind
from sweetspot.validation.cases import CASES, Case, Result, Row, sources
from sweetspot.validation.computations.registry import COMPUTATIONS

UNITS = dict.fromkeys(("", "m", "kg", "kg m^2", "m/s", "s", "rad/s", "Hz", "kg/m^3", "mph per mph"), 1.0)
UNITS |= {"%": 0.01, "cm": 0.01, "in": INCH, "ft": FOOT, "yd": 3 * FOOT, "cm^3": 1e-6, "ft/s^2": FOOT, "mph": MPH}
UNITS |= {"oz": OUNCE, "kg cm^2": 1e-4, "oz in^2": OUNCE_INCH_SQUARED, "ms": 1e-3, "kN": 1e3, "GPa": 1e9}
UNITS |= {"rpm": RPM, "rpm/deg": RPM / DEGREE, "deg": DEGREE}
"""Units of printed values, each in SI."""

_INPUTS: dict[Kind, str] = {
    "speed": "ball_speed bat_speed exit_speed speed other_speed closing_speed wind_speed faster",
    "ratio": "efficiency besr restitution recoil bat_restitution ball_restitution share humidity poisson_ratio",
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
INPUT_KINDS = {name: kind for kind, names in _INPUTS.items() for name in names.split()}
"""What the inputs of computations are; inputs with other names (bats, mode numbers) are passed on as they stand."""


SHARED = {part.name for part in fields(Row)} & {part.name for part in fields(Result)} - {"tolerance"}


def results(folder: Path = CASES) -> tuple[Result, ...]:
    """Return every published case computed and judged, source by source."""
    return tuple(judged(row, case) for case in sources(folder) for row in case.rows)


def passed(verdicts: Iterable[Result]) -> bool:
    """Return whether all rows are within tolerance, but for explained misses."""
    return all(result.passed for result in verdicts)


def judged(row: Row, case: Case) -> Result:
    """Compute one row and compare it with what is printed."""
    if row.computation not in COMPUTATIONS:
        raise InputError(f"{case.source}, {row.name}: no computation {row.computation!r}")
    if row.unit not in UNITS:
        raise InputError(f"{case.source}, {row.name}: unit {row.unit!r} is not one of {', '.join(UNITS)}")
    computed = computed_number(row) / UNITS[row.unit]
    low, high = row.allowed
    return Result(
        source=case.source,
        computed=computed,
        tolerance=tolerance_text(row),
        ok=bool(low <= computed <= high),
        **{name: getattr(row, name) for name in SHARED},
    )


def computed_number(row: Row) -> float:
    """Return the number that a row asks for, in SI."""
    computed = COMPUTATIONS[row.computation](**{name: _in_si(name, value) for name, value in row.inputs.items()})
    return float(attrgetter(row.of)(computed) if row.of else computed)


def tolerance_text(row: Row) -> str:
    """Return the allowed range in words: ``± 0.5 %`` or ``4 to 6, ± 0.5``."""
    slack = f"± {row.tolerance_percent:g} %" if row.tolerance_percent else f"± {row.tolerance:g}"
    if row.value is not None:
        return slack
    band = f"{row.low:g} to {row.high:g}"
    return f"{band}, {slack}" if row.tolerance else band


def _in_si(name: str, value: Any) -> Any:
    return parse(value, INPUT_KINDS[name], name) if name in INPUT_KINDS else value
