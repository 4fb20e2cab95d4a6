"""A ball at one moment: what goes in comes out, and the signs of spin."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotion, batted_ball, launch_angles, spin_axes

angle = st.floats(-1.5, 1.5)
turning = st.floats(-500, 500)


@given(speed=st.floats(0.1, 70), up=angle, aside=angle, back=turning, side=turning, gyro=turning)
def test_what_goes_in_comes_out(speed: float, up: float, aside: float, back: float, side: float, gyro: float) -> None:
    ball = batted_ball(speed=speed, launch_angle=up, spray=aside, backspin=back, sidespin=side, gyrospin=gyro)
    found = (ball.speed, ball.launch_angle, ball.spray, ball.backspin, ball.sidespin, ball.gyrospin)
    assert found == pytest.approx((speed, up, aside, back, side, gyro), abs=1e-9)
    many = launch_angles(np.stack([ball.velocity] * 2), np.stack([ball.spin] * 2))
    assert many[0] == pytest.approx([up, up]) and many[2][:, 1] == pytest.approx([back, side, gyro], abs=1e-9)


@given(up=angle, aside=angle)
def test_spin_axes_are_square(up: float, aside: float) -> None:
    axes = spin_axes(up, aside)
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)


def test_backspin_lifts_and_positive_side_spin_bends_to_the_left() -> None:
    """Exact: the air pushes along spin x velocity."""
    lifted = batted_ball(speed=40, launch_angle=0.0, backspin=200.0)
    assert np.cross(lifted.spin, lifted.velocity) == pytest.approx([0, 0, 8000])
    bent = batted_ball(speed=40, launch_angle=0.0, sidespin=200.0)
    assert np.cross(bent.spin, bent.velocity) == pytest.approx([-8000, 0, 0])


def test_a_pitch_is_a_launch_towards_the_plate() -> None:
    pitch = batted_ball(speed=40, launch_angle=-0.1, spray=math.pi, backspin=200.0)
    assert pitch.velocity[1] < 0 and np.cross(pitch.spin, pitch.velocity)[2] > 0


@pytest.mark.parametrize("wrong", [[0.0, 0.0], [0.0, math.nan, 0.0], 3.0])
def test_a_vector_has_three_finite_numbers(wrong: object) -> None:
    with pytest.raises(InputError, match="three finite numbers"):
        BallMotion(np.zeros(3), wrong, np.zeros(3))  # type: ignore[arg-type]
