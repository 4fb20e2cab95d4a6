"""Season in a browser: a table is chosen or dropped, read in a job, mapped, chosen from by hand and keyboard."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from tests.web.parts import Answered, Wait, choose

READ = re.compile(r"\d balls in play: ")  # before, the sentence asks for tables of balls in play
DROPPED = """([name, text]) => {
  const data = new DataTransfer();
  data.items.add(new File([text], name));
  document.getElementById("view").dispatchEvent(new DragEvent("drop",
    { dataTransfer: data, bubbles: true, cancelable: true }));
}"""


@pytest.fixture(scope="module")
def address(visitor: BrowserContext, server: str, balls: Path) -> str:
    """The address of a small season that was handed in on a page and read, which takes long."""
    page = visitor.new_page()
    page.goto(f"{server}/season")
    expect(page.locator("#verdict")).to_contain_text("Hand in tables")
    page.locator("#season-files").set_input_files(balls)
    expect(page.locator("#verdict")).to_contain_text(READ)
    expect(page.get_by_role("status").filter(has_text="rows of my balls.csv")).to_be_visible()
    expect(page).to_have_url(re.compile("season="))
    read = page.url
    page.close()
    return read


@pytest.fixture
def read(page: Page, address: str) -> Page:
    """A page on which a small season was read."""
    page.goto(address)
    expect(page.locator("#verdict")).to_contain_text(READ)
    return page


def test_a_table_is_read_chosen_from_taken_away_and_read_with_another_bat(
    read: Page, answered: Answered, settled: Wait, narrow: Wait
) -> None:
    page = read
    expect(page.get_by_role("status").filter(has_text="rows of my balls.csv")).to_be_visible()
    settled(page)
    for words in ("This map as a table", "These curves as a table", "These balls as a table"):
        page.locator("summary", has_text=words).click()
    for table in page.locator(".numbers:visible").all():
        expect(table.locator("tbody td").first).to_be_visible()
    mapped = page.get_by_role("img", name=re.compile(r"^Where on the barrel \d+ balls"))
    said = re.search(r"barrel (\d+) balls", mapped.get_attribute("aria-label") or "")
    cells = page.get_by_role("region", name=re.compile("^Where on the barrel")).locator("tbody td").all_inner_texts()
    assert said is not None and sum(int(cell) for cell in cells if cell.isdigit()) == int(said[1]), (
        "every ball is there"
    )
    whole = page.locator("#verdict").inner_text()
    month = page.locator("#season-month")
    month.select_option(index=1)
    expect(page.locator("#verdict")).not_to_have_text(whole)
    page.get_by_role("button", name="All balls again").click()
    expect(page.locator("#verdict")).to_have_text(whole)
    page.locator("#season-park").select_option("Coors Field")
    expect(page.get_by_text("the fence is that of Coors Field")).to_be_visible()
    page.locator("summary", has_text="Fence on the field").click()
    page.locator("[data-field=fence] select").select_option("wrigley-field")
    expect(page.get_by_text("the fence is that of Wrigley Field")).to_be_visible()
    page.locator("[data-field=fence] select").select_option("")
    page.get_by_role("button", name="All balls again").click()
    expect(page.get_by_text("the fence is that of Fenway Park")).to_be_visible()
    page.locator("#season-search").fill("600003")
    name = page.get_by_role("button", name="600003")
    name.focus()
    page.keyboard.press("Enter")
    expect(page.locator("#verdict")).to_contain_text("of player 600003")
    expect(page.locator(".document h2", has_text="600003")).to_be_visible()
    assert "batter=600003" in page.url
    with page.expect_download() as saved:
        page.get_by_role("link", name="players.csv").click()
    assert saved.value.path().read_text(encoding="utf-8").startswith("batter,balls,ev20_mph")
    page.get_by_role("radio", name="SI", exact=True).check()
    expect(page.locator("#verdict")).to_contain_text("m/s")
    settled(page)
    assert "mph" not in page.locator(".stack").inner_text().replace("_mph", "")
    page.get_by_role("button", name="Design a bat for this player").click()
    expect(page).to_have_url(re.compile(r"/design\?.*contact_in="))
    expect(page.locator("#verdict")).to_contain_text("This is the present bat still")
    settled(page)
    page.go_back()
    expect(page.locator("#verdict")).to_contain_text("of player 600003")
    settled(page)
    narrow(page)
    page.reload()  # the address holds it
    expect(page.locator("#verdict")).to_contain_text("of player 600003")
    page.set_viewport_size({"width": 1280, "height": 900})
    count = answered(page)
    choose(page, "mlb-a")
    answered(page, count)
    page.get_by_role("button", name="Read again with this bat").click()
    expect(page.get_by_role("button", name="Read again with this bat")).to_be_hidden()
    expect(page.locator("#verdict")).to_contain_text("squared up against MLB")


def test_a_reading_outlives_a_server_that_is_silent_and_a_reload(
    page: Page, server: str, answered: Answered, balls: Path
) -> None:
    page.goto(f"{server}/season")
    answered(page)
    silent = f"{server}/api/v1/jobs/*"
    page.route(silent, lambda route: route.abort("connectionrefused"))
    page.locator("#season-files").set_input_files(balls)
    expect(page.locator("#view [role=alert]:visible")).to_contain_text("The server does not answer")
    page.reload()
    expect(page.locator("#view [role=alert]:visible")).to_contain_text("The server does not answer")
    page.unroute(silent)
    expect(page.locator("#verdict")).to_contain_text(READ)
    expect(page.get_by_role("status").filter(has_text="rows of my balls.csv")).to_be_visible()
    expect(page.locator("#view [role=alert]:visible")).to_have_count(0)
    assert "uploads=" in page.url and page.evaluate("sessionStorage.length") == 0


def test_a_bad_table_leaves_what_was_read(read: Page, settled: Wait) -> None:
    page = read
    settled(page)
    whole, address = page.locator("#verdict").inner_text(), page.url
    fault: Any = page.locator("#view [role=alert]:visible")
    page.evaluate(DROPPED, ["nothing.csv", ""])
    expect(fault).to_have_text("nothing.csv is empty; save it anew, or leave it out.")
    page.evaluate(DROPPED, ["my words.csv", "exit_speed_mph,launch_angle_deg\nfast,high\n"])
    expect(fault).to_contain_text("my words.csv: none of 1 rows")
    expect(page.get_by_role("status").filter(has_text="rows of my balls.csv")).to_be_visible()
    assert (page.locator("#verdict").inner_text(), page.url) == (whole, address)
    rows = "".join(f"{90 + number},{10 + number},7\n" for number in range(12))
    page.evaluate(DROPPED, ["no bats.csv", f"exit_speed_mph,launch_angle_deg,batter\n{rows}"])
    expect(page.locator("#verdict")).to_contain_text("12 balls in play: ")
    expect(page.get_by_text("These tables have no bat speeds, so nothing is said of bats.")).to_be_visible()
    settled(page)
    told = page.locator(".facts > div:visible dt").all_inner_texts()
    assert told[:2] == ["Balls", "Exit speed"] and not {"Bat speed", "From the best place"} & set(told)
    page.get_by_role("button", name="7", exact=True).click()
    expect(page.locator(".document h2", has_text="Player 7")).to_be_visible()
    expect(page.get_by_role("button", name="Design a bat for this player")).to_be_hidden()


def test_a_bad_table_beside_a_good_one_is_told_at_the_top(
    page: Page, server: str, answered: Answered, tmp_path: Path
) -> None:
    page.goto(f"{server}/season")
    answered(page)
    rows = "".join(f"{90 + number},{10 + number}\n" for number in range(12))
    tables = [("few.csv", f"exit_speed_mph,launch_angle_deg\n{rows}"), ("shopping.csv", "milk,eggs\n1,2\n")]
    for name, text in tables:
        (tmp_path / name).write_text(text, encoding="utf-8")
    page.locator("#season-files").set_input_files([tmp_path / name for name, _ in tables])
    expect(page.locator("#verdict")).to_contain_text("12 balls in play: ")
    expect(page.get_by_text("12 rows of few.csv.")).to_be_visible()
    top = page.locator("section").filter(has=page.locator("#verdict"))
    expect(top.get_by_text("Not read: shopping.csv: no column for exit speed")).to_be_visible()
    facts = page.locator(".facts > div:visible dt")
    expect(facts).to_have_text(["Balls", "Exit speed", "Hardest fifth (EV20)"])  # nothing flies without a direction


def test_what_is_no_table_is_told_in_one_line(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/season")
    answered(page)
    page.evaluate(DROPPED, ["nothing.csv", ""])
    fault: Any = page.locator("#view [role=alert]:visible")
    expect(fault).to_have_text("nothing.csv is empty; save it anew, or leave it out.")
    page.evaluate(DROPPED, ["bat.toml", "name ="])
    expect(page.locator("dialog")).to_contain_text("bat.toml")  # a bat's file still goes to the bench
    page.locator("dialog").get_by_role("button", name="Close").click()
    page.goto(f"{server}/season?season={'A' * 16}")
    expect(page.locator("#view [role=alert]:visible")).to_contain_text("hand them in again")
