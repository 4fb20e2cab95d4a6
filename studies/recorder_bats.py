"""How often `sweetspot tap` names the tones of made-up bats rightly, by bat, recorder and description.

    .venv/bin/python -m studies.recorder_bats --count 3 --seed 1

Bats, free or held, are solved by their own finite elements (`struck_beams`), which share nothing with the model that
names the tones; Russell's youth bat has the tones and nodes that were measured; hoop tones and other sports' are drawn
from published ranges. Each is described to `tap` as it is but for its stiffness, as a cousin from the catalogue, or not
at all. Recorders are those of `recorder_taps` and a few more. Nothing in `sweetspot.calibration` was set on these.
"""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import scipy.signal
import soundfile
import tomli_w

from studies.recorder_taps import Array, Body, Recorder, recorders, sound
from studies.struck_beams import FREE, GRIPS, Beam, Grip, free_shapes, ring_frequency, shaken
from sweetspot import catalog
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.recording import read_recording
from sweetspot.calibration.tap_analysis import TapTest, held_damping, modes_to_name, tap_test, usual_band
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError

INCH = 0.0254
SAME = 0.012
"""Part of a frequency within which a tone is a mode."""
YOUTH = np.array([215.0, 670.0, 1252.0])
"""Hz, measured on a free youth bat of wood [russell_bendsweet]."""


@dataclass(frozen=True)
class Ringing:
    """An implement that can be tapped.

    Parameters
    ----------
    names, frequency, damping : of its modes, Hz and ratios, shape (n,).
    shape : deflection at a place from the knob end as a part of the length, (n,).
    length : m.
    own : the description that is right but for the stiffness, as a bat's file; None: there is none.
    cousin : of the catalogue.
    shifts : how far the hands moved each frequency, as a part of it.
    beam : that was solved; None: its tones were measured or drawn.
    """

    names: tuple[ModeName, ...]
    frequency: Array
    damping: Array
    shape: Callable[[float], Array]
    length: float
    own: dict[str, object] | None
    cousin: str
    shifts: Array
    beam: Beam | None = None


def bending_names(count: int) -> tuple[ModeName, ...]:
    """Return the names of the lowest bending modes."""
    return tuple(ModeName("bending", number + 1) for number in range(count))


def drawn_outline(generator: np.random.Generator, *, length: float, handle: float, barrel: float) -> Array:
    """Return places from the knob end and diameters in m of a bat whose taper is a cosine."""
    start, end = length * generator.uniform(0.15, 0.35), length * generator.uniform(0.72, 0.92)
    middle = np.linspace(start, end, 9)
    taper = handle + (barrel - handle) * (1 - np.cos(np.pi * (middle - start) / (end - start))) / 2
    knob = generator.uniform(1.75, 2.0) * INCH
    return np.array(
        [(0.0, knob), (0.6 * INCH, knob), (1.3 * INCH, handle), *zip(middle, taper, strict=True),
         (length - 0.4 * INCH, barrel * generator.uniform(0.97, 1.0)), (length, 0.8 * barrel)]
    )  # fmt: skip


def held_beam(beam: Beam, damping: float, generator: np.random.Generator, grip: Grip) -> tuple[Array, Array, Array]:
    """Return frequency, damping and how far the hands moved the frequency, of the modes below 5.5 kHz."""
    free = beam.frequency
    lost = damping * generator.uniform(0.8, 1.25, len(free))
    frequency, ratio = shaken(beam, lost, grip)
    return frequency, ratio, frequency / free - 1


def bat_file(name: str, length: float, mass: float, outline: Array, **more: object) -> dict[str, object]:
    """Return the table of a bat file; lengths and diameters in m, the mass in kg."""
    profile = [[f"{place:.5f} m", f"{diameter:.5f} m"] for place, diameter in outline]
    return {"name": name, "length": f"{length:.5f} m", "mass": f"{mass:.4f} kg", "profile": profile, **more}


def wood(generator: np.random.Generator, grip: Grip = FREE) -> Ringing:
    """Return an adult bat of ash or maple: E of 11 to 19 GPa, E/G of 11 to 20, damping of 0.4 to 1 %."""
    length = generator.uniform(32, 34.5) * INCH
    handle, barrel = generator.uniform(0.90, 1.02) * INCH, generator.uniform(2.4, 2.61) * INCH
    outline = drawn_outline(generator, length=length, handle=handle, barrel=barrel)
    density, modulus = generator.uniform(580, 720), generator.uniform(11e9, 19e9)
    beam = Beam.solid(outline, density=density, modulus=modulus, shear=modulus / generator.uniform(11, 20))
    frequency, damping, shifts = held_beam(beam, generator.uniform(0.004, 0.010), generator, grip)
    own = bat_file("made-up wood", length, beam.mass, outline, material=str(generator.choice(["white ash", "maple"])))
    return Ringing(bending_names(len(frequency)), frequency, damping, beam.shape, length, own, "r161-ash", shifts)


def hollow(generator: np.random.Generator, grip: Grip = FREE) -> Ringing:
    """Return a bat of aluminium: 2.0 to 3.3 mm of wall, hoop tones up to a third above its ring's."""
    length = generator.uniform(31, 34) * INCH
    barrel = generator.uniform(2.25, 2.625) * INCH
    outline = drawn_outline(generator, length=length, handle=generator.uniform(0.85, 0.95) * INCH, barrel=barrel)
    wall, thin = generator.uniform(2.0e-3, 3.3e-3), generator.uniform(1.8e-3, 2.6e-3)
    cap, knob = generator.uniform(0.010, 0.035), generator.uniform(0.03, 0.07)
    (apart,) = generator.spawn(1)
    depths = apart.uniform(0.012, 0.030), apart.uniform(0.005, 0.020)  # the owner does not know them
    beam = Beam.tube(outline, walls=(thin, wall), ends=(knob, cap), depths=depths)
    frequency, damping, shifts = held_beam(beam, generator.uniform(0.001, 0.004), generator, grip)
    ring = ring_frequency(barrel, wall, harmonic=2) * generator.uniform(1.0, 1.3)
    hoops = ring * np.array([1.0, generator.uniform(1.25, 1.9), generator.uniform(2.0, 2.9)])
    names = (*bending_names(len(frequency)), ModeName("hoop", 2), ModeName("hoop", 2), ModeName("hoop", 3))
    place = generator.uniform(0.76, 0.84)

    def shape(part: float) -> Array:
        swell = np.exp(-(((part - place) / 0.13) ** 2))
        second = (part - place) / 0.13 * swell
        return np.append(beam.shape(part), 3.0 * np.array([swell, second, 0.5 * swell]))

    shell = {
        "wall": [["0 m", f"{thin} m"], [f"{0.38 * length:.4f} m", f"{thin} m"], [f"{0.75 * length:.4f} m", f"{wall} m"],
                 [f"{length:.5f} m", f"{wall} m"]],
        "end_cap_mass": f"{cap} kg", "knob_mass": f"{knob} kg",
    }  # fmt: skip
    own = bat_file("made-up hollow", length, beam.mass, outline, material="aluminium_7xxx", shell=shell)
    return Ringing(
        names, np.append(frequency, hoops), np.append(damping, generator.uniform(0.001, 0.006, 3)), shape, length, own,
        "single-wall", np.append(shifts, np.zeros(3)), beam,
    )  # fmt: skip


def youth(generator: np.random.Generator, _: Grip = FREE) -> Ringing:
    """Return Russell's youth bat; a higher mode is heard too."""
    frequency = np.append(YOUTH, 1252.0 * generator.uniform(1.5, 1.62))
    damping = generator.uniform(0.004, 0.009, 4)
    nodes = ((6.0, 23.5), (2.5, 15.0, 25.5), (1.8, 10.0, 19.0, 27.0), (1.4, 7.5, 14.5, 21.0, 27.6))

    def shape(part: float) -> Array:
        return np.array([np.prod([(part - node / 30) for node in one]) * 4 ** len(one) for one in nodes])

    return Ringing(bending_names(4), frequency, damping, shape, 30 * INCH, None, "youth-30", np.zeros(4))


def _of_sport(
    cousin: str, first: tuple[float, float], ratio: tuple[float, float], length: float, lost: tuple[float, float]
) -> Callable[[np.random.Generator, Grip], Ringing]:
    """Return how an implement is made whose first tone and second over first lie in these ranges."""

    def make(generator: np.random.Generator, _: Grip = FREE) -> Ringing:
        lowest, second = generator.uniform(*first), generator.uniform(*ratio)
        stretch = np.log(second) / np.log(2.757)
        frequency = lowest * np.array([1.0, 2.757, 5.404, 8.933]) ** stretch * generator.normal(1, 0.02, 4)
        frequency[0] = lowest
        damping = generator.uniform(*lost, 4)
        return Ringing(bending_names(4), frequency, damping, free_shapes, length, None, cousin, np.zeros(4))

    return make


KINDS: dict[str, Callable[[np.random.Generator, Grip], Ringing]] = {
    "wood": wood, "hollow": hollow, "youth": youth,
    "tennis": _of_sport("tennis-racket", (120, 180), (2.6, 3.0), 0.685, (0.004, 0.012)),  # 100 to 180 Hz [Cross]
    "cricket": _of_sport("cricket-bat", (120, 150), (2.8, 3.3), 0.85, (0.008, 0.015)),  # 120 to 150, 350 to 450 Hz
    "hockey": _of_sport("hockey-stick", (105, 154), (2.6, 3.0), 0.93, (0.006, 0.012)),  # 74 to 154 Hz
    "golf": _of_sport("golf-driver", (36, 50), (2.6, 3.0), 1.15, (0.005, 0.012)),
}  # fmt: skip
"""Published ranges of first tones and their ratios, as in the pages of these sports."""


def tapped_body(one: Ringing, *, at: float, listened: float) -> Body:
    """Return what rings when an implement is tapped, and heard, at places as parts of its length."""
    loud = np.abs(one.shape(at) * one.shape(listened)) * np.sqrt(one.frequency / one.frequency[0])
    heard = loud > 1e-4 * loud.max()
    names = np.flatnonzero(heard)
    return Body(None, 0.0, one.frequency[names], one.damping[names], loud[names] / loud.max())


def two_planes(one: Ringing, generator: np.random.Generator) -> Ringing:
    """Return the same bat whose modes differ by 0.2 to 1.5 % between its two planes."""
    apart = 1 + generator.uniform(0.002, 0.015, len(one.frequency))
    part = generator.uniform(0.1, 0.5)

    def shape(place: float) -> Array:
        return np.append(one.shape(place), part * one.shape(place))

    return replace(
        one, names=one.names * 2, frequency=np.append(one.frequency, apart * one.frequency),
        damping=np.tile(one.damping, 2), shape=shape, shifts=np.tile(one.shifts, 2),
    )  # fmt: skip


def faulty_recorders() -> dict[str, Recorder]:
    """Return recorders with what goes wrong when a bat is tapped at home."""

    def changed(change: Callable[[Array, int, np.random.Generator], Array], **how: float) -> Recorder:
        def record(folder: Path, body: Body, generator: np.random.Generator) -> Path:
            rate = 48000
            timing = {"taps": 3, "lead": 0.8, "apart": 1.3, "ring": 1.0, **how}
            heard = sound(body, generator, rate=rate, taps=int(timing["taps"]), lead=timing["lead"],
                          apart=timing["apart"], ring=timing["ring"])  # fmt: skip
            heard = change(heard, rate, generator)
            path = folder / "a.wav"
            soundfile.write(path, 0.7 * heard / np.abs(heard).max(), rate, subtype="PCM_16")
            return path

        return record

    def mains(heard: Array, rate: int, _: np.random.Generator) -> Array:
        time = np.arange(len(heard)) / rate
        hum = sum(np.sin(2 * np.pi * 60 * number * time + number) / number for number in (1, 2, 3, 5, 7))
        return np.asarray(heard + 0.05 * hum)

    def room(heard: Array, rate: int, generator: np.random.Generator) -> Array:
        time = np.arange(int(0.5 * rate)) / rate
        echo = generator.standard_normal(len(time)) * np.exp(-6.9 * time / generator.uniform(0.2, 0.5))
        echo[: int(0.004 * rate)] = 0
        echo *= generator.uniform(0.1, 0.3) / np.sqrt(np.sum(echo**2))
        echo[0] = 1.0
        return np.asarray(scipy.signal.fftconvolve(heard, echo)[: len(heard)])

    def bounced(heard: Array, rate: int, _: np.random.Generator) -> Array:
        later = np.roll(heard, int(0.06 * rate))
        return np.asarray(heard + 0.6 * later)

    def handled(heard: Array, _rate: int, generator: np.random.Generator) -> Array:
        rubbed = scipy.signal.lfilter([0.05], [1, -0.95], generator.standard_normal(len(heard)))
        slow = scipy.signal.lfilter([1e-4], [1, -1 + 1e-4], generator.standard_normal(len(heard)))
        gusts = np.maximum(slow, 0.0)
        return np.asarray(heard + 0.15 * rubbed * gusts / gusts.max())

    def same(heard: Array, _rate: int, _generator: np.random.Generator) -> Array:
        return heard

    return {
        "mains hum": changed(mains), "live room": changed(room), "bounced hammer": changed(bounced),
        "handling noise": changed(handled), "10 s of silence before": changed(same, lead=10.0),
        "six taps": changed(same, taps=6),
    }  # fmt: skip


PLACES = {"tip": 0.97, "barrel": 0.85, "node of mode 1": 0.80, "knob": 0.02, "middle": 0.5}
"""Where it is tapped, parts of the length."""


def descriptions(one: Ringing, folder: Path) -> Iterator[tuple[str, Implement | None]]:
    """Return the ways in which the implement is described to the command."""
    yield "nothing", None
    yield "cousin", catalog.load_implement(one.cousin)
    if one.own is not None:
        path = folder / "own.toml"
        path.write_text(tomli_w.dumps(one.own))
        yield "own", catalog.load_implement(str(path))


def told(path: Path, described: Implement | None, at: float | None) -> TapTest:
    """Return what the command says."""
    modes = None if described is None else modes_to_name(described)
    places = [] if described is None or at is None else [at * described.length]
    return tap_test(
        [read_recording(path)], modes=modes, positions=places, band=usual_band(modes), held=held_damping(modes)
    )


def judged(one: Ringing, test: TapTest) -> tuple[Counter[str], list[str]]:
    """Return how many tones are named rightly, wrongly and not, and the wrong ones in words."""
    counts: Counter[str] = Counter()
    wrong = []
    for tone in test.tones:
        off = np.abs(np.log(tone.tone.frequency.value / one.frequency))
        true = {one.names[index] for index in np.flatnonzero(off < SAME)}
        own = "" if tone.tone.distinct else ", room's?"
        if tone.name is None:
            counts["unnamed" if true else "unnamed other"] += 1
        elif tone.name in true:
            counts["right"] += 1
        else:
            counts["WRONG"] += 1
            are = "/".join(str(name) for name in sorted(true, key=str)) or "nothing"
            wrong.append(f"{tone.tone.frequency.value:.0f} Hz is {are}, not {tone.name}{own}")
    return counts, wrong


def main(arguments: Sequence[str] | None = None) -> None:
    """Print a line per bat, place, recorder and description."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1, help="of each bat and recorder")
    parser.add_argument("--seed", type=int, default=1, help="of the first")
    parser.add_argument("--only", help="recorders whose name has this in it")
    parser.add_argument("--kinds", default=",".join(KINDS), help="of implements, with commas")
    parser.add_argument("--grip", default="free", choices=sorted(GRIPS), help="how it is held")
    parser.add_argument("--planes", action="store_true", help="modes differ between the two planes")
    options = parser.parse_args(arguments)
    total: dict[tuple[str, str], Counter[str]] = {}
    for name, record in {**recorders(), **faulty_recorders()}.items():
        if options.only and options.only not in name:
            continue
        for kind in options.kinds.split(","):
            for seed in range(options.seed, options.seed + options.count):
                generator = np.random.default_rng(seed)
                one = KINDS[kind](generator, GRIPS[options.grip])
                one = two_planes(one, generator) if options.planes else one
                place, at = list(PLACES.items())[int(generator.integers(len(PLACES)))]
                body = tapped_body(one, at=at, listened=generator.uniform(0.02, 0.98))
                with tempfile.TemporaryDirectory() as folder:
                    path = record(Path(folder), body, generator)
                    for described, implement in descriptions(one, Path(folder)):
                        counts = total.setdefault((kind, described), Counter())
                        start = f"{name}; {kind} {seed} at the {place}, described by {described}"
                        try:
                            test = told(path, implement, at)
                        except InputError as error:
                            print(f"{start}: refused: {str(error)[:160]}", flush=True)
                            counts["refused"] += 1
                            continue
                        here, wrong = judged(one, test)
                        counts.update(here)
                        warned = ["told as perhaps held"] if test.touched else []
                        warned += ["told as hardly this"] if test.unlike else []
                        counts.update(warned)
                        bad = len(test.taps) - len(test.good)
                        words = [*warned, *wrong, *([f"{bad} taps not used"] if bad else [])]
                        print(f"{start}: {dict(here)} {'; '.join(words)}", flush=True)
    for (kind, described), counts in total.items():
        print(f"{kind}, described by {described}: {dict(counts)}")


if __name__ == "__main__":
    main()
