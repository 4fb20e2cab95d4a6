"""The sheet of a measuring day, filled in in a browser without a network, is the table that `rank` reads."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser

import sweetspot
from sweetspot.calibration.bat_table import read_bats
from sweetspot.reports.kit import sheet_html
from sweetspot.reports.quantities import US
from sweetspot.units import OUNCE


def test_what_is_typed_is_saved_and_slips_are_marked(browser: Browser, tmp_path: Path) -> None:
    sheet, table = tmp_path / "sheet.html", tmp_path / "measured.csv"
    sheet.write_text(sheet_html(sweetspot.kit("r161-ash", pieces=2), US), encoding="utf-8")
    context = browser.new_context(offline=True, accept_downloads=True)
    complaints: list[str] = []
    page = context.new_page()
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.goto(sheet.as_uri())
    page.get_by_label("name").first.fill('Ann\'s "old" one, ash')
    page.get_by_label("weight of No 1").fill("879")  # grams
    assert "weight of No 1 should read near 31.0 oz" in page.locator("#odd").inner_text()
    assert page.locator("input.odd").count() == 1
    page.get_by_label("weight of No 1").fill("31.0±0.1")
    assert page.locator("#odd").inner_text() == ""
    page.get_by_label("first tone of No 1").fill("171.5")
    page.get_by_label("weight of No 2").fill("31.2")
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save measured.csv").click()
    saved.value.save_as(table)
    context.close()
    assert not complaints
    bats = read_bats(table)
    assert list(bats) == ['Ann\'s "old" one, ash', "No 2"]
    (mass, tone), _ = bats.values()
    assert (mass.value.value, mass.value.error) == pytest.approx((31.0 * OUNCE, 0.1 * OUNCE))
    assert tone.value.value == 171.5
