"""The tones of all good taps together, with frequency and damping, for naming after the modes that make them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sweetspot.calibration.measured import Measured, pooled
from sweetspot.calibration.sinusoids import Sinusoid, stands_out
from sweetspot.calibration.taps import WINDOW, Tap
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
    distinct : whether it stands out of what a room may add, in at least half of them; see `stands_out`.
    """

    frequency: Measured
    damping_ratio: Measured
    level: float
    taps: int
    distinct: bool = True

    @property
    def quality(self) -> float:
        """Q = 1 / (2 zeta): how often it swings before it has lost most of its energy."""
        return 0.5 / max(self.damping_ratio.value, 1e-9)

    @property
    def strength(self) -> float:
        """Root of its energy in a tap's window, in any unit: what dies away at once is loud and holds little."""
        decay = 2 * math.pi * self.frequency.value * self.damping_ratio.value
        return self.level / math.sqrt(max(decay, 1 / WINDOW))


class _Heard(NamedTuple):
    """A tone as one tap has it: the tap's number, its level there, and whether it stands out there."""

    tone: Sinusoid
    tap: int
    level: float
    distinct: bool


def tones_of(taps: Sequence[Tap]) -> tuple[Tone, ...]:
    """Return the tones that the good taps agree on, lowest first, each averaged by inverse variance."""
    used = [(tap.fit, tap.heard_to or math.inf) for tap in taps if tap.good and tap.fit is not None]
    if not used:
        faults = "; ".join(f"{tap.recording} at {tap.start:.2f} s {tap.fault}" for tap in taps)
        raise InputError(f"no tap can be used: {faults or 'there is none'}")
    heard = sorted(
        (_Heard(sinusoid, number, sinusoid.amplitude / max(other.amplitude for other in fit.sinusoids),
                stands_out(sinusoid, fit.sinusoids))
         for number, (fit, _) in enumerate(used) for sinusoid in fit.sinusoids),
        key=lambda entry: entry.tone.frequency.value,
    )  # fmt: skip
    groups: list[list[_Heard]] = []
    for entry in heard:
        near = groups and entry.tone.frequency.value < (1 + SAME) * groups[-1][-1].tone.frequency.value
        if near and entry.tap not in {other.tap for other in groups[-1]}:
            groups[-1].append(entry)
        else:
            groups.append([entry])
    return tuple(
        _tone(group)
        for group in groups
        if len(group) >= OFTEN * sum(heard_to > group[0].tone.frequency.value for _, heard_to in used)
    )


def _tone(group: list[_Heard]) -> Tone:
    frequency = pooled([heard.tone.frequency for heard in group])
    damping = pooled([heard.tone.damping_ratio for heard in group])
    shared = sum(heard.tone.shared_error for heard in group) / len(group)  # more taps in one room do not make it less
    return Tone(
        frequency.widened(REPEATABILITY * frequency.value).widened(shared),
        damping.widened(DAMPING_REPEATABILITY * damping.value).widened(shared / frequency.value),
        max(heard.level for heard in group),
        len(group),
        sum(heard.distinct for heard in group) >= OFTEN * len(group),
    )
