"""What nobody has moved is as in the bat's sport: the page's bat is hit as the command line's report hits it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.units import MPH
from sweetspot.web.bats import conditions_of, described, swung
from sweetspot.web.views.compare_state import CompareState
from sweetspot.web.views.explorer import ExplorerState
from sweetspot.web.views.explorer_curves import along
from sweetspot.web.views.optimum import OptimumState
from sweetspot.web.views.optimum import recipe as optimum_recipe
from tests.web.parts import Answered, choose

REPORTS = Path(__file__).parents[1] / "golden" / "answers"
PITCH, BALL = "[data-field=pitch_speed_mph] input[type=number]", "[data-field=ball] select"


@pytest.mark.parametrize("name", catalog.bat_names())
def test_a_bat_of_the_catalogue_hits_best_where_its_report_says(name: str) -> None:
    """Golden: the numbers that `sweetspot report` gave for this bat."""
    told = json.loads((REPORTS / f"report_{name}.json").read_text())
    met = along(ExplorerState(bat=name))
    assert met.spots.max_exit_speed == pytest.approx(told["sweet_spots.max_exit_speed_m"], abs=1e-4)
    assert met.conditions.pitch.speed == pytest.approx(told["conditions.pitch_speed_m_s"])
    assert met.conditions.ball.name == told["conditions.ball"]
    assert float(np.nanmax(met.scan.exit_speed)) == pytest.approx(told["best_hit.exit_speed_m_s"], rel=1e-4)


def test_a_control_that_was_moved_stays_where_it_is() -> None:
    state = swung(OptimumState(bat="slow-pitch", pitch_speed_mph=61.0, ball="baseball"))
    usual = standard_conditions(catalog.bat("slow-pitch"))
    assert (state.pitch_speed_mph, state.ball) == (61.0, "baseball")
    assert state.bat_speed_mph == pytest.approx(usual.swing.bat_speed / MPH)
    assert state.pitch == catalog.sport("slow-pitch").pitches[0]
    moved = conditions_of(state, described(state))
    assert moved.pitch.speed == pytest.approx(61 * MPH) and moved.ball == catalog.ball("baseball")


def test_other_questions_follow_the_sport_too() -> None:
    other = swung(CompareState(bat="youth-alloy"))
    assert (other.swing_law, other.league) == ("baseball", "usabat")
    assert "--pitch little-league-fastball" in optimum_recipe(OptimumState(bat="youth-30"))["command"]


def test_choosing_a_bat_brings_its_sport_s_ball_and_pitch(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    expect(page.locator(PITCH)).to_have_value("90")
    choose(page, "youth-alloy")
    expect(page.locator(PITCH)).to_have_value("50")
    choose(page, "slow-pitch")
    expect(page.locator(BALL)).to_have_value(catalog.sport("slow-pitch").balls[0])
    assert "pitch_speed_mph" not in page.url and "ball=" not in page.url
    page.locator(PITCH).fill("40")
    page.locator(PITCH).press("Enter")
    expect(page).to_have_url(re.compile("pitch_speed_mph=40"))
    choose(page, "r161-ash")
    expect(page.locator(BALL)).to_have_value("baseball")
    expect(page.locator(PITCH)).to_have_value("40")  # moved by hand: it stays
    page.locator("#undo").click()
    expect(page.locator(BALL)).to_have_value(catalog.sport("slow-pitch").balls[0])
    page.get_by_role("button", name="As usual with this bat").click()
    expect(page.locator(PITCH)).not_to_have_value("40")
    assert "pitch_speed_mph" not in page.url
