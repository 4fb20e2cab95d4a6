"""Columns of any vintage are understood, others pass through, and a doubt is one clear line."""

from __future__ import annotations

import pytest

from sweetspot.errors import InputError
from sweetspot.season.headings import headings_of, quantities

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
    ],
)
def test_a_doubt_is_one_line_that_names_the_column(names: list[str], words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        headings_of(names, file_name="x.csv")
    assert "\n" not in str(caught.value)


def test_a_person_may_say_what_a_column_is() -> None:
    found = headings_of(["Tempo", "Winkel"], given={"exit_speed": "Tempo:km/h", "launch_angle": "Winkel:deg"})
    assert found.columns["exit_speed"].factor == pytest.approx(1 / 3.6)
    with pytest.raises(InputError, match="no column 'Tempi'"):
        headings_of(["Tempo"], given={"exit_speed": "Tempi"})
    with pytest.raises(InputError, match="exit_sped is no quantity"):
        headings_of(["Tempo"], given={"exit_sped": "Tempo"})


def test_every_quantity_has_a_name_that_people_may_use() -> None:
    for name, entry in quantities().items():
        assert entry["kind"] and ("plain" in entry or "statcast" in entry), name
