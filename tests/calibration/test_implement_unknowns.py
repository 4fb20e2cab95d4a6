"""Rackets, cricket bats, clubs and sticks from scale, balance, swing weight and tap: injected truth comes back."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.calibration.calibrated_file import calibrated_table
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import BatPosterior, calibrate
from sweetspot.calibration.unknowns import as_described, described, deviated, unknowns_of
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.files.write import bat_table
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.implement_doubt import expected_deviations

Run = Callable[..., tuple[int, str, str]]
ERRORS = {"mass": 0.002, "balance_point": 0.003, "period": 0.0015, "frequency": 0.004}
"""One sigma as a part of the value: kitchen scale, balance on an edge, ten swings, a tap."""
FIRST = ModeName("bending", 1)
WANTED = [
    Measurement("mass", Measured(1, 1)),
    Measurement("balance_point", Measured(1, 1)),
    Measurement("period", Measured(1, 1), axis=0.08),
    Measurement("frequency", Measured(1, 1), mode=FIRST),
]


def measured(beam: BeamModel, seed: int | None) -> list[Measurement]:
    """Return what scale, edge, string and telephone would say; None: without any error."""
    generator = np.random.default_rng(seed)
    found = []
    for one, value in zip(WANTED, predicted(beam, WANTED).tolist(), strict=True):
        size = ERRORS[one.kind] * value
        off = 0.0 if seed is None else size * generator.standard_normal()
        found.append(Measurement(one.kind, Measured(value + off, size), axis=one.axis, mode=one.mode))
    return found


def meant(name: str, seed: int | None) -> tuple[BatPosterior, np.ndarray[Any, Any]]:
    """Return the calibration of an implement that deviates from the catalogue's, and its true deviations."""
    implement = catalog.load_implement(name)
    beam, unknowns = described(implement), unknowns_of(implement)
    spreads = np.array([one.spread for one in unknowns])
    generator = np.random.default_rng(0 if seed is None else seed + 1000)
    truth = 0.3 * spreads * np.clip(generator.standard_normal(len(unknowns)), -1.5, 1.5)
    return calibrate(beam, unknowns, measured(deviated(beam, unknowns, truth), seed)), truth


@pytest.mark.parametrize("name", ["tennis-racket", "badminton-racket", "cricket-bat", "golf-driver"])
def test_the_truth_comes_back(name: str) -> None:
    posterior, truth = meant(name, None)
    assert posterior.deviations == pytest.approx(truth, abs=2e-3)
    assert not posterior.contradictions


def test_intervals_hold_the_truth() -> None:
    """Of 40 rackets with errors of the instruments: 160 intervals, of which 144 should and 134 to 154 may hold it."""
    inside = 0
    for seed in range(40):
        posterior, truth = meant("tennis-racket", seed)
        inside += int(np.sum(np.abs(posterior.deviations - truth) < REACH * np.sqrt(np.diag(posterior.covariance))))
    assert 134 <= inside <= 156


@pytest.mark.parametrize("name", ["badminton-racket", "cricket-bat", "golf-driver", "hockey-stick"])
def test_the_file_reads_back(name: str, tmp_path: Path) -> None:
    """Weighed, hung and tapped as the file says, it answers what was measured."""
    import tomli_w

    implement = catalog.load_implement(name)
    posterior = calibrate(described(implement), unknowns_of(implement), measured(described(implement), None))
    path = tmp_path / "own.toml"
    path.write_text(tomli_w.dumps(calibrated_table(posterior, None)), encoding="utf-8")
    beam = beam_model(catalog.load_implement(str(path)))
    body, own = rigid_body(beam), rigid_body(posterior.beam)
    assert (body.mass, body.balance_point, body.moi(0.1)) == pytest.approx((own.mass, own.balance_point, own.moi(0.1)))
    assert bending_frequencies(beam, count=1)[0] == pytest.approx(posterior.beam.bat.frequency)
    assert tomllib.loads(path.read_text(encoding="utf-8"))["first_frequency"]["kind"] == "measured"


EDGES = np.array([[2.5, 0, 0, 0], [-2.5, 0, 0, 0], [2, 2, 2, 2], [-2, 2, -2, 2], [2, -2, 2, -2], [-2, -2, -2, -2]])
"""Deviations in their spreads, of the first four unknowns: beyond them measurements contradict what is expected."""


@pytest.mark.parametrize(
    "name",
    ["tennis-racket", "badminton-racket", "cricket-bat", "golf-driver", "hockey-stick", "r161-ash", "single-wall"],
)
@pytest.mark.parametrize("kinds", [("mass",), ("mass", "balance_point", "period")])
def test_whatever_is_written_reads_and_answers(name: str, kinds: tuple[str, ...]) -> None:
    """At the edges of what is expected, and one standard deviation beyond what the measurements leave open."""
    implement = catalog.load_implement(name)
    beam, unknowns = described(implement), unknowns_of(implement)
    spreads = np.array([one.spread for one in unknowns])
    wanted = [one for one in WANTED if one.kind in kinds]
    for edge in EDGES:
        truth = spreads * np.resize(np.append(edge, np.zeros(len(spreads))), len(spreads))
        values = predicted(deviated(beam, unknowns, truth), wanted).tolist()
        given = [
            Measurement(one.kind, Measured(value, ERRORS[one.kind] * value), axis=one.axis)
            for one, value in zip(wanted, values, strict=True)
        ]
        posterior = calibrate(beam, unknowns, given)
        if posterior.contradictions:
            continue
        read = implement_from_table(calibrated_table(posterior, None), name)
        own, body = rigid_body(posterior.beam), rigid_body(beam_model(read))
        assert (body.mass, body.balance_point, body.moi_cm) == pytest.approx((own.mass, own.balance_point, own.moi_cm))
        again = as_described(read) if not isinstance(read, Bat) else beam_model(read)
        for step in np.diag(np.sqrt(np.diag(posterior.covariance))):
            for sign in (1.0, -1.0):
                assert rigid_body(deviated(again, unknowns, sign * step)).mass > 0


def test_what_is_not_known_of_an_uncalibrated_racket() -> None:
    """The catalogue's is one of many; a weight and a frequency that a file gives of its own were measured."""
    racket = catalog.load_implement("tennis-racket")
    unknowns, covariance = expected_deviations(racket)
    assert np.sqrt(np.diag(covariance)) == pytest.approx([one.spread for one in unknowns])
    unknowns, covariance = expected_deviations(racket.replaced(mass=0.322, first_frequency=150.0))
    left = dict(zip([one.name for one in unknowns], np.sqrt(np.diag(covariance)).tolist(), strict=True))
    assert left == pytest.approx(
        {"mass": 0.003, "balance_point": 0.04, "gyration": 0.06, "first_frequency": 0.03}, rel=0.02
    )
    assert expected_deviations(catalog.load_implement("table-tennis-racket"))[0] == ()


def test_a_weight_beyond_the_usual_density_is_said(run: Run) -> None:
    told = " ".join(run("calibrate", "hockey-stick", "--mass", "593g±3g")[1].split())
    assert "As drawn it weighs this only at 1688 kg/m³; carbon-fibre laminate usually has 1450 to 1650 kg/m³." in told


def test_a_calibration_written_by_hand_is_checked() -> None:
    """Far from any density nothing is believed, nor is a drawing that no bat has."""
    stick = catalog.load_implement("hockey-stick").replaced(calibrated=True)
    assert rigid_body(beam_model(stick.replaced(mass=0.66, balance_point=None, moi=None))).mass == pytest.approx(0.66)
    with pytest.raises(InputError, match="only at a density"):
        beam_model(stick.replaced(mass=6.6, balance_point=None, moi=None))
    table = bat_table(catalog.bat("r161-ash")) | {"length": "33 m"}
    table["calibration"] = {"measured": ["mass"], "unknowns": ["density"], "covariance": [[0.001]]}
    with pytest.raises(InputError, match="length"):
        implement_from_table(table, "mine")


def test_what_cannot_be_calibrated_is_said() -> None:
    with pytest.raises(InputError, match="plies"):
        unknowns_of(catalog.load_implement("table-tennis-racket"))


def test_the_commands(run: Run, run_json: Callable[..., Any], tmp_path: Path) -> None:
    """A racket is calibrated into a file that hits; wrong sides of the question are refused in a line."""
    out = tmp_path / "mine.toml"
    given = ("--mass", "322g±0.5g", "--balance-point", "32.8cm±0.1cm", "--pendulum", "1.352s±0.002s", "--pivot", "10cm")
    code, answer, _ = run("calibrate", "tennis-racket", *given, "--tone", "bending-1:150Hz±0.5Hz", "--out", str(out))
    assert code == 0
    assert "swing weight about 10 cm" in answer
    assert catalog.load_implement(str(out)).mass == pytest.approx(0.322, abs=1e-4)
    assert run_json("hit", str(out), "--at", "15cm-from-tip", "--uncertainty")["exit_speed_low_m_s"] > 0
    for wrong, message in ((("--tone", "bending-2:300Hz"), "only the first"), (("--shots", str(out)), "bats only")):
        code, answer, error = run("calibrate", "tennis-racket", *given, *wrong)
        assert (code, answer) == (2, "")
        assert message in error


def test_a_moment_is_about_the_axis_of_its_sport(run: Run) -> None:
    """A racket's 316 kg cm^2 are about 10 cm; about baseball's 6 in they are 384 there, 20 % off in silence."""
    for axis, given in (("10 cm", ()), ("10 cm", ("--pivot", "10cm"))):
        code, answer, _ = run("calibrate", "tennis-racket", "--moi", "316kg*cm^2±1kg*cm^2", *given)
        assert code == 0
        assert f"swing weight about {axis} from the butt end  316.0" in answer
    code, answer, _ = run("calibrate", "r161-ash", "--moi", "11000oz*in^2±50oz*in^2")
    assert code == 0 and " 11,000 ± 8" in answer


def test_a_dozen_rackets_are_ranked(run_json: Callable[..., Any], run: Run, tmp_path: Path) -> None:
    """More swing weight and the same swing: the exit speeds are in the order of what was injected."""
    rows = [f"R{number},{318 + number}.0±0.3,32.5±0.05,{306 + 1.5 * number:.1f}±0.4,140.0±0.4" for number in range(12)]
    table = tmp_path / "rackets.csv"
    table.write_text("name,mass_g,balance_point_cm,moi_kg_cm2,bending_1_hz\n" + "\n".join(rows), encoding="utf-8")
    found = run_json("rank", str(table), "--like", "tennis-racket", "--same-speed")
    assert [one["name"] for one in found["bats"]] == [f"R{number}" for number in reversed(range(12))]
    assert found["beyond_doubt"]
    assert found["bats"][0]["swing_weight_kg_m2"] == pytest.approx(322.5e-4, rel=1e-3)
    table.write_text("name,mass_g,bending_2_hz\nA,318,300\nB,319,300\n", encoding="utf-8")
    code, _, error = run("rank", str(table), "--like", "tennis-racket", "--force")
    assert code == 2
    assert "bending_1_hz" in error
