"""Limits that quarrel are named, with how far they are apart."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.catalog.rules import league
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.designs.constraints import Limit, band, check_limits, drawn_values, kept_limits, league_limits
from sweetspot.designs.gain import present_measured
from sweetspot.designs.measures import Bench, bench_of
from sweetspot.designs.spaces import hollow_space
from sweetspot.designs.turned import turned_space
from sweetspot.errors import InputError


def test_what_can_be_is_found(bench: Bench, limits: tuple[Limit, ...]) -> None:
    numbers = check_limits(bench, limits)
    values = drawn_values(bench, numbers)
    for limit in limits:
        assert limit.excess(values[limit.measure])[0] <= 0


def test_two_limits_that_exclude_each_other_are_named(bench: Bench, limits: tuple[Limit, ...]) -> None:
    heavy = Limit("moi", 0.24, None, "as given")
    light = Limit("mass", None, 0.80, "as given")
    words = r"these two limits exclude each other: mass at most .+ moment of inertia.+misses by [\d,.]+ oz in²"
    with pytest.raises(InputError, match=words):
        check_limits(bench, (light, heavy))


def test_one_limit_that_nothing_keeps_is_named(bench: Bench) -> None:
    with pytest.raises(InputError, match=r"no bat here has a length at most 30.00 in .762.0 mm. .+ misses by 4.00 in"):
        check_limits(bench, (Limit("length", None, 0.762, "as given"),))


def test_limits_without_sense_are_refused() -> None:
    with pytest.raises(InputError, match=r"goes from 35.27 oz .1000 g. down to 17.64 oz .500 g.; give the smaller"):
        Limit("mass", 1.0, 0.5, "as given")
    with pytest.raises(InputError, match="has no end"):
        Limit("mass", None, None, "as given")
    with pytest.raises(InputError, match="'beauty' is not known"):
        Limit("beauty", 0.0, None, "as given")
    assert band("mass", 0.9, part=0.01).least == pytest.approx(0.891)


def test_a_leagues_rules_are_its_own_numbers() -> None:
    found = {limit.measure: limit.most for limit in league_limits(league("mlb"), catalog.bat("mlb-a"))}
    assert found["diameter"] == pytest.approx(2.61 * 0.0254)
    assert found["length"] == pytest.approx(42 * 0.0254)
    assert found["cup_depth"] == pytest.approx(0.0254)
    hollow = {limit.measure for limit in league_limits(league("ncaa"), catalog.bat("single-wall"))}
    assert {"drop", "length", "diameter"} <= hollow


def test_only_turned_wood_has_an_outline_to_pull() -> None:
    with pytest.raises(InputError, match="not turned from one piece"):
        turned_space(catalog.bat("single-wall"))
    with pytest.raises(InputError, match="has no wall"):
        hollow_space(catalog.bat("mlb-a"))


def test_what_is_fired_at_keeps_its_leagues_bbcor_or_bpf(bench: Bench) -> None:
    """The batch's BBCOR and BPF are those of the certification, and a limit of a league that has one."""
    bat = catalog.bat("slow-pitch")
    hollow = bench_of(hollow_space(bat), bench.batter, standard_conditions(bat))
    found, whole = present_measured(hollow).values, certify(bat, ball=hollow.conditions.ball)
    assert found["bbcor"][0] == pytest.approx(whole.bbcor, abs=1e-3)
    assert found["bpf"][0] == pytest.approx(whole.bpf, abs=2e-3)
    for name, most in (("softball", 1.20), ("usssa", 1.15), ("little-league", 1.15)):
        assert Limit("bpf", None, most, league(name).name) in kept_limits(hollow, (), league=league(name))
    assert not {"bbcor", "bpf"} & {one.measure for one in kept_limits(bench, (), league=league("usssa"))}
