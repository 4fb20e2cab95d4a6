"""The ball's force laws."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.collision.contact_law import (
    HuntCrossley,
    Hysteretic,
    equivalent_wall_speed,
    loading_force,
    stored_energy,
    unloading_exponent,
)
from sweetspot.equipment.ball import COR_FLOOR, Ball, RestitutionLaw, stiffness_from_load

peaks = st.floats(1e-4, 0.03)


@given(peaks)
def test_unloading_returns_e_squared(peak: float) -> None:
    """int F du down / int F du up = (n + 1) / (p + 1) = e^2, e at the wall speed of that energy: exact."""
    from sweetspot import catalog

    ball = catalog.ball()
    back = loading_force(ball, peak) * peak / (unloading_exponent(ball, peak) + 1)
    restitution = ball.restitution.at(equivalent_wall_speed(ball, peak))
    assert back / stored_energy(ball, peak) == pytest.approx(restitution**2)


@given(peaks, st.floats(0.01, 1.0))
def test_force_is_continuous_and_slope_is_its_derivative(peak: float, part: float) -> None:
    from sweetspot import catalog

    law = Hysteretic(catalog.ball())

    def force(place: float, turned_at: float | None) -> float:
        return law.force_and_slope(place, 0.0, turned_at)[0]

    assert force(peak, None) == pytest.approx(force(peak, peak), rel=1e-12)
    place, tiny = part * peak * 0.999, 1e-7 * peak
    rise = force(place + tiny, peak) - force(place - tiny, peak)
    assert law.force_and_slope(place, 0.0, peak)[1] == pytest.approx(rise / (2 * tiny), rel=1e-5)


def test_stored_energy_is_the_area_under_loading(baseball: Ball) -> None:
    compression = np.linspace(0, 0.02, 20001)
    area = np.trapezoid([loading_force(baseball, u) for u in compression], compression)
    assert stored_energy(baseball, 0.02) == pytest.approx(area, rel=1e-6)


def test_hunt_crossley_of_an_elastic_ball_has_no_damper(baseball: Ball) -> None:
    elastic = baseball.replaced(restitution=baseball.restitution.replaced(reference=1.0, slope=0.0))
    assert HuntCrossley.for_speed(elastic, 30.0).damping == 0.0
    lossy = HuntCrossley.for_speed(baseball, 30.0)
    assert lossy.damping > 0 and lossy.force_and_slope(0.01, -1e6, None)[0] == 0.0  # never a pull


@given(st.floats(COR_FLOOR, 0.999), st.floats(1.0, 70.0))
def test_hunt_crossley_gives_back_what_a_wall_does(restitution: float, speed: float) -> None:
    """d - ln(1 + d) = -e d - ln(1 - e d) on a rigid wall: exact."""
    from sweetspot import catalog

    ball = catalog.ball().replaced(restitution=RestitutionLaw(reference=restitution, slope=0.0, reference_speed=30.0))
    damping = HuntCrossley.for_speed(ball, speed).damping * speed
    back = restitution * damping
    assert damping - np.log1p(damping) == pytest.approx(-back - np.log1p(-back), rel=1e-6)


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
