"""Measured quantities as people write them: ``31.2oz``, ``31.2oz+-0.1oz``, ``3.12 mm ± 0.01``."""

from __future__ import annotations

import re

from sweetspot.calibration.measured import Measured
from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import NUMBER, Kind

SEPARATOR = re.compile(r"\s*(?:±|\+/-|\+-)\s*")
DECIMALS = re.compile(r"^\s*[-+]?\d*(?:\.(\d+))?\s*(.*)$")
FRACTION = re.compile(r"\d*/\d")
"""What a fraction leaves behind its first number, 33 1/2 in: it has no last digit; m/s is none."""


def parse_measured(text: str, kind: Kind, what: str = "value") -> Measured:
    """Return a quantity and its standard error in SI.

    The error is the part after ``±`` (or ``+-``), with the quantity's unit unless it has its own; without it one unit
    of the last digit written.

    >>> parse_measured("31±0.5kg", "mass")
    Measured(value=31.0, error=0.5)
    >>> parse_measured("2.5kg", "mass"), parse_measured("2.5 kg ± 20g", "mass"), parse_measured("2.5kg+-0.2", "mass")
    (Measured(value=2.5, error=0.1), Measured(value=2.5, error=0.02), Measured(value=2.5, error=0.2))
    >>> parse_measured("28m/s", "speed")
    Measured(value=28.0, error=1.0)
    """
    parts = SEPARATOR.split(text.strip(), maxsplit=1)
    if len(parts) == 2 and NUMBER.match(parts[0]) and (end := DECIMALS.match(parts[1])):
        parts[0] += f" {end[2]}".rstrip()  # one unit behind both
    value = parse(parts[0], kind, what)
    match = DECIMALS.match(parts[0])
    unit = match[2] if match else ""
    if len(parts) == 2:
        written = f"{parts[1]} {unit}" if NUMBER.match(parts[1]) and kind != "ratio" else parts[1]
        error = parse(written, kind, f"the error of {what}")
    elif match is None or FRACTION.match(unit):
        raise InputError(f"{what} was given as {text!r}; say how sure it is, as in '33.5in ± 0.1in'")
    else:
        error = parse(f"{10.0 ** -len(match[1] or '')!r} {unit}", kind, f"the error of {what}")
    if not error > 0:
        raise InputError(f"the error of {what} was given as {parts[-1]!r}; allowed is more than 0")
    return Measured(value, error)
