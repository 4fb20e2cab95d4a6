"""Certified paddles: what programs read, measured shots, and the chance to keep the limit."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from sweetspot import certify_paddle
from sweetspot.numerics.interval import interval_of

Run = Callable[..., tuple[int, str, str]]


CRUSHED = """
like = "pickleball-paddle"
name = "crushed"

[soft_spot]
position = "29 cm"
radius = "6.5 cm"
factor = 0.25
"""


def test_programs_find_their_keys(run: Run) -> None:
    code, out, err = run("certify", "pickleball-paddle", "--format", "json")
    assert code == 0, err
    test = json.loads(out)["test"]
    expected = ("pbcor", "position_from_tip_m", "rebound_speed_m_s", "effective_mass_kg", "clamp_inertia_kg_m2", "scan")
    assert set(expected) <= test.keys()
    assert {"position_from_tip_m", "pbcor", "rebound_speed_m_s"} <= test["scan"][0].keys()
    assert (
        test["clamp_inertia_kg_m2"] == pytest.approx(33e-4) and test["pbcor_low"] < test["pbcor"] < test["pbcor_high"]
    )
    assert max(row["pbcor"] for row in test["scan"]) == pytest.approx(test["pbcor"], abs=2e-3)


def test_speed_and_clamp_are_options(run: Run) -> None:
    code, out, err = run(
        "certify", "pickleball-paddle", "--speed", "50mph", "--clamp-inertia", "12.15 kg*cm^2", "--format", "json"
    )
    assert code == 0, err
    answer = json.loads(out)
    assert answer["test"]["speed_m_s"] == pytest.approx(22.352)
    assert answer["test"]["clamp_inertia_kg_m2"] == pytest.approx(12.15e-4)
    assert answer["test"]["pbcor"] == pytest.approx(0.402, abs=0.01)  # the laboratory's level [kewcor]
    assert "holes filled" not in answer["ball"]


def test_other_clamps_and_their_rebounds_are_told() -> None:
    answer = certify_paddle("pickleball-paddle")
    values = [float(interval_of(other.pbcor).value) for other in answer.clamps]
    assert values == sorted(values, reverse=True) and values[-1] > float(interval_of(answer.test.pbcor).value)
    assert all(abs(float(interval_of(other.rebound_change).value)) < 0.012 for other in answer.clamps)


def test_a_crushed_paddle_is_over_the_limit(run: Run, tmp_path: Path) -> None:
    """Exit 1, and hardly a chance to keep the rule."""
    path = tmp_path / "crushed.toml"
    path.write_text(CRUSHED)
    code, out, _ = run("certify", str(path), "--format", "json")
    answer = json.loads(out)
    assert code == 1 and not answer["passed"]
    lively = next(check for check in answer["checks"] if check["quantity"] == "pbcor")
    assert lively["verdict"] == "fail" and lively["passes_probability"] < 0.01


def shots_file(path: Path, *, offset: float = 0.0) -> Path:
    """Write ten shots at each of three places of the model's own rebounds, some mph off, with a scatter."""
    answer, draw = certify_paddle("pickleball-paddle"), np.random.default_rng(3)
    rows = ["ball_in_mph,ball_out_mph,position_in_from_tip"]
    for row in answer.test.scan[5:10:2]:
        for _ in range(10):
            back = float(interval_of(row.rebound_speed).value) / 0.44704 + offset + draw.normal(0.0, 0.1)
            rows.append(f"60,{back:.3f},{float(interval_of(row.position_from_tip).value) / 0.0254:.2f}")
    path.write_text("\n".join(rows))
    return path


def test_shots_of_the_model_give_its_value(run: Run, tmp_path: Path) -> None:
    path = shots_file(tmp_path / "shots.csv")
    code, out, err = run("certify", "pickleball-paddle", "--shots", str(path), "--format", "json")
    assert code == 0, err
    answer = json.loads(out)
    shots = answer["shots"]
    assert shots["good_rows"] == 30 and [place["count"] for place in shots["places"]] == [10, 10, 10]
    assert shots["pbcor"]["low"] < shots["pbcor"]["mean"] < shots["pbcor"]["high"]
    assert shots["pbcor"]["mean"] == pytest.approx(answer["test"]["pbcor"], abs=0.003)
    lively = next(check for check in answer["checks"] if check["quantity"] == "pbcor")
    assert lively["value"] == pytest.approx(shots["pbcor"]["mean"])


def test_livelier_shots_fail(run: Run, tmp_path: Path) -> None:
    path = shots_file(tmp_path / "shots.csv", offset=3.0)
    code, out, _ = run("certify", "pickleball-paddle", "--shots", str(path))
    assert code == 1 and "fails: PBCoR" in out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("pickleball-paddle", "--wall-that-passes"), "a paddle has no wall"),
        (("r161-ash", "--speed", "50mph"), "are for paddles"),
        (("pickleball-paddle", "--speed", "500mph"), "--speed was given as 500mph"),
        (("pickleball-paddle", "--clamp-inertia", "1 kg*m^2"), "--clamp-inertia was given as"),
        (("pickleball-paddle", "--ball", "baseball"), "a ball of baseball"),
        (("tennis-racket",), "not a baseball or softball bat"),
    ],
)
def test_what_does_not_go_together_is_refused(run: Run, words: tuple[str, ...], message: str) -> None:
    code, _, err = run("certify", *words)
    assert code == 2 and message in err
