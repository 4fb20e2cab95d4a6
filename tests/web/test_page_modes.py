"""The modes view in a real browser: each item by what a person sees of it."""

from __future__ import annotations

import csv
from pathlib import Path

from playwright.sync_api import Page, expect

from tests.web.parts import Answered, Repainted, Until, Wait, choose


def picture(page: Page) -> str:
    """The pixels of the stage as text."""
    return str(page.evaluate("document.querySelector('.picture canvas').toDataURL()"))


def row(page: Page, name: str) -> list[str]:
    """The words of one motion's row."""
    found = page.locator(".motions tr").filter(has=page.get_by_label(name, exact=True))
    return [words.strip() for words in found.first.locator("td").all_inner_texts()]


def test_motions_are_listed_with_frequency_damping_and_the_tap(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/modes")
    answered(still)
    name, frequency, damping, decay, share, felt = row(still, "Bending 1")
    assert (name, damping) == ("Bending 1", "0.75 %")
    assert 165 < float(frequency.removesuffix(" Hz")) < 180
    assert decay.endswith(" ms") and share.endswith(" %") and felt.endswith(" m/s")
    assert row(still, "Push")[1] == "\N{EN DASH}"
    assert "It stands still 6.7" in still.inner_text("#verdict")
    assert str(still.locator(".motions th").last.text_content()).endswith("1\u00a0N\u00a0s"), "no line breaks the unit"


def test_choosing_a_motion_shows_it_and_goes_into_the_address(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/modes")
    drawn = answered(still)
    before = picture(still)
    still.get_by_label("Bending 2", exact=True).check()
    drawn = answered(still, drawn)
    assert picture(still) != before
    assert "number=2" in still.url and still.inner_text("#verdict").startswith("Bending 2")
    still.get_by_label("Bending 2", exact=True).press("ArrowDown")
    drawn = answered(still, drawn)
    assert still.inner_text("#verdict").startswith("Bending 3")
    assert still.evaluate("document.activeElement.value") == "bending 3"
    still.go_back()
    answered(still, drawn)
    assert still.inner_text("#verdict").startswith("Bending 2")


def test_a_tap_on_a_node_leaves_its_motion_alone(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/modes")
    drawn = answered(still)
    assert float(row(still, "Bending 1")[4].removesuffix(" %")) > 50
    before = picture(still)
    node = still.evaluate("document.querySelector('#verdict').textContent.match(/still ([0-9.]+)\\s+in/)[1]")
    still.get_by_label("Where, from the tip, in").fill(node)
    still.keyboard.press("Enter")
    answered(still, drawn)
    assert row(still, "Bending 1")[4] == "< 0.01 %"
    assert picture(still) != before  # the arrow has moved


def test_the_tap_can_be_dragged(still: Page, server: str, answered: Answered, settled: Wait) -> None:
    still.goto(f"{server}/modes")
    settled(still)
    drawn = answered(still)
    box = still.locator(".picture canvas").bounding_box()
    assert box is not None
    still.mouse.move(box["x"] + 0.9 * box["width"], box["y"] + 60)
    still.mouse.down()
    still.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 60, steps=4)
    still.mouse.up()
    answered(still, drawn)
    assert "tap_from_tip_in=16.5" in still.url


def test_a_hollow_bat_has_hoop_motions_and_a_solid_one_has_not(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/modes")
    drawn = answered(still)
    expect(still.get_by_label("Hoop 2.1", exact=True)).to_have_count(0)
    choose(still, "single-wall")
    drawn = answered(still, drawn)
    still.get_by_role("button", name="more that barely ring").click()
    still.get_by_label("Hoop 2.2", exact=True).check()
    answered(still, drawn)
    expect(still.locator("#verdict")).to_contain_text("2 waves around it and 2 half waves along it")


def test_hands_damp(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/modes")
    drawn = answered(still)
    free = float(row(still, "Bending 1")[2].removesuffix(" %"))
    still.get_by_label("Typical hands hold the bat").check()
    answered(still, drawn)
    assert float(row(still, "Bending 1")[2].removesuffix(" %")) > 3 * free
    expect(still.get_by_label("Hands 1", exact=True)).to_have_count(1)


def test_play_moves_it_and_pause_shows_both_ends(
    still: Page, server: str, answered: Answered, until: Until, repainted: Repainted
) -> None:
    still.goto(f"{server}/modes")
    answered(still)
    resting = picture(still)
    assert still.inner_text("#play") == "Play"
    repainted(still, lambda: still.click("#play"))
    assert still.inner_text("#play") == "Pause"
    still.keyboard.press("k")
    until(still, "document.querySelector('#play').textContent === 'Play'")
    assert picture(still) == resting


def test_it_moves_by_itself_unless_asked_not_to(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/modes")
    answered(page)
    assert page.inner_text("#play") == "Pause"
    page.get_by_role("button", name="Listen to the tap").click()  # nothing complains: `page` looks


def test_units_and_exports(still: Page, server: str, answered: Answered, tmp_path: Path) -> None:
    still.goto(f"{server}/modes")
    answered(still)
    still.locator("input[name=units][value=si]").check()
    expect(still.locator("#verdict")).to_contain_text("It stands still 17.1 cm")
    still.click("#export")
    with still.expect_download() as waited:
        still.click("dialog [data-format=csv]")
    waited.value.save_as(tmp_path / "modes.csv")
    with (tmp_path / "modes.csv").open(encoding="utf-8") as opened:
        rows = list(csv.DictReader(opened))
    assert len(rows) == 101 and any(name.startswith("shape_bending_1_") for name in rows[0])
    with still.expect_download() as waited:
        still.click("dialog [data-format=svg]")
    waited.value.save_as(tmp_path / "modes.svg")
    assert "stands still" in (tmp_path / "modes.svg").read_text(encoding="utf-8")
    assert "sweetspot report r161-ash" in still.inner_text("[data-lines=command]")
