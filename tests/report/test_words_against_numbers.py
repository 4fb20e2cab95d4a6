"""Every sentence of reports and comparisons over the catalogue: its numbers are those of the table beside it, its
direction words agree with their signs, in either system of units."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.comparison import compare
from sweetspot.answers.compare import compare_of
from sweetspot.answers.report import misses_of
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.interval import NO_SPEED, Interval, sure_sign
from sweetspot.report.bat.document import report_document
from sweetspot.report.bat.tables import spots_table
from sweetspot.report.bat.words import answer_words
from sweetspot.report.comparison.document import comparison_document
from sweetspot.report.comparison.words import changes, cork_verdict, verdict
from sweetspot.report.document import Column, Document, Paragraph, Table
from sweetspot.report.quantities import SYSTEMS, US, Reader
from sweetspot.report.sentences import read
from sweetspot.report.sport_words import words_of
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import MPH
from tests.report.told import LEFT_OVER, reported

SHOWN = ("r161-ash", "single-wall", "double-wall", "composite", "youth-30", "slow-pitch", "uniform-rod",
         "tennis-racket", "badminton-racket", "table-tennis-racket", "cricket-bat", "golf-driver",
         "hockey-stick")  # fmt: skip


@pytest.fixture(scope="module", params=SHOWN)
def analysed(request: pytest.FixtureRequest) -> Analysis[Implement]:
    return sweetspot.standard_analysis(request.param)


def cells(table: Table, reader: Reader) -> list[list[str]]:
    columns: list[Column] = list(table.columns)
    return [[column.shown(cell, reader) for column, cell in zip(columns, row, strict=True)] for row in table.rows]


def paragraphs(document: Document, reader: Reader) -> list[str]:
    return [read(block.words, reader) for block in document.blocks if isinstance(block, Paragraph)]


@pytest.mark.parametrize("system", ["us", "si"])
def test_a_report_s_words_are_its_tables(analysed: Analysis[Implement], system: str) -> None:
    reader = SYSTEMS[system]  # type: ignore[index]
    words = [sentence.read(reader) for sentence in answer_words(reported(analysed))]
    assert not [text for text in words if LEFT_OVER.search(text)]
    table = spots_table(reported(analysed))
    rows = dict(zip((getattr(row[0], "mark", "") for row in table.rows), cells(table, reader), strict=True))
    best = rows["max_exit_speed"]
    place = re.search(r"hits best ([\d.]+)", words[0])
    assert place is not None and place[1] == best[1]
    speed = re.search(r"leaves at ([\d.]+)", words[0])
    assert speed is not None
    assert (
        speed[1] == reader.number(float(analysed.scan.exit_speed.max()), "speed")
        or abs(float(speed[1]) - float(reader.number(float(analysed.scan.exit_speed.max()), "speed"))) < 0.11
    )
    zone = re.search(r"reaches from ([\d.]+) to ([\d.]+)", words[0])
    assert (zone is None) == (analysed.sweet_spots.zone is None)
    if zone is not None:
        assert rows["zone"][1] == f"{zone[1]} to {zone[2]}"
        low, high = analysed.sweet_spots.zone or (0.0, 0.0)
        outside = re.search(r"best lies outside it, nearer the (\S.*?)\.", words[0])
        assert (outside is None) == (low <= analysed.sweet_spots.max_exit_speed <= high)
        if outside is not None:
            beyond = analysed.sweet_spots.max_exit_speed > high
            assert (outside[1] == words_of(analysed.bat).tip) == beyond
    tip = re.search(
        r"only ([\d.,]+) \S+ instead of ([\d.,]+) .+ vibration: ([\d.]+) \S+, ([\d.]+) \S+ less than", " ".join(words)
    )
    assert tip is not None  # why not at the end: less met, less speed, and both differences add up
    assert float(tip[1].replace(",", "")) < float(tip[2].replace(",", ""))
    assert float(tip[3]) + float(tip[4]) == pytest.approx(float(speed[1]), abs=0.16)
    if zone is not None:
        width = re.search(r"from the [a-z ]+, ([\d.]+) \S+ wide", words[0])
        assert width is not None and abs(float(zone[1]) - float(zone[2])) == pytest.approx(float(width[1]), abs=0.11)
    faster = re.search(r"hit moves ([\d.]+)", " ".join(words))
    assert faster is not None
    arm = analysed.bat.length - analysed.sweet_spots.max_exit_speed
    rate = analysed.conditions.swing.angular_speed
    assert float(faster[1]) <= float(reader.number(rate * arm, "speed")) + 0.11
    for miss in misses_of(analysed):
        assert not float(miss.inside) < -1e-9


def test_nothing_of_baseball_is_told_of_other_sports(analysed: Analysis[Implement]) -> None:
    document = report_document(reported(analysed))
    text = " ".join(paragraphs(document, document.reader))
    if analysed.bat.sport not in ("baseball", "youth-baseball", "softball", "slow-pitch", "cricket"):
        assert not re.search(r"\b(bat|pitch|knob|BBCOR)\b", text)
    published = [block for block in document.appended if getattr(block, "name", "") == "published"]
    for section in published:
        said = " ".join(" ".join(row) for table in section.blocks if isinstance(table, Table)  # type: ignore[union-attr]
                        for row in cells(table, document.reader))  # fmt: skip
        others = {"tennis", "cricket", "7-iron"} - {analysed.bat.sport}
        assert analysed.bat.sport in ("tennis", "cricket", "golf") or not any(word in said for word in others)


def test_a_comparison_s_words_have_the_signs_of_its_changes() -> None:
    names = ("r161-ash", "mlb-a", "single-wall", "youth-30", "corked-r161")
    bats = [catalog.bat(name) for name in names]
    conditions = sweetspot.standard_conditions(bats[0])
    comparison = compare(bats, conditions=conditions, law=catalog.swing_law())
    document = comparison_document(comparison)
    reader = document.reader
    sentences = paragraphs(document, reader)[: len(bats) - 1]
    for sentence, one, data in zip(sentences, comparison.compared[1:], document.data["bats"][1:], strict=True):
        assert one.label in sentence
        told = re.search(r"the ball leaves ([\d.]+) \S+ (faster|slower) \(([-+][\d.]+) to ([-+][\d.]+)\)", sentence)
        assert told is not None, sentence
        assert told[1] == reader.number(abs(one.change.value), "speed_change")
        assert (told[2] == "faster") == (one.change.value > 0)
        swung = re.search(r"swung ([\d.]+) \S+ (faster|slower)", sentence)
        if swung is not None:
            gain = one.bat_speed.value - comparison.reference.bat_speed.value
            assert (swung[2] == "faster") == (gain > 0)
        if "a gain" in sentence:
            assert data["change_m_s"]["low"] > 0 and not re.fullmatch(r"\+0\.0+", told[3])
        if "a loss" in sentence:
            assert data["change_m_s"]["high"] < 0 and not re.fullmatch(r"[-+]0\.0+", told[4])
        # the interval holds bats and ball too: nothing is left of which the sentence must say that it is so
        assert sentence.endswith((": the sign is not sure.", ": a gain.", ": a loss."))
        ends = data["change_m_s"]["low"], data["change_m_s"]["high"]
        assert ("not sure" in sentence) == (sure_sign(*ends, nothing=NO_SPEED) == 0)
    for sentence, bare in zip(
        sentences, changes(compare_of(comparison)), strict=True
    ):  # without a word on how sure it is
        assert sentence.startswith(read(bare, US).removesuffix("."))
        assert not re.search("sure|gain|loss|if ", read(bare, US))


@pytest.mark.parametrize(("ends", "said", "corked"), [
    ((-1.7, -0.04), "the sign is not sure.", "cannot be told"), ((-1.7, -0.06), "a loss.", "the ball leaves slower"),
    ((0.04, 1.7), "the sign is not sure.", "cannot be told"), ((0.06, 1.7), "a gain.", "Here it does"),
])  # fmt: skip
def test_an_interval_that_is_told_to_end_at_nothing_leaves_the_sign_open(
    ends: tuple[float, float], said: str, corked: str
) -> None:
    """-1.7 to -0.0 mph is no loss for sure."""
    bats = [catalog.bat(name) for name in ("r161-ash", "corked-r161")]
    conditions = sweetspot.standard_conditions(bats[0])
    found = compare(bats, conditions=conditions, law=catalog.swing_law(), labels=["unmodified", "cork"])
    sources = [sources_of(one.analysis.bat, one.analysis.conditions) for one in found.compared]
    answer = compare_of(found, sources)
    first, cork = answer.bats
    change = Interval(sum(ends) / 2 * MPH, ends[0] * MPH, ends[1] * MPH)
    hair = replace(answer, bats=(first, replace(cork, change=change)))
    assert said in read(verdict(hair)[0], US)
    assert corked in read(cork_verdict(hair)[0], US)
