"""Files of balls: what is shown can be given back, what is like another differs in what it says and no more."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.catalog.balls import ball_doubts, ball_of_text
from sweetspot.catalog.entries import entry_toml
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH

Run = Callable[..., tuple[int, str, str]]
LBF = 4.4482216152605


@pytest.mark.parametrize("name", catalog.ball_names())
def test_every_ball_is_shown_as_a_file_that_gives_it_back(tmp_path: Path, name: str) -> None:
    """Exact: the same ball, with the same doubts and the same drag."""
    path = tmp_path / "own.toml"
    path.write_text(entry_toml(name, "ball"), encoding="utf-8")
    own, listed = catalog.ball(path), catalog.ball(name)
    assert own == listed and ball_doubts(own) == ball_doubts(listed)
    assert catalog.ball_sport(str(path)) == catalog.ball_sport(name)
    assert catalog.aerodynamics_of_ball(str(path)) == catalog.aerodynamics_of_ball(name)


def test_a_hit_with_a_shown_ball_is_that_of_the_listed_one(run: Run, tmp_path: Path) -> None:
    """Exact, to the last digit, intervals and all."""
    path = tmp_path / "b.toml"
    path.write_text(run("show", "baseball")[1], encoding="utf-8")
    for options in ((), ("--uncertainty",)):
        words = ("hit", "r161-ash", "--at", "6in-from-tip", "--json", *options, "--ball")
        assert json.loads(run(*words, str(path))[1]) == json.loads(run(*words, "baseball")[1])


def _like(name: str, text: str) -> Ball:
    return ball_of_text(f'like = "{name}"\n{text}')


def test_what_a_file_does_not_say_is_its_parent() -> None:
    own, parent = _like("softball-12in", 'name = "mine"\ncor_reference = 0.42\n'), catalog.ball("softball-12in")
    assert own.restitution == parent.restitution.replaced(reference=0.42)
    assert own.name == "mine" and own.sport == "softball"
    assert (own.mass, own.radius, own.exponent) == (parent.mass, parent.radius, parent.exponent)
    assert peak_compression(own, 40.0) == pytest.approx(peak_compression(parent, 40.0), rel=0.01)
    assert own.spread is not None and parent.spread is not None
    assert own.spread.restitution == 0 and own.spread == parent.spread.replaced(restitution=0.0)


def test_an_error_behind_a_value_is_half_of_its_interval() -> None:
    own = _like("baseball", 'mass = "5.1 oz ± 0.02"\ncor_reference = "0.50 +- 0.01"\n')
    sizes = {name: size for doubt in ball_doubts(own) for name, size in doubt.deviation if len(doubt.deviation) == 1}
    assert sizes["mass"] == pytest.approx(0.02 / 5.1 / REACH)
    assert own.spread is not None and own.spread.restitution == 0.01


def test_weather_changes_a_ball_as_its_options_do() -> None:
    own = _like("baseball", 'temperature = "5 degC"\nhumidity = 0.8\nname = "baseball (Major League)"\n')
    assert own == catalog.ball("baseball").conditioned(temperature=5.0, humidity=0.8)


@given(lbf=st.floats(100, 700))
def test_a_softer_ball_is_softer_in_proportion_to_its_compression(lbf: float) -> None:
    """Both plates and wall press it along one law F = k u^n, of which the load between plates tells k alone."""
    own, parent = _like("softball-12in", f'compression = "{lbf} lbf"\n'), catalog.ball("softball-12in")
    assert own.stiffness == pytest.approx(parent.stiffness * lbf / 375)
    assert own.law_ends is not None and parent.law_ends is not None
    for end, before in zip(own.law_ends, parent.law_ends, strict=True):
        assert end.stiffness == pytest.approx(before.stiffness * lbf / 375)


def test_another_test_of_hardness_takes_the_place_of_the_parents() -> None:
    """k of a slow load is F / u^n; the ends of the law grow with the peak force, as k does by its power n + 1."""
    own = _like("baseball", 'load = "264 lbf"\nload_compression = "0.125 in"\n')
    assert own.stiffness == pytest.approx(264 * LBF / 0.003175**1.65)
    parent, harder = catalog.ball("baseball"), _like("baseball", 'peak_force = "45.43 kN"\n')
    assert harder.law_ends is not None and parent.law_ends is not None
    for end, before in zip(harder.law_ends, parent.law_ends, strict=True):
        assert end.stiffness / before.stiffness == pytest.approx(1.1 ** (1.65 + 1))


def test_a_file_may_be_like_another_file_beside_it(tmp_path: Path) -> None:
    (tmp_path / "old.toml").write_text('like = "baseball"\ncor_reference = 0.5\n')
    (tmp_path / "cold.toml").write_text('like = "old.toml"\nname = "cold"\ntemperature = "0 degC"\n')
    cold = catalog.ball(tmp_path / "cold.toml")
    assert cold.restitution.reference == pytest.approx(0.5 - 0.0012 * 21.1)
    with pytest.raises(InputError, match="no file is opened"):
        ball_of_text('like = "old.toml"\n')


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('like = "basebal"\n', "Did you mean baseball"),
        ('like = "baseball"\nmass = "5 kg"\n', "usual is 0.002 to 0.5 kg"),
        ('like = "baseball"\nweight = "5 oz"\n', "unknown key 'weight'"),
        ('like = "baseball"\nmass = 5.1\n', "mass"),
        ('like = "baseball"\nload = "50 N"\n', "load stands without load_compression"),
        ('like = "baseball"\ndiameter = "70 mm"\ncircumference = "9 in"\n', "exactly one of diameter, circumference"),
        ('like = "tennis"\ncompression = "50 lb"\n', "none is known of the ball"),
        ('like = "tennis"\nlaw_low = { rate_share = 0 }\n', "belong together"),
        ('like = "tennis"\nrate_share = 0.3\n', "belong together"),
        ('like = "baseball"\nsport = "base"\n', "sport 'base' is not in the catalogue"),
        ('like = "baseball"\nmass = "5.1 oz ± -0.1"\n', "at least 0"),
        ('like = "baseball"\ntemperature = "70 kg"\n', "temperature"),
        ("like = 3\n", "allowed is the name of a ball"),
        ('name = "x"\n', "mass is missing"),
    ],
)
def test_what_such_a_file_cannot_say(text: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        ball_of_text(text)


def test_files_in_a_ring_are_refused(tmp_path: Path) -> None:
    for one, other in (("a", "b"), ("b", "a")):
        (tmp_path / f"{one}.toml").write_text(f'like = "{other}.toml"\n')
    with pytest.raises(InputError, match="leads back"):
        catalog.ball(tmp_path / "a.toml")
