"""Slips of the pen that once gave an answer: each is refused in one line, and goes through when somebody insists."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

Run = Callable[..., tuple[int, str, str]]

FLY = ("fly", "--exit-speed", "100mph", "--launch-angle", "28deg")
BAT = """name = "own"
length = "33 in"
material = "white-ash"
profile = [["0 in", "2.0 in"], ["1 in", "1.05 in"], ["12 in", "1.05 in"], ["26 in", "2.5 in"], ["33 in", "2.4 in"]]
"""
REVERSED = """name = "reversed"
length = "33 in"
material = "white-ash"
profile = [["0 in", "2.5 in"], ["7 in", "2.6 in"], ["21 in", "1.05 in"], ["32.3 in", "1.0 in"], ["33 in", "1.9 in"]]
"""
RADII = BAT.replace("2.0 in", "1.0 in").replace("1.05", "0.52").replace("2.5 in", "1.25 in").replace("2.4", "1.2")
CAN = """name = "can"
length = "33 in"
material = "aluminium-7xxx"
profile = [["0 in", "1.9 in"], ["0.7 in", "1 in"], ["12 in", "1.05 in"], ["26 in", "2.6 in"], ["33 in", "2.5 in"]]
[shell]
wall = "WALL"
"""


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((*FLY, "--wind-speed", "3,500m/s"), "decimals after a point"),
        (("drop", "--height", "1,500m"), "decimals after a point"),
        (("fly", "--exit-speed", "85mph-115mph", "--launch-angle", "28deg"), "write one number and its unit"),
        (("fly", "--exit-speed", "1000mph", "--launch-angle", "28deg"), "usual is 1 to 130 mph in baseball"),
        (("fly", "--exit-speed", "0mph", "--launch-angle", "28deg"), "usual is 1 to 130 mph in baseball"),
        (("fly", "--exit-speed", "100mph", "--launch-angle", "90deg"), "90deg straight up"),
        (("fly", "--exit-speed", "100mph", "--launch-angle", "180deg"), "0deg is level"),
        (("fly", "--exit-speed", "100mph", "--launch-angle", "60deg"), "--backspin and --sidespin"),
        ((*FLY, "--spray", "180deg"), "0deg is centre field"),
        ((*FLY, "--backspin", "1e7rpm"), "beyond anything in sport"),
        ((*FLY, "--pressure", "24inHg", "--elevation", "5200ft"), "the elevation is counted on top"),
        ((*FLY, "--pressure", "1013"), "30 inHg"),
        ((*FLY, "--elevation", "5200"), "ft"),
        ((*FLY, "--wind-speed", "500mph"), "500mph; usual is 0 to 60 mph"),
        ((*FLY, "--temperature", "-300degF"), "-300degF; usual"),
        (("pendulum", "--mass", "31oz", "--balance-point", "22in", "--period", "0.725s"), "A period is there and back"),
        (("pendulum", "--mass", "31oz", "--balance-point", "22in", "--period", "14.5s"), "not of ten"),
        (("pendulum", "--mass", "31lb", "--balance-point", "22in", "--period", "1.45s"), "usual is 0.125 to 5 lb"),
        (("compare", "r161-ash", "tennis-racket"), "Compare implements of one sport"),
        (("hit", "tennis-racket", "--at", "60cm-from-tip"), "off the face of Tennis racket"),
        (("hit", "r161-ash", "--at", "5in-from-tip", "--ball-cor", "54"), "usual is 0.2 to 0.9"),
        (("report", "r161-ash", "--bat-speed-at", "40in-from-tip"), "off the bat"),
        (("report", "r161-ash", "youth-30"), "sweetspot compare A B"),
    ],
)
def test_a_slip_is_refused_in_one_line(run: Run, words: Sequence[str], told: str) -> None:
    code, out, said = run(*words)
    assert (code, out) == (2, "")
    assert told in said and said.count("\n") == 1


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (REVERSED, "positions count from the knob end"),
        (RADII, "diameters, not radii"),
        (
            CAN.replace("WALL", "0.028 in"),
            "0.711 mm (0.028 in); usual is 0.8 to 20 mm; walls of metal bats are 2 to 5 mm",
        ),
        (BAT.replace('material = "white-ash"\n', "") + '[material]\nstr = { value = "ash" }\n', "unknown key 'str'"),
        (
            BAT.replace('material = "white-ash"\n', "") + '[material]\ndensity = "600 kg/m^3"\n',
            'like is missing: write like = "..."',
        ),
        (CAN.replace("WALL", "2,800 mm"), "decimals after a point"),
        (BAT + '[cup]\ndiameter = "1.4 in"\ndepth = "9 in"\n', "deeper holes are a [[bore]]"),
        (BAT.replace('"own"', '""'), "name is empty; write what people call it"),
        ('sport = "tennis"\n' + BAT, "played with a racket, not with a bat"),
        (BAT.replace('"33 in"\nmat', '"33 ft"\nmat'), "length was given as 33 ft"),
        (BAT.replace("length", 'mass = "-31 oz"\nlength'), "mass was given as -31 oz"),
        (BAT.replace("length", "mass = 31\nlength"), 'as in "31 oz"'),
        (BAT.replace("length", 'balence_point = "22 in"\nlength'), "did you mean 'balance_point'"),
        (BAT.replace("length", 'colour = "red"\nlength'), "known are kind, name"),
    ],
)
def test_a_slip_in_a_bat_file_is_refused_in_one_line(run: Run, tmp_path: Path, text: str, told: str) -> None:
    file = tmp_path / "own.toml"
    file.write_text(text, encoding="utf-8")
    code, out, said = run("report", str(file))
    assert (code, out) == (2, "")
    assert told in said and said.count("\n") == 1 and said.count("was given as") <= 1


def test_a_field_s_own_pressure_is_taken_at_no_elevation(run: Run) -> None:
    """Denver's barometer reads 24.6 inHg; not reduced to sea level it is meant with no elevation on top."""
    code, text, _ = run(*FLY, "--pressure", "24.6inHg", "--elevation", "0ft")
    assert code == 0 and "carries" in text


def test_somebody_insists(run: Run) -> None:
    code, text, _ = run("fly", "--exit-speed", "260mph", "--launch-angle", "28deg", "--force")
    assert code == 0 and "260.0 mph" in text
