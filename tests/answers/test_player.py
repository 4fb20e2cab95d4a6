"""A fitted player and a fitted team as answers: their fields, frames and notebook cells."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.answers.player import FitPlayerAnswer, fit_player_answer
from sweetspot.answers.player_question import FitPlayerQuestion
from sweetspot.answers.team import fit_team_answer
from sweetspot.numerics.interval import Interval
from sweetspot.player.goal import Goal
from sweetspot.player.prior import natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import FOOT, MPH


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two batters who swing the same bat alike."""
    lines = ["player,bat_speed_mph,exit_speed_mph,pitch_speed_mph"]
    for batter in ("Ann", "Bea"):
        swings = simulated_swings(
            natural(np.zeros(10)),
            bats=[catalog.bat("r161-ash")],
            ball=catalog.ball(),
            count=8,
            pitch_speed=60 * MPH,
            seed=len(lines),
        )
        speeds = [(swing.bat_speed or 0.0, swing.exit_speed or 0.0) for swing in swings]
        lines += [f"{batter},{bat / MPH:.2f},{ball / MPH:.2f},60" for bat, ball in speeds]
    path = tmp_path_factory.mktemp("swings") / "swings.csv"
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def answer(file: Path) -> FitPlayerAnswer:
    return fit_player_answer(FitPlayerQuestion(file, batter="Ann", goal=Goal("carry")))


def test_every_number_has_its_interval_and_its_unit(answer: FitPlayerAnswer) -> None:
    assert isinstance(answer.now, Interval) and answer.now.low < answer.now.value < answer.now.high
    metric, customary = answer.to_dict(), answer.to_dict(units="us")
    assert customary["now_ft"]["low"] == pytest.approx(metric["now_m"]["low"] / FOOT)
    speed = customary["parameters"]["bat_speed"]
    assert speed["value_mph"] == pytest.approx(metric["parameters"]["bat_speed"]["value_m_s"] / MPH)
    assert speed["prior"]["low_mph"] < speed["low_mph"] < speed["high_mph"]
    assert metric["worth"]["towards_tip"]["change"] == {"position_m": pytest.approx(-0.0254)}


def test_a_frame_has_a_row_for_every_bat(answer: FitPlayerAnswer) -> None:
    frame = answer.to_frame(units="us")
    assert len(frame) == len(answer.options) > 10
    assert frame["change_ft"].is_sorted(descending=True) and frame["length_in"].is_between(31, 36).all()


def test_a_notebook_shows_the_training_report(answer: FitPlayerAnswer) -> None:
    before, _, behind = answer._repr_html_().partition("<details>")
    assert "What to train" in before and "Which bat?" not in before and "Which bat?" in behind and answer.plot().axes


def test_a_team_is_a_row_a_batter(file: Path) -> None:
    team = fit_team_answer(FitPlayerQuestion(file))
    assert {batter.batter for batter in team.batters} == {"Ann", "Bea"} and team.league is None
    assert team.to_frame()["expected_m_s"].is_between(30, 50).all()
    assert team.to_dict()["batters"][0]["parameters"]["bat_speed"]["own_share"] == 1.0
    assert "Team sheet" in team._repr_html_()


def test_a_team_is_sorted_by_what_is_sure(file: Path) -> None:
    """Eight swings tell little: what is not told by own swings is not told, and who surely gains most stands first."""
    team = fit_team_answer(FitPlayerQuestion(file))
    gains = [float(batter.surely_gained) for batter in team.batters]
    assert gains == sorted(gains, reverse=True)
    for batter in team.batters:
        sure = [worth.gain.low for worth in batter.advice.surely_worth]
        assert float(batter.surely_gained) == pytest.approx(max(sure, default=0.0)) and batter.best is None
        assert batter.told_by_swings == batter.advice.worth["position_spread"].own
    assert team._repr_html_().count("For everybody, not by these swings") == 1


def test_other_answers_take_the_player_from_its_file(tmp_path: Path, file: Path) -> None:
    """The speed with a bat of the same length is the same in both answers, and so is what is not known of the law."""
    heavy = catalog.bat("r161-ash").weighted(position=0.7, mass=0.08).replaced(name="heavy")
    fitted = fit_player_answer(FitPlayerQuestion(file, batter="Ann", other_bats=[heavy]))
    answer = tmp_path / "player.json"
    answer.write_text(json.dumps(fitted.to_dict()), encoding="utf-8")
    first, second = sweetspot.compare("r161-ash", heavy, player=answer).bats
    (tried,) = (option for option in fitted.options if option.key == "bat:heavy")
    assert float(first.bat_speed) == pytest.approx(float(fitted.parameters["bat_speed"].value), rel=1e-6)
    assert float(second.bat_speed) == pytest.approx(float(tried.bat_speed), rel=2e-3)
    with_law = sweetspot.compare("r161-ash", heavy, player=answer, bat_speed=30.0).bats
    assert float(with_law[0].bat_speed) == pytest.approx(30.0)  # what is given counts
