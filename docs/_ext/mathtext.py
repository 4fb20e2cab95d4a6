"""A directive that draws a formula with matplotlib's own mathtext, as SVG inside the page.

No network and no LaTeX: the formula is drawn when the page is read. The text color is the page's, so it also reads
in the dark theme.
"""

from __future__ import annotations

import hashlib
import html
import io
import logging
import re
from typing import Any

import matplotlib
from docutils import nodes
from docutils.parsers.rst import Directive
from matplotlib.figure import Figure
from sphinx.application import Sphinx

logging.getLogger("matplotlib.mathtext").setLevel(logging.WARNING)  # a sign from another font is no news

FONT_SIZE = 13
PADDING = 2.0
"""Points around the formula."""


class Mathtext(Directive):
    """``{mathtext}``: one formula per line, each drawn on its own line."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Return the drawn formulae as raw HTML."""
        formulae = [line.strip() for line in self.content if line.strip()]
        if not formulae:
            raise self.error("mathtext needs a formula")
        try:
            drawn = [drawing(formula) for formula in formulae]
        except ValueError as error:
            raise self.error(f"mathtext cannot draw this formula: {error}") from error
        lines = "".join(f'<div class="mathtext-line">{svg}</div>' for svg in drawn)
        return [nodes.raw("", f'<div class="mathtext">{lines}</div>', format="html")]


def drawing(formula: str) -> str:
    """Return one formula as an SVG element with the formula's source as its label."""
    mark = hashlib.sha256(formula.encode()).hexdigest()[:8]
    with matplotlib.rc_context({"mathtext.fontset": "dejavusans", "svg.fonttype": "path", "svg.hashsalt": mark}):
        figure = Figure(figsize=(0.01, 0.01))
        figure.text(0, 0, f"${formula}$", fontsize=FONT_SIZE)
        file = io.StringIO()
        figure.savefig(
            file, format="svg", bbox_inches="tight", pad_inches=PADDING / 72, transparent=True, metadata={"Date": None}
        )
    svg = file.getvalue()
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = re.sub(r'\bid="([^"]+)"', rf'id="m{mark}-\1"', svg)
    svg = re.sub(r'(href=")#', rf"\1#m{mark}-", svg)
    svg = re.sub(r"url\(#", f"url(#m{mark}-", svg)
    label = html.escape(formula, quote=True)
    return svg.replace("<svg", f'<svg role="img" aria-label="{label}" fill="currentColor"', 1).strip()


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directive."""
    app.add_directive("mathtext", Mathtext)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
