"""Units as headings and cells write them, by the kind of what is measured, and their size in SI."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, POUND_FORCE, RPM

FileUnits = Literal["us", "metric"]

SPEEDS = {
    "mph": MPH, "mi_h": MPH, "m_s": 1.0, "mps": 1.0, "ms": 1.0, "km_h": 1 / 3.6, "kmh": 1 / 3.6, "kph": 1 / 3.6,
    "ft_s": FOOT, "fps": FOOT,
}  # fmt: skip
SHORT = {"in": INCH, "inch": INCH, "inches": INCH, "m": 1.0, "cm": 0.01, "mm": 0.001}
LENGTHS = SHORT | {"ft": FOOT, "feet": FOOT, "yd": 3 * FOOT}
UNITS: Mapping[str, Mapping[str, float]] = {
    "speed": SPEEDS,
    "angle": dict.fromkeys(("deg", "degree", "degrees", "°"), DEGREE)
    | dict.fromkeys(("rad", "radian", "radians"), 1.0),
    "length": LENGTHS,
    "distance": {"ft": FOOT, "feet": FOOT} | LENGTHS,
    "place": {f"{unit}_from_{end}": size for unit, size in SHORT.items() for end in ("tip", "knob")},
    "station": LENGTHS | {f"{unit}_from_{end}": size for unit, size in LENGTHS.items() for end in ("tip", "knob")},
    "time": {"s": 1.0, "sec": 1.0, "seconds": 1.0},
    "spin": {"rpm": RPM, "rad_s": 1.0},
    "acceleration": {"ft_s2": FOOT, "m_s2": 1.0},
    "temperature": {"degf": 5 / 9, "degc": 1.0, "f": 5 / 9, "c": 1.0, "°f": 5 / 9, "°c": 1.0},
    "pressure": {"hpa": 100.0, "mbar": 100.0, "inhg": 3386.389, "in_hg": 3386.389, "mmhg": 133.3224, "kpa": 1000.0},
    "mass": {"oz": OUNCE, "ounces": OUNCE, "kg": 1.0, "g": 0.001, "grams": 0.001, "lb": 16 * OUNCE, "lbs": 16 * OUNCE},
    "moi": {"oz_in2": OUNCE_INCH_SQUARED, "kg_m2": 1.0, "kg_cm2": 1e-4},
    "frequency": {"hz": 1.0},
    "stiffness": {"n_m": 1.0, "lbf_in": POUND_FORCE / INCH, "lb_in": POUND_FORCE / INCH},
    "ratio": {"%": 0.01, "pct": 0.01, "percent": 0.01, "ratio": 1.0},
    "count": {},
    "text": {},
}
"""Words behind the name of a quantity that are units of its kind, and their size in SI."""
FAHRENHEIT_ZERO = -160 / 9
"""degC at 0 degF."""
PLACES = ("place", "station")
"""Kinds that count from an end of an implement; a station counts from the knob where nothing else is given."""
UNMEASURED = ("count", "text")
"""Kinds without a unit."""
ONLY_UNIT = {"time": "s", "angle": "deg", "frequency": "hz"}
"""Units of kinds that are written in another unit only with its name."""
FILE_UNITS: Mapping[FileUnits, Mapping[str, str]] = {
    "us": {"speed": "mph", "length": "in", "station": "in", "place": "in_from_tip", "distance": "ft", "spin": "rpm",
           "temperature": "degf", "pressure": "inhg", "mass": "oz", "moi": "oz_in2", "stiffness": "lbf_in"},
    "metric": {"speed": "m_s", "length": "cm", "station": "cm", "place": "cm_from_tip", "distance": "m", "spin": "rpm",
               "temperature": "degc", "pressure": "hpa", "mass": "g", "moi": "kg_cm2", "stiffness": "n_m"},
}  # fmt: skip
"""Units of columns that have none, where a person says in which units a file is."""
FOREIGN = {"knots", "kn", "mils", "yards", "miles"}
"""Words for units that are not supported."""
KNOWN_UNITS = frozenset(unit for units in UNITS.values() for unit in units) | FOREIGN
"""Words behind a name that are read as its unit, whether they fit or not; other words make another name."""


def zero_of(kind: str, unit: str) -> float:
    """Return the SI value of 0 in a unit, temperatures in degC."""
    return FAHRENHEIT_ZERO if kind == "temperature" and UNITS[kind].get(unit, 1.0) != 1 else 0.0
