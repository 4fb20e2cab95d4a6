"""Section properties of a beam: mass, inertia and stiffness per length, of round bodies, walls and anything else."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from sweetspot.equipment.laminate import effective_moduli
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import WallPart
from sweetspot.numerics.arrays import Array


@dataclass(frozen=True)
class CrossSection:
    """Properties per unit length at an array of positions (all arrays share its shape).

    Parameters
    ----------
    mass : kg/m.
    rotary_inertia : kg m, about the axis across the line and across the ball's path, on which the section tilts.
    bending_stiffness : EI, N m^2, in the plane of the ball's path.
    shear_stiffness : kappa G A, N.
    roll_inertia : kg m, about the line itself; twice ``rotary_inertia`` where the section is round.
    """

    mass: Array
    rotary_inertia: Array
    bending_stiffness: Array
    shear_stiffness: Array
    roll_inertia: Array


FLAT_SHEAR = 5 / 6
"""Timoshenko's shear coefficient of a rectangular section [cowper1966]."""


def shear_coefficient(radius_ratio: Array, poisson_ratio: float) -> Array:
    """Return Timoshenko's shear coefficient of a round section with inner-to-outer radius ratio m.

    kappa = 6 (1 + nu) (1 + m^2)^2 / ((7 + 6 nu) (1 + m^2)^2 + (20 + 12 nu) m^2); Cowper 1966 [cowper1966].

    >>> round(float(shear_coefficient(np.array(0.0), 0.3)), 4)
    0.8864
    """
    square = np.asarray(radius_ratio) ** 2
    full = (1 + square) ** 2
    top = 6 * (1 + poisson_ratio) * full
    return np.asarray(top / ((7 + 6 * poisson_ratio) * full + (20 + 12 * poisson_ratio) * square))


def of_solid(
    material: Material, *, outer: Array, void: Array, inclusions: Iterable[tuple[Array, Material | None]], scale: Array
) -> CrossSection:
    """Return the section of a round solid body with holes and fills.

    Parameters
    ----------
    outer, void : radius in m of the body, and within which there is nothing at all.
    inclusions : (radius in m, what fills it or None for a hole), radius 0 where there is none, widest first.
    scale : the material's density over its catalogue value; fills are not scaled.
    """
    density = material.density * scale

    def between(low: Array, high: Array, power: int) -> Array:
        """Integral of r^(power-1) between two radii, with whatever lies inside the void left out."""
        return np.asarray((np.maximum(high, void) ** power - np.maximum(low, void) ** power) / power)

    zero = np.zeros_like(outer)
    area = 2 * math.pi * between(zero, outer, 2)
    second = math.pi * between(zero, outer, 4)
    mass, rotary = density * area, density * second
    bending, shear = material.longitudinal_modulus * second, material.shear * area
    for inside, fill in inclusions:
        area, second = 2 * math.pi * between(zero, inside, 2), math.pi * between(zero, inside, 4)
        fill_density = fill.density if fill else 0.0
        mass = mass + (fill_density - density) * area
        rotary = rotary + (fill_density - density) * second
        bending = bending + ((fill.longitudinal_modulus if fill else 0.0) - material.longitudinal_modulus) * second
        shear = shear + ((fill.shear if fill else 0.0) - material.shear) * area
        void = np.maximum(void, inside) if fill is None else void
    return CrossSection(mass, rotary, bending, shear_coefficient(void / outer, material.poisson) * shear, 2 * rotary)


def of_walls(parts: list[WallPart], outer: Array, scale: Array) -> CrossSection:
    """Return the section of concentric walls that bend as one body: everything adds.

    A laminate counts with its effective moduli along the line and in shear [jones1999].
    """
    hole = np.asarray(np.min([np.where(part.thickness > 0, part.inner, outer) for part in parts], axis=0))
    mass, rotary, bending, shear = (np.zeros_like(outer) for _ in range(4))
    for part in parts:
        along, across, poisson = _moduli(part)
        area = math.pi * (part.outer**2 - part.inner**2)
        second = math.pi * (part.outer**4 - part.inner**4) / 4
        mass = mass + part.density * scale * area
        rotary = rotary + part.density * scale * second
        bending = bending + along * second
        shear = shear + shear_coefficient(hole / outer, poisson) * across * area
    return CrossSection(mass, rotary, bending, shear, 2 * rotary)


def _moduli(part: WallPart) -> tuple[float, float, float]:
    """Return Young's modulus along the line, shear modulus (Pa) and Poisson ratio of a wall."""
    if part.laminate is not None:
        moduli = effective_moduli(part.laminate)
        return moduli.axial, moduli.shear, min(max(moduli.poisson_ratio, 0.0), 0.5)  # Cowper's range
    return part.material.longitudinal_modulus, part.material.shear, part.material.poisson


def of_oval_tube(material: Material, *, width: Array, depth: Array, wall: Array, scale: Array) -> CrossSection:
    """Return the section of an elliptical tube, solid where the wall reaches its middle.

    EI = E pi (a b^3 - (a - h) (b - h)^3) / 4 with half width a, half depth b and wall h; the shear coefficient is that
    of the round tube with the same ratio of hole to outside.

    Parameters
    ----------
    width, depth, wall : m, across the ball's path, along it, and of the wall.
    scale : density over the material's catalogue value.
    """
    a, b = width / 2, depth / 2
    inner_a, inner_b = np.maximum(a - wall, 0.0), np.maximum(b - wall, 0.0)
    area = math.pi * (a * b - inner_a * inner_b)
    second = math.pi * (a * b**3 - inner_a * inner_b**3) / 4
    sideways = math.pi * (a**3 * b - inner_a**3 * inner_b) / 4
    density = material.density * scale
    shear = shear_coefficient(inner_b / b, material.poisson) * material.shear * area
    bending = material.longitudinal_modulus * second
    return CrossSection(density * area, density * second, bending, shear, density * (second + sideways))


def evenly(mass: Array | float, radius: Array | float, sections: CrossSection) -> CrossSection:
    """Return sections in a thin sleeve of mass per length (kg/m) at a radius (m), which adds no stiffness."""
    about = np.asarray(mass) * np.asarray(radius) ** 2
    return CrossSection(
        sections.mass + mass,
        sections.rotary_inertia + about / 2,
        sections.bending_stiffness,
        sections.shear_stiffness,
        sections.roll_inertia + about,
    )
