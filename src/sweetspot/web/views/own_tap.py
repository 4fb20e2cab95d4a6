"""Own bat: the sounds of taps, which of them can be used and why not, and the tones that they hold."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

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
from sweetspot.reports.tap.document import touched_words, unlike_words
from sweetspot.units import INCH
from sweetspot.web.errors import FieldError
from sweetspot.web.uploads import UPLOADS
from sweetspot.web.views.own_state import OwnState, name_of, unknown_of

DRAWN = 500
"""Points of a waveform on the page."""
MOST_SAMPLES, MOST_HELD = 20_000_000, 12
"""Of all channels of one recording, three minutes and a half of two at 48 kHz; and recordings: 2 GB at most."""
OF_COMMAND = ", or set --most-damping"
"""Advice about a held bat that only the command line can follow."""
HIGHEST = 1.3
"""Times the highest expected tone, up to where the spectrum is drawn."""


def expected_tones(state: OwnState) -> list[dict[str, Any]]:
    """Return the tones that a free bat as described would have, and how strongly the tap excites each."""
    described, _ = unknown_of(state)
    modes, place = modes_to_name(described), _place(state, described)
    tones, highest = [], usual_band(modes).high
    for family in FAMILIES:
        if modes.of_family(family):
            family_tones = expected_of(modes, family, positions=[place])
            tones += [
                {"name": str(name), "frequency_hz": float(hertz), "excitation": float(part)}
                for name, hertz, part in zip(
                    family_tones.names, family_tones.frequency, family_tones.excitation, strict=True
                )
                if hertz < highest
            ]
    return sorted(tones, key=lambda tone: float(tone["frequency_hz"]))


def tap(state: OwnState) -> dict[str, Any]:
    """Return the results of recorded taps: the good ones, the faults of others, and the named tones of all together.

    A recording that cannot be read is refused with its reason; the others are heard without it.
    """
    sounds: list[_Sound] = []
    refused: list[dict[str, str]] = []
    for key in state.recordings:
        try:
            sounds.append(_recording(key))
        except InputError as error:
            path, name = UPLOADS.path_of(key)
            refused.append({"recording": key, "fault": str(error).replace(str(path), name)})
    nothing: dict[str, Any] = {"refused": refused, "taps": [], "tones": [], "spectrum": None, "fault": None,
                               "unlike": False, "doubts": []}  # fmt: skip
    if not sounds:
        return nothing
    described, _ = unknown_of(state)
    modes = modes_to_name(described)
    band, held = usual_band(modes), held_damping(modes)
    taps = [tap for sound in sounds for tap in _taps(sound, band, held)]
    head = nothing | {"taps": [_tap_row(tap) for tap in taps], "waveform": _wave(sounds[-1])}
    good = [tap for tap in taps if tap.good and tap.fit is not None]
    if not good:
        return head | {
            "fault": "no tap can be used: the list says what is wrong with each" if taps else "there is no tap in it"
        }
    question = TapQuestion([sound.recording for sound in sounds], described, [_place(state, described)])
    try:
        found = tap_answer(question, taps=taps)
    except InputError as error:
        return head | {"fault": str(error)}
    test, damping = found.test, found.damping
    unlike = test.unlike and isinstance(described, Bat)  # higher tones of other implements are known less well
    assert good[-1].fit is not None
    frequency, level = spectrum(good[-1].fit)
    drawn = frequency < HIGHEST * max(tone.frequency.value for tone in found.tones)
    return head | {
        "tones": [
            {"name": None if named.name is None else str(named.name), "frequency_hz": tone.frequency.value,
             "half_hz": tone.frequency.half_width, "damping_ratio": tone.damping_ratio.value,
             "expected_hz": tone.expected, "taps": tone.taps, "own": tone.own}
            for named, tone in zip(test.tones, found.tones, strict=True)
        ],
        "measured": [
            [name_of(measurement.mode), measurement.value.value, measurement.value.error]
            for measurement in found.measurements
            if measurement.mode
        ],
        "damping": None if damping is None or test.unheard else [damping.value, damping.error],
        "fault": _fault(test, damping is not None), "unlike": unlike, "doubts": _doubts(test, unlike),
        "spectrum": {"frequency_hz": np.round(frequency[drawn], 2), "level_db": np.round(level[drawn], 2)},
    }  # fmt: skip


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


def _tap_row(found: Tap) -> dict[str, Any]:
    fault = None if found.fault is None else found.fault.removesuffix(OF_COMMAND)
    return {"recording": found.recording, "time_s": found.start, "good": found.good, "fault": fault}


def _wave(sound: _Sound) -> dict[str, Any]:
    time, low, high = waveform(sound.recording, points=DRAWN)
    return {"name": sound.recording.name, "time_s": np.round(time, 5), "low": np.round(low, 4),
            "high": np.round(high, 4)}  # fmt: skip


def _place(state: OwnState, described: Implement) -> float:
    place = described.length - state.tap_from_tip_in * INCH
    if place < 0:
        raise FieldError(
            "tap_from_tip_in", f"{described.name} is {described.length / INCH:.4g} in long; tap it nearer the tip"
        )
    return place
