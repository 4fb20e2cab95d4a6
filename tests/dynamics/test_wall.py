"""Walls of hollow bats: what the barrel is as a shell, and the beam made of the same geometry."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import BeamModel, beam_model, section
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.wall import wall_stiffness
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.laminate import Laminate, Ply, effective_moduli
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import InnerWall
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

METAL = Material(name="metal", family="metal", density=2800, longitudinal_modulus=71e9, poisson_ratio=0.33)
PLY = Material(
    name="ply", family="laminate", density=1600, longitudinal_modulus=130e9, transverse_modulus=9e9,
    shear_modulus=5e9, poisson_ratio=0.3,
)  # fmt: skip
PLIES = Laminate(plies=tuple(Ply(material=PLY, angle=angle, thickness=2e-4) for angle in (0.4, -0.4, -0.4, 0.4)))
PLACES = np.array([0.3, 0.6, 0.7])


def tube(wall: float = 0.003, material: Material = METAL, **shell: Any) -> BeamModel:
    stations = ((0.0, wall), (0.84, wall))
    outline = ((0.0, 0.06), (0.84, 0.06))
    return beam_model(
        Bat(name="tube", length=0.84, material=material, profile=outline, shell={"wall": stations, **shell})
    )


def sleeve(thickness: float, **changes: Any) -> InnerWall:
    return InnerWall(wall=((0.5, thickness), (0.8, thickness)), **{"material": METAL, **changes})


def test_one_wall() -> None:
    wall = wall_stiffness(tube(), PLACES)
    assert wall.mean_radius == pytest.approx(0.0285) and wall.thickness == pytest.approx(0.003)
    assert wall.mass_per_area == pytest.approx(2800 * 0.003)
    assert wall.stretching.shape == wall.coupling.shape == wall.bending.shape == (3, 3, 3)
    assert wall.bending[:, 1, 1] == pytest.approx(71e9 * 0.003**3 / 12 / (1 - 0.33**2))  # exact


def test_one_laminate() -> None:
    wall = wall_stiffness(tube(laminate=PLIES), PLACES)
    assert wall.mass_per_area == pytest.approx(1600 * 0.003)
    assert np.linalg.eigvalsh(wall.stretching).min() > 0 and np.abs(wall.coupling).max() < 1e-6
    assert wall.stretching[0, 0, 0] > wall.stretching[0, 1, 1]  # fibres lie nearer to the axis


def test_a_bonded_sleeve_of_the_same_metal_is_a_thicker_wall() -> None:
    double = wall_stiffness(tube(0.002, inner_wall=sleeve(0.001, bonded=True)), PLACES)
    single = wall_stiffness(tube(0.003), PLACES)
    for name in ("mass_per_area", "mean_radius", "thickness", "stretching", "bending"):
        assert np.allclose(getattr(double, name)[1:], getattr(single, name)[1:], rtol=1e-12), name
    assert np.abs(double.coupling).max() < 1e-6
    assert double.thickness[0] == pytest.approx(0.002)  # the sleeve starts further out


def test_a_bonded_sleeve_of_another_material_couples() -> None:
    steel = METAL.replaced(longitudinal_modulus=142e9)
    wall = wall_stiffness(tube(0.001, inner_wall=sleeve(0.001, material=steel, bonded=True)), PLACES)
    a = 71e9 * 0.001 / (1 - 0.33**2)
    assert wall.coupling[1, 0, 0] == pytest.approx(-a * 0.0005)  # exact: (A_outer - A_inner) times half a wall
    assert wall.bending[1, 0, 0] == pytest.approx(3 * a * (0.001**2 / 12 + 0.0005**2))


def test_a_loose_sleeve_bends_much_more_easily() -> None:
    """Two equal walls: stretching doubles, bending doubles too, where a bonded pair would be eight times stiffer."""
    one = wall_stiffness(tube(0.0015), PLACES)
    loose = wall_stiffness(tube(0.0015, inner_wall=sleeve(0.0015, gap=0.0005)), PLACES)
    bonded = wall_stiffness(tube(0.0015, inner_wall=sleeve(0.0015, bonded=True)), PLACES)
    assert np.allclose(loose.bending[1:], 2 * one.bending[1:], rtol=1e-12)
    assert np.allclose(loose.stretching[1:], 2 * one.stretching[1:], rtol=1e-12)
    assert np.allclose(bonded.bending[1:], 8 * one.bending[1:], rtol=1e-12)
    assert loose.mean_radius[1] == pytest.approx(0.03 - 0.0015 - 0.0005 / 2)


@pytest.mark.parametrize("name", ["single-wall", "double-wall", "composite", "two-piece", "slow-pitch", "russell-b6"])
def test_wall_and_beam_have_the_same_mass(name: str) -> None:
    beam = beam_model(catalog.bat(name))
    places = np.linspace(0.1, 0.83, 37)
    wall = wall_stiffness(beam, places)
    around = 2 * math.pi * wall.mean_radius * wall.mass_per_area
    assert np.allclose(around, section(beam, places).mass, rtol=1e-12)
    height = wall.thickness[:, None, None]  # brings A, B and D to one unit
    whole = np.block([[wall.stretching * height**2, wall.coupling * height], [wall.coupling * height, wall.bending]])
    assert np.linalg.eigvalsh(whole).min() > 0


def test_a_drilled_bat_has_a_wall_and_a_solid_one_has_none() -> None:
    ash = catalog.material("white ash")
    solid = Bat(name="rod", length=0.84, material=ash, profile=((0.0, 0.06), (0.84, 0.06)))
    drilled = solid.drilled(diameter=0.0254, depth=0.254)
    wall = wall_stiffness(beam_model(drilled), np.array([0.5, 0.7]))
    assert wall.thickness == pytest.approx([0.03, 0.03 - 0.0127])
    assert wall.bending[1, 0, 0] > 5 * wall.bending[1, 1, 1]  # wood is soft around the barrel
    with pytest.raises(InputError, match="solid and has no wall"):
        wall_stiffness(beam_model(solid), np.array([0.5]))


def test_beam_of_two_walls_is_exact() -> None:
    beam = tube(0.002, inner_wall=sleeve(0.0015, gap=0.0005, material=METAL.replaced(longitudinal_modulus=200e9)))
    found = section(beam, np.array([0.6]))
    ring = [(0.03, 0.028, 71e9), (0.0275, 0.026, 200e9)]
    assert found.mass[0] == pytest.approx(2800 * math.pi * sum(a**2 - b**2 for a, b, _ in ring), rel=1e-14)
    assert found.bending_stiffness[0] == pytest.approx(
        math.pi / 4 * sum(e * (a**4 - b**4) for a, b, e in ring), rel=1e-14
    )
    assert rigid_body(beam).mass == pytest.approx(
        2800 * math.pi * (0.84 * (0.03**2 - 0.028**2) + 0.3 * (0.0275**2 - 0.026**2)), rel=1e-13
    )


def test_beam_of_a_laminate_has_its_effective_modulus() -> None:
    found = section(tube(laminate=PLIES), np.array([0.6]))
    exact = effective_moduli(PLIES).axial * math.pi / 4 * (0.03**4 - 0.027**4)
    assert found.bending_stiffness[0] == pytest.approx(exact, rel=1e-12)


def test_a_two_piece_bat_adds_up_exactly() -> None:
    handle = METAL.replaced(density=1400, longitudinal_modulus=40e9)
    beam = tube(handle_material=handle, joint=0.3, joint_mass=0.05)
    body, area = rigid_body(beam), math.pi * (0.03**2 - 0.027**2)
    masses = np.array([1400 * area * 0.3, 0.05, 2800 * area * 0.54])
    assert body.mass == pytest.approx(masses.sum(), rel=1e-13)
    assert body.balance_point == pytest.approx(masses @ [0.15, 0.3, 0.57] / masses.sum(), rel=1e-13)
    soft, stiff = section(beam, np.array([0.29, 0.31])).bending_stiffness
    assert stiff / soft == pytest.approx(71 / 40)


def test_scaling_makes_both_walls_thicker() -> None:
    bat = tube(0.002, inner_wall=sleeve(0.0015, gap=0.0005)).bat
    assert isinstance(bat, Bat)
    shell = bat.shell
    assert shell is not None and shell.inner_wall is not None
    thick = shell.scaled(1.2)
    assert thick.inner_wall is not None and thick.inner_wall.gap == 0.0005
    assert thick.wall[0][1] == pytest.approx(0.0024) and thick.inner_wall.wall[0][1] == pytest.approx(0.0018)


def test_a_measured_mass_is_judged_by_the_laminate() -> None:
    """Plies may be heavier than the material that stands for their damping; only the misfit of the weight counts."""
    heavy = Laminate(plies=(Ply(material=PLY.replaced(density=1900), thickness=1e-3),))
    plain = tube(laminate=heavy, material=PLY.replaced(density_range=(1500.0, 1700.0)))
    mass = rigid_body(plain).mass
    assert rigid_body(beam_model(plain.bat.replaced(mass=1.03 * mass))).mass == pytest.approx(1.03 * mass)
    with pytest.raises(InputError, match="2090 kg/m"):
        beam_model(plain.bat.replaced(mass=1.1 * mass))


def test_a_measured_mass_scales_every_wall() -> None:
    plain = tube(0.002, inner_wall=sleeve(0.0015))
    heavier = beam_model(
        plain.bat.replaced(mass=1.02 * rigid_body(plain).mass, material=METAL.replaced(density_range=(2700.0, 2900.0)))
    )
    ratio = wall_stiffness(heavier, PLACES).mass_per_area / wall_stiffness(plain, PLACES).mass_per_area
    assert ratio == pytest.approx(1.02)


B6 = (31.0, 20.4, 9590.0)
B7 = (30.5, 19.3, 8664.0)


@pytest.mark.parametrize(
    ("name", "target"), [("double-wall", B6), ("two-piece", B6), ("composite", B7)]
)  # [russell2010swing]
def test_catalogue_shells_have_published_inertia(name: str, target: tuple[float, float, float]) -> None:
    body = rigid_body(beam_model(catalog.bat(name)))
    found = (body.mass / OUNCE, body.balance_point / INCH, body.moi(6 * INCH) / OUNCE_INCH_SQUARED)
    assert found == pytest.approx(target, rel=2e-3)


@pytest.mark.parametrize(
    ("name", "low", "high"), [("single-wall", 8000, 10000), ("slow-pitch", 7000, 10000)]
)  # [wsu_glossary]
def test_the_others_lie_in_the_published_range(name: str, low: float, high: float) -> None:
    bat = catalog.bat(name)
    body = rigid_body(beam_model(bat))
    assert low < body.moi(6 * INCH) / OUNCE_INCH_SQUARED < high
    assert body.mass / OUNCE > bat.length / INCH - 3.05 or name == "slow-pitch"  # weight over length [ncaa_bbcor]


@pytest.mark.parametrize("name", ["single-wall", "double-wall", "composite", "two-piece", "slow-pitch"])
def test_first_bending_frequency_is_that_of_a_bat(name: str) -> None:
    """Adult bats lie near 170 Hz [russell_batvibes]; stiff composite handles are higher."""
    assert 130 < bending_modes(beam_model(catalog.bat(name))).frequency[2] < 230
