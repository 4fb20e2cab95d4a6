"""The taps in a recording: where each begins, whether it can be used, and why not.

A tap is a sudden rise of the sound in the band. It is used when `tap_faults` finds nothing wrong with it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from sweetspot.calibration.hum import hum_taken_out, risen
from sweetspot.calibration.recording import FrequencyBand, Recording, in_band
from sweetspot.calibration.sinusoids import Fit, Sinusoid, fit_sinusoids, in_their_room
from sweetspot.calibration.tap_faults import APART, CROWDED, HELD, SETTLE, blows, fault_of_fit, fault_of_sound, step_of
from sweetspot.numerics.arrays import Array

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
    recording : its name.
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
    """Return all taps of a recording, good and bad.

    Parameters
    ----------
    band : frequencies looked at.
    held : damping ratio of the lowest tone from which on the implement counts as held.
    """
    clear = hum_taken_out(recording)
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
    return tuple(taps)


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
    """Return what begins at the first of two times in s, and is heard to the second.

    Parameters
    ----------
    quiet : s from the beginning of the recording in which nothing was tapped; may be negative.
    """
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
    fit = risen(fit, sound.samples[: max(int(quiet * sound.rate), 0)])
    tones = in_their_room(_louder_than_losses(fit.sinusoids, recording))
    fit = replace(fit, sinusoids=tuple(tone for tone in tones if tone.amplitude >= STEPS * step))
    return Tap(recording.name, start, fault_of_fit(fit, background=background, held=held), fit)


def _louder_than_losses(tones: tuple[Sinusoid, ...], recording: Recording) -> tuple[Sinusoid, ...]:
    """Return the tones of a recording that leaves out what is hard to hear, without those that this itself may make."""
    least = LOSSY * max((tone.amplitude for tone in tones), default=0.0) if recording.lossy else 0.0
    return tuple(tone for tone in tones if tone.amplitude >= least)
