"""Every view, opened once by its address alone: names, keyboard, contrast, tables of its charts, small and large print.

One visit serves all checks, for opening a view costs more than any of them. Those of names, roles, contrast and focus
are after the Web Content Accessibility Guidelines 2.2: names and roles of controls (4.1.2, 1.3.1), contrast of text
(1.4.3: 4.5, or 3 for large text) and of what a control is known by (1.4.11: 3), order and visibility of the focus
(2.4.3, 2.4.7), pictures with words (1.1.1), and reflow (1.4.10).
"""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from sweetspot.web.views import GROUP_OF, VIEWS
from tests.web.parts import Until, Wait
from tests.web.test_page_access import check
from tests.web.test_page_screens import OPEN, OUTSIDE

WITHOUT_CHARTS = ("start", "modes", "own", "season")
"""Views without charts of curves, maps or points at once: the modes stand in a table anyway, a season is read first."""
ADDRESSES = {"hit": "hit?bat=single-wall", "modes": "modes?bat=single-wall&family=hoop"}
"""Of views that show most of a hollow bat; others open as they are."""
ZOOMED = [(640, 450), (320, 225)]
"""CSS pixels of a window of 1280 by 900 at 200 and at 400 %."""
MARKED = """(place) => [...document.querySelectorAll(place)].map((element) => getComputedStyle(element).outlineStyle)"""


@pytest.mark.parametrize("name", VIEWS)
def test_every_view(page: Page, server: str, settled: Wait, narrow: Wait, until: Until, name: str) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    address = f"{server}/{ADDRESSES.get(name, name)}"
    page.goto(address)
    settled(page)
    assert address in asked and from_elsewhere(asked, server) == []
    expect(page).to_have_title(re.compile(re.escape(VIEWS[name].title)))
    here = page.locator(":is(.brand, #views a)[aria-current=page]")
    expect(here).to_have_text(VIEWS[name].title if name in GROUP_OF else "sweetspot")
    expect(page.locator("#fault")).to_be_hidden()
    page.emulate_media(reduced_motion="reduce")
    reached_in_order_and_seen(page)
    if name not in WITHOUT_CHARTS:
        every_curve_and_map_has_a_table(page)
    narrow(page)
    page.set_viewport_size({"width": 1280, "height": 900})
    named_and_seen(page)
    page.emulate_media(forced_colors="active", reduced_motion="reduce")
    bar = ("#groups [aria-current]", "#views [aria-current=page]") if name in GROUP_OF else ()
    for chosen in (*bar, "#tools .switch input:checked + span"):
        assert set(page.evaluate(MARKED, chosen)) == {"solid"}, chosen
    page.evaluate(OPEN)
    for width, height in ZOOMED:
        page.set_viewport_size({"width": width, "height": height})
        until(page, f"innerWidth === {width} && document.documentElement.scrollWidth <= {width}")
        settled(page)
        assert page.evaluate(OUTSIDE) == []


def test_the_description_of_the_api_is_readable_and_works(page: Page, server: str) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(f"{server}/docs")
    page.get_by_role("navigation", name="Contents").get_by_role("link", name="explorer").click()
    section = page.locator("details.card", has=page.get_by_text("POST /api/v1/explorer", exact=True))
    section.locator("summary").first.click()
    expect(section).to_contain_text("pitch_speed_mph")
    expect(section).to_contain_text(f"curl -s {server}/api/v1/explorer")
    section.get_by_text("Try it").click()
    section.get_by_role("button", name="Send").click()
    expect(section.locator("pre").last).to_contain_text("R161, white ash")
    assert f"{server}/docs" in asked and from_elsewhere(asked, server) == []
    named_and_seen(page)


def from_elsewhere(asked: list[str], server: str) -> list[str]:
    """Return the addresses that are not the server's own."""
    return [url for url in asked if not url.startswith((server, "data:", "blob:"))]


def every_curve_and_map_has_a_table(page: Page) -> None:
    """Check that each chart has a table, which fills as it opens."""
    tables = page.locator("summary:visible", has_text="as a table")
    assert tables.count() >= 1
    for table in tables.all():
        table.click()
    for table in page.locator(".numbers:visible").all():
        expect(table.locator("tbody td", has_text=re.compile(r"\d")).first).to_be_visible()


def named_and_seen(page: Page) -> None:
    """Check names, roles and contrast of all that a page holds, in both themes."""
    page.evaluate("document.querySelectorAll('details').forEach((details) => (details.open = true))")
    assert check(page, "names") == []
    assert check(page, "contrast") == []
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    assert check(page, "contrast") == []


def reached_in_order_and_seen(page: Page) -> None:
    """Check that Tab goes through all that can be used, in the order of the document, and each stop has an outline."""
    page.evaluate(
        "window.stops = [...document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]')]"
        ".filter((element) => element.tabIndex >= 0 && !element.disabled && element.checkVisibility())"
    )
    reached = []
    for _ in range(page.evaluate("window.stops.length") + 5):
        page.keyboard.press("Tab")
        place, seen = check(page, "stop")
        if place < 0 or place in reached:
            break
        assert seen, page.evaluate("document.activeElement.outerHTML.slice(0, 120)")
        reached.append(place)
    radios = page.evaluate("window.stops.filter((stop) => stop.type === 'radio').length")
    groups = page.evaluate("new Set(window.stops.filter((s) => s.type === 'radio').map((s) => s.name)).size")
    assert reached == sorted(reached)
    assert len(reached) == page.evaluate("window.stops.length") - (radios - groups)  # a group of radios is one stop
