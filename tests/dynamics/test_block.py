"""A block's motions against exact springs, columns, plates and the two-spring formula."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.drop_test import fire, static_share
from sweetspot.collision.coupled import hit
from sweetspot.dynamics import block as blocks
from sweetspot.dynamics.block import Block, block_modes, expected_patch, local_modes, modes_of_surface, plate, spring
from sweetspot.equipment.ball import Ball, RestitutionLaw
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.papers import formulas as paper

FALL = math.sqrt(2 * 9.80665)


@pytest.fixture
def linear_ball() -> Ball:
    law = RestitutionLaw(reference=0.5, reference_speed=40.0)
    return Ball(name="linear", mass=0.145, radius=0.037, restitution=law, stiffness=1e6, exponent=1.0)


@pytest.fixture
def metal() -> Material:
    return catalog.material("aluminium-7xxx")


@pytest.mark.parametrize("ratio", [5.0, 10.0, 50.0])
def test_a_spring_without_mass_gives_the_two_spring_formula(linear_ball: Ball, ratio: float) -> None:
    """e^2 = (s e0^2 + 1) / (s + 1) to 1e-3: exact. The faster the mode that stands for the spring, the closer.

    5 % of damping: without it a spring as soft as a fifth of this would ring on by itself, which no spring without
    mass can do.
    """
    exact = (ratio * 0.25 + 1) / (ratio + 1)
    misses = []
    for frequency in (10e3, 20e3, 40e3):
        modes = modes_of_surface(spring(1 / (ratio * linear_ball.stiffness), frequency=frequency), damping_ratio=0.05)
        impact = hit(modes, ball=linear_ball, position=0.0, closing_speed=40.0, step=5e-7)
        misses.append(abs(impact.collision_efficiency**2 - exact))
    assert max(misses[1:]) < 1e-3
    assert misses[2] < misses[0]


def test_a_deep_block_is_the_half_space_of_the_papers_limit(baseball: Ball, ash: Material) -> None:
    """z of the cone reaches Boussinesq's as 1 / (1 + z0 / depth); 1.4 % short at a depth of 1 m."""
    speed, hertz = 30.0, baseball.replaced(exponent=1.5, damping=0.0, law_ends=None)
    compression = (2.5 * hertz.mass * speed**2 / 2 / hertz.stiffness) ** 0.4
    limit = paper.block_share(hertz, material=ash, compression=compression)
    patch = expected_patch(hertz, speed)
    apex = math.pi * patch * (1 - 0.44**2) / 2
    for depth in (0.1, 1.0):
        deep = Block(material=ash, thickness=depth, length=10, width=10, floor_modulus=None)
        share = static_share(hertz, speed=speed, compliance=local_modes(deep, patch=patch, depth=depth).compliance)
        assert share / (1 - share) == pytest.approx(limit / (1 - limit) * depth / (depth + apex), rel=1e-3)


def test_a_thin_wide_layer_and_a_narrow_column_are_exact(metal: Material) -> None:
    """h / (E A), with A the patch for a thin layer and the whole section for a column: exact."""
    layer = Block(material=metal, thickness=0.001, floor_modulus=None)
    patch = 0.05
    assert local_modes(layer, patch=patch, depth=0.001).compliance == pytest.approx(
        0.001 / (metal.longitudinal_modulus * math.pi * patch**2), rel=0.02
    )
    column = Block(material=metal, thickness=2.0, length=0.02, width=0.02, floor_modulus=None)
    found = local_modes(column, patch=0.02 / math.sqrt(math.pi), depth=2.0)  # the patch covers the section
    assert found.compliance == pytest.approx(2.0 / (metal.longitudinal_modulus * 0.02**2), rel=1e-9)
    quarter_wave = math.sqrt(metal.longitudinal_modulus / metal.density) / (4 * 2.0)
    assert found.frequency[:2] == pytest.approx([quarter_wave, 3 * quarter_wave], rel=0.01)


def test_a_floor_gives_way_as_a_half_space(ash: Material) -> None:
    """Rigid and concrete floor differ by (1 - nu^2) / (2 E R), R the radius of the cone's foot: exact."""
    patch, depth = 0.015, 0.1
    on = {
        modulus: local_modes(
            Block(material=ash, thickness=depth, floor_modulus=modulus), patch=patch, depth=depth
        ).compliance
        for modulus in (None, 30e9)
    }
    foot = patch * (1 + depth / (math.pi * patch * (1 - 0.44**2) / 2))
    assert on[30e9] - on[None] == pytest.approx(0.96 / (2 * 30e9 * foot), rel=1e-6)


def test_a_thin_clamped_plate_has_the_published_frequency_and_give(metal: Material) -> None:
    """lambda^2 = 35.99 and w = 0.00560 F L^2 / D at the middle: Leissa's and Timoshenko's clamped square plate, exact
    to the digits given. Shear and the patch make 3 mm a little lower and stiffer.
    """
    sheet = Block(material=metal, thickness=0.003, support="clamped")
    rigidity = metal.longitudinal_modulus * 0.003**3 / 12 / (1 - 0.33**2)
    found = plate(sheet, patch=0.003)
    frequency = 35.99 / (2 * math.pi * 0.2**2) * math.sqrt(rigidity / (metal.density * 0.003))
    assert found.frequency[0] == pytest.approx(frequency, rel=3e-3)
    assert found.compliance == pytest.approx(0.00560 * 0.2**2 / rigidity, rel=0.02)


def test_a_free_block_is_a_mass_and_bends_as_published(metal: Material) -> None:
    """lambda^2 = 19.6 (mode with a ring-like node) for nu = 0.3 to 0.33, free square plate; even modes only: 1 %."""
    sheet = Block(material=metal, thickness=0.002, support="free")
    modes = block_modes(sheet, patch=0.005)
    assert modes.families[0] == "rigid" and modes.frequency[0] == 0
    assert modes.shape_at(0.0)[0] ** 2 == pytest.approx(1 / sheet.mass)
    rigidity = metal.longitudinal_modulus * 0.002**3 / 12 / (1 - 0.33**2)
    unit = math.sqrt(rigidity / (metal.density * 0.002)) / (2 * math.pi * 0.2**2)
    lowest = np.sort(modes.frequency[modes.frequency > 0])[:2] / unit
    assert lowest == pytest.approx([19.6, 24.3], rel=0.02)


def test_more_functions_change_little(metal: Material, baseball: Ball, monkeypatch: pytest.MonkeyPatch) -> None:
    """Convergence: 8 polynomials per direction against 10."""
    sheet = Block(material=metal, thickness=0.003, support="clamped")
    few = fire(sheet, ball=baseball, speed=FALL).rebound
    monkeypatch.setattr(blocks, "FUNCTIONS", 10)
    assert fire(sheet, ball=baseball, speed=FALL).rebound == pytest.approx(few, rel=2e-3)


def test_bad_blocks_are_refused(metal: Material) -> None:
    with pytest.raises(InputError, match=r"thickness is 0 mm; allowed is 0\.5 to 2000 mm"):
        Block(material=metal, thickness=0.0)
    with pytest.raises(InputError, match="width is 20000 mm"):
        Block(material=metal, thickness=0.1, width=20.0)
    with pytest.raises(InputError, match="wider than the face"):
        block_modes(Block(material=metal, thickness=0.1, length=0.03), patch=0.02)
