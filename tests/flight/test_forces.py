"""Drag and lift: laws of other sports as members of one family, and what each force may not do."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import REFERENCE_REYNOLDS, VISCOSITY, Aerodynamics, acceleration, drag_and_lift
from sweetspot.flight.air import CALM, Air
from sweetspot.flight.batted_spin import check_usual_spin
from sweetspot.flight.conditions import FlightConditions
from sweetspot.units import DEGREE

BALL, LAW = catalog.ball(), catalog.aerodynamics("trajectory-calculator")
part = st.floats(-300, 300)
vectors = st.tuples(part, part, part).map(np.array)


@given(vectors, vectors)
def test_drag_brakes_and_lift_turns(velocity: np.ndarray, spin: np.ndarray) -> None:
    drag, lift = drag_and_lift(velocity, spin=spin, ball=BALL, aerodynamics=LAW, density=1.2)
    power = float(np.linalg.norm(lift) * np.linalg.norm(velocity))
    assert drag @ velocity <= 0
    assert abs(lift @ velocity) <= 1e-9 * power + 1e-12
    assert abs(lift @ spin) <= 1e-9 * float(np.linalg.norm(lift) * np.linalg.norm(spin)) + 1e-12


def test_gyro_spin_lifts_nothing_but_brakes() -> None:
    velocity = np.array([0.0, 40.0, 0.0])
    drag, lift = drag_and_lift(velocity, spin=np.array([0.0, 250.0, 0.0]), ball=BALL, aerodynamics=LAW, density=1.2)
    still, _ = drag_and_lift(velocity, spin=np.zeros(3), ball=BALL, aerodynamics=LAW, density=1.2)
    assert np.array_equal(lift, np.zeros(3))
    assert drag[1] < still[1] < 0


def test_backspin_lifts_and_positive_sidespin_bends_left() -> None:
    velocity = np.array([0.0, 40.0, 0.0])
    _, up = drag_and_lift(velocity, spin=np.array([250.0, 0.0, 0.0]), ball=BALL, aerodynamics=LAW, density=1.2)
    _, left = drag_and_lift(velocity, spin=np.array([0.0, 0.0, 250.0]), ball=BALL, aerodynamics=LAW, density=1.2)
    assert up[2] > 0 and left[0] < 0
    assert up[2] == pytest.approx(-left[0])


def test_a_ball_at_rest_in_the_air_falls_freely() -> None:
    found = acceleration(np.zeros(3), spin=np.array([300.0, 0.0, 0.0]), ball=BALL, aerodynamics=LAW, density=1.2)
    assert found == pytest.approx([0.0, 0.0, -9.80665])


def test_numbers_of_the_sheet() -> None:
    """Published: nathan_calculator, first row: S 0.20969, Cd 0.37380, Cl 0.21904."""
    assert LAW.drag_coefficient(0.20969, spin=2500 * math.pi / 30) == pytest.approx(0.37380, abs=5e-6)
    assert LAW.lift_coefficient(0.20969) == pytest.approx(0.21904, abs=5e-6)


def test_laws_of_other_sports() -> None:
    """Exact: Cl = 1 / (2 + v / (R w)) = S / (1 + 2 S) of tennis, a S^0.4 of golf, none for a shuttle."""
    tennis = Aerodynamics(drag=0.5, lift_scale=1.0, lift_offset=1.0, lift_slope=2.0)
    golf = Aerodynamics(drag=0.2, lift_scale=0.3, lift_exponent=0.4, drag_per_spin_factor=0.5)
    for factor in (0.01, 0.2, 1.5):
        assert tennis.lift_coefficient(factor) == pytest.approx(1 / (2 + 1 / factor))
        assert golf.lift_coefficient(factor) == pytest.approx(0.3 * factor**0.4)
        assert golf.drag_coefficient(factor, spin=300.0) == pytest.approx(0.2 + 0.5 * factor)
        assert Aerodynamics(drag=0.6).lift_coefficient(factor) == 0.0
    assert golf.lift_coefficient(0.0) == 0.0


def test_at_terminal_speed_drag_carries_the_weight() -> None:
    """Exact: m g = rho pi R^2 Cd v^2 / 2."""
    shuttle = BALL.replaced(mass=0.0052, radius=0.033)
    drag = 2 * shuttle.mass * 9.80665 / (1.2 * math.pi * shuttle.radius**2 * 6.8**2)
    found = acceleration(
        np.array([0.0, 0.0, -6.8]), spin=np.zeros(3), ball=shuttle, aerodynamics=Aerodynamics(drag=drag), density=1.2
    )
    assert found == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)


@pytest.mark.parametrize(
    "values", [{"drag": -0.1}, {"drag": 0.3, "lift_offset": 0.0}, {"drag": 0.3, "spin_decay_time": 0.0}]
)
def test_coefficients_that_cannot_be_are_refused(values: dict[str, float]) -> None:
    with pytest.raises(InputError, match=list(values)[-1]):
        Aerodynamics(**values)


def test_every_catalogue_entry_can_fly() -> None:
    for name in catalog.aerodynamics_names():
        law = catalog.aerodynamics(name)
        _, lift = drag_and_lift(
            np.array([0.0, 30.0, 5.0]), spin=np.array([100.0, 0.0, 0.0]), ball=BALL, aerodynamics=law, density=1.2
        )
        assert np.isfinite(lift).all()


def test_unknown_aerodynamics_names_the_nearest() -> None:
    with pytest.raises(InputError, match="baseball"):
        catalog.aerodynamics("basebal")


def test_thin_air_has_the_greater_coefficient() -> None:
    """Exact: Cd = c + b (Re_0 / Re - 1) with Re = 2 rho R v / mu; half the density is twice Re_0 / Re."""
    law = Aerodynamics(drag=0.33, drag_per_inverse_reynolds=0.04)
    velocity, still = np.array([0.0, 38.0, 0.0]), np.zeros(3)
    thick, thin = (
        -drag_and_lift(velocity, spin=still, ball=BALL, aerodynamics=law, density=density)[0][1]
        / (density * math.pi * BALL.radius**2 / (2 * BALL.mass) * 38.0**2)
        for density in (1.2, 0.6)
    )
    reynolds = 2 * 1.2 * BALL.radius * 38.0 / VISCOSITY
    assert thick == pytest.approx(0.33 + 0.04 * (REFERENCE_REYNOLDS / reynolds - 1))
    assert thin - thick == pytest.approx(0.04 * REFERENCE_REYNOLDS / reynolds)


def test_only_the_active_spin_drags_where_a_law_says_so() -> None:
    velocity = np.array([0.0, 40.0, 0.0])
    law = Aerodynamics(drag=0.3, drag_per_active_spin=2e-4)
    still, gyro, back = (
        drag_and_lift(velocity, spin=np.array(spin), ball=BALL, aerodynamics=law, density=1.2)[0][1]
        for spin in ((0.0, 0.0, 0.0), (0.0, 250.0, 0.0), (250.0, 0.0, 0.0))
    )
    assert gyro == still
    assert back / still == pytest.approx((0.3 + 2e-4 * 250) / 0.3)


def test_more_viscous_drag_than_drag_is_refused() -> None:
    with pytest.raises(InputError, match="pulled along"):
        Aerodynamics(drag=0.03, drag_per_inverse_reynolds=0.04)


def test_one_air_and_one_wind_are_asked_for_where_each_flight_has_its_own() -> None:
    """A single trajectory has no use for a density or a wind for each of many."""
    each = FlightConditions(ball=BALL, aerodynamics=LAW, air=[1.2, 1.1], wind=[[0.0, 1.0], [0.0, 2.0]])
    with pytest.raises(InputError, match="give one `Air`"):
        _ = each.one_air
    with pytest.raises(InputError, match="give one `Wind`"):
        _ = each.one_wind
    with pytest.raises(InputError, match="or `Airs`"):
        _ = each.weather
    assert each.density == pytest.approx([1.2, 1.1])
    one = FlightConditions(ball=BALL, aerodynamics=LAW, air=Air())
    assert one.one_air == Air() and one.one_wind == CALM


def test_the_usual_spin_of_a_pop_up_is_not_guessed() -> None:
    """Known from 15 deg downward to 50 deg up; a ball with a spin of its own may go anywhere."""
    for angle in (-15.0, 0.0, 50.0):
        check_usual_spin(angle * DEGREE, given=False)
    for angle in (-15.1, 50.1, 80.0):
        check_usual_spin(angle * DEGREE, given=True)
        with pytest.raises(InputError, match="known for -15 to 50 deg only; give the spin"):
            check_usual_spin(angle * DEGREE, given=False)
