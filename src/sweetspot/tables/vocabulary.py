"""The names that columns of tables have: quantities that anybody may name, and measuring systems with their own."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal

from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, POUND_FORCE, RPM
from sweetspot.units.factors import STANDARD_GRAVITY

FileUnits = Literal["us", "metric"]

SPEEDS = {
    **dict.fromkeys(("mph", "mi_h"), MPH),
    **dict.fromkeys(("m_s", "mps", "ms"), 1.0),
    **dict.fromkeys(("km_h", "kmh", "kph"), 1 / 3.6),
    **dict.fromkeys(("ft_s", "fps"), FOOT),
}
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
    "time": {"s": 1.0, "sec": 1.0, "seconds": 1.0, "ms": 1e-3},
    "spin": {"rpm": RPM, "rad_s": 1.0},
    "acceleration": {"ft_s2": FOOT, "m_s2": 1.0, "g": STANDARD_GRAVITY},
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
UNITS_OF_FILES: Mapping[str, tuple[str, str]] = {
    "place": ("in_from_tip", "cm_from_tip"),
    **{"speed": ("mph", "m_s"), "length": ("in", "cm"), "station": ("in", "cm")},
    **{"distance": ("ft", "m"), "spin": ("rpm", "rpm"), "temperature": ("degf", "degc"), "pressure": ("inhg", "hpa")},
    **{"mass": ("oz", "g"), "moi": ("oz_in2", "kg_cm2"), "stiffness": ("lbf_in", "n_m")},
}
FILE_UNITS: Mapping[FileUnits, Mapping[str, str]] = {
    "us": {kind: us for kind, (us, _) in UNITS_OF_FILES.items()},
    "metric": {kind: metric for kind, (_, metric) in UNITS_OF_FILES.items()},
}
"""Units of columns that have none, where a person says in which units a file is."""
FOREIGN = {"knots", "kn", "mils", "yards", "miles"}
"""Words for units that are not supported."""
KNOWN_UNITS = frozenset(unit for units in UNITS.values() for unit in units) | FOREIGN
"""Words behind a name that are read as its unit, whether they fit or not; other words make another name."""


def zero_of(kind: str, unit: str) -> float:
    """Return the SI value of 0 in a unit, temperatures in degC."""
    return FAHRENHEIT_ZERO if kind == "temperature" and UNITS[kind].get(unit, 1.0) != 1 else 0.0


SIGNS = {"²": "2", "\u2033": "in", '"': "in", "ø": "diameter", "\u2300": "diameter"}
"""Signs of headings as words."""
METRES = re.compile(r"\b(milli|centi)?met(?:er|re)s?\b")
FILE = Path(__file__).with_name("headings.toml")


@dataclass(frozen=True)
class TableQuantity:
    """A quantity of tables: what kind it is (`UNITS`), and its names that anybody may use."""

    kind: str
    names: tuple[str, ...]


@dataclass(frozen=True)
class MeasuringSystem:
    """A system whose headings mean its own units.

    ``name``: as messages write it. ``marks``: sets of headings, each of which gives a table of the system away.
    ``columns``: quantity and unit by heading, most preferred first; "" for what is no quantity here. ``fixed``: whether
    its units are never metric.
    """

    name: str
    marks: tuple[frozenset[str], ...]
    columns: Mapping[str, tuple[str, str]]
    fixed: bool


@cache
def _table() -> Mapping[str, Mapping[str, Any]]:
    with FILE.open("rb") as file:
        return tomllib.load(file)


@cache
def quantities() -> Mapping[str, TableQuantity]:
    """Return every quantity of tables by its name."""
    groups = (group.items() for name, group in _table().items() if name != "systems")
    return {
        name: TableQuantity(entry["kind"], tuple(entry.get("names", ()))) for group in groups for name, entry in group
    }


def quantities_of(*groups: str) -> tuple[str, ...]:
    """Return the quantities of tables of some sorts: balls, swings."""
    return tuple(name for group in groups for name in _table()[group])


@cache
def systems() -> tuple[MeasuringSystem, ...]:
    """Return the measuring systems, the most particular first."""
    entries = _table()["systems"]

    def columns(key: str) -> dict[str, tuple[str, str]]:
        meanings = {heading: text.partition(" ") for heading, text in entries[key]["columns"].items()}
        by_heading = {heading: (quantity, simplified(unit)) for heading, (quantity, _, unit) in meanings.items()}
        also = entries[key].get("also")
        return by_heading | (columns(also) if also else {})

    return tuple(
        MeasuringSystem(entry["name"], tuple(map(frozenset, entry["marks"])), columns(key), entry.get("fixed", False))
        for key, entry in entries.items()
    )


def simplified(heading: str) -> str:
    """Return a heading in lower case, words and unit joined by single underscores.

    >>> simplified("Exit Velocity [km/h]"), simplified("ExitSpeed"), simplified("ax (ft/s²)")
    ('exit_velocity_km_h', 'exitspeed', 'ax_ft_s2')
    """
    plain = heading.replace("\ufeff", "").strip().strip('"').lower()
    for sign, word in SIGNS.items():
        plain = plain.replace(sign, word)
    plain = METRES.sub(lambda match: f"{(match[1] or '')[:1]}m", plain)
    return re.sub(r"[^0-9a-z%°]+", "_", plain).strip("_")


@cache
def quantity_by_name(wanted: tuple[str, ...]) -> Mapping[str, str]:
    """Return the quantity of each name that anybody may use, written without underscores."""
    found: dict[str, str] = {}
    for quantity in wanted:
        for name in quantities()[quantity].names:
            found.setdefault(joined(name), quantity)
    return found


def joined(name: str) -> str:
    """Return a simplified name without its underscores."""
    return name.replace("_", "")


def spelled_names(wanted: Collection[str]) -> list[str]:
    """Return all names that anybody may use for some quantities, as they are spelled."""
    return [name for quantity in wanted for name in quantities()[quantity].names]
