"""Swing files: what is understood, refused, listed and said."""

from __future__ import annotations

import csv
import gzip
import math
from datetime import date
from pathlib import Path
from typing import Any

import pytest

from sweetspot.errors import InputError
from sweetspot.flight.pitch.home_plate import PLATE_OVER_RELEASE
from sweetspot.plausibility import insisting
from sweetspot.player.player_swing import PlayerSwing, check_enough, columns_of
from sweetspot.player.swings import SwingFile, evenly, read_swings
from sweetspot.tables.cells import BadRow
from sweetspot.tables.headings import GivenColumns
from sweetspot.tables.vocabulary import simplified
from sweetspot.units import INCH, MPH
from tests.real_data import real_file

LENGTH = 33 * INCH
BLAST = "Date,Equipment,Plane Score,On Plane Efficiency (%),Attack Angle (deg),Bat Speed (mph),Exit Velocity (mph)"


def written(folder: Path, *lines: str, name: str = "swings.csv") -> Path:
    path = folder / name
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def read(path: Path, pitch_speed: float | None = 82 * MPH, **more: Any) -> SwingFile:
    return read_swings(path, length=LENGTH, pitch_speed=pitch_speed, **more)


def test_plain_columns_in_any_order_with_units(tmp_path: Path) -> None:
    """Exact: unit conversions; a position from the knob is turned round."""
    path = written(
        tmp_path, "note,Exit Velocity [km/h],position_in_from_knob,bat_speed_m_s,launch_angle_deg", "x,144,27,31,20.0"
    )
    swing = read(path).swings[0]
    assert swing.exit_speed == pytest.approx(40.0)
    assert swing.bat_speed == 31.0
    assert swing.position == pytest.approx(6 * INCH)
    assert swing.launch_angle == pytest.approx(math.radians(20))
    assert swing.pitch_speed == 82 * MPH
    assert swing.attack_angle is None
    assert read(path).ignored_columns == ("note",)


def test_statcast_knows_its_units_and_slows_the_pitch(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        "launch_angle,game_date,batter,launch_speed,release_speed,bat_speed,attack_angle,bat_speed_x",
        "21,2024-07-25,1.0,101.5,95,72.0,9.5,",
        "21.0,7/26/2024,1,99,95.0,71,,",
        ",2024-07-27,1,,94,,,",
    )
    found = read(path, None)
    assert found.system == "Statcast"
    assert found.swings[0].pitch_speed == pytest.approx(PLATE_OVER_RELEASE * 95 * MPH)
    assert found.swings[0].attack_angle == pytest.approx(math.radians(9.5))
    assert (found.first_day, found.last_day) == (date(2024, 7, 25), date(2024, 7, 27))
    assert found.without_swing == 1  # a pitch without a swing is not a bad row
    assert any("0.920" in note for note in found.notes)


def test_blast_and_hittrax(tmp_path: Path) -> None:
    blast = read(written(tmp_path, "Metrics export", "", BLAST, "2/1/2026,33/30 wood,50,70,8.0,66.1,91"), 0.0)
    assert blast.system == "Blast"
    assert blast.swings[0].bat == "33/30 wood"
    assert blast.swings[0].bat_speed == pytest.approx(66.1 * MPH)
    hittrax = read(written(tmp_path, "#,Date,Pitch,Velo,LA,Dist", "1,02/01/2026,55.0,88.5,14,300"), None)
    assert hittrax.system == "HitTrax"
    assert hittrax.swings[0].pitch_speed == pytest.approx(55 * MPH)
    assert hittrax.swings[0].bat_speed is None


def test_units_missing_are_refused_with_what_to_do(tmp_path: Path) -> None:
    path = written(tmp_path, "bat_speed,exit_speed", "70,95")
    with pytest.raises(InputError, match=r"no unit.*bat_speed_mph.*--file-units us"):
        read(path)
    assert read(path, given=GivenColumns(units="us")).swings[0].bat_speed == pytest.approx(70 * MPH)
    with pytest.raises(InputError, match="unknown unit"):
        read(written(tmp_path, "bat_speed_knots,exit_speed_mph", "70,95"))


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ([""], "is empty"),
        (["bat_speed_mph,exit_speed_mph"], "no row"),
        (["day,mood", "1,good"], "no column for bat speed or exit speed"),
        (["bat_speed_mph,swing_speed_mph", "70,70"], "both give bat_speed"),
        (["bat_speed_mph,exit_speed_mph", "700,95"], "no swing that can be used: row 2: bat speed is 700.0 mph"),
        (["batter,bat_speed_mph", "a,70", "b,70"], "2 batters"),
    ],
)
def test_files_that_cannot_be_used(tmp_path: Path, lines: list[str], message: str) -> None:
    with pytest.raises(InputError, match=message):
        read(written(tmp_path, *lines))


def test_without_pitch_speed_it_says_what_to_give(tmp_path: Path) -> None:
    path = written(tmp_path, "bat_speed_mph,exit_speed_mph", "70,95")
    with pytest.raises(InputError, match="--pitch-speed 82mph"):
        read(path, None)
    assert read(written(tmp_path, "bat_speed_mph", "70"), None).swings[0].pitch_speed is None


def test_impossible_rows_are_listed_and_the_rest_used(tmp_path: Path) -> None:
    rows = [
        "70,95,20",
        "70,300,20",
        "-3,95,20",
        "70,95,120",
        "x,95,20",
        "45,125,0",
        "20,60,5",
        "69,90",
        "72,,",
        "68,85,3",
    ]
    found = read(written(tmp_path, "bat_speed_mph,exit_speed_mph,launch_angle_deg", *rows))
    assert [row.row for row in found.bad_rows] == [3, 4, 5, 6, 7, 8, 9]
    assert [swing.row for swing in found.swings] == [2, 10, 11]
    reasons = {row.row: row.reason for row in found.bad_rows}
    assert "more than any bat gives" in reasons[7]
    assert "a bunt or a checked swing" in reasons[8]
    assert "2 cells under 3" in reasons[9]


def test_what_is_missing_constant_or_few_is_said(tmp_path: Path) -> None:
    rows = [f"70,{speed},," for speed in (90, 95, 91, 88)]
    notes = " ".join(read(written(tmp_path, "bat_speed_mph,exit_speed_mph,launch_angle_deg,note", *rows)).notes)
    assert "Only 4 swings are usable" in notes
    assert "Bat speed is 31.3 m/s (70.0 mph) in every row" in notes
    assert "Launch angle is empty" in notes
    assert "Attack angle is missing" in notes


def test_one_batter_of_several(tmp_path: Path) -> None:
    path = written(tmp_path, "batter,bat_speed_mph", "12.0,70", "15,60", "12,71")
    assert [swing.row for swing in read(path, batter="12").swings] == [2, 4]
    with pytest.raises(InputError, match="15"):
        read(path, batter="16")


def test_a_long_file_is_thinned_evenly_and_says_so() -> None:
    swings = [PlayerSwing(row, 30.0, None, None, None, None, None, "") for row in range(1000)]
    taken, notes = evenly(swings, 400)
    assert len(taken) == 400 and taken[0].row == 0 and taken[-1].row >= 997
    assert "1000 swings are usable; 400" in notes[0]


def test_names_are_simplified_and_systems_recognised() -> None:
    assert simplified(" Bat  Speed (MPH) ") == "bat_speed_mph"
    assert columns_of(["bat_speed", "launch_speed", "launch_angle"], file_name="f").system == "Statcast"


def test_real_statcast_files() -> None:
    """The files as published, 118 columns and 14: every row is used, empty or listed with a reason."""
    game = real_file("savant_2024-07-25_cease_nohitter_full118col.csv.gz")
    with pytest.raises(InputError, match="9 batters"):
        read(game, None)
    found = read(game, None, batter="545121")
    assert len(found.swings) == 10
    assert found.first_day == date(2024, 7, 25)
    table = real_file("cmu36sure2026_battedballs_battracking.csv.gz")
    with gzip.open(table, "rt", encoding="utf-8") as file:
        count = sum(1 for _ in csv.reader(file)) - 1
    many = read(table)
    assert len(many.swings) + len(many.bad_rows) + many.without_swing == count
    assert len(many.bad_rows) < 0.01 * count


def test_fouls_lend_their_bat_speed_and_bunts_nothing(tmp_path: Path) -> None:
    """Newer Statcast exports give fouls an exit speed; taken as hits they would spread the contact point."""
    path = written(
        tmp_path,
        "description,launch_speed,launch_angle,release_speed,bat_speed",
        "hit_into_play,101,20,95,72", "foul,71,60,94,73", "foul_tip,,,94,70", "foul,70,55,94,", "foul_bunt,40,5,90,30",
        "swinging_strike,,,93,71", "ball,,,93,",
    )  # fmt: skip
    found = read(path, None)
    assert [one.exit_speed is not None for one in found.swings] == [True, False, False, False]
    assert [one.foul for one in found.swings] == [False, True, True, False]
    assert found.without_swing == 2 and [one.row for one in found.bad_rows] == [6]
    assert any("2 of 4 swings are fouls" in note for note in found.notes)


ROWS = [(66.4, 88.1), (69.0, 90.2), (64.8, 79.5), (67.2, 85.0), (65.5, 91.3), (66.0, 86.4)]


@pytest.mark.parametrize(
    ("separator", "comma", "encoding"),
    [(",", False, "utf-8"), (";", True, "utf-8"), (";", False, "utf-8-sig"), ("\t", False, "utf-16")],
)
def test_programs_of_every_country(tmp_path: Path, separator: str, comma: bool, encoding: str) -> None:
    """Exact: semicolons with decimal commas, tabs, and what Excel calls Unicode text, are read as the plain file is."""
    lines = [separator.join(("bat_speed_mph", "exit_speed_mph"))]
    lines += [separator.join(f"{value}".replace(".", "," if comma else ".") for value in row) for row in ROWS]
    path = tmp_path / "swings.csv"
    path.write_text("\n".join(lines), encoding=encoding)
    assert [one.bat_speed for one in read(path).swings] == pytest.approx([bat * MPH for bat, _ in ROWS])


def test_a_decimal_comma_between_commas_is_a_bad_row(tmp_path: Path) -> None:
    path = written(tmp_path, "bat_speed_mph,exit_speed_mph", '"66,4",88.1', *(f"{bat},{ball}" for bat, ball in ROWS))
    assert "'66,4', not a number" in read(path).bad_rows[0].reason


@pytest.mark.parametrize(
    ("headings", "rows", "message"),
    [
        ("exit_speed_mph,bat_speed_mph", ROWS, "swapped"),
        ("bat_speed_mph,exit_speed_mph", [(bat * MPH, ball * MPH) for bat, ball in ROWS], "write the unit"),
        ("bat_speed_mph,exit_speed_mph,pitch_speed_mph", [(*row, 0.6) for row in ROWS], "usual is 10 to 125 mph"),
        ("bat_speed_mph,exit_speed_mph,position_in_from_tip", [(*row, 27) for row in ROWS], "from the other end"),
        (
            "Player Name,bat_speed_mph,exit_speed_mph",
            list(zip("aabbcc", *zip(*ROWS, strict=True), strict=True)),
            "3 batters",
        ),
    ],
)
def test_files_that_say_something_else_than_is_meant(
    tmp_path: Path, headings: str, rows: list[tuple[object, ...]], message: str
) -> None:
    with pytest.raises(InputError, match=message):
        read(written(tmp_path, headings, *(",".join(map(str, row)) for row in rows)))


def test_unknown_columns_are_told_with_what_may_be_meant(tmp_path: Path) -> None:
    lines = [f"red,{ball},{bat},{ball}" for bat, ball in ROWS]
    found = read(written(tmp_path, "colour,exit_velocty,bat_speed_mph,exit_speed_mph", *lines))
    note = next(note for note in found.notes if note.startswith("Columns not understood"))
    assert "'colour'" in note and "'exit_velocty' (did you mean exit_velocity_mph?)" in note


def test_too_few_swings_are_refused_unless_somebody_insists(tmp_path: Path) -> None:
    swings = read(written(tmp_path, "bat_speed_mph,exit_speed_mph", "66,88", "67,90", "65,85")).swings
    with pytest.raises(InputError, match="5 are the fewest"):
        check_enough(swings, Path("swings.csv"))
    with pytest.raises(InputError, match=r"used \(1 left out; row 4: no such file\); 5"):
        check_enough(swings, Path("swings.csv"), [BadRow(4, "no such file")])
    with insisting():
        check_enough(swings, Path("swings.csv"))
