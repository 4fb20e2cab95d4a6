"""How sure an exit speed is for the ball alone."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.catalog.balls import ball_spreads
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.uncertainty.ranking_draws import response_of_efficiency
from sweetspot.uncertainty.sources import error_by_ball


def test_spreads_of_the_catalogue(baseball: Ball) -> None:
    spreads = ball_spreads(baseball)
    assert spreads["mass"] == pytest.approx(0.125 / 5.125)
    assert spreads["stiffness"] == pytest.approx(2.5 * 5 / 37)
    assert ball_spreads(baseball.replaced(name="my own")) == {}


def test_the_quick_answer_is_that_of_the_response(analysis: Analysis[Bat]) -> None:
    """The quick answer of every report beside what moves the ball's patch too: v = q v_ball + (1 + q) v_bat."""
    place, conditions = analysis.sweet_spots.max_exit_speed, analysis.conditions
    response = response_of_efficiency(analysis.beam, conditions, unknowns=(), positions=np.array([place]))
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    quick = error_by_ball(analysis.reduced, conditions=conditions, position=place)
    assert quick == pytest.approx(closing * float(np.linalg.norm(response.slopes[:, 0] * response.spreads)), rel=0.01)
