"""Sounds that are no taps and taps that are some, made another way than those of `studies.tap_trials`.

    .venv/bin/python -m studies.other_sounds --count 20 --seed 1

No limit of `sweetspot.calibration` was set on these. A voice is a tube of ten sections whose areas glide from one vowel
to another, driven by the flow through a glottis that opens and closes (Kelly and Lochbaum's lines, Rosenberg's pulse);
a room is a box of walls that take a part of the sound (image sources); what clatters rings, falls back and rings again.
Taps are those on frame, shaft or blade of the catalogue's implements of every sport, in a mode's two planes, once and
in series.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Sequence

import numba
import numpy as np
import scipy.signal
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.calibration.recording import FrequencyBand, Recording, tap_sound
from sweetspot.calibration.tap_analysis import frame_modes, held_damping, usual_band
from sweetspot.calibration.taps import Tap, find_taps
from sweetspot.dynamics.modes import Modes

Array = NDArray[np.float64]
RATE = 22050
LEAD = 0.4
"""s of background before every sound."""
SECTIONS = 11
"""Of the vocal tract: 343 m/s / 22050 Hz = 1.56 cm each, 17 cm together."""
GLOTTIS, LIPS = 0.75, -0.85
"""Part of a wave that comes back from either end (assumed; usual in such models)."""
SPEED_OF_SOUND = 343.0
IMPLEMENTS = (
    "r161-ash", "college-alloy", "youth-alloy", "fast-pitch", "cricket-bat", "tennis-racket", "badminton-racket",
    "golf-driver", "hockey-stick", "table-tennis-racket",
)  # fmt: skip


@numba.njit(cache=False)
def _tract(flow: Array, areas: Array) -> Array:
    """Return the sound at the lips of a tube with areas (n, sections), driven by a glottal flow (n,)."""
    count = areas.shape[1]
    right, left, out = np.zeros(count), np.zeros(count), np.zeros(len(flow))
    for index in range(len(flow)):
        new_right, new_left = np.zeros(count), np.zeros(count)
        new_right[0] = flow[index] + GLOTTIS * left[0]
        for joint in range(count - 1):
            first, second = areas[index, joint], areas[index, joint + 1]
            part = (first - second) / (first + second)
            scattered = part * (right[joint] - left[joint + 1])
            new_right[joint + 1] = right[joint] + scattered
            new_left[joint] = left[joint + 1] + scattered
        new_left[count - 1] = LIPS * right[count - 1]
        out[index] = right[count - 1]
        right, left = 0.999 * new_right, 0.999 * new_left
    return out


def tract(generator: np.random.Generator) -> Array:
    """Return areas of a vocal tract in any unit, shape (sections,): a throat, a mouth and one place that is narrow."""
    place = np.arange(SECTIONS)
    area = np.where(place < generator.uniform(3, 7), generator.uniform(0.5, 4), generator.uniform(1, 7))
    narrow = np.exp(-(((place - generator.uniform(2, 9)) / generator.uniform(1, 2.5)) ** 2))
    return np.asarray(np.maximum(area * (1 - generator.uniform(0.3, 0.95) * narrow), 0.1))


def glottis(generator: np.random.Generator, pitch: Array) -> Array:
    """Return the flow of a voice with this pitch in Hz, shape (n,): it opens as a cosine and closes twice as fast."""
    phase = np.cumsum(pitch * (1 + 0.01 * generator.standard_normal(len(pitch)))) / RATE % 1
    opening = generator.uniform(0.3, 0.5)
    closed = 1.5 * opening
    flow = np.where(phase < opening, 0.5 - 0.5 * np.cos(np.pi * phase / opening), 0.0)
    closing = (phase >= opening) & (phase < closed)
    flow[closing] = np.cos(np.pi * (phase[closing] - opening) / (closed - opening) / 2)
    return np.asarray(flow + generator.uniform(0.005, 0.05) * flow * generator.standard_normal(len(flow)))


def syllable(generator: np.random.Generator) -> Array:
    """Return a stop or a hiss and then a vowel that becomes another; a held breath of power opens and closes it."""
    seconds = generator.uniform(0.1, 0.5)
    count = int(seconds * RATE)
    along = np.linspace(0, 1, count)
    pitch = generator.uniform(80, 300) * np.exp(generator.uniform(-0.3, 0.15) * along)
    first, last = tract(generator), tract(generator)
    turn = 1 / (1 + np.exp(-(along - generator.uniform(0.2, 0.8)) / generator.uniform(0.03, 0.3)))
    areas = np.exp(np.outer(1 - turn, np.log(first)) + np.outer(turn, np.log(last)))
    flow = glottis(generator, pitch)
    rise, fall = generator.uniform(0.002, 0.06), generator.uniform(0.03, 0.25)
    shape = np.minimum(1, along * seconds / rise) * np.minimum(1, (1 - along) * seconds / fall) ** generator.uniform(
        1, 2
    )
    voice = np.diff(_tract(flow * shape, areas), prepend=0.0)
    voice /= np.abs(voice).max()
    hiss = generator.standard_normal(int(generator.uniform(0.003, 0.12) * RATE))
    hiss = np.diff(hiss, prepend=0.0) * np.exp(-np.linspace(0, generator.uniform(0, 6), len(hiss)))
    return np.concatenate([generator.uniform(0, 0.4) * hiss / np.abs(hiss).max(), voice])


def talk(generator: np.random.Generator) -> Array:
    """Return two to six syllables."""
    parts: list[Array] = []
    for _ in range(generator.integers(2, 7)):
        parts += [generator.uniform(0.2, 1) * syllable(generator), np.zeros(int(generator.uniform(0, 0.3) * RATE))]
    return np.concatenate(parts)


def cough(generator: np.random.Generator) -> Array:
    """Return bursts of breath through a tract, each louder at its beginning."""
    parts = []
    for _ in range(generator.integers(1, 4)):
        count = int(generator.uniform(0.1, 0.3) * RATE)
        time = np.arange(count) / RATE
        breath = generator.standard_normal(count) * np.exp(-time / generator.uniform(0.03, 0.1))
        parts += [_tract(breath, np.repeat(tract(generator)[None], count, axis=0)), np.zeros(int(0.1 * RATE))]
    return np.concatenate(parts)


def clatter(generator: np.random.Generator) -> Array:
    """Return something small and hard that falls on a table and bounces until it lies: keys, a spoon, a pen."""
    seconds = 1.2
    time = np.arange(int(seconds * RATE)) / RATE
    tones = generator.uniform(400, 4500, generator.integers(3, 8))
    blow = sum(np.exp(-time * tone * generator.uniform(0.02, 0.1)) * np.sin(2 * np.pi * tone * time) for tone in tones)
    sound, when, speed, kept = np.zeros(len(time)), 0.0, 1.0, generator.uniform(0.4, 0.8)
    gap = generator.uniform(0.04, 0.25)
    while when < seconds and speed > 0.02:
        begin = int(when * RATE)
        sound[begin:] += speed * np.asarray(blow)[: len(time) - begin] * generator.uniform(0.5, 1)
        when, speed, gap = when + gap, speed * kept, gap * kept
        if gap < 0.004:
            break
    return sound


def scrape(generator: np.random.Generator) -> Array:
    """Return a thing drawn over a floor: noise that swells and ebbs through a few resonances."""
    count = int(generator.uniform(0.3, 1.0) * RATE)
    time = np.arange(count) / RATE
    swell = np.abs(np.sin(np.pi * time * generator.uniform(1, 8))) ** generator.uniform(0.3, 3)
    noise = generator.standard_normal(count) * swell
    sound = np.zeros(count)
    for tone in generator.uniform(150, 3000, 4):
        numerator, denominator = scipy.signal.iirpeak(tone, generator.uniform(3, 20), fs=RATE)
        sound += scipy.signal.lfilter(numerator, denominator, noise)
    return sound


def organ(generator: np.random.Generator) -> Array:
    """Return music: held chords of many harmonics, one after another."""
    parts = []
    for _ in range(generator.integers(2, 6)):
        time = np.arange(int(generator.uniform(0.15, 0.6) * RATE)) / RATE
        root = 110 * 2 ** (generator.integers(0, 25) / 12)
        chord = sum(
            np.sin(2 * np.pi * root * interval * number * time + generator.uniform(0, 6)) / number
            for interval in (1, 1.26, 1.5) for number in range(1, 8)
        )  # fmt: skip
        shape = np.minimum(1, time / generator.uniform(0.003, 0.05)) * np.minimum(1, (time[-1] - time) / 0.03)
        parts.append(np.asarray(chord * shape * generator.uniform(0.4, 1)))
    return np.concatenate(parts)


def song(generator: np.random.Generator) -> Array:
    """Return a voice that holds notes with vibrato over a drum and plucked strings, without a pause."""
    beat = generator.uniform(0.35, 0.6)
    count = int(6 * beat * RATE)
    time, sound = np.arange(count) / RATE, np.zeros(count)
    notes = 165 * 2 ** (generator.integers(0, 13, 6) / 12)
    pitch = np.repeat(notes, -(-count // 6))[:count] * (1 + 0.012 * np.sin(2 * np.pi * 5.5 * time))
    areas = np.repeat(tract(generator)[None], count, axis=0)
    voice = np.diff(_tract(glottis(generator, pitch), areas), prepend=0.0)
    sound += voice / np.abs(voice).max()
    for number in range(6):
        begin = int(number * beat * RATE)
        later = time[: count - begin]
        for harmonic in range(1, 9):  # a plucked string
            tone = notes[number] * 0.75 * harmonic
            sound[begin:] += 0.3 / harmonic * np.exp(-1.5 * harmonic * later) * np.sin(2 * np.pi * tone * later)
        drum = generator.uniform(90, 220)
        sound[begin:] += generator.uniform(0.3, 1) * np.exp(-12 * later) * np.sin(2 * np.pi * drum * later)
    return sound


def applause(generator: np.random.Generator) -> Array:
    """Return the claps of 3 to 30 pairs of hands for two seconds, each 2 to 6 ms of noise about its own pitch."""
    count = int(2.0 * RATE)
    sound = np.zeros(count)
    for _ in range(generator.integers(3, 31)):
        numerator, denominator = scipy.signal.iirpeak(generator.uniform(700, 2500), generator.uniform(1, 4), fs=RATE)
        when, gap = generator.uniform(0, 0.3), generator.uniform(0.18, 0.35)
        while when < 1.9:
            size = int(0.03 * RATE)
            clap = generator.standard_normal(size) * np.exp(-np.arange(size) / (generator.uniform(0.002, 0.006) * RATE))
            begin = int(when * RATE)
            sound[begin : begin + size] += generator.uniform(0.3, 1) * scipy.signal.lfilter(
                numerator, denominator, clap
            )
            when += gap * generator.uniform(0.9, 1.1)
    return sound


SOUNDS: dict[str, Callable[[np.random.Generator], Array]] = {
    "talk": talk, "cough": cough, "clatter": clatter, "scrape": scrape, "organ": organ,
    "song": song, "applause": applause,
}  # fmt: skip


def box(generator: np.random.Generator) -> Array:
    """Return the impulse response of a room: image sources of a box, walls that take 15 to 70 % of the energy."""
    sizes = generator.uniform((2.5, 2.5, 2.3), (7, 6, 3.5))
    keeps = np.sqrt(1 - generator.uniform(0.15, 0.7))
    source = sizes * generator.uniform(0.2, 0.8, 3)
    toward = generator.standard_normal(3)
    heard = np.clip(source + generator.uniform(0.1, 0.5) * toward / np.linalg.norm(toward), 0.05, sizes - 0.05)
    seconds = 0.35
    cells = [np.arange(-reach, reach + 1) for reach in np.ceil(seconds * SPEED_OF_SOUND / sizes).astype(int)]
    along = [
        (np.where(cell % 2 == 0, cell * size + own, (cell + 1) * size - own) - ear) ** 2
        for cell, size, own, ear in zip(cells, sizes, source, heard, strict=True)
    ]
    far = np.sqrt(along[0][:, None, None] + along[1][:, None] + along[2]).ravel()
    bounces = sum(np.abs(one) for one in np.ix_(*cells))
    direct = float(np.linalg.norm(heard - source))
    at = ((far - direct) / SPEED_OF_SOUND * RATE).astype(int)
    inside = at < int(seconds * RATE)
    size = (keeps ** np.asarray(bounces).ravel() * direct / far)[inside]
    return np.asarray(np.bincount(at[inside], weights=size, minlength=int(seconds * RATE)), float)


def recorded(generator: np.random.Generator, sound: Array, *, live: bool) -> Array:
    """Return a sound in a live or a dead room, after `LEAD` s of the room's own noise."""
    wet = scipy.signal.fftconvolve(sound, box(generator)) if live else sound
    whole = np.concatenate([np.zeros(int(LEAD * RATE)), wet, np.zeros(int(0.2 * RATE))])
    noise = scipy.signal.lfilter([1], [1, -generator.uniform(0, 0.95)], generator.standard_normal(len(whole)))
    noise *= 10 ** generator.uniform(-3.3, -1.7) / noise.std()
    return np.asarray(0.4 * whole / np.abs(whole).max() + 0.4 * noise)


def two_planes(generator: np.random.Generator, modes: Modes, place: float) -> Array:
    """Return a tap's sound whose modes ring in two planes, up to 1.5 % apart, that may begin against each other."""
    first = tap_sound(modes, position=place, listened=place, duration=generator.uniform(0.0003, 0.0009), rate=RATE)
    apart = 1 + generator.uniform(0.002, 0.015)
    time = np.arange(len(first))
    second = np.interp(time * apart, time, first)
    return np.asarray(first + generator.uniform(-1, 1) * second)


def false_taps(kind: str, seed: int) -> tuple[Tap, ...]:
    """Return everything that starts in a sound that is no tap."""
    generator = np.random.default_rng((seed, 7, sorted(SOUNDS).index(kind)))
    samples = recorded(generator, SOUNDS[kind](generator), live=seed % 2 == 0)
    return find_taps(Recording(kind, samples, RATE), band=FrequencyBand(60.0, 5000.0))


def series(name: str, seed: int) -> tuple[tuple[Tap, ...], list[float], Modes]:
    """Return what is found in one to five taps of an implement, when it was tapped in s, and its modes."""
    generator = np.random.default_rng((seed, 11))
    implement = catalog.load_implement(name)
    modes = frame_modes(implement)
    place = implement.length * generator.uniform(0.9, 0.99)
    taps = generator.integers(1, 6)
    parts = [generator.uniform(0.4, 1) * two_planes(generator, modes, place) for _ in range(taps)]
    gap = np.zeros(int(generator.uniform(0, 0.8) * RATE))
    sound = np.concatenate([piece for part in parts for piece in (part / np.abs(part).max(), gap)])
    samples = recorded(generator, sound, live=seed % 2 == 0)
    when = [LEAD + number * (len(parts[0]) + len(gap)) / RATE for number in range(taps)]
    return find_taps(Recording(name, samples, RATE), band=usual_band(modes), held=held_damping(modes)), when, modes


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the rates."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=[*SOUNDS, *IMPLEMENTS], help="one sound or one implement")
    asked = parser.parse_args(arguments)
    seeds = range(1000 * asked.seed, 1000 * asked.seed + asked.count)
    for kind in (kind for kind in SOUNDS if asked.only in (None, kind)):
        taken = [any(tap.good for tap in false_taps(kind, seed)) for seed in seeds]
        print(f"{kind}: {sum(taken)} of {len(taken)} recordings have a false tap", flush=True)
    for name in (name for name in IMPLEMENTS if asked.only in (None, name)):
        found, given, faults = 0, 0, Counter[str]()
        for seed in range(seeds.start, seeds.start + max(1, asked.count // 5)):
            taps, when, _ = series(name, seed)
            given += len(when)
            found += sum(any(tap.good and abs(tap.start - one) < 0.01 for tap in taps) for one in when)
            faults.update(tap.fault.split(":")[0] for tap in taps if tap.fault)
        print(f"{name}: {found} of {given} taps used; refused: {dict(faults)}", flush=True)


if __name__ == "__main__":
    main()
