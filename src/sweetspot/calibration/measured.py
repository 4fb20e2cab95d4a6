"""Measured values with their standard errors, as people write them (``31.2oz``, ``3.12 mm ± 0.01``)."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH
from sweetspot.plausibility import parse
from sweetspot.units import NUMBER, Kind


@dataclass(frozen=True)
class Measured:
    """A value and its standard error (one sigma), both in the same unit."""

    value: float
    error: float

    @property
    def low(self) -> float:
        """Lower end of the 90 % interval."""
        return self.value - REACH * self.error

    @property
    def high(self) -> float:
        """Upper end of the 90 % interval."""
        return self.value + REACH * self.error

    @property
    def relative(self) -> float:
        """Error over value."""
        return self.error / abs(self.value)

    @property
    def half_width(self) -> float:
        """Half the width of the 90 % interval."""
        return REACH * self.error

    def widened(self, error: float) -> Measured:
        """Return the same value with a further, independent error."""
        return Measured(self.value, math.hypot(self.error, error))


ValueKind = Literal["measured", "fitted", "assumed"]


@dataclass(frozen=True)
class CalibratedValue:
    """A value of a calibrated implement with its error, SI, and where it comes from."""

    value: Measured
    kind: ValueKind


def pooled(values: Sequence[Measured]) -> Measured:
    """Return the mean weighted by inverse variance.

    Where the values scatter more than their errors allow, the error grows with them (Birge's ratio
    sqrt(chi^2 / (n - 1)), never below 1).

    >>> pooled([Measured(1.0, 0.1), Measured(3.0, 0.1)])  # twenty errors apart: the mean is worth little
    Measured(value=2.0, error=1.0)
    """
    weights = np.array([1 / value.error**2 for value in values])
    numbers = np.array([value.value for value in values])
    mean = float(weights @ numbers / weights.sum())
    spread = math.sqrt(weights @ (numbers - mean) ** 2 / max(len(values) - 1, 1))
    return Measured(mean, float(max(spread, 1.0) / math.sqrt(weights.sum())))


SEPARATOR = re.compile(r"\s*(?:±|\+/-|\+-)\s*")
DECIMALS = re.compile(r"^\s*[-+]?\d*(?:\.(\d+))?\s*(.*)$")
FRACTION = re.compile(r"\d*/\d")
"""What a fraction leaves behind its first number, 33 1/2 in: it has no last digit; m/s is none."""


FLOORS: Mapping[str, float] = {"mass": 1e-3, "balance_point": 5e-4, "pendulum": 2e-3, "tone": 0.3}
"""One sigma of a value without its own ±, at least (assumed): kitchen scale in kg, edge in m, stopwatch over twenty
swings in s, microphone in Hz. More digits, as a mean has, do not make an instrument better."""


def parse_measured(text: str, kind: Kind, what: str = "value", *, floor: float = 0.0) -> Measured:
    """Return a quantity and its standard error in SI.

    The error is the part after ``±`` (or ``+-``), with the quantity's unit unless it has its own; without it one unit
    of the last digit written, and no less than ``floor`` (SI): one of `FLOORS`.

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
        error = max(parse(f"{10.0 ** -len(match[1] or '')!r} {unit}", kind, f"the error of {what}"), floor)
    if not error > 0:
        raise InputError(f"the error of {what} was given as {parts[-1]!r}; allowed is more than 0")
    return Measured(value, error)
