"""A ball that was measured: its law is found again, its file is that ball, and a contradiction is said."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.answers.calibrate_ball import (
    Bounce,
    CalibrateBallQuestion,
    calibrate_ball_answer,
    drop_bounce,
)
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.balls import ball_doubts, ball_of_text
from sweetspot.equipment.ball import RestitutionLaw
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH
from sweetspot.units import MPH

Run = Callable[..., tuple[int, str, str]]


@given(
    level=st.floats(0.40, 0.60),
    slope=st.floats(0.0004, 0.0025),
    speeds=st.lists(st.floats(5.0, 60.0), min_size=2, max_size=5, unique_by=lambda speed: round(speed / 8)),
)
def test_a_law_that_is_measured_well_is_found_again(level: float, slope: float, speeds: list[float]) -> None:
    """Exact: bounces of a straight line with errors of a millionth leave nothing of what was believed before."""
    law = RestitutionLaw(reference=level, reference_speed=26.0, slope=slope)
    bounces = [Bounce(speed, Measured(float(law.at(speed)), 1e-7)) for speed in speeds]
    found = calibrate_ball_answer(CalibrateBallQuestion("baseball", bounces))
    own = ball_of_text(found.to_toml())
    for speed in (10.0, 40.0):
        assert own.restitution.at(speed) == pytest.approx(law.at(speed), abs=3e-4)
    assert found.slope.error < found.slope_before.error / 20


def test_its_file_has_the_doubts_of_the_fit() -> None:
    """Level and slope are independent where the file has them, and its spreads are those of the answer."""
    bounces = [Bounce(speed * MPH, Measured(value, 0.005)) for speed, value in ((58, 0.53), (90, 0.50))]
    mass, compression = Measured(0.1452, 0.0003), Measured(1300.0, 40.0)
    found = calibrate_ball_answer(CalibrateBallQuestion("baseball", bounces, mass, compression, name="mine"))
    own, before = ball_of_text(found.to_toml()), catalog.ball("baseball")
    assert own.name == "mine" and own.mass == pytest.approx(0.1452)
    assert own.spread is not None and own.spread.scatter == 0
    assert own.spread.restitution == pytest.approx(found.restitution.half_width, rel=0.05)
    assert own.spread.slope == pytest.approx(found.slope.half_width, rel=0.05)
    turning = [dict(doubt.deviation) for doubt in ball_doubts(own) if len(doubt.deviation) == 2]
    assert turning[0]["restitution"] == pytest.approx(0, abs=1e-12)
    assert own.stiffness / before.stiffness == pytest.approx(1300 / (264 * 4.4482216), rel=0.02)


def test_one_bounce_moves_the_level_and_leaves_the_slope() -> None:
    found = calibrate_ball_answer(CalibrateBallQuestion("tennis", [Bounce(6.9, Measured(0.70, 0.005))]))
    tennis = catalog.ball("tennis")
    assert found.restitution.value == pytest.approx(0.70, abs=1e-3) and not found.contradictory
    assert found.slope.value == pytest.approx(tennis.restitution.slope, rel=1e-4)
    assert found.slope.half_width == pytest.approx(found.slope_before.half_width, rel=1e-4)


def test_a_drop_is_that_of_the_drop_test() -> None:
    """The rule of tennis, from the rebound on a rigid floor in air: the restitution of the catalogue's ball."""
    tennis = catalog.ball("tennis")
    bounce = drop_bounce(tennis, height=2.54, rebound=Measured(1.41, 0.01))
    assert bounce.restitution.value == pytest.approx(float(tennis.restitution.at(bounce.speed)), abs=0.002)
    assert bounce.restitution.error == pytest.approx(bounce.restitution.value * 0.01 / (2 * 1.41), rel=0.06)


def test_a_cold_ball_is_written_as_it_is_at_its_usual_temperature() -> None:
    bounce = Bounce(26.0, Measured(0.50, 0.002))
    cold = calibrate_ball_answer(CalibrateBallQuestion("baseball", [bounce], temperature=1.1))
    warm = calibrate_ball_answer(CalibrateBallQuestion("baseball", [bounce]))
    assert cold.restitution.value - warm.restitution.value == pytest.approx(20 * 0.0012, abs=1e-3)


def test_bounces_that_lie_on_no_line_contradict_each_other() -> None:
    bounces = [Bounce(speed * MPH, Measured(value, 0.005)) for speed, value in ((58, 0.55), (90, 0.40))]
    assert calibrate_ball_answer(CalibrateBallQuestion("baseball", bounces)).contradictory


@pytest.mark.parametrize(
    ("bounces", "why"), [((), "nothing was measured"), ((Bounce(20.0, Measured(1.2, 0.1)),), "allowed is 0 to 1")]
)
def test_what_no_ball_does_is_refused(bounces: tuple[Bounce, ...], why: str) -> None:
    with pytest.raises(InputError, match=why):
        calibrate_ball_answer(CalibrateBallQuestion("baseball", bounces))


def test_half_widths_cover_the_truth() -> None:
    """Of 200 balls of the catalogue's law, measured twice with error, nine in ten laws lie within the interval."""
    rng, inside = np.random.default_rng(5), 0
    law = catalog.ball("baseball").restitution
    for _ in range(200):
        bounces = [
            Bounce(speed, Measured(float(law.at(speed)) + 0.004 * rng.standard_normal(), 0.004))
            for speed in (20.0, 50.0)
        ]
        found = calibrate_ball_answer(CalibrateBallQuestion("baseball", bounces))
        off = found.restitution.value - float(law.at(found.reference_speed))
        inside += abs(off) < REACH * found.restitution.error
    assert 170 <= inside <= 196


def test_the_command_writes_a_ball_that_hits(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "mine.toml"
    words = ("calibrate-ball", "baseball", "--restitution", "0.48±0.005@58mph", "--out", str(out))
    code, text, said = run(*words)
    assert code == 0 and "it returns 0.480" in text and "wrote" in said
    assert run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", str(out))[0] == 0
    assert run(*words)[0] == 2  # writes over nothing
    torn = run("calibrate-ball", "baseball", "--restitution", "0.4±0.005@90mph", "--restitution", "0.55±0.005@58mph")
    assert torn[0] == 1 and "contradict" in torn[1]
    for wrong, why in (("--drop=254cm", "heights of fall and rebound"), ("--drop=1m:2m", "less than it fell")):
        assert why in run("calibrate-ball", "tennis", wrong)[2]
    assert "with its speed" in run("calibrate-ball", "tennis", "--restitution=0.5")[2]


def test_pounds_at_a_quarter_inch_are_the_load(run_json: Callable[..., Any]) -> None:
    """How balls' compressions are labeled; 1 pqi is 1 lbf there (exact)."""
    for written in ("280pqi±10pqi", "280 PQI ± 10", "280lbf±10lbf"):
        found = run_json("calibrate-ball", "baseball", "--compression", written)
        assert found["compression_n"] == pytest.approx(280 * 4.4482216)
        assert found["compression_error_n"] == pytest.approx(10 * 4.4482216)
