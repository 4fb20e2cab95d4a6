"""The explorer in a real browser: each control by what a person sees of it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from tests.web.parts import Answered, Until, Wait, bench, choose, moved, number, picture, written

VIEW = "explorer"


def test_the_first_picture_says_where_the_bat_hits_best(opened: Page, settled: Wait) -> None:
    settled(opened)
    expect(opened.locator("#verdict")).to_contain_text("R161, white ash hits fastest 5.7 in from the tip")
    expect(opened.locator("#view canvas")).to_have_count(3)
    assert number(opened, "Exit speed") == pytest.approx(103.3, abs=1)
    drawn = opened.evaluate(
        "[...document.querySelectorAll('#view canvas')].map((c) => new Set(c.getContext('2d')"
        ".getImageData(0, 0, c.width, c.height).data).size)"
    )
    assert min(drawn) > 50  # shades on every canvas: something is drawn on it


def test_a_swing_weight_says_how_sure_it_is(opened: Page, answered: Answered) -> None:
    """That of the R161 follows from its outline, that of B6 was measured."""
    fact = opened.locator(".facts div:has(:text-is('Swing weight')) dd")
    expect(fact).to_have_text(re.compile(r"^10,300\s±\s1000\soz\sin²$"))
    count = answered(opened)
    choose(opened, "russell-b6")
    answered(opened, count)
    expect(fact).to_have_text(re.compile(r"^9590\soz\sin²$"))


CONTROLS = {
    "pitch_speed_mph": (60, "Exit speed"),
    "bat_speed_mph": (80, "Exit speed"),
    "impact_from_tip_in": (2, "Exit speed"),
    "ball_cor": (0.45, "Exit speed"),
    "ball_humidity": (95, "Exit speed"),
    "ball_temperature_degf": (20, "Exit speed"),
    "choke_up_in": (2, "Exit speed"),
    "offset_in": (0.8, "Launch angle"),
    "mass_oz": (33, "Weight"),
    "bore_diameter_in": (1, "Weight"),
    "cup_diameter_in": (1.5, "Weight"),
    "weight_oz": (2, "Weight"),
}


def test_every_control_changes_number_picture_and_address(opened: Page, answered: Answered, settled: Wait) -> None:
    settled(opened)
    for field, (value, name) in CONTROLS.items():
        before, shown = number(opened, name), picture(opened)
        moved(opened, answered, field, value)
        assert abs(number(opened, name) - before) > 0.05, field
        assert picture(opened) != shown, field
        assert f"{field}=" in opened.url
    before_hands = picture(opened)
    moved(opened, answered, "hands_in", 8)  # the centre of percussion moves, no number beside it
    assert picture(opened) != before_hands


def test_dragging_a_slider_redraws_before_it_is_let_go(opened: Page, answered: Answered, until: Until) -> None:
    before, count = number(opened, "Exit speed"), answered(opened)
    slider = opened.get_by_role("slider", name="Pitch speed")
    box = slider.bounding_box()
    assert box is not None
    middle = box["y"] + box["height"] / 2
    opened.mouse.move(box["x"] + 0.8 * box["width"], middle)
    opened.mouse.down()
    opened.mouse.move(box["x"] + 0.5 * box["width"], middle, steps=5)
    answered(opened, count)
    until(opened, "parseFloat(document.querySelector('[data-field=pitch_speed_mph] input').value) < 65")
    answered(opened)
    assert number(opened, "Exit speed") < before - 2
    assert "pitch_speed_mph" not in opened.url  # not yet a step for the back button
    opened.mouse.up()
    expect(opened).to_have_url(re.compile("pitch_speed_mph="))


def test_dragging_the_ball_along_the_bat(opened: Page, answered: Answered, settled: Wait) -> None:
    settled(opened)
    before, count = number(opened, "Exit speed"), answered(opened)
    canvas = opened.locator("#view canvas").first.bounding_box()
    assert canvas is not None
    level = canvas["y"] + canvas["height"] * 0.6
    opened.mouse.move(canvas["x"] + 0.8 * canvas["width"], level)
    opened.mouse.down()
    opened.mouse.move(canvas["x"] + 0.35 * canvas["width"], level, steps=4)
    answered(opened, count + 1)
    opened.mouse.up()
    expect(opened).to_have_url(re.compile("impact_from_tip_in=1"))
    assert number(opened, "Exit speed") < before - 5


@pytest.mark.parametrize("pressed", ["Exit speed over the barrel", "Curves along the bat"])
def test_the_map_and_the_curves_can_be_pressed_too(
    opened: Page, answered: Answered, settled: Wait, pressed: str
) -> None:
    settled(opened)  # the map comes after the answer
    count = answered(opened)
    opened.get_by_role("img", name=pressed).click(position={"x": 700, "y": 100})
    answered(opened, count)
    expect(opened).to_have_url(re.compile("impact_from_tip_in="))


def test_a_bat_of_the_catalogue(opened: Page, answered: Answered) -> None:
    count = answered(opened)
    choose(opened, "single-wall")
    answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("Single-wall aluminium")
    bench(opened).locator("summary", has_text="Workshop").click()
    expect(opened.get_by_role("slider", name="Wall thickness")).to_be_visible()
    expect(opened.get_by_role("slider", name="Hole in the barrel")).to_be_hidden()
    before = number(opened, "BBCOR in play")
    moved(opened, answered, "wall_factor", 0.9)
    assert number(opened, "BBCOR in play") > before  # a thinner wall springs more


def test_an_uploaded_bat(opened: Page, answered: Answered, tmp_path: Path) -> None:
    own = catalog.bat("youth-30").replaced(name="My bat")
    (tmp_path / "my.toml").write_text(bat_toml(own), encoding="utf-8")
    count = answered(opened)
    bench(opened).locator("#any-file").set_input_files(tmp_path / "my.toml")
    answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("My bat hits fastest")
    opened.reload()
    answered(opened)
    expect(opened.locator("#verdict")).to_contain_text("My bat")  # the address holds it


def test_a_ball_of_ones_own(opened: Page, answered: Answered, tmp_path: Path) -> None:
    """What is wrong in it stands beside it; the ball that it describes is hit; a listed one takes its place again."""
    opened.locator("summary", has_text="Ball").first.click()
    opened.locator("summary", has_text="Your own ball").click()
    before = number(opened, "Exit speed")
    (tmp_path / "ball.toml").write_text('like = "baseball"\nweight = "5 oz"\n', encoding="utf-8")
    opened.get_by_label("Ball file (TOML)").set_input_files(tmp_path / "ball.toml")
    expect(opened.locator("#ball-fault")).to_contain_text("unknown key 'weight'")
    count = answered(opened)
    opened.locator("#ball-text").fill('like = "baseball"\nname = "dead"\ncor_reference = 0.48\n')
    opened.locator("details.own", has=opened.locator("#ball-text")).get_by_role("button", name="Use").click()
    answered(opened, count)
    expect(opened.locator("#ball-fault")).to_be_hidden()
    assert number(opened, "Exit speed") < before - 1
    count = answered(opened)
    opened.get_by_label("Ball", exact=True).select_option("baseball")
    answered(opened, count)
    assert number(opened, "Exit speed") == before and "ball_toml" not in opened.url


def test_a_bat_too_long_for_an_address_is_kept_by_the_browser(opened: Page, answered: Answered, tmp_path: Path) -> None:
    own = catalog.bat("youth-30").replaced(name="Long bat")
    (tmp_path / "long.toml").write_text("# " + "many words " * 1600 + "\n" + bat_toml(own), encoding="utf-8")
    count = answered(opened)
    bench(opened).locator("#any-file").set_input_files(tmp_path / "long.toml")
    answered(opened, count)
    assert len(opened.url) < 1000
    opened.reload()
    answered(opened)
    expect(opened.locator("#verdict")).to_contain_text("Long bat")
    opened.go_back()
    expect(opened.locator("#verdict")).to_contain_text("R161")


def test_a_dropped_bat(opened: Page, answered: Answered) -> None:
    text = bat_toml(catalog.bat("mlb-a").replaced(name="Dropped"))
    count = answered(opened)
    opened.evaluate(
        """(text) => {
          const data = new DataTransfer();
          data.items.add(new File([text], 'dropped.toml', { type: 'text/plain' }));
          document.querySelector('#view').dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }));
        }""",
        text,
    )
    answered(opened, count)
    expect(opened.locator("#verdict")).to_contain_text("Dropped")


def test_a_wrong_file_is_explained_by_its_name(opened: Page, answered: Answered, tmp_path: Path) -> None:
    for content, words in (
        ("name = 'x'\nlength = '33 in'", "material is missing"),
        ("#" * 30_000, "wrong.toml is larger than 0.02 MB"),
    ):
        (tmp_path / "wrong.toml").write_text(content, encoding="utf-8")
        bench(opened).locator("#any-file").set_input_files(tmp_path / "wrong.toml")
        expect(opened.locator("dialog")).to_contain_text(words)
        opened.locator("dialog").get_by_role("button", name="Close").click()
    assert number(opened, "Exit speed") > 100  # the last good picture stays


def test_drawing_the_outline(opened: Page, answered: Answered, settled: Wait) -> None:
    before, count = number(opened, "Weight"), answered(opened)
    opened.get_by_role("button", name="Whole bat").click()
    bench(opened).locator("summary", has_text="Draw the outline").click()
    expect(opened.locator(".stations tbody tr").first).to_be_visible()  # the page hears of an opened box a task later
    settled(opened)
    station = catalog.bat().profile[9]  # type: ignore[index]
    place = opened.evaluate(
        """([position, diameter]) => {
          const box = document.querySelector('#view canvas').getBoundingClientRect();
          const scale = (box.width - 58) / 0.8382;
          return [box.left + 46 + position * scale, box.top + 112 + 0.038 * scale - diameter / 2 * scale];
        }""",
        list(station),
    )
    opened.mouse.move(*place)
    opened.mouse.down()
    opened.mouse.move(place[0], place[1] - 20, steps=4)
    opened.mouse.up()
    answered(opened, count + 1)
    expect(opened).to_have_url(re.compile("profile_in="))
    assert number(opened, "Weight") > before + 0.5
    rows = opened.locator(".stations tbody tr")
    stations = rows.count()
    count = answered(opened)
    opened.get_by_role("button", name="Add a station after station 3", exact=True).click()
    answered(opened, count)
    expect(rows).to_have_count(stations + 1)


def test_what_the_server_refuses_stands_beside_its_field(opened: Page, answered: Answered) -> None:
    fault = opened.locator("[data-field=mass_oz] .fault")
    written(opened, "mass_oz", 12)
    expect(fault).to_contain_text("Allowed is")
    moved(opened, answered, "mass_oz", 32)
    expect(fault).to_be_hidden()


def test_the_export_gives_the_numbers_and_pictures(opened: Page) -> None:
    opened.get_by_role("button", name="Export").click()
    found = {}
    for name in ("png", "svg", "csv", "json", "toml"):
        with opened.expect_download() as download:
            opened.locator(f"dialog [data-format={name}]").click()
        found[name] = download.value.path().read_bytes()
    assert found["png"].startswith(b"\x89PNG")
    assert found["svg"].startswith(b"<svg")
    assert b"sweet zone" in found["svg"]
    assert found["csv"].splitlines()[0].startswith(b"position_m,exit_speed_m_s")
    assert len(found["csv"].splitlines()) == 162
    assert json.loads(found["json"])["answer"]["bat"]["name"] == "R161, white ash"
    assert b'material = "white-ash"' in found["toml"]
    expect(opened.locator("[data-lines=command]")).to_contain_text("sweetspot report r161-ash")
    expect(opened.locator("[data-lines=python]")).to_contain_text("sweetspot.report('r161-ash')")


@pytest.mark.parametrize(
    ("view", "fold", "row", "words"),
    [("explorer", "sure", "this ball", "%"), ("compare", "rules_sure", "BBCOR of the test", " to ")],
)
def test_how_sure_the_numbers_are_stands_below(
    still: Page, server: str, settled: Wait, view: str, fold: str, row: str, words: str
) -> None:
    """Asked for only by those who open it: intervals beside the report's numbers, and what they come from."""
    still.goto(f"{server}/{view}")
    settled(still)
    still.locator(f"#{fold} summary").click()
    told = still.locator(f"#{fold} .document")
    expect(told).to_contain_text("90 % intervals")
    expect(told).to_contain_text("±")
    expect(told.get_by_role("row", name=row).first).to_contain_text(words)
