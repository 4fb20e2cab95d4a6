"""Reliability has intervals that hold as often as they should, and is not given from three balls a player."""

from __future__ import annotations

import numpy as np
import polars as pl
import pytest

from sweetspot.seasons.pooling import Spread, pooled


def _spread(random: np.random.Generator, *, players: int, balls: int, between: float) -> Spread:
    true = random.normal(0, between, players)
    value = true[:, None] + random.normal(0, 1, (players, balls))
    frame = pl.DataFrame({"who": np.repeat(np.arange(players), balls).astype(str), "value": value.ravel()})
    return pooled(frame, key="who", measure="value")[1]


@pytest.mark.parametrize("between", [0.1, 0.3, 1.0])
def test_intervals_hold_nine_times_in_ten(between: float) -> None:
    """Of 300 made-up leagues; their number then scatters by 1.7 points."""
    random, at = np.random.default_rng(7), 34
    truth = at * between**2 / (1 + at * between**2)
    found = [_spread(random, players=30, balls=12, between=between).reliability_interval(at) for _ in range(300)]
    held = [interval.low <= truth <= interval.high for interval in found if interval is not None]
    assert len(held) == 300 and 0.85 <= float(np.mean(held)) <= 0.95


def test_three_balls_a_player_tell_no_reliability() -> None:
    few = _spread(np.random.default_rng(8), players=19, balls=3, between=0.3)
    assert few.reliability_interval(34) is None and few.mean_balls == pytest.approx(3.0)


def test_more_balls_narrow_the_interval_and_the_value_lies_in_it() -> None:
    widths = []
    for balls in (6, 24, 96):
        interval = _spread(np.random.default_rng(9), players=60, balls=balls, between=0.3).reliability_interval(100)
        assert interval is not None and interval.low <= interval.value <= interval.high
        widths.append(interval.high - interval.low)
    assert widths[0] > widths[1] > widths[2]
