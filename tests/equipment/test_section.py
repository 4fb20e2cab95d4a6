"""Sections against plain integrals over rings and ellipses, and against the limits of Cowper's coefficient."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.equipment.section import of_oval_tube, of_solid, shear_coefficient

OUTER, INNER = 0.033, 0.0127
ASH, CORK = catalog.material("white_ash"), catalog.material("cork")


def disc(radius: float) -> tuple[float, float]:
    """Area and second moment of a disc."""
    return math.pi * radius**2, math.pi * radius**4 / 4


@pytest.mark.parametrize("fill", [None, CORK])
def test_a_bored_section_is_ring_and_fill(fill: object) -> None:
    """Exact: what is left of the wood, plus the fill, each with its own density and moduli."""
    one = np.array([OUTER])
    found = of_solid(ASH, outer=one, void=0 * one, inclusions=[(np.array([INNER]), fill)], scale=1.0)  # type: ignore[list-item, arg-type]
    (area, second), (hole, hole_second) = disc(OUTER), disc(INNER)
    filled = CORK if fill is not None else None
    density, modulus, shear = (filled.density, filled.longitudinal_modulus, filled.shear) if filled else (0.0, 0.0, 0.0)
    assert found.mass[0] == pytest.approx(ASH.density * (area - hole) + density * hole)
    rotary = ASH.density * (second - hole_second) + density * hole_second
    assert found.rotary_inertia[0] == pytest.approx(rotary)
    assert found.roll_inertia[0] == pytest.approx(2 * rotary)
    stiff = ASH.longitudinal_modulus * (second - hole_second) + modulus * hole_second
    assert found.bending_stiffness[0] == pytest.approx(stiff)
    ratio = 0.0 if filled else INNER / OUTER
    kappa = float(shear_coefficient(np.array(ratio), ASH.poisson))
    assert found.shear_stiffness[0] == pytest.approx(kappa * (ASH.shear * (area - hole) + shear * hole))


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_cowpers_coefficient_has_its_limits(poisson: float) -> None:
    """[cowper1966]: 6 (1 + nu)/(7 + 6 nu) of a solid round, 2 (1 + nu)/(4 + 3 nu) of a thin round tube."""
    assert shear_coefficient(np.array(0.0), poisson) == pytest.approx(6 * (1 + poisson) / (7 + 6 * poisson))
    assert shear_coefficient(np.array(1.0), poisson) == pytest.approx(2 * (1 + poisson) / (4 + 3 * poisson))


def test_an_oval_tube_is_an_ellipse_less_an_ellipse() -> None:
    """Exact: EI about the wide axis is pi a b^3 / 4 with b along the ball's path."""
    a, b, wall = 0.02, 0.012, 0.003
    one = np.ones(1)
    found = of_oval_tube(ASH, width=2 * a * one, depth=2 * b * one, wall=wall * one, scale=one)
    inner_a, inner_b = a - wall, b - wall
    second = math.pi * (a * b**3 - inner_a * inner_b**3) / 4
    sideways = math.pi * (a**3 * b - inner_a**3 * inner_b) / 4
    assert found.bending_stiffness[0] == pytest.approx(ASH.longitudinal_modulus * second)
    assert found.rotary_inertia[0] == pytest.approx(ASH.density * second)
    assert found.roll_inertia[0] == pytest.approx(ASH.density * (second + sideways))
    assert found.mass[0] == pytest.approx(ASH.density * math.pi * (a * b - inner_a * inner_b))
