"""A bat test and the rules held against it: fields, intervals, and how probable it is that each rule is kept."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.answers.certify import CertifyQuestion, RuleCheck, certify_answer
from sweetspot.catalog.rules import league
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.errors import InputError
from sweetspot.numerics.interval import Interval
from sweetspot.reports.notebook import document_of
from sweetspot.uncertainty.sources import sources_of


def question(name: str, *, leagues: tuple[str, ...] = ("ncaa",), sure: bool = False) -> CertifyQuestion:
    bat, ball = catalog.bat(name), catalog.ball()
    sources = sources_of(bat, standard_conditions(bat).replaced(ball=ball)) if sure else None
    return CertifyQuestion(bat, [league(one) for one in leagues], ball, sources=sources, draws=64)


def of(checks: tuple[RuleCheck, ...], quantity: str) -> RuleCheck:
    return next(one for one in checks if one.quantity == quantity)


def test_what_a_rule_limits_is_the_number_of_the_test() -> None:
    answer = certify_answer(question("college-alloy"))
    limited = of(answer.checks, "bbcor")
    assert answer.test is not None and limited.value == answer.test.bbcor
    assert limited.most == 0.5 and limited.margin == pytest.approx(0.5 - float(answer.test.bbcor))
    assert limited.passes_probability is None and answer.passes is None and answer.uncertainty is None
    assert answer.passed and answer.verdict == "pass" and not answer.sure


def test_draws_put_an_interval_beside_value_and_margin_and_a_chance_beside_the_rule() -> None:
    """Exact: what is added to the value is taken from the margin below a greatest value."""
    answer = certify_answer(question("college-alloy", sure=True))
    limited = of(answer.checks, "bbcor")
    assert answer.test is not None
    assert isinstance(limited.value, Interval) and isinstance(limited.margin, Interval)
    assert limited.value == answer.test.bbcor
    assert limited.margin.low == pytest.approx(0.5 - limited.value.high)
    assert limited.margin.high == pytest.approx(0.5 - limited.value.low)
    assert limited.passes_probability is not None and 0 < limited.passes_probability < 1
    open_one = of(answer.checks, "moi")
    assert isinstance(open_one.value, Interval) and open_one.margin is None, "what no limit is known of has a value"
    assert of(answer.checks, "length").passes_probability is None, "a length is no matter of chance"
    assert answer.passes is not None
    assert [one.quantity for one in answer.passes] == [
        one.quantity for one in answer.checks if one.passes_probability is not None
    ]
    assert answer.to_dict()["checks"][0]["league_name"] == "NCAA and NFHS"


def test_a_wall_is_asked_only_of_a_limit() -> None:
    asked = question("college-alloy", leagues=("mlb",))
    with pytest.raises(InputError, match="no rule of this league limits BBCOR or BPF"):
        certify_answer(CertifyQuestion(asked.bat, asked.leagues, asked.ball, passing_wall=True))


def test_a_notebook_shows_it() -> None:
    document = document_of(certify_answer(question("r161-ash")))
    assert document.name == "certify" and document.passed
