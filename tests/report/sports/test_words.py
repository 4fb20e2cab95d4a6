"""Reports of other sports: their words, their units, and soft defaults marked."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.catalog.sports import sport, sport_names
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import ASSUMED_MARK
from sweetspot.paper.sports import dead_spot, face_share, sport_rows
from sweetspot.report.bat.words import answer
from sweetspot.report.sports.vocabulary import speaks_otherwise, speech
from sweetspot.report.sports.words import sport_answer

Run = Callable[..., tuple[int, str, str]]
OTHERS = [name for name in sport_names() if name not in ("baseball", "softball") and sport(name).implements]


@cache
def usual(name: str) -> Analysis[Implement]:
    tool = catalog.implement(sport(name).implements[0])
    return analyse(tool, standard_conditions(tool))


def test_units_and_words() -> None:
    assert speech("tennis").speed(30.0) == "30.0 m/s" and speech("golf").speed(44.704) == "100.0 mph"
    assert speech("cricket").place(0.15) == "15.0 cm" and speech("tennis").distance(0.914) == "0.91 m"
    assert not speaks_otherwise(catalog.bat("r161-ash")) and not speaks_otherwise(catalog.bat("slow-pitch"))


@pytest.mark.parametrize("name", OTHERS)
def test_the_answer_speaks_the_sports_language(name: str) -> None:
    found, words = usual(name), sport(name).words
    assert speaks_otherwise(found.bat)
    paragraphs = answer(found)
    assert paragraphs == sport_answer(found)
    text = " ".join(paragraphs)
    assert f"This {words.implement} hits best" in text and words.efficiency in text and words.tip in text
    assert f"{found.best.collision_efficiency:.2f}" in text
    assert ("mph" in text) == (words.speed_unit == "mph") and "knob" not in text and "pitch" not in text
    soft = [one for one in (sport(name).stroke.swing_speed, sport(name).stroke.ball_speed) if one.kind == "assumed"]
    assert text.count(ASSUMED_MARK) == len(soft)


def test_special_words_where_a_sport_has_them() -> None:
    if "golf" in OTHERS:
        assert "smash factor" in answer(usual("golf"))[0]
    if "field-hockey" in OTHERS:
        assert any("negative" in text for text in answer(usual("field-hockey")))
    if "tennis" in OTHERS:
        found = usual("tennis")
        place = dead_spot(found)
        assert place is not None and found.bat.length - 0.1 < place < found.bat.length
        assert any("dead spot" in text and "best bounce" in text for text in answer(found))
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
    tool = sport(name).implements[0]
    code, out, err = run("hit", tool, "--at", "4cm-from-tip")
    assert code == 0 and sport(name).words.efficiency in out, err
    assert "Hit 4.0 cm from the" in out


def test_a_ball_of_another_sport_is_said_aloud(run: Run) -> None:
    code, out, err = run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", "tennis")
    assert code == 0 and "is a ball of tennis" in err and "made for baseball" in err
    code, _, err = run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", "baseball")
    assert code == 0 and err == ""
    code, out, err = run("hit", "r161-ash", "--at", "6in-from-tip", "--ball", "tenis")
    assert code == 2 and out == "" and "Did you mean" in err
