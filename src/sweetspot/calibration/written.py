"""Measured quantities as people write them: ``31.2oz``, ``31.2oz+-0.1oz``, ``3.12 mm ± 0.01``."""

from __future__ import annotations

import math
import re

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.catalog.swing_laws import MOMENTS, swing_weight
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


POINTS = re.compile(r"\s*[A-Za-z]\d(?:\.(\d+))?\s*")


def of_swing_weight(text: str, sport: str, *, mass: Measured | None, what: str = "swing weight") -> Measurement:
    """Return the moment of inertia that a swing weight is, or the balance point that a first moment tells of a weight.

    ``text``: a letter with points, ``D2`` or ``D2.5±0.2``, in a sport that has them; else a quantity with its unit.
    ``sport``: name in the catalogue. ``mass``: kg, weighed; needed where the sport's swing weight is a first moment, M
    = m (x - axis).

    >>> found = of_swing_weight("D2", "golf", mass=Measured(0.310, 0.0005))  # (217 in oz / 10.93 oz + 14 in) = 33.84 in
    >>> found.name, round(found.value.value, 4), round(found.value.error, 4)
    ('balance point', 0.8597, 0.0041)
    >>> of_swing_weight("316kg*cm^2±1kg*cm^2", "tennis", mass=None).axis
    0.1
    """
    convention = swing_weight(sport)
    if convention.order == 2:
        return Measurement("moi", parse_measured(text, "moi", what), axis=convention.axis)
    if convention.zero is None or convention.step is None:
        moment = parse_measured(text, MOMENTS[1], what)
    else:
        written, *error = SEPARATOR.split(text.strip(), maxsplit=1)
        value = convention.moment_of(written)
        digits = POINTS.fullmatch(written)
        assert digits is not None  # or it is no swing weight
        points = parse(error[0], "ratio", f"the error of {what}") if error else 10.0 ** -len(digits[1] or "")
        if not points > 0:
            raise InputError(f"the error of {what} was given as {error[0]!r}; allowed is more than 0")
        moment = Measured(value, points * convention.step * convention.size)
    if mass is None:
        raise InputError(f"{what} {text} tells of the balance point only together with the weight; give the mass too")
    arm = moment.value / mass.value
    error_of_arm = math.hypot(moment.error / mass.value, arm * mass.error / mass.value)
    return Measurement("balance_point", Measured(convention.axis + arm, error_of_arm))
