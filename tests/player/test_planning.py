"""Plans of swings: which bats, how many, in which order; and whether to stop."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH
from sweetspot.player.planning import BLOCK, MOST_PLANNED, SwingPlan, SwingScatter, leaded, swing_plan
from sweetspot.player.prior import fixed, priors
from sweetspot.units import INCH, MPH, OUNCE

OWN, LAW = catalog.bat("r161-ash"), catalog.swing_law()
USUAL = SwingScatter.usual()
HEAVY = leaded(OWN, 6 * OUNCE)


def plan_of(within: float = 0.08) -> SwingPlan:
    return swing_plan([OWN, HEAVY], aim="exponent", within=within, law=LAW, scatter=USUAL)


def test_the_error_is_that_of_a_straight_line() -> None:
    """Exact: least squares of log speed against log moment of inertia, with the prior as one more measurement."""
    plan = plan_of()
    x = np.log([rigid_body(beam_model(bat)).moi(bat.choke + LAW.axis) for bat in plan.order])
    noisy = (USUAL.bat_speed_spread**2 + fixed("bat_speed_noise") ** 2) / USUAL.bat_speed**2
    slope = (1 - fixed("slow_part")) * np.sum((x - x.mean()) ** 2) / noisy
    assert plan.expected_error == pytest.approx(REACH / math.sqrt(slope + priors()["exponent"].width ** -2))
    assert plan.enough and plan.expected_error <= 0.08


def test_the_place_is_found_as_a_mean_of_marks() -> None:
    """Exact: the standard error of a mean of so many marks, with the prior."""
    plan = swing_plan([OWN, HEAVY], aim="position", within=0.4 * INCH, law=LAW, scatter=USUAL)
    assert plan.bats == (OWN,) and plan.order == (OWN,) * plan.each
    mean = (USUAL.position_spread**2 + fixed("position_noise") ** 2) / plan.each
    assert plan.expected_error == pytest.approx(REACH / math.sqrt(1 / mean + priors()["position"].width ** -2))


@given(st.floats(0.05, 0.12), st.floats(2.0, 6.0))
def test_no_fewer_swings_would_do(within: float, spread: float) -> None:
    scatter = replace(USUAL, bat_speed_spread=spread * MPH)
    plan = swing_plan([OWN, HEAVY], aim="exponent", within=within, law=LAW, scatter=scatter)
    assert plan.expected_error <= within or (not plan.enough and len(plan.order) == MOST_PLANNED)
    fewer = REACH / math.sqrt(priors()["exponent"].width ** -2 + (plan.each - 1) * plan.information)
    assert fewer > within


def test_the_two_bats_that_differ_most_are_taken() -> None:
    plan = swing_plan([OWN, leaded(OWN, 2 * OUNCE), HEAVY], aim="exponent", within=0.08, law=LAW, scatter=USUAL)
    assert plan.bats == (OWN, HEAVY)


def test_lead_goes_on_where_the_bats_are_alike_and_no_more_than_is_needed() -> None:
    alike = [OWN, leaded(OWN, 0.5 * OUNCE)]
    plans = [swing_plan(alike, aim="exponent", within=within, law=LAW, scatter=USUAL) for within in (0.11, 0.06)]
    assert all(plan.enough and plan.bats[0] == OWN and "oz of lead" in plan.bats[1].name for plan in plans)
    masses = [rigid_body(beam_model(plan.bats[1])).mass for plan in plans]
    assert masses[0] < masses[1]
    without = swing_plan(alike, aim="exponent", within=0.06, law=LAW, scatter=USUAL, lead=False)
    assert not without.enough and without.bats == tuple(alike)


@given(st.integers(1, 120))
def test_the_order_is_balanced_at_every_time(count: int) -> None:
    """Exact: as many with each bat, in blocks, and of a player who slows steadily no bat has the worse half."""
    order = plan_of().order_of(2 * count)
    assert Counter(order) == {OWN: count, HEAVY: count}
    for made in range(len(order)):
        counts = Counter(order[:made])
        assert abs(counts[OWN] - counts[HEAVY]) <= BLOCK
    whole = plan_of().order_of(4 * BLOCK * count)
    turns, first = np.arange(len(whole)), np.array([bat == OWN for bat in whole])
    assert turns[first].mean() == pytest.approx(turns[~first].mean())


def test_further_swings_are_those_that_are_missing() -> None:
    plan = plan_of()
    assert plan.further(0.08, 0.08) == 0
    unknown = REACH * priors()["exponent"].width
    assert plan.further(unknown, 0.08) == plan.each
    assert 0 < plan.further(0.09, 0.08) < plan.each


def test_what_no_plan_can_be_made_with() -> None:
    with pytest.raises(InputError, match="allowed is above 0"):
        plan_of(0.0)
    with pytest.raises(InputError, match="give a second bat"):
        swing_plan([OWN], aim="exponent", within=0.08, law=LAW, scatter=USUAL, lead=False)
