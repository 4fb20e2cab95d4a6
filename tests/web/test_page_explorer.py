"""The explorer in a real browser: each control by what a person sees of it."""

from __future__ import annotations

from collections.abc import Callable

from playwright.sync_api import Page


def test_opens(page: Page, server: str, answered: Callable[..., int]) -> None:
    page.goto(f"{server}/explorer")
    assert answered(page) >= 1
