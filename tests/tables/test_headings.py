"""One reader of headings: systems, units in heading and option, all faults at once, hints that lead somewhere."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from sweetspot.analysis.certification.shots import read_shots
from sweetspot.calibration.bat_table import read_bats
from sweetspot.errors import InputError
from sweetspot.player.player_swing import SWINGS, columns_of
from sweetspot.player.swings import read_swings
from sweetspot.seasons.headings import BALLS, headings_of
from sweetspot.tables.headings import GivenColumns, Headings, maybe_heading, read_headings
from sweetspot.tables.vocabulary import UNITS, UNMEASURED, quantities, quantities_of, systems
from sweetspot.units import DEGREE, FOOT, MPH


def factors(found: Headings) -> dict[str, float]:
    return {name: column.factor for name, column in found.columns.items()}


SPEED_AND_ANGLE = {"exit_speed": MPH, "launch_angle": DEGREE}


@pytest.mark.parametrize(
    ("names", "system", "expected"),
    [
        (["ExitSpeed", "Angle"], "Trackman", SPEED_AND_ANGLE),
        (["EXIT_SPEED", "LAUNCH_ANGLE", "REL_SPEED"], "Trackman", SPEED_AND_ANGLE | {"release_speed": MPH}),
        (["ExitVelocity", "LaunchAngle"], "Rapsodo", SPEED_AND_ANGLE),
        (["Velo", "LA"], "HitTrax", SPEED_AND_ANGLE),
        (["Velo (km/h)", "LA"], "HitTrax", SPEED_AND_ANGLE | {"exit_speed": 1 / 3.6}),
        (["launch_speed", "launch_angle"], "Statcast", SPEED_AND_ANGLE),
        (["exit_velo_mph_x", "blast_bat_speed_mph_x"], "OpenBiomechanics", {"exit_speed": MPH, "bat_speed": MPH}),
        (["Exit Velocity (mph)", "Launch Angle"], "plain", SPEED_AND_ANGLE),
        (["ExitVelo mph", "LA"], "plain", SPEED_AND_ANGLE),
        (["Exit velocity in mph", "Launch angle in degrees"], "plain", SPEED_AND_ANGLE),
        (["exit_speed_fps", "launch_angle_radians"], "plain", {"exit_speed": FOOT, "launch_angle": 1.0}),
        (["hit_speed_ms", "la_deg"], "plain", {"exit_speed": 1.0, "launch_angle": DEGREE}),
    ],
)
def test_swings_and_balls_are_read_by_the_same_headings(
    names: list[str], system: str, expected: dict[str, float]
) -> None:
    for found in (headings_of(names), columns_of(names, file_name="f")):
        assert found.system == system
        assert factors(found) == pytest.approx(expected)


def test_of_two_headings_of_a_system_the_preferred_one_counts() -> None:
    """A sensor's bat speed is that at 6 in from the tip; motion capture's is in the same file."""
    names = ["exit_velo_mph_x", "bat_speed_mph_max_x", "blast_bat_speed_mph_x", "user"]
    found = columns_of(names, file_name="f")
    assert found.columns["bat_speed"].heading == "blast_bat_speed_mph_x" and found.columns["batter"].heading == "user"


def test_a_pitch_s_tilt_on_a_clock_is_no_angle() -> None:
    assert not headings_of(["ExitSpeed", "Angle", "Tilt"]).has("tilt")
    assert headings_of(["exit_speed_mph", "swing_tilt"]).columns["tilt"].unit == "deg"


def test_units_of_a_whole_file() -> None:
    """A system's own headings may be metric too, but for Statcast's; what the heading says goes before."""
    plain, metric = GivenColumns(units="us"), GivenColumns(units="metric")
    assert factors(headings_of(["ev", "la"], given=plain)) == SPEED_AND_ANGLE
    assert headings_of(["EV"], given=metric).columns["exit_speed"].factor == 1.0
    assert headings_of(["ExitSpeed", "Angle"], given=metric).columns["exit_speed"].factor == 1.0
    assert headings_of(["launch_speed"], given=metric).columns["exit_speed"].factor == MPH
    assert headings_of(["Velo (mph)", "LA"], given=metric).columns["exit_speed"].factor == MPH
    assert headings_of(["ev", "distance"], given=plain).columns["distance"].factor == FOOT


def test_a_person_names_columns_of_swings_too() -> None:
    given = GivenColumns({"exit_speed": "Tempo:km/h", "pitch_speed": "Wurf:mph"})
    found = columns_of(["Tempo", "Wurf"], given=given, file_name="f")
    assert factors(found) == pytest.approx({"exit_speed": 1 / 3.6, "plate_speed": MPH})
    with pytest.raises(InputError, match=r"no quantity .* Did you mean .*exit_speed.*; no column 'Wurd'"):
        columns_of(["Tempo"], given=GivenColumns({"exit_spede": "Tempo", "bat_speed": "Wurd"}), file_name="f")


def test_all_faults_of_a_file_are_told_at_once() -> None:
    with pytest.raises(InputError) as caught:
        headings_of(["ev", "bat_speed", "hit_spin_mph", "release_speed_knots"])
    told = str(caught.value)
    for words in ("columns ev and bat_speed have no unit", "--file-units us", "--column exit_speed=ev:mph",
                  "the unit mph, which is no spin", "an unknown unit, knots"):  # fmt: skip
        assert words in told, words


READERS: dict[str, Callable[..., object]] = {
    "swings": partial(read_swings, length=0.84),
    "shots": partial(read_shots, length=0.84),
    "bats": read_bats,
}


@pytest.mark.parametrize(
    ("reader", "text", "faults"),
    [
        ("swings", "bat_speed_kn,exit_speed,pitch_speed_mph\n70,95,85", ["unknown unit, kn", "exit_speed has no unit"]),
        ("swings", "bat_speed_mph,bat speed (km/h),exit_speed\n70,110,95", ["both give bat_speed", "exit_speed has"]),
        ("shots", "ball_in_kn,ball_out\n60,20", ["unknown unit, kn", "no column for position", "ball_out has no unit"]),
        ("bats", "name,mass_oz,weight_g,moi\nA,31,880,11000", ["both give mass", "moi has no unit"]),
        ("bats", "name,mass_oz,balance_point_in\nA,x,22\nB,31,y\nA,31,22", ["line 2, mass", "line 3, bal", "line 4"]),
    ],
)
def test_all_faults_of_other_tables_are_told_at_once(reader: str, text: str, faults: list[str], tmp_path: Path) -> None:
    table = tmp_path / "table.csv"
    table.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        READERS[reader](table)
    assert [words for words in faults if words not in str(caught.value)] == []


def test_what_a_message_says_of_a_missing_column_is_enough(tmp_path: Path) -> None:
    table = tmp_path / "shots.csv"
    table.write_text("ball_in_mph,back,place\n60,20,6", encoding="utf-8")
    given: dict[str, str] = {}
    for name, heading in (("ball_out", "back"), ("position", "place")):
        with pytest.raises(InputError, match=f"--column {name}=HEADING:") as caught:
            read_shots(table, length=0.84, given=GivenColumns(given))
        given[name] = str(caught.value).partition(f"{name}=")[2].partition(".")[0].replace("HEADING", heading)
    assert read_shots(table, length=0.84, given=GivenColumns(given)).shots


@pytest.mark.parametrize("wanted", [SWINGS, BALLS])
def test_no_hint_leads_into_the_next_refusal(wanted: tuple[str, ...]) -> None:
    """Every name misspelt by a letter: what is suggested is read, and has a unit."""
    names = [name for quantity in wanted for name in quantities()[quantity].names if len(name) >= 6]
    hints = [maybe_heading(name[:3] + name[4:], wanted) for name in names]
    suggested = [hint.partition("did you mean ")[2].removesuffix("?)") for hint in hints if "did you mean" in hint]
    assert len(suggested) > len(names) / 2
    for heading in suggested:
        found = read_headings([heading], wanted=wanted)
        assert found.columns and not any(column.has_no_unit for column in found.columns.values()), heading


def test_the_names_fit_together() -> None:
    """Systems give quantities that there are in units that these have, and every quantity has a name somewhere."""
    own = {quantity for system in systems() for quantity, _ in system.columns.values()}
    for name, quantity in quantities().items():
        assert quantity.kind in UNITS and (quantity.names or name in own), name
    for system in systems():
        named = {heading: column for heading, column in system.columns.items() if column[0]}
        assert named, system.name
        for heading, (name, unit) in named.items():
            kind = quantities()[name].kind
            assert (kind in UNMEASURED and not unit) or unit in UNITS[kind], heading
        assert all(marks <= {*system.columns, *OTHER_MARKS} for marks in system.marks), system.name
    assert set(quantities_of("balls", "swings")) <= set(quantities())


OTHER_MARKS = {"plane_score", "on_plane_efficiency", "pitch_call"}
"""Headings that give a system away and are no quantities of its own."""
