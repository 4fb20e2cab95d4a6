"""The slow-motion view in a real browser: each item by what a person sees of it."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.web.parts import Answered, Until, visit

SIDE = 0


def picture(page: Page, index: int) -> str:
    """The pixels of one canvas as text."""
    return str(page.evaluate(f"document.querySelectorAll('.picture canvas')[{index}].toDataURL()"))


def barrel(page: Page) -> str:
    """The pixels of the end view's lower part, where no ball comes."""
    return str(
        page.evaluate(
            "(() => { const canvas = document.querySelectorAll('.picture canvas')[1]; const tall = canvas.height; "
            "const data = canvas.getContext('2d').getImageData(0, 0.62 * tall, canvas.width, 0.26 * tall).data; "
            "return Array.from(data).join(',') })()"
        )
    )


def moment(page: Page) -> float:
    return float(page.inner_text(".moment").removesuffix(" ms").replace("\N{MINUS SIGN}", "-"))


def scrub(page: Page, milliseconds: float) -> None:
    page.eval_on_selector(
        "#moment",
        "(range, value) => { range.value = value; range.dispatchEvent(new Event('input', { bubbles: true })); "
        "range.dispatchEvent(new Event('change', { bubbles: true })) }",
        str(milliseconds),
    )


def test_the_ledger_and_the_wave_are_said(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/hit")
    answered(still)
    parts = still.locator(".ledger dt").all_inner_texts()
    assert parts[:3] == ["ball, moving", "ball, squeezed", "heat in the ball"] and "bat, bending vibration" in parts
    percents = [int(words.split("·")[1].strip(" %")) for words in still.locator(".ledger dd").all_inner_texts()]
    assert sum(percents) == pytest.approx(100, abs=4)
    said = " ".join(still.inner_text("#verdict").split())
    assert re.search(r"The wave reaches the top hand 0\.\d\d ms after first touch", said)
    assert "too late" in still.inner_text("#verdict")
    assert still.inner_text("#play") == "Play" and moment(still) == 0.6


def test_scrubbing_bends_the_bat_and_moves_the_energy(
    still: Page, server: str, answered: Answered, until: Until
) -> None:
    still.goto(f"{server}/hit")
    answered(still)
    before, ledger = picture(still, SIDE), still.inner_text(".ledger")
    scrub(still, 2.5)
    assert moment(still) == 2.5
    assert picture(still, SIDE) != before and still.inner_text(".ledger") != ledger
    assert "moment_ms=2.5" in still.url
    still.go_back()
    until(still, "document.querySelector('.moment').textContent === '0.60 ms'")


def test_an_address_opens_at_its_moment(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/hit?moment_ms=1.25&bat=single-wall")
    answered(still)
    assert moment(still) == 1.25
    assert "Single-wall aluminium" in still.inner_text("#verdict")


def test_a_hollow_barrel_breathes_after_the_ball_has_left_and_a_solid_one_does_not(
    still: Page, server: str, answered: Answered
) -> None:
    for bat, breathes in (("single-wall", True), ("r161-ash", False)):
        still.goto(f"{server}/hit?bat={bat}&moment_ms=3.6")
        answered(still)
        first = barrel(still)
        scrub(still, 3.75)
        assert (barrel(still) != first) is breathes


def test_play_goes_on_and_pause_stops(still: Page, server: str, answered: Answered, until: Until) -> None:
    still.goto(f"{server}/hit?slowness=3000")
    answered(still)
    still.click("#play")
    until(still, "parseFloat(document.querySelector('.moment').textContent) > 0.65")
    assert still.inner_text("#play") == "Pause"
    still.click("#play")
    rested = moment(still)
    still.wait_for_timeout(120)
    assert moment(still) == rested > 0.6 and still.inner_text("#play") == "Play"
    assert "moment_ms=" in still.url


def test_it_plays_once_by_itself_unless_asked_not_to(page: Page, server: str, answered: Answered, until: Until) -> None:
    page.goto(f"{server}/hit?slowness=100")  # 4.4 ms in 0.44 s
    answered(page)
    until(page, "document.querySelector('#play').textContent === 'Play'")
    assert moment(page) == 4.0 and "moment_ms" not in page.url


def test_keys(still: Page, server: str, answered: Answered, until: Until) -> None:
    still.goto(f"{server}/hit")
    answered(still)
    still.focus("#moment")
    still.keyboard.press("Home")
    assert moment(still) == -0.4
    still.keyboard.press("ArrowRight")
    assert still.eval_on_selector("#moment", "range => Number(range.value)") > -0.4
    still.keyboard.press("End")
    assert moment(still) == 4.0
    scrub(still, 0.6)
    still.keyboard.press(".")
    later = moment(still)
    still.keyboard.press(",")
    assert later > 0.6 >= moment(still)
    still.keyboard.press("k")
    until(still, "document.querySelector('#play').textContent === 'Pause'")
    words = still.get_attribute("#moment", "aria-valuetext") or ""
    assert "after first touch" in words and "hands" in words


def test_keys_still_work_after_other_views(still: Page, server: str, answered: Answered, until: Until) -> None:
    still.goto(f"{server}/hit")
    answered(still)
    for name in ("modes", "hit"):
        visit(still, name)
        answered(still)
    still.keyboard.press("k")
    until(still, "document.querySelector('#play').textContent === 'Pause'")


def test_exaggeration_and_recoil_change_the_drawing_alone(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/hit?moment_ms=2")
    drawn = answered(still)
    pictures, fact = {picture(still, SIDE)}, still.inner_text(".facts")
    still.get_by_label("Bat's motion drawn larger, times").first.fill("6")
    drawn = answered(still, drawn)
    pictures.add(picture(still, SIDE))
    still.get_by_label("Show the whole motion").uncheck()
    answered(still, drawn)
    pictures.add(picture(still, SIDE))
    assert len(pictures) == 3 and still.inner_text(".facts") == fact


def test_units(still: Page, server: str, answered: Answered) -> None:
    still.goto(f"{server}/hit")
    answered(still)
    assert "lbf" in still.inner_text(".facts") and "mph" in still.inner_text(".facts")
    still.locator("input[name=units][value=si]").check()
    assert "kN" in still.inner_text(".facts") and "m/s" in still.inner_text(".facts")


def test_exports(still: Page, server: str, answered: Answered, tmp_path: Path) -> None:
    still.goto(f"{server}/hit?bat=single-wall")
    answered(still)
    still.click("#export")
    files = {}
    for kind in ("png", "svg", "csv", "json"):
        with still.expect_download() as waited:
            still.click(f"dialog [data-format={kind}]")
        files[kind] = tmp_path / f"hit.{kind}"
        waited.value.save_as(files[kind])
    assert files["png"].read_bytes()[:4] == b"\x89PNG"
    assert "from the end; wall" in files["svg"].read_text(encoding="utf-8")
    with files["csv"].open(encoding="utf-8") as opened:
        rows = list(csv.DictReader(opened))
    assert {"time_s", "force_n", "energy_bending_j", "wall_dent_harmonic_2_m"} <= set(rows[0])
    assert len(rows) > 200
    assert "film" in json.dumps(json.loads(files["json"].read_text(encoding="utf-8")))
    assert "sweetspot hit single-wall --at 6in-from-tip" in still.inner_text("[data-lines=command]")
    assert "history_of(impact" in still.inner_text("[data-lines=python]")
