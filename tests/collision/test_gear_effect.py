"""A golf ball toward toe or heel: the head turns, friction turns the ball the other way, bulge sends it out."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.collision.gear_effect import side_shot
from sweetspot.equipment.face import Face
from sweetspot.equipment.golf_club import ClubHead, GolfClub

CLUB = catalog.implement("golf-driver")
BALL = catalog.ball("golf")
PUSH = BALL.mass * 67.0  # N s, a ball at 150 mph


def head(**changes: float | Face | None) -> ClubHead:
    assert isinstance(CLUB, GolfClub)
    return CLUB.head.replaced(**changes)


@given(
    lateral=st.floats(-0.04, 0.04).filter(lambda place: abs(place) > 1e-4), depth=st.floats(0.0, 0.05),
    bulge=st.floats(0.2, 1.0), returned=st.floats(-1.0, 0.5),
)  # fmt: skip
def test_newton_and_euler(lateral: float, depth: float, bulge: float, returned: float) -> None:
    """Exact: with the ball's impulse read off its motion, head and ball slide after as e_x says, or friction is all.

    The head and the ball are two rigid bodies in the plane; nothing of the function's own algebra is used.
    """
    club = head(depth=depth, bulge=bulge, face=head().face.replaced(tangential_restitution=returned))
    shot = side_shot(club, ball=BALL, lateral=lateral, normal_impulse=PUSH, speed=45.0)
    side = math.copysign(1.0, lateral)
    delta, slope = lateral / bulge, side * shot.aside
    normal, along = np.array([math.sin(delta), math.cos(delta)]), np.array([math.cos(delta), -math.sin(delta)])
    rubbed = PUSH * math.tan(slope - delta)  # the ball leaves along J_n n + J_t t
    impulse = PUSH * normal + rubbed * along
    spin = -rubbed * BALL.radius / (0.4 * BALL.mass * BALL.radius**2)  # of z to x, its contact is at -R n
    assert spin == pytest.approx(-side * shot.spin, abs=1e-6)
    contact = np.array([lateral, depth])

    def slides(push: np.ndarray) -> float:
        turned = -(contact[1] * push[0] - contact[0] * push[1]) / club.roll_moi
        face = np.array([0.0, 45.0]) - push / club.mass + turned * np.array([contact[1], -contact[0]])
        tangent = float(push @ along)
        ball = push / BALL.mass + tangent * 2.5 / BALL.mass * along
        return float((face - ball) @ along)

    driven = slides(PUSH * normal) - slides(np.zeros(2)) + slides(np.zeros(2))
    rubs_its_most = abs(rubbed) == pytest.approx(0.2 * PUSH, rel=1e-9)
    assert rubs_its_most or slides(impulse) == pytest.approx(-returned * driven, abs=1e-9)


def test_both_sides_alike_and_nothing_in_the_middle() -> None:
    toe, heel = (side_shot(head(), ball=BALL, lateral=way * 0.0127, normal_impulse=PUSH, speed=45.0) for way in (1, -1))
    assert toe == pytest.approx(heel)
    assert side_shot(head(), ball=BALL, lateral=0.0, normal_impulse=PUSH, speed=45.0) == (0.0, 0.0)


def test_what_makes_the_spin() -> None:
    """Exact limits: no depth, flat face, no spin; bulge against gear; a heavier turn, less spin."""
    flat = side_shot(head(depth=0.0, bulge=None), ball=BALL, lateral=0.0127, normal_impulse=PUSH, speed=45.0)
    assert flat.spin == pytest.approx(0.0, abs=1e-12) and flat.aside == pytest.approx(0.0)
    geared = side_shot(head(bulge=None), ball=BALL, lateral=0.0127, normal_impulse=PUSH, speed=45.0)
    heavy = side_shot(head(bulge=None, roll_moi=5.9e-4), ball=BALL, lateral=0.0127, normal_impulse=PUSH, speed=45.0)
    bulged = side_shot(head(), ball=BALL, lateral=0.0127, normal_impulse=PUSH, speed=45.0)
    assert geared.spin > heavy.spin > 0 and bulged.spin < geared.spin and bulged.aside > geared.aside
