"""Paddles in the numbers by which players compare them."""

from __future__ import annotations

import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.answers.paddle_numbers import paddle_face, paddle_in_doubt
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.numerics.interval import interval_of
from sweetspot.reports.comparison.document import compare_document
from sweetspot.uncertainty.sources import sources_of
from tests.paddles import paddle


def test_numbers_have_the_intervals_that_are_known() -> None:
    given = paddle()
    body, doubt = rigid_body(beam_model(given)), sources_of(given, standard_conditions(given)).doubt
    plain, sure = paddle_face(given, body), paddle_in_doubt(given, body, doubt)
    assert plain is not None
    assert sure is not None
    for name in ("swing_weight", "twist_weight", "pbcor"):
        whole = interval_of(getattr(sure, name))
        assert whole.value == pytest.approx(float(getattr(plain, name)))
        assert whole.low < whole.value < whole.high
    # mass and swing weight at the same mass differ by 3 % each, one sigma: 1.645 sqrt(2) 3 % of the swing weight
    swing = interval_of(sure.swing_weight)
    assert swing.high / swing.value - 1 == pytest.approx(1.645 * 2**0.5 * 0.03, rel=0.02)
    tennis = catalog.implement("tennis-racket")
    assert paddle_in_doubt(tennis, rigid_body(beam_model(tennis)), None) is None


def test_compare_says_twist_weight_sweet_zone_and_what_is_legal() -> None:
    answer = sweetspot.compare("pickleball-paddle", "pickleball-ruby")
    first, second = (bat.paddle for bat in answer.bats)
    assert first is not None
    assert second is not None
    assert float(first.twist_weight) > float(second.twist_weight)
    table = next(
        block for block in compare_document(answer).blocks if getattr(block, "title", "").startswith("As play")
    )
    heads = [str(column.heading) for column in table.columns]  # type: ignore[union-attr]
    assert any("twist" in head for head in heads) and any("sweet zone" in head for head in heads)
    assert len(table.rows) == 2  # type: ignore[union-attr]
