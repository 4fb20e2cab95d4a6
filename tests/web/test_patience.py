"""Tests of a page wait as long as it works, and fail in seconds where it has nothing to do."""

from __future__ import annotations

import time

import pytest
from playwright.sync_api import Page, expect

from tests.web import conftest
from tests.web.parts import Until


def test_a_wrong_word_on_a_page_at_rest_fails_soon(
    page: Page, server: str, until: Until, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(conftest, "REST", 200)
    page.goto(f"{server}/static/no-such-page")
    began = time.monotonic()
    with pytest.raises(AssertionError):
        expect(page).to_have_title("another")
    with pytest.raises(AssertionError, match="never true"):
        until(page, "false")
    assert time.monotonic() - began < 60


def test_a_word_is_waited_for_while_the_page_works(page: Page, server: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A bar is seen for longer than a page at rest would be given."""
    monkeypatch.setattr(conftest, "REST", 100)
    page.goto(f"{server}/static/no-such-page")
    page.evaluate("""() => {
      document.body.append(document.createElement("progress"));
      setTimeout(() => { document.body.textContent = "the word"; }, 3000);
    }""")
    expect(page.locator("body")).to_have_text("the word")
