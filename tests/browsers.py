"""The Chromium of this machine."""

from __future__ import annotations

import shutil

SHELL = "chromium-headless-shell"
"""Chromium without windows to draw: it needs two thirds of the processor."""
WHOLE = ("chromium", "chromium-browser", "google-chrome")


def for_tests() -> str | None:
    """Return the path of the browser that costs least, or None where there is none."""
    return _first(SHELL, *WHOLE)


def for_people() -> str | None:
    """Return the path of the browser that is most like what people have, or None where there is none."""
    return _first(*WHOLE, SHELL)


def _first(*names: str) -> str | None:
    return next((path for name in names if (path := shutil.which(name))), None)
