"""The units that people write most, read without `pint`, whose registry takes longer than a whole report may.

Every other unit, and what is not one number and one unit, is `pint`'s; a test compares both.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from sweetspot.units.factors import (
    DEGREE,
    FOOT,
    INCH,
    INCH_OF_MERCURY,
    MPH,
    OUNCE,
    OUNCE_INCH_SQUARED,
    POUND_FORCE,
    RPM,
)

WRITTEN: Mapping[str, Mapping[str, float]] = {
    "length": {"in": INCH, "ft": FOOT, "yd": 3 * FOOT, "mm": 1e-3, "cm": 0.01, "m": 1.0},
    "mass": {"oz": OUNCE, "lb": 16 * OUNCE, "g": 1e-3, "kg": 1.0},
    "speed": {"mph": MPH, "m/s": 1.0, "km/h": 1 / 3.6, "ft/s": FOOT},
    "moi": {"oz*in^2": OUNCE_INCH_SQUARED, "kg*m^2": 1.0, "kg*cm^2": 1e-4, "g*cm^2": 1e-7},
    "density": {"kg/m^3": 1.0, "g/cm^3": 1e3, "lb/ft^3": 16 * OUNCE / FOOT**3},
    "pressure": {
        "Pa": 1.0,
        "hPa": 100.0,
        "kPa": 1e3,
        "MPa": 1e6,
        "GPa": 1e9,
        "inHg": INCH_OF_MERCURY,
        "psi": POUND_FORCE / INCH**2,
    },
    "force": {"N": 1.0, "kN": 1e3, "lbf": POUND_FORCE},
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "1/krpm": 1e-3 / RPM},
    "angle": {"deg": DEGREE, "rad": 1.0},
    "angular speed": {"rpm": RPM, "rad/s": 1.0},
    "areal density": {"kg/m^2": 1.0},
    "linear density": {"g/m": 1e-3, "kg/m": 1.0},
    "stiffness": {"kN/m": 1e3, "MN/m": 1e6, "N/m": 1.0},
    "frequency": {"Hz": 1.0, "kHz": 1e3},
    "slope per speed": {"1/mph": 1 / MPH, "s/m": 1.0},
    "slope per temperature": {"1/delta_degC": 1.0},
}
"""Size in SI of each unit, by the kind of quantity."""
TEMPERATURES = {"degC": (1.0, 0.0), "degF": (5 / 9, 32.0)}
"""Size in degC, and which number stands for 0 degC."""
TEMPERATURE = re.compile(
    r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?:deg(?:rees?)?|[°º])?[\s_]*(f|c)(?:ahrenheit|elsius)?",
    re.IGNORECASE,
)
"""A number and F or C, with or without a word or sign for degrees: no weather is given in farads or coulombs."""
SHOUTED = {"in", "ft", "yd", "oz", "lb", "mph"}
"""Units that are the same in capitals."""
ONE_NUMBER_AND_UNIT = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z1][\w*/^]*)")


def written(text: str, kind: str) -> float | None:
    """Return one number with one usual unit of a kind in SI; None for anything else.

    >>> written("10 mm", "length"), written("50 F", "temperature"), written("10 furlong", "length")
    (0.01, 10.0, None)
    """
    if kind == "temperature":
        number_in = _temperature(text)
        if number_in is None:
            return None
        size, zero = TEMPERATURES[number_in[1]]
        return (number_in[0] - zero) * size
    match = ONE_NUMBER_AND_UNIT.fullmatch(text.strip())
    if match is None:
        return None
    number, unit = float(match[1]), match[2]
    unit = unit.lower() if unit.lower() in SHOUTED else unit
    size_of = WRITTEN.get(kind, {})
    return number * size_of[unit] if unit in size_of else None


def _temperature(text: str) -> tuple[float, str] | None:
    """Return a temperature's number and the key of its unit."""
    match = TEMPERATURE.fullmatch(text.strip())
    return None if match is None else (float(match[1]), f"deg{match[2].upper()}")


def in_unit_of(given: str, bounds: tuple[float, float], unit: str) -> tuple[tuple[float, float], str]:
    """Return bounds in the unit that somebody wrote, and that unit; as they are where none of one kind is found.

    Parameters
    ----------
    bounds : in ``unit``.

    >>> in_unit_of("-300degF", (-40, 60), "degC"), in_unit_of("0.6 m", (-1, 2), "ft")
    (((-40.0, 140.0), 'degF'), ((-0.3048, 0.6096), 'm'))
    """
    if unit in TEMPERATURES:
        number_in = _temperature(given)
        theirs = number_in[1] if number_in else unit
        (our_size, our_zero), (size, zero) = TEMPERATURES[unit], TEMPERATURES[theirs]
        low, high = ((bound - our_zero) * our_size / size + zero for bound in bounds)
        return (low, high), theirs
    match = ONE_NUMBER_AND_UNIT.fullmatch(given.strip())
    theirs = match[2] if match else unit
    for sizes in WRITTEN.values():
        if theirs in sizes and unit in sizes:
            low, high = (bound * sizes[unit] / sizes[theirs] for bound in bounds)
            return (low, high), theirs
    return bounds, unit
