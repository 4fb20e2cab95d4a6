"""A document as the page shows it: text and tables in either system of units; most pictures it draws itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

from sweetspot.reports.document import Block, Document, Picture, Section
from sweetspot.reports.html import fragment
from sweetspot.reports.quantities import SYSTEMS, Reader, System, with_minus_signs
from sweetspot.reports.sentences import Sentence, Slot
from sweetspot.units.usual_units import WRITTEN

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


def page_document(document: Document, *, mark: str = "", pictured: bool = False) -> ReadDocument:
    """Return a document as the page shows it.

    Parameters
    ----------
    mark : put behind its sections' anchors, where several documents stand on one page.
    pictured : whether the document's own pictures stand in it, and its details below on demand, for a view that draws
        none of them itself.
    """
    bare = (
        replace(document, appendix=document.details)
        if pictured
        else replace(document, blocks=_without_pictures(document.blocks, mark))
    )
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


BESIDE = {"oz": "mass", "in": "place", "ft": "distance", "mph": "speed", "lb/ft^3": "density", "oz in^2": "moi"}
"""The kind of a quantity beside which one of these stands; the other unit is an SI one."""
SIZES = {unit: size for kind in ("length", "mass", "speed", "density", "moi") for unit, size in WRITTEN[kind].items()}
NUMBER = r"-?\d[\d.]*(?:e[+-]?\d+)?"
METRIC, CUSTOMARY = r"kg m\^2|kg/m\^3|m/s|kg|g|mm|m", "|".join(map(re.escape, BESIDE))
BOTH = re.compile(
    rf"(?P<number>{NUMBER}) (?:(?P<metric>{METRIC}) \({NUMBER} (?P<beside>{CUSTOMARY})\)"
    rf"|(?P<customary>{CUSTOMARY}) \({NUMBER} (?:{METRIC})\))"
)
"""As `sweetspot.units.shown` and its like write them: '0.8382 m (33 in)'; or the other way round."""
WALL_DIGITS = 3
"""Decimals of inches or centimetres, of a thickness given in millimetres."""


def in_one_system(words: str) -> dict[System, str]:
    """Return words whose quantities stand there in both systems, for readers of each.

    >>> in_one_system("its knob of 2.0 oz (57 g), 0.8382 m (33 in) from the tip")["us"]
    'its knob of 2.0 oz, 33.0 in from the tip'
    >>> in_one_system("a density of 301 kg/m^3 (18.8 lb/ft^3)")["si"]
    'a density of 301 kg/m³'
    """
    return {system: BOTH.sub(partial(_in_system, reader=reader), words) for system, reader in SYSTEMS.items()}


def _in_system(found: re.Match[str], reader: Reader) -> str:
    unit = found["metric"] or found["customary"]
    value = float(found["number"]) * SIZES[unit.replace(" ", "*")]
    digits = WALL_DIGITS if unit == "mm" else None
    return with_minus_signs(Slot(value, BESIDE[found["beside"] or unit], digits=digits).read(reader))
