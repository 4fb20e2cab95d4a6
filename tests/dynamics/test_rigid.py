"""The rigid bat: percussion, effective mass, hands, pendulum."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass, hand_impulse_ratio
from sweetspot.dynamics.swing_weight import moi_from_pendulum, pendulum_period
from sweetspot.errors import InputError

bodies = st.builds(
    RigidBody,
    mass=st.floats(0.3, 2),
    balance_point=st.floats(0.4, 0.7),
    moi_cm=st.floats(0.01, 0.1),
    roll_moi=st.just(0.0003),
)


@given(bodies, st.floats(0.0, 0.3))
def test_percussion_centre_and_pivot_are_conjugate(body: RigidBody, pivot: float) -> None:
    """Huygens: hung from its centre of percussion, the body has the old pivot as its new centre (exact)."""
    centre = centre_of_percussion(body, pivot=pivot)
    mirrored = RigidBody(body.mass, centre - body.balance_point, body.moi_cm, body.roll_moi)
    assert centre_of_percussion(mirrored, pivot=0.0) == pytest.approx(centre - pivot, rel=1e-9)


@given(bodies, st.floats(0.0, 0.3))
def test_a_blow_at_the_percussion_centre_spares_the_hands(body: RigidBody, pivot: float) -> None:
    centre = centre_of_percussion(body, pivot=pivot)
    assert hand_impulse_ratio(body, centre, hands=pivot) == pytest.approx(0.0, abs=1e-9)
    # free and pivoted recoil are equal there (exact; table (a) case 8 of the published numbers)
    assert effective_mass(body, centre) == pytest.approx(effective_mass(body, centre, pivot=pivot), rel=1e-9)


@given(bodies, st.floats(0.0, 0.3))
def test_a_blow_on_the_hands_is_all_theirs(body: RigidBody, hands: float) -> None:
    assert hand_impulse_ratio(body, hands, hands=hands) == pytest.approx(1.0)


def test_pivoted_bat_is_immovable_at_its_pivot() -> None:
    body = RigidBody(0.9, 0.57, 0.045, 0.0003)
    assert effective_mass(body, 0.15, pivot=0.15) == math.inf
    assert effective_mass(body, body.balance_point) == pytest.approx(0.9)


@given(bodies, st.floats(0.0, 0.3))
def test_pendulum_both_ways(body: RigidBody, pivot: float) -> None:
    period = pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    back = moi_from_pendulum(period, mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    assert back == pytest.approx(body.moi(pivot), rel=1e-12)
    # F2398: the centre of percussion is g T^2 / (4 pi^2) from the pivot
    assert centre_of_percussion(body, pivot=pivot) - pivot == pytest.approx(
        9.80665 * period**2 / (4 * math.pi**2), rel=1e-12
    )


def test_refusals() -> None:
    body = RigidBody(0.9, 0.57, 0.045, 0.0003)
    with pytest.raises(InputError, match="handle side of the balance point"):
        centre_of_percussion(body, pivot=0.6)
    with pytest.raises(InputError, match="hang it from the handle"):
        pendulum_period(0.2, mass=0.9, balance_point=0.57, pivot=0.57)
    for wrong in (0.0, -1.0, math.nan):
        with pytest.raises(InputError, match="above zero"):
            moi_from_pendulum(wrong, mass=0.9, balance_point=0.57, pivot=0.15)
