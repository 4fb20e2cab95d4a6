"""Whether `sweetspot calibrate` finds made-up bats that another code solved: weighed, balanced, hung and tapped.

    .venv/bin/python -m studies.calibrated_bats --count 10 --seed 1

Bats are those of `struck_beams`, which share nothing with our beam, and are recorded as in `recorder_bats`. What scale,
balance and pendulum say, and the drawing, have the errors that are told to the command. `--case` says what the user got
wrong: nothing; the bat was held; it was tapped elsewhere than told; another bat's drawing was given.

Moduli of the woods are those of straight-grained billets, and G lies between those of both planes: 0.077 and 0.109 of E
for white ash, 0.063 and 0.111 for sugar maple (the Wood Handbook's elastic ratios, recalled).
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import math
import os
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only get in each other's way

import numpy as np
import tomli_w

from studies.recorder_bats import (
    INCH,
    PLACES,
    Ringing,
    bat_file,
    bending_names,
    drawn_outline,
    faulty_recorders,
    held_beam,
    hollow,
    tapped_body,
)  # fmt: skip
from studies.recorder_taps import recorders
from studies.struck_beams import FREE, GRIPS, Beam, Grip
from sweetspot.calibration.calibrated_file import known_deviations
from sweetspot.catalog.implements import loaded_implement
from sweetspot.catalog.standard_hit import standard_analysis
from sweetspot.cli import main as command
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import all_modes
from sweetspot.numerics.constants import STANDARD_AXIS, STANDARD_GRAVITY
from sweetspot.numerics.interval import REACH
from sweetspot.numerics.piecewise import cubic_spline
from sweetspot.uncertainty.drawn_hits import speed_doubt
from sweetspot.uncertainty.implement_doubt import doubt_of_piece
from sweetspot.uncertainty.sources import Sources

WOODS = {"white ash": (0.077, 0.109), "sugar maple": (0.063, 0.111)}
"""G over E in the two planes."""
SCALE, BALANCE, PENDULUM, DRAWING, WALL, FITTING = 0.001, 0.0015, 0.002, 0.003, 0.08, 0.1
"""One sigma of what is told: kg, m, s; diameters, walls, and masses of a hollow bat's ends as parts of them."""
ROOMS = ("44.1 kHz, 16 bit", "48 kHz, 24 bit", "live room", "mains hum", "handling noise", "one dead channel")
"""Ways to record, in turns."""
GRIPPED = ("fingers", "light", "hand", "hands")
ELSEWHERE = ("node of mode 1", "middle", "barrel", "knob")
CASES = ("right", "held", "elsewhere", "cousin")


@dataclass(frozen=True)
class Truth:
    """A made-up bat: what rings, and what is true of it by name, SI."""

    ringing: Ringing
    values: dict[str, float]


def billet(generator: np.random.Generator, wood: str, grip: Grip) -> Truth:
    """Return a bat of ash or maple: E of 12.5 to 18 GPa, 5 % denser or lighter at the tip, up to 15 g of tape."""
    length = generator.uniform(32, 34.5) * INCH
    handle, barrel = generator.uniform(0.90, 1.02) * INCH, generator.uniform(2.4, 2.61) * INCH
    outline = drawn_outline(generator, length=length, handle=handle, barrel=barrel)
    density, modulus = generator.uniform(590, 750), generator.uniform(12.5e9, 18e9)
    shear = modulus * generator.uniform(*WOODS[wood])
    beam = Beam.solid(
        outline, density=density, modulus=modulus, shear=shear, gradient=generator.uniform(-0.08, 0.08),
        knob=generator.uniform(0.001, 0.015),
    )  # fmt: skip
    frequency, damping, shifts = held_beam(beam, generator.uniform(0.004, 0.010), generator, grip)
    own = bat_file("made-up wood", length, beam.mass, outline, material=wood)
    cousin = "r161-ash" if wood == "white ash" else "mlb-c"
    names = bending_names(len(frequency))
    ringing = Ringing(names, frequency, damping, beam.shape, length, own, cousin, shifts, beam)
    return Truth(ringing, {"longitudinal_modulus": modulus, "shear_modulus": shear, **of_body(beam)})


def tube(generator: np.random.Generator, grip: Grip) -> Truth:
    """Return a hollow bat; its hoop tones are drawn, and E is that of aluminium."""
    ringing = hollow(generator, grip)
    assert ringing.beam is not None
    return Truth(ringing, {"longitudinal_modulus": 71e9, **of_body(ringing.beam)})


def of_body(beam: Beam) -> dict[str, float]:
    """Return weight, balance point and moment of inertia about 6 in."""
    moi = beam.moi_cm + beam.mass * (beam.balance_point - STANDARD_AXIS) ** 2
    return {"mass": beam.mass, "balance_point": beam.balance_point, "moi": moi}


def weighed(truth: Truth, generator: np.random.Generator) -> list[str]:
    """Return what scale, balance and a pendulum about 6 in say, as options."""
    of = truth.values
    arm = of["balance_point"] - STANDARD_AXIS
    period = 2 * math.pi * math.sqrt(of["moi"] / (of["mass"] * STANDARD_GRAVITY * arm))
    told = zip(("--mass", "--balance-point", "--pendulum"), (of["mass"], of["balance_point"], period),
               (SCALE, BALANCE, PENDULUM), ("kg", "m", "s"), strict=True)  # fmt: skip
    return [
        word
        for option, value, error, unit in told
        for word in (option, f"{value + error * generator.standard_normal():.6f}{unit}±{error}{unit}")
    ]


def drawing(own: dict[str, Any], generator: np.random.Generator) -> dict[str, Any]:
    """Return a bat's file as its owner knows it: handle and barrel, walls and ends are off by what is usual."""
    rows = np.array([[float(text.split()[0]) for text in row] for row in own["profile"]])
    part = np.clip((rows[:, 1] - rows[:, 1].min()) / np.ptp(rows[:, 1]), 0, 1)
    off = DRAWING * generator.standard_normal(2)
    rows[:, 1] *= np.exp(off[0] * (1 - part) + off[1] * part)
    changed = {**own, "profile": [[f"{place:.5f} m", f"{wide:.5f} m"] for place, wide in rows.tolist()]}
    if shell := own.get("shell"):
        wall, cap, knob = np.exp(np.array([WALL, FITTING, FITTING]) * generator.standard_normal(3))
        changed["shell"] = {
            "wall": [[place, f"{float(thick.split()[0]) * wall:.6f} m"] for place, thick in shell["wall"]],
            "end_cap_mass": f"{float(shell['end_cap_mass'].split()[0]) * cap:.5f} kg",
            "knob_mass": f"{float(shell['knob_mass'].split()[0]) * knob:.5f} kg",
        }
    return changed


def true_exit_speed(truth: Truth, file: str) -> tuple[float, float, float]:
    """Return the best hit's exit speed by the calibrated file, its error by the bat, and the true one there, m/s.

    The true one is that of the modes that the other code solved; how the ball dents the wood, which no tap tells, is
    ours.
    """
    beam, known = truth.ringing.beam, known_deviations(loaded_implement(file).table)
    assert beam is not None and known is not None
    analysis = standard_analysis(file)
    doubt = speed_doubt(analysis, Sources(doubt_of_piece(file, *known), (), "its calibration", "bat"))
    assert doubt is not None
    conditions, place = analysis.conditions, np.array([analysis.sweet_spots.max_exit_speed])
    ours = all_modes(analysis.beam, conditions.ball)
    count = len(ours)
    rates = 4 * np.pi * np.append([0.0, 0.0], beam.solved)[:count] * float(np.mean(truth.ringing.damping))
    modes = Modes(
        ours.families, ours.harmonics, np.append([0.0, 0.0], beam.solved)[:count], rates,
        cubic_spline(beam.places, beam.modes[:, :count]), ours.rigid_part, np.zeros((0, count)),
        compliances=ours.compliances,
    )  # fmt: skip
    speed = conditions.swing.angular_speed * (place - conditions.swing.pivot)
    both = [
        exit_speed(
            hits_with_motion(one, ball=conditions.ball, position=place, closing_speed=speed + conditions.pitch.speed)
            .collision_efficiency, ball_speed=conditions.pitch.speed, bat_speed=speed,
        )[0]
        for one in (ours, modes)
    ]  # fmt: skip
    return float(both[0]), doubt.error, float(both[1])


def run(words: list[str]) -> tuple[int, str, str]:
    """Return the exit code of a command, what it printed, and its warnings."""
    out, err = io.StringIO(), io.StringIO()
    code = 0
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            command(words)
        except SystemExit as stopped:
            code = int(stopped.code or 0)
    told = [line for line in err.getvalue().splitlines() if "still working" not in line and "wrote" not in line]
    return code, out.getvalue(), " ".join(told)


def tried(kind: str, seed: int, case: str, folder: Path) -> tuple[str, dict[str, float]]:
    """Return what the command made of one bat, and by how many sigma its values miss the truth.

    What it made is "refused", "contradicting", "warned" or "answered", and in brackets why.
    """
    generator = np.random.default_rng((seed, len(kind)))
    grip = GRIPS[GRIPPED[seed % len(GRIPPED)]] if case == "held" else FREE
    truth = tube(generator, grip) if kind == "hollow" else billet(generator, kind, grip)
    one = truth.ringing
    at = PLACES[ELSEWHERE[seed % len(ELSEWHERE)]] if case == "elsewhere" else PLACES["tip"]
    sound = {**recorders(), **faulty_recorders()}[ROOMS[seed % len(ROOMS)]](
        folder, tapped_body(one, at=at, listened=generator.uniform(0.02, 0.98)), generator
    )
    assert one.own is not None
    own, made = folder / "own.toml", folder / "made.toml"
    own.write_text(tomli_w.dumps(drawing(one.own, generator)))
    told = (1 - PLACES["tip"]) * one.length
    code, out, err = run(
        ["calibrate", one.cousin if case == "cousin" else str(own), *weighed(truth, generator), "--tap", str(sound),
         "--at", f"{1e3 * told:.1f}mm-from-tip", "--format", "json", "--out", str(made)]
    )  # fmt: skip
    if code == 2:
        return f"refused [{err[:150]}]", {}
    answer = json.loads(out)
    if code == 1:
        return f"contradicting [{answer['findings'][0][:220]}]", {}
    off = {}
    for name, true in truth.values.items():
        if name in answer["bat"]:
            entry = answer["bat"][name]
            value, error = (next(entry[key] for key in entry if key.startswith(name) and ("_error" in key) is wide)
                            for wide in (False, True))  # fmt: skip
            off[name] = (value - true) / error
    if kind != "hollow":
        ours, error, true_speed = true_exit_speed(truth, str(made))
        off["exit_speed"] = (ours - true_speed) / error
    names = [row["name"] for row in answer["measurements"]]
    return f"{'warned' if err else 'answered'} [{err[:150]} {', '.join(names[3:])}]", off


def main(arguments: Sequence[str] | None = None) -> None:
    """Print a line per bat and case, and what became of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=5, help="of each kind")
    parser.add_argument("--seed", type=int, default=1, help="of the first")
    parser.add_argument("--kinds", default=",".join([*WOODS, "hollow"]), help="with commas")
    parser.add_argument("--case", default="right", choices=CASES, help="what the user got wrong")
    options = parser.parse_args(arguments)
    for kind in options.kinds.split(","):
        became: Counter[str] = Counter()
        inside: dict[str, list[bool]] = {}
        for seed in range(options.seed, options.seed + options.count):
            with tempfile.TemporaryDirectory() as folder:
                told, off = tried(kind, seed, options.case, Path(folder))
            became[told.split(" ")[0]] += 1
            for name, sigma in off.items():
                inside.setdefault(name, []).append(abs(sigma) < REACH)
            sigmas = ", ".join(f"{name} {sigma:+.1f}" for name, sigma in off.items())
            print(f"{kind} {seed}, {options.case}: {told} {sigmas}", flush=True)
        parts = ", ".join(f"{name} {sum(held)} of {len(held)}" for name, held in inside.items())
        print(f"{kind}, {options.case}: {dict(became)}; inside its 90 % interval: {parts}", flush=True)


if __name__ == "__main__":
    main()
