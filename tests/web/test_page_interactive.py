"""The interactive chart of every view that has curves, and the first visit's guide in the words of the view."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from sweetspot.web.views import VIEWS

Answered = Callable[..., int]
Until = Callable[[Page, str], Any]

CURVES = {"explorer": 6, "hit": 2, "compare": 6, "paper": 2, "flight": 3}
"""Curves of each view's first chart, counted in its panels; two for each of compare's three bats."""


def opened(page: Page, until: Until) -> None:
    page.locator("#export").click()
    page.get_by_role("button", name="Interactive chart").click()
    until(page, "[...document.querySelectorAll('dialog .plot')].some((plot) => plot.data)")


@pytest.mark.parametrize("name", CURVES)
def test_every_view_with_curves_draws_them_again(
    page: Page, server: str, answered: Answered, until: Until, name: str
) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(f"{server}/{name}")
    answered(page)
    assert not any("plotly" in url for url in asked)  # only when asked for
    opened(page, until)
    assert page.evaluate("document.querySelector('.plot').data.length") == CURVES[name]
    offered = page.locator(".plot .modebar-btn").evaluate_all("(found) => found.map((one) => one.dataset.title ?? '')")
    assert offered
    assert not any("cloud" in title.lower() or "share" in title.lower() for title in offered), offered
    assert all(url.startswith((server, "data:", "blob:")) for url in asked)
    page.keyboard.press("Escape")
    expect(page.locator("dialog")).to_have_count(0)
    expect(page.locator("#export")).to_be_focused()


def test_the_curves_are_in_the_readers_units(page: Page, server: str, answered: Answered, until: Until) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    highest = "Math.max(...document.querySelector('.plot').data[0].y.filter((value) => value !== null))"
    opened(page, until)
    us = page.evaluate(highest)
    page.keyboard.press("Escape")
    page.get_by_role("radio", name="SI").check()
    opened(page, until)
    assert us * 0.44704 == pytest.approx(page.evaluate(highest), rel=1e-9)  # mph in m/s: exact by definition


def test_the_picture_is_saved(page: Page, server: str, answered: Answered, until: Until) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    opened(page, until)
    with page.expect_download() as saved:
        page.get_by_role("button", name="Download PNG").click()
    assert saved.value.suggested_filename == "sweetspot-explorer-chart.png"
    assert saved.value.path().read_bytes().startswith(b"\x89PNG")


def test_a_program_that_cannot_be_loaded_is_said(page: Page, server: str, answered: Answered) -> None:
    page.route("**/vendor/*", lambda route: route.fulfill(status=404))
    page.goto(f"{server}/explorer")
    answered(page)
    page.locator("#export").click()
    page.get_by_role("button", name="Interactive chart").click()
    expect(page.locator("dialog [role=status]")).to_contain_text("could not be loaded")


def test_the_guide_speaks_of_the_view_one_is_on(browser: Browser, server: str) -> None:
    titles = set()
    for name in VIEWS:
        context = browser.new_context()
        page = context.new_page()
        page.goto(f"{server}/{name}")
        expect(page.locator("dialog")).to_contain_text("Step 1 of 3")
        titles.add(page.locator("#guide-title").text_content())
        context.close()
    assert len(titles) == len(VIEWS)
