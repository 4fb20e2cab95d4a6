"""The hit in space: its head-on limit, what friction may and may not do, mirrors, and published spins."""

from __future__ import annotations

from functools import partial
from math import degrees, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of, hit_at
from sweetspot.collision import hit_in_space
from sweetspot.collision.coupled import STEP
from sweetspot.collision.hit_in_space import Contact, Strike, Strikes, strike, strikes
from sweetspot.collision.impact import Outcome
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.collision.oblique_contact import NO_FRICTION, SPHERE, Friction
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.units import INCH, MPH

BALL = catalog.ball()
TO_RPM = 30 / np.pi


@pytest.fixture(scope="module")
def model(analysis: Analysis) -> ReducedBat[Bat]:
    return analysis.reduced


def pitched(speed: float = 82 * MPH, *, drop: float = 0.0, spin: tuple[float, float, float] = (0, 0, 0)) -> BallMotion:
    """A ball that comes from the mound, falling by the angle ``drop``."""
    return BallMotion(np.zeros(3), speed * np.array([0, -np.cos(drop), -np.sin(drop)]), np.array(spin, float))


def struck(model: ReducedBat[Bat], *, position: float | None = None, offset: float = 0.0, **changes: object) -> Strike:
    x = model.bat.length - 6 * INCH
    usual = {
        "ball": BALL,
        "swing": Swing(bat_speed=72 * MPH, measured_at=x),
        "path": SwingPath(),
        "pitch": pitched(),
        "contact": Contact(x if position is None else position, offset),
    }
    return strike(model, **{**usual, **changes})  # type: ignore[arg-type]


def test_head_on_is_the_main_job(model: ReducedBat[Bat], analysis: Analysis) -> None:
    """Level path, ball straight against it, no spin: the exit speed is the normal part's, exactly without friction.

    With it the front of the turning bat drags the ball along the bat, by less than 0.1 m/s of 46 m/s.
    """
    conditions, place = analysis.conditions, analysis.sweet_spots.max_exit_speed
    expected = exit_speed_of(hit_at(place, modes=analysis.modes, conditions=conditions), conditions)
    for friction, within in ((0.0, 1e-12), (0.2, 0.1)):
        found = struck(
            model,
            swing=conditions.swing,
            position=place,
            pitch=pitched(conditions.pitch.speed),
            friction=Friction(friction),
        )
        assert found.launched is not None
        assert found.launched.velocity == pytest.approx([0, expected, 0], rel=1e-12, abs=within)
        assert found.launched.spin[:2] == pytest.approx([0, 0], abs=1e-12)
        assert abs(found.launched.spin[2]) <= 100 * within


@given(offset=st.floats(-0.05, 0.05), attack=st.floats(-0.4, 0.4), drop=st.floats(-0.3, 0.3))
@settings(max_examples=20)
def test_without_friction_the_spin_stays(model: ReducedBat[Bat], offset: float, attack: float, drop: float) -> None:
    spin = (-240.0, 30.0, 50.0)
    found = struck(
        model,
        offset=offset,
        path=SwingPath(attack_angle=attack),
        pitch=pitched(drop=drop, spin=spin),
        friction=NO_FRICTION,
    )
    assert found.launched is not None
    assert found.launched.spin == pytest.approx(spin, abs=1e-12)


def batch(model: ReducedBat[Bat], seed: int, count: int = 60) -> tuple[Strikes, dict[str, np.ndarray]]:
    rng = np.random.default_rng(seed)
    inputs = {
        "bat_speed": rng.uniform(20, 40, count),
        "position": model.bat.length - rng.uniform(0.05, 0.3, count),
        "offset": rng.uniform(-0.06, 0.06, count),
        "pitch_velocity": rng.normal([0, -37, -4], [2, 4, 2], (count, 3)),
        "pitch_spin": rng.normal(0, 200, (count, 3)),
    }
    axes = SwingPath(attack_angle=0.15, attack_direction=-0.1, tilt=0.55).axes
    many = strikes(
        model,
        ball=BALL,
        swings=Swings(inputs["bat_speed"], axes),
        pitches=BallMotions(velocity=inputs["pitch_velocity"], spin=inputs["pitch_spin"]),
        contact=Contact(inputs["position"], inputs["offset"]),
    )
    return many, inputs


def test_angular_momentum_about_the_contact_is_kept(model: ReducedBat[Bat]) -> None:
    """Exact: every impulse acts at the point of contact, r n below the centre, so I w + m r n x v stays."""
    found, given_ = batch(model, 1)
    axes = SwingPath(attack_angle=0.15, attack_direction=-0.1, tilt=0.55).axes
    reach = BALL.radius + model.bat.diameter_at(given_["position"]) / 2
    lift = np.arcsin(given_["offset"] / reach)
    normal = np.cos(lift)[:, None] * axes.forward + np.sin(lift)[:, None] * axes.up
    inertia = SPHERE * BALL.mass * BALL.radius**2

    def about_contact(velocity: np.ndarray, spin: np.ndarray) -> np.ndarray:
        return inertia * spin + BALL.mass * BALL.radius * np.cross(normal, velocity)

    before = about_contact(given_["pitch_velocity"], given_["pitch_spin"])
    assert about_contact(found.velocity, found.spin) == pytest.approx(before, rel=1e-9, abs=1e-9)


OFFSETS = np.linspace(-1.4, 1.4, 29) * INCH


def directions(model: ReducedBat[Bat], place: float, step: float | None) -> tuple[np.ndarray, np.ndarray]:
    """Directions and spins by the kernel for a row of offsets; ``step`` None: the kernel's own."""
    path = SwingPath(attack_angle=0.15, tilt=0.55)
    count = len(OFFSETS)
    with pytest.MonkeyPatch.context() as patch:
        if step is not None:
            patch.setattr(hit_in_space, "hits_with_motion", partial(hits_with_motion, step=step))
        many = strikes(
            model,
            ball=BALL,
            swings=Swings(np.full(count, 31.0), path.axes),
            pitches=BallMotions(velocity=pitched().velocity, spin=pitched().spin),
            contact=Contact(np.full(count, place), OFFSETS),
        )
    return many.velocity / many.exit_speed[:, None], many.spin


@pytest.mark.parametrize("from_tip", [3.0, 6.0, 9.0])
def test_one_and_many_agree(model: ReducedBat[Bat], from_tip: float) -> None:
    """At the same step they are one; the kernel's own step turns the ball by less than 2e-5.

    The bat's motion is that at release, not at the next kick: no direction jumps where a kick is gained or lost.
    """
    x = model.bat.length - from_tip * INCH
    swing = Swing(bat_speed=31.0, measured_at=x)
    same, _ = directions(model, x, STEP)
    usual, spins = directions(model, x, None)
    for row in range(0, len(OFFSETS), 3):
        one = struck(
            model, swing=swing, path=SwingPath(attack_angle=0.15, tilt=0.55), position=x, offset=float(OFFSETS[row])
        ).launched
        assert one is not None
        towards = one.velocity / np.linalg.norm(one.velocity)
        assert same[row] == pytest.approx(towards, abs=1e-7)
        assert usual[row] == pytest.approx(towards, abs=2e-5)
        assert spins[row] == pytest.approx(one.spin, abs=0.05)  # rad/s of some hundred


def test_left_mirrors_right(model: ReducedBat[Bat]) -> None:
    sides = [
        struck(model, path=SwingPath(attack_angle=0.15, attack_direction=-0.1, tilt=0.5, bats=side), offset=0.01)
        for side in ("right", "left")
    ]
    right, left = (side.launched for side in sides)
    assert right is not None and left is not None
    assert right.velocity * [-1, 1, 1] == pytest.approx(left.velocity)
    assert right.spin * [1, -1, -1] == pytest.approx(left.spin)


def test_below_the_centre_makes_backspin_and_a_tilted_bat_side_spin(model: ReducedBat[Bat]) -> None:
    level = struck(model, offset=0.02).launched
    tilted = struck(model, offset=0.02, path=SwingPath(tilt=radians(32))).launched
    assert level is not None and tilted is not None
    assert level.launch_angle > 0 and level.backspin > 0
    assert abs(level.sidespin) < 0.05 * level.backspin  # only what the turning of a level bat drags along it
    assert tilted.sidespin < 0 < tilted.spray  # a right-handed batter slices it to right field
    assert 0 < tilted.backspin < level.backspin


def test_a_miss_is_an_outcome(model: ReducedBat[Bat]) -> None:
    assert struck(model, offset=0.1).outcome is Outcome.MISS
    assert struck(model, offset=-0.1).launched is None
    assert (
        struck(model, pitch=BallMotion(np.zeros(3), np.array([0, 60.0, 0]), np.zeros(3))).outcome is Outcome.NO_CONTACT
    )
    found = strikes(
        model,
        ball=BALL,
        swings=Swings([30.0, 30.0], SwingPath().axes),
        pitches=BallMotions(velocity=[0, -30, 0], spin=[0, 0, 0]),
        contact=Contact([0.7, 0.7], [0.2, 0.0]),
    )
    assert found.outcome.tolist() == [Outcome.MISS, Outcome.SEPARATED]
    assert np.isnan(found.exit_speed[0]) and found.exit_speed[1] > 30


def test_off_the_bat_is_refused(model: ReducedBat[Bat]) -> None:
    with pytest.raises(InputError, match="on the bat"):
        strikes(
            model,
            ball=BALL,
            swings=Swings([30.0], SwingPath().axes),
            pitches=BallMotions(velocity=[0, -30, 0], spin=[0, 0, 0]),
            contact=Contact([0.9]),
        )


def test_grazing_contact_slides(model: ReducedBat[Bat]) -> None:
    reach = BALL.radius + 0.031
    assert struck(model, offset=0.9 * reach).gripped is False
    assert struck(model, offset=0.2 * reach).gripped is True


def test_second_plane_shakes_less_than_the_first(model: ReducedBat[Bat]) -> None:
    """Friction is at most 0.2 of the normal force [kensrud2017]; along the bat, 1.4 m/s for 0.8 ms, less friction."""
    found = struck(model, offset=0.03)
    assert found.second_plane is not None and 0 < found.second_plane <= 0.2
    assert found.travel_around is not None and found.travel_along == pytest.approx(1e-3, abs=5e-4)


@pytest.mark.parametrize(("bat_speed", "low", "high"), [(63, 0, 3500), (77, 2800, 3500), (88, 0, 4000)])
def test_published_spin_off_a_tee(model: ReducedBat[Bat], bat_speed: float, low: float, high: float) -> None:
    """[kensrud2017]: bat at 63 to 88 mph on a ball at rest, launch to 30 degrees, spin to 3500 rpm; at 77 mph and 20
    degrees about 3100 to 3200 rpm, within 10 %."""
    x = model.bat.length - 6 * INCH
    swing = Swing(bat_speed=bat_speed * MPH, measured_at=x)
    found = [
        struck(model, swing=swing, pitch=pitched(0.0), offset=d * INCH).launched for d in np.linspace(0.9, 1.4, 11)
    ]
    at_20 = min((ball for ball in found if ball), key=lambda ball: abs(degrees(ball.launch_angle) - 20))
    assert low <= at_20.backspin * TO_RPM <= high


def test_a_reduction_is_what_analysis_uses(analysis: Analysis) -> None:
    found = reduced_bat(analysis.bat, ball=analysis.conditions.ball)
    assert found.body == analysis.body
    assert found.modes.frequency == pytest.approx(analysis.modes.frequency)
