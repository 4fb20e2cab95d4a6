"""The comparison in a real browser: bats, what-ifs, verdict, rules, exports, by what a person sees."""

from __future__ import annotations

import json
import re
from functools import partial
from pathlib import Path
from urllib.parse import quote

import pytest
from playwright.sync_api import Page, Route, expect

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from tests.web.parts import Answered, Wait, choose, picture

VIEW = "compare"


def test_the_first_picture_has_three_bats_and_a_verdict(opened: Page) -> None:
    expect(opened.locator("#verdict")).to_contain_text("R161, corked")
    expect(opened.locator("#verdict")).to_contain_text("corked: swung 2.0 mph faster, the ball leaves 0.7 mph")
    expect(opened.locator("#verdict")).to_contain_text("(\N{MINUS SIGN}1.3 to +0.0): probably a loss")
    expect(opened.locator("#working")).to_be_hidden()
    rows = opened.get_by_role("region", name=re.compile("what they do in play")).locator("tbody tr")
    expect(rows).to_have_count(3)
    expect(rows.nth(0)).to_contain_text("reference")
    expect(opened.get_by_role("img", name=re.compile("^Change of exit speed"))).to_be_visible()


def test_nothing_is_judged_before_the_whole_interval_is_there(
    page: Page, server: str, answered: Answered, request: pytest.FixtureRequest
) -> None:
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    page.route("**/api/v1/compare/intervals", hold)
    request.addfinalizer(partial(page.unroute_all, behavior="ignoreErrors"))  # a held request holds the page open
    page.goto(f"{server}/compare")
    answered(page)
    table = page.get_by_role("region", name=re.compile("what they do in play"))
    change = page.get_by_role("img", name=re.compile("^Change of exit speed"))
    expect(page.locator("#working")).to_be_visible()
    expect(change).to_have_attribute("aria-label", re.compile(r"corked \S0\.7.mph;"))
    for place in (page.locator("#verdict"), table):
        expect(place).not_to_contain_text(re.compile(r"loss|gain|sure| to [+\N{MINUS SIGN}\d]"))
    while not held:
        page.wait_for_timeout(50)
    held[0].continue_()
    expect(page.locator("#verdict")).to_contain_text("(\N{MINUS SIGN}1.3 to +0.0): probably a loss")
    expect(page.locator("#working")).to_be_hidden()
    expect(table).to_contain_text("\N{MINUS SIGN}1.3 to +0.0")
    expect(change).to_have_attribute("aria-label", re.compile("interval"))


def test_a_bat_that_passes_only_as_far_as_is_known_is_not_simply_passed(page: Page, server: str) -> None:
    page.goto(f"{server}/compare?others=" + quote(json.dumps([{"bat": "college-alloy"}])))
    rule = page.get_by_role("region", name=re.compile("^Every rule")).get_by_role("row", name=re.compile("^BBCOR"))
    expect(rule.locator("td").nth(1)).to_contain_text("✓ pass, not sure (0.498")
    expect(rule.locator("td.good")).to_have_count(0)  # one piece of wood is not held to it


def test_bats_come_and_go(opened: Page, answered: Answered) -> None:
    before, count = picture(opened), answered(opened)
    opened.get_by_role("button", name="Add a bat").click()
    count = answered(opened, count)
    assert picture(opened) != before
    expect(opened.get_by_role("button", name="Add a bat")).to_be_hidden()
    opened.get_by_label("Bat 4", exact=True).select_option("composite")
    count = answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("Composite")
    opened.get_by_role("button", name="Remove Bat 2").click()
    answered(opened, count)
    expect(opened.locator("#verdict")).not_to_contain_text("corked")
    opened.go_back()
    expect(opened.locator("#verdict")).to_contain_text("corked")


def test_a_bat_is_changed_in_its_place(opened: Page, answered: Answered) -> None:
    count = answered(opened)
    slot = opened.get_by_role("group", name="Bat 2", exact=True)
    slot.locator("summary").click()
    weight = slot.get_by_role("spinbutton", name="Weight of the bat, oz")
    weight.fill("33")
    weight.press("Enter")
    answered(opened, count)
    expect(opened.get_by_role("region", name=re.compile("in play")).locator("tbody tr").nth(1)).to_contain_text("oz")
    assert '"mass_oz":33' in opened.evaluate("decodeURIComponent(location.search)")
    assert "wall_factor" not in opened.url  # only what was changed


def test_an_own_bat_takes_a_place(opened: Page, answered: Answered, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(bat_toml(catalog.bat("youth-30").replaced(name="My own")), encoding="utf-8")
    count = answered(opened)
    opened.get_by_role("group", name="Bat 3", exact=True).locator("summary").click()
    opened.get_by_label("Bat 3: your own bat file (TOML)").set_input_files(file)
    answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("My own")
    file.write_text("name = 'x'", encoding="utf-8")
    opened.get_by_label("Bat 3: your own bat file (TOML)").set_input_files(file)
    expect(opened.get_by_role("group", name="Bat 3", exact=True)).to_contain_text("is missing")


def test_corking_and_another_wall(opened: Page, answered: Answered) -> None:
    count = answered(opened)
    opened.get_by_label("Compare", exact=True).select_option("cork")
    count = answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("Does corking help?")
    expect(opened.get_by_label("Bat 2", exact=True)).to_be_hidden()
    before = opened.locator("#verdict").inner_text()
    depth = opened.locator("[data-field=hole_depth_in] input[type=number]")
    depth.fill("5")
    depth.press("Enter")
    count = answered(opened, count)
    assert opened.locator("#verdict").inner_text() != before
    opened.get_by_label("Compare", exact=True).select_option("wall")
    expect(opened.locator("[data-field=what_if] .fault")).to_contain_text("solid and has no wall")
    choose(opened, "russell-b6")
    answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("thinner wall is the livelier one")


def test_a_change_is_written_as_on_the_command_line(opened: Page, answered: Answered) -> None:
    count = answered(opened)
    opened.get_by_label("Compare", exact=True).select_option("change")
    count = answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("knob-weight 2oz")
    line = opened.get_by_label("Change", exact=True)
    line.fill("shaved 0.2mm")
    line.press("Enter")
    expect(opened.locator("[data-field=change] .fault")).to_contain_text("solid and has no wall")
    line.fill("cup 0.9in")
    line.press("Enter")
    answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("cup 0.9in")


def test_rules_of_a_league(opened: Page, answered: Answered) -> None:
    rules = opened.get_by_role("region", name=re.compile("Every rule"))
    expect(rules.locator("tbody tr").first).to_contain_text("fail")
    count = answered(opened)
    opened.get_by_label("Rules of").select_option("mlb")
    answered(opened, count)
    expect(rules).to_contain_text("one piece of solid wood")
    expect(rules).to_contain_text("Major League Baseball")


def test_units_and_phone(opened: Page, narrow: Wait) -> None:
    opened.get_by_label("Compare", exact=True).select_option("cork")
    opened.get_by_role("radio", name="SI", exact=True).check()
    expect(opened.locator("#verdict")).to_contain_text("m/s")
    expect(opened.locator("#verdict")).to_contain_text("Does corking help?")
    assert "mph" not in opened.locator("#view").inner_text()
    narrow(opened)


def test_exports(opened: Page) -> None:
    opened.get_by_role("button", name="Export").click()
    lines = opened.locator("dialog pre")
    expect(lines.first).to_contain_text("sweetspot compare r161-ash corked-r161 russell-b6")
    content = {}
    for form in ("png", "svg", "csv", "json"):
        with opened.expect_download() as saved:
            opened.locator(f"dialog [data-format={form}]").click()
        content[form] = Path(saved.value.path()).read_bytes()
    assert min(map(len, content.values())) > 1000
    assert len(json.loads(content["json"])["answer"]["bats"]) == 3
    assert content["csv"].startswith(b"label,position_m,exit_speed_m_s")
    assert b"R161, corked" in content["svg"]
