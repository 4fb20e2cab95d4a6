"""The first page: one bat, one ball to drag, a sentence, a sound, and ways on; it works before anything is read."""

from __future__ import annotations

import re

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.units import INCH
from sweetspot.web.bats import reduced
from sweetspot.web.views import explorer, modes, start
from tests.web.parts import Answered, Wait, picture

VIEW = "start"
MOST_CONTROLS = 10
CONTROLS = "#view :is(a[href], button, input, select, textarea, summary, [tabindex])"


@pytest.mark.parametrize(("bat", "from_tip"), [("r161-ash", 6.0), ("youth-alloy", 2.0), ("mlb-a", 11.5)])
def test_the_hit_is_the_explorers(bat: str, from_tip: float) -> None:
    """Other code: the view with everything along the bat."""
    here = start.answer(start.StartState(bat=bat, impact_from_tip_in=from_tip))
    whole = explorer.answer(explorer.ExplorerState(bat=bat, impact_from_tip_in=from_tip))
    assert here.exit_speed == whole.hit.exit_speed
    assert here.best == whole.sweet_spots.max_exit_speed
    assert here.sentence["us"][1] == whole.headline["us"][0]
    assert start.recipe(start.StartState(bat=bat)) == explorer.recipe(explorer.ExplorerState(bat=bat))


@pytest.mark.parametrize(
    ("from_tip", "words"),
    [
        (6.0, r"here; 2 in towards the hands costs [\d.]+ mph, 2 in towards the tip costs [\d.]+ mph"),
        (1.0, r"here; 2 in towards the hands gains [\d.]+ mph\.$"),  # beyond the tip there is nothing to miss by
        (12.0, r"towards the hands costs [\d.]+ mph, 2 in towards the tip gains"),
    ],
)
def test_what_a_miss_costs(from_tip: float, words: str) -> None:
    """Exact: the difference between the two hits, told to a tenth of a mile per hour."""
    here = start.answer(start.StartState(impact_from_tip_in=from_tip))
    assert re.search(words, here.sentence["us"][0])
    inside = start.answer(start.StartState(impact_from_tip_in=from_tip + 2))
    assert here.exit_speed is not None and inside.exit_speed is not None
    change = float(re.findall(r"hands (?:costs|gains) ([\d.]+)", here.sentence["us"][0])[0])
    assert change == pytest.approx(
        abs(float(here.exit_speed) - float(inside.exit_speed)) / 0.44704, abs=0.3
    )  # between places of the curve


def test_the_sound_has_the_bats_own_tones() -> None:
    """Other code: the modes; where a bending mode has its node a hit leaves none of it."""
    state = start.StartState()
    model = reduced(state, catalog.ball())
    node = float(modes.answer(modes.ModesState()).nodes.node_1)
    at_node = start.answer(start.StartState(impact_from_tip_in=round((model.bat.length - node) / INCH, 2)))
    frequencies = model.modes.frequency
    for tone in at_node.tones:
        assert np.min(np.abs(frequencies / float(tone.frequency) - 1)) < 1e-9
    lowest = pytest.approx(min(frequencies[2:]))
    assert sum(float(tone.energy_share) for tone in at_node.tones if float(tone.frequency) == lowest) < 0.01
    tip = start.answer(start.StartState(impact_from_tip_in=0.5))
    assert max(tip.tones, key=lambda tone: float(tone.energy_share)).frequency == pytest.approx(min(frequencies[2:]))


def test_it_is_the_first_page_and_small(page: Page, server: str, answered: Answered) -> None:
    page.goto(server)
    answered(page)
    expect(page.locator("#view")).to_have_attribute("data-view", "start")
    expect(page.locator("h1")).to_have_text(start.TITLE)
    expect(page.locator(".brand")).to_contain_text("sweetspot")
    assert page.locator(CONTROLS).count() <= MOST_CONTROLS
    expect(page.locator("dialog")).to_have_count(0)


def test_old_addresses_of_the_first_page_keep_their_state(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/?bat=youth-30&pitch_speed_mph=61.5")
    answered(page)
    expect(page.locator("#verdict")).to_contain_text("Youth 30 in")
    expect(page.locator("[data-field=pitch_speed_mph] input[type=number]")).to_have_value("61.5")


def test_the_ball_is_moved_by_hand_and_by_key(opened: Page, answered: Answered, settled: Wait) -> None:
    settled(opened)
    words = opened.locator("#verdict p").first
    before, count = words.inner_text(), answered(opened)
    canvas = opened.locator("#view canvas")
    box = canvas.bounding_box()
    assert box is not None
    opened.mouse.click(box["x"] + 0.6 * box["width"], box["y"] + box["height"] / 2)
    answered(opened, count)
    assert words.inner_text() != before
    held = canvas.get_attribute("aria-valuenow")
    canvas.focus()
    count = answered(opened)
    opened.keyboard.press("ArrowRight")
    answered(opened, count)
    assert float(canvas.get_attribute("aria-valuenow") or 0) == pytest.approx(float(held or 0) + 0.1, abs=0.011)
    drawn = picture(opened)
    opened.keyboard.press("Home")
    expect(words).not_to_contain_text("towards the hands")
    assert picture(opened) != drawn


def test_doors_lead_on_with_the_bat_and_the_hit(opened: Page, answered: Answered) -> None:
    speed = opened.locator("[data-field=bat_speed_mph] input[type=number]")
    speed.fill("61")
    speed.press("Enter")
    for door in start.DOORS:
        opened.goto(opened.url.replace("/start", "/"))
        answered(opened)
        title = start.DOORS[door][0]
        opened.get_by_role("navigation", name="Ways on").get_by_role("link", name=title).click()
        expect(opened.locator("#view")).to_have_attribute("data-view", door)
        expect(opened).to_have_url(re.compile("bat_speed_mph=61"))
        opened.go_back()
        answered(opened)


def test_the_hit_sounds(opened: Page) -> None:
    opened.evaluate(
        "() => { window.played = 0; const { start } = AudioBufferSourceNode.prototype;"
        "AudioBufferSourceNode.prototype.start = function (...when) { window.played += 1; start.apply(this, when); }; }"
    )
    opened.get_by_role("button", name="Hear this hit").click()
    assert opened.evaluate("window.played") == 1
