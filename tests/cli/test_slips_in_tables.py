"""Slips in tables that once gave an answer: another unit, another column, another end, a comma; each is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

Run = Callable[..., tuple[int, str, str]]

STATIONS = ((0, 1.8), (0.5, 2), (1.2, 1.0), (9, 0.97), (15, 1.3), (20, 1.8), (25, 2.3), (30, 2.5), (33, 2.3))
OUTLINE = [f"{place},{size}" for place, size in STATIONS]
SWINGS = [f"{66 + row % 4},{88 + row % 5},60" for row in range(10)]
HEAD = "bat_speed_mph,exit_speed_mph,pitch_speed_mph"
RANKED = "name,mass_oz,balance_point_in,pendulum_s,bending_1_hz"
RANK, DRAW = ("rank", "FILE", "--like", "r161-ash"), ("outline", "FILE", "--material", "ash")
FIT, SHOTS = ("fit-player", "FILE"), ("certify", "r161-ash", "--shots", "FILE")


@pytest.mark.parametrize(
    ("command", "head", "rows", "told"),
    [
        (RANK, "name,mass_oz,balance_point_in", ["A,22,31", "B,22,31"], "times that of R161"),
        (RANK, "name,mass_g,balance_point_in", ["A,31,22"], "usual is 2 to 80 oz"),
        (RANK, RANKED, ["A,31,22,14.5,171"], "not of ten"),
        (RANK, RANKED, ["A,31,22,1.45,1710"], "the bending 1 is"),
        (RANK, "name,mass_oz,balance_point_cm", ["A,31,22"], "balance point is 0.393 times"),
        (RANK, "name,mass_oz,balence_point_in", ["A,31,22"], "did you mean balance_point_in"),
        (RANK, RANKED, ['A,"1,031",22,1.45,171'], "thousands without a comma"),
        ((*DRAW, "--length", "33in"), "in_from_tip,diameter_in", OUTLINE, "has its thicker half where"),
        (DRAW, "in_from_knob,circumference_in", OUTLINE, "with circumference_in taken as diameters"),
        (DRAW, "in_from_knob,radius_in", OUTLINE, "with radius_in taken as diameters"),
        (DRAW, "cm_from_knob,diameter_in", OUTLINE, "with cm_from_knob counted in inches"),
        (FIT, f"{HEAD},launch_angle_deg", [f"{row},0.{number}" for number, row in enumerate(SWINGS)], "in radians"),
        (FIT, HEAD, ["66,88,60"] * 10, "is one row copied"),
        (SHOTS, "ball_in_mph,ball_out_mph,position_in_from_tip", ["136,80,6", "136,81,6"], "bats have 0.2 to 0.6"),
        (("fly", "--exit-speed", "1,030mph"), "", [], "write thousands without it"),
        (("report", "r161-ash", "--bat-speed", "70m/s"), "", [], "usual is 0.447 to 49.2 m/s in baseball"),
        (("hit", "r161-ash", "--at", "6in"), "", [], "there the hands are"),
    ],
)
def test_a_slip_in_a_table_is_refused(
    run: Run, tmp_path: Path, command: tuple[str, ...], head: str, rows: list[str], told: str
) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\n".join([head, *rows, ""]), encoding="utf-8")
    code, out, said = run(*(str(file) if word == "FILE" else word for word in command))
    assert (code, out) == (2, ""), out
    assert told in said.strip().splitlines()[-1]


def test_semicolons_and_decimal_commas_of_stations_are_read(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "stations.csv"
    rows = [f"{place};{size}".replace(".", ",") for place, size in STATIONS]
    file.write_text("\n".join(["in_from_knob;diameter_in", *rows]), encoding="utf-8")
    code, out, said = run("outline", str(file), "--material", "ash")
    assert code == 0 and "9 stations: handle 0.97 in, barrel 2.50 in" in " ".join(out.split()), said


@pytest.mark.parametrize(
    ("command", "head", "told"),
    [
        (("fit-player", "FILE"), "bat_sped_mph,exit_sped_mph,pitch_speed_mph", "did you mean exit_speed_mph?"),
        (("season", "FILE"), "exit_sped_mph,launch_angle_deg", "did you mean exit_speed_mph?"),
        (SHOTS, "bal_in_mph,ball_out_mph,position_in_from_tip", "did you mean ball_in_mph?"),
        (("fit-player", "FILE"), f"{HEAD},bat", "(did you mean r161-ash?)"),
    ],
)
def test_a_misspelt_heading_or_bat_is_named(
    run: Run, tmp_path: Path, command: tuple[str, ...], head: str, told: str
) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\n".join([head, *(f"{row},r161-asch" for row in SWINGS)]), encoding="utf-8")
    code, out, said = run(*(str(file) if word == "FILE" else word for word in command))
    assert (code, out) == (2, "") and told in said.strip().splitlines()[-1], said


def test_a_bat_that_nobody_knows_is_taken_for_the_named_one_in_words(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\n".join([f"{HEAD},bat", *(f"{row},r161-asch" for row in SWINGS)]), encoding="utf-8")
    code, out, _ = run("fit-player", str(file), "--bat", "youth-30")
    told = " ".join(out.split())
    first = told.index("The file calls the bat 'r161-asch' (did you mean r161-ash?), which is not known here: it is ")
    assert code == 0 and first < told.index("Questions and answers")
