"""Slips of units, decimals and scales are refused, by whichever door they come; who insists is believed."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from sweetspot import Swing, all_modes, batted_ball, beam_model, catalog, effective_mass, hits, rigid_body
from sweetspot.collision.coupled import hit
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.plausibility import insisting, parse

Run = Callable[..., tuple[int, str, str]]


@pytest.mark.parametrize("text", ["3,500 m/s", "1,000ft", "12,125 in", "1,5,2 oz", "1.000,5 ft", "1,000,000 ft"])
def test_a_comma_that_may_stand_for_thousands_is_never_misread(text: str) -> None:
    with pytest.raises(InputError, match="decimals after a point"):
        parse(text, "length" if "in" in text or "ft" in text else "mass" if "oz" in text else "speed")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("fly --backspin 2e4rpm", "15000 rpm"),
        ("fly --backspin 2100rad/s", "usual is -1570 to 1570 rad/s"),
        ("fly --temperature -300degF", "usual is -40 to 140 degF"),
        ("fly --wind-speed 500km/h", "usual is 0 to 96.6 km/h"),
        ("report r161-ash --pitch-speed 0.6mph", "for a ball at rest say tee"),
    ],
)
def test_silent_nonsense_is_refused_in_the_units_it_came_in(run: Run, arguments: str, words: str) -> None:
    code, out, err = run(*arguments.split())
    assert code == 2 and not out
    assert words in err and err.count("\n") == 1


def test_who_insists_is_believed(run: Run) -> None:
    code, out, _ = run("fly", "--exit-speed", "300mph", "--force")
    assert code == 0 and "300.0 mph" in out
    with insisting():
        assert parse("300 mph", "speed", "--wind-speed") == pytest.approx(134.112)
    with pytest.raises(InputError, match="--force"):
        parse("300 mph", "speed", "--wind-speed")


def test_inches_and_degrees_in_python_are_told_of(r161: Bat) -> None:
    beam, ball = beam_model(r161), catalog.ball()
    modes, body = all_modes(beam, ball), rigid_body(beam)
    for wrong in (
        lambda: hit(modes, ball=ball, position=27, closing_speed=50.0),
        lambda: hits(modes, ball=ball, position=np.array([0.6, 27.0]), closing_speed=50.0),
        lambda: effective_mass(body, 27.0),
    ):
        with pytest.raises(InputError, match=r"places are in metres, and 27 in are 27 \* 0.0254"):
            wrong()
    with pytest.raises(InputError, match=r"write math.radians\(28\)"):
        batted_ball(speed=44.7, launch_angle=28)
    with pytest.raises(InputError, match="measured_at"):
        Swing(bat_speed=31.0, measured_at=27.0)
    assert math.isfinite(hit(modes, ball=ball, position=0.69, closing_speed=50.0).collision_efficiency)


def test_a_stroke_far_from_its_sports_is_told_of(run: Run) -> None:
    for words in (("--bat-speed", "30m/s"), ("--pitch-speed", "tee"), ("--bat-speed", "66m/s", "--force")):
        assert "warning" not in run("hit", "r161-ash", "--at", "6in-from-tip", *words)[2]
    code, out, said = run("hit", "r161-ash", "--at", "6in-from-tip", "--bat-speed", "66m/s")
    assert code == 2 and not out and "usual is 0.447 to 49.2 m/s in baseball" in said
    for words in (("--bat-speed", "7mph"), ("--pitch-speed", "20mph")):
        code, _, said = run("hit", "r161-ash", "--at", "6in-from-tip", *words)
        assert code == 0 and f"{words[0]} was given as {words[1]}" in said


def test_a_hanging_bat_that_no_bat_is_like(run: Run) -> None:
    for words in ("--mass 86g --moi 10100oz*in^2", "--mass 860g --moi 101000oz*in^2"):
        code, _, said = run("pendulum", *words.split(), "--balance-point", "57cm")
        assert code == 2 and "radius of gyration" in said
    assert run("pendulum", "--mass", "860g", "--moi", "10100oz*in^2", "--balance-point", "57cm")[0] == 0
