"""A measured value with its 90 % interval, for people."""

from __future__ import annotations

from sweetspot.calibration.measured import Measured
from sweetspot.reports.sentences import Doubtful, Sentence, Slot


def measured_words(value: Measured, scale: str, *, sign: bool = False) -> Sentence:
    """Return a value with half the width of its interval, both to the second digit of that.

    >>> from sweetspot.reports.quantities import US
    >>> measured_words(Measured(171.8042, 0.2), "frequency").read(US)
    '171.80 ± 0.33 Hz'
    """
    half = value.half_width
    return Sentence((Doubtful(value.value, half, scale, sign) if half > 0 else Slot(value.value, scale, sign=sign),))
