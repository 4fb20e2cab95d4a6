"""Reports of other sports: their words, their units, and soft defaults marked."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse, dead_spot
from sweetspot.answers.report import report_of
from sweetspot.catalog.sports import sport, sport_implements, sport_names
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.implement import Implement
from sweetspot.papers.sports import face_share, sport_rows
from sweetspot.reports.bat.provenance import assumed_of_ball
from sweetspot.reports.bat.words import answer_words
from sweetspot.reports.quantities import SI
from sweetspot.reports.sport_words import arriving, reader_of

Run = Callable[..., tuple[int, str, str]]
OTHERS = [name for name in sport_names() if sport(name).words.incoming != "pitch" and sport_implements(name)]


def told(found: Analysis[Implement]) -> str:
    return " ".join(paragraph.read(reader_of(found.bat.sport)) for paragraph in answer_words(report_of(found)))


@cache
def usual(name: str) -> Analysis[Implement]:
    tool = catalog.implement(sport_implements(name)[0])
    return analyse(tool, standard_conditions(tool))


def test_units_and_words() -> None:
    tennis, golf, bat = (
        reader_of(catalog.implement(name).sport) for name in ("tennis-racket", "golf-driver", "slow-pitch")
    )
    assert tennis.shown(30.0, "speed") == "30.0 m/s" and golf.shown(44.704, "speed") == "100.0 mph"
    assert golf.shown(0.0254, "place") == "1.0 in" and golf.shown(0.2, "mass") == "200 g"  # as club makers have it
    assert tennis.shown(0.15, "place") == "15.0 cm" and bat.shown(0.1524, "place") == "6.0 in"
    words = sport("badminton").words
    assert (
        arriving(words, 5.0).read(SI) == "a shuttle at 5 m/s" and arriving(words, 0.0).read(SI) == "a shuttle at rest"
    )


@pytest.mark.parametrize("name", OTHERS)
def test_the_answer_speaks_the_sports_language(name: str) -> None:
    found, words = usual(name), sport(name).words
    text = told(found)
    assert f"This {words.implement} hits best" in text and words.tip in text
    assert ("mph" in text) == (words.speed_unit == "mph") and "knob" not in text and "pitch" not in text
    soft = [one for one in (sport(name).stroke.swing_speed, sport(name).stroke.ball_speed) if one.kind == "assumed"]
    of_ball = assumed_of_ball(found.conditions.ball)
    assert text.count("Assumed, not measured: ") == bool(soft or of_ball)
    assert all(value in text for value in (*(one.name for one in soft), *of_ball))


def test_special_words_where_a_sport_has_them() -> None:
    assert "smash factor" in told(usual("golf"))
    assert "is negative" in told(usual("field-hockey"))
    found = usual("tennis")
    place = dead_spot(found)
    assert place is not None and found.bat.length - 0.1 < place < found.bat.length
    assert "dead spot" in told(found) and "best bounce" in told(found)
    assert 0.3 < face_share(found) < 0.8  # strings and ball are about equally stiff


@pytest.mark.parametrize("name", OTHERS)
def test_the_papers_formulas_hold_as_far_as_they_go(name: str) -> None:
    """W of two springs against the full model: never below it by more than rounding, for it knows no vibration."""
    rows = {row.equation: row for row in sport_rows(sport(name)) if row.equation in ("11", "W")}
    returned, measured = rows["W"].computed, rows["W"].full_model
    assert isinstance(returned, float) and isinstance(measured, float)
    assert measured - 0.02 < returned < 1
    assert isinstance(rows["11"].computed, float) and rows["11"].computed > 0


@pytest.mark.parametrize("name", OTHERS)
def test_commands(run: Run, name: str) -> None:
    tool = sport_implements(name)[0]
    code, out, err = run("hit", tool, "--at", "4cm-from-tip")
    assert code == 0 and sport(name).words.efficiency in out, err
    assert ("hit 1.6 in from the" if name in ("golf", "pickleball") else "hit 4.0 cm from the") in out


def test_a_ball_of_another_sport_is_said_aloud(run: Run) -> None:
    code, out, err = run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", "tennis")
    assert code == 0 and "is a ball of tennis" in err and "made for baseball" in err
    code, _, err = run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", "baseball")
    assert code == 0 and err == ""
    code, out, err = run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", "tenis")
    assert code == 2 and out == "" and "Did you mean" in err
