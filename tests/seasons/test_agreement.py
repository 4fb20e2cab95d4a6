"""What of a season agrees with its tables, in one line."""

from __future__ import annotations

import pytest

from sweetspot.seasons.agreement import agreement_of
from sweetspot.seasons.home_run_table import HomeRunsOf
from sweetspot.seasons.season_drag import LeftOver
from sweetspot.units import FOOT


def kind(expected: float, hit: int, spread: float) -> HomeRunsOf:
    return HomeRunsOf(0.1, 0.2, 400, expected, hit, spread)


@pytest.mark.parametrize(
    ("expected", "hit", "spread", "agrees"),
    [(105.0, 100, 1.0, 1), (120.0, 100, 1.0, 0), (120.0, 100, 10.0, 1), (1.0, 4, 1.0, 0)],
)
def test_home_runs_agree_within_a_tenth_or_two_deviations(
    expected: float, hit: int, spread: float, agrees: int
) -> None:
    found = agreement_of({"launch_angle": [kind(expected, hit, spread)], "home_run_here": [kind(1, 90, 1)]}, {})
    assert (found.home_run_kinds, found.home_runs_agree) == (1, agrees)


def test_kinds_without_home_runs_are_not_counted() -> None:
    assert agreement_of({"pull": [kind(0.2, 0, 0.4)]}, {}).home_run_kinds == 0


def test_distances_agree_within_five_feet_or_two_errors() -> None:
    groups = [LeftOver(4 * FOOT, 0.1, 300, 0.3), LeftOver(-8 * FOOT, 0.1, 100, 0.4), LeftOver(8 * FOOT, 2.0, 100, 0.5)]
    found = agreement_of({}, {"launch_angle": groups, "park": [LeftOver(30.0, 0.1, 50, None, "x")]})
    assert (found.distance_kinds, found.distances_agree) == (3, 2)
    assert found.distance_above == pytest.approx((4 * 300 - 8 * 100 + 8 * 100) / 500 * FOOT)


def test_nothing_known_agrees_with_nothing() -> None:
    found = agreement_of({}, {})
    assert found.distance_above is None and found.distances_agree == found.home_runs_agree == 0
