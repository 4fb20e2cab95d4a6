"""What of a gain can be seen."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.special import ndtri

from sweetspot.analysis.certification.rules import Verdict
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.answers.design import answer_of
from sweetspot.answers.design_question import Designed, designed_bat
from sweetspot.catalog.rules import league
from sweetspot.designs.batter import FROM_TIP, contacts_at
from sweetspot.designs.constraints import Limit
from sweetspot.designs.gain import CLEARLY, PAIR, GainVerdict, gain_of, present_measured
from sweetspot.designs.measures import Bench
from sweetspot.designs.pareto import DesignSearch, Front, Generation, search
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.design.document import design_document
from sweetspot.reports.design.words import worth_words
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import read
from sweetspot.units import INCH
from tests.designs.conftest import met_at
from tests.reports.told import LEFT_OVER, text_of, unknown_numbers


@pytest.fixture(scope="module")
def design(bench: Bench, limits: tuple[Limit, ...], inside_starts: Array) -> Designed:
    there = met_at(bench, 8.0)
    question = DesignSearch(("exit_speed", "zone"), limits, population=12, generations=1)
    front = search(there, question, starts=inside_starts)
    return designed_bat(there, question, front, league=league("mlb"))


def test_the_present_bat_gains_nothing_over_itself(bench: Bench) -> None:
    now = present_measured(bench)
    gain = gain_of(bench, bench.space.start, now, now)
    assert gain.expected == pytest.approx(0.0, abs=1e-12)
    assert gain.verdict is GainVerdict.HIDDEN and gain.odds == pytest.approx(0.5, abs=1e-9)
    assert gain.doubt > 0.2  # m/s: wood alone


def test_a_gain_is_seen_only_where_its_interval_clearly_leaves_zero_out(bench: Bench) -> None:
    """At its interval's end by a hair it is likely, no more; two of a shipment scatter at least as much as reported."""
    now = present_measured(bench)
    none = gain_of(bench, bench.space.start, now, now)
    assert none.pieces == pytest.approx(PAIR) and none.pieces > none.wood > 0
    said = {
        part: replace(none, expected=part * none.spread)
        for part in (-2.6, -2.57, -1.3, -1.2, 1.2, 1.3, 1.65, 2.57, 2.6)
    }
    assert [one.verdict for one in said.values()] == [
        GainVerdict.LOSS,
        *[GainVerdict.LIKELY_LOSS] * 2,
        *[GainVerdict.HIDDEN] * 2,
        *[GainVerdict.LIKELY] * 3,
        GainVerdict.SEEN,
    ]
    assert replace(none, expected=CLEARLY * none.spread).odds == pytest.approx(0.995, abs=1e-5)
    assert said[1.65].expected > said[1.65].doubt  # its 90 % interval is above zero, and yet only likely


@pytest.mark.parametrize(("balls", "seen"), [(3, False), (30, True), (300, True)])
def test_few_balls_are_no_gain_that_you_could_see(design: Designed, balls: int, seen: bool) -> None:
    """Met 8 in from the tip, give or take 1.2 in: three balls may be anybody's, thirty are this batter's."""
    batter = design.bench.batter
    place = (8 + 1.2 * ndtri((np.arange(balls) + 0.5) / balls)) * INCH
    contacts = contacts_at(place)
    few = replace(design.bench, batter=replace(batter, weight=contacts.weight, sample=contacts))
    measured = few.measured(design.numbers)
    gain = gain_of(few, design.numbers, measured, present_measured(few))
    assert (gain.verdict is GainVerdict.SEEN) == seen == (gain.balls_needed is None)
    front = Front(design.numbers[None], measured, Generation(0, design.numbers[None], measured))
    text = read(worth_words(designed_bat(few, design.question, front)), US)
    assert f"{balls} balls tell of the contacts" in text
    assert ("met as these the gain would be seen" in text) == (not seen)
    needed = gain.balls_needed or balls
    assert 20 < needed <= 300
    later = replace(gain, balls=needed, sample=gain.sample * np.sqrt((balls + 3.5) / (needed + 3.5)))
    assert later.verdict is GainVerdict.SEEN  # from so many balls on


def test_what_no_number_of_balls_would_show(design: Designed) -> None:
    gain = replace(design.gain, sample=0.3, balls=5, expected=1.3 * design.gain.pieces)
    assert gain.balls_needed is None and gain.verdict is not GainVerdict.SEEN
    text = read(worth_words(replace(design, gain=gain)), US)
    assert "5 balls tell" in text and "from no number of balls" in text


def test_a_torpedo_for_who_meets_the_ball_inside(design: Designed) -> None:
    gain = design.gain
    assert gain.verdict is GainVerdict.SEEN and gain.odds > 0.995 and gain.shift > 0.3 * INCH
    assert gain.at(2 * INCH) < 0 < gain.at(8 * INCH)
    assert gain.turning_place is not None and 4 * INCH < gain.turning_place < 7 * INCH
    assert gain.by_weight < gain.wood
    assert gain.curve.shape == gain.noise.shape == FROM_TIP.shape
    assert all(check.verdict is not Verdict.FAIL for check in design.checks)


def test_shift_and_width_come_before_the_maximum(design: Designed) -> None:
    document = design_document(answer_of(design))
    text = read(document.blocks[0].words, US)  # type: ignore[union-attr]
    assert text.index("best place moves") < text.index("zone") < text.index("greatest exit speed")
    warning = read(document.blocks[2].words, US)  # type: ignore[union-attr]
    assert "should not use it" in warning
    assert isinstance(design.bat, Bat)
    files = {name: make(US) for name, make in document.attachments.items()}
    assert set(files) == {
        "search.json",
        "designed-bat.toml",
        "designed-bat.svg",
        "designed-bat.dxf",
        "designed-bat.csv",
        "designed-bat.lathe.csv",
        "designed-bat.pdf",
        "designed-bat.stl",
        "designed-bat.step",
    }
    assert document.data["gain"]["seen"] is True
    assert len(document.rows["exit_speed_m_s"]) == len(design.front)
    assert np.isfinite(document.data["measures"]["exit_speed_m_s"])


def test_a_bat_that_is_not_on_the_front_is_refused(design: Designed) -> None:
    with pytest.raises(InputError, match="bat 999 of the front"):
        designed_bat(design.bench, design.question, design.front, pick=999)


def test_sentences_are_the_numbers_beside_them(design: Designed) -> None:
    """Directions against signs; a number that stands nowhere else belongs to what was asked or to a tolerance."""
    document, gain = design_document(answer_of(design)), design.gain
    others = ("For contacts around", "Contacts ", "Tolerance: ", "Time to contact", "What changes most")
    short = design.bench.batter.mean_contact - design.value("best_from_tip")
    assert not [words for _, words in unknown_numbers(document, [ZONE_LOSS, short]) if not words.startswith(others)]
    text = text_of(document, US)
    assert not LEFT_OVER.search(text)
    assert ("towards the hands" in text.split(";")[0]) == (gain.shift > 0)
    assert (" wider." in text) == (gain.wider >= 0)
    assert (" faster on average" in text) == (gain.expected >= 0)
    assert ("a gain that you could see" in text and "no gain that" not in text) == (gain.verdict is GainVerdict.SEEN)
    late = re.search(r"Time to contact changes by ([-+\d.]+) ms \(([-+\d.]+) to ([-+\d.]+) ms\)", text)
    assert late is not None and float(late[2]) <= float(late[1]) <= float(late[3])
    assert (float(late[1]) < 0) == (gain.time < 0)
