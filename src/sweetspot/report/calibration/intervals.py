"""A measured value with its 90 % interval: for people, and for other programs."""

from __future__ import annotations

from sweetspot.calibration.measured import Measured
from sweetspot.report.sentences import Doubtful, Sentence, Slot


def measured_json(value: Measured, name: str, unit: str) -> dict[str, float]:
    """Return value, standard error and ends of the 90 % interval under keys that end in the unit."""
    ends = {"": value.value, "_error": value.error, "_low": value.low, "_high": value.high}
    return {f"{name}{part}{unit}": number for part, number in ends.items()}


def measured_words(value: Measured, scale: str, *, sign: bool = False) -> Sentence:
    """Return a value with half the width of its interval, both to the second digit of that.

    >>> from sweetspot.report.quantities import US
    >>> measured_words(Measured(171.8042, 0.2), "frequency").read(US)
    '171.80 ± 0.33 Hz'
    """
    half = half_width(value)
    return Sentence((Doubtful(value.value, half, scale, sign) if half > 0 else Slot(value.value, scale, sign=sign),))


def half_width(value: Measured) -> float:
    """Return half the width of a value's 90 % interval."""
    return value.high - value.value
