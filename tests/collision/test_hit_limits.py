"""The coupled collision in limits that have exact answers: rigid bat, immovable wall, linear ball; and momentum."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from sweetspot import catalog
from sweetspot.collision.closed_form import free_restitution, rigid_efficiency
from sweetspot.collision.coupled import check_step, hit
from sweetspot.collision.impact import Outcome
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import effective_mass, rigid_body
from sweetspot.equipment.ball import Ball, RestitutionLaw, damping_from_share
from sweetspot.errors import InputError
from sweetspot.numerics.piecewise import Piecewise

BALL = catalog.ball()
LINE = beam_model(catalog.bat("r161-ash"))
BODY = rigid_body(LINE)
MODES = bending_modes(LINE)
WALL = replace(
    MODES.selected([0]),
    frequency=np.zeros(1),
    damping_rate=np.zeros(1),
    shapes=Piecewise(np.zeros((1, 1, 1)), np.array([0.0, 1.0])),
)
"""A bat that does not move at all: one motion with zero shape."""
LINEAR = BALL.replaced(
    name="linear",
    exponent=1.0,
    stiffness=2e6,
    damping=0.0,
    restitution=RestitutionLaw(reference=1.0, reference_speed=30.0),
)
PLACES = st.floats(0.0, LINE.bat.length)
WALL_SPEEDS = (1.0, 5.0, 20.0, 40.0, 60.0, 85.0, 110.0)


def losing_by_rate(share: float) -> Ball:
    """Return the baseball with a share of its loss by the rate of compression, at 60 m/s."""
    return BALL.replaced(damping=damping_from_share(share, speed=60.0, restitution=float(BALL.restitution.at(60.0))))


def order(steps: ArrayLike, errors: ArrayLike) -> float:
    """Return the slope of log error against log step: the order of convergence."""
    return float(np.polyfit(np.log(np.asarray(steps, float)), np.log(np.abs(np.asarray(errors, float))), 1)[0])


@settings(max_examples=60)
@given(place=PLACES, closing=st.floats(1.0, 110.0))
def test_rigid_limit_is_the_closed_form(place: float, closing: float) -> None:
    # exact
    rigid = MODES.selected([0, 1])
    found = hits(rigid, ball=BALL, position=place, closing_speed=closing, step=1e-6).collision_efficiency[0]
    assert found == pytest.approx(rigid_efficiency(BALL, body=BODY, position=place, closing_speed=closing), abs=1e-7)


def test_rigid_limit_of_the_readable_version_at_its_default_step() -> None:
    rigid = MODES.selected([0, 1])
    for place in (0.1, 0.4, 0.6, 0.7, 0.82):
        found = hit(rigid, ball=BALL, position=place, closing_speed=70.0).collision_efficiency
        assert found == pytest.approx(rigid_efficiency(BALL, body=BODY, position=place, closing_speed=70.0), abs=1e-6)


@pytest.mark.parametrize("speed", WALL_SPEEDS)
@pytest.mark.parametrize("share", [0.0, 0.3, 0.5])
def test_wall_returns_the_restitution_law(share: float, speed: float) -> None:
    """Exact, whatever part of the loss goes with the rate of compression."""
    bounce = hit(WALL, ball=losing_by_rate(share), position=0.5, closing_speed=speed, step=1e-6)
    assert bounce.collision_efficiency == pytest.approx(BALL.restitution.at(speed), abs=1e-6)


@pytest.mark.parametrize(("share", "least"), [(0.0, 2.4), (1.0, 1.9)])
def test_wall_converges_at_the_law_s_order(share: float, least: float) -> None:
    # Corrected kicks lift a ball without a damper towards four, its kink holds it near 2.5; a damper leaves second.
    steps, ball = np.array([8.0, 4.0, 2.0, 1.0]) * 1e-6, losing_by_rate(share)
    errors = [
        hit(WALL, ball=ball, position=0.5, closing_speed=60.0, step=step).collision_efficiency
        - BALL.restitution.at(60.0)
        for step in steps
    ]
    assert order(steps, errors) > least


@pytest.mark.parametrize("speed", [5.0, 70.0])
@pytest.mark.parametrize("share", [0.3, 1.0])
def test_a_rigid_bat_that_recoils_is_a_closed_form_with_a_damper_too(share: float, speed: float) -> None:
    """Exact: what is stored, springs back and is left, by the integral of x dx / (1 + x); see `free_restitution`."""
    ball, rigid = losing_by_rate(share), MODES.selected([0, 1])
    for place in (0.1, 0.6, 0.83):
        found = hit(rigid, ball=ball, position=place, closing_speed=speed, step=1e-6).collision_efficiency
        exact = rigid_efficiency(ball, body=BODY, position=place, closing_speed=speed)
        assert found == pytest.approx(exact, abs=4e-7)


def test_a_light_body_tells_the_two_losses_apart() -> None:
    """A ball that loses by the rate gets no livelier on a light body, one that loses by depth alone does."""
    recoil = BALL.mass / np.array([1.0, 0.15, 0.05, 0.02])
    by_depth, by_rate = (
        np.asarray(free_restitution(losing_by_rate(share), closing_speed=np.full(4, 60.0), recoil=recoil))
        for share in (0.0, 0.35)
    )
    assert by_depth[-1] - by_depth[0] > 0.05
    assert np.ptp(by_rate) < 0.01


@pytest.mark.parametrize("bat", ["wall", "rigid"])
def test_linear_elastic_ball_is_a_half_sine(bat: str) -> None:
    # exact: T = pi sqrt(mu / k), F = v sqrt(mu k) with mu the mass that ball and bat show together
    rigid = bat == "rigid"
    modes = MODES.selected([0, 1]) if rigid else WALL
    inverse_mass = 1 / LINEAR.mass + (1 / effective_mass(BODY, 0.7) if rigid else 0.0)
    mass, speed = 1 / inverse_mass, 30.0
    half_period, peak = math.pi * math.sqrt(mass / LINEAR.stiffness), speed * math.sqrt(mass * LINEAR.stiffness)
    one = hit(modes, ball=LINEAR, position=0.7, closing_speed=speed)
    many = hits(modes, ball=LINEAR, position=0.7, closing_speed=speed, step=4e-6)
    for found in (one.release_time, many.release_time[0]):
        assert found == pytest.approx(half_period, rel=1e-6)
    for found in (one.peak_force, many.peak_force[0]):
        assert found == pytest.approx(peak, rel=1e-5)
    # 1 % of the peak is reached asin(0.01) of a radian before the end
    assert one.contact_time == pytest.approx(half_period * (1 - math.asin(0.01) / math.pi), rel=1e-5)
    assert one.energy.heat == pytest.approx(0.0, abs=1e-4 * one.energy.incoming)


@settings(max_examples=25)
@given(place=PLACES, closing=st.floats(2.0, 100.0))
def test_momentum_goes_to_the_free_bat(place: float, closing: float) -> None:
    # exact: m (1 + q) v = M v_cm, and its moment about the balance point is the bat's spin
    body, modes = BODY, MODES
    blow = hit(modes, ball=BALL, position=place, closing_speed=closing)
    impulse = BALL.mass * (1 + blow.collision_efficiency) * closing
    translation, rotation = modes.rigid_part @ blow.velocity  # sqrt(M) v_cm and sqrt(I_cm) times the angular speed
    arm = place - body.balance_point
    assert math.sqrt(body.mass) * translation == pytest.approx(impulse, rel=1e-9)
    assert math.sqrt(body.moi_cm) * rotation == pytest.approx(impulse * arm, rel=1e-9, abs=1e-9 * impulse)
    assert blow.energy.translation == pytest.approx(impulse**2 / (2 * body.mass), rel=1e-9)
    assert blow.energy.rotation == pytest.approx((impulse * arm) ** 2 / (2 * body.moi_cm), rel=1e-9, abs=1e-15)


def test_rigid_limit_spends_no_energy_on_vibration() -> None:
    blow = hit(MODES.selected([0, 1]), ball=BALL, position=0.7, closing_speed=70.0)
    ledger = blow.energy
    assert blow.outcome is Outcome.SEPARATED
    assert (ledger.bending, ledger.hoop) == pytest.approx((0.0, 0.0), abs=1e-12)
    assert ledger.damping == pytest.approx(0.0, abs=1e-9)
    q = rigid_efficiency(BALL, body=BODY, position=0.7, closing_speed=70.0)
    impulse = BALL.mass * (1 + q) * 70.0
    arm = 0.7 - BODY.balance_point
    both = impulse**2 / 2 * (1 / BODY.mass + arm**2 / BODY.moi_cm)
    assert ledger.translation + ledger.rotation == pytest.approx(both, rel=1e-6)


def test_vibration_only_takes_energy_from_the_ball() -> None:
    places = np.linspace(0.5, 0.82, 9)
    real = hits(MODES, ball=BALL, position=places, closing_speed=70.0).collision_efficiency
    rigid = [rigid_efficiency(BALL, body=BODY, position=place, closing_speed=70.0) for place in places]
    # At the node the waves that are too fast to keep energy give theirs back: a spring beside the ball, worth 0.001;
    # and a ball that is pressed more slowly loses less by the rate.
    assert np.all(real < np.array(rigid) + 0.008)
    assert np.all(real[[0, 1, 2, 3, 6, 7, 8]] < np.array(rigid)[[0, 1, 2, 3, 6, 7, 8]])


@pytest.mark.parametrize("step", [0.0, -1e-6, float("nan"), float("inf")])
def test_a_step_is_a_number_above_zero(step: float) -> None:
    with pytest.raises(InputError, match=r"step is .* allowed is a number above zero"):
        check_step(step)
