"""The sound of a tapped implement, made from its modes: the inverse of reading a recording.

A half-sine tap leaves mode i with a speed in proportion to s_i(x) G(w_i) (`sweetspot.dynamics.modes.tapped`); a
microphone near the place y hears the surface's acceleration there, w_i s_i(y) times it.
"""

from __future__ import annotations

import numpy as np

from sweetspot.calibration.recording import Recording
from sweetspot.dynamics.modes import Modes, tapped
from sweetspot.numerics.arrays import Array

RATE = 44100.0
"""Samples per s."""
SOFT_TAP = 0.0004
"""s, contact of a small hard hammer with wood (assumed)."""
LOUDNESS = 0.5
"""Of full scale, the loudest sample of the loudest tap."""


def tap_sound(modes: Modes, *, position: float, listened: float, duration: float = SOFT_TAP, seconds: float = 1.0,
              rate: float = RATE) -> Array:  # fmt: skip
    """Return the sound of one tap from its beginning on, in any unit, shape (n,).

    Parameters
    ----------
    modes : of the free implement.
    position, listened : m from the knob end, where it is tapped and where the microphone is.
    duration : of the contact, s.
    seconds, rate : length of the sound and samples per s.
    """
    ringing = [index for index, family in enumerate(modes.families) if family != "rigid"]
    time = np.arange(round(seconds * rate)) / rate
    natural, ratio = modes.angular_frequency[ringing], modes.damping_ratio[ringing]
    speed = tapped(modes, position=position, duration=duration)[ringing]
    loud = speed * modes.shape_at(listened)[ringing] * natural
    heard = 2 * np.pi * 0.45 * rate > natural
    sound = np.zeros_like(time)
    for amplitude, omega, zeta in zip(loud[heard], natural[heard], ratio[heard], strict=True):
        sound += amplitude * np.exp(-zeta * omega * time) * np.sin(omega * np.sqrt(1 - zeta**2) * time)
    return sound


def synthesised(
    modes: Modes, *, position: float, listened: float, taps: int = 3, apart: float = 1.0, noise: float = 0.002,
    seed: int = 1,
) -> Recording:  # fmt: skip
    """Return a recording of several taps of different strength in white noise.

    Parameters
    ----------
    position, listened : m from the knob end, where it is tapped and where the microphone is.
    taps : number of taps.
    apart : s from tap to tap.
    noise : rms over the loudest sample.
    seed : of noise and strengths.
    """
    generator = np.random.default_rng(seed)
    tap = tap_sound(modes, position=position, listened=listened, seconds=apart)
    tap = LOUDNESS * tap / np.abs(tap).max()
    strength = generator.uniform(0.6, 1.0, taps)
    quiet = np.zeros(round(0.3 * RATE))
    sound = np.concatenate([quiet, *(part * tap for part in strength)])
    return Recording("synthetic", sound + noise * LOUDNESS * generator.standard_normal(len(sound)), RATE)
