"""The page for people who use a keyboard, a screen reader, large contrast or calm pictures.

What holds for every view is checked in test_page_every_view.py.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.parts import Answered, Wait, written

CHECKS = Path(__file__).with_name("access.js").read_text(encoding="utf-8")


def check(page: Page, name: str) -> Any:
    """Return what one of the checks in access.js finds."""
    return page.evaluate(f"{CHECKS.rstrip()}.{name}()")


VIEW = "explorer"


def test_texts_on_canvases_have_contrast_too(opened: Page) -> None:
    for theme in ("light", "dark"):
        opened.evaluate(f"document.documentElement.dataset.theme = '{theme}'")
        colours = check(opened, "palette")
        for name in ("ink", "muted"):
            assert contrast(colours[name], colours["panel"]) >= 4.5
            assert contrast(colours[name], colours["zone"]) >= 4.5
        assert contrast(colours["zone-ink"], colours["panel"]) >= 4.5


def contrast(one: str, other: str) -> float:
    """Return the contrast of two colours written #rrggbb, after WCAG."""

    def light(colour: str) -> float:
        values = [int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5)]
        linear = [value / 12.92 if value <= 0.03928 else ((value + 0.055) / 1.055) ** 2.4 for value in values]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    low, high = sorted([light(one), light(other)])
    return (high + 0.05) / (low + 0.05)


def test_the_explorer_works_without_a_mouse(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    ball = page.get_by_role("slider", name="Ball along the bat")
    ball.focus()
    page.keyboard.press("ArrowLeft")
    count = answered(page, count)
    expect(ball).to_have_attribute("aria-valuetext", "6.1 in from the tip")
    page.get_by_role("slider", name="Pitch speed").focus()
    page.keyboard.press("ArrowRight")
    answered(page, count)
    assert "pitch_speed_mph=90.5" in page.url
    expect(page.locator("#announcer")).to_contain_text("hits fastest")  # said to a screen reader
    page.keyboard.press("Tab")
    page.locator(".skip").focus()
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.id") == "view"


@pytest.mark.parametrize(
    ("view", "words", "last"),
    [("flight", "This path as a table", "381"), ("modes?number=2", "This motion as a table", "0.00")],
)
def test_a_path_and_a_motion_are_tables_too(
    page: Page, server: str, settled: Wait, view: str, words: str, last: str
) -> None:
    page.goto(f"{server}/{view}")
    settled(page)
    page.locator("summary", has_text=words).click()
    rows = page.locator("details", has_text=words).locator("tbody tr")
    expect(rows.last).to_contain_text(last)  # where it comes down, and the tip
    assert rows.count() > 10


COVERED = """(() => {
  const { left, top, width, height } = document.activeElement.getBoundingClientRect();
  const there = document.elementFromPoint(left + width / 2, top + Math.min(20, height / 2)); // of what is tall, its top
  return !(document.activeElement.contains(there) || there?.contains(document.activeElement));
})()"""


@pytest.mark.parametrize("view", ["explorer", "flight"])
def test_on_a_phone_the_keyboard_reaches_the_picture_first_and_nothing_that_is_covered(
    page: Page, server: str, settled: Wait, view: str
) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(f"{server}/{view}")
    settled(page)
    page.locator("#view").focus()
    reached: list[str] = []
    covered: list[str] = []
    while "Controls" not in "".join(reached):
        page.keyboard.press("Tab")
        page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        words = page.evaluate("document.activeElement.getAttribute('aria-label') || document.activeElement.textContent")
        reached.append(words[:40])
        assert len(reached) < 40
        if page.evaluate(COVERED):
            covered.append(words[:40])
    assert len(reached) > 8
    assert not covered


def test_a_low_window_is_not_filled_by_what_stays_on_top(page: Page, server: str, settled: Wait) -> None:
    page.set_viewport_size({"width": 720, "height": 450})  # a laptop's at 200 %
    page.goto(f"{server}/explorer")
    settled(page)
    page.evaluate("scrollTo(0, 600)")
    assert page.evaluate("document.querySelector('#view .pinned').getBoundingClientRect().bottom") < 100


def test_what_is_wrong_is_tied_to_its_field(opened: Page) -> None:
    written(opened, "pitch_speed_mph", 900)
    field = opened.locator("[data-field=pitch_speed_mph] input[type=number]")
    expect(field).to_have_attribute("aria-invalid", "true")
    described = field.get_attribute("aria-describedby")
    expect(opened.locator(f"[id='{described}']")).to_have_text("Allowed is 0 to 125 mph.")
