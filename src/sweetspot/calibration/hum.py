"""The mains in a recording: steady tones at the multiples of 50 or 60 Hz, and how they are taken out.

Hum is the same before, in and after a tap, and a tap is not. Where nothing is tapped, every tenth of a second holds
whole periods of all multiples of 50 and of 60 Hz, whose complex amplitudes turn by 2 pi k d t where the mains are off
by d. Multiples that turn so and keep their size are fitted by least squares to the quiet parts and taken from all of
it. A filter would take from the tones beside them too; this leaves a tone that rings in the taps as it is.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.recording import Recording
from sweetspot.calibration.sinusoids import Fit, Sinusoid
from sweetspot.numerics.arrays import Array

MAINS, HIGHEST_HUM = (50.0, 60.0), 1000.0
"""Hz of the mains, and up to where their multiples are looked for (assumed)."""
AS_LOUD = 0.5
"""Amplitude of hum before a tap over that after it, at least."""
WANDERS, LONGEST_BEFORE, SHORTEST_BEFORE = 0.01, 0.5, 0.1
"""Part of its frequency by which the tone of a fan or a motor wanders, and s of sound before the first tap that say
how loud it is, at most and at least (assumed)."""
PART, BLOCK = 0.1, 5.0
"""s of a part with whole periods of both mains, and of the sound in which they keep frequency and amplitude."""
FEWEST = 4
"""Quiet parts of a block at least."""
QUIET, ROUNDS = 0.25, 3
"""Part of all parts that counts as quiet, and how often they are chosen."""
OFF, STEPS = 0.1, 401
"""Hz by which the mains are off at most, and how many frequencies are tried."""
STEADY = 0.9
"""Of a multiple's power that is steady over all quiet parts, at least."""


def hum_taken_out(recording: Recording) -> Recording:
    """Return a recording without the mains that hum all through it; one without any, or never quiet, as it is."""
    samples, rate = recording.samples, recording.rate
    size, count = round(PART * rate), round(BLOCK * rate)
    blocks = max(1, round(len(samples) / count))
    edges = np.linspace(0, len(samples), blocks + 1).round().astype(int)
    hum = np.concatenate([_hum(samples[low:high], rate, size) for low, high in pairwise(edges)])
    return replace(recording, samples=recording.samples - hum) if hum.any() else recording


def _hum(samples: Array, rate: float, size: int) -> Array:
    """Return the mains in one block of sound: zero where none is steady."""
    whole = len(samples) // size * size
    parts = samples[:whole].reshape(-1, size)
    ramp = np.stack([np.ones(size), np.linspace(-1, 1, size)]) / np.sqrt(size)
    ramp[1] /= np.linalg.norm(ramp[1])
    parts = parts - parts @ ramp.T @ ramp  # what drifts is no hum
    hum = np.zeros_like(samples)
    count = int(QUIET * len(parts))
    if count < FEWEST:
        return hum
    for _ in range(ROUNDS):  # where it rings is told better without the hum
        left = parts - hum[:whole].reshape(-1, size)
        quiet = np.sort(np.argsort(np.mean(left**2, axis=1))[:count])
        hum = _steady_hum(parts[quiet], quiet * size, rate, len(samples))
    return hum


def _steady_hum(parts: Array, starts: NDArray[np.intp], rate: float, count: int) -> Array:
    """Return what is steady in quiet parts of a block, all through its samples, shape (count,).

    Parameters
    ----------
    parts : quiet sound, shape (n, size).
    starts : samples before each, shape (n,).
    """
    hum, time = np.zeros(count), np.arange(count) / rate
    frequencies, _ = max((_steady(parts, starts / rate, rate, base) for base in MAINS), key=lambda entry: entry[1])
    if not len(frequencies):
        return hum
    there = (starts[:, None] + np.arange(parts.shape[1])).ravel()
    turning = 2 * np.pi * np.outer(time[there], frequencies)
    sizes = np.linalg.lstsq(np.hstack([np.cos(turning), np.sin(turning)]), parts.ravel(), rcond=None)[0]
    for frequency, cosine, sine in zip(frequencies, *np.split(sizes, 2), strict=True):
        hum += cosine * np.cos(2 * np.pi * frequency * time) + sine * np.sin(2 * np.pi * frequency * time)
    return hum


def _steady(parts: Array, starts: Array, rate: float, base: float) -> tuple[Array, float]:
    """Return the frequencies of the mains' multiples that keep their size over all parts, and their power.

    Parameters
    ----------
    parts : quiet sound, shape (n, size).
    starts : when each begins, s, shape (n,).
    base : Hz of the mains.
    """
    number = np.arange(1, int(min(HIGHEST_HUM, 0.45 * rate) / base) + 1)
    time = np.arange(parts.shape[1]) / rate
    sizes = parts @ np.exp(-2j * np.pi * base * np.outer(time, number)) * (2 / parts.shape[1])
    sizes = sizes * np.exp(-2j * np.pi * base * np.outer(starts, number))
    tried = np.linspace(-OFF, OFF, STEPS)
    turned = np.exp(-2j * np.pi * tried[:, None, None] * starts[None, :, None] * number)
    steady = np.abs(np.mean(turned * sizes, axis=1)) ** 2
    best = int(np.argmax(steady.sum(axis=1)))
    is_steady: NDArray[np.bool_] = steady[best] > STEADY * np.mean(np.abs(sizes) ** 2, axis=0)
    return np.asarray(number[is_steady] * (base + tried[best])), float(steady[best][is_steady].sum())


def risen(fit: Fit, earlier: Array) -> Fit:
    """Return a fit without the tones that were there before anything was tapped: of a fan, a motor, rushing air.

    Parameters
    ----------
    earlier : the sound before the first tap of the recording; too little of it says nothing.
    """
    import scipy.signal

    quiet = earlier[-round(LONGEST_BEFORE * fit.rate) :]
    if len(quiet) < SHORTEST_BEFORE * fit.rate:
        return fit
    window = scipy.signal.windows.hann(len(quiet), sym=False)
    # by Parseval's theorem a sine of amplitude a has the sum N a^2 / 4 of the window's squares in its bins
    power = 4 * np.abs(np.fft.rfft(window * quiet)) ** 2 / (len(quiet) * np.sum(window**2))
    frequency = np.fft.rfftfreq(len(quiet), 1 / fit.rate)

    def before(sinusoid: Sinusoid) -> float:
        reach = WANDERS * sinusoid.frequency.value + 2 * fit.rate / len(quiet)
        return float(np.sqrt(power[np.abs(frequency - sinusoid.frequency.value) < reach].sum()))

    return replace(
        fit, sinusoids=tuple(sinusoid for sinusoid in fit.sinusoids if before(sinusoid) < AS_LOUD * sinusoid.amplitude)
    )
