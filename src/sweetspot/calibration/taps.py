"""The taps in a recording: where each begins, whether it can be used, and why not.

A tap is a sudden rise of the sound in the band. It is used when it is not clipped, when no second blow falls into its
ringing, when the ringing stands out of the noise, and when it lasts as long as that of a freely hung implement. A
second blow shows as a burst in what linear prediction cannot foresee: a sum of damped sinusoids can be foreseen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from sweetspot.calibration.recording import Band, Recording, in_band
from sweetspot.calibration.sinusoids import Fit, Sinusoid, fit_sinusoids
from sweetspot.numerics.arrays import Array

FRAME = 0.002
"""s over which the loudness is taken."""
RISE = 10.0
"""dB above everything in the last `QUIET_BEFORE` s, where a tap begins."""
QUIET_BEFORE = 0.03
ABOVE_FLOOR = 10.0
"""dB of a tap's beginning above the quietest tenth of the recording, at least."""
SETTLE = 0.006
"""s from the blow to the window: the contact itself and its nearest echoes."""
WINDOW = 0.5
"""s of ringing that are used at most."""
SHORTEST = 0.04
"""s of ringing at least."""
FULL_SCALE = 0.999
"""Two samples this large, or `FLAT` tops of exactly the same height and no rounding, are clipped."""
FLAT = 3
NEAR_TOP = 0.05
"""Of full scale; quieter tops are not looked at for clipping."""
ORDER = 40
"""Of the linear prediction."""
BURST = 8.0
"""Size of a blow's burst over the rms of what else is not foreseen around it, at least."""
BURST_SHARE = 0.1
"""And over the greatest burst."""
APART = 0.2
"""s between taps that are meant as two."""
ONE_BLOW = 0.02
"""s after the beginning in which all blows are one contact; the window then begins after the last."""
MEDIAN_TO_RMS = 1.4826
LARGEST_MISFIT = 0.8
"""rms of what is no damped sinusoid over that of the sound."""
HELD = 0.02
"""Damping ratio of the lowest tone from which on something holds the implement (assumed): freely hung bats have 0.001
to 0.015, hands damp strongly [russell_bendsweet]."""

MAINS, MAINS_SPREAD = (50.0, 60.0), 0.3
"""Hz of the mains, and how far a multiple may seem to lie from it."""
HIGHEST_HUM, HUM_LEVEL, HUM_DAMPING = 1000.0, 0.3, 2e-4
"""Hz up to which hum is looked for, the part of the loudest tone's amplitude that it has at most unless it was there
before the tap, and the damping ratio below which a tone may not die away at all; bats have five times that and more
(all assumed)."""
BEFORE, AS_LOUD = (0.3, 0.004), 0.5
"""s before a tap between which hum is looked for, and how loud it is there at least, over its amplitude after it."""
HUMLESS, CLEARER = 400.0, 6.0
"""Hz from which on taps are looked for where they stand out by this many dB more: mains and steps are below."""
ECHO = 0.1
"""Part of its frequency within which a weaker tone that dies away faster is an echo (assumed)."""
HEARD = 0.1
"""Amplitude over the loudest tone's; the lowest tone that is at least this loud says whether the implement is free."""


@dataclass(frozen=True)
class Tap:
    """One tap of a recording.

    Parameters
    ----------
    recording : its name.
    start : s from the beginning of the recording.
    fault : why it is not used; None: it is.
    fit : of its ringing; None where it was rejected before.
    """

    recording: str
    start: float
    fault: str | None
    fit: Fit | None

    @property
    def good(self) -> bool:
        """Whether it is used."""
        return self.fault is None


def find_taps(recording: Recording, *, band: Band, held: float = HELD) -> tuple[Tap, ...]:
    """Return all taps of a recording, good and bad.

    Parameters
    ----------
    band : frequencies looked at.
    held : damping ratio of the lowest tone from which on the implement counts as held.
    """
    sound = in_band(recording, band)
    starts = _starts(_where_taps_stand_out(recording, sound, band))
    ends = [*starts[1:], sound.duration]
    taps = [_tap(recording, sound, start, end, band, held) for start, end in zip(starts, ends, strict=True)]
    for index, (before, after) in enumerate(pairwise(starts)):
        if after - before < APART:
            fault = f"doubled: two taps {1e3 * (after - before):.0f} ms apart; let it ring between taps"
            taps[index : index + 2] = [replace(one, fault=one.fault or fault) for one in taps[index : index + 2]]
    return tuple(taps)


def _where_taps_stand_out(recording: Recording, sound: Recording, band: Band) -> Recording:
    """Return the sound in its band, or without what is low where taps then stand out of hum much farther."""
    if not band.low < HUMLESS < min(band.high, 0.45 * recording.rate) / 2:
        return sound
    without = in_band(recording, Band(HUMLESS, band.high))
    gains = []
    for one in (sound, without):
        level, floor = _levels(one)
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
    before = round(QUIET_BEFORE / FRAME)
    starts: list[int] = []
    for index in range(count):
        earlier = level[max(0, index - before) : index]
        rises = not len(earlier) or level[index] > earlier.max() + RISE
        apart = not starts or index - starts[-1] >= 2
        if rises and level[index] > floor + ABOVE_FLOOR and level[index] > level.max() - 50 and apart:
            starts.append(index)
    merged: list[int] = []
    for index in starts:  # the rise of one tap may take several frames
        if not merged or index - merged[-1] > SETTLE / FRAME:
            merged.append(index)
    return [index * frame / sound.rate for index in merged] or [0.0]


def _tap(recording: Recording, sound: Recording, start: float, end: float, band: Band, held: float) -> Tap:
    def rejected(fault: str, fit: Fit | None = None) -> Tap:
        return Tap(recording.name, start, fault, fit)

    raw = recording.samples[int(start * recording.rate) : int(min(end, start + WINDOW) * recording.rate)]
    if clipped(raw):
        return rejected("clipped: louder than the recording can hold; tap more softly or lower the level")
    if end - start < ONE_BLOW + SETTLE + SHORTEST:
        return rejected(f"too short: only {1e3 * (end - start):.0f} ms of it; let it ring")
    whole = sound.samples[int(start * sound.rate) : int(min(end, start + WINDOW) * sound.rate)]
    struck = blows(whole, sound.rate)
    late = struck[struck > ONE_BLOW]
    if len(late):
        return rejected(f"doubled: a second blow {1e3 * late[0]:.0f} ms after the first; let the hammer bounce off")
    window = whole[int((struck.max(initial=0.0) + SETTLE) * sound.rate) :]
    earlier = sound.samples[int(max(start - BEFORE[0], 0.0) * sound.rate) : int(max(start - BEFORE[1], 0) * sound.rate)]
    fit = _without_hum(fit_sinusoids(window, sound.rate, band=band), earlier)
    if not fit.sinusoids or fit.misfit > LARGEST_MISFIT:
        return rejected(
            f"too quiet: {100 * min(fit.misfit, 1):.0f} % of the sound is noise; tap harder or nearer the microphone",
            fit,
        )
    loudest = max(one.amplitude for one in fit.sinusoids)
    lowest = next(one for one in fit.sinusoids if one.amplitude > HEARD * loudest and not _echoed(one, fit.sinusoids))
    ratio = lowest.damping_ratio
    if ratio.value > held and ratio.low > held / 2:
        return rejected(
            f"not free: at {lowest.frequency.value:.0f} Hz the damping is {100 * ratio.value:.1f} %, a freely hung one "
            f"has less than {100 * held:g} %; hang it from rubber bands and keep hands away, or set --most-damping",
            fit,
        )
    return Tap(recording.name, start, None, fit)


def _echoed(one: Sinusoid, all_of_them: Sequence[Sinusoid]) -> bool:
    """Say whether a tone beside this one dies away more slowly and holds more energy: this is its echo in the room.

    A tone's energy goes as a^2 / (zeta f).
    """

    def energy(tone: Sinusoid) -> float:
        return tone.amplitude**2 / max(tone.damping_ratio.value * tone.frequency.value, 1e-12)

    return any(
        abs(other.frequency.value - one.frequency.value) < ECHO * one.frequency.value
        and other.damping_ratio.value < one.damping_ratio.value
        and energy(other) > energy(one)
        for other in all_of_them
    )


def _without_hum(fit: Fit, earlier: Array) -> Fit:
    """Return a fit without the mains: tones at a multiple of 50 or 60 Hz that do not die away.

    They are fainter than what rings, or were there before.

    Parameters
    ----------
    earlier : the sound before the tap; may be empty.
    """
    loudest = max((one.amplitude for one in fit.sinusoids if not _hums(one)), default=0.0)
    kept = tuple(
        one
        for one in fit.sinusoids
        if not _hums(one)
        or (one.amplitude > HUM_LEVEL * loudest and _amplitude(earlier, one, fit.rate) < AS_LOUD * one.amplitude)
    )
    return replace(fit, sinusoids=kept)


def _amplitude(samples: Array, one: Sinusoid, rate: float) -> float:
    """Return how loud a tone is in a sound that is too short for nothing: 0 below two of its periods."""
    if len(samples) < 2 * rate / one.frequency.value:
        return 0.0
    turning = np.exp(-2j * np.pi * one.frequency.value * np.arange(len(samples)) / rate)
    return float(2 * abs(np.mean(samples * turning)))


def _hums(one: Sinusoid) -> bool:
    near = min(abs(one.frequency.value - base * round(one.frequency.value / base)) for base in MAINS)
    return one.frequency.value < HIGHEST_HUM and near < MAINS_SPREAD and one.damping_ratio.low < HUM_DAMPING


def clipped(samples: Array) -> bool:
    """Say whether a sound was cut off: at full scale, or again and again at the very same height."""
    for side in (samples, -samples):
        top = side.max(initial=0.0)
        if top < NEAR_TOP:
            continue
        at_top = side >= top
        runs = at_top[1:] & at_top[:-1]
        if (top >= FULL_SCALE and at_top.sum() > 1) or np.count_nonzero(runs[1:] & ~runs[:-1]) >= FLAT:
            return True
    return False


def blows(samples: Array, rate: float) -> Array:
    """Return when in s blows fall into a sound: what the `ORDER` samples before do not let foresee.

    A blow stands out of the 40 ms around it, and counts when it is no less than a tenth of the greatest.
    """
    import scipy.linalg
    import scipy.ndimage

    count = len(samples)
    if count < 4 * ORDER:
        return np.zeros(0)
    padded = np.concatenate([np.zeros(ORDER), samples])
    past = np.lib.stride_tricks.sliding_window_view(padded[:-1], ORDER)
    ringing = slice(min(int(SETTLE * rate), count // 2), None)
    normal = past[ringing].T @ past[ringing]
    normal += 1e-9 * max(np.trace(normal), 1e-300) / ORDER * np.eye(ORDER)
    weights = scipy.linalg.solve(normal, past[ringing].T @ samples[ringing], assume_a="pos")
    surprise = np.abs(samples - past @ weights)
    around = scipy.ndimage.median_filter(surprise, size=2 * int(0.02 * rate) + 1, mode="nearest")
    bursts = (surprise > BURST * MEDIAN_TO_RMS * around) & (surprise > BURST_SHARE * surprise.max())
    return np.asarray(np.flatnonzero(bursts) / rate)
