"""Search in American and in British spelling: each page is also found by the spelling that it does not use."""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

PAIRS = (
    ("aluminum", "aluminium"), ("analyze", "analyse"), ("behavior", "behaviour"), ("caliber", "calibre"),
    ("catalog", "catalogue"), ("center", "centre"), ("color", "colour"), ("favor", "favour"), ("fiber", "fibre"),
    ("gray", "grey"), ("license", "licence"), ("liter", "litre"), ("meter", "metre"), ("millimeter", "millimetre"),
    ("centimeter", "centimetre"), ("mold", "mould"), ("normalize", "normalise"), ("neighbor", "neighbour"),
    ("practice", "practise"), ("skeptic", "sceptic"), ("synthesize", "synthesise"),
)  # fmt: skip
"""American, British."""
OTHER = {one: two for pair in PAIRS for one, two in (pair, pair[::-1])}
WORD = re.compile(rf"\b({'|'.join(OTHER)})s?\b", re.IGNORECASE)


def other_spellings(text: str) -> list[str]:
    """Return the words of a text that are spelled otherwise on the other side, in that spelling."""
    return sorted({OTHER[found[1].lower()] for found in WORD.finditer(text)})


def add_keywords(_app: Sphinx, document: nodes.document) -> None:
    """Add to a page the keywords that the search index takes in."""
    if words := other_spellings(document.astext()):
        document.insert(0, nodes.meta(name="keywords", content=", ".join(words), lang="en"))


def setup(app: Sphinx) -> dict[str, Any]:
    """Listen to pages as they are read."""
    app.connect("doctree-read", add_keywords)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
