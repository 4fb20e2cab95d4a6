"""Own bat in a browser: measured by sliders and by taps, from a file and from a microphone, and put on the bench."""

from __future__ import annotations

from pathlib import Path

import soundfile
from playwright.sync_api import Browser, Page, expect

from sweetspot import catalog
from sweetspot.calibration.recording import recording_bytes, synthesised
from sweetspot.calibration.tap_analysis import modes_to_name
from tests import browsers
from tests.web.parts import Answered, choose, visit


def test_a_bat_is_weighed_tapped_and_carried_to_other_views(
    page: Page, server: str, answered: Answered, taps: Path
) -> None:
    page.goto(f"{server}/own?balanced_in=22.05&pendulum_ms=1454.5")
    count = answered(page)
    weight = page.locator("[data-field=weighed_oz] input[type=number]")
    expect(weight).to_have_value("")  # what the bat as described weighs is not passed off as measured
    expect(page.get_by_label("It weighs").first).to_have_attribute("aria-valuetext", "not measured")
    expect(page.locator("[data-field=weighed_error_oz]")).to_be_hidden()
    weight.fill("31")
    weight.press("Tab")
    count = answered(page, count)
    expect(page.locator("[data-field=weighed_error_oz] input[type=number]")).to_have_value("0.08")  # 90 %
    expect(page.get_by_role("row", name="mass").first).to_contain_text("31.00 oz ± 0.08 oz")
    assert "--" not in page.locator(".stack").inner_text()  # options of the command line
    weight.fill("")
    weight.press("Tab")
    count = answered(page, count)
    assert "weighed_oz" not in page.url
    weight.fill("31")
    weight.press("Tab")
    answered(page, count)
    expect(page.locator("#verdict")).to_contain_text("The measurements agree")
    page.locator("#tap-file").set_input_files(taps)
    expect(page.locator(".lights .pass").filter(has_text="used")).to_have_count(2)
    expect(page.locator(".lights .fail").first).to_contain_text("doubled")
    expect(page.get_by_role("row", name="bending 1").filter(has_text="its own")).to_contain_text("Hz")
    expect(page.get_by_role("button", name="Leave out: bending 1")).to_be_visible()
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench-chip")).to_contain_text("calibrated")
    visit(page, "explorer")
    expect(page.locator("#verdict")).to_contain_text("calibrated hits fastest")


def test_a_bad_sound_is_told_and_costs_no_good_tap(
    page: Page, server: str, answered: Answered, taps: Path, tmp_path: Path
) -> None:
    page.goto(f"{server}/own")
    answered(page)
    page.locator("#tap-file").set_input_files(taps)
    used = page.locator(".lights .pass").filter(has_text="used")
    expect(used).to_have_count(2)
    bad = {"silence.wav": b"", "words.wav": b"no sound at all"}
    for name, content in bad.items():
        (tmp_path / name).write_bytes(content)
    page.locator("#tap-file").set_input_files([tmp_path / name for name in bad])
    fault = page.locator("#view [role=alert]:visible")
    expect(fault).to_contain_text("silence.wav is empty")
    expect(fault).to_contain_text("words.wav cannot be read as a sound")
    expect(page.get_by_text("1 recording.")).to_be_visible()  # the good one
    expect(used).to_have_count(2)
    page.reload()
    expect(used).to_have_count(2)
    page.get_by_role("button", name="Forget the taps").click()
    page.reload()
    answered(page)
    expect(page.get_by_role("button", name="Forget the taps")).to_be_disabled()
    assert "tones" not in page.url


def test_a_contradiction_stands_in_words_and_is_left_out(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/own?weighed_oz=31&balanced_in=23.05&pendulum_ms=1454.5")
    answered(page)
    expect(page.locator(".against")).to_contain_text("balance point lies")
    expect(page.get_by_role("button", name="Put it on the bench")).to_be_disabled()
    expect(page.get_by_role("columnheader", name="the fitted bat")).to_have_count(0)
    expect(page.get_by_text("Nothing is reported of the bat")).to_be_visible()
    page.get_by_role("button", name="Leave out: balance point").click()
    expect(page.locator(".against")).to_be_hidden()
    expect(page.locator("#verdict")).to_contain_text("The measurements agree")
    expect(page.get_by_role("columnheader", name="the fitted bat")).to_be_visible()


def test_what_is_wrong_stands_beside_its_field(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/own?weighed_oz=31&balanced_in=23.05&pendulum_ms=1454.5")
    count = answered(page)
    beside = page.locator(".side .contradicts:visible")
    expect(beside).to_have_count(1)
    expect(beside).to_contain_text("5.1 sigma off. By all the others it should be 21.89 in")
    choose(page, "mlb-a")
    answered(page, count)
    page.goto(f'{server}/own?weighed_oz=31&balanced_in=22.05&tones=[["bending-2",171.3,0.4]]')
    answered(page)
    page.get_by_role("button", name="It is bending 1").click()
    expect(page.locator(".against")).to_be_hidden()
    expect(page.get_by_role("row", name="bending 1").first).to_contain_text("171.3 Hz")
    page.goto(f"{server}/own?pendulum_ms=1e999")
    answered(page)
    expect(page.locator("[data-field=pendulum_ms] .fault")).to_be_visible()


def test_a_racket_goes_the_same_way_and_is_hit_with(page: Page, server: str, answered: Answered, taps: Path) -> None:
    page.goto(f"{server}/own?weighed_oz=31&units=si")
    count = answered(page)
    page.locator("#tap-file").set_input_files(taps)
    expect(page.get_by_text("1 recording.")).to_be_visible()
    count = answered(page, count)
    page.get_by_label("It is").select_option("tennis-racket")
    expect(page.locator("#verdict")).to_contain_text("As described, not measured: 318 g")
    expect(page.get_by_text("1 recording.")).to_have_count(0)  # it was of the bat
    expect(page.locator("#bench-chip")).to_contain_text("Tennis racket")
    for field, value in (("weighed_oz", "322"), ("swing_weight_oz_in2", "316")):
        count = int(page.locator("#view").get_attribute("data-answered") or 0)
        number = page.locator(f"[data-field={field}] input[type=number]")
        number.fill(value)
        number.press("Tab")
        answered(page, count)
    expect(page.locator("#verdict")).to_contain_text("The measurements agree. 322.0 ± 2.3 g")
    expect(page.get_by_role("row", name="swing weight about 10 cm from the butt end")).to_be_visible()
    page.get_by_role("button", name="Hit with it in Every sport").click()
    expect(page.locator("#verdict")).to_contain_text("calibrated hits fastest")
    page.get_by_role("button", name="Weigh, balance and tap it").click()
    expect(page.locator("#verdict")).to_contain_text("As described, not measured: 322 g")


def test_taps_get_the_names_that_a_better_description_has(
    page: Page, server: str, answered: Answered, tmp_path: Path
) -> None:
    """Whoever taps first and then says what was tapped need not tap again."""
    alloy = catalog.bat("college-alloy")
    place = alloy.length - 0.0254
    path = tmp_path / "alloy.wav"
    path.write_bytes(recording_bytes(synthesised(modes_to_name(alloy), position=place, listened=place, taps=1), path))
    page.goto(f"{server}/own")
    answered(page)
    page.locator("#tap-file").set_input_files(path)
    expect(page.locator("#view .fault:visible")).to_contain_text("hardly")
    assert "tones" not in page.url
    choose(page, "college-alloy")
    expect(page.get_by_role("button", name="Leave out: bending 1")).to_be_visible()
    expect(page.locator("#verdict")).to_contain_text("The measurements agree")
    page.keyboard.press("Control+z")
    expect(page.get_by_text("These tones do not count now")).to_be_visible()
    page.get_by_role("button", name="Count them").click()
    expect(page.get_by_role("button", name="Leave out: bending 1")).to_be_visible()


def test_what_was_measured_stays_with_the_bat_in_hand_and_the_page_says_so(
    page: Page, server: str, answered: Answered
) -> None:
    page.goto(f"{server}/own?weighed_oz=31")
    answered(page)
    expect(page.locator("#moved")).to_be_hidden()
    choose(page, "mlb-a")
    expect(page.locator("#moved")).to_contain_text("Measured while the bat was described as R161")
    expect(page.get_by_role("row", name="mass").first).to_contain_text("31.00 oz")
    page.get_by_role("button", name="Forget what was measured").click()
    expect(page.locator("#moved")).to_be_hidden()


def test_the_microphone_freezes_on_a_tap(browser: Browser, server: str, taps: Path, tmp_path: Path) -> None:
    samples, rate = soundfile.read(taps)
    heard = tmp_path / "heard.wav"
    soundfile.write(heard, samples, rate, subtype="PCM_16")  # all that the pretended microphone understands
    flags = ["--no-sandbox", "--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream",
             f"--use-file-for-fake-audio-capture={heard}"]  # fmt: skip
    listening = browser.browser_type.launch(executable_path=browsers.for_tests(), args=flags)
    try:
        page = listening.new_page()
        page.goto(f"{server}/own")
        page.get_by_role("button", name="Listen").click()
        expect(page.locator(".lights li").filter(has_text="tap 1.wav").first).to_be_visible()
        page.get_by_role("button", name="Stop listening").click()
        expect(page.get_by_role("button", name="Listen", exact=True)).to_be_visible()
    finally:
        listening.close()


def test_a_microphone_that_is_not_allowed_is_told(browser: Browser, server: str, answered: Answered) -> None:
    """A browser that nobody answers refuses the microphone that it has."""
    flags = ["--no-sandbox", "--use-fake-device-for-media-stream"]
    refusing = browser.browser_type.launch(executable_path=browsers.for_tests(), args=flags)
    try:
        page = refusing.new_page()
        page.goto(f"{server}/own")
        answered(page)
        page.get_by_role("button", name="Listen", exact=True).click()
        expect(page.get_by_text("The microphone was not allowed; allow it beside the address")).to_be_visible()
        expect(page.get_by_role("button", name="Listen", exact=True)).to_be_enabled()
    finally:
        refusing.close()
