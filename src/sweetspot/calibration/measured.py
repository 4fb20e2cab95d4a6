"""Measured values with their standard errors, and the intervals that follow."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.numerics.interval import REACH


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
