"""Python and the command line ask the same: the same numbers, to the last digit, from the same words."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.calibration.recording import recording_bytes, synthesised
from sweetspot.calibration.tap_analysis import modes_to_name
from sweetspot.units import INCH
from tests.seasons.conftest import made_up

door: Any = sweetspot
R161 = "r161-ash"
SWINGS = "".join(f"{68 + number % 4},{92 + 3 * (number % 4)},{10 + number}\n" for number in range(8))
FILES = {
    "choked.toml": 'like = "r161-ash"\nchoke = "1 in"\n',
    "swings.csv": f"Bat Speed (mph),Exit Velocity (mph),Launch Angle (deg)\n{SWINGS}",
    "bats.csv": "name,mass_oz,balance_point_in,bending_1_hz\nA,31.00±0.05,22.05±0.05,171.5±0.4\n"
    "B,31.05±0.05,22.05±0.05,165.0±0.4\n",
    "heavier.toml": 'like = "tennis-racket"\nmass = "330 g"\nmoi = "335 kg*cm^2"\n',
    "stations.csv": "position_in,diameter_in\n0,1.7\n1,1\n9,1\n15,1.2\n20,1.7\n25,2.3\n30,2.6\n33,2.4\n",
}
ASKED: list[tuple[str, Callable[[], Any]]] = [
    ("report r161-ash --bat-speed 68mph --ball-cor 0.5", lambda: door.report(R161, bat_speed="68mph", ball_cor=0.5)),
    ("report choked.toml", lambda: door.report("choked.toml")),
    (
        "hit r161-ash --at 5in-from-tip --pitch-speed 85mph±2mph --uncertainty",
        lambda: door.hit(R161, at="5in-from-tip", pitch_speed="85mph±2mph", uncertainty=True),
    ),
    (
        "hit tennis-racket --at 20cm-from-tip --beside 3cm",
        lambda: door.hit("tennis-racket", at="20cm-from-tip", beside="3cm"),
    ),
    (
        "play r161-ash --at 5in-from-tip±0.5in --offset 0.7in --pitch curve --park fenway --wind-speed 8mph "
        "--wind-direction left-to-right --uncertainty",
        lambda: door.play(
            R161,
            at="5in-from-tip±0.5in",
            offset="0.7in",
            pitch="curve",
            park="fenway",
            wind_speed="8mph",
            wind_direction="left-to-right",
            uncertainty=True,
        ),
    ),
    (
        "fly --exit-speed 103mph±1mph --launch-angle 31deg --spray=-22deg --park coors --uncertainty",
        lambda: door.fly(
            exit_speed="103mph±1mph", launch_angle="31deg", spray="-22deg", park="coors", uncertainty=True
        ),
    ),
    (
        "fly --ball tennis --exit-speed 30m/s --launch-angle 8deg --height 1m",
        lambda: door.fly(ball="tennis", exit_speed="30m/s", launch_angle="8deg", height="1m"),
    ),
    (
        "fly --exit-speed 40m/s:45m/s:2 --wind-speed 0m/s:5m/s:2 --launch-angle 28deg --cell hang-time",
        lambda: door.fly_table({"exit_speed": ["40 m/s", "45 m/s"], "wind_speed": [0, "5 m/s"]}, launch_angle="28 deg"),
    ),
    (
        "compare mlb-a --rows mass=0.85kg:0.9kg:2 --columns cup-depth=0cm:2cm:2 --bat-speed 68mph",
        lambda: door.what_if("mlb-a", {"mass": ["0.85 kg", 0.9], "cup_depth": ["0 cm", "2 cm"]}, bat_speed="68 mph"),
    ),
    ("compare r161-ash youth-30 --same-speed", lambda: door.compare(R161, "youth-30", same_speed=True)),
    ("compare r161-ash --what-if cork8in", lambda: door.compare(R161, what_if="cork8in")),
    (
        "compare r161-ash --what-if cup0.9in --add 6g@52cm,6g@12cm",
        lambda: door.compare(R161, what_if=["cup0.9in", "lead 6g@52cm,6g@12cm"]),
    ),
    (
        "design mlb-a --contact 8in --population 8 --generations 2 --want exit-speed",
        lambda: door.design("mlb-a", contact="8in", population=8, generations=2, want=["exit_speed"]),
    ),
    ("certify r161-ash --league mlb", lambda: door.certify(R161, league="mlb")),
    ("certify golf-driver", lambda: door.certify_club("golf-driver")),
    (
        "certify pickleball-paddle --speed 50mph --clamp-inertia 12.15kg*cm^2",
        lambda: door.certify_paddle("pickleball-paddle", speed="50 mph", clamp_inertia="12.15 kg*cm^2"),
    ),
    (
        "optimum --show launch --exit-speed 95mph --backspin 2000rpm",
        lambda: door.optimum(R161, show=["launch"], exit_speed="95mph", backspin="2000rpm"),
    ),
    (
        "optimum --show parks --park fenway --temperature 80degF",
        lambda: door.optimum(R161, show=["parks"], park="fenway", temperature="80degF"),
    ),
    (
        "drop --speed 60mph --material white-ash --thickness 5cm --support clamped",
        lambda: door.drop(speed="60mph", thickness="5cm", support="clamped"),
    ),
    (
        "pendulum --mass 30.5oz --balance-point 22.4in --period 1.38s±0.01s --uncertainty",
        lambda: door.pendulum(mass="30.5oz", balance_point="22.4in", period="1.38s±0.01s", uncertainty=True),
    ),
    ("paper r161-ash --entry-angle 20deg --fill rubber", lambda: door.paper(R161, entry_angle="20deg", fill="rubber")),
    (
        "plan-swings r161-ash mlb-a --within 0.06 --bat-speed 64mph --bat-speed-spread 2mph",
        lambda: door.plan_swings("r161-ash", "mlb-a", within=0.06, bat_speed="64mph", bat_speed_spread="2mph"),
    ),
    (
        "fit-player swings.csv --bat mlb-a --pitch-speed 60mph --goal line --line 250ft",
        lambda: door.fit_player("swings.csv", bat="mlb-a", pitch_speed="60mph", goal="line", line="250ft"),
    ),
    (
        "match tennis-racket heavier.toml",
        lambda: door.match("tennis-racket", "heavier.toml"),
    ),
    ("kit r161-ash --pieces 3", lambda: door.kit(R161, pieces=3)),
    ("rank bats.csv --like r161-ash --bat-speed 68mph", lambda: door.rank("bats.csv", like=R161, bat_speed="68mph")),
    (
        "calibrate r161-ash --mass 31.00oz±0.05oz --balance-point 22.05in±0.05in --tone bending-1:171.5Hz±0.4Hz",
        lambda: door.calibrate(
            R161, mass="31.00oz±0.05oz", balance_point="22.05in±0.05in", tones={"bending-1": door.Measured(171.5, 0.4)}
        ),
    ),
    (
        "calibrate r161-ash --measured bats.csv --row A",
        lambda: door.calibrate(R161, measured="bats.csv", row="A"),
    ),
    ("outline stations.csv --material maple", lambda: door.outline("stations.csv", material="maple")),
    (
        "tap tapped.wav --bat youth-30 --at 1in-from-tip",
        lambda: door.tap("tapped.wav", implement="youth-30", at="1in-from-tip"),
    ),
    ("season balls.csv --try mlb-a", lambda: door.season("balls.csv", others=["mlb-a"])),
]
IN_WORDS = {"verdict", "findings", "answers", "words", "quantity", "comment", "made_with"}
"""What a command adds to an answer or to its rows: sentences, and what made it."""


def one_tap() -> bytes:
    youth = catalog.bat("youth-30")
    place = youth.length - INCH
    return recording_bytes(
        synthesised(modes_to_name(youth), position=place, listened=place, taps=1), Path("tapped.wav")
    )


@pytest.mark.parametrize(("words", "ask"), ASKED, ids=[words for words, _ in ASKED])
def test_python_answers_as_the_command(
    words: str, ask: Callable[[], Any], run: Any, run_json: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", 3)
    for name, text in FILES.items():
        Path(name).write_text(text, encoding="utf-8")
    if "tapped.wav" in words:
        Path("tapped.wav").write_bytes(one_tap())
    if "balls.csv" in words:
        made_up(120).write_csv("balls.csv")
    printed = run_json(*words.split())
    answered = json.loads(json.dumps(ask().to_dict()))
    assert without_words(printed, answered) == answered


def without_words(printed: Any, answered: Any) -> Any:
    """Return what a command printed without the sentences that the answer does not have."""
    if isinstance(printed, dict) and isinstance(answered, dict):
        keys = [key for key in printed if key in answered or key not in IN_WORDS]
        return {key: without_words(printed[key], answered.get(key)) for key in keys}
    if isinstance(printed, list) and isinstance(answered, list) and len(printed) == len(answered):
        return [without_words(*pair) for pair in zip(printed, answered, strict=True)]
    return printed


def test_every_question_is_tried() -> None:
    asked = {words.split()[0].replace("-", "_") for words, _ in ASKED}
    doors = {name: getattr(door, name) for name in door.__all__ if inspect.isfunction(getattr(door, name))}
    assert asked | {"fly_table", "what_if", "certify_paddle", "certify_club"} == {
        name for name, ask in doors.items() if ".ask_" in ask.__wrapped__.__module__
    }
