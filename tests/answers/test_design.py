"""A designed bat as an answer: its fields, frame and notebook cell."""

from __future__ import annotations

from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.answers.batter import BatterSetup
from sweetspot.answers.design import DesignAnswer, design_answer
from sweetspot.answers.design_question import DesignQuestion
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.errors import InputError
from sweetspot.numerics.interval import Interval
from sweetspot.units import INCH, MPH


@pytest.fixture(scope="module")
def question() -> DesignQuestion:
    """Return a racket's, whose every bat is made in no time."""
    racket = catalog.load_implement("tennis-racket")
    conditions = standard_conditions(racket)
    return DesignQuestion(
        bat=racket,
        batter=BatterSetup().of(racket, conditions),
        conditions=conditions,
        wants=("exit_speed",),
        population=8,
        generations=1,
    )


@pytest.fixture(scope="module")
def answer(question: DesignQuestion) -> DesignAnswer:
    return design_answer(question)


def test_every_number_has_its_unit_and_the_gain_its_interval(answer: DesignAnswer) -> None:
    gain = answer.gain.expected_exit_speed
    assert isinstance(gain, Interval) and gain.high - gain.value == pytest.approx(answer.gain.half_interval)
    metric, customary = answer.to_dict(), answer.to_dict(units="us")
    assert customary["gain"]["expected_exit_speed_low_mph"] == pytest.approx(gain.low / MPH)
    assert customary["measures"]["best_from_tip_in"] == pytest.approx(metric["measures"]["best_from_tip_m"] / INCH)
    assert customary["front"]["mass"] == metric["front"]["mass"]  # variables are SI, to go on from
    assert metric["handle_bending"] is None and answer.complete


def test_a_frame_has_a_row_for_every_bat_of_the_front(answer: DesignAnswer) -> None:
    frame = answer.to_frame()
    assert frame["bat"].to_list() == list(range(1, len(frame) + 1))
    assert frame["exit_speed_m_s"].is_sorted(descending=True)


def test_a_notebook_shows_what_the_command_prints(answer: DesignAnswer) -> None:
    assert "The best place" in answer._repr_html_() and answer.plot().axes


def test_where_the_ball_is_met_is_said_once(question: DesignQuestion) -> None:
    with pytest.raises(InputError, match="contact and player both say where the ball is met"):
        BatterSetup(contact=8 * INCH, player=Path("player.json")).of(question.bat, question.conditions)
