"""Best swing's answers: chances are of the chosen park in its own air, and the copied command gives the same swing."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from typing import Any

import numpy as np

from sweetspot.units import FOOT
from sweetspot.web.views.optimum import OptimumState, answer, recipe, swing


def test_chances_are_of_the_chosen_park_in_its_own_air() -> None:
    fenway, coors = (answer(OptimumState(park=park)).map for park in ("fenway-park", "coors-field"))
    np.testing.assert_array_equal(fenway.carry, coors.carry)
    assert np.shape(fenway.chance) == np.shape(fenway.carry)
    assert np.min(fenway.carry[fenway.chance > 0.5]) > 390 * FOOT  # to the centre of Fenway
    # 415 ft in Denver by the map at sea level; in its thin air balls that carry less there are out
    assert np.min(coors.carry[coors.chance > 0.5]) < 415 * FOOT


def test_the_copied_command_finds_the_same_swing(run_json: Callable[..., Any]) -> None:
    state = OptimumState(bat_speed_mph=66, hands_in=5, ball_cor=0.5, ball_humidity=0.7, ball_temperature_degf=40)
    found = run_json(*shlex.split(recipe(state)["command"])[1:])["swings"]
    told = swing(state).html["us"]
    assert f"farthest ({found[0]['carry_m'] / FOOT:.0f}\N{NO-BREAK SPACE}ft)" in told
