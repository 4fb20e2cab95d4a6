"""The three parts of what is not known of a ball, and what they leave to an exit speed."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import beam_model, catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.answers.certify import CertifyQuestion, certify_answer
from sweetspot.catalog.balls import BALL_LAW, MEAN_BALL, THIS_BALL, ball_doubts, slope_doubt
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.drawn_hits import speed_doubt
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.ranking_draws import response_of_efficiency
from sweetspot.uncertainty.sources import Sources, errors_by_ball, sources_of, sources_of_ball
from sweetspot.units import MPH

PARTS = (THIS_BALL, MEAN_BALL, BALL_LAW)


def test_every_ball_has_three_parts(baseball: Ball) -> None:
    """Two have no doubt of their mean: they are so much below and above that of the baseball by definition."""
    for name in catalog.ball_names():
        by_definition = {MEAN_BALL} if name in ("baseball-dead", "baseball-lively") else set()
        assert {doubt.part for doubt in ball_doubts(catalog.ball(name))} == set(PARTS) - by_definition
    assert ball_doubts(baseball.replaced(spread=None)) == ()


def test_a_line_of_restitution_turns_about_what_wood_certifies_at(baseball: Ball) -> None:
    """Another slope changes the level at the rule's speed by 123 - 58 mph of it, and nothing at the anchor."""
    slope, anchor = slope_doubt(baseball)
    (turning,) = [doubt for doubt in ball_doubts(baseball) if "restitution_slope" in dict(doubt.deviation)]
    assert turning.part == BALL_LAW and anchor == pytest.approx(123 * MPH)
    turned = baseball.deviated(dict(turning.deviation)).restitution
    law = baseball.restitution
    assert turned.at(anchor) == pytest.approx(law.at(anchor), abs=1e-12)
    assert turned.at(law.reference_speed) - law.at(law.reference_speed) == pytest.approx(
        slope * (anchor - law.reference_speed)
    )
    assert turned.slope - law.slope == pytest.approx(slope)


def test_the_parts_deviate_together_in_one_ball(baseball: Ball) -> None:
    sources = Sources(NO_DOUBT, sources_of_ball(baseball))
    off = np.zeros((2, len(sources.others)))
    off[1] = 1.0
    plain, other = sources.balls(baseball, off)
    assert plain == baseball
    one_by_one = baseball
    for source in sorted(sources.others, key=lambda source: dict(source.ball).keys() != {"law"}):
        one_by_one = source.deviated(one_by_one, 1.0)
    assert other.mass == pytest.approx(one_by_one.mass)
    assert other.restitution.at(60.0) == pytest.approx(one_by_one.restitution.at(60.0), abs=1e-4)


def test_an_exit_speed_with_a_bat_that_was_measured(r161: Bat) -> None:
    """[the three parts: 0.8, 0.6 and 0.5 mph]: with the bat, weighed, balanced and with its own outline, 1.2 to 1.7."""
    bat = r161.replaced(outline_assumed=False)
    bat = bat.replaced(balance_point=rigid_body(beam_model(bat)).balance_point)
    analysis = analyse(bat, standard_conditions(bat))
    doubt = speed_doubt(analysis, sources_of(bat, analysis.conditions))
    assert doubt is not None
    assert 1.2 * MPH < REACH * doubt.error < 1.7 * MPH
    by_part = {part: REACH * doubt.error * doubt.shares[part] ** 0.5 / MPH for part in PARTS}
    assert by_part[THIS_BALL] == pytest.approx(0.84, abs=0.15)
    assert by_part[MEAN_BALL] == pytest.approx(0.6, abs=0.1)
    assert by_part[BALL_LAW] == pytest.approx(0.5, abs=0.15)


def test_the_quick_answer_is_that_of_the_response(analysis: Analysis[Bat]) -> None:
    """The quick answer of every report beside what moves the ball's patch too: v = q v_ball + (1 + q) v_bat."""
    place, conditions = analysis.sweet_spots.max_exit_speed, analysis.conditions
    response = response_of_efficiency(analysis.beam, conditions, unknowns=(), positions=np.array([place]))
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    quick = errors_by_ball(analysis.reduced, conditions=conditions, position=place)
    assert quick is not None
    assert quick.whole == pytest.approx(closing * float(np.linalg.norm(response.slopes[:, 0])), rel=0.03)


@pytest.mark.parametrize(("name", "least", "most"), [("r161-ash", 0.0, 0.004), ("single-wall", 0.005, 0.02)])
def test_a_test_carries_the_law(name: str, least: float, most: float) -> None:
    """[ball law: wood hardly, a single wall by 0.009]: half of the range of BBCOR at both ends of the law."""
    answer = certify_answer(CertifyQuestion(catalog.bat(name), (), catalog.ball()))
    assert answer.test is not None and answer.test.spread_by_law is not None
    low, high = answer.test.spread_by_law.bbcor
    assert least < (high - low) / 2 < most
