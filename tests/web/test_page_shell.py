"""What every view has from the page around it: address, back button, units, theme, guide, and a lost connection."""

from __future__ import annotations

import json
import re
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from urllib.parse import quote

import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from sweetspot.web.bundle import LATER
from sweetspot.web.run_server import listening, server_for
from sweetspot.web.views import GROUPS
from tests.web.parts import Answered, Until, Wait, visit


def field(page: Page, name: str) -> Any:
    return page.locator(f"[data-field={name}] input[type=number]")


def test_the_address_is_the_state(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer?bat=youth-30&pitch_speed_mph=61.5&no_such=1")
    answered(page)
    expect(page.locator("#verdict")).to_contain_text("Youth 30 in")
    assert field(page, "pitch_speed_mph").input_value() == "61.5"


def test_back_and_forward(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    for speed in ("80", "85"):
        field(page, "pitch_speed_mph").fill(speed)
        field(page, "pitch_speed_mph").press("Enter")
        count = answered(page, count)
    page.go_back()
    answered(page, count)
    assert field(page, "pitch_speed_mph").input_value() == "80"
    page.go_back()
    expect(page).to_have_url(f"{server}/explorer")
    page.go_forward()
    expect(page).to_have_url(re.compile("pitch_speed_mph=80"))


def test_a_wrong_address_is_explained(page: Page, server: str) -> None:
    page.goto(f"{server}/explorer?bat=no-such-bat")
    expect(page.locator("[data-field=bat] .fault")).to_contain_text("not in the catalogue")
    page.goto(f"{server}/explorer?pitch_speed_mph=NaN")
    expect(page.locator("[data-field=pitch_speed_mph] .fault")).to_contain_text("finite number")


def test_units_switch_everywhere(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    page.get_by_role("radio", name="SI", exact=True).check()
    expect(page.locator("#verdict")).to_contain_text("m/s")
    assert field(page, "pitch_speed_mph").input_value() == "40.2"
    assert "mph" not in page.locator("#view").inner_text()
    field(page, "pitch_speed_mph").fill("40")
    field(page, "pitch_speed_mph").press("Enter")
    expect(page).to_have_url(re.compile(r"pitch_speed_mph=89\.477"))
    page.reload()
    answered(page)
    expect(page.locator("#verdict")).to_contain_text("m/s")  # remembered


def test_light_and_dark(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    ground = "getComputedStyle(document.documentElement).backgroundColor"
    light, drawn = page.evaluate(ground), page.locator("#view canvas:visible").first.screenshot()
    page.locator("#theme").click()
    assert page.evaluate(ground) != light
    assert page.locator("#view canvas:visible").first.screenshot() != drawn
    page.reload()
    answered(page)
    assert page.evaluate(ground) != light  # remembered


def test_paper_is_white(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/modes")
    answered(page)
    page.get_by_role("button", name="Dark", exact=True).click()
    colours = []
    for event in ("resize", "beforeprint", "afterprint"):
        page.evaluate(f"dispatchEvent(new Event('{event}'))")
        colours.append(page.evaluate("getComputedStyle(document.body).color"))
    assert colours[0] == colours[2] != colours[1]


def test_a_printed_sheet_says_its_conditions_and_all_its_numbers(page: Page, server: str, until: Until) -> None:
    page.goto(f"{server}/hit?pitch_speed_mph=81")
    page.get_by_role("button", name="Pause").wait_for()  # printed while the film plays
    foot = "document.querySelector('#view > p.note')?.textContent ?? ''"
    printing = "dispatchEvent(new Event('beforeprint'))"
    until(page, f"({printing}, {foot}.includes('pitch 81.0 mph'))")  # what puts it there comes after the picture
    empty = "[...document.querySelectorAll('.ledger dd')].filter((value) => !value.textContent)"
    assert page.evaluate(f"dispatchEvent(new Event('afterprint')), {printing}, {empty}.length") == 0
    assert page.evaluate(f"dispatchEvent(new Event('afterprint')), {foot}") == ""


def test_nothing_lies_over_the_picture_until_it_is_asked_for(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    expect(page.locator("dialog")).to_have_count(0)
    page.get_by_role("button", name="Guide").click()
    for step in (1, 2, 3):
        expect(page.locator("dialog")).to_contain_text(f"Step {step} of 3")
        page.locator("dialog .next").click()
    expect(page.locator("dialog")).to_have_count(0)


def test_the_bar_has_four_groups_and_remembers_what_was_seen_of_each(page: Page, server: str) -> None:
    page.goto(f"{server}/compare?pitch_speed_mph=81")
    expect(page.locator("#groups a")).to_have_text(list(GROUPS))
    expect(page.locator("#views a:visible")).to_have_text([view.VIEW.title for view in GROUPS["Which bat"]])
    visit(page, "design")
    visit(page, "flight")
    page.locator("#groups a", has_text="Which bat").click()
    expect(page.locator("#view")).to_have_attribute("data-view", "design")
    page.locator(".brand").click()
    expect(page.locator("#view")).to_have_attribute("data-view", "start")
    expect(page.locator("#views")).to_be_hidden()
    expect(page.locator(".brand")).to_have_attribute("aria-current", "page")


@contextmanager
def serving(port: int = 0) -> Iterator[int]:
    """A server of one's own for a while, and its port."""
    opened = listening("127.0.0.1", port)
    server = server_for()
    thread = threading.Thread(target=server.run, kwargs={"sockets": [opened]}, daemon=True)
    thread.start()
    try:
        yield opened.getsockname()[1]
    finally:
        server.should_exit = True
        thread.join(60)


def test_a_lost_connection_is_shown_and_comes_back(page: Page, answered: Answered) -> None:
    with serving() as port:
        page.goto(f"http://127.0.0.1:{port}/explorer")
        count = answered(page)
    expect(page.locator("#status")).to_contain_text("connection to the server is lost")
    field(page, "pitch_speed_mph").fill("70")  # asked while nobody listens
    field(page, "pitch_speed_mph").press("Enter")
    with serving(port):
        expect(page.locator("#status")).to_be_hidden()
        answered(page, count)
        assert field(page, "pitch_speed_mph").input_value() == "70"


def test_a_view_opened_without_a_server_says_so_and_comes_with_it(
    page: Page, answered: Answered, settled: Wait
) -> None:
    with serving() as port:
        page.goto(f"http://127.0.0.1:{port}/explorer?bat=youth-30")
        settled(page)
        page.wait_for_load_state("networkidle")  # the files of the other views too
    expect(page.locator("#status")).to_contain_text("connection to the server is lost")
    page.locator("#groups a", has_text="The ball").click()
    expect(page.locator("#view .absent")).to_contain_text("Flight needs the server")
    expect(page.locator("#view :is(.side, .picture:not(.absent)):visible")).to_have_count(0)
    page.locator("#bench-chip").click()
    page.get_by_role("button", name="Describe yours").click()
    expect(page.locator("dialog")).to_contain_text("The server does not answer")
    page.locator("dialog").get_by_role("button", name="Close").click()
    with serving(port):
        expect(page.locator("#status")).to_be_hidden()
        answered(page)
        expect(page.locator("#view .absent")).to_have_count(0)
        expect(page.locator("#bench-chip")).to_contain_text("Youth 30 in")
        expect(page.locator("[data-field=park] option")).not_to_have_count(1)  # the lists too
        expect(page.locator("#view canvas:visible").first).to_be_visible()
        settled(page)


def test_a_view_whose_file_did_not_come_comes_once_it_can(
    page: Page, server: str, answered: Answered, settled: Wait
) -> None:
    """The line to the server stays open all the while, so nothing but another try can bring it."""
    page.route(f"**/static/{LATER}*", lambda route: route.abort("connectionrefused"))
    page.goto(server)
    answered(page)
    page.locator("#groups a", has_text="Which bat").click()
    expect(page.locator("#view .absent")).to_contain_text("Compare needs the server")
    page.locator("#groups a", has_text="The ball").click()
    expect(page.locator("#view .absent")).to_contain_text("Flight needs the server")
    page.unroute(f"**/static/{LATER}*")
    expect(page.locator("#view[data-view=flight] canvas:visible").first).to_be_visible()
    expect(page.locator("#view .absent")).to_have_count(0)
    expect(page.locator("#status")).to_be_hidden()
    settled(page)


def test_the_first_picture_takes_few_requests_and_few_bytes(page: Page, server: str, settled: Wait) -> None:
    """At most twelve, and 120 kB; and nothing comes from anywhere else."""
    wire = page.context.new_cdp_session(page)
    asked: dict[str, str] = {}
    carried: dict[str, float] = {}
    wire.on("Network.requestWillBeSent", lambda one: asked.update({one["requestId"]: one["request"]["url"]}))
    wire.on("Network.loadingFinished", lambda one: carried.update({asked[one["requestId"]]: one["encodedDataLength"]}))
    wire.send("Network.enable")
    page.goto(server)
    settled(page)
    assert all(address.startswith(server) for address in asked.values())
    assert 3 < len(asked) <= 12
    assert sum(size for address, size in carried.items() if not address.endswith(LATER)) < 120e3


def test_a_slider_of_a_place_from_the_tip_goes_as_the_picture_does(page: Page, server: str, answered: Answered) -> None:
    """The tip is on the right: to the right is nearer to it, by hand and by key."""
    page.goto(f"{server}/explorer")
    answered(page)
    range_ = page.locator("[data-field=impact_from_tip_in] input[type=range]")
    before = float(range_.input_value())
    range_.focus()
    range_.press("ArrowRight")
    assert float(range_.input_value()) < before
    box = range_.bounding_box()
    assert box is not None
    range_.click(position={"x": 0.9 * box["width"], "y": box["height"] / 2})
    assert float(range_.input_value()) < 0.2 * float(range_.get_attribute("max") or 0)


def test_what_is_being_typed_stays_when_an_answer_comes(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    speed = field(page, "pitch_speed_mph")
    speed.focus()
    speed.evaluate("""node => {
      const give = (value, event) => { node.value = value; node.dispatchEvent(new Event(event, { bubbles: true })); };
      give("80", "change");
      give("70", "input");
    }""")
    answered(page, count)
    expect(speed).to_have_value("70")


def test_undo_redo_and_reset(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    undo, redo = page.locator("#undo"), page.locator("#redo")
    expect(undo).to_be_disabled()
    for speed in ("80", "70"):
        field(page, "pitch_speed_mph").fill(speed)
        field(page, "pitch_speed_mph").press("Enter")
        expect(page).to_have_url(re.compile(f"pitch_speed_mph={speed}"))
    undo.click()
    expect(field(page, "pitch_speed_mph")).to_have_value("80")
    redo.click()
    expect(field(page, "pitch_speed_mph")).to_have_value("70")
    expect(redo).to_be_disabled()
    page.locator("#verdict").click()
    page.keyboard.press("Control+z")
    expect(field(page, "pitch_speed_mph")).to_have_value("80")
    page.get_by_role("button", name="Start this view anew").click()
    expect(field(page, "pitch_speed_mph")).to_have_value("90")


def test_links_that_others_open(page: Page, server: str, answered: Answered) -> None:
    """A short link holds all of a long state; the embedded picture has no controls and may stand in other pages."""
    text = bat_toml(catalog.bat("youth-30").replaced(name="Somebody's own"))
    long = f"{server}/explorer?pitch_speed_mph=61&bat_toml={quote(text)}"
    page.goto(long)
    answered(page)
    page.get_by_role("radio", name="SI", exact=True).check()
    page.locator("#share").click()
    short = page.get_by_label("Link to this picture").input_value()
    assert len(short) < len(long) / 2
    page.evaluate(
        "Object.defineProperty(navigator, 'clipboard', { value: undefined })"
    )  # as at an address of a network
    page.get_by_role("button", name="Copy to embed").click()
    expect(page.locator("dialog [role=status]")).to_contain_text("did not let it be copied")
    embedded = page.get_by_label("Link to this picture").input_value()
    assert "/embed/explorer?" in embedded and "units=si" in embedded
    page.evaluate("localStorage.setItem('units', 'us')")  # another reader's
    page.goto(short)
    answered(page)
    expect(page.locator("#bench-chip")).to_contain_text("Somebody's own")
    expect(page.locator("#verdict")).to_contain_text(" m/s")
    assert float(field(page, "pitch_speed_mph").input_value()) == pytest.approx(61 * 0.44704, abs=0.06)
    response = page.goto(f"{server}/embed/explorer?pitch_speed_mph=61")
    answered(page)
    assert response is not None
    assert "frame-ancestors *" in response.headers["content-security-policy"]
    expect(page.locator(".top")).to_be_hidden()
    expect(page.locator(".side")).to_be_hidden()
    expect(page.locator("#verdict")).to_be_visible()
    page.goto(f"{server}/explorer?s=broken")  # cut off on its way
    answered(page)


def test_an_address_stays_short_enough_to_be_sent(page: Page, server: str, answered: Answered) -> None:
    """Four own bats are 9 kB as they are; packed, the address itself can be copied, reloaded and opened elsewhere."""
    own = [bat_toml(catalog.bat("youth-30").replaced(name=f"Own bat {count}")) for count in range(4)]
    others = json.dumps([{"bat_toml": text} for text in own[1:]])
    long = f"{server}/compare?bat_toml={quote(own[0])}&others={quote(others)}"
    page.goto(long)
    answered(page)
    page.wait_for_url("**/compare?s=*")
    short = page.url
    assert len(short) < 2000 < len(long)
    page.locator("#views a[data-name=modes]").evaluate("(link) => link.click()")  # one step, not by its group
    answered(page)
    expect(page.locator("#view")).to_have_attribute("data-view", "modes")
    page.wait_for_url("**/modes?*")
    page.go_back()
    expect(page.locator("#view")).to_have_attribute("data-view", "compare")
    expect(page.locator("#view")).to_contain_text("Own bat 3")
    stranger = page.context.browser.new_context()  # type: ignore[union-attr]
    other = stranger.new_page()
    other.goto(short)
    for text in ("Own bat 0", "Own bat 3"):
        expect(other.locator("#view")).to_contain_text(text)
    page.get_by_role("button", name="Export").click()
    expect(page.locator("dialog")).to_contain_text(short)  # which holds all: nothing need be sent along
    expect(page.locator("dialog")).not_to_contain_text("too long")
    page.get_by_role("button", name="Close").click()
    page.locator("#share").click()
    page.evaluate("Object.defineProperty(navigator, 'clipboard', { value: undefined })")
    page.get_by_role("button", name="Copy to embed").click()
    frame = page.get_by_label("Link to this picture").input_value()
    assert "/embed/compare?s=" in frame and len(frame) < 2000
    stranger.close()


def test_nothing_is_kept_of_many_views(page: Page, server: str, answered: Answered) -> None:
    """Nodes and listeners stay flat while one goes from view to view."""
    page.goto(f"{server}/explorer")
    answered(page)
    measure = page.context.new_cdp_session(page)

    def rounds(count: int) -> dict[str, float]:
        for _ in range(count):
            for name in ("modes", "explorer", "flight"):
                visit(page, name)
                expect(page.locator("#view")).to_have_attribute("data-view", name)
                answered(page)
        measure.send("HeapProfiler.collectGarbage")
        return {one["name"]: one["value"] for one in measure.send("Performance.getMetrics")["metrics"]}

    measure.send("Performance.enable")
    first, later = rounds(2), rounds(6)
    for name in ("Nodes", "JSEventListeners"):
        assert later[name] < 1.25 * first[name] + 60, (name, first[name], later[name])


def test_an_address_that_names_no_control_says_so(page: Page, server: str, settled: Wait) -> None:
    page.goto(f"{server}/compare?bats=left&pitch_speed_mph=80&units=us")
    settled(page)
    said = page.locator("#unknown")
    expect(said).to_have_text("Compare has no control \u201cbats\u201d; that part of the address changes nothing.")
    page.locator("#views a", has_text="Design").click()
    settled(page)
    expect(said).to_be_hidden()


def test_paper_has_the_words_of_folds_but_no_tables_of_pictures(page: Page, server: str, settled: Wait) -> None:
    page.goto(f"{server}/explorer")
    settled(page)
    folds = ("What the report says", "These curves as a table", "How sure these numbers are")
    report, numbers, sure = (page.locator(f"#view details:has-text('{words}')").last for words in folds)
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    expect(report.locator("p").first).to_be_visible()
    expect(numbers).to_be_hidden()
    expect(sure).to_be_hidden()  # nobody has asked for it, so that nothing would stand under its heading
    page.emulate_media(media="null")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert report.get_attribute("open") is None
