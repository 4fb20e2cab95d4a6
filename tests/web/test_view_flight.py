"""The flight's answers: the library's flight and fence, without air the parabola, from a swing the play."""

from __future__ import annotations

import math
import shlex
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.answers.records import to_dict
from sweetspot.catalog.aerodynamic_laws import aerodynamics_in
from sweetspot.flight.fence import fly_all_parks
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.units import FOOT, INCH, MPH
from sweetspot.web.errors import FieldError
from sweetspot.web.views import flight, flight_swing
from sweetspot.web.views.flight import VIEW
from sweetspot.web.views.flight_state import FlightState


def answer(state: FlightState) -> dict[str, Any]:
    return to_dict(flight.answer(state))


def asked(**controls: Any) -> dict[str, Any]:
    return answer(FlightState.model_validate(controls))


def test_without_air_it_is_a_parabola() -> None:
    """R = v cos(a) t with t from height to the ground: exact."""
    found = asked(exit_speed_mph=90, launch_angle_deg=30, spray_deg=0, height_ft=3)
    speed, angle = 90 * MPH, math.radians(30)
    up = speed * math.sin(angle)
    time = (up + math.sqrt(up**2 + 2 * STANDARD_GRAVITY * 3 * FOOT)) / STANDARD_GRAVITY
    assert found["without_air"]["carry_m"] == pytest.approx(2 * FOOT + speed * math.cos(angle) * time, rel=1e-9)
    assert found["flight"]["carry_m"] < found["without_air"]["carry_m"]


def test_high_and_warm_carries_farther() -> None:
    boston, denver = (asked(park=park)["flight"]["carry_m"] for park in ("fenway-park", "coors-field"))
    assert denver > boston + 5
    assert asked(temperature_degf=100)["flight"]["carry_m"] > asked(temperature_degf=40)["flight"]["carry_m"]
    out, into = (asked(wind_speed_mph=10, wind_direction_deg=to)["flight"]["carry_m"] for to in (0, 180))
    assert out > boston > into


def test_the_green_monster_stops_what_clears_other_fences() -> None:
    low = asked(exit_speed_mph=98, launch_angle_deg=21, spray_deg=-25)
    assert low["park"]["name"] == "Fenway Park" and low["end"]["outcome"] == "off the wall"
    assert low["end"]["clearance_m"] < 0 and 0 < low["out_in"] < low["of"] == 30
    assert low["out_in"] == sum(row["outcome"] == "home run" for row in low["parks"])


def test_own_elevation_counts() -> None:
    own, same = (asked(own_elevation=choice, exit_speed_mph=108)["parks"] for choice in (True, False))
    pair = next((a, b) for a, b in zip(own, same, strict=True) if a["park"] == "Coors Field")
    assert pair[0]["clearance_m"] > pair[1]["clearance_m"] + 5


def test_foul_is_foul() -> None:
    assert asked(spray_deg=50)["end"]["outcome"] == "foul"


def test_a_better_met_ball_goes_farther() -> None:
    under, dead = (asked(start="swing", offset_in=offset) for offset in (0.7, 0.0))
    assert under["launch"]["backspin_rad_s"] > 100 > abs(dead["launch"]["backspin_rad_s"])
    assert under["flight"]["carry_m"] > dead["flight"]["carry_m"]
    assert under["swing"]["bat_speed_m_s"] == pytest.approx(70 * MPH)


def test_a_miss_is_said() -> None:
    found = asked(start="swing", offset_in=2.5, impact_from_tip_in=20)
    assert found["missed"] and "flight" not in found


@pytest.mark.parametrize(
    ("controls", "field", "words"),
    [
        ({"park": "Sandlot"}, "park", "not in the catalogue"),
        ({"start": "swing", "tilt_deg": 5}, "tilt_deg", "no path in a plane is steeper than the plane"),
        ({"start": "swing", "impact_from_tip_in": 30}, "impact_from_tip_in", "would meet the hands"),
    ],
)
def test_faults_name_their_control(controls: dict[str, Any], field: str, words: str) -> None:
    with pytest.raises(FieldError, match=words) as caught:
        asked(**controls)
    assert caught.value.field == field


@pytest.mark.parametrize(
    "controls",
    [
        {"wind_speed_mph": 8.0, "wind_direction_deg": -30.0},
        {"direction": "landing", "spray_deg": 12.0, "sidespin_rpm": 900.0, "ball": "softball-12in"},
        {"start": "swing", "offset_in": 0.3, "batter": "left"},
    ],
)
def test_python_lines_give_the_same_numbers(controls: dict[str, Any]) -> None:
    state = FlightState.model_validate(controls)
    assert VIEW.recipe is not None
    lines = VIEW.recipe(state)
    names: dict[str, Any] = {}
    exec(lines["python"], names)
    flown = names["fly"] if "fly" in names else names["play"].flight
    fence = names["fly" if "fly" in names else "play"].fence
    found = answer(state)
    assert flown.carry == pytest.approx(found["flight"]["carry_m"], rel=1e-4)  # the readable solution
    assert fence.outcome == found["end"]["outcome"]
    assert np.isfinite(flown.hang_time)


@pytest.mark.parametrize(
    "controls",
    [{"sidespin_rpm": -300.0}, {"direction": "landing", "sidespin_rpm": 900.0}, {"start": "swing", "offset_in": 0.3}],
)
def test_the_command_line_gives_the_same_numbers(controls: dict[str, Any], run_json: Callable[..., Any]) -> None:
    state = FlightState.model_validate(controls)
    assert VIEW.recipe is not None
    found = run_json(*shlex.split(VIEW.recipe(state)["command"])[1:])
    carry = found["carry_m"] if "carry_m" in found else found["flight"]["carry_m"]
    assert carry == pytest.approx(answer(state)["flight"]["carry_m"], rel=1e-4)


def test_a_direction_without_a_wind_is_no_wind(run_json: Callable[..., Any]) -> None:
    """The arrow may have been turned while no wind blows; the command line refuses a direction without a speed."""
    state = FlightState.model_validate({"wind_direction_deg": 120.0, "sidespin_rpm": -300.0})
    assert VIEW.recipe is not None
    found = run_json(*shlex.split(VIEW.recipe(state)["command"])[1:])
    assert found["carry_m"] == pytest.approx(answer(state)["flight"]["carry_m"], rel=1e-4)


def test_every_park_is_judged_as_by_the_paths() -> None:
    """The compiled fences, followed no further than needed, against paths of 161 points in every park's own air."""
    for controls in ({}, {"exit_speed_mph": 104.0, "spray_deg": 20.0, "wind_speed_mph": 9.0}, {"spray_deg": 50.0}):
        state = FlightState.model_validate(controls)
        start = flight._start(state)
        assert start.motion is not None
        found = answer(state)
        for row, park in zip(found["parks"], catalog.parks(), strict=True):
            there = replace(start.conditions, aerodynamics=aerodynamics_in(park, start.conditions.aerodynamics))
            (end,) = fly_all_parks(start.motion, there, parks=(park,))
            assert row["outcome"] == str(end.outcome.flat[0]), (controls, row["park"])
            clearance = math.nan if row["clearance_m"] is None else row["clearance_m"]  # it never came to the fence
            assert clearance == pytest.approx(float(end.clearance.flat[0]), abs=0.005, nan_ok=True)
        assert 0 <= found["chance"] <= 1
        assert found["expected_out_in"] == pytest.approx(sum(row["chance"] for row in found["parks"]))


@pytest.mark.parametrize("own_elevation", [True, False])
def test_each_park_has_the_carry_and_the_fence_that_its_own_command_says(
    own_elevation: bool, run_json: Callable[..., Any]
) -> None:
    """In thin air, at sea level and under a roof that never opens; alike in the air of the chosen park."""
    ball = {"exit_speed_mph": 101.0, "spray_deg": -12.0, "sidespin_rpm": -900.0, "wind_speed_mph": 6.0}
    chosen = FlightState.model_validate({"park": "fenway", "own_elevation": own_elevation, **ball})
    rows = {row["park"]: row for row in answer(chosen)["parks"]}
    assert VIEW.recipe is not None
    for name in ("coors", "chase", "tropicana", "oracle-park", "fenway"):
        higher = {} if own_elevation else {"elevation_ft": catalog.park("fenway").elevation / FOOT}
        there = FlightState.model_validate({"park": name, **ball, **higher})
        found = run_json(*shlex.split(VIEW.recipe(there)["command"])[1:])
        row = rows[found["fence"]["park"]]
        assert row["carry_m"] == pytest.approx(found["carry_m"], rel=1e-4), name
        assert row["outcome"] == found["fence"]["outcome"], name
        came = name != "coors" or own_elevation  # in Boston's air it falls short of Denver's fence
        assert (row["clearance_m"] is not None) == came, name
        assert row["clearance_m"] == pytest.approx(found["fence"]["clearance_m"], abs=0.01), name
        assert not came or row["fence_m"] == pytest.approx(found["fence"]["distance_m"], abs=0.15), name
    carries = {round(row["carry_m"], 3) for row in rows.values()}
    assert (len(carries) > 20) if own_elevation else (len(carries) == 2)  # in one air: in the open and under the roof


def test_no_slider_of_the_swing_goes_where_no_swing_is() -> None:
    bounds = answer(FlightState.model_validate({"start": "swing", "tilt_deg": 20.0}))["bat"]["bounds"]
    assert (bounds["attack_angle_deg"], bounds["tilt_deg"][0]) == ([-20.0, 20.0], 9.0)
    for ends in ({"attack_angle_deg": 20.0}, {"attack_angle_deg": -20.0}, {"tilt_deg": 9.0}):
        assert not answer(FlightState.model_validate({"start": "swing", "tilt_deg": 20.0, **ends}))["missed"]


@pytest.mark.parametrize("park", ["tropicana", "coors", "fenway"])
def test_the_table_says_of_the_chosen_park_what_the_headline_says(park: str) -> None:
    """Also under a roof that never opens, where the ball flies by the law of still air, and in thin air."""
    for speed, spray in ((104.0, 0.0), (104.0, -10.0), (100.0, 20.0)):
        found = answer(FlightState.model_validate({"park": park, "exit_speed_mph": speed, "spray_deg": spray}))
        (row,) = (one for one in found["parks"] if one["park"] == found["park"]["name"])
        assert row["outcome"] == found["end"]["outcome"]
        assert row["clearance_m"] == pytest.approx(found["end"]["clearance_m"], abs=0.005)


def test_chances_elsewhere_are_those_of_each_park_alone() -> None:
    """To half a point, in the thin air of Denver too; the bound is that of 150 made-up balls."""
    for spray in (-30.0, 0.0, 25.0):
        elsewhere = answer(FlightState.model_validate({"park": "wrigley", "exit_speed_mph": 103.0, "spray_deg": spray}))
        for row in elsewhere["parks"]:
            here = answer(
                FlightState.model_validate({"park": row["park"], "exit_speed_mph": 103.0, "spray_deg": spray})
            )
            assert row["chance"] == pytest.approx(here["chance"], abs=0.005), row["park"]


def test_the_map_holds_the_flight_itself() -> None:
    """Exit speed and launch angle on a point of the map's grid: the same carry."""
    grid = flight.carry_map(FlightState())
    row, column = 11, 14
    speed, angle = grid.exit_speed[column], grid.launch_angle[row]
    found = asked(exit_speed_mph=speed / MPH, launch_angle_deg=math.degrees(angle))
    assert grid.carry[row][column] == pytest.approx(found["flight"]["carry_m"], abs=0.01)


def test_a_direction_may_be_that_of_the_landing() -> None:
    found = asked(direction="landing", spray_deg=10.0, sidespin_rpm=1500.0)
    assert found["flight"]["landing_direction_rad"] == pytest.approx(math.radians(10), abs=1e-5)
    assert found["launch"]["spray_rad"] > math.radians(12)  # the spin bends it back to the left


@pytest.mark.parametrize("start", ["ball", "swing"])
def test_how_sure_a_flight_is(start: str) -> None:
    """A ball with its own numbers has its drag alone; one that was hit has bat and ball too."""
    told = flight.sure(FlightState.model_validate({"start": start})).html["us"]
    assert "carries" in told and "±" in told and "drag of the ball" in told
    assert ("this ball" in told) == (start == "swing")


def test_a_missed_ball_is_not_sure_of_anything() -> None:
    with pytest.raises(FieldError, match="misses"):
        flight.sure(FlightState(start="swing", offset_in=2.5, bat="russell-b1", impact_from_tip_in=20))


def test_the_chosen_park_has_one_chance() -> None:
    """In the headline and among all parks, whose airs are told from a few."""
    found = asked()
    [row] = [row for row in found["parks"] if row["park"] == found["park"]["name"]]
    assert row["chance"] == found["chance"]


def test_a_hit_in_space_is_the_play_s_where_it_happens() -> None:
    """Exact: the barrel rises by the attack angle, the ball lies as far off the bat's axis as asked, both touch."""
    state = FlightState(start="swing", offset_in=0.5, attack_angle_deg=12, tilt_deg=30, impact_from_tip_in=5)
    found, played = flight_swing.space(state), flight.answer(state)
    assert found is not None and isinstance(played, flight.FlownBall)
    axes = np.array([found.forward, found.up, found.tip])
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)
    assert math.asin(found.forward[2]) == pytest.approx(math.radians(12))
    assert math.acos(abs(found.up[2])) == pytest.approx(math.radians(30))  # the plane against the ground
    assert found.tip[2] < 0  # the barrel is below the hands
    off = found.ball - found.axis
    assert off @ found.up == pytest.approx(0.5 * INCH)
    assert off @ found.tip == pytest.approx(0, abs=1e-12)
    bat = catalog.bat("r161-ash")
    place = bat.length - 5 * INCH
    assert float(found.place) == pytest.approx(place)
    assert float(np.linalg.norm(off)) == pytest.approx(float(found.radius) + float(bat.diameter_at(place)) / 2)
    assert np.linalg.norm(found.leaves) == pytest.approx(played.launch.exit_speed)
    assert "rises 12.0° in a plane tilted 30.0°" in found.sentence["us"][0]
    assert "1.3 cm above its axis" in found.sentence["si"][0]
    below = flight_swing.space(state.model_copy(update={"offset_in": -0.5, "attack_angle_deg": -5}))
    assert below is not None
    assert "falls 5.0°" in below.sentence["us"][0]
    assert "0.50 in below its axis" in below.sentence["us"][0]
    assert flight_swing.space(FlightState()) is None  # nobody swings
    assert flight_swing.space(state.model_copy(update={"offset_in": 5.0})) is None
