"""Which measurement contradicts all the others, and what was probably meant by it.

Every slip that people make is tried: a tone by another mode's name, inches told as centimetres, a balance point from
the other end, two swings timed for one. Those that agree with everything else are told; there may be several.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.naming import MOST_BENDING, ModeName
from sweetspot.calibration.posterior import Posterior, calibrate
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

NEAR: Mapping[str, float] = {"mass": 0.15, "balance_point": 0.1, "moi": 0.3, "period": 0.1, "frequency": 0.3}
"""Logarithm of a value over what the others expect from which on a slip is not tried: more than bats of one drawing
differ by. 25 % of the modulus are 0.12 of a frequency; 0.15 of a mass are two spreads of wood's density (7 %)."""
UNITS: Mapping[str, Sequence[tuple[str, str, float]]] = {
    "mass": (("pounds", "kilograms", 16 * OUNCE), ("ounces", "grams", OUNCE / 0.001)),
    "balance_point": (("inches", "centimetres", INCH / 0.01),),
    "moi": (
        ("oz in²", "kg cm²", OUNCE_INCH_SQUARED / 1e-4), ("lb in²", "oz in²", 16.0),
        ("lb in²", "kg cm²", 16 * OUNCE_INCH_SQUARED / 1e-4),
    ),
}  # fmt: skip
"""Units that are taken for each other, and the first over the second."""
COUNTED = (10, 20)
"""Swings that are timed and divided by."""
HANDLE = 0.4
"""Of the length; an implement balances beyond it, and hangs from within it."""


@dataclass(frozen=True)
class Meant:
    """What was probably meant by a measurement.

    Parameters
    ----------
    measurement : as it was meant.
    words : how, in words after "as"; "": about another axis.
    """

    measurement: Measurement
    words: str = ""


def suspects(posterior: Posterior) -> dict[str, Posterior]:
    """Return the measurements that alone explain a contradiction, each with the bat that all the others agree on.

    All are tried: one that the unknowns can always meet pulls at what is expected of them, not at itself. A lone
    measurement contradicts the bat as described.
    """
    if not posterior.contradictions:
        return {}
    if len(posterior.measurements) == 1:
        return {posterior.measurements[0].name: _as_described(posterior)}
    without = {
        one.name: _agreement(posterior, [other for other in posterior.measurements if other is not one])
        for one in posterior.measurements
    }
    return {name: others for name, others in without.items() if others}


def meant(suspect: Measurement, others: Posterior) -> list[Meant]:
    """Return as what a measurement would agree with all the others, the nearest first.

    Parameters
    ----------
    suspect : it contradicts them as it was given.
    others : what is known of the bat without it.
    """
    slips = list(_slips(suspect, others))
    if not slips:
        return []
    values = np.array([one.measurement.value.value for one in slips])
    said = predicted(others.beam, [one.measurement for one in slips], livelier=others.livelier)
    with np.errstate(invalid="ignore"):
        off = np.abs(np.log(said / values))
    return [
        slips[index]
        for index in np.argsort(off)
        if off[index] < NEAR[suspect.kind] and _agreement(others, [*others.measurements, slips[index].measurement])
    ]


def renamed(posterior: Posterior) -> list[Measurement]:
    """Return the tones under names by which all measurements agree: two exchanged, or all one higher or lower.

    Nothing where no such names do.
    """
    tones = [one for one in posterior.measurements if one.mode is not None]
    rest = [one for one in posterior.measurements if one.mode is None]
    for names in _other_names([one.mode for one in tones if one.mode]):
        again = [replace(one, mode=name) for one, name in zip(tones, names, strict=True)]
        if _agreement(posterior, [*rest, *again]):
            return again
    return []


def _other_names(names: Sequence[ModeName]) -> Iterator[list[ModeName]]:
    for first, second in combinations(range(len(names)), 2):
        exchanged = list(names)
        exchanged[first], exchanged[second] = names[second], names[first]
        yield exchanged
    for step in (1, -1):
        moved = [replace(one, harmonic=one.harmonic + step * (one.family == "bending")) for one in names]
        if moved != list(names) and all(1 <= one.harmonic <= MOST_BENDING for one in moved):
            yield moved


def _slips(suspect: Measurement, others: Posterior) -> Iterator[Meant]:
    """Yield what people may have meant, whether it agrees or not."""
    for one, other, size in UNITS.get(suspect.kind, ()):
        yield Meant(_times(suspect, size), f"{one} and not {other}")
        yield Meant(_times(suspect, 1 / size), f"{other} and not {one}")
    if suspect.kind == "balance_point":
        from_other_end = others.beam.bat.length - suspect.value.value
        if from_other_end > 0:
            yield Meant(replace(suspect, value=Measured(from_other_end, suspect.value.error)), "from the other end")
    if suspect.kind == "period":
        yield Meant(_times(suspect, 0.5), "the time of two swings")
        yield Meant(_times(suspect, 2.0), "the time of half a swing")
        for count in COUNTED:
            for swings in (count - 1, count + 1):
                yield Meant(_times(suspect, count / swings), f"{swings} swings counted for {count}")
    if suspect.kind in ("period", "moi"):
        at = suspect.axis
        elsewhere = (0.0, STANDARD_AXIS, at * INCH / 0.01, at * 0.01 / INCH)
        for axis in dict.fromkeys(round(place, 6) for place in elsewhere):
            if axis != round(at, 6) and axis < HANDLE * others.beam.bat.length:
                yield Meant(replace(suspect, axis=axis))
    if suspect.kind == "frequency" and isinstance(others.beam.bat, Bat):
        known = {one.mode for one in others.measurements} | {suspect.mode}
        names = [ModeName("bending", number) for number in range(1, MOST_BENDING + 1)]
        names += [ModeName("hoop", 2)] * (others.beam.bat.shell is not None)
        yield from (Meant(replace(suspect, mode=name), str(name)) for name in names if name not in known)


def _times(suspect: Measurement, factor: float) -> Measurement:
    value = suspect.value
    return replace(suspect, value=Measured(value.value * factor, value.error * factor))


def _as_described(posterior: Posterior) -> Posterior:
    """Return what is known of the same bat before anything was measured."""
    spreads = np.array([one.spread for one in posterior.unknowns])
    return replace(
        posterior, beam=posterior.prior, measurements=(), deviations=np.zeros(len(spreads)),
        covariance=np.diag(spreads**2), predictions=np.empty(0), pulls=np.zeros(len(spreads)), gains=np.diag(spreads),
    )  # fmt: skip


def _agreement(posterior: Posterior, measurements: Sequence[Measurement]) -> Posterior | None:
    """Return the same bat by other measurements, None where these contradict each other too."""
    try:
        one = calibrate(posterior.prior, posterior.unknowns, measurements, agreeing=True)
    except InputError:
        return None
    return None if one.contradictions else one
