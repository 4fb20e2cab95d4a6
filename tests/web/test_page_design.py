"""Design in a browser: a handle is pulled, lights and curves follow, the search's front grows and a bat is taken."""

from __future__ import annotations

import re
from typing import Any

from playwright.sync_api import Page, expect

from tests.web.parts import Answered, Wait, visit


def test_a_handle_is_pulled_by_hand_and_by_keyboard(page: Page, server: str, answered: Answered, settled: Wait) -> None:
    page.goto(f"{server}/design?keep_mass=false&keep_moi=false")
    count = answered(page)
    expect(page.locator("#verdict")).to_contain_text("present bat still")
    settled(page)
    box: Any = page.locator("#view canvas").first.bounding_box()
    stations = page.evaluate(
        "(async () => (await fetch('/api/v1/design', { method: 'POST', body: '{}', headers: "
        "{ 'content-type': 'application/json' } })).json())()"
    )
    length, handle = stations["design"]["length_m"], stations["design"]["stations"][8]
    scale = (box["width"] - 46 - 12) / length
    x = box["x"] + 46 + handle["position_m"] * scale
    middle = box["y"] + 8 + 0.038 * scale
    page.mouse.move(x, middle - handle["diameter_m"] / 2 * scale)
    page.mouse.down()
    page.mouse.move(x, middle - 1.08 * handle["diameter_m"] / 2 * scale, steps=4)
    page.mouse.up()
    count = answered(page, count)
    expect(page.locator("#verdict")).to_contain_text("Over these contacts")
    expect(page.locator(".lights .fail")).to_contain_text(["greatest diameter"])  # 2.7 in of barrel
    page.get_by_text("The bat's numbers").click()
    knob = page.get_by_role("slider", name="4.4 in from the tip")
    wide = float(knob.input_value())
    knob.focus()
    page.keyboard.press("ArrowLeft")
    answered(page, count)
    assert float(knob.input_value()) < wide
    page.get_by_role("button", name="As the present bat").click()
    expect(page.locator("#verdict")).to_contain_text("present bat still")
    expect(page.locator(".lights .fail")).to_have_count(0)


def test_the_search_grows_a_front_and_a_bat_is_taken(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/design?also_want=swing_time&want=sting")
    answered(page)
    page.get_by_role("button", name="Find better").click()
    expect(page.get_by_text(re.compile(r"^Looking.*\d bats? on the front"))).to_be_visible()
    page.get_by_role("button", name="Stop").click()
    page.get_by_text(re.compile(r"Stopped after \d+ of 30 generations; \d+ bats?")).wait_for()
    page.reload()
    page.get_by_text(re.compile(r"Stopped after \d+ of 30 generations; \d+ bats?")).wait_for()
    page.get_by_text("These bats as a table, to take one").click()
    page.get_by_role("button", name="Take bat 1", exact=True).click()
    expect(page.locator("#verdict")).to_contain_text("Over these contacts")
    expect(page.get_by_text("1 (taken)")).to_be_visible()
    with page.expect_download() as taken:
        page.get_by_role("button", name="Drawing (SVG)").click()
    assert taken.value.suggested_filename == "designed-bat.svg"
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench-chip")).to_contain_text("designed")
    visit(page, "explorer")
    expect(page.locator("#verdict")).to_contain_text("designed hits fastest")
