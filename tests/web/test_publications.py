"""What was published of a bat stands beside its curves with its source, as long as nothing of the bat was changed."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sweetspot.units import INCH
from sweetspot.web.controls import BatState
from sweetspot.web.views.explorer_curves import Publication, published
from tests.web.parts import Answered, choose

LENGTH = 0.84


def of_bat(**controls: Any) -> tuple[Publication, ...]:
    return published(BatState(**controls), length=LENGTH, most_efficient=0.7)


def test_places_and_values_come_with_their_source() -> None:
    marks = {(mark.words["us"].partition(":")[0], mark.curve): mark for mark in of_bat(bat="r161-ash")}
    assert marks[("Cross 1998", "sting_m_s")].place == pytest.approx([LENGTH - 6.5 * INCH] * 2)
    best = marks[("Nathan 2003", "collision_efficiency")]
    assert best.place == pytest.approx([LENGTH - 6 * INCH, LENGTH - 4 * INCH])
    assert best.words["us"].endswith("4.0 in to 6.0 in from the tip") and "American Journal of Physics" in best.source
    greatest = marks[("Nathan 2011", "collision_efficiency")]
    assert greatest.values == pytest.approx([0.202, 0.226]) and greatest.place == (0.7, 0.7)


def test_the_cases_are_read_once_for_a_bat_however_it_is_swung(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another swing has its most efficient place elsewhere; a slider that is dragged must not read every case again."""
    places = [published(BatState(), length=LENGTH, most_efficient=0.65)]
    monkeypatch.setattr("sweetspot.web.views.explorer_curves.sources", lambda: pytest.fail("read again"))
    places.append(published(BatState(), length=LENGTH, most_efficient=0.68))
    assert [{mark.place for mark in marks if mark.values} for marks in places] == [{(0.65, 0.65)}, {(0.68, 0.68)}]


def test_a_changed_bat_is_not_the_one_that_was_measured() -> None:
    assert of_bat(bat="r161-ash", bore_diameter_in=1.0) == ()
    assert of_bat(bat="composite") == ()


def test_the_page_lists_what_its_diamonds_are(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    page.locator("summary", has_text="What was published of this bat").click()
    expect(page.get_by_text("Cross 1998: barrel node of mode 1: 6.5 in from the tip")).to_be_visible()
    page.get_by_role("radio", name="SI", exact=True).check()
    expect(page.get_by_text("Cross 1998: barrel node of mode 1: 16.5 cm from the tip")).to_be_visible()
    choose(page, "composite")
    answered(page, count)
    expect(page.locator("summary", has_text="What was published of this bat")).to_be_hidden()
