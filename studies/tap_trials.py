"""How often a sound that is no tap counts as one, and a tap as none, on made-up sounds of which no limit was set.

    .venv/bin/python -m studies.tap_trials --count 40 --seed 1

Speech is voiced by pulses of a gliding pitch through gliding formants; steps, claps, creaks and slams are bursts of
coloured noise through resonances of low Q. Taps are those of bars, plates and bats in noise of every colour, in rooms.
Nothing of `sweetspot.calibration` makes them.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Sequence

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from sweetspot.calibration.recording import BAT_BAND, Recording
from sweetspot.calibration.taps import Tap, find_taps

Array = NDArray[np.float64]
RATE = 22050
LEAD = 0.4
"""s of background before every sound."""
FORMANTS = (
    (730, 1090, 2440),
    (270, 2290, 3010),
    (300, 870, 2240),
    (530, 1840, 2480),
    (570, 840, 2410),
    (490, 1350, 1690),
)
"""Hz of six English vowels (assumed; rounded textbook values)."""


def resonance(sound: Array, frequency: Array | float, width: float) -> Array:
    """Return a sound through a resonance of this width in Hz whose frequency may glide, shape (n,)."""
    radius = np.exp(-np.pi * width / RATE)
    turn = 2 * radius * np.cos(2 * np.pi * np.broadcast_to(frequency, sound.shape) / RATE)
    out = np.zeros(len(sound) + 2)
    for index, value in enumerate(sound):
        out[index + 2] = value * (1 - radius) + turn[index] * out[index + 1] - radius**2 * out[index]
    return out[2:]


def coloured(generator: np.random.Generator, count: int, power: float) -> Array:
    """Return noise whose power goes as 1 / f^power, of rms 1."""
    spectrum = np.fft.rfft(generator.standard_normal(count))
    frequency = np.maximum(np.fft.rfftfreq(count, 1 / RATE), 30.0)
    noise = np.fft.irfft(spectrum * frequency ** (-power / 2), count)
    return np.asarray(noise / noise.std())


def syllable(generator: np.random.Generator) -> Array:
    """Return a consonant's burst and a vowel that glides in pitch and formants."""
    seconds = generator.uniform(0.12, 0.45)
    time = np.arange(int(seconds * RATE)) / RATE
    pitch = generator.uniform(85, 260) * (1 + generator.uniform(-0.25, 0.25) * time / seconds)
    pitch = pitch * (1 + 0.01 * np.sin(2 * np.pi * 5 * time))
    cycle = np.cumsum(pitch) / RATE
    pulses = np.diff(np.floor(cycle), prepend=0.0) * (1 + 0.05 * generator.standard_normal(len(time)))
    source = scipy.signal.lfilter([1], [1, -1.92, 0.9216], pulses)  # the glottis: 12 dB an octave
    source += 0.02 * source.std() * generator.standard_normal(len(time))
    first, last = (np.array(FORMANTS[index]) for index in generator.integers(0, len(FORMANTS), 2))
    voice = np.diff(source, prepend=0.0)
    for one, other, width in zip(first, last, (70, 100, 130), strict=True):
        voice = resonance(voice, one + (other - one) * time / seconds, width)
    attack, release = generator.uniform(0.001, 0.05), generator.uniform(0.02, 0.2)
    voice = voice / np.abs(voice).max() * np.minimum(1, time / attack) * np.clip((seconds - time) / release, 0, 1)
    plosive = generator.standard_normal(int(generator.uniform(0.004, 0.03) * RATE))
    plosive *= generator.uniform(0, 0.6) * np.exp(-np.arange(len(plosive)) / (0.005 * RATE))
    return np.concatenate([plosive, voice])


def speech(generator: np.random.Generator) -> Array:
    """Return two to five syllables, close together or apart."""
    parts = []
    for _ in range(generator.integers(2, 6)):
        parts += [generator.uniform(0.3, 1) * syllable(generator), np.zeros(int(generator.uniform(0, 0.25) * RATE))]
    return np.concatenate(parts)


def burst(generator: np.random.Generator, *, lasts: float, power: float, tones: Array, width: float) -> Array:
    """Return coloured noise that dies away within ``lasts`` s, through broad resonances."""
    count = int(max(0.3, 5 * lasts) * RATE)
    noise = coloured(generator, count, power) * np.exp(-np.arange(count) / (lasts * RATE))
    sound = sum(resonance(noise, float(one), width) * generator.uniform(0.4, 1) for one in tones)
    return np.asarray(sound / np.abs(sound).max())


def clap(generator: np.random.Generator) -> Array:
    """Return what hands make: 3 to 10 ms around 1 kHz."""
    return burst(
        generator, lasts=generator.uniform(0.002, 0.006), power=0.0, tones=generator.uniform(600, 2500, 2), width=500
    )


def step(generator: np.random.Generator) -> Array:
    """Return a heel on a floor: a thump below 200 Hz and a click."""
    thump = burst(
        generator, lasts=generator.uniform(0.02, 0.06), power=2.0, tones=generator.uniform(60, 220, 3), width=60
    )
    click = 0.4 * clap(generator)
    thump[: len(click)] += click[: len(thump)]
    return thump


def slam(generator: np.random.Generator) -> Array:
    """Return a door, a book on a table."""
    return burst(
        generator, lasts=generator.uniform(0.03, 0.15), power=1.0, tones=generator.uniform(80, 900, 5), width=80
    )


def creak(generator: np.random.Generator) -> Array:
    """Return a chair's slips that follow each other faster or slower, through a few resonances of Q about 15."""
    seconds = generator.uniform(0.2, 0.7)
    time = np.arange(int(seconds * RATE)) / RATE
    rate = generator.uniform(20, 150) * np.exp(generator.uniform(-1, 1) * time / seconds)
    slips = np.diff(np.floor(np.cumsum(rate) / RATE), prepend=0.0) * generator.uniform(0.3, 1, len(time))
    sound = sum(resonance(slips, float(one), one / 15) for one in generator.uniform(300, 2500, 3))
    return np.asarray(sound / np.abs(sound).max() * np.minimum(1, (seconds - time) / 0.03))


def whistle(generator: np.random.Generator) -> Array:
    """Return a tone that glides."""
    seconds = generator.uniform(0.2, 0.6)
    time = np.arange(int(seconds * RATE)) / RATE
    tone = generator.uniform(500, 2500) * (1 + generator.uniform(-0.3, 0.3) * time / seconds)
    return np.sin(2 * np.pi * np.cumsum(tone) / RATE) * np.minimum(1, time / 0.005) * np.exp(-3 * time / seconds)


def tapped(generator: np.random.Generator) -> tuple[Array, Array]:
    """Return a freely hung body's sound, and the frequencies in Hz that it truly has."""
    ratios = np.array([1, 2.757, 5.404, 8.933, 13.34]) ** generator.uniform(0.9, 1.02)
    if generator.random() < 0.4:  # a plate or a brace: modes close together
        ratios = np.cumprod(np.append(1, generator.uniform(1.12, 1.9, 7)))
    tones = generator.uniform(90, 400) * ratios
    tones = tones[tones < 4500]
    time = np.arange(int(1.0 * RATE)) / RATE
    damping = generator.uniform(0.001, 0.012, len(tones))
    size = generator.uniform(0.1, 1, len(tones)) * np.sinc(generator.uniform(0.0002, 0.0006) * tones)
    phase = generator.uniform(0, 2 * np.pi, len(tones))
    sound = np.zeros(len(time))
    for frequency, ratio, one, shift in zip(tones, damping, size, phase, strict=True):
        sound += one * np.exp(-2 * np.pi * ratio * frequency * time) * np.sin(2 * np.pi * frequency * time + shift)
    force = np.hanning(max(3, int(generator.uniform(0.0003, 0.001) * RATE)))
    return np.convolve(sound, force)[: len(sound)] / np.abs(sound).max(), tones


def heard(generator: np.random.Generator, sound: Array, *, noise: float) -> Array:
    """Return a sound in a room and in noise of some colour, after `LEAD` s of the background alone."""
    lasts = generator.uniform(0.1, 0.5)
    time = np.arange(int(lasts * RATE)) / RATE
    echo = generator.standard_normal(len(time)) * np.exp(-6.9 * time / lasts)
    echo[: int(0.004 * RATE)] = 0
    echo *= generator.uniform(0, 0.3) / np.sqrt(np.sum(echo**2))
    echo[0] = 1.0
    wet = scipy.signal.fftconvolve(sound, echo)
    whole = np.concatenate([np.zeros(int(LEAD * RATE)), wet, np.zeros(int(0.2 * RATE))])
    background = coloured(generator, len(whole), generator.uniform(0, 2))
    return np.asarray(0.5 * whole / np.abs(whole).max() + 0.5 * noise * background)


SOUNDS: dict[str, Callable[[np.random.Generator], Array]] = {
    "speech": speech, "clap": clap, "step": step, "slam": slam, "creak": creak, "whistle": whistle,
}  # fmt: skip
NOISES = (0.0005, 0.005, 0.02)
"""rms of the background over the loudest sample."""


def false_taps(kind: str, seed: int) -> tuple[Tap, ...]:
    """Return everything that starts in a sound that is no tap."""
    generator = np.random.default_rng((seed, sorted(SOUNDS).index(kind)))
    samples = heard(generator, SOUNDS[kind](generator), noise=NOISES[seed % 3])
    return find_taps(Recording(kind, samples, RATE), band=BAT_BAND)


def true_tap(seed: int) -> tuple[tuple[Tap, ...], Array]:
    """Return what is found in the sound of a tap, and the tones that the body truly has."""
    generator = np.random.default_rng((seed, 99))
    sound, tones = tapped(generator)
    samples = heard(generator, sound, noise=NOISES[seed % 3])
    return find_taps(Recording("tap", samples, RATE), band=BAT_BAND), tones


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the rates."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=SOUNDS, help="of the sounds that are no taps")
    asked = parser.parse_args(arguments)
    seeds = range(1000 * asked.seed, 1000 * asked.seed + asked.count)
    for kind in [asked.only] if asked.only else SOUNDS:
        taken = [any(tap.good for tap in false_taps(kind, seed)) for seed in seeds]
        print(f"{kind}: {sum(taken)} of {len(taken)} recordings have a false tap")
    found, faults, wrong, tones = 0, Counter[str](), 0, 0
    for seed in seeds:
        taps, true = true_tap(seed)
        found += any(tap.good and abs(tap.start - LEAD) < 0.01 for tap in taps)
        faults.update((tap.fault or "used").split(":")[0] for tap in taps)
        for one in (one for tap in taps if tap.good and tap.fit for one in tap.fit.sinusoids):
            tones += 1
            wrong += bool(np.min(np.abs(true / one.frequency.value - 1)) > 0.01)
    print(f"taps: {found} of {len(seeds)} used; {dict(faults)}")
    print(f"tones: {wrong} of {tones} are none that the body has, to 1 %")


if __name__ == "__main__":
    main()
