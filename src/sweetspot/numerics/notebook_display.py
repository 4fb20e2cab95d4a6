"""What lets a notebook show an answer as a report, without the physics knowing of reports."""

from __future__ import annotations

from importlib import import_module
from typing import Any


class ShownInNotebooks:
    """Base of everything that a notebook shows as HTML.

    How it looks is known to `sweetspot.report.notebook` alone, which is higher up in the house; so it is loaded by
    its name, and only when a notebook asks.
    """

    def plot(self) -> Any:
        """Return the picture of this answer, a matplotlib figure; raises `InputError` for an answer without one."""
        return import_module("sweetspot.report.notebook").figure_of(self)

    def _repr_html_(self) -> str:
        """Return what a notebook shows."""
        text: str = import_module("sweetspot.report.notebook").html_of(self)
        return text
