"""The ball's force laws."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.collision.contact_law import (
    ContactLaw,
    damped_impulse,
    loading_force,
    stored_energy,
    unloading_exponent,
    wall_speed,
)
from sweetspot.equipment.ball import (
    COR_FLOOR,
    Ball,
    damped_part,
    damping_from_share,
    peak_compression,
    rate_share,
    stiffness_from_load,
)

peaks = st.floats(1e-4, 0.03)


@given(st.floats(1e-4, 0.02), st.floats(0.0, 0.01))
def test_unloading_returns_what_a_wall_does(peak: float, damping: float) -> None:
    """Exact, by quadrature of both ways: m v dv = -F du from the wall speed to rest, and from rest to e times it."""
    ball = catalog.ball().replaced(damping=damping)
    speed = wall_speed(ball, stored_energy(ball, peak))
    power, back = unloading_exponent(ball, peak), float(ball.restitution.at(speed)) * speed
    energy = loading_force(ball, peak) * peak / (power + 1)
    rates = np.linspace(0.0, 1.0, 4001)
    for most, stored, sign in ((speed, stored_energy(ball, peak), 1), (back, energy, -1)):
        along = most * rates
        assert ball.mass * np.trapezoid(along / (1 + sign * damping * along), along) == pytest.approx(stored, rel=1e-5)


@given(peaks, st.floats(0.01, 1.0))
def test_force_is_continuous_and_slope_is_its_derivative(peak: float, part: float) -> None:
    law = ContactLaw(catalog.ball())

    def force(place: float, turned_at: float | None) -> float:
        return law.force_and_slope(place, turned_at)[0]

    assert force(peak, None) == pytest.approx(force(peak, peak), rel=1e-12)
    place, tiny = part * peak * 0.999, 1e-7 * peak
    rise = force(place + tiny, peak) - force(place - tiny, peak)
    assert law.force_and_slope(place, peak)[1] == pytest.approx(rise / (2 * tiny), rel=1e-5)


def test_stored_energy_is_the_area_under_loading(baseball: Ball) -> None:
    compression = np.linspace(0, 0.02, 20001)
    area = np.trapezoid([loading_force(baseball, u) for u in compression], compression)
    assert stored_energy(baseball, 0.02) == pytest.approx(area, rel=1e-6)


@given(st.floats(0.0, 1.0), st.floats(0.2, 0.95), st.floats(5.0, 70.0))
def test_a_damper_takes_the_share_it_was_made_for(share: float, restitution: float, speed: float) -> None:
    damping = damping_from_share(share, speed=speed, restitution=restitution)
    assert rate_share(damping, speed=speed, restitution=restitution) == pytest.approx(share, abs=1e-4)


def test_all_by_the_rate_is_hunt_and_crossley(baseball: Ball) -> None:
    """Exact: then the way back is the way in, p = n."""
    speed = 60.0
    damping = damping_from_share(1.0, speed=speed, restitution=float(baseball.restitution.at(speed)))
    ball = baseball.replaced(damping=damping)
    assert unloading_exponent(ball, peak_compression(ball, speed)) == pytest.approx(ball.exponent, abs=1e-9)


def test_a_small_damper_is_nearly_none(baseball: Ball) -> None:
    """Across the series of `damped_part`, and to the closed form without one."""
    plain, tiny = (baseball.replaced(damping=damping) for damping in (0.0, 1e-7))
    assert unloading_exponent(tiny, 0.015) == pytest.approx(unloading_exponent(plain, 0.015), rel=1e-5)
    assert damped_part(1e-3 * (1 - 1e-9)) == pytest.approx(damped_part(1e-3 * (1 + 1e-9)), rel=1e-8)


def test_a_kick_never_pulls_and_its_damper_never_drives() -> None:
    def kick(damping: float, rate: float) -> float:
        return damped_impulse(1e-2, damping, rate, 10.0, rate, 5e-10, 1e-5)[0]

    assert kick(0.05, -30.0) == 0.0
    assert kick(0.01, 20.0) > kick(0.0, 20.0) == 1e-2


def test_the_law_moves_between_its_ends(baseball: Ball) -> None:
    """0 is the ball itself, -1 and 1 the ends; no damper drives a ball however far beyond."""
    assert baseball.law_ends is not None
    assert baseball.with_law(0.0) == baseball
    for deviation, end in zip((-1.0, 1.0), baseball.law_ends, strict=True):
        found = baseball.with_law(deviation)
        assert (found.damping, found.stiffness) == pytest.approx((end.damping, end.stiffness))
        assert (found.restitution.reference, found.restitution.slope) == pytest.approx((end.reference, end.slope))
    assert baseball.with_law(-3.0).damping == 0.0


def test_a_faster_ball_is_deader_within_what_a_ball_can_be(baseball: Ball) -> None:
    """A straight line down from the reference, by hand; one speed as a number or as one of many."""
    law = baseball.restitution.replaced(reference=0.5, reference_speed=25.0, slope=0.002)
    speeds = np.array([25.0, 35.0, 15.0, -1e3, 1e4])
    expected = [0.5, 0.48, 0.52, 1.0, COR_FLOOR]
    assert law.at(speeds) == pytest.approx(expected)
    assert [law.at(float(speed)) for speed in speeds] == pytest.approx(expected)


def test_a_warm_and_a_dry_ball_are_livelier(baseball: Ball) -> None:
    """[theibert_list] and [azcentral2010]: the signs; by 0.0012 per kelvin and 0.10 per unit of humidity."""
    here = baseball.restitution.reference
    warm = baseball.conditioned(temperature=baseball.reference_temperature + 10)
    damp = baseball.conditioned(humidity=baseball.reference_humidity + 0.2)
    assert warm.restitution.reference - here == pytest.approx(10 * 0.0012)
    assert damp.restitution.reference - here == pytest.approx(-0.2 * 0.10)


def test_a_load_test_is_met(baseball: Ball) -> None:
    stiffness = stiffness_from_load(444.0, compression=0.003, exponent=baseball.exponent)
    assert loading_force(baseball.replaced(stiffness=stiffness), 0.003) == pytest.approx(444.0)
