"""Shows answers in notebooks as reports, without the physics knowing of reports."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar, Protocol


class Renderer(Protocol):
    """Turns an answer into what a notebook displays."""

    def figure_of(self, answer: Any, /) -> Any:
        """Return the picture of an answer, a matplotlib figure; raises `InputError` for an answer without one."""

    def html_of(self, answer: Any, /) -> str:
        """Return an answer as HTML."""

    def text_of(self, answer: Any, /) -> str:
        """Return an answer as the command line prints it."""


class ShownInNotebooks:
    """Base of everything that a notebook shows as HTML.

    ``renderer`` loads what draws and writes; the front door (`sweetspot`) sets it, since only the top of the package
    may name reports. Nothing is loaded before a notebook asks.
    """

    renderer: ClassVar[Callable[[], Renderer]]

    def plot(self) -> Any:
        """Return the picture of this answer, a matplotlib figure; raises `InputError` for an answer without one."""
        return ShownInNotebooks.renderer().figure_of(self)

    def _repr_html_(self) -> str:
        """Return the HTML that a notebook shows."""
        return ShownInNotebooks.renderer().html_of(self)
