"""Oblique contact: the paper's two limits, and friction between them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.collision.coupled import hit
from sweetspot.collision.oblique_contact import Friction, ObliqueImpact, decompose, oblique, travel
from sweetspot.errors import InputError


def slanted(analysis: Analysis, angle: float, **changes: object) -> ObliqueImpact:
    return oblique(
        analysis.best,
        ball=analysis.conditions.ball,
        body=analysis.body,
        ball_speed=40.0,
        angle=angle,
        **changes,  # type: ignore[arg-type]
    )


@given(st.floats(0, 60), st.floats(-1.5, 1.5))
def test_decomposition_is_pythagoras(speed: float, angle: float) -> None:
    normal, along = decompose(speed, angle)
    assert math.hypot(normal, along) == pytest.approx(speed)
    assert along * math.cos(angle) == pytest.approx(normal * math.sin(angle), abs=1e-9)


def test_elastic_limit_is_speed_times_time(analysis: Analysis) -> None:
    found = slanted(analysis, 0.2, rubbing="smooth")
    assert found.travel == pytest.approx(40 * math.sin(0.2) * analysis.best.release_time, rel=1e-12)
    assert found.along_speed_after == found.along_speed and found.spin == 0.0 and not found.gripped


def test_plastic_limit_is_no_travel(analysis: Analysis) -> None:
    found = slanted(analysis, 0.2, rubbing="cling")
    assert (found.travel, found.along_speed_after) == (0.0, 0.0)


@given(st.floats(-0.6, 0.6))
def test_real_contact_lies_between(analysis: Analysis, angle: float) -> None:
    smooth, real = slanted(analysis, angle, rubbing="smooth"), slanted(analysis, angle)
    assert abs(real.travel) <= abs(smooth.travel) + 1e-15
    assert real.travel * angle >= 0
    assert abs(real.along_speed_after) <= abs(real.along_speed)


def test_a_rolling_ball_keeps_five_sevenths(analysis: Analysis) -> None:
    """e_x = 0 and a bat that cannot slide: 5/7 of the speed and spin v/r (exact, a uniform sphere)."""
    heavy = analysis.body.__class__(1e12, analysis.body.balance_point, 1e12, 1.0)
    ball = analysis.conditions.ball
    found = oblique(
        analysis.best,
        ball=ball,
        body=heavy,
        ball_speed=40.0,
        angle=0.1,
        friction=Friction(coefficient=10.0, tangential_restitution=0.0),
    )
    assert found.along_speed_after == pytest.approx(5 / 7 * found.along_speed)
    assert found.spin * ball.radius == pytest.approx(found.along_speed_after)


def test_little_friction_slides(analysis: Analysis) -> None:
    found = slanted(analysis, 0.6, friction=Friction(0.01))
    ball = analysis.conditions.ball
    impulse = ball.mass * analysis.best.closing_speed * (1 + analysis.best.collision_efficiency)
    assert not found.gripped
    assert found.along_speed - found.along_speed_after == pytest.approx(0.01 * impulse / ball.mass, rel=1e-3)


def test_mirror_symmetry(analysis: Analysis) -> None:
    left, right = slanted(analysis, -0.3), slanted(analysis, 0.3)
    assert (left.travel, left.spin) == pytest.approx((-right.travel, -right.spin))


def test_grazing_is_refused() -> None:
    with pytest.raises(InputError, match="allowed is more than -90"):
        decompose(40.0, math.pi / 2)


def test_travel_does_not_depend_on_where_the_last_kick_lies(analysis: Analysis) -> None:
    """Release lies between two kicks: counted otherwise, coarse steps would differ by a step."""
    ball = analysis.conditions.ball
    fine, coarse = (
        travel(
            hit(analysis.modes, ball=ball, position=0.69, closing_speed=60.0, step=step),
            ball=ball,
            speed=0.0,
            impulse=1.0,
        )
        for step in (1e-6, 16e-6)
    )
    assert coarse == pytest.approx(fine, rel=2e-3)
