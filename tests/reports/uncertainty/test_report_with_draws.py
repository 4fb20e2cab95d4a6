"""A report with draws: an interval beside every number that is not given, in words, tables and the picture."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import pytest

from sweetspot import analyse, catalog
from sweetspot.answers.report import ReportAnswer, report_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.numerics.interval import Interval
from sweetspot.reports.bat.document import report_document
from sweetspot.reports.bat.figure import report_figure
from sweetspot.reports.document import Document, Paragraph, Section
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import Bounds, Slot, read
from sweetspot.uncertainty.sources import sources_of


@pytest.fixture(scope="module")
def report() -> ReportAnswer:
    bat = catalog.bat("college-alloy")
    analysis = analyse(bat, standard_conditions(bat))
    sources = sources_of(bat, analysis.conditions, bat_speed_error=0.3, pitch_speed_error=0.3)
    return report_of(analysis, sources, drawn=True, draws=32)


@pytest.fixture(scope="module")
def document(report: ReportAnswer) -> Document:
    return report_document(report)


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


def test_every_number_of_the_answer_has_its_interval(document: Document) -> None:
    """But distances of misses, the zone's measure, and soft defaults, which are given; brackets of other laws go."""
    found = [one for block in document.blocks if not isinstance(block, Section) for one in slots(block)]
    assert not any(isinstance(one, Bounds) for one in found)
    halves = {each["half_interval_m_s"] for each in document.data["worth_measuring"]}  # what would be left of one
    without = [one for one in found if isinstance(one, Slot) and not isinstance(one.value, Interval) and not one.round]
    assert {one.value for one in without} <= halves


GIVEN = {"sweet-spots": 2, "along": 18, "mass": 3, "modes": 6, "best-hit": 1}
"""By table, how many of its numbers are given (measure of the zone, places, length, axes, what a sum may miss), and of
nodes those that are another one's for a drawn bat, both from the tip and from the knob."""


@pytest.mark.parametrize("name", list(GIVEN))
def test_every_number_of_the_tables_has_its_interval(document: Document, name: str) -> None:
    section = next(one for one in document.details if isinstance(one, Section) and one.name == name)
    table = section.blocks[0]
    found = [one for one in slots(getattr(table, "rows")) if isinstance(one, Slot)]  # noqa: B009 - any block
    assert found
    lacking = [one for one in found if not isinstance(one.value, Interval)]
    assert len(lacking) <= GIVEN[name], lacking


def test_words_are_told_with_ends(document: Document) -> None:
    words = [block.words for block in document.blocks if isinstance(block, Paragraph)]
    text = " ".join(read(one, US) for one in words)
    assert "reaches from" in text and "± 0." in text.split("reaches from")[1].split("wide")[0]
    assert "In brackets" not in text


def test_the_picture_has_bands(report: ReportAnswer) -> None:
    figure = report_figure(report, US)
    bands = [one for axes in figure.axes for one in axes.collections if one.get_gid() == "band"]
    assert len(bands) == 4
    assert any("±" in text.get_text() and "mph" in text.get_text() for text in figure.texts)
    plain = report_figure(report_of(report.analysis), US)
    assert not [one for axes in plain.axes for one in axes.collections if one.get_gid() == "band"]
