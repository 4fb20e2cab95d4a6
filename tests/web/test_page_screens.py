"""Small screens and the keyboard alone: the wizard, the drawer, and words; test_page_every_view.py has the views."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.web.parts import Answered, Wait, bench

OUTSIDE = """() => [...document.querySelectorAll("body *")].filter((element) => {
  const { left, right, width } = element.getBoundingClientRect();
  const movable = ".scroll, .stations, .formula, pre, textarea, nav, .unseen, .skip";
  return width > 1 && (right > innerWidth + 1 || left < -1) && element.checkVisibility() && !element.closest(movable);
}).map((element) => element.outerHTML.slice(0, 100))"""
OPEN = "document.querySelectorAll('#view details').forEach((details) => (details.open = true))"


def test_the_drawer_is_shut_in_a_low_window_and_opens_where_a_fault_lies(
    page: Page, server: str, answered: Answered
) -> None:
    page.set_viewport_size({"width": 320, "height": 225})
    page.goto(f"{server}/explorer")
    answered(page)
    drawer, speed = page.locator("button.drawer"), page.locator("[data-field=pitch_speed_mph] input[type=number]")
    expect(drawer).to_have_attribute("aria-expanded", "false")
    expect(speed).to_be_hidden()
    drawer.focus()
    page.keyboard.press("Tab")
    assert not page.evaluate("document.activeElement.closest('.side')")  # what is shut is not reached
    drawer.focus()
    page.keyboard.press("Enter")
    expect(drawer).to_have_attribute("aria-expanded", "true")
    expect(speed).to_be_visible()
    drawer.press("Enter")
    page.goto(f"{server}/explorer?pitch_speed_mph=999")
    answered(page)
    expect(drawer).to_have_attribute("aria-expanded", "true")
    expect(page.locator("[data-field=pitch_speed_mph] .fault")).to_contain_text("125")


def test_a_drawer_that_nobody_shut_opens_when_there_is_room(page: Page, server: str, answered: Answered) -> None:
    page.set_viewport_size({"width": 560, "height": 360})
    page.goto(f"{server}/explorer")
    answered(page)
    drawer = page.locator("button.drawer")
    expect(drawer).to_have_attribute("aria-expanded", "false")
    page.set_viewport_size({"width": 360, "height": 800})
    expect(drawer).to_have_attribute("aria-expanded", "true")
    drawer.click()
    page.set_viewport_size({"width": 560, "height": 700})
    expect(drawer).to_have_attribute("aria-expanded", "false")  # shut by somebody


def test_a_telephone_on_its_side_has_its_controls_beside_the_picture(page: Page, server: str, settled: Wait) -> None:
    page.set_viewport_size({"width": 844, "height": 390})
    page.goto(f"{server}/explorer")
    settled(page)
    speed, picture = page.locator("[data-field=pitch_speed_mph]"), page.locator("#view canvas").first
    expect(speed).to_be_in_viewport()
    right, left = picture.bounding_box(), speed.bounding_box()
    assert right is not None and left is not None
    assert right["x"] + right["width"] <= left["x"] and right["y"] < 0.5 * 390


def test_a_low_window_shows_the_picture_first(page: Page, server: str, settled: Wait) -> None:
    """A telephone on its side, and a page at 400 %: what is not a picture is below it, and nothing lies over it."""
    for width, height in ((844, 390), (360, 225)):
        page.set_viewport_size({"width": width, "height": height})
        for view in (
            "",
            "explorer",
            "hit",
            "modes",
            "own",
            "compare",
            "design",
            "player",
            "flight",
            "optimum",
            "sports",
        ):
            page.goto(f"{server}/{view}")
            settled(page)
            part = page.evaluate("""() => Math.max(...[...document.querySelectorAll("#view canvas")].map((canvas) => {
              const { left, top, bottom, width } = canvas.getBoundingClientRect();
              const end = Math.min(bottom, innerHeight) - 4;
              const shown = end > top && document.elementFromPoint(left + width / 2, end) === canvas ? end - top : 0;
              return shown / Math.min(bottom - top - 4, 0.3 * innerHeight); // all of it, or a good part
            }))""")
            assert part >= 1, f"{view or 'start'} at {width} x {height}: {part} of what a picture should show"


def test_the_wizard_by_keyboard_on_a_small_screen(page: Page, server: str, answered: Answered) -> None:
    page.set_viewport_size({"width": 320, "height": 480})
    page.goto(f"{server}/explorer")
    answered(page)
    page.locator("#bench-chip").focus()
    page.keyboard.press("Enter")
    page.get_by_role("button", name="Describe yours").focus()
    page.keyboard.press("Enter")
    expect(page.locator("#wizard-sport")).to_be_focused()
    assert page.evaluate(OUTSIDE) == []
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    expect(page.locator("#wizard-name")).to_be_focused()
    page.keyboard.type("Typed")
    page.locator("#wizard-length_in").fill("90")
    put = page.get_by_role("button", name="Put it on the bench")
    put.focus()
    page.keyboard.press("Enter")
    expect(page.locator("#wizard-length_in")).to_be_focused()  # where the refusal stands
    expect(page.locator("#wizard-length_in-fault")).to_be_in_viewport()
    page.keyboard.press("Control+a")
    page.keyboard.type("33.5")
    put.focus()
    page.keyboard.press("Enter")
    expect(page.locator("dialog")).to_have_count(0)
    expect(page.locator("#bench-name")).to_be_focused()  # with what was assumed
    expect(page.locator("#bench-chip")).to_contain_text("Typed")


def test_an_own_bat_is_measured_by_keyboard(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/own")
    count = answered(page)
    page.get_by_role("slider", name="It weighs").focus()
    page.keyboard.press("ArrowRight")
    count = answered(page, count)
    expect(page.get_by_role("row", name="mass").first).to_be_visible()
    leave = page.get_by_role("button", name="Leave out: mass")
    leave.focus()
    page.keyboard.press("Enter")
    answered(page, count)
    expect(leave).to_have_count(0)


def test_the_workshop_tells_a_weight_in_the_reader_s_units(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer?bat=single-wall&mass_oz=31.5")
    answered(page)
    bench(page).locator("summary", has_text="Workshop").click()
    line = page.locator(".note", has_text="Its weight")
    expect(line).to_contain_text("31.5 oz")
    expect(line).not_to_contain_text(re.compile(r"\d g"))
    page.get_by_role("radio", name="SI", exact=True).check()
    expect(line).to_contain_text("893 g")
    expect(line).not_to_contain_text("oz")


def test_a_thin_plate_is_told_in_the_reader_s_units(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/paper?question=drop")
    answered(page)
    plate = page.locator("#view")
    expect(plate).to_contain_text("0.12 in")  # 3 mm
    expect(plate).not_to_contain_text("3 mm")
    page.get_by_role("radio", name="SI", exact=True).check()
    expect(plate).not_to_contain_text("0.12 in")


def test_a_table_without_room_keeps_words_whole_and_bars_true(page: Page, server: str, answered: Answered) -> None:
    """Exact: a bar of 30 blocks is twice as long as one of 15, and no cell is wider than the box."""
    page.set_viewport_size({"width": 360, "height": 740})
    page.goto(f"{server}/explorer")
    answered(page)
    widths = page.evaluate(
        """async () => {
          const { tableOf } = await import("/static/controls/parts.js");
          const row = (name, count) => [name, "45.0° to left field", "█".repeat(count), "1.0 ± 0.2 mph"];
          const rows = [row("the first one of them", 30), row("two", 15)];
          const box = tableOf("Parks", ["park", "towards", "", "speed"], rows);
          document.querySelector("#view .stack, #view .picture").append(box);
          await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
          const range = document.createRange();
          const bars = [...box.querySelectorAll(".bars")].map((cell) => {
            range.selectNodeContents(cell);
            return [range.getBoundingClientRect().width, cell.clientWidth];
          });
          const lines = [...box.querySelectorAll("td[data-label=towards], td[data-label=speed]")].map((cell) => {
            range.selectNodeContents(cell);
            return range.getClientRects().length;
          });
          const apart = box.querySelector("table").matches(".apart");
          const headed = tableOf("Blows", ["place (in)", "Impulse, N s"], [["1.0", "7.12"]]);
          const unit = headed.querySelectorAll("th")[1].textContent;
          return { bars, lines, apart, over: box.scrollWidth - box.clientWidth, unit };
        }"""
    )
    (long, room), (short, _) = widths["bars"]
    assert widths["apart"] and widths["over"] <= 0
    assert long == pytest.approx(2 * short, rel=0.02) and long <= room
    assert widths["lines"] == [1, 1, 1, 1]
    assert widths["unit"] == "Impulse, N\u00a0s", "no line breaks a unit of two words"


def test_a_scrolled_table_ends_with_a_whole_row(page: Page, server: str, settled: Wait) -> None:
    page.goto(f"{server}/explorer")
    settled(page)
    page.evaluate(OPEN)
    bench(page).locator("summary", has_text="Draw the outline").click()
    expect(page.locator("#bench .stations tbody tr").first).to_be_visible()
    for width in (1280, 390):
        page.set_viewport_size({"width": width, "height": 844})
        settled(page)
        cut = page.evaluate(
            """() => [...document.querySelectorAll("#view .numbers .scroll, #bench .stations")].filter((box) => {
              const end = box.getBoundingClientRect().bottom;
              return box.scrollHeight > box.clientHeight + 1 && ![...box.querySelectorAll("tbody tr")]
                .some((row) => Math.abs(row.getBoundingClientRect().bottom - end) < 2);
            }).map((box) => box.className + box.textContent.slice(0, 40))"""
        )
        assert cut == []
        assert page.locator("#bench .stations").evaluate("(box) => box.scrollHeight > box.clientHeight + 1")
