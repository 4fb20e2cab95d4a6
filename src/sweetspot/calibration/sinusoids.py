"""Damped sinusoids fitted to a ringing sound: frequency, damping and amplitude of each, with errors.

y(t) = sum_k exp(-d_k t) (a_k cos(w_k t) + b_k sin(w_k t)), f = w / (2 pi), zeta = d / sqrt(w^2 + d^2).

One sinusoid after the other is found as the highest peak of what is left, beginning with the peak of the zero-padded
spectrum (refined by a parabola) and the decay from one half of the window to the other; then all are fitted together by
least squares with the exact Jacobian. An error comes from the covariance at the noise that is left around its own
frequency.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.recording import FrequencyBand
from sweetspot.numerics.arrays import Array

MOST = 16
"""Sinusoids at most."""
OVER_NOISE = 25.0
"""Power of a peak over the median of the noise around it: noise alone has its highest of 1,000 bins at 10."""
FAINTEST = 3e-3
"""Amplitude over that of the loudest sinusoid."""
TWIN = 0.02
"""Two sinusoids closer than this part of their frequency are one mode in two planes, or one that is no pure
exponential: the fainter counts only from `TWIN_SHARE` of the louder."""
TWIN_SHARE = 0.15
"""Amplitude of the fainter of two such over the louder's, at least."""
LOCAL = 0.15
"""Half width of the surroundings whose noise counts, as a part of the frequency."""
NARROWEST = 40.0
"""Hz, half width of the surroundings at least."""
WORST = 0.02
"""Error of a frequency as a part of it, from which on it is not known."""
FASTEST_DECAY = 0.12
"""Damping ratio; what dies away faster is a thump."""
TAIL = 4
"""The last of this many parts of the window; when what rings has died away there, it holds the noise."""
PADDING = 8
"""Times the window's length over which a spectrum is taken, so that peaks are smooth."""
SLOWEST_DECAY, LARGEST_LOG = 1e-3, 12.0
"""1/s at the start of a fit, and the largest logarithm of a decay rate in it."""
LOUD_PART = 0.9
"""Of the energy of a window, in the part of it of which a misfit speaks."""
ROUGHLY, FINALLY = 5, 60
"""Evaluations while sinusoids are still being found, and of the last fit."""


@dataclass(frozen=True)
class Sinusoid:
    """One ringing tone.

    Parameters
    ----------
    frequency : Hz, of the damped oscillation.
    damping_ratio : fraction of critical.
    amplitude : at the beginning of the window, in the sound's own unit.
    shared_error : Hz, one sigma of the frequency that all taps in one room share; see `with_room_error`.
    """

    frequency: Measured
    damping_ratio: Measured
    amplitude: float
    shared_error: float = 0.0

    def energy(self, seconds: float) -> float:
        """Return the integral of its square over its first ``seconds``, in the sound's own unit squared times s."""
        decay = max(2 * np.pi * self.frequency.value * self.damping_ratio.value, SLOWEST_DECAY)
        return -float(np.expm1(-2 * decay * seconds)) * self.amplitude**2 / (4 * decay)


@dataclass(frozen=True)
class Fit:
    """The decomposition of a window of sound into damped sinusoids.

    ``misfit``: rms of what is left over rms of the sound, of the part in which it rings. ``rate``: samples per s.
    """

    sinusoids: tuple[Sinusoid, ...]
    misfit: float
    samples: Array
    fitted: Array
    rate: float


def fit_sinusoids(samples: Array, rate: float, *, band: FrequencyBand, most: int = MOST) -> Fit:
    """Take a window of sound apart into damped sinusoids.

    ``samples``: from shortly after the blow on, shape (n,). ``rate``: samples per s.
    """
    time = np.arange(len(samples)) / rate
    parameters = np.zeros((0, 4))
    for _ in range(most):
        left = samples - _model(parameters, time)
        start = _next_peak(left, parameters, rate, band)
        if start is None:
            break
        parameters = _refined(np.vstack([parameters, start]), samples, time, trials=ROUGHLY)
        parameters = parameters[_rings(parameters)]
    if len(parameters):
        parameters = _refined(parameters, samples, time, trials=FINALLY)
        parameters = parameters[_rings(parameters)]
        parameters = parameters[np.argsort(parameters[:, 0])]
    fitted = _model(parameters, time)
    sinusoids = [sinusoid for sinusoid in _with_errors(parameters, samples - fitted, time) if _counts(sinusoid, band)]
    loudest = max((sinusoid.amplitude for sinusoid in sinusoids), default=0.0)
    heard = tuple(sinusoid for sinusoid in sinusoids if sinusoid.amplitude > FAINTEST * loudest)
    return Fit(heard, _misfit(samples, fitted, rate, band), samples, fitted, rate)


def _model(parameters: Array, time: Array) -> Array:
    """Return the sum of sinusoids with rows (f, d, a, b)."""
    total = np.zeros_like(time)
    for frequency, decay, cosine, sine in parameters:
        phase = 2 * np.pi * frequency * time
        total += np.exp(-decay * time) * (cosine * np.cos(phase) + sine * np.sin(phase))
    return total


def _jacobian(parameters: Array, time: Array) -> Array:
    """Return the derivatives of `_model`, shape (n, 4 k)."""
    columns = []
    for frequency, decay, cosine, sine in parameters:
        phase, envelope = 2 * np.pi * frequency * time, np.exp(-decay * time)
        in_phase, ahead = envelope * np.cos(phase), envelope * np.sin(phase)
        columns += [
            2 * np.pi * time * (sine * in_phase - cosine * ahead),
            -time * (cosine * in_phase + sine * ahead),
            in_phase,
            ahead,
        ]
    return np.array(columns).T


def _refined(parameters: Array, samples: Array, time: Array, *, trials: int) -> Array:
    """Return the least-squares parameters nearest to the given ones; fitted in log d: decays stay positive."""
    from scipy.optimize import least_squares

    def unpacked(unknowns: Array) -> Array:
        rows = unknowns.reshape(-1, 4).copy()
        rows[:, 1] = np.exp(np.minimum(rows[:, 1], LARGEST_LOG))
        return rows

    def jacobian(unknowns: Array) -> Array:
        rows = unpacked(unknowns)
        matrix = _jacobian(rows, time)
        matrix[:, 1::4] *= rows[:, 1]
        return matrix

    start = parameters.copy()
    start[:, 1] = np.log(np.maximum(start[:, 1], SLOWEST_DECAY))

    def misses(unknowns: Array) -> Array:
        return _model(unpacked(unknowns), time) - samples

    fit = least_squares(misses, start.ravel(), jac=jacobian, method="lm", x_scale="jac", max_nfev=trials, ftol=1e-10)
    return unpacked(fit.x)


def _next_peak(left: Array, found: Array, rate: float, band: FrequencyBand) -> Array | None:
    """Return a start (f, d, a, b) for the highest peak that stands out of its surroundings, or None."""
    size = PADDING * len(left)
    power = np.abs(np.fft.rfft(left, size)) ** 2
    frequency = np.asarray(np.fft.rfftfreq(size, 1 / rate), dtype=np.float64)
    quiet = np.abs(np.fft.rfft(left[-len(left) // TAIL :], size)) ** 2
    inside = frequency > band.low  # strong tones above the band are taken out too: their skirts reach into it
    allowed = inside.copy()
    for near in found:
        amplitude = np.hypot(near[2], near[3])
        strength = (TWIN_SHARE * amplitude / 2 * rate * min(1 / max(near[1], 1e-9), len(left) / rate)) ** 2
        allowed &= (np.abs(frequency - near[0]) > TWIN * near[0]) | (power > strength)
    while allowed.any():
        peak = int(np.argmax(np.where(allowed, power, 0.0)))
        width = max(LOCAL * frequency[peak], NARROWEST)
        around = inside & (np.abs(frequency - frequency[peak]) < width)
        noise = min(np.median(power[around]), TAIL * np.median(quiet[around]))
        if 0 < peak < len(power) - 1 and power[peak] > OVER_NOISE * noise:
            return _start(left, rate, frequency, power, peak)
        allowed &= np.abs(frequency - frequency[peak]) > width / 4
    return None


def _start(left: Array, rate: float, frequency: Array, power: Array, peak: int) -> Array:
    before, top, after = np.log(power[peak - 1 : peak + 2])
    shift = 0.5 * (before - after) / (before - 2 * top + after) if before - 2 * top + after else 0.0
    tone = frequency[peak] + shift * (frequency[1] - frequency[0])
    time = np.arange(len(left)) / rate
    turning = left * np.exp(-2j * np.pi * tone * time)
    half = len(left) // 2
    early, late = abs(turning[:half].sum()), abs(turning[half : 2 * half].sum())
    decay = max(np.log(max(early, 1e-300) / max(late, 1e-300)) * rate / half, 0.5 * rate / len(left))
    basis = np.exp(-decay * time)[:, None] * np.stack(
        [np.cos(2 * np.pi * tone * time), np.sin(2 * np.pi * tone * time)], 1
    )
    cosine, sine = np.linalg.lstsq(basis, left, rcond=None)[0]
    return np.array([tone, decay, cosine, sine])


def _rings(parameters: Array) -> NDArray[np.bool_]:
    """Return which rows decay slowly enough to be a tone."""
    return np.asarray(np.abs(parameters[:, 1]) < FASTEST_DECAY * 2 * np.pi * np.abs(parameters[:, 0]))


def _counts(sinusoid: Sinusoid, band: FrequencyBand) -> bool:
    """Return whether a tone lies in the band and its frequency is known."""
    return (
        band.low < sinusoid.frequency.value < band.high and sinusoid.frequency.error < WORST * sinusoid.frequency.value
    )


def _with_errors(parameters: Array, left: Array, time: Array) -> tuple[Sinusoid, ...]:
    """Return the sinusoids with errors: covariance of the fit at the noise density around each of them."""
    if not len(parameters):
        return ()
    rate = 1 / (time[1] - time[0])
    jacobian = _jacobian(parameters, time)
    scale = np.linalg.norm(jacobian, axis=0)
    covariance = np.linalg.pinv((jacobian / scale).T @ (jacobian / scale)) / np.outer(scale, scale)
    density = np.abs(np.fft.rfft(left)) ** 2 / len(left)  # white noise of variance s^2 has s^2 in every bin
    frequency = np.fft.rfftfreq(len(left), 1 / rate)
    sinusoids = []
    for index, (tone, decay, cosine, sine) in enumerate(parameters):
        near = np.abs(frequency - tone) < max(LOCAL / 3 * tone, NARROWEST)
        noise = float(np.mean(density[near]))
        tone_error, decay_error = np.sqrt(noise * np.diag(covariance)[4 * index : 4 * index + 2])
        natural = 2 * np.pi * tone
        ratio = decay / np.hypot(natural, decay)
        sinusoids.append(
            Sinusoid(
                Measured(float(tone), float(tone_error)),
                Measured(float(ratio), float(decay_error / natural)),
                float(np.hypot(cosine, sine)),
            )
        )
    return tuple(sinusoids)


def _misfit(samples: Array, fitted: Array, rate: float, band: FrequencyBand) -> float:
    """Return rms left over rms inside the band, of the part that holds nine tenths of the energy."""
    import scipy.signal

    bandpass = scipy.signal.butter(4, (band.low, min(band.high, 0.46 * rate)), "bandpass", fs=rate, output="sos")
    left, whole = (scipy.signal.sosfiltfilt(bandpass, signal) for signal in (samples - fitted, samples))
    energy = np.cumsum(whole**2)
    end = int(np.searchsorted(energy, LOUD_PART * energy[-1])) + 1
    return float(np.sqrt(np.sum(left[:end] ** 2) / max(energy[end - 1], 1e-300)))


ECHO = 0.1
"""Part of its frequency within which a tone with less energy than another may be its echo (assumed)."""
AUDIBLE, WEIGHTY = 1e-3, 1e-2
"""Energy over that of the tone with most, below which a tone may be the room's, and below which its damping says
nothing of the body (both assumed; of 103 tones that made-up rooms added to 16 taps, 3 hold more than the first and
none more than the second without another beside it)."""
NEAR = 0.04
"""Part of its frequency within which a tone's neighbours may be the room's (assumed)."""
IN_A_ROOM = 0.5
"""Part of all tones that have neighbours, from which on they are the room's: two planes or two modes of an implement
give a neighbour or two (assumed)."""


def stands_out(sinusoid: Sinusoid, tones: Sequence[Sinusoid], *, least: float = AUDIBLE) -> bool:
    """Return whether a tone is surely the tapped body's: no other near it holds more energy, and it holds enough.

    A room only gives back what the body rang into it, spread over its own many tones that die away sooner. So the
    body's tone has most of the energy around it. Of a mode in two planes the fainter does not stand out either.
    """
    energy_of_it, energies = sinusoid.energy(math.inf), [other.energy(math.inf) for other in tones]
    near = (
        energy
        for other, energy in zip(tones, energies, strict=True)
        if abs(other.frequency.value - sinusoid.frequency.value) < ECHO * sinusoid.frequency.value
    )
    return energy_of_it >= max(near, default=energy_of_it) and energy_of_it >= least * max(
        energies, default=energy_of_it
    )


def with_room_error(tones: tuple[Sinusoid, ...]) -> tuple[Sinusoid, ...]:
    """Return tones with the error that a room adds to each: the spread of its energy over its neighbours.

    sigma^2 = sum E_j (f_j - f)^2 / sum E_j over the tones within `NEAR`, E = a^2 / (zeta f) the energy of each. Where
    less than `IN_A_ROOM` of the tones have neighbours nothing is left open.
    """
    if len(tones) < 2:
        return tones
    frequency = np.array([tone.frequency.value for tone in tones])
    near = np.abs(frequency[:, None] - frequency) < NEAR * frequency[:, None]
    if np.mean(near.sum(axis=1) > 1) < IN_A_ROOM:
        return tones
    energy: Array = near * np.array([tone.energy(math.inf) for tone in tones])
    spread = np.sqrt(np.sum(energy * (frequency[:, None] - frequency) ** 2, axis=1) / energy.sum(axis=1))
    return tuple(replace(entry, shared_error=float(item)) for entry, item in zip(tones, spread, strict=True))
