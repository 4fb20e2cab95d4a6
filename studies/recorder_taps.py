"""How often the answers of `sweetspot tap` hold what made-up bars, braces and plates were made with, by recorder.

    .venv/bin/python -m studies.recorder_taps --count 3 --seed 1

A bar or brace is solved by Ritz's method (Legendre polynomials in the deflection and the rotation of a Timoshenko
beam), which shares nothing with Goens' formula; a strip and a plate of wood by the same polynomials in both directions.
Each is struck by a short pulse, once or often, and written as recorders write: every usual rate and format, one dead
channel of two, an offset, an automatic gain, clipped attacks, hum of a fan, lossy formats, a file that begins with the
tap or holds nothing but one. Nothing in `sweetspot.calibration` was set on these.
"""

from __future__ import annotations

import argparse
import math
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import scipy.linalg
import scipy.signal
import soundfile
from numpy.polynomial import Legendre
from numpy.typing import NDArray

from sweetspot.calibration.bar import Bar
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.recording import BAT_BAND, Recording, read_recording
from sweetspot.calibration.tap_analysis import TapTest, tap_test
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH

Array = NDArray[np.float64]
DEGREES = 14
"""Legendre polynomials along a bar; five modes are then exact to 1e-6."""
SHEAR = 5 / 6
"""Shear factor of a rectangle."""


@dataclass(frozen=True)
class Body:
    """What is tapped.

    Parameters
    ----------
    bar : sizes and weight as a caliper and a scale would tell; None: a plate.
    modulus : E along it, Pa.
    frequency, damping : of its modes, Hz and ratios, shape (n,).
    loud : how loud a tap makes each, shape (n,).
    """

    bar: Bar | None
    modulus: float
    frequency: Array
    damping: Array
    loud: Array


def polynomials(count: int) -> tuple[Array, Array, Array]:
    """Return Gauss's weights, and Legendre polynomials and their slopes at his points on -1 to 1, (count, points)."""
    points, weights = np.polynomial.legendre.leggauss(2 * count)
    basis = [Legendre.basis(degree) for degree in range(count)]
    return weights, np.array([one(points) for one in basis]), np.array([one.deriv()(points) for one in basis])


def beam_frequencies(length: float, thickness: float, density: float, modulus: float, shear: float) -> Array:
    """Return the bending frequencies of a free bar by Ritz's method, Hz, per unit of its width."""
    weights, value, slope = polynomials(DEGREES)
    half = length / 2
    area, inertia = thickness, thickness**3 / 12
    mass_of = np.einsum("p,ip,jp->ij", weights, value, value) * half
    bend = np.einsum("p,ip,jp->ij", weights, slope, slope) / half
    mixed = np.einsum("p,ip,jp->ij", weights, slope, value)
    shearing = SHEAR * shear * area
    stiff = np.block(
        [[shearing * bend, -shearing * mixed], [-shearing * mixed.T, modulus * inertia * bend + shearing * mass_of]]
    )
    heavy = scipy.linalg.block_diag(density * area * mass_of, density * inertia * mass_of)
    squares = scipy.linalg.eigh(stiff, heavy, eigvals_only=True)
    return np.asarray(np.sqrt(squares[2:7]) / (2 * np.pi))  # the first two are its motions as a rigid body


def plate_frequencies(length: float, width: float, thickness: float, density: float, moduli: Array) -> Array:
    """Return the lowest frequencies of a free thin orthotropic plate by Ritz's method, Hz.

    Parameters
    ----------
    moduli : along, across, in shear, and Poisson's ratio for a pull along, shape (4,).
    """
    count = 14  # with 9 the fourth mode along is 13 % too high
    points, weights = np.polynomial.legendre.leggauss(2 * count)
    basis = [Legendre.basis(degree) for degree in range(count)]
    form = [np.array([one.deriv(order)(points) if order else one(points) for one in basis]) for order in range(3)]

    def product(first: int, second: int, long: float) -> Array:
        of_one = np.einsum("p,ip,jp->ij", weights, form[first], form[second])
        return np.asarray(of_one * (long / 2) ** (1 - first - second))

    along, across, shear, poisson = moduli
    rigid = thickness**3 / 12
    other = 1 - poisson**2 * across / along
    d11, d22, d12, d66 = (
        along * rigid / other, across * rigid / other, poisson * across * rigid / other, shear * rigid,
    )  # fmt: skip
    cross = np.kron(product(2, 0, length), product(0, 2, width))
    stiff = (
        d11 * np.kron(product(2, 2, length), product(0, 0, width))
        + d22 * np.kron(product(0, 0, length), product(2, 2, width))
        + d12 * (cross + cross.T)
        + 4 * d66 * np.kron(product(1, 1, length), product(1, 1, width))
    )
    heavy = density * thickness * np.kron(product(0, 0, length), product(0, 0, width))
    squares = scipy.linalg.eigh(stiff, heavy, eigvals_only=True)
    return np.asarray(np.sqrt(np.maximum(squares[3:], 0)) / (2 * np.pi))


def brace(generator: np.random.Generator) -> Body:
    """Return a wooden brace: E/G of 8 to 20, damping of 0.4 to 1 %."""
    length, width, thickness = (
        generator.uniform(0.25, 0.6),
        generator.uniform(0.006, 0.015),
        generator.uniform(0.008, 0.02),
    )
    density, modulus = generator.uniform(360, 520), generator.uniform(8e9, 16e9)
    return _bar(generator, (length, width, thickness), density, modulus, generator.uniform(8, 20), (0.004, 0.010))


def metal_bar(generator: np.random.Generator) -> Body:
    """Return a bar of steel or aluminium."""
    sizes = generator.uniform(0.1, 0.3), generator.uniform(0.015, 0.03), generator.uniform(0.003, 0.008)
    density, modulus = ((7850, 208e9), (2700, 70e9))[int(generator.integers(2))]
    return _bar(generator, sizes, density, modulus * generator.uniform(0.97, 1.03), 2.62, (0.0002, 0.002))


def _bar(
    generator: np.random.Generator, sizes: tuple[float, float, float], density: float, modulus: float, ratio: float,
    lost: tuple[float, float],
) -> Body:  # fmt: skip
    length, _, thickness = sizes
    frequency = beam_frequencies(length, thickness, density, modulus, modulus / ratio)
    bar = _measured(generator, sizes, density)
    loud = generator.uniform(0.3, 1.0, len(frequency)) / (1 + np.arange(len(frequency)))
    damping = generator.uniform(*lost, len(frequency))
    return Body(bar, modulus, frequency, damping, loud)


def _measured(generator: np.random.Generator, sizes: tuple[float, float, float], density: float) -> Bar:
    """Return length, width, thickness and weight as a tape, a caliper and a scale tell them."""
    errors = np.array([0.0005, 0.0001, 0.00002])  # one sigma of a tape and of a caliper
    told = np.array(sizes) + errors * generator.standard_normal(3)
    length, width, thickness = (Measured(float(size), float(off)) for size, off in zip(told, errors, strict=True))
    mass = math.prod((density, *sizes)) + 0.0001 * float(generator.standard_normal())
    return Bar(length, width, thickness, Measured(mass, 0.0001))


def _spruce(generator: np.random.Generator) -> Array:
    """Return what `plate_frequencies` takes: E along and across the grain, G in Pa, and Poisson's ratio."""
    along = generator.uniform(9e9, 14e9)
    return np.array([along, along / generator.uniform(10, 20), along / generator.uniform(13, 18), 0.37])


def strip(generator: np.random.Generator) -> Body:
    """Return a thin strip of spruce, 0.04 to 0.22 as wide as long, solved as a plate: it twists and bends across."""
    length, part, thickness = (
        generator.uniform(0.3, 0.6),
        generator.uniform(0.04, 0.22),
        generator.uniform(0.0025, 0.006),
    )
    density, moduli = generator.uniform(380, 480), _spruce(generator)
    width = part * length
    frequency = plate_frequencies(length, width, thickness, density, moduli)[:12]
    bar = _measured(generator, (length, width, thickness), density)
    damping = generator.uniform(0.004, 0.010, len(frequency))
    return Body(bar, float(moduli[0]), frequency, damping, generator.uniform(0.1, 1.0, len(frequency)))


def plate(generator: np.random.Generator) -> Body:
    """Return a plate of spruce as for a guitar's top, of which the lowest twenty modes sound."""
    length, width, thickness = (
        generator.uniform(0.4, 0.56),
        generator.uniform(0.18, 0.24),
        generator.uniform(0.0025, 0.0045),
    )
    moduli = _spruce(generator)
    frequency = plate_frequencies(length, width, thickness, generator.uniform(380, 460), moduli)[:20]
    damping = generator.uniform(0.004, 0.010, len(frequency))
    return Body(None, float(moduli[0]), frequency, damping, generator.uniform(0.1, 1.0, len(frequency)))


def sound(
    body: Body, generator: np.random.Generator, *, rate: int, taps: int, lead: float, apart: float, ring: float
) -> Array:
    """Return a series of taps in background noise; the loudest sample is 1.

    Parameters
    ----------
    lead, apart, ring : s before the first tap, from tap to tap, and after the last.
    """
    starts = [lead + apart * number for number in range(taps)]
    time = np.arange(int((starts[-1] + ring) * rate)) / rate
    heard = np.zeros(len(time))
    contact = generator.uniform(0.0003, 0.001)
    for start in starts:
        after = time - start
        on = after >= 0
        strength = generator.uniform(0.6, 1.0)
        for frequency, damping, loud in zip(body.frequency, body.damping, body.loud, strict=True):
            if frequency < 0.45 * rate:
                spectrum = 1 / (1 + (frequency * contact) ** 2)
                decay = np.exp(-2 * np.pi * damping * frequency * after[on])
                phase = 0.3 * generator.standard_normal()
                pull = np.sin(2 * np.pi * frequency * np.sqrt(1 - damping**2) * after[on] + phase)
                heard[on] += strength * loud * spectrum * generator.uniform(0.7, 1.0) * decay * pull
        blow = on & (after < contact)
        heard[blow] += 0.5 * strength * np.sin(np.pi * after[blow] / contact)
    heard /= np.abs(heard).max()
    hiss = scipy.signal.lfilter([1], [1, -0.7], generator.standard_normal(len(time)))
    return np.asarray(heard + generator.uniform(0.0005, 0.003) * hiss)


def limited(heard: Array, rate: int) -> Array:
    """Return a sound under an automatic gain: what is loud is held down within 5 ms and let go within 300."""
    gain, gains = 1.0, np.ones(len(heard))
    rise, fall = 1 - np.exp(-1 / (0.3 * rate)), 1 - np.exp(-1 / (0.005 * rate))
    for index, size in enumerate(np.abs(heard).tolist()):
        wanted = 1.0 if size * gain < 0.4 else 0.4 / size
        gain += (wanted - gain) * (fall if wanted < gain else rise)
        gains[index] = gain
    return np.asarray(heard * gains)


def fan(heard: Array, rate: int, generator: np.random.Generator) -> Array:
    """Return a sound beside a fan: hum that wanders a little, and rushing air."""
    time = np.arange(len(heard)) / rate
    turns = 2 * np.pi * np.cumsum(23.3 * (1 + 0.003 * np.sin(2 * np.pi * 0.7 * time))) / rate
    hum = sum(np.sin(number * turns + number) / number for number in (1, 2, 5, 10))
    air = scipy.signal.lfilter([0.02], [1, -0.98], generator.standard_normal(len(heard)))
    return np.asarray(heard + 0.02 * hum + 0.05 * air)


def _written(path: Path, heard: Array, rate: int, form: str = "PCM_16", level: float = 0.7) -> Path:
    soundfile.write(path, level * heard, rate, subtype=form)
    return path


Recorder = Callable[[Path, Body, np.random.Generator], Path]


def recorders() -> dict[str, Recorder]:
    """Return the ways to record, by name."""

    def plain(rate: int, form: str) -> Recorder:
        def record(folder: Path, body: Body, generator: np.random.Generator) -> Path:
            heard = sound(body, generator, rate=rate, taps=3, lead=0.5, apart=1.2, ring=1.0)
            return _written(folder / "a.wav", heard, rate, form)

        return record

    def changed(
        change: Callable[[Array, int, np.random.Generator], Array], ending: str = "wav", **how: float
    ) -> Recorder:
        def record(folder: Path, body: Body, generator: np.random.Generator) -> Path:
            timing = {"taps": 3, "lead": 0.5, "apart": 1.2, "ring": 1.0, **how}
            rate = 44100
            heard = sound(
                body, generator, rate=rate, taps=int(timing["taps"]), lead=timing["lead"], apart=timing["apart"],
                ring=timing["ring"],
            )  # fmt: skip
            form = {"wav": "PCM_16", "ogg": "VORBIS", "mp3": "MPEG_LAYER_III"}[ending]
            return _written(folder / f"a.{ending}", change(heard, rate, generator), rate, form)

        return record

    def same(heard: Array, _rate: int, _generator: np.random.Generator) -> Array:
        return heard

    return {
        "44.1 kHz, 16 bit": plain(44100, "PCM_16"), "48 kHz, 24 bit": plain(48000, "PCM_24"),
        "96 kHz, 32 bit": plain(96000, "PCM_32"), "192 kHz, float": plain(192000, "FLOAT"),
        "384 kHz, 16 bit": plain(384000, "PCM_16"), "44.1 kHz, 8 bit": plain(44100, "PCM_U8"),
        "8 kHz, telephone": plain(8000, "ULAW"),
        "one dead channel": changed(lambda heard, _rate, _generator: np.column_stack([0 * heard, heard])),
        "offset of 0.2": changed(lambda heard, _rate, _generator: heard + 0.2),
        "automatic gain": changed(lambda heard, rate, _generator: limited(heard, rate)),
        "clipped attack": changed(lambda heard, _rate, _generator: np.clip(1.8 * heard, -1, 1)),
        "clipped at full scale": changed(lambda heard, _rate, _generator: np.clip(3 * heard, -1.42, 1.42)),
        "fan": changed(fan),
        "OGG": changed(same, "ogg"), "MP3": changed(same, "mp3"),
        "begins 5 ms before one tap": changed(same, taps=1, lead=0.005),
        "begins with the tap": changed(same, taps=1, lead=0.0),
        "one tap of 0.2 s": changed(same, taps=1, lead=0.02, ring=0.2),
        "five taps, 0.4 s apart": changed(same, taps=5, apart=0.4),
    }  # fmt: skip


def _told(recording: Recording, bar: Bar | None) -> TapTest:
    """Return what the command says."""
    return tap_test([recording], bar=bar, band=BAT_BAND if bar is None else bar.band)


def held(body: Body, test: TapTest) -> tuple[int, int, str]:
    """Return how many loud tones hold a true mode within their interval, of how many, and what E is off in sigma."""
    right, tones = 0, 0
    for one in test.tones:
        if one.tone.distinct:
            tones += 1
            near = float(np.abs(body.frequency - one.tone.frequency.value).min())
            right += near < REACH * one.tone.frequency.error
    if test.bar is None:
        return right, tones, ""
    off = (test.bar.modulus.value - body.modulus) / test.bar.modulus.error
    part = test.bar.modulus.value / body.modulus - 1
    return right, tones, f"E {1e-9 * test.bar.modulus.value:.1f} GPa, {100 * part:+.1f} % ({off:+.1f} sigma)"


def main(arguments: Sequence[str] | None = None) -> None:
    """Print a line per body and way to record."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1, help="of each body and recorder")
    parser.add_argument("--seed", type=int, default=1, help="of the first")
    parser.add_argument("--only", help="recorders whose name has this in it")
    options = parser.parse_args(arguments)
    for name, record in recorders().items():
        if options.only and options.only not in name:
            continue
        for kind, made in (("brace", brace), ("metal bar", metal_bar), ("strip", strip), ("plate", plate)):
            for seed in range(options.seed, options.seed + options.count):
                generator = np.random.default_rng(seed)
                body = made(generator)
                with tempfile.TemporaryDirectory() as folder:
                    try:
                        test = _told(read_recording(record(Path(folder), body, generator)), body.bar)
                    except InputError as error:
                        print(f"{name}; {kind} {seed}: refused: {error}", flush=True)
                        continue
                right, tones, said = held(body, test)
                faults = sorted({tap.fault for tap in test.taps if tap.fault})
                print(
                    f"{name}; {kind} {seed}: {len(test.good)} taps, {right} of {tones} tones right, {said} {faults}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
