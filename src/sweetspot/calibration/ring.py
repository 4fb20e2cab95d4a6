"""What all good taps say together: tones with frequency and damping, named after the modes that make them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sweetspot.calibration.measured import Measured, pooled
from sweetspot.calibration.sinusoids import Sinusoid
from sweetspot.calibration.taps import Tap
from sweetspot.errors import InputError

REPEATABILITY = 0.0015
"""Of a frequency, one sigma (assumed): how it hangs, its temperature, the microphone's clock; no fit can know it."""
DAMPING_REPEATABILITY = 0.03
"""The same of a damping ratio (assumed): strings, air and supports take a little."""
SAME = 0.01
"""Tones of different taps closer than this part of their frequency are one."""
OFTEN = 0.5
"""Part of the taps in which a tone must be heard."""


@dataclass(frozen=True)
class Tone:
    """A frequency at which the implement rings, from all taps.

    Parameters
    ----------
    frequency : Hz.
    damping_ratio : fraction of critical; the errors of both hold the repeatability.
    level : loudness over the loudest tone's, 0 to 1.
    taps : number of taps in which it was heard.
    """

    frequency: Measured
    damping_ratio: Measured
    level: float
    taps: int

    @property
    def quality(self) -> float:
        """Q = 1 / (2 zeta): how often it swings before it has lost most of its energy."""
        return 0.5 / max(self.damping_ratio.value, 1e-9)


def tones_of(taps: Sequence[Tap]) -> tuple[Tone, ...]:
    """Return the tones that the good taps agree on, lowest first, each averaged by inverse variance.

    Raises
    ------
    InputError
        when no tap is good; the message says what is wrong with each.
    """
    fits = [tap.fit for tap in taps if tap.good and tap.fit is not None]
    if not fits:
        faults = "; ".join(f"{tap.recording} at {tap.start:.2f} s {tap.fault}" for tap in taps)
        raise InputError(f"no tap can be used: {faults or 'there is none'}")
    heard = sorted(
        ((one, number, one.amplitude / max(other.amplitude for other in fit.sinusoids))
         for number, fit in enumerate(fits) for one in fit.sinusoids),
        key=lambda entry: entry[0].frequency.value,
    )  # fmt: skip
    groups: list[list[tuple[Sinusoid, int, float]]] = []
    for entry in heard:
        near = groups and entry[0].frequency.value < (1 + SAME) * groups[-1][-1][0].frequency.value
        if near and entry[1] not in {number for _, number, _ in groups[-1]}:
            groups[-1].append(entry)
        else:
            groups.append([entry])
    often = [group for group in groups if len(group) >= OFTEN * len(fits)]
    return tuple(_tone(group) for group in often)


def _tone(group: list[tuple[Sinusoid, int, float]]) -> Tone:
    frequency = pooled([one.frequency for one, _, _ in group])
    damping = pooled([one.damping_ratio for one, _, _ in group])
    shared = sum(one.shared_error for one, _, _ in group) / len(group)  # more taps in one room do not make it less
    return Tone(
        frequency.widened(REPEATABILITY * frequency.value).widened(shared),
        damping.widened(DAMPING_REPEATABILITY * damping.value).widened(shared / frequency.value),
        max(level for _, _, level in group),
        len(group),
    )
