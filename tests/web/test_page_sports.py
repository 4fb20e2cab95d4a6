"""A bat of another sport than baseball meets that sport's neighbours and fields on the page, not baseball's."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.web.views.flight import FlownBall, fences
from sweetspot.web.views.flight import answer as flight
from sweetspot.web.views.flight_state import FlightState
from sweetspot.web.views.optimum import OptimumState, recipe
from tests.web.parts import Answered, visit


@pytest.mark.parametrize(
    ("bat", "fields"), [("slow-pitch", 1), ("fast-pitch", 1), ("youth-alloy", 2), ("r161-ash", 30)]
)
def test_balls_fly_over_the_fields_of_the_bats_sport(bat: str, fields: int) -> None:
    own = catalog.sport(catalog.bat(bat).sport).fields
    state = FlightState(bat=bat)
    found = flight(state)
    assert isinstance(found, FlownBall) and found.of == len(found.parks) == len(fences(state).parks) == fields
    assert found.park.name == catalog.park(own[0] if own else "fenway-park").name
    lines = recipe(OptimumState(bat=bat))["command"].split("\n")
    assert [line.split("--park ")[1] for line in lines] == list(own or ("all",))
    chosen = flight(FlightState(bat=bat, park="coors-field"))
    assert chosen.park.name == "Coors Field"  # who chooses gets it


def test_bats_of_the_sport_stand_beside_a_softball_bat(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/compare?bat=slow-pitch")
    answered(page)
    beside = page.get_by_role("group", name="Bat 2", exact=True).locator("select").first
    expect(beside).to_have_value("fast-pitch")
    expect(page.get_by_role("group", name="Bat 3", exact=True)).to_be_hidden()
    page.get_by_role("button", name="Add a bat").click()
    added = page.get_by_role("group", name="Bat 3", exact=True)
    expect(added.locator("select").first).to_have_value("corked-r161")  # softball has no third one
    page.goto(f"{server}/compare?bat=youth-30")
    expect(page.get_by_role("group", name="Bat 2", exact=True).locator("select").first).to_have_value("youth-alloy")


def test_the_best_swing_of_a_softball_bat_has_its_field(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/optimum?bat=fast-pitch")
    answered(page)
    expect(page.locator("[data-field=park] select")).to_have_value("fast-pitch")
    page.goto(f"{server}/optimum?bat=r161-ash")
    expect(page.locator("[data-field=park] select")).to_have_value("fenway-park")
    expect(page.locator("#bench-chip")).to_be_visible()


def test_a_racket_is_named_over_its_view_and_the_bat_over_others(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/sports")
    answered(page)
    expect(page.locator("#bench-chip")).to_have_text(catalog.implement("tennis-racket").name)
    visit(page, "explorer")
    expect(page.locator("#bench-chip")).to_contain_text(catalog.bat("r161-ash").name)
