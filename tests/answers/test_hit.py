"""One collision as every consumer asks for it."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.answers.hit import HitQuestion, hit_answer
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.errors import InputError
from sweetspot.numerics.interval import Interval
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import MPH


def question(name: str, from_tip: float, *, sure: bool = False) -> HitQuestion:
    tool = catalog.load_implement(name)
    conditions = standard_conditions(tool)
    sources = sources_of(tool, conditions) if sure else None
    return HitQuestion(tool, conditions, tool.length - from_tip, sources=sources, draws=64)


@pytest.mark.parametrize("name", ["r161-ash", "college-alloy", "tennis-racket"])
def test_an_answer_holds_the_collision_and_what_follows_from_it(name: str) -> None:
    """Exact: exit speed from q, and the parts of the energy add up."""
    asked = question(name, 0.15)
    answer = hit_answer(asked)
    q, pitch = float(answer.collision_efficiency), asked.conditions.pitch.speed
    assert float(answer.exit_speed) == pytest.approx(q * pitch + (1 + q) * float(answer.bat_speed))
    assert float(answer.exit_speed) == exit_speed_of(answer.impact, asked.conditions)
    shares = answer.to_dict()["energy_share"]
    assert sum(part for part_name, part in shares.items() if part_name != "incoming") == pytest.approx(1, abs=1e-3)
    assert answer.uncertainty is None and answer.exit_speed_half_by_ball is not None
    assert (answer.damage is None) == (name == "tennis-racket")


def test_intervals_hold_their_numbers_and_shares_add_up() -> None:
    answer = hit_answer(question("r161-ash", 0.15, sure=True))
    numbers = [answer.exit_speed, answer.collision_efficiency, answer.energy.heat, answer.bat.moi_6in, answer.ball_mass]
    for number in numbers:
        assert isinstance(number, Interval)
        assert number.low <= number.value <= number.high
    assert answer.uncertainty is not None and answer.uncertainty.draws == 64
    assert sum(answer.uncertainty.shares.values()) == pytest.approx(1)
    assert answer.exit_speed_half_by_ball is None  # it is part of the interval


def test_a_frame_has_one_row_of_what_stands_alone() -> None:
    answer = hit_answer(question("r161-ash", 0.15))
    frame = answer.to_frame("us")
    assert frame.height == 1
    assert frame["exit_speed_mph"][0] == pytest.approx(float(answer.exit_speed) / MPH)
    assert "history" not in frame.columns


def test_a_place_off_the_bat_is_refused() -> None:
    with pytest.raises(InputError, match="position"):
        hit_answer(question("r161-ash", -0.05))


def test_the_history_is_that_of_the_impact() -> None:
    answer = hit_answer(question("r161-ash", 0.15))
    history = answer.to_dict()["history"]
    assert np.max(history["force_n"]) == pytest.approx(float(answer.peak_force), rel=1e-3)
