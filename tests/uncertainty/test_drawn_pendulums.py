"""A pendulum's interval against the closed form of its errors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sweetspot.calibration.measured import Measured
from sweetspot.numerics.confidence import REACH
from sweetspot.uncertainty.drawn_pendulums import Hung, drawn_pendulum

HUNG = Hung(
    mass=Measured(0.88, 0.003), balance_point=Measured(0.56, 0.001), pivot=Measured(0.1524, 0.0),
    swung=Measured(1.4545, 0.003), timed=True,
)  # fmt: skip


def test_a_moment_by_a_period() -> None:
    """I goes as M d T^2: the parts of its variance are those of M, of d and four times those of T."""
    answers = drawn_pendulum(HUNG)
    parts = np.array([0.003 / 0.88, 0.001 / (0.56 - 0.1524), 2 * 0.003 / 1.4545]) ** 2
    moi, reach = answers.values["moi_kg_m2"][0], answers.reach("moi_kg_m2")
    half = REACH * moi * parts.sum() ** 0.5
    assert [float(reach.below), float(reach.above)] == pytest.approx([half, half], rel=0.03)  # T^2 is crooked
    shares = answers.shares("moi_kg_m2")
    told = [shares[name] for name in ("weight", "balance point", "period")]
    assert told == pytest.approx((parts / parts.sum()).tolist(), abs=0.01)
    assert shares["together"] < 0.001


def test_a_period_by_a_moment_goes_back() -> None:
    moi = drawn_pendulum(HUNG).values["moi_kg_m2"][0]
    back = replace(HUNG, swung=Measured(float(moi), 0.001), timed=False)
    assert drawn_pendulum(back).values["period_s"][0] == pytest.approx(1.4545)


def test_the_command(run_json: Callable[..., Any], run: Callable[..., tuple[int, str, str]]) -> None:
    bat = ("pendulum", "--mass", "31.0oz", "--balance-point", "22.05in±0.05in", "--period", "1.4545s±0.003s")
    told = run_json(*bat, "--uncertainty")
    assert told["moi_low_kg_m2"] < told["moi_kg_m2"] < told["moi_high_kg_m2"]
    assert list(told["uncertainty"]["sources"]) == ["weight", "balance point", "period"]
    code, _, err = run(*bat)
    assert code == 2 and "errors are for" in err
