"""A recording of taps in other words: louder, upside down, later, in stereo, at another rate, in another file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from sweetspot.calibration.recording import Recording, read_recording, synthesised
from sweetspot.calibration.tap_analysis import tap_test
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array


@pytest.fixture(scope="module")
def sound(r161: Bat, baseball: Ball) -> Recording:
    return synthesised(
        all_modes(beam_model(r161), baseball), position=0.813, listened=0.80, taps=1, apart=0.7, noise=0.001, seed=4
    )


def tones(recording: Recording) -> Array:
    """Return frequency and damping of every tone, the lowest first."""
    found = tap_test([recording]).tones
    return np.array(sorted((each.tone.frequency.value, each.tone.damping_ratio.value) for each in found))


@pytest.fixture(scope="module")
def heard(sound: Recording) -> Array:
    found = tones(sound)
    assert len(found) >= 2
    return found


def quieter(sound: Recording) -> Recording:
    return replace(sound, samples=0.05 * sound.samples)


def upside_down(sound: Recording) -> Recording:
    return replace(sound, samples=-sound.samples)


def off_zero(sound: Recording) -> Recording:
    return replace(sound, samples=0.3 * sound.samples + 0.1)


def later(sound: Recording) -> Recording:
    return replace(sound, samples=np.concatenate([sound.samples[:6000], sound.samples]))


def longer(sound: Recording) -> Recording:
    return replace(sound, samples=np.concatenate([sound.samples, sound.samples[:6000]]))


@pytest.mark.parametrize(
    ("change", "rel"), [(quieter, 1e-9), (upside_down, 1e-9), (off_zero, 1e-5), (later, 1e-3), (longer, 1e-3)]
)
def test_the_same_taps(sound: Recording, heard: Array, change: Callable[[Recording], Recording], rel: float) -> None:
    """Exact but for where a window begins: how loud, how early and which way up is no property of a bat."""
    found = tones(change(sound))
    assert len(found) == len(heard)
    assert found[:, 0] == pytest.approx(heard[:, 0], rel=rel)
    assert found[:, 1] == pytest.approx(heard[:, 1], rel=100 * rel)


@pytest.mark.parametrize(
    ("name", "subtype"), [("a.wav", "PCM_16"), ("a.wav", "FLOAT"), ("a.flac", "PCM_24"), ("a.aiff", "PCM_24")]
)
@pytest.mark.parametrize("channels", [1, 2])
def test_the_same_file(tmp_path: Path, sound: Recording, heard: Array, name: str, subtype: str, channels: int) -> None:
    """Exact but for the last bit: one channel or two alike, of any coding that leaves out nothing."""
    path = tmp_path / name
    soundfile.write(path, np.column_stack([sound.samples] * channels), round(sound.rate), subtype=subtype)
    found = tones(read_recording(path))
    assert found[:, 0] == pytest.approx(heard[:, 0], rel=1e-4)


def test_faster_sound_is_higher(sound: Recording, heard: Array) -> None:
    """Exact: the same samples at a rate a tenth higher are tones a tenth higher (in a band as much higher)."""
    fast = replace(sound, rate=1.1 * sound.rate)
    lowest = tones(fast)[0]
    assert lowest[0] == pytest.approx(1.1 * heard[0, 0], rel=1e-3)
