"""Columns of any vintage are understood, others pass through, and a doubt is one clear line."""

from __future__ import annotations

from datetime import date
from pathlib import Path
from typing import Any

import polars as pl
import pytest
from polars.testing import assert_frame_equal

from sweetspot import catalog
from sweetspot.answers.season import season_answer
from sweetspot.answers.season_question import SeasonQuestion
from sweetspot.errors import InputError
from sweetspot.reports import html
from sweetspot.reports.quantities import US
from sweetspot.reports.season.document import player_page
from sweetspot.seasons.batters import require_batter
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.made_up import MadeSeason, made_season
from sweetspot.seasons.season_table import analyse_season, season_columns, season_setting
from sweetspot.tables.headings import GivenColumns
from tests.seasons.conftest import made_up

STATCAST_36 = [
    "game_date",
    "game_year",
    "game_pk",
    "home_team",
    "away_team",
    "batter",
    "pitcher",
    "stand",
    "p_throws",
    "pitch_type",
    "release_speed",
    "effective_speed",
    "release_spin_rate",
    "release_extension",
    "release_pos_x",
    "release_pos_y",
    "release_pos_z",
    "vx0",
    "vy0",
    "vz0",
    "ax",
    "ay",
    "az",
    "pfx_x",
    "pfx_z",
    "plate_x",
    "plate_z",
    "events",
    "description",
    "bb_type",
    "hc_x",
    "hc_y",
    "hit_distance_sc",
    "launch_speed",
    "launch_angle",
    "launch_speed_angle",
]
TRACKMAN = [
    "PitchNo",
    "Date",
    "PAofInning",
    "PitchofPA",
    "Pitcher",
    "PitcherId",
    "Batter",
    "BatterId",
    "BatterSide",
    "PitchCall",
    "ExitSpeed",
    "Angle",
    "Direction",
    "HitSpinRate",
    "Distance",
    "Bearing",
    "HangTime",
    "RelSpeed",
    "ZoneSpeed",
    "PlateLocSide",
    "PlateLocHeight",
]


def test_statcast_of_any_vintage_and_order() -> None:
    short = headings_of(STATCAST_36)
    long = headings_of(["\ufeffpitch_type", *reversed(STATCAST_36), "bat_speed", "attack_angle", "new_in_2027"])
    assert short.system == long.system == "Statcast"
    assert short.columns["exit_speed"] == long.columns["exit_speed"]
    assert "bat_speed" not in short.columns and long.columns["bat_speed"].unit == "mph"
    assert "new_in_2027" in long.passed
    assert any("byte order mark" in note for note in long.notes)


def test_trackman_direction_sets_out_and_bearing_comes_down() -> None:
    found = headings_of(TRACKMAN)
    assert found.system == "Trackman"
    assert found.columns["launch_direction"].heading == "Direction"
    assert found.columns["bearing"].heading == "Bearing"
    assert found.columns["batter"].heading == "BatterId" and found.columns["batter_name"].heading == "Batter"


def test_a_club_s_feed_says_where_on_the_bat() -> None:
    found = headings_of([*TRACKMAN, "BatSpeed", "BatAttackAngle", "BatImpactAngle", "BatAxialOffset"])
    assert found.columns["axial_offset"].unit == "in"
    assert found.columns["attack_to_right"].heading == "BatImpactAngle"


def test_plain_names_carry_their_units() -> None:
    found = headings_of(["Exit Velocity [km/h]", "Launch Angle (deg)", "bat_speed_m_s", "note"])
    assert found.columns["exit_speed"].factor == pytest.approx(1 / 3.6)
    assert found.columns["bat_speed"].factor == 1.0
    assert found.passed == ("note",)


@pytest.mark.parametrize(
    ("names", "words"),
    [
        (["a", "b"], "no column for exit speed; launch_speed"),
        (["ev", "la"], "column ev has no unit; write it into the heading, for example ev_mph"),
        (["exit_speed_deg"], "has the unit deg, which is no speed"),
        (["launch_angle", "bat_speed", "hc_x"], "swings alone|no column for exit speed"),
        (["launch_angle", "hc_x"], "no column for exit speed"),  # rather than that the angle has no unit
        (["exit_speed_mph", "bat_speed"], "column bat_speed has no unit"),
    ],
)
def test_a_doubt_is_one_line_that_names_the_column(names: list[str], words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        headings_of(names, file_name="x.csv")
    assert "\n" not in str(caught.value)


def test_a_measurement_without_a_unit_is_left_alone_and_named() -> None:
    found = headings_of(["exit_speed_mph", "Distance", "Temperature (°F)", "Hang Time", "note"])
    assert found.passed == ("Distance", "note") and found.columns["temperature"].unit == "°f"
    assert found.notes == ("Distance has no unit and is left alone; distance_ft, say, would be read",)


def test_a_person_may_say_what_a_column_is() -> None:
    found = headings_of(
        ["Tempo", "Winkel"], given=GivenColumns({"exit_speed": "Tempo:km/h", "launch_angle": "Winkel:deg"})
    )
    assert found.columns["exit_speed"].factor == pytest.approx(1 / 3.6)
    with pytest.raises(InputError, match="no column 'Tempi'"):
        headings_of(["Tempo"], given=GivenColumns({"exit_speed": "Tempi"}))
    with pytest.raises(InputError, match="exit_sped is no quantity"):
        headings_of(["Tempo"], given=GivenColumns({"exit_sped": "Tempo"}))


def test_who_says_which_column_is_the_exit_speed_has_no_leaderboard() -> None:
    names = ["launch_speed", "batted_ball_events"]
    with pytest.raises(InputError, match="leaderboard"):
        headings_of(names)
    assert headings_of(names, given=GivenColumns({"exit_speed": "launch_speed"})).columns["exit_speed"].unit == "mph"


def trackman() -> pl.DataFrame:
    """Return a table by Trackman's names; its dates begin with the month."""
    made = made_up()
    return made.select(
        PitchNo="pitch_number", Date=pl.col("game_date").str.to_date().dt.strftime("%m/%d/%Y"), GameID="game_pk",
        BatterId="batter", BatterSide=pl.col("stand").replace({"L": "Left", "R": "Right"}), PitchCall=pl.lit("InPlay"),
        ExitSpeed="launch_speed", Angle="launch_angle", Direction=pl.col("hc_x") - 125.0, RelSpeed="release_speed",
        PlateLocSide="plate_x", PlateLocHeight="plate_z", BatSpeed="bat_speed",
    )  # fmt: skip


def by_hand() -> pl.DataFrame:
    """Return a table whose headings carry their units; its dates begin with the day."""
    return made_up().select(
        "stand", pl.col("game_date").str.to_date().dt.strftime("%d/%m/%Y").alias("Date"), "home_team", "batter",
        (pl.col("launch_speed") * 1.609344).round(1).alias("Exit Velocity [km/h]"),
        pl.col("launch_angle").alias("Launch Angle (deg)"), pl.col("hc_y").alias("hc_y"), pl.col("hc_x"),
        (pl.col("bat_speed") * 0.44704).round(2).alias("bat_speed_m_s"),
    )  # fmt: skip


DAY_FIRST = pl.col("game_date").str.to_date().dt.strftime("%d/%m/%Y")
TABLES = {
    "Statcast": (made_up(), "game_date"),
    "Trackman": (trackman(), "Date"),
    "plain, with units": (by_hand(), "Date"),
    "days first": (made_up(year=2026).with_columns(game_date=DAY_FIRST), "game_date"),
    "days first, as categories": (
        made_up(year=2026).with_columns(game_date=DAY_FIRST.cast(pl.Categorical)),
        "game_date",
    ),
}


@pytest.mark.parametrize("which", TABLES)
@pytest.mark.parametrize("name", ["table.csv", "table.parquet"])
def test_a_frame_is_understood_as_the_same_table_in_a_file(which: str, name: str, tmp_path: Path) -> None:
    """What a ball is told hangs on its day: the park of that year, the plate's edge that its place is given at."""
    frame, dates = TABLES[which]
    path = tmp_path / name
    frame.write_csv(path) if name.endswith("csv") else frame.write_parquet(path)
    season = analyse_season([path], folder=tmp_path / "out")
    filed = season.balls().collect().drop("table", "table_row")
    for given in (frame, frame.lazy()):
        framed = season_columns(given, setting=season.setting).collect()
        assert_frame_equal(framed, filed.cast({dates: framed.schema[dates]}), check_dtypes=False)
    assert season.survey.days[0] is not None and season.survey.days[0][1].month == date(2024, 8, 1).month


def test_a_frame_that_holds_lists_is_refused_as_a_file_is() -> None:
    nested = made_up().with_columns(launch_speed=pl.concat_list("launch_speed"))
    with pytest.raises(InputError, match="column launch_speed holds List"):
        season_columns(nested, setting=season_setting(contact=False))


@pytest.mark.parametrize("frame", ["table.csv", {"launch_speed": [90.0]}])
def test_what_is_no_polars_frame_is_refused_in_a_line(frame: Any) -> None:
    with pytest.raises(InputError, match="give a polars frame"):
        season_columns(frame, setting=season_setting(contact=False))


def test_a_club_s_feed_needs_no_inference_of_the_place(tmp_path: Path) -> None:
    """Where along the bat a ball was met is what the feed says, within its error, whatever side of the best place."""
    bat = catalog.bat("r161-ash")
    truth = made_season(bat, MadeSeason(players=6, balls=60))
    feed = truth.select(
        Batter=pl.format("Batter, {}", "batter"), Pitcher=pl.format("Pitcher, {}", "pitcher"),
        ExitSpeed="launch_speed", Angle="launch_angle", BatSpeed="bat_speed", BatAttackAngle="attack_angle",
        BatAxialOffset=6.0 - pl.col("true_from_tip_in"), RelSpeed="release_speed", truth="true_from_tip_in",
    )  # fmt: skip
    feed.write_csv(tmp_path / "club.csv")
    answer = season_answer(SeasonQuestion(paths=[tmp_path / "club.csv"]))
    balls = answer.balls().filter(pl.col("contact_outcome") == "ok").collect()
    off = balls["from_tip_in"] - balls["truth"]
    assert len(balls) > 300 and off.abs().median() < 0.35 and off.abs().max() < 2.0  # type: ignore[operator]
    sure = balls.filter((balls["truth"] - balls["best_from_tip_in"]).abs() > 1.0)
    tip_side = sure["truth"] < sure["best_from_tip_in"]
    assert ((sure["tip_side"] > 0.5) == tip_side).mean() > 0.97  # type: ignore[operator]
    assert "the side of the bat that was met" not in str(answer.warnings)
    assert not any("Which side" in words for words in answer.cannot_tell)


def test_who_has_no_number_goes_by_his_name(tmp_path: Path) -> None:
    """And where no park is known, and no event, home runs are missing: nobody was counted to hit none."""
    frame = trackman().select(
        "ExitSpeed", "Angle", Batter=pl.format("Batter, {}", "BatterId"), Pitcher=pl.lit("Pitcher, One")
    )
    frame.write_csv(tmp_path / "table.csv")
    require_batter([tmp_path / "table.csv"], "Batter, 600001")
    answer = season_answer(SeasonQuestion(paths=[tmp_path / "table.csv"], contact=False))
    players = answer.to_frame()
    assert players["batter"].to_list() == [f"Batter, {600_000 + number}" for number in range(6)]
    assert answer.to_frame(key="pitcher").select("pitcher", "balls").rows() == [("Pitcher, One", 60)]
    counted = ["home_runs_expected", "home_runs", "home_runs_average_park", "doubters"]
    assert players.select(counted).null_count().row(0) == (6,) * len(counted)
    page = html.page(player_page(answer.player("Batter, 600001")), US)
    assert "10 balls in play" in page and "Home runs:" not in page
