"""The hit in slow motion without a browser: the answer is the film, whole and short."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sweetspot.web.answers import answer_json
from sweetspot.web.errors import FieldError
from sweetspot.web.views import explorer, hit

BATS = ("r161-ash", "single-wall")


def asked(**controls: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(answer_json("hit", hit.HitFilmState(**controls)))
    return found


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize("bat", BATS)
def test_energies_sum_to_the_incoming_one_at_every_moment(bat: str, held: bool) -> None:
    answer = asked(bat=bat, held=held)
    energy = np.array(list(answer["energy_j"].values()))
    assert energy.sum(axis=0) == pytest.approx(answer["hit"]["incoming_energy_j"], rel=1e-4)
    assert set(answer["energy_j"]) >= {"ball", "stored", "heat", "translation", "rotation", "bending", "damping"}
    assert ("hoop" in answer["energy_j"]) == (bat == "single-wall")


def test_an_answer_is_short() -> None:
    longest = hit.HitFilmState(bat="single-wall", held=True, duration_ms=20)
    assert len(answer_json("hit", longest)) < 200_000
    assert len(asked(duration_ms=20)["film"]["time_s"]) <= 240


def test_modes_add_up_to_the_motion_under_the_hands() -> None:
    # exact but for the places' spacing: the drawing's line against the motion at the hand's own place
    answer = asked(held=True)
    film, hand = answer["film"], answer["hands_m"][0]
    line = np.array(film["motion_sqrt_kg_m"]).T @ np.array(film["shape_per_sqrt_kg"])
    drawn = [np.interp(hand, film["place_m"], moment) for moment in line]
    assert drawn == pytest.approx(answer["top_hand"]["displacement_m"], abs=2e-5)


def test_ball_and_bat_part_where_the_gap_opens() -> None:
    answer = asked()
    times, gap = np.array(answer["film"]["time_s"]), np.array(answer["film"]["gap_m"])
    release = answer["hit"]["release_time_s"]
    assert not gap[times < release].any()
    assert np.all(np.diff(gap[times > release]) > 0)


def test_the_wall_is_dented_under_the_ball_by_as_much_as_is_felt() -> None:
    """What ball and line leave between them is the dent as the ball feels it: less than the wall's own."""
    answer = asked(bat="single-wall")
    film, hoop = answer["film"], answer["hoop"]
    dent = np.sum(hoop["dent_m"], axis=0)
    assert 5e-4 < dent.max() < 5e-3
    assert hoop["harmonics"] == [2, 3, 4]
    place = answer["hit"]["position_m"]
    line = np.array(film["motion_sqrt_kg_m"]).T @ np.array(film["shape_per_sqrt_kg"])
    under = np.array([np.interp(place, film["place_m"], moment) for moment in line])
    pressed = np.array(film["time_s"]) < answer["hit"]["release_time_s"]
    felt = np.array(film["ball_travel_m"]) - np.array(film["compression_m"]) - under
    ratio = felt[pressed].max() / dent[pressed].max()
    assert 0.7 < ratio < 1.0


def test_a_ball_that_is_hit_again_is_told_alike_everywhere(run: Callable[..., tuple[int, str, str]]) -> None:
    # 18 in from the tip of a metal bat: page, commands and report say the same of what nobody has measured
    doubt, first = asked(bat="single-wall", impact_from_tip_in=18.0)["hit"]["touched_again"]["us"]
    assert "hits it again" in doubt and "mph slower" in doubt and first.startswith("By the first touch alone")
    met = explorer.answer(explorer.ExplorerState(bat="single-wall", impact_from_tip_in=18.0))
    assert met.hit.touched_again["us"] == [doubt, first]
    assert asked(bat="single-wall", impact_from_tip_in=6.0)["hit"]["touched_again"]["us"] == []
    measured = doubt[: doubt.index("; had it")].removeprefix("The ")

    def said(*command: str) -> str:
        return " ".join(run(*command)[1].split())

    assert doubt in said("hit", "single-wall", "--at", "18in-from-tip")
    assert measured in said("play", "single-wall", "--at", "18in-from-tip")
    assert f"in from the tip, the {measured}." in said("report", "single-wall")
    assert "hits it again" not in said("report", "r161-ash")


def test_how_it_is_drawn_makes_no_difference() -> None:
    first = asked()
    assert asked(moment_ms=2, exaggeration=9, recoil=False, slowness=200) == first
    assert asked(impact_from_tip_in=5) != first


def test_hands_change_the_handle_and_not_the_ball() -> None:
    """Published: the grip does not matter for the ball [nathan2000]."""
    free, held = asked(), asked(held=True)
    assert held["hit"]["exit_speed_m_s"] == pytest.approx(free["hit"]["exit_speed_m_s"], rel=0.01)
    assert np.abs(held["top_hand"]["velocity_m_s"]).max() < 0.95 * np.abs(free["top_hand"]["velocity_m_s"]).max()


@pytest.mark.parametrize(
    ("controls", "field"), [({"impact_from_tip_in": 30}, "impact_from_tip_in"), ({"bat": "no such bat"}, "bat")]
)
def test_wrong_controls_are_named(controls: dict[str, Any], field: str) -> None:
    with pytest.raises(FieldError) as refused:
        asked(**controls)
    assert refused.value.field == field


@pytest.mark.parametrize("held", [False, True])
def test_the_recipe_gives_the_same_film(held: bool) -> None:
    state = hit.HitFilmState(impact_from_tip_in=4.5, held=held, pitch_speed_mph=80)
    names: dict[str, Any] = {}
    exec(hit.recipe(state)["python"], names)
    answer, scene = hit.answer(state), names["scene"]
    assert answer.film.force == pytest.approx(scene.force, abs=0.05)
    assert answer.energy["bending"] == pytest.approx(scene.energy.bending, abs=1e-3)


def test_the_command_gives_the_same_hit(run_json: Callable[..., dict[str, Any]]) -> None:
    state = hit.HitFilmState(bat="single-wall", impact_from_tip_in=4.5)
    program, *arguments = hit.recipe(state)["command"].split()
    assert program == "sweetspot"
    assert run_json(*arguments)["release_time_s"] == pytest.approx(hit.answer(state).hit.release_time, rel=1e-9)
    assert "command" not in hit.recipe(hit.HitFilmState(held=True))  # it knows no hands that weigh something


def test_how_sure_the_hits_numbers_are() -> None:
    """The hit of the command with its intervals; who holds the bat makes no difference to them."""
    free, held = (hit.sure(hit.HitFilmState(held=held)) for held in (False, True))
    assert free == held
    assert "exit speed" in free.html["us"] and "this ball" in free.html["us"]
    assert "±" in free.html["us"] and "m/s" in free.html["si"]
