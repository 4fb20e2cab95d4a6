"""Sports as data: every number has a source and a certainty, and says so where it is from memory."""

from __future__ import annotations

import math

import pytest

from sweetspot import catalog, references
from sweetspot.catalog.sports import certainty, sport, sport_names, sport_records
from sweetspot.equipment.sport import ASSUMED_MARK, CERTAINTIES
from sweetspot.errors import InputError
from sweetspot.papers.sports import rule_book_drops, sport_rows

NAMES = sport_names()


def test_the_sports_are_those_of_the_balls() -> None:
    of_balls = {catalog.ball_sport(name).replace(" ", "-") for name in catalog.ball_names()}
    borrowed = {"youth-baseball": "baseball", "slow-pitch": "softball"}
    assert of_balls == set(NAMES) - set(borrowed)
    for name in NAMES:
        owners = {catalog.ball_sport(ball).replace(" ", "-") for ball in sport(name).balls}
        assert owners == {borrowed.get(name, name)}


@pytest.mark.parametrize("name", NAMES)
def test_every_number_has_a_source_and_memory_is_marked(name: str) -> None:
    found = sport(name)
    for one in found.numbers():
        references.reference(one.source)
        assert one.kind in CERTAINTIES and math.isfinite(one.value)
        assert (one.source == "recalled") <= (one.kind == "assumed"), one.name
        assert (ASSUMED_MARK in one.marked) == (one.kind == "assumed")
    assert sum(certainty(name).values()) == len(sport_records(name)) > len(found.numbers())
    assert found.not_covered and found.name and found.balls


@pytest.mark.parametrize("name", NAMES)
def test_strokes_are_ones_that_people_play(name: str) -> None:
    stroke = sport(name).stroke
    assert 5 < stroke.swing_speed.value < 60
    assert 0 <= stroke.ball_speed.value < 50
    assert 0 <= stroke.from_tip < 0.3 < stroke.hands + 0.3


def test_marks_lie_one_behind_the_other() -> None:
    for name in NAMES:
        distances = [mark.distance.value for mark in sport(name).marks]
        assert distances == sorted(distances)
    net = sport("tennis").marks[0]
    assert net.height is not None and (net.distance.value, net.height.value) == (11.89, 0.914)


def test_memory_is_never_a_rule() -> None:
    """Limits known from memory alone are the two of the cricket bat, and they say so."""
    soft = [(name, one.name) for name in NAMES for one in sport(name).limits if one.kind == "assumed"]
    assert soft == [("cricket", "length of the bat"), ("cricket", "width of the bat")]


def test_rule_book_drops() -> None:
    """Bands of the rule books, as printed [itf_ball, ittf_bounce]; see test_rule_book_drops for the physics."""
    assert 1.35 < rule_book_drops("tennis")["bound of the ball"].rebound < 1.47
    drops = rule_book_drops("table tennis")
    assert 0.24 < drops["bounce of the ball on steel"].rebound < 0.26
    assert drops["bounce on the table"].rebound == pytest.approx(0.23, abs=0.015)
    rows = [row for row in sport_rows(sport("tennis")) if row.equation == "Fig. 6"]
    assert [row.paper for row in rows] == ["135 to 147 cm"]
    assert all(isinstance(row.full_model, float) and 135 < row.full_model < 147 for row in rows)


def test_unknown_names_give_the_nearest() -> None:
    with pytest.raises(InputError, match="Did you mean tennis"):
        sport("tenis")
