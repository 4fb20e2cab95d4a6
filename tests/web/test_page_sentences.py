"""Sentences that the page makes itself say the numbers of the answer, and their directions agree with the signs."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.reports.quantities import US
from sweetspot.units import DEGREE, INCH
from sweetspot.web.views import explorer, flight, hit, modes, optimum, sports
from sweetspot.web.views.flight_state import FlightState

BATS = ("r161-ash", "corked-r161", "composite", "two-piece", "youth-alloy", "slow-pitch", "torpedo")


def shown(value: float, scale: str, digits: int | None = None) -> str:
    return US.shown(value, scale, digits=digits).replace("-", "\N{MINUS SIGN}")


@pytest.mark.parametrize("name", BATS)
def test_explorer_and_hit_say_what_they_show(name: str) -> None:
    found = explorer.answer(explorer.ExplorerState(bat=name, impact_from_tip_in=3.0))
    bat, [fastest, *_, here] = found.bat, found.headline["us"]
    best = shown(float(bat.length) - float(found.sweet_spots.max_exit_speed), "place", 1)
    assert fastest == f"{bat.name} hits fastest {best} from the tip: {shown(float(found.best_exit_speed), 'speed')}."
    assert found.hit.exit_speed is not None
    assert here == f"Here, 3.0 in from the tip: {shown(float(found.hit.exit_speed), 'speed')}."
    pressed = hit.answer(hit.HitFilmState(bat=name))
    contact, arrival = float(pressed.hit.contact_time), pressed.top_hand.arrival
    push, wave, back = pressed.words["us"][:3]
    assert arrival is not None
    assert f"the push is over {1e3 * contact:.2f} ms after first touch" in push
    assert f"reaches the top hand {1e3 * float(arrival):.2f} ms" in wave
    assert back.endswith("too late.") == (2 * float(arrival) > contact)


@pytest.mark.parametrize(
    ("asked", "begins", "holds"),
    [
        ({"exit_speed_mph": 110, "spray_deg": 0}, "Home run: ", "above its top"),
        ({"exit_speed_mph": 105}, "Probably a home run: ", "above its top"),
        ({"exit_speed_mph": 98}, "Probably in play: ", "below its top"),
        ({"exit_speed_mph": 70, "spray_deg": 20}, "In play: ", "from the plate"),
        ({"spray_deg": -58}, "Foul", ""),
        ({"launch_angle_deg": -8, "backspin_rpm": -700, "sidespin_rpm": 400}, "In play: ", "from the plate"),
        ({"bat": "slow-pitch", "ball": "softball-12in", "sidespin_rpm": -400}, "", ""),
    ],
)
def test_flight_says_directions_as_signs_have_them(asked: dict[str, Any], begins: str, holds: str) -> None:
    found = flight.answer(FlightState(**asked))
    assert isinstance(found, flight.FlownBall)
    words, chance, over = " ".join(found.headline["us"]), float(found.chance), found.end.outcome == "home run"
    assert words.startswith(begins) and holds in words
    assert ("above its top" in words) == over
    clearance = float(found.end.clearance or 0.0)
    assert shown(abs(clearance), "distance") in words or "its top" not in words
    unsure = 0.05 < chance < 0.95
    assert unsure == words.startswith(("Probably ", "Perhaps "))
    assert not unsure or words.startswith("Probably ") == (over == (chance > 0.5))
    assert (f"Of a hundred like it {100 * chance:.0f} are home runs." in words) == unsure
    assert f"Out in {found.out_in} of {found.of} park" in words
    launch, [leaves] = found.launch, found.leaves["us"]
    for side, scale, positive, negative in (
        (launch.launch_angle, "angle", "up", "down"),
        (launch.spray, "angle", "to right field", "to left field"),
        (launch.backspin, "spin", "of backspin", "of topspin"),
        (launch.sidespin, "spin", "that bend it left", "that bend it right"),
    ):
        value = float(side)
        word, other = (positive, negative) if value > 0 else (negative, positive)
        assert other not in leaves
        size = shown(abs(value), scale)
        assert (f"{size} {word}" in leaves) == (abs(value) > 0 and size != "0 rpm")
    assert ("to centre field" in leaves) == (abs(float(launch.spray)) < DEGREE / 100)


def test_the_best_launch_is_said() -> None:
    found = optimum.answer(optimum.OptimumState())
    launch = found.launch
    assert found.words["us"] == [
        f"A ball at {shown(float(launch.exit_speed), 'speed')} carries farthest at "
        f"{shown(float(launch.launch_angle), 'angle')}: {shown(float(launch.carry), 'distance')}."
    ]


@pytest.mark.parametrize("name", catalog.implement_names())
def test_every_sport_says_where_its_implement_hits_best(name: str) -> None:
    played = sports.answer(sports.SportsState(implement=name))
    [fastest, here], terms = played.headline["us"], played.words
    best = shown(float(played.tool.length) - float(played.sweet_spots.max_exit_speed), "place", 1)
    assert f"{played.tool.name} hits fastest {best} from the {terms.tip}" in fastest
    speed = float(played.hit.exit_speed)
    assert here.endswith(f": {shown(speed, 'speed') if math.isfinite(speed) else '-'}.")


@pytest.mark.parametrize("name", BATS)
def test_modes_say_where_each_motion_stands_still(name: str) -> None:
    first = modes.answer(modes.ModesState(bat=name))
    for shown_motion in first.modes:
        state = modes.ModesState(bat=name, family=shown_motion.family, number=shown_motion.number)
        found = modes.answer(state)
        motion, words = found.modes[found.chosen], found.words["us"]
        assert (motion.family, motion.number) == (shown_motion.family, shown_motion.number)
        still = sorted((float(found.bat.length) - node) / INCH for node in motion.nodes)
        assert [float(number) for number in re.findall(r"\d+\.\d+", words[1])] == pytest.approx(still, abs=0.006)
        assert still or words[1] == "It stands still nowhere along the bat."
        assert not motion.frequency or shown(float(motion.frequency), "frequency") in words[0]
