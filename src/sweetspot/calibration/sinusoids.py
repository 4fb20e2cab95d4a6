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
from typing import NamedTuple

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
"""Steps while sinusoids are still being found, and of the last fit."""
SINGULAR = 1e-12
"""Of the scaled normal equations, the least eigenvalue: tones that are one have errors so large that neither counts."""
ROWS = 16
"""Of the products of matrices that a fit is made of."""
SETTLED = 1e-8
"""Part of the squares that are left, by which a step that changes less ends a fit."""


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
        parameters = parameters[_rings(parameters, rate)]
    if len(parameters):
        parameters = _refined(parameters, samples, time, trials=FINALLY)
        parameters = parameters[_rings(parameters, rate)]
        parameters = parameters[np.argsort(parameters[:, 0])]
    fitted = _model(parameters, time)
    sinusoids = [sinusoid for sinusoid in _with_errors(parameters, samples - fitted, time) if _counts(sinusoid, band)]
    loudest = max((sinusoid.amplitude for sinusoid in sinusoids), default=0.0)
    heard = tuple(sinusoid for sinusoid in sinusoids if sinusoid.amplitude > FAINTEST * loudest)
    return Fit(heard, _misfit(samples, fitted, rate, band), samples, fitted, rate)


class _Powers(NamedTuple):
    """Powers z^n of z = exp((-d + i w) dt) of each row (f, d, a, b), as products of coarse and fine ones.

    ``coarse``, ``fine``: z^(m j) and z^l, shapes (k, -) and (k, m); so n = m j + l. Sums over all n are products of
    matrices so small that no library shares them out to threads, which would take longer, and no array of k n numbers
    is made.
    """

    coarse: NDArray[np.complex128]
    fine: NDArray[np.complex128]


def _powers(parameters: Array, time: Array) -> _Powers:
    step, size = float(time[1] - time[0]), math.isqrt(len(time)) + 1
    rate = (-parameters[:, 1] + 2j * np.pi * parameters[:, 0]) * step
    rows = ROWS * -(-len(time) // (size * ROWS))
    coarse = np.exp(np.multiply.outer(rate, size * np.arange(rows)))
    return _Powers(coarse, np.exp(np.multiply.outer(rate, np.arange(size))))


def _model(parameters: Array, time: Array) -> Array:
    """Return the sum of sinusoids with rows (f, d, a, b)."""
    return _summed(parameters, _powers(parameters, time), len(time))


def _summed(parameters: Array, powers: _Powers, count: int) -> Array:
    size = parameters[:, 2] - 1j * parameters[:, 3]
    coarse = (size[:, None] * powers.coarse).T.reshape(powers.coarse.shape[1] // ROWS, ROWS, len(size))
    return np.asarray((coarse @ powers.fine).real.ravel()[:count])


def _projected(powers: _Powers, samples: Array) -> NDArray[np.complex128]:
    """Return the sum of z^n times the n-th sample, shape (k,)."""
    filled = np.zeros((powers.coarse.shape[1] // ROWS, ROWS, powers.fine.shape[1]))
    filled.ravel()[: len(samples)] = samples
    sums = filled @ powers.fine.T
    return np.asarray(np.einsum("kn,nk->k", powers.coarse, sums.reshape(powers.coarse.shape[::-1])))


def _slopes(parameters: Array) -> NDArray[np.complex128]:
    """Return the factors g of the model's derivatives by f, d, a and b, shape (k, 4).

    Each derivative is Re(g z^n), those by f and d times t, where z^n are `_powers`.
    """
    size = parameters[:, 2] - 1j * parameters[:, 3]
    return np.stack([2j * np.pi * size, -size, np.ones_like(size), np.full_like(size, -1j)], axis=1)


def _gram(parameters: Array, slopes: NDArray[np.complex128], time: Array) -> Array:
    """Return the inner products of the model's derivatives, shape (4 k, 4 k), from sums of geometric series.

    sum Re(g z^n) Re(h y^n) = Re(g h sum (z y)^n + g h* sum (z y*)^n) / 2, with n or n^2 before it where t is.
    """
    step, count = float(time[1] - time[0]), len(time)
    rate = np.asarray((-parameters[:, 1] + 2j * np.pi * parameters[:, 0]) * step, np.complex128)
    order = np.array([1, 1, 0, 0])
    times = (order[:, None] + order)[None, :, None, :]
    total = np.zeros((len(parameters), 4, len(parameters), 4))
    for other, factors in ((rate, slopes), (rate.conj(), slopes.conj())):
        sums = _geometric(rate[:, None] + other, count)
        pairs = np.where(times == 0, sums[0][:, None, :, None], sums[1][:, None, :, None] * step)
        pairs = np.where(times == 2, sums[2][:, None, :, None] * step**2, pairs)
        total += (slopes[:, :, None, None] * factors * pairs).real / 2
    return total.reshape(4 * len(parameters), -1)


def _geometric(exponent: NDArray[np.complex128], count: int) -> NDArray[np.complex128]:
    """Return the sums of q^n, n q^n and n^2 q^n over n < ``count``, where q = e^exponent is not 1, shape (3, ...)."""
    away, ratio = -np.expm1(exponent), np.exp(exponent)
    last = np.exp(count * exponent)
    plain = -np.expm1(count * exponent) / away
    first = (ratio * plain - count * last) / away
    second = (ratio * (plain + 2 * first) - count**2 * last) / away
    return np.stack([plain, first, second])


def _refined(parameters: Array, samples: Array, time: Array, *, trials: int) -> Array:
    """Return the least-squares parameters nearest to the given ones; fitted in log d: decays stay positive.

    Levenberg and Marquardt's steps on the normal equations, which are sums of geometric series: what a room adds to a
    tap costs little more than a clean one.
    """
    import scipy.linalg

    rows = parameters.copy()
    rows[:, 1] = np.clip(rows[:, 1], SLOWEST_DECAY, math.exp(LARGEST_LOG))
    powers = _powers(rows, time)
    left = samples - _summed(rows, powers, len(time))
    damping, growth, square = 1e-3, 2.0, float(left @ left)
    for _ in range(trials):
        slopes = _slopes(rows)
        slopes[:, 1] *= rows[:, 1]
        matrix = _gram(rows, slopes, time)
        later, plain = _projected(powers, time * left), _projected(powers, left)
        gradient = (slopes * np.stack([later, later, plain, plain], axis=1)).real.ravel()
        scale = np.sqrt(np.maximum(np.diag(matrix), 1e-300))
        whole = matrix / np.outer(scale, scale)
        try:
            factors = scipy.linalg.cho_factor(whole + damping * np.eye(len(whole)))
        except scipy.linalg.LinAlgError:
            damping, growth = damping * growth, 2 * growth
            continue
        step = scipy.linalg.cho_solve(factors, gradient / scale)
        expected = float(step @ (damping * step + gradient / scale))
        tried = rows + (step / scale).reshape(-1, 4)
        tried[:, 1] = np.minimum(rows[:, 1] * np.exp(np.minimum((step / scale)[1::4], 2.0)), math.exp(LARGEST_LOG))
        tried[:, 1] = np.maximum(tried[:, 1], SLOWEST_DECAY / 1e3)
        new_powers = _powers(tried, time)
        new_left = samples - _summed(tried, new_powers, len(time))
        new_square = float(new_left @ new_left)
        gain = (square - new_square) / max(expected, 1e-300)
        if new_square < square:
            settled = max(square - new_square, expected) < SETTLED * square
            rows, powers, left, square = tried, new_powers, new_left, new_square
            damping, growth = damping * max(1 / 3, 1 - (2 * gain - 1) ** 3), 2.0
            if settled:
                break
        elif expected < SETTLED * square:
            break
        else:
            damping, growth = damping * growth, 2 * growth
    return rows


def _next_peak(left: Array, found: Array, rate: float, band: FrequencyBand) -> Array | None:
    """Return a start (f, d, a, b) for the highest peak that stands out of its surroundings, or None."""
    import scipy.fft

    size = scipy.fft.next_fast_len(PADDING * len(left), real=True)
    power = np.abs(scipy.fft.rfft(left, size)) ** 2
    frequency = np.asarray(np.fft.rfftfreq(size, 1 / rate), dtype=np.float64)
    quiet = np.abs(scipy.fft.rfft(left[-len(left) // TAIL :], size)) ** 2
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


def _rings(parameters: Array, rate: float) -> NDArray[np.bool_]:
    """Return which rows are a tone: below half of the rate, where steps of the fit may leave it, and slow to decay."""
    frequency = parameters[:, 0]
    slow = np.abs(parameters[:, 1]) < FASTEST_DECAY * 2 * np.pi * np.abs(frequency)
    return np.asarray(slow & (frequency > 0) & (frequency < rate / 2))


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
    normal = _gram(parameters, _slopes(parameters), time)
    scale = np.sqrt(np.diag(normal))
    spread, directions = np.linalg.eigh(normal / np.outer(scale, scale))
    covariance = (directions / np.maximum(spread, SINGULAR)) @ directions.T / np.outer(scale, scale)
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
