"""Intervals of the best way to hit: held at the best contact, which hardly differs from searching anew."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.optimum import best_launch
from sweetspot.answers.flight import DRAG
from sweetspot.answers.optimum import drawn_optimum
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.uncertainty.sources import NOTHING, Source
from sweetspot.units import MPH, RPM


def test_a_held_launch_carries_as_far_as_one_searched_anew() -> None:
    """With a tenth less drag the best angle is another, and the carry there is the same to 0.3 %."""
    law, spin, speed = catalog.aerodynamics(), 2200 * RPM, 100 * MPH
    flying = FlightConditions(ball=catalog.ball(), aerodynamics=law, air=Air())
    best = best_launch(speed, flying, backspin=spin)
    left = batted_ball(speed=speed, launch_angle=best.launch_angle, backspin=spin, position=(0.0, 0.6096, 0.9144))
    sources = NOTHING.with_source(Source(DRAG, 0.1044, ""))
    answers, main = drawn_optimum(sources, launches=[(left, flying)], count=64)
    drag = sources.of(DRAG, sources.deviations(answers.normal))
    assert main == "launches.0.carry"
    carry = np.asarray(answers.columns["launches"][0]["carry"])  # type: ignore[index, call-overload]
    assert carry[0] == pytest.approx(best.carry)
    row = int(np.argmin(np.abs(drag + 0.1)))
    other = law.replaced(drag=law.drag * math.exp(drag[row]))
    anew = best_launch(speed, FlightConditions(ball=catalog.ball(), aerodynamics=other, air=Air()), backspin=spin)
    assert abs(anew.launch_angle - best.launch_angle) > 5e-4
    assert carry[row] == pytest.approx(anew.carry, rel=3e-3)


def test_the_command(run_json: Callable[..., Any]) -> None:
    asked = ("--pitch", "FF", "--exit-speed", "100mph", "--park", "fenway")
    found = run_json("optimum", *asked, "--bat-speed", "70mph±1mph", "--uncertainty")
    swing, launch, park = (found[name][0] for name in ("swings", "launches", "parks"))
    assert swing["carry_low_m"] < swing["carry_m"] < swing["carry_high_m"]
    assert swing["exit_speed_low_m_s"] < swing["exit_speed_m_s"] < swing["exit_speed_high_m_s"]
    assert 1 < launch["carry_high_m"] - launch["carry_low_m"] < 10
    assert 0.2 < park["exit_speed_high_m_s"] - park["exit_speed_low_m_s"] < 2
    assert "attack_angle_low_rad" not in swing
    assert "swing" in found["uncertainty"]["shares"]
    alone = run_json("optimum", "--show", "launch", "--exit-speed", "100mph", "--uncertainty")
    assert list(alone["uncertainty"]["sources"]) == [DRAG]
