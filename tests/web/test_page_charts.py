"""Charts that answer: values at the pointer, zoom by wheel and buttons, a table for each; and what is taken away."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from sweetspot.web.views import VIEWS
from tests.web.parts import Answered, Repainted, Until, Wait

SCROLLED = """new Promise((done) => {
  let last = NaN;
  const look = () => (scrollY === last ? done() : ((last = scrollY), requestAnimationFrame(look)));
  look();
})"""
"""Waits until the page has come to rest."""


def test_the_pointer_reads_values_and_the_wheel_zooms_once_pressed(
    page: Page, server: str, answered: Answered, settled: Wait, until: Until, repainted: Repainted
) -> None:
    page.goto(f"{server}/explorer")
    settled(page)
    page.locator(".chart canvas").scroll_into_view_if_needed()
    box = page.locator(".chart canvas").bounding_box()
    assert box is not None
    x, y = box["x"] + 0.3 * box["width"], box["y"] + 60
    repainted(page, lambda: page.mouse.move(x, y))
    top = page.evaluate("scrollY")
    page.mouse.wheel(0, 40)
    until(page, f"scrollY > {top}")  # nobody has pressed it: the wheel is the page's
    page.evaluate(SCROLLED)
    page.locator(".chart canvas").scroll_into_view_if_needed()
    box = page.locator(".chart canvas").bounding_box()
    assert box is not None
    count = answered(page)
    page.mouse.click(box["x"] + 0.5 * box["width"], box["y"] + 60)
    answered(page, count)
    settled(page)
    where = "document.querySelector('.chart canvas').getBoundingClientRect().top"
    assert page.evaluate(where) == pytest.approx(box["y"], abs=2)  # an answer leaves the page where it was
    top = page.evaluate(where)
    repainted(page, lambda: page.mouse.wheel(0, -300))
    assert page.evaluate(where) == pytest.approx(top, abs=2)
    page.locator(".picture").get_by_role("button", name="Whole bat").click()
    page.locator("summary", has_text="These curves as a table").click()
    rows = page.locator(".chart .numbers tbody tr")
    expect(rows).to_have_count(18)  # filled as it opens, without rows where nothing can be hit
    assert float(re.findall(r"[\d.]+", rows.last.locator("th").inner_text())[0]) == pytest.approx(
        0, abs=0.05
    )  # the tip
    assert float(rows.first.locator("th").inner_text()) == pytest.approx(24.4, abs=0.1)  # where hits begin


def test_fingers_zoom_and_scroll_without_moving_the_ball(
    browser: Browser, server: str, settled: Wait, repainted: Repainted, in_view: Callable[[Page, str, str], Any]
) -> None:
    context = browser.new_context(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    page = context.new_page()
    page.goto(f"{server}/explorer")
    settled(page)
    box = page.locator("#view canvas").first.bounding_box()
    assert box is not None
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
    line = context.new_cdp_session(page)

    def touched(*steps: list[tuple[float, float]]) -> None:
        for kind, places in zip(
            ("touchStart", *["touchMove"] * (len(steps) - 1), "touchEnd"), (*steps, []), strict=True
        ):
            line.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [
                {"x": x + across, "y": y + up, "id": number} for number, (across, up) in enumerate(places)
            ]})  # fmt: skip

    repainted(page, lambda: touched(*([(-apart, 0.0), (apart, 0.0)] for apart in (30.0, 60.0, 90.0))))
    touched(*([(0.0, -15.0 * step)] for step in range(8)))
    settled(page)
    assert page.url == f"{server}/explorer"
    repainted(page, lambda: touched(*([(-8.0 * step, 0.0)] for step in range(8))))
    settled(page)
    assert "impact_from_tip_in" in page.url
    before = page.url
    below = page.locator("#view canvas").nth(1).bounding_box()
    assert below is not None
    apart = below["y"] + 40 - y  # one finger on the bat, the other on the map
    touched([(0.0, 0.0), (20.0, apart)], [(-20.0, 0.0), (40.0, apart)], [(-40.0, 0.0), (60.0, apart)])
    settled(page)
    assert page.url == before
    page.goto(f"{server}/explorer?bore_diameter_in=1&bore_depth_in=6")
    settled(page)
    hole = in_view(
        page,
        "explorer",
        """const { picture } = view, { left, top } = picture.element.getBoundingClientRect();
        const { grips: [{ at, aside }] } = picture.data;
        const { left: knob, scale, middle } = picture.place(picture.surface.width);
        return [left + knob + scale * at, top + middle + scale * aside];""",
    )
    x, y = hole[0] + 5, hole[1] + 5  # a finger beside it holds it too, and the hole does not jump to the finger
    touched(*([(-10.0 * step, 0.0)] for step in range(6)))
    settled(page)
    assert "bore_depth_in=6&" not in page.url and "bore_diameter_in=1&" in f"{page.url}&"
    x -= 50
    touched(*([(0.0, 2.0 * step)] for step in range(6)))
    settled(page)
    assert page.evaluate("scrollY") == 0 and "bore_diameter_in=1&" not in f"{page.url}&"
    context.close()


def test_a_picture_says_what_it_is_when_it_travels_alone(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer?bore_diameter_in=1")
    answered(page)
    page.get_by_role("button", name="Export").click()
    with page.expect_download() as saved:
        page.locator("dialog [data-format=svg]").click()
    words = " ".join(re.findall(r">([^<]+)</text>", saved.value.path().read_text(encoding="utf-8")))
    for part in (
        "hits fastest",
        "R161",
        "hole 1.00 in wide",
        "pitch 90.0 mph",
        "sweetspot 0.",
        "Sources",
        "bore_diameter_in=1",
    ):
        assert part in words, part
    assert re.search(r"20\d\d-\d\d-\d\d", words)


def test_the_guide_speaks_of_the_view_one_is_on(page: Page, server: str) -> None:
    """Three steps of each view's own; that they open, test_page_shell.py shows."""
    page.goto(f"{server}/docs")
    titles = page.evaluate(
        """async (names) => {
          const views = await Promise.all(names.map((name) => import(`/static/views/${name}.js`)));
          return views.map(({ default: view }) => view.guide.map(([title]) => title));
        }""",
        [*VIEWS],
    )
    assert {len(steps) for steps in titles} == {3} and len({steps[0] for steps in titles}) == len(VIEWS)
