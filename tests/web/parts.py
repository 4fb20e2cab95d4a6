"""Parts of a view as a person sees them: a number below the curves, the pictures, a control's field."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from playwright.sync_api import Page, expect

from sweetspot.web.views import GROUP_OF

Answered = Callable[..., int]
Wait = Callable[[Page], None]
Until = Callable[[Page, str], Any]
Repainted = Callable[[Page, Callable[[], None]], None]
"""What the fixtures of those names in conftest.py do; `settled` and `narrow` wait."""

UNFOLD = """(field) => {
  for (let at = field; at; at = at.parentElement) {
    if (at.tagName === "DETAILS") at.open = true;
    if (at.id === "bench" && at.hidden) document.getElementById("bench-chip").click();
  }
}"""


def visit(page: Page, name: str) -> None:
    """Go to a view by the bar, as a person does: its group, then the view."""
    page.locator(f"#groups a[data-group='{GROUP_OF[name]}']").click()
    link = page.locator(f"#views a[data-name={name}]")
    link.click()
    expect(link).to_have_attribute("aria-current", "page")


def bench(page: Page) -> Any:
    """Return what lies behind the chip in the bar, opened."""
    opened = page.locator("#bench")
    if opened.is_hidden():
        page.locator("#bench-chip").click()
    return opened


def choose(page: Page, key: str) -> None:
    """Choose a bat, or what another sport hits with, of the list behind the chip, and shut that again."""
    opened = bench(page)
    opened.locator(f"input[value={key}]").check()
    opened.get_by_role("button", name="Close").click()


def number(page: Page, name: str) -> float:
    """Return a number below the curves, in the unit shown."""
    text = page.locator(f".facts div:has(:text-is('{name}')) dd").inner_text()
    return float(re.findall(r"-?[\d.]+", text.replace("\N{MINUS SIGN}", "-"))[0])


def written(page: Page, field: str, value: object) -> None:
    """Write a number into a control's field."""
    box = page.locator(f"[data-field={field}] input[type=number]")
    box.evaluate(UNFOLD)
    box.fill(str(value))
    box.press("Enter")


def moved(page: Page, answered: Answered, field: str, value: object) -> None:
    """Write a number into a control's field and wait for the picture."""
    before = answered(page)
    written(page, field, value)
    answered(page, before)


def picture(page: Page) -> str:
    """Return what is on the view's canvases, as text."""
    return str(page.evaluate("[...document.querySelectorAll('#view canvas')].map((c) => c.toDataURL()).join()"))
