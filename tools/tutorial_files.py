"""Make the files of the tutorials (`tests/tutorials`): made up, with the truth known.

It prints the truth, and what scale, string and tap say where no file holds it.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.bat_table import TIMED
from sweetspot.calibration.measured import FLOORS, Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.recording import LOUDNESS, Recording, recording_bytes, tap_sound
from sweetspot.calibration.unknowns import Unknown, described, deviated, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.cli import main as run
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.reduction import ReducedBat, all_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Conditions, Pitch
from sweetspot.numerics.arrays import Array
from sweetspot.reports.calibration.document import as_part
from sweetspot.units import INCH, MPH, OUNCE, OUNCE_INCH_SQUARED

FOLDER = Path(__file__).parents[1] / "tests" / "tutorials"
BODY = (
    Measurement("mass", Measured(1, 0.05 * OUNCE)), Measurement("balance_point", Measured(1, 0.05 * INCH)),
    Measurement("period", Measured(1, 0.003)),
)  # fmt: skip
"""A kitchen scale, a balance on an edge, a pendulum timed over twenty swings."""
MET, SCATTER = 6.3, 1.6
"""Where the made-up player meets the ball, in from the tip, and its standard deviation."""
SHEAR_SPREAD = 0.2
"""By which shear moduli of made-up billets differ, one sigma: less than is supposed of wood in general."""
METAL_SEED, METAL_PART = 33, 0.6
"""Which made-up metal bat, and what part of the spreads between bats of one model it has."""
RATE = 16_000.0
"""Samples per s of the recording: a bat's first five modes end below 3 kHz."""


def differing(bat: Bat, seed: int, *, by: float = 1.0) -> BeamModel:
    """Return a bat that differs from its description as bats do, times ``by``."""
    unknowns = unknowns_of(bat)
    spreads = np.array([_spread(one) for one in unknowns])
    return deviated(described(bat), unknowns, by * spreads * np.random.default_rng(seed).standard_normal(len(unknowns)))


def _spread(unknown: Unknown) -> float:
    return SHEAR_SPREAD if unknown.name == "shear_modulus" else unknown.spread


def measured(beam: BeamModel, wanted: list[Measurement] | tuple[Measurement, ...], seed: int) -> list[float]:
    """Return what is measured on a bat, SI, with the errors of the instruments."""
    generator = np.random.default_rng(seed)
    values = predicted(beam, list(wanted)).tolist()
    return [value + one.value.error * generator.standard_normal() for one, value in zip(wanted, values, strict=True)]


def dozen() -> str:
    """Return a table of twelve bats like R161 in ash."""
    rows = ["name,mass_oz,balance_point_in,pendulum_s"]
    for number in range(1, 13):
        mass, balance, period = measured(differing(catalog.bat("r161-ash"), number, by=0.7), BODY, 100 + number)
        rows.append(f"No {number},{mass / OUNCE:.2f}±0.05,{balance / INCH:.2f}±0.05,{period:.4f}±0.003")
    return "\n".join(rows) + "\n"


def efficiency(beam: BeamModel, conditions: Conditions, places: Array) -> Array:
    """Return q at places in m from the knob end."""
    return scan(ReducedBat.of_beam(beam, conditions.ball), conditions, places).collision_efficiency


def swings(seed: int, *, count: int, speed: float) -> list[str]:
    """Return rows of one player's swings with two bats: bat, bat speed, exit speed, pitch speed, place."""
    generator = np.random.default_rng(seed)
    first = described(catalog.bat("r161-ash"))
    law, rows = catalog.swing_law(), []
    for name in ("r161-ash", "mlb-a"):
        bat = catalog.bat(name)
        beam, conditions = described(bat), standard_conditions(bat)
        heavier = rigid_body(beam).moi(law.axis) / rigid_body(first).moi(law.axis)
        bat_speed = speed * heavier**-law.exponent + 1.5 * generator.standard_normal(count)
        from_tip = np.clip(MET + SCATTER * generator.standard_normal(count), 0.5, 14)
        pitch = 60 + 2 * generator.standard_normal(count)
        places = bat.length - np.sort(from_tip) * INCH
        there = efficiency(beam, conditions, places)[np.argsort(np.argsort(from_tip))]
        turned = (bat.length / INCH - from_tip) / (bat.length / INCH - 6)  # the speed grows along the bat
        square = np.cos(0.12 * generator.standard_normal(count))  # hit a little beside the middle
        leaves = square * (there * pitch + (1 + there) * bat_speed * turned) + generator.standard_normal(count)
        rows += [
            f"{name},{a:.1f},{b:.1f},{c:.1f},{d:.1f}"
            for a, b, c, d in zip(bat_speed, leaves, pitch, from_tip, strict=True)
        ]
    return rows


def write_coach(folder: Path) -> None:
    """Write a dozen bats, a player's swings, and a team's."""
    head = "bat,bat_speed_mph,exit_speed_mph,pitch_speed_mph,position_in_from_tip"
    (folder / "dozen.csv").write_text(dozen(), encoding="utf-8")
    (folder / "swings.csv").write_text("\n".join([head, *swings(1, count=25, speed=66)]) + "\n", encoding="utf-8")
    names = ("Ann", "Bea", "Cal", "Dee", "Eve", "Fay")
    team = [
        f"{name},{row}"
        for number, name in enumerate(names)
        for row in swings(10 + number, count=8, speed=62 + 1.5 * number)
    ]
    (folder / "team.csv").write_text("\n".join([f"player,{head}", *team]) + "\n", encoding="utf-8")


def write_maker(folder: Path) -> None:
    """Write the sound of a bat that was turned from the drawing, and print what scale and string say of it."""
    with TemporaryDirectory() as written:
        file = Path(written) / "drawing-12.toml"
        with suppress(SystemExit):
            run(["outline", str(folder / "drawing.dxf"), "--material", "sugar maple", "--out", str(file)])
        bat = catalog.bat(str(file))
    turned = differing(bat, 5)
    mass, balance, period = measured(turned, BODY, 105)
    print(f"turned: {mass / OUNCE:.2f} oz, {balance / INCH:.2f} in, {period:.4f} s")
    print("turned, off: ", off(bat, 5))
    write_taps(folder / "turned.flac", turned, 5)


def write_taps(path: Path, beam: BeamModel, seed: int) -> None:
    """Write the sound of four taps 1 in from the tip of a hanging bat."""
    place = beam.bat.length - 1 * INCH
    one = tap_sound(all_modes(beam, catalog.ball()), position=place, listened=place, seconds=0.9, rate=RATE)
    one = LOUDNESS * one / np.abs(one).max()
    generator = np.random.default_rng(seed)
    quiet = np.zeros(round(0.3 * RATE))
    sound = np.concatenate([quiet, *(part * one for part in generator.uniform(0.6, 1.0, 4))])
    sound += 0.001 * generator.standard_normal(len(sound))
    path.write_bytes(recording_bytes(Recording(path.stem, sound, RATE), path))


def write_metal_bat(folder: Path) -> None:
    """Write the sound of a metal bat like the catalogue's, and print what scale and string say of it."""
    bat = catalog.bat("college-alloy")
    own = differing(bat, METAL_SEED, by=METAL_PART)
    mass, balance, period = measured(own, BODY, 100 + METAL_SEED)
    print(f"own metal bat: {mass / OUNCE:.2f} oz, {balance / INCH:.2f} in, {period:.4f} s")
    print("own metal bat, off: ", off(bat, METAL_SEED, by=METAL_PART))
    write_taps(folder / "taps.flac", own, METAL_SEED)


def write_laboratory(folder: Path) -> None:
    """Write shots at a metal bat, and print what scale, pendulum and tap say of it."""
    bat = catalog.bat("college-alloy")
    seed = 9
    tested = differing(bat, seed, by=0.7)
    moi = Measurement("moi", Measured(1, 20 * OUNCE_INCH_SQUARED))
    tones = [Measurement("frequency", Measured(1, 0.5), mode=ModeName("bending", 1)),
             Measurement("frequency", Measured(1, 2), mode=ModeName("hoop", 2))]  # fmt: skip
    mass, balance, period, inertia, bending, hoop = measured(
        tested, [*(replace(one, value=Measured(1, one.value.error / 2)) for one in BODY), moi, *tones], 100 + seed
    )
    print(f"tested: {mass / OUNCE:.2f} oz, {balance / INCH:.2f} in, {period:.4f} s, "
          f"{inertia / OUNCE_INCH_SQUARED:.0f} oz in^2, {bending:.1f} Hz, {hoop:.0f} Hz")  # fmt: skip
    print("tested, off: ", off(bat, seed, by=0.7))
    generator = np.random.default_rng(seed)
    from_tip = np.repeat(np.arange(4.0, 8.5, 0.5), 6)
    ball = catalog.ball()
    places = bat.length - from_tip * INCH
    shot = hits(all_modes(tested, ball), ball=ball, position=places, closing_speed=np.full(len(places), 136 * MPH))
    came = 136 + 0.5 * generator.standard_normal(len(from_tip))
    ball_cor = ball.restitution.at(60 * MPH) + 0.004 * generator.standard_normal(len(from_tip))
    left = came * (shot.collision_efficiency + 0.006 * generator.standard_normal(len(from_tip)))
    rows = [f"{a:.1f},{b:.1f},{c:g},{d:.3f}" for a, b, c, d in zip(came, left, from_tip, ball_cor, strict=True)]
    head = "ball_in_mph,ball_out_mph,position_in_from_tip,ball_cor"
    (folder / "shots.csv").write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")


DAY = (
    *(Measurement(kind, Measured(1, FLOORS[kind])) for kind in ("mass", "balance_point")),
    Measurement("period", Measured(1, FLOORS["pendulum"])),
    *(Measurement("frequency", Measured(1, FLOORS["tone"]), mode=ModeName("bending", number)) for number in (1, 2)),
)
"""What the sheet of a measuring day asks of a wooden bat."""
DAY_SEED, CAGE = 40, {"pitch": 60.0, "bat": 68.0, "from_tip": 7.0}
"""Of the first made-up bat of the day; speeds in the cage in mph, and where the ball is met, in from the tip."""


def write_measuring_day(folder: Path) -> None:
    """Write the filled sheet of six bats that were turned from one design, and print the truth of the fourth."""
    bat = catalog.bat(str(folder / "designed.toml"))
    rows = ["name,mass_oz,balance_point_in,twenty_swings_s,bending_1_hz,bending_2_hz,moisture_percent"]
    for number in range(1, 7):
        mass, balance, period, *tones = measured(differing(bat, DAY_SEED + number, by=0.7), DAY, 100 + number)
        heard = ",".join(f"{tone:.1f}" for tone in tones)
        rows.append(f"No {number},{mass / OUNCE:.2f},{balance / INCH:.2f},{TIMED * period:.2f},{heard},")
    (folder / "measured.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    print("No 4, off: ", off(bat, DAY_SEED + 4, by=0.7), f"leaves at {in_the_cage(bat):.1f} mph")


def in_the_cage(bat: Bat) -> float:
    """Return the exit speed in mph of the fourth bat of the day, as it truly is."""
    usual = standard_conditions(bat)
    swing = usual.swing.replaced(bat_speed=CAGE["bat"] * MPH)
    conditions = usual.replaced(swing=swing, pitch=Pitch(speed=CAGE["pitch"] * MPH))
    place = np.array([bat.length - CAGE["from_tip"] * INCH])
    beam = differing(bat, DAY_SEED + 4, by=0.7)
    return float(scan(ReducedBat.of_beam(beam, conditions.ball), conditions, place).exit_speed[0] / MPH)


def off(bat: Bat, seed: int, *, by: float = 1.0) -> dict[str, str]:
    """Return by how much each property of a bat made by `differing` is off its description."""
    unknowns = unknowns_of(bat)
    truth = np.random.default_rng(seed).standard_normal(len(unknowns))
    parts = {
        str(one.name): as_part(one.name, Measured(by * _spread(one) * away, 0.0))
        for one, away in zip(unknowns, truth, strict=True)
    }
    return {name: f"{part.value:+.1%}" for name, part in parts.items()}


def main() -> None:
    """Write all."""
    folders = {
        "coach": write_coach,
        "maker": write_maker,
        "laboratory": write_laboratory,
        "measuring_day": write_measuring_day,
        "metal_bat": write_metal_bat,
    }
    for name, write in folders.items():
        (FOLDER / name).mkdir(parents=True, exist_ok=True)
        write(FOLDER / name)


if __name__ == "__main__":
    main()
