"""The taps in a recording, without the hum of the mains: where each begins, whether it can be used, and why not.

A tap is a sudden rise of the sound in the band. It is used when `tap_faults` finds nothing wrong with it. The tones of
all good taps together are named after the modes that make them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.measured import Measured, pooled
from sweetspot.calibration.recording import FrequencyBand, Recording, in_band
from sweetspot.calibration.sinusoids import Fit, Sinusoid, fit_sinusoids, stands_out, with_room_error
from sweetspot.calibration.tap_faults import APART, CROWDED, HELD, SETTLE, blows, fault_of_fit, fault_of_sound, step_of
from sweetspot.errors import InputError
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
OFF, TRIED = 0.1, 401
"""Hz by which the mains are off at most, and how many frequencies are tried."""
STEADY = 0.9
"""Of a multiple's power that is steady over all quiet parts, at least."""


def without_hum(recording: Recording) -> Recording:
    """Return a recording without the mains that hum all through it; one without any, or never quiet, as it is.

    Hum is the same before, in and after a tap, and a tap is not. Where nothing is tapped, every tenth of a second holds
    whole periods of all multiples of 50 and of 60 Hz, whose complex amplitudes turn by 2 pi k d t where the mains are
    off by d. Multiples that turn so and keep their size are fitted by least squares to the quiet parts and taken from
    all of it. A filter would take from the tones beside them too; this leaves a tone that rings in the taps as it is.
    """
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
    for _ in range(ROUNDS):  # its ringing is found better without the hum
        left = parts - hum[:whole].reshape(-1, size)
        quiet = np.sort(np.argsort(np.mean(left**2, axis=1))[:count])
        hum = _steady_hum(parts[quiet], quiet * size, rate, len(samples))
    return hum


def _steady_hum(parts: Array, starts: NDArray[np.intp], rate: float, count: int) -> Array:
    """Return the steady part of a block's quiet parts, continued through all its samples, shape (count,)."""
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
    """Return the frequencies of the mains' multiples that keep their size over all parts, and their power."""
    number = np.arange(1, int(min(HIGHEST_HUM, 0.45 * rate) / base) + 1)
    time = np.arange(parts.shape[1]) / rate
    sizes = parts @ np.exp(-2j * np.pi * base * np.outer(time, number)) * (2 / parts.shape[1])
    sizes = sizes * np.exp(-2j * np.pi * base * np.outer(starts, number))
    tried = np.linspace(-OFF, OFF, TRIED)
    turned = np.exp(-2j * np.pi * tried[:, None, None] * starts[None, :, None] * number)
    steady = np.abs(np.mean(turned * sizes, axis=1)) ** 2
    best = int(np.argmax(steady.sum(axis=1)))
    is_steady: NDArray[np.bool_] = steady[best] > STEADY * np.mean(np.abs(sizes) ** 2, axis=0)
    return np.asarray(number[is_steady] * (base + tried[best])), float(steady[best][is_steady].sum())


def without_background(fit: Fit, earlier: Array) -> Fit:
    """Return a fit without the tones that were there before anything was tapped: of a fan, a motor, rushing air."""
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


FRAME = 0.002
"""s over which the loudness is taken."""
RISE = 10.0
"""dB above everything in the last `QUIET_BEFORE` s, where a tap begins."""
QUIET_BEFORE = 0.03
"""s before a tap that are quieter than its beginning."""
ABOVE_FLOOR = 10.0
"""dB of a tap's beginning above the quietest tenth of the recording, at least."""
WINDOW = 0.5
"""s of ringing that are used at most."""
BEFORE = 0.004
"""s before the first tap in which its filtered sound may begin."""
HUMLESS, CLEARER = 400.0, 6.0
"""Hz from which on taps are looked for where they stand out by this many dB more: mains and steps are below."""
FEWER_TONES = 1000.0
"""Hz up to which a tap is heard once more whose tones are more than a fit can hold."""
RINGS, LOUDER_PART = 2.0, 4.0
"""s that a tap rings at most, and times the power of a recording's quietest tenth of parts, above which it is sound."""
OTHER_SOUND = 1.0
"""Energy of other sound over that of taps, from which on a tap needs another that confirms it (assumed)."""
LOSSY = 0.03
"""Amplitude over the loudest tone's of the faintest tone that counts in a lossy format (assumed; made-up taps as OGG
and MP3 get tones of 0.01 to 0.08 that nothing made)."""
STEPS = 1.0
"""Steps of a recording that a tone's amplitude has at least: rounding makes overtones of a ring a few steps high
(assumed; made-up taps in 8 bit get tones of 0.05 to 0.84 steps that nothing made)."""


@dataclass(frozen=True)
class Tap:
    """One tap of a recording.

    Parameters
    ----------
    start : s from the beginning of the recording.
    fault : why it is not used; None: it is.
    fit : of its ringing; None where it was rejected before.
    heard_to : Hz up to which it was heard, where that is less than the band; above it has more tones than a fit.
    """

    recording: str
    start: float
    fault: str | None
    fit: Fit | None
    heard_to: float | None = None

    @property
    def good(self) -> bool:
        """Whether it is used."""
        return self.fault is None


def find_taps(recording: Recording, *, band: FrequencyBand, held: float = HELD) -> tuple[Tap, ...]:
    """Return all taps of a recording, good and bad."""
    clear = without_hum(recording)
    sound = in_band(clear, band)
    starts = _starts(_where_taps_stand_out(clear, sound, band))
    spans = list(pairwise([*starts, sound.duration]))
    quiet = starts[0] - BEFORE
    taps = [_tap(recording, sound, span, band, held=held, quiet=quiet) for span in spans]
    crowded = [index for index, tap in enumerate(taps) if tap.fault and CROWDED in tap.fault]
    if crowded and 2 * band.low < FEWER_TONES < band.high:
        lower = FrequencyBand(band.low, FEWER_TONES)
        low_sound = in_band(clear, lower)
        for index in crowded:
            again = _tap(recording, low_sound, spans[index], lower, held=held, quiet=quiet)
            taps[index] = replace(again, heard_to=FEWER_TONES) if again.good else taps[index]
    for index, (before, after) in enumerate(pairwise(starts)):
        if after - before < APART:
            fault = f"doubled: two taps {1e3 * (after - before):.0f} ms apart; let it ring between taps"
            taps[index : index + 2] = [replace(tap, fault=tap.fault or fault) for tap in taps[index : index + 2]]
    return _confirmed(taps, sound)


def _confirmed(taps: Sequence[Tap], sound: Recording) -> tuple[Tap, ...]:
    """Return taps, of which those count as none that no other confirms where the recording sounds on without them.

    In music and talk a beat may ring like a struck body; so among much other sound two taps must have the same loudest
    tone. In a recording of nothing but taps, one is enough.
    """
    good = [tap for tap in taps if tap.good and tap.fit and tap.fit.sinusoids]
    loudest = [max(tap.fit.sinusoids, key=lambda tone: tone.energy(WINDOW)).frequency.value for tap in good if tap.fit]
    alone = [
        tap
        for tap, tone in zip(good, loudest, strict=True)
        if sum(abs(other / tone - 1) < SAME for other in loudest) < 2
    ]
    if not alone or _other_sound(sound, [tap.start for tap in good]) < OTHER_SOUND:
        return tuple(taps)
    fault = "unconfirmed: the recording holds more other sound than taps, and no second tap has this one's tone; tap "
    return tuple(replace(tap, fault=fault + "in silence, twice or more") if tap in alone else tap for tap in taps)


def _other_sound(sound: Recording, starts: Sequence[float]) -> float:
    """Return the energy of a sound outside of taps over that within, without what is as loud as its quiet parts."""
    size = round(PART * sound.rate)
    parts = sound.samples[: len(sound.samples) // size * size].reshape(-1, size)
    power = np.mean(parts**2, axis=1)
    power = np.maximum(power - LOUDER_PART * np.quantile(power, 0.1), 0.0)
    begin = np.arange(len(power)) * PART
    within = np.any([(begin > start - 2 * PART) & (begin < start + RINGS) for start in starts], axis=0)
    return float(power[~within].sum() / max(power[within].sum(), 1e-300))


def _where_taps_stand_out(recording: Recording, sound: Recording, band: FrequencyBand) -> Recording:
    """Return the sound in its band, or without what is low where taps then stand out of hum much farther."""
    if not band.low < HUMLESS < min(band.high, 0.45 * recording.rate) / 2:
        return sound
    without = in_band(recording, FrequencyBand(HUMLESS, band.high))
    gains = []
    for entry in (sound, without):
        level, floor = _levels(entry)
        gains.append(float(level.max(initial=floor)) - floor)
    return without if gains[1] > gains[0] + CLEARER else sound


def _levels(sound: Recording) -> tuple[Array, float]:
    """Return the loudness of every frame in dB, and that of the recording's quietest tenth."""
    import scipy.ndimage

    frame = max(1, round(FRAME * sound.rate))
    count = len(sound.samples) // frame
    power = np.mean(sound.samples[: count * frame].reshape(count, frame) ** 2, axis=1)
    level = 10 * np.log10(power + 1e-30)
    if not count:
        return level, 0.0
    tops = scipy.ndimage.maximum_filter1d(level, round(QUIET_BEFORE / FRAME))  # hum is as loud as at its tops
    return level, float(np.quantile(tops, 0.1))


def _starts(sound: Recording) -> list[float]:
    """Return the times in s at which the sound suddenly rises; a recording may begin within a tap."""
    level, floor = _levels(sound)
    frame, count = max(1, round(FRAME * sound.rate)), len(level)
    if count < 3:
        return [0.0]
    # the ring of one tap may fill a recording; then its quietest tenth is no background
    starts = _rises(level, floor + ABOVE_FLOOR) or [index for index in _rises(level, -np.inf) if index]
    return [index * frame / sound.rate for index in starts] or [0.0]


def _rises(level: Array, least: float) -> list[int]:
    """Return the frames at which the loudness in dB suddenly rises to ``least`` or more."""
    before = round(QUIET_BEFORE / FRAME)
    starts: list[int] = []
    for index in range(len(level)):
        earlier = level[max(0, index - before) : index]
        # a recording may begin within a tap, which goes on: what is loud in its first frame alone is the filter's edge
        rises = level[index] > earlier.max() + RISE if len(earlier) else level[index + 1] > least
        apart = not starts or index - starts[-1] >= 2
        if rises and level[index] > least and level[index] > level.max() - 50 and apart:
            starts.append(index)
    merged: list[int] = []
    for index in starts:  # the rise of one tap may take several frames
        if not merged or index - merged[-1] > SETTLE / FRAME:
            merged.append(index)
    return merged


def _tap(
    recording: Recording, sound: Recording, span: tuple[float, float], band: FrequencyBand, *, held: float, quiet: float
) -> Tap:
    """Return the sound that begins at the first of two times in s, and is heard to the second."""
    start, end = span
    background = float(10 ** (_levels(sound)[1] / 10))
    raw = recording.samples[int(start * recording.rate) : int(min(end, start + WINDOW) * recording.rate)]
    whole = sound.samples[int(start * sound.rate) : int(min(end, start + WINDOW) * sound.rate)]
    step = step_of(raw)
    struck = blows(whole, sound.rate, finest_step=step)
    if fault := fault_of_sound(raw, whole, struck, sound.rate, step=step, lasts=end - start):
        return Tap(recording.name, start, fault, None)
    window = whole[int((struck.max(initial=0.0) + SETTLE) * sound.rate) :]
    fit = fit_sinusoids(window, sound.rate, band=band)
    fit = without_background(fit, sound.samples[: max(int(quiet * sound.rate), 0)])
    tones = with_room_error(_louder_than_losses(fit.sinusoids, recording))
    fit = replace(fit, sinusoids=tuple(tone for tone in tones if tone.amplitude >= STEPS * step))
    return Tap(recording.name, start, fault_of_fit(fit, background=background, held=held), fit)


def _louder_than_losses(tones: tuple[Sinusoid, ...], recording: Recording) -> tuple[Sinusoid, ...]:
    """Return the tones of a recording that leaves out what is hard to hear, without those that this itself may make."""
    least = LOSSY * max((tone.amplitude for tone in tones), default=0.0) if recording.lossy else 0.0
    return tuple(tone for tone in tones if tone.amplitude >= least)


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
    heard = []
    for number, (fit, _) in enumerate(used):
        loudest = max((tone.amplitude for tone in fit.sinusoids), default=1.0)
        heard += [
            _Heard(tone, number, tone.amplitude / loudest, stands_out(tone, fit.sinusoids)) for tone in fit.sinusoids
        ]
    heard.sort(key=lambda entry: entry.tone.frequency.value)
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
