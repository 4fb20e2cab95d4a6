"""Implements like one of the catalogue have what was measured, and say what was changed for it.

Every expected number is exact: it is what was asked for, or a sum of parts.
"""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.catalog.scaled_implements import Measures, scaled_to
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.units import OUNCE

DRAWN = [name for name in catalog.implement_names() if name not in ("textbook",)]
"""The catalogue's that have an outline."""


def body_of(tool: Implement) -> RigidBody:
    return rigid_body(beam_model(tool))


@pytest.mark.parametrize("name", DRAWN)
def test_what_was_measured_is_met(name: str) -> None:
    pattern = catalog.implement(name)
    mass = 1.02 * body_of(pattern).mass
    plain, _ = scaled_to(pattern, Measures(length=1.01 * pattern.length, mass=mass))
    assert plain.length == pytest.approx(1.01 * pattern.length) and body_of(plain).mass == pytest.approx(mass)
    balance = body_of(plain).balance_point + 2e-3
    known = Measures(length=plain.length, mass=mass, balance_point=balance)
    balanced = body_of(scaled_to(pattern, known)[0])
    assert (balanced.mass, balanced.balance_point) == pytest.approx((mass, balance), rel=1e-9)


@pytest.mark.parametrize(
    ("name", "axis"), [("tennis-racket", 0.1), ("badminton-racket", 0.09), ("hockey-stick", 0.0), ("r161-ash", 0.1524)]
)
def test_a_swing_weight_is_met_about_its_axis(name: str, axis: float) -> None:
    pattern = catalog.implement(name)
    wanted = 1.03 * body_of(pattern).moi(axis)
    made, _ = scaled_to(pattern, Measures(moi=wanted, moi_axis=axis))
    assert body_of(made).moi(axis) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "mass", "what"),
    [("cricket-bat", 1.45, "blade"), ("hockey-stick", 0.62, "wall"), ("table-tennis-racket", 0.15, "plies")],
)
def test_what_density_cannot_thickness_can_and_it_is_said(name: str, mass: float, what: str) -> None:
    made, told = scaled_to(catalog.implement(name), Measures(mass=mass))
    assert body_of(made).mass == pytest.approx(mass) and what in told


def test_the_wall_of_a_hollow_bat_meets_what_no_cap_can() -> None:
    made, told = scaled_to(catalog.implement("single-wall"), Measures(mass=36 * OUNCE))
    assert body_of(made).mass == pytest.approx(36 * OUNCE) and "every wall" in told


def test_a_club_is_the_sum_of_its_parts() -> None:
    pattern = catalog.implement("golf-driver")
    assert isinstance(pattern, GolfClub)
    heavier, told = scaled_to(pattern, Measures(mass=body_of(pattern).mass + 0.01))
    assert isinstance(heavier, GolfClub) and heavier.head.mass == pytest.approx(0.21) and "210" not in told
    assert heavier.wall == pattern.wall and "a head of 0.21 kg" in told
    with pytest.raises(InputError, match="by its head"):
        scaled_to(pattern, Measures(mass=0.2))
    with pytest.raises(InputError, match="can balance"):
        scaled_to(pattern, Measures(balance_point=0.3))


def test_what_cannot_be_is_refused() -> None:
    with pytest.raises(InputError, match="density"):
        scaled_to(catalog.implement("cricket-bat"), Measures(mass=3.0))
    with pytest.raises(InputError, match="no outline"):
        scaled_to(catalog.implement("textbook"), Measures(length=0.9))
