"""Python and the command line ask the same: the same numbers, to the last digit, from the same words."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sweetspot

door: Any = sweetspot
R161 = "r161-ash"
CHOKED = 'like = "r161-ash"\nchoke = "1 in"\n'
ASKED: list[tuple[str, Callable[[], Any]]] = [
    ("report r161-ash --bat-speed 68mph --ball-cor 0.5", lambda: door.report(R161, bat_speed="68mph", ball_cor=0.5)),
    ("report CHOKED", lambda: door.report("choked.toml")),
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
    ("compare r161-ash youth-30 --same-speed", lambda: door.compare(R161, "youth-30", same_speed=True)),
    (
        "compare r161-ash --what-if cork --bore-depth 8in",
        lambda: door.compare_corked(R161, bore_depth="8in"),
    ),
    ("certify r161-ash --league mlb", lambda: door.certify(R161, league="mlb")),
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
    (
        "paper r161-ash --entry-angle 20deg --fill rubber",
        lambda: door.paper(R161, entry_angle="20deg", fill="rubber"),
    ),
]


@pytest.mark.parametrize(("words", "ask"), ASKED, ids=[words for words, _ in ASKED])
def test_python_answers_as_the_command(
    words: str, ask: Callable[[], Any], run_json: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("choked.toml").write_text(CHOKED, encoding="utf-8")
    printed = run_json(*words.replace("CHOKED", "choked.toml").split())
    answered = json.loads(json.dumps(ask().to_dict()))
    assert {key: printed[key] for key in answered} == answered
    assert set(printed) - set(answered) <= {"verdict"}  # in words


def test_every_question_is_tried() -> None:
    asked = {words.split()[0] for words, _ in ASKED}
    assert asked == {"report", "hit", "play", "fly", "compare", "certify", "optimum", "drop", "pendulum", "paper"}
