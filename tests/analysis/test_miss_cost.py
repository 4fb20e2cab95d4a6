"""What a miss costs, and how that follows from the law of the ball."""

from __future__ import annotations

import math

import pytest

from sweetspot import analyse, catalog, standard_conditions
from sweetspot.analysis.bat_analysis import Analysis, law_scans, miss_costs
from sweetspot.analysis.drop_test import fire
from sweetspot.analysis.sweet_spot import miss_cost
from sweetspot.dynamics.block import Block
from sweetspot.equipment.ball import Ball
from sweetspot.units import INCH, MPH


def test_the_interval_holds_our_own_cost(analysis: Analysis) -> None:
    distances = (INCH, 2 * INCH, 3 * INCH)
    for distance, both in zip(distances, miss_costs(analysis, distances), strict=True):
        for ours, loss in zip(miss_cost(analysis.scan, distance), both, strict=True):
            assert loss.value == ours
            assert loss.low <= loss.value <= loss.high
            assert loss.low > 0
    narrow, _, wide = miss_costs(analysis, distances)
    assert wide[0].high - wide[0].low > narrow[0].high - narrow[0].low


def test_a_miss_off_the_bat_costs_nothing_that_can_be_said(analysis: Analysis) -> None:
    ((inside, outside),) = miss_costs(analysis, (10 * INCH,))
    assert inside.value > 0
    assert math.isnan(outside.value)


@pytest.mark.parametrize("deviation", [-1, 1])
def test_every_law_leaves_a_wall_of_ash_alike(baseball: Ball, deviation: int) -> None:
    """The rule's test [kagan2004] is one of three that the ball passes whatever the rate's share of its loss."""
    wall = Block(material=catalog.material("white ash"), thickness=4 * INCH)
    found = [fire(wall, ball=ball, speed=58 * MPH).restitution for ball in (baseball, baseball.with_law(deviation))]
    assert found[1] == pytest.approx(found[0], abs=1e-3)


def test_the_law_is_worth_most_on_a_bat_whose_wall_springs(analysis: Analysis) -> None:
    bat = catalog.bat("single-wall")
    wood, hollow = (
        [scan.exit_speed.max() for scan in law_scans(bat_analysis, reach=2 * INCH)]
        for bat_analysis in (analysis, analyse(bat, standard_conditions(bat)))
    )
    assert abs(wood[1] - wood[0]) < 0.5 * MPH
    assert abs(hollow[1] - hollow[0]) > 1.5 * MPH
