"""Measurements that contradict all the others, and their probable intended meaning.

The slips that people make are tried: inches given as centimetres, a balance point from the other end, two swings timed
for one, a tone by another mode's name. Those that agree with everything else are reported; there may be several.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import MOST_BENDING, ModeName
from sweetspot.calibration.posterior import BatPosterior, calibrate
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

NEAR: Mapping[str, float] = {"mass": 0.15, "balance_point": 0.1, "moi": 0.3, "period": 0.1, "frequency": 0.3}
"""Logarithm of a value over what the others expect from which on a slip is not tried: more than bats of one drawing
differ by. 25 % of the modulus are 0.12 of a frequency; 0.15 of a mass are two spreads of wood's density (7 %)."""
FACTORS: Mapping[str, Mapping[str, float]] = {
    "mass": {
        "pounds and not kilograms": 16 * OUNCE,
        "kilograms and not pounds": 1 / (16 * OUNCE),
        "ounces and not grams": OUNCE / 0.001,
        "grams and not ounces": 0.001 / OUNCE,
    },
    "balance_point": {"inches and not centimetres": INCH / 0.01, "centimetres and not inches": 0.01 / INCH},
    "moi": {
        "oz in² and not kg cm²": OUNCE_INCH_SQUARED / 1e-4,
        "kg cm² and not oz in²": 1e-4 / OUNCE_INCH_SQUARED,
        "lb in² and not oz in²": 16.0,
        "oz in² and not lb in²": 1 / 16.0,
    },
    "period": {"the time of two swings": 0.5, "the time of half a swing": 2.0},
}
"""Factors by which a value has to be multiplied if the words describe the slip."""
HANDLE = 0.4
"""Of the length; an implement balances beyond it, and hangs from within it."""


@dataclass(frozen=True)
class IntendedReading:
    """The probable intended meaning of a measurement (``words``: how, in words after "as"; "": about another axis)."""

    measurement: Measurement
    words: str = ""


def suspects(posterior: BatPosterior) -> dict[str, BatPosterior]:
    """Return the measurements that alone explain a contradiction, each with the bat that all the others agree on.

    All are tried: one that the unknowns can always meet pulls at what is expected of them, not at itself. A lone
    measurement contradicts the bat as described.
    """
    if not posterior.contradictions:
        return {}
    if len(posterior.measurements) == 1:
        return {posterior.measurements[0].name: _as_described(posterior)}
    without = {
        suspect.name: _agreement(posterior, [other for other in posterior.measurements if other is not suspect])
        for suspect in posterior.measurements
    }
    return {name: others for name, others in without.items() if others}


def intended_readings(suspect: Measurement, others: BatPosterior) -> list[IntendedReading]:
    """Return the readings of a measurement that agree with all the others, the nearest first."""
    slips = list(_slips(suspect, others))
    if not slips:
        return []
    values = np.array([slip.measurement.value.value for slip in slips])
    expected = predicted(others.beam, [slip.measurement for slip in slips], livelier=others.livelier)
    with np.errstate(invalid="ignore"):
        off = np.abs(np.log(expected / values))
    return [
        slips[index]
        for index in np.argsort(off)
        if off[index] < NEAR[suspect.kind] and _agreement(others, [*others.measurements, slips[index].measurement])
    ]


def _slips(suspect: Measurement, others: BatPosterior) -> Iterator[IntendedReading]:
    """Yield the readings that may have been intended, whether they agree or not."""
    value, bat = suspect.value, others.beam.bat
    for words, factor in FACTORS.get(suspect.kind, {}).items():
        yield IntendedReading(replace(suspect, value=Measured(value.value * factor, value.error * factor)), words)
    if suspect.kind == "balance_point" and value.value < bat.length:
        yield IntendedReading(
            replace(suspect, value=Measured(bat.length - value.value, value.error)), "from the other end"
        )
    if suspect.kind in ("period", "moi"):
        elsewhere = (0.0, STANDARD_AXIS, suspect.axis * INCH / 0.01, suspect.axis * 0.01 / INCH)
        for axis in dict.fromkeys(round(place, 6) for place in elsewhere):
            if axis != round(suspect.axis, 6) and axis < HANDLE * bat.length:
                yield IntendedReading(replace(suspect, axis=axis))
    if suspect.kind == "frequency" and isinstance(bat, Bat):
        taken = {other.mode for other in others.measurements} | {suspect.mode}
        names = [ModeName("bending", number) for number in range(1, MOST_BENDING + 1)]
        names += [ModeName("hoop", 2)] * (bat.shell is not None)
        yield from (IntendedReading(replace(suspect, mode=name), str(name)) for name in names if name not in taken)


def _as_described(posterior: BatPosterior) -> BatPosterior:
    """Return the prior of the same bat, before any measurement."""
    spreads = np.array([unknown.spread for unknown in posterior.unknowns])
    return replace(
        posterior,
        beam=posterior.prior,
        measurements=(),
        deviations=np.zeros(len(spreads)),
        covariance=np.diag(spreads**2),
        predictions=np.empty(0),
        pulls=np.zeros(len(spreads)),
        gains=np.diag(spreads),
    )


def _agreement(posterior: BatPosterior, measurements: Sequence[Measurement]) -> BatPosterior | None:
    """Return the same bat by other measurements, None where these contradict each other too."""
    try:
        found = calibrate(posterior.prior, posterior.unknowns, measurements, agreeing=True)
    except InputError:
        return None
    return None if found.contradictions else found
