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
from sweetspot.numerics.interval import NO_SPEED, Interval, chance_above, sure_sign
from sweetspot.reports.bat.document import report_document
from sweetspot.reports.bat.tables import spots_table
from sweetspot.reports.bat.words import answer_words
from sweetspot.reports.comparison.document import comparison_document
from sweetspot.reports.comparison.words import PROBABLY, changes, cork_verdict, verdict
from sweetspot.reports.document import Document, Paragraph, Section, Table
from sweetspot.reports.quantities import SYSTEMS, US
from sweetspot.reports.sentences import joined, read
from sweetspot.reports.sport_words import words_of
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import MPH
from tests.reports.told import LEFT_OVER, numbers_after, numbers_of_cell, reported

BALL_SPORTS = ("r161-ash", "single-wall", "double-wall", "composite", "youth-30", "slow-pitch", "uniform-rod",
               "cricket-bat")  # fmt: skip
OTHERS = ("tennis-racket", "badminton-racket", "table-tennis-racket", "golf-driver", "hockey-stick")
SHOWN = BALL_SPORTS + OTHERS


@pytest.fixture(scope="module")
def analysed(request: pytest.FixtureRequest) -> Analysis[Implement]:
    return sweetspot.standard_analysis(request.param)


@pytest.mark.parametrize("analysed", SHOWN, indirect=True)
def test_a_report_s_words_are_its_tables(analysed: Analysis[Implement]) -> None:
    report, spots, terms = reported(analysed), analysed.sweet_spots, words_of(analysed.bat.sport)
    answer, fastest = joined(answer_words(report)), float(analysed.scan.exit_speed.max())
    text = str(answer)
    assert not any(LEFT_OVER.search(answer.read(reader)) for reader in SYSTEMS.values())
    places = {getattr(row[0], "mark", ""): numbers_of_cell(row[1]) for row in spots_table(report).rows}
    assert places["max_exit_speed"] == numbers_after(answer, " hits best ")[:1]
    assert numbers_after(answer, " leaves at ")[0] == pytest.approx(fastest, abs=0.05 * MPH)
    low, high = spots.zone or (0.0, analysed.bat.length)
    nearer = terms.hands if spots.max_exit_speed < low else terms.tip
    zone = numbers_after(answer, " reaches from ")[:3] if spots.zone else []
    assert places["zone"] == zone[:2] and zone[2:] == pytest.approx([high - low][: len(zone)])
    assert ("best lies outside it" in text) != (low <= spots.max_exit_speed <= high)
    assert f"best lies outside it, nearer the {nearer}." in text or low <= spots.max_exit_speed <= high
    # why not at the end: less met, less speed, and both differences add up
    there, here = numbers_after(answer, "meets only ")[:2]
    real, less = numbers_after(answer, "as vibration: ")[:2]
    assert there < here and real + less == pytest.approx(fastest, abs=0.05 * MPH)
    arm = analysed.bat.length - spots.max_exit_speed
    assert numbers_after(answer, "hit moves ")[0] <= analysed.conditions.swing.angular_speed * arm + 1e-9
    assert not any(float(miss.inside) < -1e-9 for miss in misses_of(analysed))


@pytest.mark.parametrize("analysed", OTHERS, indirect=True)
def test_nothing_of_baseball_is_told_of_other_sports(analysed: Analysis[Implement]) -> None:
    document = report_document(reported(analysed))
    assert not re.search(r"\b(bat|pitch|knob|BBCOR)\b", " ".join(paragraphs(document)))


@pytest.mark.parametrize("analysed", SHOWN, indirect=True)
def test_published_numbers_are_those_of_the_sport(analysed: Analysis[Implement]) -> None:
    document = report_document(reported(analysed))
    published = [block for block in document.appended if isinstance(block, Section) and block.name == "published"]
    cells = [str(cell) for section in published for table in section.blocks if isinstance(table, Table)
             for row in table.rows for cell in row]  # fmt: skip
    strange = (
        {"tennis", "cricket", "7-iron"}
        if analysed.bat.sport not in ("tennis", "table-tennis", "cricket", "golf")
        else set()
    )
    assert not any(word in cell for word in strange for cell in cells)


def paragraphs(document: Document) -> list[str]:
    return [str(block.words) for block in document.blocks if isinstance(block, Paragraph)]


def test_a_comparison_s_words_have_the_signs_of_its_changes() -> None:
    """The interval holds bats and ball too: nothing is left of which the sentence must say that it is so."""
    names = ("r161-ash", "mlb-a", "single-wall", "youth-30", "corked-r161")
    bats = [catalog.bat(name) for name in names]
    comparison = compare(bats, conditions=sweetspot.standard_conditions(bats[0]), law=catalog.swing_law())
    document = comparison_document(comparison)
    told = [block.words for block in document.blocks if isinstance(block, Paragraph)][1 : len(bats)]  # corking first
    bare = changes(compare_of(comparison))
    for sentence, alone, bat, data in zip(told, bare, comparison.compared[1:], document.data["bats"][1:], strict=True):
        text, gain = str(sentence), bat.bat_speed.value - comparison.reference.bat_speed.value
        change, low, high = (data["change_m_s"][end] for end in ("value", "low", "high"))
        swung, _, leaves = text.partition("the ball leaves ")
        assert numbers_after(sentence, "the ball leaves ")[:3] == pytest.approx([abs(change), low, high])
        assert bat.label in swung and ("faster" in leaves, "slower" in leaves) == (change > 0, change < 0)
        assert ("faster" in swung, "slower" in swung) == (gain > NO_SPEED, gain < -NO_SPEED)
        sure = sure_sign(low, high, nothing=NO_SPEED)
        probably = {
            True: r": probably a gain \(\d\d %\)\.( To know it |$)",
            False: r": probably a loss \(\d\d %\)\.( To know it |$)",
        }
        chance = chance_above(0.0, Interval(change, low, high))
        words = (
            probably[chance > 0.5]
            if max(chance, 1 - chance) >= PROBABLY
            else r": the sign is not sure\.( To know it |$)"
        )
        assert re.search({0: words, 1: r": a gain\.$", -1: r": a loss\.$"}[sure], text)
        assert text.startswith(str(alone).removesuffix(".")) and not re.search("sure|gain|loss|if ", str(alone))


@pytest.mark.parametrize(("ends", "said", "corked"), [
    ((-1.7, -0.04), "probably a loss (96 %).", "Probably not (96 %)"), ((-1.7, -0.06), "a loss.", "No: net of"),
    ((0.04, 1.7), "probably a gain (96 %).", "Probably (96 %)"), ((0.06, 1.7), "a gain.", "Here it does"),
    ((-1.7, 0.5), "probably a loss (82 %).", "Probably not (82 %)"),
    ((-1.7, 0.7), "the sign is not sure.", "Not surely either way"),
])  # fmt: skip
def test_an_interval_that_is_told_to_end_at_nothing_leaves_the_sign_open(
    ends: tuple[float, float], said: str, corked: str
) -> None:
    """-1.7 to -0.0 mph is no loss for sure."""
    bats = [catalog.bat(name) for name in ("r161-ash", "corked-r161")]
    conditions = sweetspot.standard_conditions(bats[0])
    found = compare(bats, conditions=conditions, law=catalog.swing_law(), labels=["unmodified", "cork"])
    sources = [sources_of(bat.analysis.bat, bat.analysis.conditions) for bat in found.compared]
    answer = compare_of(found, sources)
    first, cork = answer.bats
    change = Interval(sum(ends) / 2 * MPH, ends[0] * MPH, ends[1] * MPH)
    hair = replace(answer, bats=(first, replace(cork, change=change)))
    assert said in read(verdict(hair)[0], US)
    assert corked in read(cork_verdict(hair)[0], US)
