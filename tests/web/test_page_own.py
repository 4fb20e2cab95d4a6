"""Own bat in a browser: measured by sliders and by taps, from a file and from a microphone, and put on the bench."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import soundfile
from playwright.sync_api import Browser, Page, expect

from tests import browsers

Answered = Callable[..., int]


def test_a_bat_is_weighed_tapped_and_carried_to_other_views(
    page: Page, server: str, answered: Answered, taps: Path
) -> None:
    page.goto(f"{server}/own?balanced_in=22.05&pendulum_ms=1454.5")
    count = answered(page)
    page.get_by_role("button", name="As shown").first.click()
    answered(page, count)
    expect(page.locator("#verdict")).to_contain_text("The measurements agree")
    page.locator("#tap-file").set_input_files(taps)
    expect(page.locator(".lights .pass").filter(has_text="used")).to_have_count(2)
    expect(page.locator(".lights .fail").first).to_contain_text("doubled")
    expect(page.get_by_role("row", name="bending 1").first).to_contain_text("Hz")
    expect(page.get_by_role("row", name="bending 1").first).to_contain_text("its own")
    expect(page.get_by_role("button", name="Leave out: bending 1")).to_be_visible()
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench-chip")).to_contain_text("calibrated")
    page.get_by_role("link", name="Explorer", exact=True).click()
    expect(page.locator("#verdict")).to_contain_text("calibrated hits fastest")


def test_a_contradiction_stands_in_words_and_is_left_out(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/own?weighed_oz=31&balanced_in=23.05&pendulum_ms=1454.5")
    answered(page)
    expect(page.locator(".against")).to_contain_text("balance point lies")
    expect(page.get_by_role("button", name="Put it on the bench")).to_be_disabled()
    page.get_by_role("button", name="Leave out: balance point").click()
    expect(page.locator(".against")).to_be_hidden()
    expect(page.locator("#verdict")).to_contain_text("The measurements agree")


def test_the_microphone_freezes_on_a_tap(browser: Browser, server: str, taps: Path, tmp_path: Path) -> None:
    samples, rate = soundfile.read(taps)
    heard = tmp_path / "heard.wav"
    soundfile.write(heard, samples, rate, subtype="PCM_16")  # all that the pretended microphone understands
    flags = ["--no-sandbox", "--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream",
             f"--use-file-for-fake-audio-capture={heard}"]  # fmt: skip
    listening = browser.browser_type.launch(executable_path=browsers.for_tests(), args=flags)
    try:
        page = listening.new_page()
        page.add_init_script("localStorage.setItem('guided', 'yes')")
        page.goto(f"{server}/own")
        page.get_by_role("button", name="Listen").click()
        expect(page.locator(".lights li").filter(has_text="tap 1.wav").first).to_be_visible()
        page.get_by_role("button", name="Stop listening").click()
        expect(page.get_by_role("button", name="Listen", exact=True)).to_be_visible()
    finally:
        listening.close()
