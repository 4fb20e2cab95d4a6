"""Things are validated when made, and never change."""

from __future__ import annotations

import inspect
import math
from typing import Any

import pytest

from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.ball import Ball, RestitutionLaw, stiffness_from_peak_force
from sweetspot.equipment.bat import Bat, Bore
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.motion.swing import Hands, Pitch, Swing


def bat(ash: Material, **changes: Any) -> Bat:
    values: dict[str, Any] = {
        "name": "b",
        "length": 0.84,
        "material": ash,
        "profile": ((0.0, 0.05), (0.1, 0.025), (0.84, 0.065)),
    }
    return Bat(**{**values, **changes})


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"length": -1.0}, "length"),
        ({"length": 33.0}, "length"),
        ({"length": math.nan}, "finite"),
        ({"profile": ((0.0, 0.05), (0.5, 0.03), (0.4, 0.03), (0.84, 0.06))}, "goes back from 0.5 m (19.69 in) to 0.4"),
        ({"profile": ((0.0, 0.05), (0.5, 0.03))}, "give a station at each end"),
        ({"profile": ((0.0, 0.05),)}, "two or more"),
        ({"profile": ((0.0, 0.05), (0.84, 0.65))}, "650 mm at 0.84 m; allowed is 5 to 120 mm"),
        ({"profile": ((0.0, 0.05), (0.84, -0.06))}, "-60 mm"),
        ({"profile": None}, "give either a profile or a linear_density"),
        ({"linear_density": (1.0,)}, "only one of them"),
        ({"profile": None, "linear_density": (-1.0, 1.0)}, "above zero"),
        ({"profile": None, "linear_density": (60.0,)}, "thick in white ash"),
        ({"mass": -0.8}, "mass was given as -0.8"),
        ({"mass": math.inf}, "finite"),
        ({"balance_point": 0.05}, "measure it from the knob end"),
        ({"bores": ({"diameter": 0.07, "depth": 0.2},)}, "bore is 0.07 m"),
        ({"bores": ({"diameter": 0.02, "depth": 0.9},)}, "make it shallower"),
        ({"bores": ({"diameter": 0.02, "depth": 0.2, "plug": 0.3},)}, "shorten the plug"),
        ({"cup": {"diameter": 0.066, "depth": 0.02}}, "cup is 0.066 m"),
        ({"shell": {"wall": ((0.0, 0.003), (0.84, 0.05))}}, "no more than the radius"),
        (
            {"shell": {"wall": ((0.0, 0.003), (0.84, 0.003))}, "cup": {"diameter": 0.03, "depth": 0.02}},
            "hollow already",
        ),
        ({"point_masses": ({"position": 0.9, "mass": 0.01},)}, "beyond the tip"),
        ({"choke": 0.5}, "third of the length"),
        ({"profile": None, "linear_density": (1.0,) * 99}, "99 coefficients; give 1 to"),
        (
            {"profile": None, "linear_density": (1.0,), "cup": {"diameter": 0.03, "depth": 0.02}},
            "describes a solid bat",
        ),
        ({"shell": {"wall": ((0.0, 0.003), (0.8, 0.003))}}, "give a station at each end"),
        ({"shell": {"wall": ((0.0, 0.003), (0.84, 0.0))}}, "allowed is more than 0 and no more than the radius"),
        ({"added": ({"position": 0.85, "mass": 0.01},)}, "off b, which is"),
        ({"colour": "red"}, "unknown key 'colour'"),
    ],
)
def test_bat_refuses(ash: Material, changes: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError) as caught:
        bat(ash, **changes)
    assert said in str(caught.value)


def test_another_outline_from_the_same_wood(r161: Bat) -> None:
    """A reshaped bat keeps the density that its original's weight says, and may have another length."""
    shorter = r161.reshaped(((0.0, 0.03), (0.8, 0.06)))
    assert shorter.length == 0.8
    assert shorter.mass is None
    assert beam_model(shorter).density_factor == beam_model(r161).density_factor


def test_verbs_return_new_bats(ash: Material) -> None:
    plain = bat(ash, mass=0.9)
    cork = ash.replaced(name="cork", density=160.0, density_range=None)
    corked = plain.corked(diameter=0.0254, depth=0.254, fill=cork, plug=0.0254)
    assert plain.bores == () and corked.bores[0].fill == cork
    assert corked.original == plain and corked.cupped(diameter=0.03, depth=0.02).original == plain
    assert plain.drilled(diameter=0.02, depth=0.2).bores == (Bore(diameter=0.02, depth=0.2),)
    assert plain.choked_up(0.025).choked_up(0.025).choke == 0.05
    assert plain.with_mass(1.0).mass == 1.0 and plain.mass == 0.9
    assert plain.with_material(cork).material is not plain.material
    assert corked.with_mass(0.8).original is None
    with pytest.raises(Exception, match="frozen"):
        plain.mass = 1.0  # type: ignore[misc]


def test_positions_off_the_bat(ash: Material) -> None:
    bat(ash).check_position(0.84)
    for place in (-0.01, 0.85, math.nan, math.inf):
        with pytest.raises(InputError, match="off the bat"):
            bat(ash).check_position(place)


def test_material() -> None:
    metal = Material(name="al", family="metal", density=2800, longitudinal_modulus=71e9, poisson_ratio=0.33)
    assert metal.shear == pytest.approx(71e9 / 2.66)  # exact: E / (2 (1 + nu))
    with pytest.raises(InputError, match="neither a shear_modulus nor a poisson_ratio"):
        Material(name="x", density=2800, longitudinal_modulus=71e9)
    with pytest.raises(InputError, match="outside its own range"):
        metal.replaced(density_range=(1000.0, 2000.0))
    with pytest.raises(InputError, match="poisson_ratio"):
        metal.replaced(poisson_ratio=0.7)


def test_restitution_law_is_a_line_with_a_floor() -> None:
    law = RestitutionLaw(reference=0.55, reference_speed=26.0, slope=0.002)
    assert law.at(26.0) == 0.55
    assert law.at(36.0) == pytest.approx(0.53)
    assert law.at(1e6) == 0.05 and RestitutionLaw(reference=1, reference_speed=1.0, slope=1.0).at(0.0) == 1.0


def test_ball_conditions(baseball: Ball) -> None:
    damp = baseball.conditioned(humidity=0.7)
    assert damp.restitution.reference < baseball.restitution.reference
    assert damp.conditioned(humidity=0.7) == damp  # conditioning twice does not count twice
    back = damp.conditioned(humidity=baseball.reference_humidity)
    assert back.restitution.reference == pytest.approx(baseball.restitution.reference)
    assert baseball.conditioned(temperature=35.0).restitution.reference > baseball.restitution.reference
    with pytest.raises(InputError, match="ratio from 0 to 1"):
        baseball.conditioned(humidity=50.0)
    with pytest.raises(InputError, match="-40 to 60"):
        baseball.conditioned(temperature=200.0)


def test_stiffness_stores_the_kinetic_energy() -> None:
    k = stiffness_from_peak_force(37e3, speed=67.0, mass=0.145, exponent=1.5)
    peak = (37e3 / k) ** (1 / 1.5)
    assert k * peak**2.5 / 2.5 == pytest.approx(0.145 * 67.0**2 / 2)


def test_swing_and_pitch() -> None:
    swing = Swing(bat_speed=31.3, measured_at=0.686, pivot=-0.02)
    assert swing.speed_at(0.686) == pytest.approx(31.3)
    assert swing.speed_at(-0.02) == 0.0
    for wrong, message in (
        ({"bat_speed": 0.0}, "bat speed was given as 0 mph; possible is more than 0, up to 157 mph"),
        ({"bat_speed": -1.0}, "bat speed was given as -2.237 mph; possible is more than 0, up to 157 mph"),
        ({"bat_speed": 90.0}, "bat speed was given as 201.3 mph; possible is 0 to 157 mph"),
        ({"measured_at": 0.01, "pivot": 0.02}, "bat speed is measured at"),
    ):
        with pytest.raises(InputError, match=message):
            swing.replaced(**wrong)
    with pytest.raises(InputError, match=r"speed was given as 223\.7 mph; possible is 0 to 157 mph"):
        Pitch(speed=100.0)
    with pytest.raises(InputError, match="0 for no hand"):
        Hands(position=0.15, mass=1e-300)
    with pytest.raises(InputError, match="without a mass hold nothing"):
        Hands(position=0.15, stiffness=1e9)
    assert Hands(position=0.15).places == pytest.approx((0.15, 0.061))
    assert Hands(position=0.05).places == (0.05, 0.0)


def test_a_weight_at_the_tip_is_still_on_the_bat_and_things_of_two_kinds_are_never_equal(ash: Material) -> None:
    """The wall of a hole that is narrower than the cup comes out of it: an edge there, none for one as wide."""
    assert bat(ash, added=({"position": 0.84, "mass": 0.01},)).added[0].mass == 0.01
    assert bat(ash) != ash and bat(ash) == bat(ash) and bat(ash) != 3
    cup = {"diameter": 0.04, "depth": 0.02}
    narrow, wide = (bat(ash, cup=cup, bores=({"diameter": size, "depth": 0.2},)) for size in (0.02, 0.04))
    (edge,) = set(narrow.breakpoints()) - set(wide.breakpoints())
    assert edge == pytest.approx(0.84 - 0.02 * (1 - 0.25))


def test_help_begins_with_names_and_defaults() -> None:
    """And not with the bounds of every type, which the docstring tells."""
    written = str(inspect.signature(Bat))
    assert written.startswith("(*, name, length, sport='baseball', mass=None,") and "Annotated" not in written
