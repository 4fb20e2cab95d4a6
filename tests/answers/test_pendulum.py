"""A pendulum's interval against the closed form of its errors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sweetspot.answers.pendulum import PendulumQuestion, pendulum_answer
from sweetspot.calibration.measured import Measured
from sweetspot.numerics.interval import REACH, Interval

HUNG = PendulumQuestion(
    mass=Measured(0.88, 0.003),
    balance_point=Measured(0.56, 0.001),
    pivot=Measured(0.1524, 0.0),
    swung=Measured(1.4545, 0.003),
    timed=True,
    uncertain=True,
)


def test_a_moment_by_a_period() -> None:
    """I goes as M d T^2: the parts of its variance are those of M, of d and four times those of T."""
    answer = pendulum_answer(HUNG)
    parts = np.array([0.003 / 0.88, 0.001 / (0.56 - 0.1524), 2 * 0.003 / 1.4545]) ** 2
    moi = answer.moi
    assert isinstance(moi, Interval) and answer.uncertainty is not None
    half = REACH * moi.value * parts.sum() ** 0.5
    assert [moi.value - moi.low, moi.high - moi.value] == pytest.approx([half, half], rel=0.03)  # T^2 is crooked
    shares = answer.uncertainty.shares
    told = [shares[name] for name in ("weight", "balance point", "period")]
    assert told == pytest.approx((parts / parts.sum()).tolist(), abs=0.01)
    assert shares["together"] < 0.001


def test_a_period_by_a_moment_goes_back() -> None:
    moi = float(pendulum_answer(HUNG).moi)
    back = pendulum_answer(replace(HUNG, swung=Measured(moi, 0.001), timed=False))
    assert float(back.period) == pytest.approx(1.4545)
    assert isinstance(back.period, Interval) and back.uncertainty is not None and back.uncertainty.of == "period"


def test_the_command(run_json: Callable[..., Any], run: Callable[..., tuple[int, str, str]]) -> None:
    bat = ("pendulum", "--mass", "31.0oz", "--balance-point", "22.05in±0.05in", "--period", "1.4545s±0.003s")
    told = run_json(*bat, "--uncertainty")
    assert told["moi_low_kg_m2"] < told["moi_kg_m2"] < told["moi_high_kg_m2"]
    assert list(told["uncertainty"]["sources"]) == ["weight", "balance point", "period"]
    code, _, err = run(*bat)
    assert code == 2 and "errors are for" in err
