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
from sweetspot.calibration.measured import REACH, Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.naming import ModeName
from sweetspot.calibration.posterior import Posterior, calibrate
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.bending import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.errors import InputError

Run = Callable[..., tuple[int, str, str]]
ERRORS = {"mass": 0.002, "balance_point": 0.003, "period": 0.0015, "frequency": 0.004}
"""One sigma as a part of the value: kitchen scale, balance on an edge, ten swings, a tap."""
FIRST = ModeName("bending", 1)
WANTED = [
    Measurement("mass", Measured(1, 1)), Measurement("balance_point", Measured(1, 1)),
    Measurement("period", Measured(1, 1), axis=0.08), Measurement("frequency", Measured(1, 1), mode=FIRST),
]  # fmt: skip


def measured(line: BeamModel, seed: int | None) -> list[Measurement]:
    """Return what scale, edge, string and telephone would say; None: without any error."""
    generator = np.random.default_rng(seed)
    found = []
    for one, value in zip(WANTED, predicted(line, WANTED).tolist(), strict=True):
        size = ERRORS[one.kind] * value
        off = 0.0 if seed is None else size * generator.standard_normal()
        found.append(Measurement(one.kind, Measured(value + off, size), axis=one.axis, mode=one.mode))
    return found


def meant(name: str, seed: int | None) -> tuple[Posterior, np.ndarray[Any, Any]]:
    """Return the calibration of an implement that deviates from the catalogue's, and its true deviations."""
    implement = catalog.load_implement(name)
    line, unknowns = described(implement), unknowns_of(implement)
    spreads = np.array([one.spread for one in unknowns])
    generator = np.random.default_rng(0 if seed is None else seed + 1000)
    truth = 0.3 * spreads * np.clip(generator.standard_normal(len(unknowns)), -1.5, 1.5)
    return calibrate(line, unknowns, measured(deviated(line, unknowns, truth), seed)), truth


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
    line = beam_model(catalog.load_implement(str(path)))
    body, own = rigid_body(line), rigid_body(posterior.line)
    assert (body.mass, body.balance_point, body.moi(0.1)) == pytest.approx((own.mass, own.balance_point, own.moi(0.1)))
    assert bending_frequencies(line, count=1)[0] == pytest.approx(posterior.line.bat.frequency)
    assert tomllib.loads(path.read_text(encoding="utf-8"))["first_frequency"]["kind"] == "measured"


def test_what_cannot_be_calibrated_is_said() -> None:
    with pytest.raises(InputError, match="plies"):
        unknowns_of(catalog.load_implement("table-tennis-racket"))


def test_the_commands(run: Run, run_json: Callable[..., Any], tmp_path: Path) -> None:
    """A racket is calibrated into a file that hits; wrong sides of the question are refused in a line."""
    out = tmp_path / "mine.toml"
    given = ("--mass", "322g±0.5g", "--balance-point", "32.8cm±0.1cm", "--pendulum", "1.352s±0.002s", "--pivot", "10cm")
    code, answer, _ = run("calibrate", "tennis-racket", *given, "--tone", "bending-1:150Hz±0.5Hz", "--out", str(out))
    assert code == 0
    assert "swing weight about 10.0 cm" in answer
    assert catalog.load_implement(str(out)).mass == pytest.approx(0.322, abs=1e-4)
    assert run_json("hit", str(out), "--at", "15cm-from-tip", "--uncertainty")["exit_speed_low_m_s"] > 0
    for wrong, message in ((("--tone", "bending-2:300Hz"), "only the first"), (("--shots", str(out)), "bats only")):
        code, answer, error = run("calibrate", "tennis-racket", *given, *wrong)
        assert (code, answer) == (2, "")
        assert message in error


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
