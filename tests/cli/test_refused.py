"""What nobody can mean, or slipped from a pen, is refused in one line that says how to mend it."""

from __future__ import annotations

import shlex
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

Run = Callable[..., tuple[int, str, str]]

REFUSED = tomllib.loads(Path(__file__).with_name("refused.toml").read_text(encoding="utf-8"))
CASES = [(words, message) for command in REFUSED.values() for words, message in command.items()]
PROFILE = '["0 in", "2.0 in"], ["1 in", "1.05 in"], ["12 in", "1.05 in"], ["26 in", "2.5 in"], ["33 in", "2.4 in"]'
REVERSED = '["0 in", "2.5 in"], ["7 in", "2.6 in"], ["21 in", "1.05 in"], ["32.3 in", "1.0 in"], ["33 in", "1.9 in"]'
RADII = '["0 in", "1.0 in"], ["1 in", "0.52 in"], ["12 in", "0.52 in"], ["26 in", "1.25 in"], ["33 in", "1.2 in"]'
SOLID = f"""name = "own bat"
length = "33 in"
mass = "31 oz"
material = "white ash"
profile = [{PROFILE}]
[[bore]]
diameter = "1 in"
depth = "8 in"
fill = "cork"
[cup]
diameter = "1.4 in"
depth = "0.9 in"
"""
PLAIN = SOLID.partition("[[bore]]")[0].replace('mass = "31 oz"\n', "")
HOLLOW = f"""name = "own bat"
length = "33 in"
material = "aluminium-7xxx"
profile = [{PROFILE}]
[shell]
wall = "2.8 mm"
"""
STRUNG = 'like = "tennis-racket"\n[strings]\ntension = "55 lb"\n'
WOOD = 'material = "white ash"'
EDITS = [
    (SOLID, SOLID, "name = ", "is not valid TOML"),
    (PLAIN, PROFILE, REVERSED, "positions count from the knob end"),
    (PLAIN, PROFILE, RADII, "diameters, not radii"),
    (SOLID, '["12 in"', '["27 in"', "profile goes back from 0.6858 m (27 in) to 0.6604 m (26 in)"),
    (SOLID, '"2.5 in"', '"25 in"', "allowed is 5 to 120 mm"),
    (SOLID, '"2.5 in"', '"-2.5 in"', "allowed is 5 to 120 mm"),
    (SOLID, '"33 in"\nm', '"33 ft"\nm', "length was given as 33 ft"),
    (SOLID, '"31 oz"', '"-31 oz"', "mass was given as -31 oz"),
    (SOLID, '"31 oz"', '"31"', "mass was given as 31 without a unit"),
    (SOLID, '"31 oz"', "31", 'mass was given as 31: write the unit too, in quotes, as in "31 oz"'),
    (SOLID, '"31 oz"', '"31 in"', "is not a mass"),
    (SOLID, '"31 oz"', '"nan oz"', "finite number"),
    (SOLID, '"31 oz"', '"31 ± 0.1 oz"', "write the value alone here"),
    (SOLID, '"31 oz"', '"3 1 oz"', "mass was given as '3 1 oz', which is not a number with a unit"),
    (SOLID, '"31 oz"', '"12 oz"', "only at a density of"),
    (SOLID, "length", 'balance_point = "15 in"\nlength', "Check the profile or the measurement"),
    (SOLID, "length", 'balence_point = "22 in"\nlength', "did you mean 'balance_point'"),
    (SOLID, "length", 'colour = "red"\nlength', "known are kind, name"),
    (SOLID, 'name = "own bat"', "", "name is missing"),
    (SOLID, '"own bat"', '""', "name is empty; write what people call it"),
    (SOLID, "name", 'sport = "tennis"\nname', "played with a racket, not with a bat"),
    (SOLID, '"1 in"\nd', '"3 in"\nd', "make it narrower or shallower"),
    (SOLID, '"cork"', '"corck"', "Did you mean cork"),
    (SOLID, '"0.9 in"', '"9 in"', "deeper holes are a [[bore]]"),
    (SOLID, '"1.4 in"', '"2.6 in"', "cup is 0.06604 m (2.6 in) wide and has to be narrower"),
    (SOLID, '"white ash"', '"wite ash"', "Did you mean white-ash"),
    (SOLID, WOOD, 'material = { str = "ash" }', "unknown key 'str'"),
    (SOLID, WOOD, 'material = { density = "600 kg/m^3" }', 'like is missing: write like = "..."'),
    (SOLID, WOOD, 'material = { like = "ash", youngs_modulus = "9 GPa" }', "known are like, density, long"),
    (SOLID, "[[bore]]", "linear_density = [1.0]\n[[bore]]", "exactly one of"),
    (SOLID, "[cup]", '[[point_mass]]\nposition = "30 in"\nmass = "-1.5 oz"\n[cup]', "-1.5 oz; usual is 0 to 8.82 oz"),
    (HOLLOW, '"2.8 mm"', '"0.028 in"', "0.711 mm (0.028 in); usual is 0.8 to 20 mm; walls of metal bats are 2 to 5 mm"),
    (HOLLOW, '"2.8 mm"', '"2,800 mm"', "decimals after a point"),
    (HOLLOW, '"2.8 mm"', "2.8", 'wall was given as 2.8: write the unit too, in quotes, as in "2.8 mm"'),
    (STRUNG, '"55 lb"', '"24"', "write for example 230 N, 24 kg or 52 lb"),
    (STRUNG, '"55 lb"', "55", 'as in "55 lb"'),
]
"""A file of an implement, what is changed in it, to what, and what is said of it."""
STATIONS = ((0, 1.8), (0.5, 2), (1.2, 1.0), (9, 0.97), (15, 1.3), (20, 1.8), (25, 2.3), (30, 2.5), (33, 2.3))
OUTLINE = [f"{place},{size}" for place, size in STATIONS]
SWAPPED = ["1.8,0", "1,5", "1,10", "1.8,20", "2.6,30", "2.3,33"]
SWINGS = [f"{66 + row % 4},{88 + row % 5},60,r161-asch" for row in range(10)]
HEAD = "bat_speed_mph,exit_speed_mph,pitch_speed_mph"
RANKED = "name,mass_oz,balance_point_in,pendulum_s,bending_1_hz"
RANK, DRAW = ("rank", "FILE", "--like", "r161-ash"), ("outline", "FILE", "--material", "ash")
FIT, SHOTS = ("fit-player", "FILE"), ("certify", "r161-ash", "--shots", "FILE")
TABLES = [
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
    (DRAW, "position_in,diameter_in", [], "has 1 line; allowed are a heading"),
    (DRAW, "position_in,diameter_in", SWAPPED, "the columns position_in and diameter_in swapped"),
    (FIT, f"{HEAD},bat,launch_angle_deg", [f"{row},0.{number}" for number, row in enumerate(SWINGS)], "in radians"),
    (FIT, HEAD, ["66,88,60"] * 10, "is one row copied"),
    (FIT, "bat_sped_mph,exit_sped_mph,pitch_speed_mph", SWINGS, "did you mean exit_speed_mph?"),
    (FIT, f"{HEAD},bat", SWINGS, "(did you mean r161-ash?)"),
    (("season", "FILE"), "exit_sped_mph,launch_angle_deg", SWINGS, "did you mean exit_speed_mph?"),
    (("season", "FILE"), "type,launch_speed,launch_angle", ["X,25,95", "X,20,101", "X,,12"], "2 impossible (an exit"),
    (SHOTS, "ball_in_mph,ball_out_mph,position_in_from_tip", ["136,80,6", "136,81,6"], "bats have 0.2 to 0.6"),
    (SHOTS, "bal_in_mph,ball_out_mph,position_in_from_tip", SWINGS, "did you mean ball_in_mph?"),
    (("report", "FILE"), "position_in,diameter_in", ["0,1.7"], "`sweetspot outline` makes a bat file"),
    (("tap", "FILE"), "", [], "has no line of headings"),
]


def refused(run: Run, *words: str) -> str:
    """Run a command, demand that it refuses without an answer, and return the last line of what it says."""
    code, out, said = run(*words)
    assert (code, out) == (2, ""), out
    return said.strip().splitlines()[-1]


@pytest.mark.parametrize(("words", "message"), CASES, ids=[words for words, _ in CASES])
def test_one_line_says_what_is_wrong(run: Run, words: str, message: str) -> None:
    code, out, said = run(*shlex.split(words))
    assert (code, out) == (2, "")
    assert said.startswith("sweetspot: ") and message in said and said.count("\n") == 1


@pytest.mark.parametrize(("text", "old", "new", "message"), EDITS, ids=[edit[-1] for edit in EDITS])
def test_one_line_says_what_is_wrong_in_a_bat_file(
    run: Run, tmp_path: Path, text: str, old: str, new: str, message: str
) -> None:
    file = tmp_path / "own.toml"
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")
    code, out, said = run("report", str(file))
    assert (code, out, said.count("\n")) == (2, "", 1)
    assert message in said and (str(file) in said or "own bat" in said)
    assert said.count("was given as") <= 1 and "tuple" not in said


@pytest.mark.parametrize(("command", "head", "rows", "message"), TABLES, ids=[table[-1] for table in TABLES])
def test_one_line_says_what_is_wrong_in_a_table(
    run: Run, tmp_path: Path, command: Sequence[str], head: str, rows: list[str], message: str
) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\n".join([head, *rows, ""]) if head else "", encoding="utf-8")
    assert message in refused(run, *(str(file) if word == "FILE" else word for word in command))


def test_somebody_insists(run: Run) -> None:
    code, text, _ = run("fly", "--exit-speed", "260mph", "--launch-angle", "28deg", "--force")
    assert code == 0 and "260.0 mph" in text


def test_a_table_saved_on_windows_is_read(run: Run, tmp_path: Path) -> None:
    """A name with an accent in the code page of Windows; bytes that are no text are refused still."""
    table = tmp_path / "team.csv"
    table.write_bytes(f"{HEAD},player\n70,90,60,Jos\u00e9\n69,88,60,Ren\u00e9e\n".encode("cp1252"))
    assert "Jos\u00e9, Ren\u00e9e" in run("fit-player", str(table))[2]
    table.write_bytes(bytes(range(256)) * 4)
    assert "is not a text file" in run("fit-player", str(table))[2]


def test_semicolons_and_decimal_commas_of_stations_are_read(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "stations.csv"
    rows = [f"{place};{size}".replace(".", ",") for place, size in STATIONS]
    file.write_text("\n".join(["in_from_knob;diameter_in", *rows]), encoding="utf-8")
    code, out, said = run("outline", str(file), "--material", "ash")
    assert code == 0 and "9 stations: handle 0.97 in, barrel 2.50 in" in " ".join(out.split()), said


def test_a_bat_that_nobody_knows_is_taken_for_the_named_one_in_words(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\n".join([f"{HEAD},bat", *SWINGS]), encoding="utf-8")
    code, out, _ = run("fit-player", str(file), "--bat", "youth-30")
    told = " ".join(out.split())
    first = told.index("The file calls the bat 'r161-asch' (did you mean r161-ash?), which is not known here: it is ")
    assert code == 0 and first < told.index("Questions and answers")


def test_a_ball_of_another_sport_is_named(run: Run) -> None:
    message = "a ball of tennis; ncaa tests bats with a ball of baseball. Leave it out"
    assert message in refused(run, "certify", "r161-ash", "--ball", "tennis")
    code, told, said = run("report", "r161-ash", "--ball", "tennis")
    assert code == 0 and "computed all the same" in said and "; hit by: tennis ball, type 2" in " ".join(told.split())
