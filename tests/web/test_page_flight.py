"""The flight in a real browser: path, park, weather and count, by what a person sees."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.parts import Answered, Wait, moved, number, picture, written

VIEW = "flight"


def test_the_first_picture_says_over_which_fences_in_the_order_of_the_caption(opened: Page) -> None:
    expect(opened.locator("#verdict")).to_contain_text(re.compile(r"Fenway Park.*Out in \d+ of 30 parks"))
    expect(opened.get_by_role("region", name=re.compile("every park")).locator("tbody tr")).to_have_count(30)
    expect(opened.get_by_role("img", name=re.compile("^The flight from the side"))).to_be_visible()
    expect(opened.get_by_role("img", name=re.compile("^The field of Fenway Park"))).to_be_visible()
    assert number(opened, "Without air") > number(opened, "Carry") + 50
    # the likeliest home run first, each with its own carry: in Denver 19 ft more than in Phoenix
    table = opened.get_by_role("region", name=re.compile("every park")).locator("table")
    expect(table.locator("caption")).to_contain_text("the likeliest home run first")
    rest = table.locator("tbody tr").nth(12)
    expect(rest).to_be_hidden()  # a long table begins with its first rows
    opened.get_by_role("button", name="All 30 rows").click()
    expect(rest).to_be_visible()
    rows = [row.split("\t") for row in table.locator("tbody tr").all_inner_texts()]
    chances = [int(row[2].removesuffix("%")) for row in rows]
    assert chances == sorted(chances, reverse=True)
    carry = {row[0].splitlines()[0].strip(): row[3] for row in rows}
    assert (carry["Coors Field"], carry["Chase Field"]) == ("406\N{NO-BREAK SPACE}ft", "387\N{NO-BREAK SPACE}ft")


CONTROLS = {
    "exit_speed_mph": 92,
    "launch_angle_deg": 40,
    "backspin_rpm": 500,
    "wind_speed_mph": 12,
    "temperature_degf": 40,
    "elevation_ft": 5000,
    "pressure_inhg": 28,
    "height_ft": 6,
}


def test_each_control_changes_carry_and_picture(opened: Page, answered: Answered) -> None:
    for field, value in CONTROLS.items():
        before, shown = number(opened, "Carry"), picture(opened)
        moved(opened, answered, field, value)
        assert number(opened, "Carry") != before and picture(opened) != shown, field
        assert f"{field}=" in opened.url


def test_direction_and_sidespin_move_the_path_on_the_field(opened: Page, answered: Answered) -> None:
    for field, value in (("spray_deg", 25), ("sidespin_rpm", 1500)):
        shown = picture(opened)
        moved(opened, answered, field, value)
        assert picture(opened) != shown
    moved(opened, answered, "spray_deg", 55)
    expect(opened.locator("#verdict")).to_contain_text("Foul")


def test_dragging_on_the_field_turns_the_ball(opened: Page, answered: Answered, settled: Wait) -> None:
    settled(opened)
    count = answered(opened)
    box = opened.get_by_role("img", name=re.compile("^The field of")).bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] - 14
    opened.mouse.move(x, y - 200)
    opened.mouse.down()
    opened.mouse.move(x + 150, y - 150, steps=4)
    answered(opened, count)
    opened.mouse.up()
    expect(opened).to_have_url(re.compile(r"spray_deg=(4\d|50)"))  # the plate is drawn a few pixels above the corner


def test_the_ball_comes_down_where_the_hand_lets_it_go(
    page: Page, server: str, settled: Wait, in_view: Callable[[Page, str, str], Any]
) -> None:
    """Within half: carry is not quite the 0.6th power of speed. Twenty moves before an answer must not add up."""
    page.goto(f"{server}/flight?spray_deg=0")
    settled(page)
    landed = """const { field, answer } = view;
      field.element.scrollIntoView({ block: "center" });
      const { left, top } = field.element.getBoundingClientRect();
      return [left + field.landed[0], top + field.landed[1], field.scale, answer.flight.carry_m];"""
    x, y, scale, carry = in_view(page, "flight", landed)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - 30, steps=20)
    page.mouse.up()
    settled(page)
    gone = in_view(page, "flight", landed)[3] - carry
    assert gone == pytest.approx(30 / scale, rel=0.5) and gone < 0.1 * carry


def test_another_park_brings_its_elevation(opened: Page, answered: Answered) -> None:
    before, count = number(opened, "Carry"), answered(opened)
    opened.get_by_label("Park", exact=True).select_option("coors-field")
    answered(opened, count)
    assert number(opened, "Carry") > before + 10
    assert float(opened.locator("[data-field=elevation_ft] input[type=number]").input_value()) > 5000
    expect(opened.locator("#verdict")).to_contain_text("Coors Field")


def test_from_the_swing(opened: Page, answered: Answered) -> None:
    count = answered(opened)
    opened.get_by_label("The ball starts").select_option("swing")
    answered(opened, count)
    expect(opened.get_by_text("The bat moves at")).to_be_visible()
    expect(opened.get_by_role("slider", name="Exit speed")).to_be_hidden()
    before = number(opened, "Carry")
    moved(opened, answered, "bat_speed_mph", 60)
    assert number(opened, "Carry") < before
    moved(opened, answered, "offset_in", 2.5)
    moved(opened, answered, "impact_from_tip_in", 20)
    expect(opened.locator("#verdict")).to_contain_text("The bat misses the ball")
    moved(opened, answered, "impact_from_tip_in", 6)
    moved(opened, answered, "offset_in", 0.7)
    expect(opened.get_by_role("img", name=re.compile("^The flight from the side"))).to_be_visible()
    written(opened, "tilt_deg", 2)
    expect(opened.locator("[data-field=tilt_deg] .fault")).to_contain_text("Allowed is 9 to 75")
    expect(opened.locator("[data-field=tilt_deg]")).to_contain_text("No path in a plane is steeper")


def test_units_phone_and_lines(opened: Page, narrow: Wait) -> None:
    opened.get_by_role("radio", name="SI", exact=True).check()
    expect(opened.locator("#verdict")).to_contain_text(" m ")
    text = opened.locator("#view").inner_text()
    assert "mph" not in text and " ft" not in text
    narrow(opened)
    opened.get_by_role("button", name="Menu").click()
    opened.get_by_role("button", name="Export").click()
    expect(opened.locator("dialog pre").first).to_contain_text("sweetspot fly --exit-speed 98mph")
    with opened.expect_download() as saved:
        opened.locator("dialog [data-format=csv]").click()
    assert saved.value.suggested_filename == "sweetspot-flight.csv"


def test_a_hit_in_space_is_drawn_when_it_is_opened_and_turned_by_hand(
    page: Page, server: str, settled: Wait, repainted: Any
) -> None:
    page.goto(f"{server}/flight")
    settled(page)
    fold = page.locator("#space")
    expect(fold).to_be_hidden()  # a ball with its own numbers was hit by nobody
    page.get_by_label("The ball starts").select_option("swing")
    settled(page)
    fold.locator("summary").click()
    expect(fold.locator(".words")).to_contain_text("The barrel rises 9.0")
    shown = fold.locator("canvas")
    expect(shown).to_have_attribute("aria-label", re.compile("The barrel rises 9.0"))
    for press in (lambda: shown.press("ArrowLeft"), lambda: fold.get_by_role("button", name="From above").click()):
        repainted(page, press)
