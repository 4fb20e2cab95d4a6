"""A document as the page shows it: text and tables in either system of units; pictures it draws itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sweetspot.report.document import Block, Document, Picture, Section
from sweetspot.report.html import fragment
from sweetspot.report.quantities import SYSTEMS


def told(document: Document) -> dict[str, Any]:
    """Return a document's title and its HTML for readers of either system; the server's own words, all escaped."""
    bare = replace(document, blocks=_without_pictures(document.blocks))
    return {
        "title": str(document.title),
        "html": {system: fragment(bare, reader) for system, reader in SYSTEMS.items()},
    }


def _without_pictures(blocks: Sequence[Block]) -> list[Block]:
    return [
        replace(block, blocks=_without_pictures(block.blocks)) if isinstance(block, Section) else block
        for block in blocks
        if not isinstance(block, Picture)
    ]
