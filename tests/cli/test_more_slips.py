"""Slips of the kinds that users made, with other options and quantities: one line that says how to mend it."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot import InputError, Wind, batted_ball, standard_flight, trajectory
from sweetspot.flight.trajectory import FlightOutcome

Run = Callable[..., tuple[int, str, str]]

FLIGHT = ("fly", "--exit-speed", "103mph", "--launch-angle", "28deg")
SLIPS = [
    ((*FLIGHT, "--spray", "90deg"), "the spray is 90 deg, and what spin hits usually have is known for -60 to 60 deg"),
    ((*FLIGHT, "--wind-direction", "40deg"), "--wind-direction belongs to a wind; say how fast it blows"),
    ((*FLIGHT, "--wind-speed", "9mph", "--wind-direction", "400deg"), "usual is -360 to 360 deg"),
    (
        (*FLIGHT, "--wind-speed", "9mph", "--wind-direction", "sw"),
        "no direction known here; write for example out, in,",
    ),
    ((*FLIGHT, "--humidity", "50"), "usual is 0 to 1; a ratio from 0 to 1, or a percentage: 50 % is 0.5"),
    (("play", "r161-ash", "--at", "30in-from-tip"), "there the hands are"),
    (("play", "r161-ash", "--attack-angle", "58deg"), "swing path: the plane of the swing"),
    (("pendulum", "--mass", "31oz", "--balance-point", "22cm", "--period", "1.45s"), "as no implement does"),
    (("hit", "r161-ash", "--at", "6in-from-barrel"), "places are written 27in, from the knob end, or 6in-from-tip"),
    (("hit", "r161-ash", "--at", "-3in"), "A negative number is written with =, as in --at=-3in"),
    (("hit", "r161-ash"), "hit needs --at. Where the ball meets the bat: 27in, 6in-from-tip"),
    (("play", "--bats"), "play needs --bats. Side the batter bats from. Choices: right, left."),
    (("parks", "koors"), "Did you mean coors"),
    (("show", "nosuch"), "example aluminium-7xxx, american-family-field"),
    (("report", "nosuch"), "`sweetspot bats` lists all"),
    (("fly", "--exit-speed", "100mph", "--height", "30ft"), "usual is 0 to 11 ft"),
    (("play", "r161-ash", "--height", "30ft"), "usual is 0 to 11 ft"),
    ((*FLIGHT, "--wind-profile", "0.14", "--calm-below", "30ft"), "--wind-profile, --calm-below belong to a wind"),
    ((*FLIGHT, "--cell", "hang-time"), "--cell belongs to a table; give a range"),
    (("play", "--pitch", "curve", "--pitch-backspin", "900rpm"), "--pitch-backspin belongs to a pitch without a name"),
    (("optimum", "--show", "launch", "--bat-speed", "60mph", "--pitch", "CU"), "--pitch, --bat-speed belong to the"),
    (("optimum", "--show", "parks", "--exit-speed", "90mph"), "--exit-speed belongs to the best launch; leave --show"),
    (("optimum", "--show", "swing", "--backspin", "900rpm"), "--backspin belongs to the best launch; leave --show"),
    (("calibrate", "r161-ash", "--tone", "bending-1:0Hz"), "allowed is a frequency of more than 0 Hz"),
]
BASE = 'name = "x"\nlength = "33 in"\nmaterial = "aluminium 7xxx"\nprofile = [["0 in", "1 in"], ["33 in", "2.6 in"]]\n'
FILES = {
    'like = "tennis-racket"\n[strings]\ntension = "24"\n': "write for example 230 N, 24 kg or 52 lb",
    BASE + "[shell]\nwall = 2.8\n": 'wall was given as 2.8: write the unit too, in quotes, as in "2.8 mm"',
    'like = "tennis-racket"\n[strings]\ntension = 55\n': 'as in "55 lb"',
    BASE.replace("length", 'mass = "31 ± 0.1 oz"\nlength'): "write the value alone here",
    BASE.replace("length", 'mass = "3 1 oz"\nlength'): "mass was given as '3 1 oz', which is not a number with a unit",
    BASE.replace('"x"', '""'): "name is empty; write what people call it",
    BASE.replace(
        '["33 in', '["9 in", "2 in"], ["3 in", "2 in"], ["33 in'
    ): "goes back from 0.2286 m (9 in) to 0.0762 m (3 in)",
    BASE + '[cup]\ndiameter = "2.6 in"\ndepth = "1 in"\n': "cup is 0.06604 m (2.6 in) wide and has to be narrower",
    BASE.replace('"aluminium 7xxx"', '{ like = "ash", youngs_modulus = "9 GPa" }'): "known are like, density, long",
    BASE + '[[point_mass]]\nposition = "30 in"\nmass = "-1.5 oz"\n': "mass was given as -1.5 oz; usual is 0 to 8.82 oz",
}


@pytest.mark.parametrize(("arguments", "message"), SLIPS)
def test_a_slip_is_refused_in_one_line(run: Run, arguments: tuple[str, ...], message: str) -> None:
    code, out, err = run(*arguments)
    assert code == 2 and not out and message in err and len(err.strip().splitlines()) == 1, err


@pytest.mark.parametrize(("text", "message"), FILES.items())
def test_a_slip_in_a_file(run: Run, tmp_path: Path, text: str, message: str) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(text)
    code, _, err = run("report", str(file))
    assert code == 2 and message in err and "tuple" not in err, err


def test_a_table_saved_on_windows_is_read(run: Run, tmp_path: Path) -> None:
    """A name with an accent in the code page of Windows; bytes that are no text are refused still."""
    table = tmp_path / "team.csv"
    rows = "bat_speed_mph,exit_speed_mph,pitch_speed_mph,player\n70,90,60,Jos\u00e9\n69,88,60,Ren\u00e9e\n"
    table.write_bytes(rows.encode("cp1252"))
    assert "Jos\u00e9, Ren\u00e9e" in run("fit-player", str(table))[2]
    table.write_bytes(bytes(range(256)) * 4)
    assert "is not a text file" in run("fit-player", str(table))[2]


TABLES = {
    ("outline", "FILE"): ("position_in,diameter_in\n", "has 1 line; allowed are a heading"),
    ("outline ", "FILE"): (
        "position_in,diameter_in\n1.8,0\n1,5\n1,10\n1.8,20\n2.6,30\n2.3,33\n",
        "the columns position_in and diameter_in swapped",
    ),
    ("report", "FILE"): ("position_in,diameter_in\n0,1.7\n", "`sweetspot outline` makes a bat file"),
    ("tap", "FILE"): ("", "cannot be read as a sound: Invalid data found when processing input; record anew"),
    ("season", "FILE"): ("type,launch_speed,launch_angle\nX,25,95\nX,20,101\nX,,12\n", "2 impossible (an exit speed"),
}


@pytest.mark.parametrize(("command", "table"), TABLES.items())
def test_a_table_of_another_kind(run: Run, tmp_path: Path, command: tuple[str, str], table: tuple[str, str]) -> None:
    file, (text, message) = tmp_path / "table.csv", table
    file.write_text(text)
    code, _, err = run(command[0].strip(), str(file))
    assert code == 2 and message in err, err


def test_a_wind_in_words_is_that_of_its_angle(run: Run) -> None:
    """Exact; and answers for programs come by the short word too."""
    carries = [
        json.loads(run(*FLIGHT, "--wind-speed", "9mph", "--wind-direction", to, "--json")[1])["carry_m"]
        for to in ("in-from-lf", "135deg", "0deg")
    ]
    assert carries[0] == carries[1] < carries[2] - 10


def test_no_wind_bends_no_ball(run: Run) -> None:
    pulled = (*FLIGHT, "--spray", "20deg")
    assert "Its spin bends it" in " ".join(run(*pulled)[1].split())
    windy = (*pulled, "--wind-speed", "10mph", "--wind-direction", "0deg")
    assert "Its spin and the wind bend it" in " ".join(run(*windy)[1].split())


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"speed": math.nan}, "speed is not a finite number; leave out"),
        ({"speed": [40.0, math.inf]}, "speed is not a finite number; leave"),
        ({"backspin": math.inf}, "backspin is not a finite number"),
        ({"speed": "100in"}, "speed was given as .100in., which is not a speed"),
        ({"launch_angle": math.nan}, "launch_angle is not a finite number; leave out"),
        ({"position": (0.0, math.nan, 1.0)}, "position is not a finite number; leave"),
    ],
)
def test_what_is_no_number_starts_no_ball(wrong: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        batted_ball(**{"speed": 40.0, "launch_angle": 0.4, **wrong})


@pytest.mark.parametrize("wrong", ["speed", "launch_angle"])
def test_a_row_that_was_not_measured_has_no_flight_and_the_others_do(wrong: str) -> None:
    measured: dict[str, Any] = {"speed": [40.0, 41.0], "launch_angle": [0.4, 0.4]}
    whole = trajectory(batted_ball(**measured), standard_flight())
    found = trajectory(batted_ball(**{**measured, wrong: [math.nan, measured[wrong][1]]}), standard_flight())
    assert found.outcome.tolist() == [FlightOutcome.UNUSABLE, FlightOutcome.LANDED]
    assert math.isnan(found.carry[0]) and found.carry[1] == whole.carry[1]


def test_a_wind_in_degrees_is_refused() -> None:
    with pytest.raises(InputError, match=r"direction: it is 90 rad; angles are in radians: write math.radians\(90\)"):
        Wind(speed=5.0, direction=90)
    assert Wind(speed=5.0, direction=-math.pi).velocity[1] == pytest.approx(-5.0)


def test_a_ball_of_another_sport_is_named(run: Run) -> None:
    code, _, err = run("certify", "r161-ash", "--ball", "tennis")
    assert code == 2 and "a ball of tennis; ncaa tests bats with a ball of baseball. Leave it out" in err
    code, told, err = run("report", "r161-ash", "--ball", "tennis")
    assert code == 0 and "computed all the same" in err and "; hit by: tennis ball, type 2" in " ".join(told.split())


@pytest.mark.parametrize(
    "wrong",
    [
        {"speed": [40.0, 45.0, 30.0], "launch_angle": [0.4, 0.5]},
        {"speed": ["100mph", "90mph"], "spray": [0.1, 0.2, 0.3]},
    ],
)
def test_arrays_that_do_not_fit_are_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(InputError, match="do not fit together"):
        batted_ball(**{"launch_angle": 0.4, **wrong})
