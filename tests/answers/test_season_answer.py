"""A season from Python: a question in, and the answer as dictionary, frame, page and picture."""

from __future__ import annotations

import gc
from dataclasses import replace
from pathlib import Path

import polars as pl
import pytest

from sweetspot.answers.season import SeasonAnswer, season_answer
from sweetspot.answers.season_question import SeasonQuestion
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.units import MPH
from tests.seasons.conftest import made_up


@pytest.fixture(scope="module")
def answer(tmp_path_factory: pytest.TempPathFactory) -> SeasonAnswer:
    path = tmp_path_factory.mktemp("season") / "swings.csv"
    made_up(300).write_csv(path)
    return season_answer(SeasonQuestion(paths=(path,), others=("mlb-a",)))


def test_a_season_is_a_dictionary_with_units_in_its_names(answer: SeasonAnswer) -> None:
    si, us = answer.to_dict(), answer.to_dict(units="us")
    assert si["tables"][0]["columns"]["exit_speed"] == {"heading": "launch_speed", "unit": "mph"}
    assert si["league"]["balls"] == sum(si["tables"][0]["ledger"].values()) == 300
    (tried,), (tried_us,) = si["other_bats"], us["other_bats"]
    assert tried["low_m_s"] < tried["gain_m_s"] < tried["high_m_s"]
    assert tried_us["gain_mph"] == pytest.approx(tried["gain_m_s"] / MPH)
    assert us["places"]["spread_in"] == pytest.approx(si["places"]["spread_m"] / 0.0254)
    assert "question" not in si and "drawn" not in si


def test_its_frames_are_players_groups_and_balls(answer: SeasonAnswer) -> None:
    players, clubs = answer.to_frame(units="us"), answer.to_frame(key="team")
    assert len(players) == 6 and "exit_speed_low90_mph" in players.columns and "exit_speed_m_s" in clubs.columns
    assert players["balls"].sum() == clubs["balls"].sum() == len(answer.balls().collect()) == 300
    assert answer.to_frame(key="nothing").is_empty()


def test_a_notebook_shows_the_season_and_a_player(answer: SeasonAnswer) -> None:
    assert "300 balls in play with an exit speed" in answer._repr_html_()
    assert len(answer.plot().axes) == 2 and repr(answer) == "<SeasonAnswer of 300 balls in play, 1 tables>"
    player = answer.player("600002")
    assert player.to_dict()["balls"] == 50 and player.to_dict()["ev20_m_s"] == player.row["ev20"]
    assert player.to_dict("us")["ev20_mph"] == pytest.approx(player.row["ev20"] / MPH)
    assert "Player 600002" in player._repr_html_()
    with pytest.raises(InputError, match="no batter 'Nobody'"):
        answer.player("Nobody")


def test_a_folder_that_nobody_asked_for_goes_with_the_last_answer(tmp_path: Path) -> None:
    made_up(30).write_parquet(tmp_path / "table.parquet")
    paths = (tmp_path / "table.parquet", tmp_path / "players.csv")
    pl.DataFrame({"batter": [1], "balls": [2], "ev20_mph": [3.0], "home_runs_expected": [1.0],
                  "home_runs_average_park": [1.0], "home_runs": [1]}).write_csv(paths[1])  # fmt: skip
    with pytest.warns(UnusualWarning, match=r"left out, as season wrote them itself: players\.csv"):
        found = season_answer(SeasonQuestion(paths=paths, contact=False))
    folder, found = found.season.folder, replace(found, drag=())
    gc.collect()
    assert len(found.balls().collect()) == 30 and folder.exists()
    del found
    gc.collect()
    assert not folder.exists()
