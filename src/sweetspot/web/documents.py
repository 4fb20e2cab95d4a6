"""A document as the page shows it: text and tables in either system of units; pictures it draws itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from sweetspot.reports.document import Block, Document, Picture, Section
from sweetspot.reports.html import fragment
from sweetspot.reports.quantities import SYSTEMS, System, with_minus_signs
from sweetspot.reports.sentences import Sentence

Sentences = dict[System, list[str]]
"""By the reader's system of units."""

UNITS = sorted({re.escape(unit.name) for reader in SYSTEMS.values() for unit in reader.units.values() if unit.name})
BEFORE_UNIT = re.compile(rf"(?<=\d) (?=(?:{'|'.join(UNITS)})(?:[\s,;)]|$))")


def unbroken(text: str) -> str:
    r"""Return a text that no line breaks between a number and its unit.

    >>> unbroken("5.0 mph, 3 oz lighter").split(" ")  # what a line may break
    ['5.0\xa0mph,', '3\xa0oz', 'lighter']
    """
    return BEFORE_UNIT.sub("\N{NO-BREAK SPACE}", text)


@dataclass(frozen=True)
class ReadDocument:
    """A document's title and its HTML for readers of either system; the server's own words, all escaped."""

    title: str
    html: dict[System, str]


def page_document(document: Document, *, mark: str = "") -> ReadDocument:
    """Return a document as the page shows it.

    Parameters
    ----------
    mark : put behind its sections' anchors, where several documents stand on one page.
    """
    bare = replace(document, blocks=_without_pictures(document.blocks, mark))
    return ReadDocument(
        str(document.title), {system: unbroken(fragment(bare, reader)) for system, reader in SYSTEMS.items()}
    )


def in_both_systems(sentences: Iterable[Sentence]) -> Sentences:
    """Return sentences as readers of either system see them, with minus signs as the page's own numbers have."""
    every = [in_either_system(sentence) for sentence in sentences]
    return {system: [words[system] for words in every] for system in SYSTEMS}


def in_either_system(sentence: Sentence) -> dict[System, str]:
    """Return one sentence as `in_both_systems` does several."""
    return {system: with_minus_signs(sentence.read(reader)) for system, reader in SYSTEMS.items()}


def _without_pictures(blocks: Sequence[Block], mark: str) -> list[Block]:
    return [
        replace(block, name=f"{block.name}{mark}", blocks=_without_pictures(block.blocks, mark))
        if isinstance(block, Section)
        else block
        for block in blocks
        if not isinstance(block, Picture)
    ]
