"""Own bat: the sounds of taps, which of them can be used and why not, and the tones that they hold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated

import numpy as np

from sweetspot.answers.records import Frequency, Time
from sweetspot.answers.tap import TapQuestion, tap_answer
from sweetspot.calibration.mode_naming import expected_of
from sweetspot.calibration.recording import FrequencyBand, Recording, read_recording
from sweetspot.calibration.tap_analysis import (
    FAMILIES,
    TapTest,
    held_damping,
    modes_to_name,
    spectrum,
    usual_band,
    waveform,
)
from sweetspot.calibration.taps import Tap, find_taps
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.sentences import Slot, joined, say
from sweetspot.reports.tap import touched_words, unlike_words
from sweetspot.units import INCH
from sweetspot.units.dimensions import FREQUENCY, TIME, System
from sweetspot.web.documents import in_either_system
from sweetspot.web.errors import FieldError
from sweetspot.web.uploads import UPLOADS
from sweetspot.web.views.own_state import OwnState, ToneName, name_of, unknown_of

DRAWN, TOLD = 500, 4
"""Points of a waveform on the page, and expected tones in the description of its picture."""
MOST_SAMPLES, MOST_HELD = 20_000_000, 12
"""Of all channels of one recording, three minutes and a half of two at 48 kHz; and recordings: 2 GB at most."""
OF_COMMAND = ", or set --most-damping"
"""Advice about a held bat that only the command line can follow."""
HIGHEST = 1.3
"""Times the highest expected tone, up to where the spectrum is drawn."""


@dataclass(frozen=True)
class ExpectedTone:
    """A tone of a free bat as described, and how strongly the tap excites it."""

    name: str
    frequency: Frequency
    excitation: float


@dataclass(frozen=True)
class RefusedSound:
    """A recording that cannot be read, and why."""

    recording: str
    fault: str


@dataclass(frozen=True)
class TapRow:
    """A tap of a recording, s from its begin; ``fault`` says why it is not a good one."""

    recording: str
    time: Time
    good: bool
    fault: str | None


@dataclass(frozen=True, kw_only=True)
class ToneRow:
    """A tone of all good taps: its mode, half its 90 % interval, and whether it is the bat's own and not the room's."""

    name: str | None
    frequency: Frequency
    half: Frequency
    damping_ratio: float
    expected: Annotated[float | None, FREQUENCY]
    taps: int
    from_bat: bool


@dataclass(frozen=True)
class TapWaveform:
    """Least and greatest values of a recording over time, full scale 1."""

    name: str
    time: Annotated[Array, TIME]
    low: Array
    high: Array


@dataclass(frozen=True)
class TapSpectrum:
    """Levels of what rings, dB below the loudest."""

    frequency: Annotated[Array, FREQUENCY]
    level_db: Array


@dataclass(frozen=True, kw_only=True)
class HeardTaps:
    """What is heard in recorded taps; ``measured`` and ``damping`` are controls of the view.

    Parameters
    ----------
    words : how many of the taps are used.
    fault : why nothing of it counts; ``doubts`` about what counts all the same.
    unlike : whether what rang is hardly what is described.
    """

    refused: tuple[RefusedSound, ...]
    taps: tuple[TapRow, ...] = ()
    words: str = ""
    waveform: TapWaveform | None = None
    tones: tuple[ToneRow, ...] = ()
    spectrum: TapSpectrum | None = None
    measured: tuple[tuple[ToneName, float, float], ...] = ()
    damping: tuple[float, float] | None = None
    fault: str | None
    unlike: bool = False
    doubts: tuple[str, ...] = ()


def expected_tones(state: OwnState) -> tuple[ExpectedTone, ...]:
    """Return the tones that a free bat as described would have, and how strongly the tap excites each."""
    described, _ = unknown_of(state)
    modes, place = modes_to_name(described), _place(state, described)
    tones, highest = [], usual_band(modes).high
    for family in FAMILIES:
        if modes.of_family(family):
            family_tones = expected_of(modes, family, positions=[place])
            tones += [
                ExpectedTone(str(name), float(hertz), float(part))
                for name, hertz, part in zip(
                    family_tones.names, family_tones.frequency, family_tones.excitation, strict=True
                )
                if hertz < highest
            ]
    return tuple(sorted(tones, key=lambda tone: float(tone.frequency)))


def expected_words(tones: Sequence[ExpectedTone]) -> dict[System, str]:
    """Return the lowest of the expected tones in words."""
    lowest = (say("{name} {at}", name=tone.name, at=Slot(tone.frequency, "frequency")) for tone in tones[:TOLD])
    return in_either_system(say("expected: {tones}.", tones=joined(lowest, ", ")))


def tap(state: OwnState) -> HeardTaps:
    """Return the results of recorded taps: the good ones, the faults of others, and the named tones of all together.

    A recording that cannot be read is refused with its reason; the others are heard without it.
    """
    sounds: list[_Sound] = []
    refused: list[RefusedSound] = []
    for key in state.recordings:
        try:
            sounds.append(_recording(key))
        except InputError as error:
            path, name = UPLOADS.path_of(key)
            refused.append(RefusedSound(key, str(error).replace(str(path), name)))
    if not sounds:
        return HeardTaps(refused=tuple(refused), fault=None)
    described, _ = unknown_of(state)
    modes = modes_to_name(described)
    band, held = usual_band(modes), held_damping(modes)
    taps = [tap for sound in sounds for tap in _taps(sound, band, held)]
    head = HeardTaps(
        refused=tuple(refused),
        taps=tuple(map(_tap_row, taps)),
        words=f"{sum(tap.good for tap in taps)} of {len(taps)} taps used.",
        waveform=_wave(sounds[-1]),
        fault="no tap can be used: the list says what is wrong with each" if taps else "there is no tap in it",
    )
    good = [tap for tap in taps if tap.good and tap.fit is not None]
    if not good:
        return head
    question = TapQuestion([sound.recording for sound in sounds], described, [_place(state, described)])
    try:
        found = tap_answer(question, taps=taps)
    except InputError as error:
        return replace(head, fault=str(error))
    test, damping = found.test, found.damping
    unlike = test.unlike and isinstance(described, Bat)  # higher tones of other implements are known less well
    assert good[-1].fit is not None
    frequency, level = spectrum(good[-1].fit)
    drawn = frequency < HIGHEST * max(tone.frequency.value for tone in found.tones)
    return replace(
        head,
        tones=tuple(
            ToneRow(
                name=None if named.name is None else str(named.name),
                frequency=tone.frequency.value,
                half=tone.frequency.half_width,
                damping_ratio=tone.damping_ratio.value,
                expected=tone.expected,
                taps=tone.taps,
                from_bat=tone.own,
            )
            for named, tone in zip(test.tones, found.tones, strict=True)
        ),
        measured=tuple(
            (name_of(measurement.mode), measurement.value.value, measurement.value.error)
            for measurement in found.measurements
            if measurement.mode
        ),
        damping=None if damping is None or test.unheard else (damping.value, damping.error),
        fault=_fault(test, damping is not None),
        unlike=unlike,
        doubts=tuple(_doubts(test, unlike)),
        spectrum=TapSpectrum(np.round(frequency[drawn], 2), np.round(level[drawn], 2)),
    )


def _fault(test: TapTest, bending: bool) -> str | None:
    """Return why nothing of a tap test counts; None: its tones may."""
    if test.unheard:
        return f"{unlike_words(test)} Nothing of it counts: describe what was tapped better"
    if not bending:
        return "no tone is a bending mode of what is described; hang it freely, tap it near the tip, describe it better"
    return None


def _doubts(test: TapTest, unlike: bool) -> list[str]:
    """Return the doubts about tones that may count all the same."""
    if test.unheard:
        return []
    hardly = [f"{unlike_words(test)} Describe what was tapped better, or count them all the same."] if unlike else []
    return [*hardly, *([str(touched_words(test, test.touched))] if test.touched else [])]


class _Sound:
    """A recording under the key of its file; two of one key are one."""

    def __init__(self, key: str, recording: Recording) -> None:
        self.key, self.recording = key, recording


@lru_cache(maxsize=MOST_HELD)
def _recording(key: str) -> _Sound:
    path, name = UPLOADS.path_of(key)
    return _Sound(key, replace(read_recording(path, most=MOST_SAMPLES), name=name))


@lru_cache(maxsize=128)
def _taps(sound: _Sound, band: FrequencyBand, held: float) -> tuple[Tap, ...]:
    return find_taps(sound.recording, band=band, held=held)


def _tap_row(found: Tap) -> TapRow:
    fault = None if found.fault is None else found.fault.removesuffix(OF_COMMAND)
    return TapRow(found.recording, found.start, found.good, fault)


def _wave(sound: _Sound) -> TapWaveform:
    time, low, high = waveform(sound.recording, points=DRAWN)
    return TapWaveform(sound.recording.name, np.round(time, 5), np.round(low, 4), np.round(high, 4))


def _place(state: OwnState, described: Implement) -> float:
    place = described.length - state.tap_from_tip_in * INCH
    if place < 0:
        raise FieldError(
            "tap_from_tip_in", f"{described.name} is {described.length / INCH:.4g} in long; tap it nearer the tip"
        )
    return place
