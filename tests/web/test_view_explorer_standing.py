"""Where a bat's numbers stand among the catalogue's: counted from the list of bats, and said beside the numbers."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.web.catalogue import STUDIED
from sweetspot.web.controls import HitState
from sweetspot.web.views.explorer_standing import standing
from tests.web.parts import Wait


@pytest.mark.parametrize("name", ["r161-ash", "composite"])
def test_weights_are_counted_among_bats_of_the_sport_that_are_sold(name: str) -> None:
    sold = [key for key in catalog.bat_names() if not key.startswith(STUDIED) and catalog.bat(key).sport == "baseball"]
    others = [rigid_body(beam_model(catalog.bat(key))).mass for key in sold if key != name]
    lighter = sum(mass < rigid_body(beam_model(catalog.bat(name))).mass for mass in others)
    found = standing(HitState(bat=name))
    assert found is not None
    assert found.below["mass"] == f"heavier than {lighter} of {len(others)}"
    assert f"{len(others)} other baseball bats" in found.among


def test_how_it_is_swung_makes_no_difference_and_what_was_done_to_it_does() -> None:
    bat = standing(HitState())
    assert bat is not None
    assert standing(HitState(bat_speed_mph=50, pitch_speed_mph=40)) == bat
    heavier = standing(HitState(mass_oz=36))
    assert heavier is not None
    assert heavier.below["mass"] != bat.below["mass"]


def test_among_few_bats_a_place_says_nothing() -> None:
    assert standing(HitState(bat="fast-pitch")) is None


def test_a_place_stands_below_its_number(page: Page, server: str, settled: Wait) -> None:
    page.goto(f"{server}/explorer")
    settled(page)
    fact = page.locator("#view .facts div", has_text="Weight").first
    expect(fact.locator("small")).to_contain_text("heavier than")
    page.goto(f"{server}/explorer?bat=fast-pitch")
    settled(page)
    expect(fact.locator("small")).to_be_hidden()
