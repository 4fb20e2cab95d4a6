"""The paper in a real browser: its questions in turn, each with claim, formula, numbers to move, and the model."""

from __future__ import annotations

import re

from playwright.sync_api import Page, expect

from sweetspot.papers.chain import PARTS
from tests.web.parts import Answered, Wait, moved, picture

CONTROLS = {
    "end": ("entry_angle_deg", "30"),
    "percussion": ("rod_hands_in", "0"),
    "corking": ("hole_depth_in", "5"),
    "drop": ("drop_height_m", "60"),
    "energy": ("metal_share", "0.2"),
}


VIEW = "paper"


def test_the_questions_come_one_after_the_other(opened: Page, answered: Answered) -> None:
    titles = []
    for question in PARTS:
        expect(opened).to_have_url(re.compile(f"question={question}" if question != "end" else r"/paper$"))
        titles.append(opened.locator("#view h1").inner_text())
        assert opened.locator("#verdict").inner_text() and opened.locator("#view tbody tr").count() >= 1
        if question != "verdict":
            count = answered(opened)
            opened.get_by_role("button", name="Next question").click()
            answered(opened, count)
    assert len(set(titles)) == len(PARTS)
    expect(opened.get_by_role("button", name="Next question")).to_be_disabled()
    opened.go_back()
    expect(opened.locator("#view h1")).to_have_text(titles[-2])


def shown(page: Page) -> tuple[str, ...]:
    return page.locator(".formulas").inner_text(), page.locator("#view .scroll tbody").inner_text(), picture(page)


def test_numbers_move_formula_picture_and_statements(opened: Page, answered: Answered) -> None:
    for step, (question, (field, value)) in enumerate(CONTROLS.items()):
        count = answered(opened)
        if step:
            opened.locator(".questions button").nth(step).click()
            answered(opened, count)
        before = shown(opened)
        moved(opened, answered, field, value)
        assert all(new != old for new, old in zip(shown(opened), before, strict=True)), question
        assert f"{field}=" in opened.url


def test_formulas_are_mathematics_and_misprints_are_named(opened: Page, answered: Answered) -> None:
    count = answered(opened)
    opened.get_by_role("button", name="2. Where is it, then?").click()
    answered(opened, count)
    assert opened.locator(".formulas mfrac").count() >= 4
    assert (opened.locator(".formulas math").first.get_attribute("alttext") or "").endswith("= ( l + x ) I")
    opened.locator("summary", has_text="Misprints").click()
    expect(opened.locator(".slips li").first).to_contain_text("the printed 1 + x is l + x")


def test_keyboard_alone(opened: Page, answered: Answered) -> None:
    opened.get_by_role("button", name="5. Why not metal?").focus()
    count = answered(opened)
    opened.keyboard.press("Enter")
    answered(opened, count)
    slider = opened.get_by_role("slider", name="z₂, share of metal")
    slider.focus()
    before, count = opened.locator(".formulas").inner_text(), answered(opened)
    opened.keyboard.press("ArrowRight")
    answered(opened, count)
    assert opened.locator(".formulas").inner_text() != before


def test_a_bat_that_cannot_be_drilled_is_explained(page: Page, server: str) -> None:
    page.goto(f"{server}/paper?question=corking&bat=russell-b6")
    expect(page.locator("[data-field=bat] .fault")).to_contain_text("choose a solid wood bat")


def test_units_phone_and_lines(opened: Page, narrow: Wait) -> None:
    opened.get_by_role("radio", name="SI", exact=True).check()
    expect(opened.locator("#verdict")).to_contain_text("m/s")
    assert "mph" not in opened.locator("#view").inner_text()
    narrow(opened)
    opened.get_by_role("button", name="Menu").click()  # where a phone has the tools
    opened.get_by_role("button", name="Export").click()
    expect(opened.locator("dialog pre").first).to_contain_text("sweetspot paper r161-ash --entry-angle 10deg")
    expect(opened.locator("dialog pre").nth(1)).to_contain_text("sweetspot.paper('r161-ash', entry_angle='10deg'")


def test_symbols_of_the_statements_are_formulas(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/paper?question=percussion")
    answered(page)
    table = page.locator("#view table").last
    expect(table.locator("math").first).to_be_attached()
    assert not re.search(r"[A-Za-z]_[A-Z]|\^2", table.inner_text())
