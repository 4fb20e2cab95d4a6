"""A report with draws: an interval beside every number that is not given, in words, tables and the picture."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import pytest

from sweetspot import analyse, catalog
from sweetspot.calibration.draws.drawn_reports import drawn_report
from sweetspot.calibration.draws.intervals import Reaches
from sweetspot.calibration.draws.sources import sources_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.report.bat.document import report_document
from sweetspot.report.bat.figure import report_figure
from sweetspot.report.bat.words import misses_of
from sweetspot.report.document import Document, Paragraph, Section
from sweetspot.report.quantities import US
from sweetspot.report.sentences import Bounds, Slot, read
from sweetspot.report.uncertainty.uncertainty_section import uncertain


@pytest.fixture(scope="module")
def drawn() -> tuple[Document, Reaches, Any]:
    bat = catalog.bat("college-alloy")
    analysis = analyse(bat, standard_conditions(bat))
    misses = misses_of(analysis)
    sources = sources_of(bat, analysis.conditions, bat_speed_error=0.3, pitch_speed_error=0.3)
    answers = drawn_report(analysis, sources, misses=misses, count=32)
    plain = report_document(analysis, misses=misses, reaches=answers.reaches)
    told = uncertain(plain, answers, main="best_hit.exit_speed_m_s", named="best exit speed", where=sources.described)
    return told, answers.reaches, analysis


def slots(part: Any) -> Iterator[Slot | Bounds]:
    """Yield every number of a part of a document."""
    if isinstance(part, (Slot, Bounds)):
        yield part
    elif isinstance(part, (list, tuple)):
        for one in part:
            yield from slots(one)
    elif is_dataclass(part) and not isinstance(part, type):
        for field in fields(part):
            yield from slots(getattr(part, field.name))


def test_every_number_of_the_answer_has_its_interval(drawn: tuple[Document, Reaches, Any]) -> None:
    """But distances of misses, the zone's measure, and soft defaults, which are given; brackets of other laws go."""
    document, _, _ = drawn
    found = [one for block in document.blocks if not isinstance(block, Section) for one in slots(block)]
    assert not any(isinstance(one, Bounds) for one in found)
    without = [one for one in found if isinstance(one, Slot) and one.reach is None and not one.round]
    assert not [(one.value, one.of) for one in without]


@pytest.mark.parametrize("name", ["sweet-spots", "along", "mass", "modes", "best-hit"])
def test_every_number_of_the_tables_has_its_interval(drawn: tuple[Document, Reaches, Any], name: str) -> None:
    document, _, _ = drawn
    section = next(one for one in document.details if isinstance(one, Section) and one.name == name)
    table = section.blocks[0]
    found = [one for one in slots(getattr(table, "rows")) if isinstance(one, Slot) and one.of]  # noqa: B009 - any block
    assert found
    lacking = {one.of for one in found if one.reach is None}
    assert all("nodes" in of for of in lacking), lacking  # one that is another one for a drawn bat has none
    assert len(lacking) <= 3


def test_words_are_told_with_ends(drawn: tuple[Document, Reaches, Any]) -> None:
    document, _, _ = drawn
    words = [block.words for block in document.blocks if isinstance(block, Paragraph)]
    text = " ".join(read(one, US) for one in words)
    assert "reaches from" in text and "± 0." in text.split("reaches from")[1].split("wide")[0]
    assert "These intervals reach from a ball" in text and "allows as well" not in text


def test_the_picture_has_bands(drawn: tuple[Document, Reaches, Any]) -> None:
    _, reaches, analysis = drawn
    figure = report_figure(analysis, US, reaches)
    bands = [one for axes in figure.axes for one in axes.collections if one.get_gid() == "band"]
    assert len(bands) == 4
    assert any("±" in text.get_text() and "mph" in text.get_text() for text in figure.texts)
    plain = report_figure(analysis, US)
    assert not [one for axes in plain.axes for one in axes.collections if one.get_gid() == "band"]
