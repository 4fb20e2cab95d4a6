"""Intervals of a drop test: followed by slope and bend, they are those of tests done anew."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.drop_test import Rebound, fire
from sweetspot.answers.drop import drawn_drop, drop_sources
from sweetspot.catalog.balls import BALL_LAW, MEAN_BALL
from sweetspot.dynamics.block import Block
from sweetspot.equipment.ball import Ball
from sweetspot.uncertainty.intervals import interval_ends, variance_shares

SPEED = 8.0


def fired(block: Block, ball: Ball, more: float) -> Rebound:
    return fire(block, ball=ball, speed=SPEED + more)


def test_draws_are_tests_done_anew() -> None:
    block = Block(material=catalog.material("white-ash"), thickness=0.05)
    rebound = fired(block, catalog.ball(), 0.0)
    sources = drop_sources(block, catalog.ball(), speed_error=0.3)
    drawn = drawn_drop(rebound, sources, fired, count=64)
    off = sources.deviations(drawn.normal)
    restitution = np.asarray(drawn.columns["restitution"])
    assert restitution[0] == pytest.approx(rebound.restitution)
    column = sources.names.index(MEAN_BALL)
    law, (restitution_size,) = rebound.ball.restitution, [size for _, size in sources.others[column].ball]
    row = int(np.argmax(np.abs(drawn.normal[:, column])))
    change = restitution_size * off[row, column]
    other = rebound.ball.replaced(restitution=law.replaced(reference=law.reference + change))
    done = fired(block, other, 0.0).restitution
    shares = variance_shares(drawn.normal[1:], sources.names, restitution[1:])
    low, high = interval_ends(restitution[1:])
    assert max(shares, key=lambda name: shares[name]) == BALL_LAW  # far below its anchor
    assert low < rebound.restitution < high
    assert abs(done - rebound.restitution) == pytest.approx(abs(change), rel=0.2)  # e is the ball's on a block


def test_the_command(run_json: Callable[..., Any], run: Callable[..., tuple[int, str, str]]) -> None:
    found = run_json("drop", "--uncertainty")
    assert found["rebound_height_low_m"] < found["rebound_height_m"] < found["rebound_height_high_m"]
    assert found["energy_j"]["ball_low"] < found["energy_j"]["ball"]
    assert found["uncertainty"]["of"] == "restitution"
    code, out, _ = run("drop", "--speed", "60mph±1mph", "--uncertainty")
    assert code == 0
    assert "26.82 ± 0.7" in out
