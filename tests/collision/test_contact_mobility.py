"""The contact in space against two rigid bodies of six degrees each, integrated in time by another method.

Nothing is shared with the package but the loading force: the bat and the ball are moved by Newton's and Euler's laws,
friction by Coulomb's law with a sharp bend at rest, and the whole is stiff, so an implicit method of scipy does it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.collision.hit_in_space import Contact, Strike, strike, strikes
from sweetspot.collision.oblique_contact import (
    SPHERE,
    USUAL_FRICTION,
    ContactFrame,
    Friction,
    SurfaceMobility,
    contact_impulses,
    turning_surface,
)
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import RestitutionLaw
from sweetspot.equipment.bat import Bat
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.units import INCH, MPH

ELASTIC = catalog.ball().replaced(
    restitution=RestitutionLaw(reference=1.0, reference_speed=25.0, slope=0.0), damping=0.0
)
PATH = SwingPath(attack_angle=0.15, attack_direction=-0.1, tilt=0.55)
Vector = tuple[float, float, float]
SHARP = 2e-3
"""m/s of sliding below which the integrated friction bends to zero."""


@pytest.fixture(scope="module")
def rigid(analysis: Analysis) -> ReducedBat[Bat]:
    """The bat without its vibrations."""
    modes = analysis.reduced.modes
    return replace(analysis.reduced, modes=modes.selected(modes.of_family("rigid")))


def met(
    model: ReducedBat[Bat], position: float, offset: float, spin: Vector, friction: Friction = USUAL_FRICTION
) -> Strike:
    pitch = BallMotion(np.zeros(3), np.array([1.0, -37.0, -4.0]), np.array(spin))
    swing = Swing(bat_speed=31.0, measured_at=position)
    contact = Contact(position, offset)
    return strike(model, ball=ELASTIC, swing=swing, path=PATH, pitch=pitch, contact=contact, friction=friction)


def integrated(
    model: ReducedBat[Bat], position: float, offset: float, spin: Vector, friction: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return velocity and spin of the ball; bodies move, but not far enough to turn the contact."""
    axes, body, ball = PATH.axes, model.body, ELASTIC
    radius = float(model.bat.diameter_at(np.array(position))) / 2
    lift = np.arcsin(offset / (ball.radius + radius))
    normal = np.cos(lift) * axes.forward + np.sin(lift) * axes.up
    arm_bat, arm_ball = (position - body.balance_point) * axes.tip + radius * normal, -ball.radius * normal
    turn = 31.0 / position * np.cross(axes.tip, axes.forward)
    centre = np.cross(turn, body.balance_point * axes.tip)  # the axis of the swing is the knob end
    inverse = (np.eye(3) - np.outer(axes.tip, axes.tip)) / body.moi_cm + np.outer(axes.tip, axes.tip) / body.roll_moi
    moment = SPHERE * ball.mass * ball.radius**2
    start = np.concatenate([centre, turn, [1.0, -37.0, -4.0], spin, [0.0]])

    def rates(_: float, state: np.ndarray) -> np.ndarray:
        bat_v, bat_w, ball_v, ball_w = state[:12].reshape(4, 3)
        past = bat_v + np.cross(bat_w, arm_bat) - ball_v - np.cross(ball_w, arm_ball)
        closing = past @ normal
        sliding = past - closing * normal
        push = ball.stiffness * max(state[12], 0.0) ** ball.exponent
        force = push * (normal + friction * sliding / np.sqrt(sliding @ sliding + SHARP**2))
        return np.concatenate([
            -force / body.mass, -inverse @ np.cross(arm_bat, force), force / ball.mass,
            np.cross(arm_ball, force) / moment, [closing],
        ])  # fmt: skip

    def gone(time: float, state: np.ndarray) -> float:
        return float(state[12]) if time > 1e-5 else 1.0

    gone.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(rates, (0, 0.01), start, method="Radau", events=gone, rtol=1e-7, atol=1e-9, max_step=2e-5)
    assert found.t_events is not None and len(found.t_events[0]) == 1
    return found.y[6:9, -1], found.y[9:12, -1]


@pytest.mark.parametrize(
    ("from_tip", "offset", "spin"),
    [(3, 0.005, (-200.0, 0.0, 0.0)), (6, 0.012, (-240.0, 0.0, 60.0)), (8, -0.01, (100.0, 0.0, -80.0))],
)
def test_gripping_contact_is_that_of_two_rigid_bodies(
    rigid: ReducedBat[Bat], from_tip: float, offset: float, spin: Vector
) -> None:
    """Exact but for the order of friction and push within the contact, which is of second order in the coupling.

    Friction is just enough, so that it lasts through most of the contact; with much of it the ball grips at once, and
    the exit speed of the case near the tip changes by another 0.03 %.
    """
    place = rigid.bat.length - from_tip * INCH
    ours = met(rigid, place, offset, spin, Friction(0.06, 0.0)).launched
    velocity, turning = integrated(rigid, place, offset, spin, friction=0.06)
    assert ours is not None
    assert ours.velocity == pytest.approx(velocity, abs=0.015)
    assert ours.spin == pytest.approx(turning, abs=0.05)  # of some 100 rad/s


def test_sliding_contact_is_that_of_two_rigid_bodies(rigid: ReducedBat[Bat]) -> None:
    """Coulomb's law all the way: the direction of friction turns a little, which in step with the push it does not."""
    place, spin = rigid.bat.length - 3 * INCH, (0.0, 0.0, 300.0)
    found = met(rigid, place, 0.03, spin, Friction(0.05, 0.0))
    velocity, turning = integrated(rigid, place, 0.03, spin, friction=0.05)
    assert found.launched is not None and found.gripped is False
    assert found.launched.velocity == pytest.approx(velocity, abs=0.05)
    assert found.launched.spin == pytest.approx(turning, abs=3.0)


def test_without_couplings_each_direction_is_alone() -> None:
    """The limit: C = 0 gives (1 + e_x) s / (7/2m + K) in both directions and leaves the normal impulse alone."""
    mass, slip, push = 0.145, np.array([2.0, -1.0]), 12.0
    found = contact_impulses(*slip, give=SurfaceMobility(2.0, 3.0, 1.2), ball_mass=mass, normal_impulse=push)
    assert found.normal == push
    assert [found.around, found.along] == pytest.approx(1.3 * slip / (3.5 / mass + np.array([3.0, 1.2])), rel=1e-12)


def test_friction_never_exceeds_its_share_of_the_coupled_push() -> None:
    rng = np.random.default_rng(7)
    around, along = rng.normal(0, 40, (2, 200))
    found = contact_impulses(
        around,
        along,
        give=SurfaceMobility(2.0, 3.0, 1.2, rng.uniform(-0.3, 0.3, 200)),
        ball_mass=0.145,
        normal_impulse=12.0,
        friction=Friction(coefficient=0.2),
    )
    assert 0 < found.gripped.sum() < 200
    size = np.hypot(found.around, found.along)
    assert np.all(size <= 0.2 * found.normal * (1 + 1e-12))
    assert size[~found.gripped] == pytest.approx(0.2 * found.normal[~found.gripped], rel=1e-12)


def test_the_front_of_a_turning_bat_moves_towards_the_hands(analysis: Analysis) -> None:
    """omega R = 70 mph / 27 in x 1.3 in = 1.5 m/s, and as the barrel recoils its front moves back to the tip."""
    model, place = analysis.reduced, analysis.bat.length - 6 * INCH
    pitch = BallMotion(np.zeros(3), np.array([0.0, -37.0, 0.0]), np.zeros(3))
    swing = Swing(bat_speed=70 * MPH, measured_at=place)

    def along(friction: float) -> float:
        found = strike(
            model,
            ball=analysis.conditions.ball,
            swing=swing,
            path=SwingPath(),
            pitch=pitch,
            contact=Contact(place),
            friction=Friction(coefficient=friction),
        ).launched
        assert found is not None
        return float(found.velocity[0])  # a level bat of a right-hander points to the right

    assert along(0.0) == pytest.approx(0.0, abs=1e-12)
    axes = SwingPath().axes
    front = turning_surface(ContactFrame(*axes), axes, angular_speed=70 * MPH / place, radius=1.3 * INCH)
    assert front == pytest.approx([-70 * MPH / place * 1.3 * INCH, 0, 0])
    assert abs(along(0.2)) < 0.2  # the two nearly cancel at the sweet spot of a usual swing


def test_an_axis_nearer_to_the_barrel_turns_the_bat_faster(analysis: Analysis) -> None:
    """The same speed of the barrel about another axis: `strike` and `strikes` agree on what that changes."""
    model, place = analysis.reduced, analysis.bat.length - 6 * INCH
    spins = []
    for pivot in (0.0, 0.2):
        one = strike(
            model,
            ball=catalog.ball(),
            swing=Swing(bat_speed=31.0, measured_at=place, pivot=pivot),
            path=PATH,
            pitch=BallMotion(np.zeros(3), np.array([0, -37.0, -4.0]), np.zeros(3)),
            contact=Contact(place, 0.01),
        ).launched
        many = strikes(
            model,
            ball=catalog.ball(),
            swings=Swings([31.0], PATH.axes, pivot),
            pitches=BallMotions(velocity=[0, -37.0, -4.0], spin=[0, 0, 0]),
            contact=Contact([place], [0.01]),
        )
        assert one is not None
        assert many.spin[0] == pytest.approx(one.spin, rel=1e-3, abs=1.0)  # the kernel steps more coarsely
        spins.append(one.spin)
    assert np.abs(spins[0] - spins[1]).max() > 1.0
