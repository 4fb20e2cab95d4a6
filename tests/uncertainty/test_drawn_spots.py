"""Sweet spots, zones, misses and nodes of many draws at once against one bat's, one by one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import analyse, catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.sweet_spot import max_exit_speed, miss_cost, sweet_zone
from sweetspot.answers.report import Miss
from sweetspot.answers.report_draws import DESCRIBED
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.drawn_hits import draws_of
from sweetspot.uncertainty.drawn_spots import best_positions, costs_of_misses, drawn_nodes, sweet_zones
from sweetspot.uncertainty.sources import sources_of


@pytest.fixture(scope="module")
def analysis() -> Analysis[Bat]:
    bat = catalog.bat()
    return analyse(bat, standard_conditions(bat))


@pytest.fixture(scope="module")
def curves(analysis: Analysis[Bat]) -> tuple[Array, Array]:
    """The described bat's exit speed and sting, and such that are shifted, tilted, spiked or without a zone."""
    scan = analysis.scan
    off = (scan.position - scan.position.mean())[None, :] * np.array([0.0, 6.0, -8.0, 0.0, 0.0])[:, None]
    speed = scan.exit_speed + off
    speed[3, 40] += 30.0  # a spike of few millimetres is no place to hit
    sting = scan.sting * np.array([1.0, 1.1, 0.8, 1.0, 1.0])[:, None]
    sting[4] = 1.0
    return speed, sting


def test_places_and_zones_are_those_of_every_bat_alone(analysis: Analysis[Bat], curves: tuple[Array, Array]) -> None:
    speed, sting = curves
    found = sweet_zones(analysis.scan.position, speed, sting)
    alone = [
        sweet_zone(replace(analysis.scan, exit_speed=fast, sting=stings))
        for fast, stings in zip(speed, sting, strict=True)
    ]
    assert alone[4] is None and any(alone)
    expected = [zone or (np.nan, np.nan) for zone in alone]
    assert found == pytest.approx(np.array(expected), abs=3e-4, nan_ok=True)  # that one looks at places 0.2 mm apart
    tops = best_positions(analysis.scan.position, speed[:3])
    assert tops == pytest.approx([max_exit_speed(replace(analysis.scan, exit_speed=one)) for one in speed[:3]])


def test_misses_cost_what_they_cost_every_bat_alone(analysis: Analysis[Bat], curves: tuple[Array, Array]) -> None:
    speed, position = curves[0], analysis.scan.position
    near, far = costs_of_misses(position, speed, [Miss(0.05, 1.0, 1.0), Miss(0.5, 1.0, np.nan)])
    for row, one in enumerate(speed):
        alone = miss_cost(replace(analysis.scan, exit_speed=one), 0.05)
        assert (near["inside"][row], near["outside"][row]) == pytest.approx(alone)
    assert np.isnan(far["outside"]).all()


@pytest.mark.parametrize("name", ["r161-ash", "college-alloy", "tennis-racket", "golf-driver"])
def test_nodes_follow_the_bat(name: str) -> None:
    bat = catalog.implement(name)
    conditions = standard_conditions(bat)
    other = None if isinstance(bat, Bat) else unknowns_of(bat)
    known = None if other is None else (other, 0.01**2 * np.eye(len(other)))  # after they were measured
    sources = sources_of(bat, conditions, calibration=known)
    beam = beam_model(bat) if other is None else described(bat)
    draws = draws_of(beam, conditions, sources, count=2)
    off = sources.deviations(draws.normal)[1, : len(sources.unknowns)]
    own = all_modes(deviated(beam, sources.unknowns, off), conditions.ball)
    found = drawn_nodes(draws, DESCRIBED)
    for index in range(5):
        assert found[index][1] == pytest.approx(own.nodes(index + 2), abs=2e-4)
    assert len(found) == sum(family in DESCRIBED for family in own.families)
