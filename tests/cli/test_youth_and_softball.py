"""Youth baseball and softball from the pitch to the fence: their balls, distances, fences and rules."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.catalog.ballparks import field_names
from sweetspot.catalog.deliveries import delivery_sport, other_delivery_names
from sweetspot.flight.pitch import PLATE
from sweetspot.units import FOOT, MPH, OUNCE

SMALL_FIELDS = ("youth-baseball", "softball", "slow-pitch")
Run = Callable[..., tuple[int, str, str]]


def test_balls_of_eleven_and_twelve_inches() -> None:
    """Exact: the balls' names are their circumferences; the smaller one is lighter."""
    eleven, twelve = catalog.ball("softball-11in"), catalog.ball("softball-12in")
    assert eleven.radius / twelve.radius == pytest.approx(11 / 12)
    assert 5.8 * OUNCE < eleven.mass < twelve.mass < 7.1 * OUNCE
    assert catalog.ball("youth-soft").stiffness < catalog.ball("baseball").stiffness


@pytest.mark.parametrize(
    ("name", "distance"), [("little-league-fastball", 46), ("fast-pitch", 43), ("slow-pitch", 50), ("FF", 60.5)]
)
def test_pitches_come_from_their_own_rubber(name: str, distance: float) -> None:
    delivery = catalog.delivery(name)
    assert delivery.motion.position[1] == pytest.approx(distance * FOOT - delivery.extension)
    assert delivery.extension < delivery.distance - PLATE


def test_every_sport_s_pitches_balls_and_fields_are_in_the_catalogue() -> None:
    for sport in map(catalog.sport, catalog.sport_names()):
        for pitch in sport.pitches:
            assert delivery_sport(pitch) == sport.key
        assert set(sport.fields) <= set(field_names())
        assert all(catalog.ball(ball).mass > 0 for ball in sport.balls)
    assert {pitch for name in SMALL_FIELDS for pitch in catalog.sport(name).pitches} == set(other_delivery_names())


def test_a_field_s_fence_goes_through_its_three_distances() -> None:
    """Exact: an arc through poles and centre; with equal distances a circle about the plate."""
    field = catalog.park("intermediate")
    assert field.distance_at(0.0) == pytest.approx(275 * FOOT)
    assert field.fence[0][1] == pytest.approx(200 * FOOT) == field.fence[-1][1]
    assert {round(far / FOOT, 6) for _, far, _ in catalog.park("Little League").fence} == {200.0}


@pytest.mark.parametrize("command", [("play", "fast-pitch"), ("hit", "fast-pitch", "--at", "6in-from-tip")])
def test_what_is_assumed_of_a_softball_is_named(run: Run, command: tuple[str, ...]) -> None:
    words = " ".join(run(*command)[1].split())
    assert "Assumed, not measured: of the ball, loss of restitution with speed and stiffness." in words


def test_a_child_s_hit_over_the_fence(run: Run, run_json: Callable[..., Any]) -> None:
    given = ("play", "youth-30", "--pitch", "little-league-fastball", "--bat-speed", "60mph", "--park", "little-league")
    played = run_json(*given)
    assert 50 < played["pitch_speed_m_s"] / MPH < 53
    assert played["flight"]["carry_m"] > 200 * FOOT
    code, text, _ = run(*given)
    assert code == 0 and "At Little League field" in text


def test_optimum_throws_what_is_thrown_there(run: Run) -> None:
    code, text, _ = run("optimum", "youth-30", "--show", "swing", "--at", "5in-from-tip", "--attack-angle", "15deg")
    assert code == 0
    assert "Little League fastball" in text and "Little League changeup" in text and "four-seam" not in text


@pytest.mark.parametrize(
    ("bat", "thrown", "others"),
    [
        ("slow-pitch", ("slow pitch",), ("windmill", "four-seam")),
        ("youth-alloy", ("Little League fastball",), ("slow pitch", "four-seam")),
        ("r161-ash", ("four-seam fastball", "curve"), ("slow pitch", "Little League")),
    ],
)
def test_optimum_begins_with_what_its_bat_meets(
    run: Run, bat: str, thrown: tuple[str, ...], others: tuple[str, ...]
) -> None:
    _, text, _ = run("optimum", bat, "--show", "swing", "--at", "6in-from-tip", "--attack-angle", "10deg")
    assert all(name in text for name in thrown) and not any(name in text for name in others)


def test_a_slow_pitch_swing_leaves_the_ball_below_its_test_s_limit(run_json: Callable[..., Any]) -> None:
    """Published: men of slow pitch swing at 85 mph against 25 mph, and 98 mph is the limit of that test [asa_limit]."""
    best = run_json("report", "slow-pitch")
    assert best["conditions"]["pitch_speed_m_s"] == pytest.approx(25 * MPH)
    assert 80 < best["best_hit"]["exit_speed_m_s"] / MPH < 98


@pytest.mark.parametrize(
    ("given", "usual"),
    [
        (("fly", "--exit-speed", "100m/s"), "0.447 to 58.1 m/s in baseball"),
        (("fly", "--ball", "table-tennis", "--exit-speed", "60m/s"), "0.3 to 40 m/s"),
        (("fly", "--ball", "tennis", "--exit-speed", "20m/s:120m/s:3"), "1 to 80 m/s"),
        (("optimum", "youth-30", "--show", "launch", "--exit-speed", "140mph"), "1 to 130 mph"),
    ],
)
def test_each_sport_has_its_own_exit_speeds(run: Run, given: tuple[str, ...], usual: str) -> None:
    code, _, error = run(*given)
    assert code == 2 and usual in error and error.count("\n") == 1
    assert run(*given, "--force")[0] == 0


def test_rules_are_those_of_the_bat_s_sport(run: Run) -> None:
    code, text, _ = run("certify", "youth-30")
    assert code == 0 and "Rules of USABat" in text and "NCAA" not in text
    assert catalog.sport("softball").rules == "softball"


def test_parks_list_the_fields(run: Run) -> None:
    code, text, _ = run("parks")
    assert code == 0 and "Fields of other leagues" in text and "slow-pitch" in text
    assert "11 to 11" not in text and "8 to 8" not in text
