"""The bat behind the chip in the bar: found in a list, changed beside the picture, the same everywhere."""

from __future__ import annotations

from playwright.sync_api import Page, expect

from tests.web.parts import Wait, bench
from tests.web.test_page_every_view import named_and_seen
from tests.web.test_page_screens import OUTSIDE


def test_the_bench_lies_beside_the_picture_and_is_used_by_key(
    page: Page, server: str, settled: Wait, narrow: Wait
) -> None:
    page.goto(f"{server}/explorer")
    settled(page)
    chip = page.locator("#bench-chip")
    chip.focus()
    page.keyboard.press("Enter")
    expect(chip).to_have_attribute("aria-expanded", "true")
    expect(page.locator("#bench-name")).to_be_focused()
    box, picture = page.locator("#bench").bounding_box(), page.locator("#view canvas").first.bounding_box()
    assert box is not None and picture is not None
    assert box["x"] + box["width"] <= picture["x"]  # what is changed is seen
    page.locator("#bench details").evaluate_all("all => all.forEach((one) => (one.open = true))")
    named_and_seen(page)
    narrow(page)
    assert page.evaluate(OUTSIDE) == []
    box = page.locator("#bench").bounding_box()
    assert box is not None and box["y"] > 0.4 * 740  # above it is the picture
    page.locator("#bench-search").focus()
    page.keyboard.press("Escape")
    expect(page.locator("#bench")).to_be_hidden()
    expect(chip).to_be_focused()


def test_a_bat_is_found_by_name_sport_or_kind(page: Page, server: str, settled: Wait) -> None:
    page.goto(f"{server}/modes")
    settled(page)
    opened = bench(page)
    rows, search = opened.locator(".bat-list label:visible"), page.get_by_label("Find a bat")
    expect(opened.locator(".bat-list legend").first).to_have_text("Youth baseball")
    expect(opened.locator("input:checked")).to_have_value("r161-ash")
    for words, found in (("usabat", "USABat alloy"), ("slow-pitch", "Slow-pitch softball"), ("cricket", "Cricket bat")):
        search.fill(words)
        expect(rows).to_have_count(1)
        expect(rows).to_contain_text(found)
    search.fill("no such bat")
    expect(opened.get_by_role("status")).to_contain_text("Describe yours")
    search.fill("usabat")
    rows.locator("input").check()
    expect(page.locator("#bench-name")).to_contain_text("USABat alloy")
    settled(page)
    search.fill("cricket")
    rows.locator("input").check()
    expect(page.locator("#view")).to_have_attribute("data-view", "sports")
    expect(page.locator("#bench-chip")).to_contain_text("Cricket bat")
