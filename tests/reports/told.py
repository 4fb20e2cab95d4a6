"""What a command tells: its document caught before it is printed, its sentences, and every number of its tables."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numpy as np
import pytest

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.answers.report import ReportAnswer, report_of
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.interval import Interval
from sweetspot.reports.document import Block, Bullets, Cards, Cell, Document, Paragraph, Question, Section, Table
from sweetspot.reports.notebook import document_of
from sweetspot.reports.quantities import US, Reader
from sweetspot.reports.sentences import Bounds, Doubtful, Part, Sentence, Slot, Span, Words, read
from sweetspot.uncertainty.sources import sources_of

Run = Callable[..., tuple[int, str, str]]
Tell = Callable[..., Document]

LEFT_OVER = re.compile(
    r"[{}]|\bnan\b|\binf\b|None|--(?![a-z])|  |(?<![\d.])0 mph|towards to|from from|\b1 (files|swings|rows|balls)\b"
)
INTERVAL = re.compile(r"([-+]?\d[\d,.]*)(?: [^\d\s()][^\s()]*)? \(([-+]?\d[\d,.]*) to ([-+]?\d[\d,.]*)\)")


@pytest.fixture
def tell(run: Run, monkeypatch: pytest.MonkeyPatch) -> Tell:
    """Return a function that runs a command and returns the document it would print."""
    caught: list[Document] = []

    def present(answer: object, *_: object, **__: object) -> int:
        caught.append(document_of(answer))
        return 0

    monkeypatch.setattr("sweetspot.cli.output.present", present)

    def command(*words: str) -> Document:
        caught.clear()
        code, _, said = run(*words)
        assert len(caught) == 1, (code, said)
        return caught[0]

    return command


def blocks(document: Document) -> Iterator[Block]:
    """Return every block that a terminal shows, those inside sections too."""
    waiting = [*document.blocks, *document.details]
    while waiting:
        block = waiting.pop(0)
        yield block
        if isinstance(block, Section):
            waiting[:0] = block.blocks


def sentences(document: Document) -> Iterator[Words]:
    """Return every sentence: running text, lists, answers to questions, cards."""
    for block in blocks(document):
        if isinstance(block, Paragraph):
            yield block.words
        elif isinstance(block, Bullets):
            yield from block.items
        elif isinstance(block, Question):
            yield block.answer
        elif isinstance(block, Cards):
            yield from (number for number, _ in block.cards)


def text_of(document: Document, reader: Reader) -> str:
    """Return all sentences as a reader sees them."""
    return "\n".join(read(words, reader) for words in sentences(document))


def numbers_in(words: Words) -> Iterator[float]:
    """Return the numbers of a sentence in SI, the ends of intervals too."""
    for part in words.parts if isinstance(words, Sentence) else ():
        yield from _of_part(part)


def numbers_after(words: Document | Words, opening: str) -> list[float]:
    """Return the numbers (SI) that follow some words of a sentence, or of the one sentence of a document with them."""
    if isinstance(words, Document):
        (words,) = (sentence for sentence in sentences(words) if opening in str(sentence))
    assert isinstance(words, Sentence), words
    text, found = "", list[float]()
    for part in words.parts:
        if found or text.endswith(opening):
            found += _of_part(part)
        text += part if isinstance(part, str) else part.read(US)
    assert found, (opening, text)
    return found


def known_numbers(document: Document) -> np.ndarray:
    """Return every number of a document's data and tables in SI, without sign."""
    found = [*_of_data(dict(document.data))]
    for block in blocks(document):
        if isinstance(block, Table):
            found += [number for row in block.rows for cell in row for number in numbers_of_cell(cell)]
    values = np.abs(np.array(found, float))
    return np.asarray(values[np.isfinite(values)])


def unknown_numbers(document: Document, allowed: Iterable[float] = ()) -> list[tuple[float, str]]:
    """Return the numbers of sentences that stand in no table and not in the data, with their sentence."""
    known = np.concatenate([known_numbers(document), np.abs(np.array([*allowed], float))])
    return [
        (number, str(words))
        for words in sentences(document)
        for number in numbers_in(words)
        if not (math.isfinite(number) and np.isclose(known, abs(number), rtol=1e-6, atol=1e-9).any())
    ]


def reported(analysis: Analysis[Implement]) -> ReportAnswer:
    """Return the report of an analysis as `sweetspot report` gives it without draws."""
    return report_of(analysis, sources_of(analysis.bat, analysis.conditions))


def check_sentences(document: Document, readers: Iterable[Reader], allowed: Iterable[float] = ()) -> None:
    """Fail for numbers that stand nowhere else, words left over from templates, and values outside their intervals."""
    unknown = unknown_numbers(document, allowed)
    assert not unknown, unknown
    for reader in readers:
        text = text_of(document, reader)
        assert not LEFT_OVER.search(text), LEFT_OVER.search(text)
        for found in INTERVAL.finditer(text):
            value, low, high = (float(number.replace(",", "").rstrip(".")) for number in found.groups())
            assert low <= value <= high, found[0]


def _of_part(part: Part) -> Iterator[float]:
    if isinstance(part, (Slot, Doubtful)):
        yield float(part.value)
    elif isinstance(part, (Span, Bounds)):
        yield from (part.low, part.high)


def numbers_of_cell(cell: Cell) -> list[float]:
    """Return the numbers (SI) of a cell of a table."""
    if isinstance(cell, Sentence):
        return list(numbers_in(cell))
    value = cell.value if isinstance(cell, Slot) else cell
    return [float(value)] if isinstance(value, (int, float, Interval)) else []


def _of_data(value: Any) -> Iterator[float]:
    if isinstance(value, dict):
        for inner in value.values():
            yield from _of_data(inner)
    elif isinstance(value, (list, tuple, np.ndarray)):
        for inner in value:
            yield from _of_data(inner)
    elif isinstance(value, (int, float, np.number)) and not isinstance(value, bool):
        yield float(value)
