"""A number that is pulled stays where the hand holds it, what is locked stays, and the rest moves little."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.catalog.rules import league
from sweetspot.designs.constraints import KEPT, Limit, drawn_values, kept_limits, nearest_within_limits
from sweetspot.designs.measures import Bench

BARREL = 7


def bands(bench: Bench, *names: str) -> tuple[Limit, ...]:
    return tuple(one for one in kept_limits(bench, names, league=None) if one.why == "kept as it is")


@pytest.mark.parametrize("names", [("mass",), ("mass", "moi"), ("mass", "moi", "balance_point", "handle")])
def test_what_is_locked_stays(bench: Bench, names: tuple[str, ...]) -> None:
    pulled = bench.space.start
    pulled[BARREL] *= 1.06
    found = nearest_within_limits(bench, pulled, bands(bench, *names), pulled=BARREL)
    values = drawn_values(bench, found)
    assert all(float(one.excess(values[one.measure])[0]) <= 0 for one in bands(bench, *names))
    assert found[BARREL] == pytest.approx(pulled[BARREL], rel=1e-3)
    widths = np.array([one.high - one.low for one in bench.space.variables])
    assert np.max(np.abs(found - pulled) / widths) < 0.2


def test_what_keeps_everything_is_left_alone_and_what_cannot_be_goes_as_far_as_it_can(bench: Bench) -> None:
    start = bench.space.start
    assert np.array_equal(nearest_within_limits(bench, start, bands(bench, *KEPT)), start)
    light = Limit("mass", None, 0.3, "nobody's bat")
    found = nearest_within_limits(bench, start, [light])
    low = np.array([one.low for one in bench.space.variables])
    assert np.all(found >= low - 1e-12) and drawn_values(bench, found)["mass"][0] > 0.3


def test_a_bbcor_limit_is_left_out_where_nothing_is_fired(bench: Bench) -> None:
    assert "bbcor" not in {one.measure for one in kept_limits(bench, (), league=league("ncaa"))}
