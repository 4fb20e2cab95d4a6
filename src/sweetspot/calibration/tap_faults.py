"""Faults of a sound that begins like a tap, in words; None where it is the ringing of a free body.

After the blow nothing drives what was tapped. Every tone then dies away alone, all began together, and what they say
can be foreseen: a second blow shows as a burst in what linear prediction cannot foresee, a voice or a creak as what is
no damped sinusoid, a whistle that glides as sinusoids that cancel each other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sweetspot.calibration.sinusoids import AUDIBLE, LOUD_PART, WEIGHTY, Fit, Sinusoid, stands_out
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ROBUST_SCALE

SETTLE = 0.006
"""s from the blow to the window: the contact itself and its nearest echoes."""
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
ONE_BLOW = 0.02
"""s after the beginning in which all blows are one contact; the window then begins after the last."""
APART = 0.2
"""s between blows that are intended as two taps."""
LARGEST_MISFIT = 0.8
"""rms of what is no damped sinusoid over that of the sound."""
MOST_DRIVEN = 0.3
"""rms of what is neither a damped sinusoid nor the background over that of the sound (assumed). After the blow nothing
drives what was tapped: all that it says is damped sinusoids that began together. A voice or a creak is driven on."""
CROWDED = "more tones than can be separated"
"""What driven sound may be instead, in the words of its fault, unless it has fewer tones."""
MOST_CANCELLED = 5.0
"""Energy of a fit's sinusoids, each alone, over that of the sound (assumed). Tones of a body lie apart and hardly
cancel each other: two planes that begin against each other reach 4; a tone that glides needs many that cancel."""
STEADIEST = 5e-6
"""Damping ratio of the tone with most energy, below which it does not die away (assumed): what hangs in air loses more,
a recorded steel bar 1.4e-5."""
HELD_ON = 0.1
"""Energy of tones that do not die away over that of all, from which on something else sounds (assumed): what was
tapped leaves none, and of two planes the fainter may seem to go on."""
AS_LOUD_AS_NOISE = 10.0
"""Mean square of a tap over that of the quiet recording, up to which it may be too quiet (assumed)."""
FEWEST_MULTIPLES, MULTIPLE, MOST_OFF = 4, 0.004, 0.05
"""Tones at whole multiples of one frequency, and by which part of their number and how much at most they may be off
(assumed). Of four tones that lie anyhow, one set in a thousand does."""
MOST_OF_ENERGY, SPARSEST = 0.95, 3
"""Of a sound's energy that such multiples hold, and how many times their number the highest is at most (assumed)."""
LASTING, BREAKS_OFF, DEEPEST = (0.12, 0.24, 0.48), 14.0, 30.0
"""s in three thirds, and dB by which twice the middle third may lie above the other two together, of which none counts
as more than `DEEPEST` below the loudest. What dies away is never above by more than a pair of tones makes that begin by
cancelling each other (11 dB); a syllable goes on and breaks off."""
LOUDER = 6.0
"""dB by which a later 20 ms may be louder than the blow's. Of a free body the energy only falls, and a microphone hears
each mode's two planes: cos b cos(b - a) e^(-i w1 t) + sin b sin(b - a) e^(-i w2 t), the planes at b and the microphone
at a to the blow. That begins with cos a and is never more than 1: 1 / cos^2 a, 6 dB at 60 degrees."""
FEWEST_STEPS = 20.0
"""Steps of a recording that its loudest sample has at least: at 13, made-up taps seem held for the rounding alone."""
HELD = 0.02
"""Damping ratio of the lowest tone from which on something holds the implement (assumed): freely hung bats have 0.001
to 0.015, hands damp strongly [russell_bendsweet]."""
HEARD = 0.1
"""Amplitude over the loudest tone's; the lowest tone that is at least this loud says whether the implement is free."""


def fault_of_sound(raw: Array, whole: Array, struck: Array, rate: float, *, step: float, lasts: float) -> str | None:
    """Return the fault of a tap that shows before anything is fitted; None if there is none.

    ``struck``: s at which blows fall into it. ``lasts``: s until the next tap or the end.
    """
    high = float(np.abs(raw).max(initial=0.0))
    if high < FEWEST_STEPS * step:
        return f"too quiet: only {high / step:.0f} steps of the recording high; raise its level, or record in 16 bit"
    if clipped(raw):
        return "clipped: louder than the recording can hold; tap more softly or lower the level"
    if lasts < ONE_BLOW + SETTLE + SHORTEST:
        return f"too short: only {1e3 * lasts:.0f} ms of it; let it ring"
    late = struck[struck > ONE_BLOW]
    if len(late) and late[0] > APART:
        return f"doubled: tapped again {1e3 * late[0]:.0f} ms later, while it rang; let it ring out between taps"
    if len(late):
        return f"doubled: a second blow {1e3 * late[0]:.0f} ms after the first; let the hammer bounce off"
    return _does_not_die_away(whole, struck, rate)


def _does_not_die_away(whole: Array, struck: Array, rate: float) -> str | None:
    louder = louder_later(whole[int(struck.max(initial=0.0) * rate) :], rate)
    if louder > LOUDER:
        return f"no ring: it gets {louder:.0f} dB louder after its beginning, and a ring only dies away; a voice"
    if breaks_off(whole[int(SETTLE * rate) :], rate):
        return "no ring: it goes on and breaks off instead of dying away; speech, or a hand that stopped it"
    return None


def fault_of_fit(fit: Fit, *, background: float, held: float) -> str | None:
    """Return the fault of a tap that shows in the damped sinusoids fitted to it; None if there is none.

    ``background``: mean square of the recording where it is quiet. ``held``: damping ratio of the lowest loud tone from
    which on the implement counts as held.
    """
    if not fit.sinusoids or fit.misfit > LARGEST_MISFIT:
        if float(np.mean(fit.samples**2)) < AS_LOUD_AS_NOISE * background:
            return (
                "too quiet: no tone of it stands out of the rest of the recording; tap harder, nearer the microphone, "
                "or in silence"
            )
        return (
            f"no ring: {100 * min(fit.misfit, 1):.0f} % of it is no tone that dies away; a knock on something that "
            "does not ring, a clap, music or a voice"
        )
    loudest = max(sinusoid.amplitude for sinusoid in fit.sinusoids)
    loud = [sinusoid for sinusoid in fit.sinusoids if sinusoid.amplitude > HEARD * loudest]
    lowest = next((sinusoid for sinusoid in loud if stands_out(sinusoid, fit.sinusoids, least=WEIGHTY)), loud[0])
    ratio = lowest.damping_ratio
    if ratio.value > held and ratio.low > held / 2:
        return (
            f"not free: at {lowest.frequency.value:.0f} Hz the damping is {100 * ratio.value:.1f} %, a freely hung one "
            f"has less than {100 * held:g} %; hang it from rubber bands and keep hands away, or set --most-damping"
        )
    return _no_free_body(fit, background)


def _no_free_body(fit: Fit, background: float) -> str | None:
    longest = max(fit.sinusoids, key=lambda sinusoid: sinusoid.energy(len(fit.samples) / fit.rate))
    if longest.damping_ratio.high < STEADIEST:
        return f"no ring: {longest.frequency.value:.0f} Hz does not die away; a held note, or an alarm"
    lasting = held_on(fit)
    if lasting > HELD_ON:
        return (
            f"no ring: {100 * lasting:.0f} % of its energy is in tones that do not die away, and a struck body's all "
            "do; music, a voice or a machine"
        )
    if pitch := common_pitch(fit.sinusoids):
        return (
            f"no ring: its tones are whole multiples of {pitch:.0f} Hz, and those of a bat or a bar are not; a voice, "
            "a string, a wind instrument, or a ring that overdrove the recording"
        )
    driven = driven_part(fit, background)
    if driven > MOST_DRIVEN:
        return (
            f"no ring: {100 * driven:.0f} % of it is neither dying tones nor the noise before it; a voice, a clap, "
            f"something that rattles, a room that echoes, or {CROWDED}: try --band 60Hz:500Hz"
        )
    if cancelled(fit) > MOST_CANCELLED:
        return "no ring: its tones glide instead of keeping their pitch; a whistle or a voice"
    return None


def louder_later(samples: Array, rate: float) -> float:
    """Return the increase of a sound's level in dB over its first `ONE_BLOW` s, over as long a time each."""
    size = int(ONE_BLOW * rate)
    energy = np.concatenate([[0.0], np.cumsum(samples**2)])
    power = energy[size:] - energy[:-size] + 1e-30
    return float(10 * np.log10(power[size:].max() / power[0]))


def driven_part(fit: Fit, background: float) -> float:
    """Return the rms of what is neither damped sinusoid nor background over that of the sound, while it is loud."""
    energy = np.cumsum(fit.samples**2)
    loud = int(np.searchsorted(energy, LOUD_PART * energy[-1]))
    return math.sqrt(max(fit.misfit**2 - background * (loud + 1) / float(energy[loud]), 0.0))


def held_on(fit: Fit) -> float:
    """Return the energy of a fit's tones that do not die away over that of all."""
    seconds = len(fit.samples) / fit.rate
    lasting = sum(tone.energy(seconds) for tone in fit.sinusoids if tone.damping_ratio.value < STEADIEST)
    return lasting / max(sum(tone.energy(seconds) for tone in fit.sinusoids), 1e-300)


def common_pitch(tones: Sequence[Sinusoid]) -> float | None:
    """Return the frequency in Hz whose whole multiples the tones are, as a voice's and a string's; None: there is none.

    A free beam's tones lie as 1, 2.76, 5.40, 8.93, a plate's anyhow.
    """
    energy = np.array([tone.energy(math.inf) for tone in tones])
    frequency = np.array([tone.frequency.value for tone in tones])
    heard = energy > AUDIBLE * energy.max(initial=0.0)
    loudest = frequency[np.argsort(-energy)[:FEWEST_MULTIPLES]]
    for pitch in np.unique(np.divide.outer(loudest, np.arange(1, 2 * FEWEST_MULTIPLES + 1)))[::-1]:
        number = frequency / pitch
        near = np.abs(number - np.round(number)) < np.minimum(MULTIPLE * number, MOST_OFF)
        multiples = np.unique(np.round(number[near & heard]))
        few = len(multiples) < FEWEST_MULTIPLES or multiples[-1] > SPARSEST * len(multiples)
        if not few and energy[near].sum() > MOST_OF_ENERGY * energy.sum():
            return float(pitch)
    return None


def cancelled(fit: Fit) -> float:
    """Return the energy of a fit's sinusoids, each alone, over that of the sound."""
    seconds = len(fit.samples) / fit.rate
    return sum(sinusoid.energy(seconds) for sinusoid in fit.sinusoids) * fit.rate / float(fit.samples @ fit.samples)


def breaks_off(samples: Array, rate: float) -> bool:
    """Return whether a sound goes on and then breaks off: the energy of damped tones falls ever more slowly."""
    for seconds in LASTING:
        size = int(seconds * rate / 3)
        if 3 * size <= len(samples):
            level = 10 * np.log10(np.mean(samples[: 3 * size].reshape(3, size) ** 2, axis=1) + 1e-30)
            first, middle, last = np.maximum(level, level.max() - DEEPEST).tolist()
            if 2 * middle - first - last > BREAKS_OFF:
                return True
    return False


def clipped(samples: Array) -> bool:
    """Return whether a sound was clipped: at full scale, or repeatedly at the very same height."""
    for side in (samples, -samples):
        top = side.max(initial=0.0)
        if top < NEAR_TOP:
            continue
        at_top = side >= top
        runs = at_top[1:] & at_top[:-1]
        if (top >= FULL_SCALE and at_top.sum() > 1) or np.count_nonzero(runs[1:] & ~runs[:-1]) >= FLAT:
            return True
    return False


def step_of(samples: Array) -> float:
    """Return the smallest step between samples, in which a sound was written; 0: all are the same."""
    steps = np.diff(np.unique(samples))
    return float(steps.min()) if len(steps) else 0.0


def blows(samples: Array, rate: float, *, finest_step: float = 0.0) -> Array:
    """Return when in s blows fall into a sound: what the `ORDER` samples before do not let foresee.

    A blow stands out of the 40 ms around it and of what rounding makes, and counts when it is no less than a tenth of
    the greatest.

    ``finest_step``: of the recording; in 8 bit the end of a ring is nothing but single steps, of rms 1 / sqrt(12) each.
    """
    import scipy.linalg
    import scipy.ndimage

    count = len(samples)
    if count < 4 * ORDER:
        return np.zeros(0)
    padded = np.concatenate([np.zeros(ORDER), samples])
    first = min(int(SETTLE * rate), count // 2)
    ringing, normal = padded[first : count + ORDER - 1], np.zeros((ORDER, ORDER))
    normal[0] = normal[:, 0] = np.correlate(ringing, padded[first:count])
    for row in range(1, ORDER):  # a row is the one above but for a sample at either end
        start, end = padded[first + row - 1 : first + ORDER - 1], padded[count + row - 1 : count + ORDER - 1]
        normal[row, row:] = normal[row - 1, row - 1 : -1] - start[0] * start + end[0] * end
        normal[row:, row] = normal[row, row:]
    normal += 1e-9 * max(np.trace(normal), 1e-300) / ORDER * np.eye(ORDER)
    weights = scipy.linalg.solve(normal, np.correlate(ringing, samples[first:]), assume_a="pos")
    surprise = np.abs(samples - np.correlate(padded[:-1], weights))
    size = 2 * int(0.02 * rate) + 1
    around = scipy.ndimage.median_filter(surprise, size=size, mode="nearest")
    inside = scipy.ndimage.median_filter(surprise, size=size, mode="reflect")
    around[count // 2 :] = np.maximum(around, inside)[count // 2 :]  # the very last sample may be quiet by chance
    usual = np.maximum(ROBUST_SCALE * around, finest_step / math.sqrt(12))
    bursts = (surprise > BURST * usual) & (surprise > BURST_SHARE * surprise.max())
    return np.asarray(np.flatnonzero(bursts) / rate)
