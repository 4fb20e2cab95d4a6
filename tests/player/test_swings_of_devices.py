"""Swing files as devices and coaches write them: what was not measured, units in cells, names, sums below."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.player.model import bats_of
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.swings import batters, read_swings
from sweetspot.tables.headings import GivenColumns
from sweetspot.units import FOOT, INCH, MPH

LENGTH = 33 * INCH


def written(folder: Path, *lines: str) -> Path:
    path = folder / "swings.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def test_a_column_of_zeros_was_not_measured(tmp_path: Path) -> None:
    path = written(tmp_path, "Date,Pitch,Velo,LA,BV", "2026-04-01,62,88,12,0", "2026-04-01,63,91,20,0.0")
    found = read_swings(path, length=LENGTH)
    assert found.system == "HitTrax" and len(found.swings) == 2 and not found.bad_rows
    assert all(one.bat_speed is None for one in found.swings)
    assert "Column BV is 0 in every row: taken as not measured." in found.notes
    mixed = written(tmp_path, "Date,Pitch,Velo,LA,BV", "2026-04-01,62,88,12,0", "2026-04-01,63,91,20,70")
    assert [one.row for one in read_swings(mixed, length=LENGTH).bad_rows] == [2]


def test_cells_are_read_by_their_own_unit(tmp_path: Path) -> None:
    path = written(
        tmp_path, "My cage,,", "Bat Speed,Exit Velocity,Launch Angle", "66.1 mph,140 km/h,28°", "30 m/s,88mph,0.3 rad"
    )
    first, second = read_swings(path, length=LENGTH, pitch_speed=0.0).swings
    assert first.bat_speed == pytest.approx(66.1 * MPH) and first.exit_speed == pytest.approx(140 / 3.6)
    assert first.launch_angle == pytest.approx(math.radians(28))
    assert (second.bat_speed, second.launch_angle) == (30.0, 0.3) and second.exit_speed == pytest.approx(88 * MPH)
    bare = written(tmp_path, "Bat Speed,Exit Velocity", "66.1,88 mph")
    with pytest.raises(InputError, match="column Bat Speed has no unit"):
        read_swings(bare, length=LENGTH, pitch_speed=0.0)
    other = written(tmp_path, "Bat Speed (mph)", "66.1 furlongs", "67")
    assert "'66.1 furlongs', not a number" in read_swings(other, length=LENGTH).bad_rows[0].reason


def test_places_in_cells_count_from_the_end_that_they_name(tmp_path: Path) -> None:
    """Exact: 27 in from the knob of a bat of 33 in are 6 in from its tip."""
    path = written(tmp_path, "bat_speed_mph,exit_speed_mph,Position", "66,88,6in-from-tip", "66,89,27 in from knob")
    found = read_swings(path, length=LENGTH, pitch_speed=0.0).swings
    assert [one.position for one in found] == pytest.approx([6 * INCH, 6 * INCH])


def test_headings_that_a_person_names_may_stand_below_others(tmp_path: Path) -> None:
    path = written(tmp_path, "My cage,,", "Tempo,Schlag", *(f"{95 + row},{130 + row}" for row in range(30)))
    said = GivenColumns({"bat_speed": "Tempo:km/h", "exit_speed": "Schlag:km/h"})
    found = read_swings(path, length=LENGTH, pitch_speed=0.0, given=said)
    assert len(found.swings) == 30 and found.swings[0].bat_speed == pytest.approx(95 / 3.6)


def test_one_batter_however_his_name_is_spelt(tmp_path: Path) -> None:
    path = written(tmp_path, "Player,bat_speed_mph", "Jimmy,66", "jimmy ,67", "JIMMY,65", "Average,66")
    assert batters(path) == ("Jimmy",)
    found = read_swings(path, length=LENGTH, batter="jimmy")
    assert len(found.swings) == 3 and "Row 5 sums the others up and is no swing." in found.notes


@pytest.mark.parametrize(
    ("headings", "system"),
    [("ExitSpeed,Angle,BatSpeed", "Trackman"), ("ExitVelocity,LaunchAngle,bat_speed_mph", "Rapsodo")],
)
def test_systems_name_their_units(tmp_path: Path, headings: str, system: str) -> None:
    found = read_swings(written(tmp_path, headings, "88,20,66"), length=LENGTH, pitch_speed=0.0)
    swing = found.swings[0]
    assert found.system == system and swing.exit_speed == pytest.approx(88 * MPH)
    assert swing.launch_angle == pytest.approx(math.radians(20)) and swing.bat_speed == pytest.approx(66 * MPH)


def test_feet_a_second_and_radians_in_headings(tmp_path: Path) -> None:
    path = written(tmp_path, "exit_speed_fps,launch_angle_radians", "130,0.4")
    swing = read_swings(path, length=LENGTH, pitch_speed=0.0).swings[0]
    assert swing.exit_speed == pytest.approx(130 * FOOT) and swing.launch_angle == 0.4


def test_headings_of_another_language_are_still_columns(tmp_path: Path) -> None:
    path = written(tmp_path, "Schläger;Tempo (km/h)", "a;66,5")
    with pytest.raises(InputError, match=r"The file has: 'Schläger', 'Tempo \(km/h\)'"):
        read_swings(path, length=LENGTH)


def test_a_tee_that_was_none_is_asked_about(tmp_path: Path) -> None:
    """Off a tee 60 mph of bat speed give at most 87 mph; the fastest balls would be left out one by one."""
    rows = [f"60,{speed}" for speed in (70, 75, 80, 92, 93, 94)]
    path = written(tmp_path, "bat_speed_mph,exit_speed_mph", *rows)
    with pytest.raises(InputError, match=r"3 of 6 rows cannot be .* row 5: .* was it a tee\?"):
        read_swings(path, length=LENGTH, pitch_speed=0.0)
    assert len(read_swings(path, length=LENGTH, pitch_speed=70 * MPH).swings) == 6


def test_a_pitch_is_as_fast_as_everywhere_else(tmp_path: Path) -> None:
    path = written(tmp_path, "bat_speed_mph,exit_speed_mph,pitch_speed_mph", "70,100,112", "70,100,130")
    found = read_swings(path, length=LENGTH)
    assert len(found.swings) == 1
    assert "pitch speed is 130.0 mph; usual is 10 to 125 mph" in found.bad_rows[0].reason


def test_bats_by_names_of_ones_own_are_several_bats() -> None:
    swing = PlayerSwing(2, 30.0, None, 0.0, None, None, None, "Louisville C271")
    other = PlayerSwing(3, 30.0, None, 0.0, None, None, None, "Victus Nox 33/30")
    slip = PlayerSwing(4, 30.0, None, 0.0, None, None, None, "r161-asch")
    good, bats, bad, notes = bats_of([swing, other, slip], load=catalog.load_bat, stand_in_for=lambda _: catalog.bat())
    assert good == (swing, other) and set(bats) == {swing.bat, other.bat} and [one.row for one in bad] == [4]
    assert bats[other.bat].name == other.bat and bats[other.bat].length == catalog.bat().length
    assert "'Victus Nox 33/30' for R161, white ash" in notes[0] and "--bat-is" in notes[0]
