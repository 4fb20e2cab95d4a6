"""Bats side by side: the same fields with intervals, by straight lines and by draws."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.comparison import Comparison, compare
from sweetspot.answers.compare import CompareQuestion, chance_above_zero, compare_answer, compare_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.interval import Band, Interval
from sweetspot.reports.notebook import document_of
from sweetspot.uncertainty.sources import Sources, sources_of


@cache
def found() -> tuple[Comparison[Implement], tuple[Sources, ...]]:
    bats = [catalog.bat("r161-ash"), catalog.bat("mlb-a")]
    comparison = compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law())
    return comparison, tuple(sources_of(one.analysis.bat, one.analysis.conditions) for one in comparison.compared)


@pytest.mark.parametrize("drawn", [False, True])
def test_lines_and_draws_give_the_same_fields_with_intervals(drawn: bool) -> None:
    comparison, sources = found()
    answer = compare_of(comparison, sources, drawn=drawn, draws=64)
    first, second = answer.bats
    numbers = [
        second.bat_speed, second.exit_speed, second.change, second.swung_faster, second.break_even_bat_speed,
        second.max_bbcor, second.max_collision_efficiency, second.bending_1, second.bat.moi_6in,
    ]  # fmt: skip
    for number in numbers:
        assert isinstance(number, Interval) and number.low < number.value < number.high
    assert isinstance(first.change, Interval) and first.change.low == first.change.value == first.change.high == 0
    change = second.scan.change
    assert isinstance(change, Band)
    known = np.isfinite(change.value) & np.isfinite(change.low)
    assert np.all(change.low[known] <= change.value[known]) and np.all(change.value[known] <= change.high[known])
    assert (answer.uncertainty is not None) == drawn


def test_a_speed_with_its_interval_stands_below_one_key() -> None:
    comparison, sources = found()
    bare, sure = (compare_of(comparison, one).to_dict()["bats"][1] for one in (None, sources))
    assert bare["change_m_s"]["low"] == bare["change_m_s"]["value"] == sure["change_m_s"]["value"]
    assert sure["change_m_s"]["low"] < sure["change_m_s"]["value"] < sure["change_m_s"]["high"]
    assert "max_bbcor_low" in sure and "max_bbcor_low" not in bare


def test_a_gain_is_as_probable_as_draws_have_it() -> None:
    comparison, sources = found()
    answer = compare_of(comparison, sources, drawn=True, draws=64)
    assert answer.uncertainty is not None
    (gain,) = answer.uncertainty.gains
    assert gain.exit_speed_gain == answer.bats[1].change and 0 < gain.faster_probability < 1
    assert answer.uncertainty.of == "bats.1.change"


def test_no_difference_is_as_often_faster_as_slower() -> None:
    assert chance_above_zero(np.zeros(9)) == 0.5


def test_rules_are_those_of_each_bat_s_own_sport() -> None:
    bats = [catalog.bat("r161-ash"), catalog.bat("slow-pitch")]
    answer = compare_answer(CompareQuestion(bats, standard_conditions(bats[0]), None, rules=True))
    wooden, metal = (bat.certificate for bat in answer.bats)
    assert wooden is not None and {one.league for one in wooden.checks} == {"ncaa", "mlb"}
    assert metal is not None and {one.league for one in metal.checks} == {catalog.sport("slow-pitch").rules}
    assert answer.to_dict()["bats"][0]["rules"]["verdict"] == wooden.verdict


def test_a_notebook_shows_it() -> None:
    comparison, sources = found()
    assert document_of(compare_of(comparison, sources)).name == "compare"
