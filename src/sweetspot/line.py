"""A bat reduced to a beam: mass, bending and shear stiffness per length, and point masses.

Everything here is a polynomial between the bat's breakpoints (conical pieces, straight bores, a paraboloid cup),
so Gauss-Legendre quadrature on each piece gives the mass integrals exactly, to rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.bat import Bat
from sweetspot.errors import InputError
from sweetspot.material import Material
from sweetspot.plates import DEFAULT_POISSON, effective_moduli
from sweetspot.shell import WallPart

Array = NDArray[np.float64]

GAUSS_POINTS = 6
"""Exact to degree 11; the highest degree met is 7 (r^4 of a cone, times a density gradient, times x^2)."""
GRADIENT_LIMIT = 0.25
"""Largest density change from the middle to an end that may explain a measured balance or MOI (assumed)."""
KNOB_MASS_LIMITS = (-0.025, 0.085)
"""Mass at the knob that may explain measured values, kg (assumed: a knob smaller than drawn; tape, a knob weight)."""


class Lump(NamedTuple):
    """Mass in kg at a position in m from the knob end; slightly negative for a knob smaller than drawn."""

    position: float
    mass: float


@dataclass(frozen=True)
class Line:
    """A bat as a beam.

    Parameters
    ----------
    bat : the description it came from.
    density_factor : measured mass over mass at catalogue density, for the bat's own material.
    density_gradient : relative change of density from the middle of the bat to its tip.
    point_masses : everything that sits at one place: knob, end cap, added weights.
    """

    bat: Bat
    density_factor: float
    density_gradient: float
    point_masses: tuple[Lump, ...]


@dataclass(frozen=True)
class Section:
    """Properties per unit length at an array of positions (all arrays share its shape).

    Parameters
    ----------
    mass : kg/m.
    rotary_inertia : kg m, about a diameter (twice this about the bat's own axis).
    bending_stiffness : EI, N m^2.
    shear_stiffness : kappa G A, N.
    """

    mass: Array
    rotary_inertia: Array
    bending_stiffness: Array
    shear_stiffness: Array


def reduce(bat: Bat) -> Line:
    """Reduce a bat to a line whose mass, balance and moment of inertia are the measured ones, if any.

    A measured mass scales the density of the bat's own material. A measured balance point or moment of
    inertia then sets a density gradient along the bat, and both together also a mass at the knob.

    Raises
    ------
    InputError
        when no allowed density, gradient or knob mass gives what was measured; the message has the misfit.
    """
    measured = bat.original or bat
    line = _fitted(measured)
    return line if measured is bat else replace(line, bat=bat, point_masses=_carried_masses(bat, line))


def section(line: Line, position: Array) -> Section:
    """Return the section properties at positions in m (not exactly at a jump: there the inner side is taken)."""
    bat = line.bat
    outer = bat.diameter_at(position) / 2
    if bat.shell is not None:
        return _of_walls(bat.shell.parts(position, outer, bat.material), outer, density_scale(line, position))
    void = _void_radius(bat, position)
    material = bat.material
    density = material.density * density_scale(line, position)

    def between(low: Array, high: Array, power: int) -> Array:
        """Integral of r^(power-1) between two radii, with whatever lies inside the void left out."""
        return np.asarray((np.maximum(high, void) ** power - np.maximum(low, void) ** power) / power)

    zero = np.zeros_like(position)
    area = 2 * math.pi * between(zero, outer, 2)
    second = math.pi * between(zero, outer, 4)
    mass, rotary = density * area, density * second
    bending, shear = material.longitudinal_modulus * second, material.shear * area
    for start, stop, radius, fill in _inclusions(bat):
        inside = np.where((position > start) & (position <= stop), radius, 0.0)
        area, second = 2 * math.pi * between(zero, inside, 2), math.pi * between(zero, inside, 4)
        fill_density = fill.density if fill else 0.0
        mass = mass + (fill_density - density) * area
        rotary = rotary + (fill_density - density) * second
        bending = bending + ((fill.longitudinal_modulus if fill else 0.0) - material.longitudinal_modulus) * second
        shear = shear + ((fill.shear if fill else 0.0) - material.shear) * area
        void = np.maximum(void, inside) if fill is None else void
    poisson = DEFAULT_POISSON if material.poisson_ratio is None else material.poisson_ratio
    return Section(mass, rotary, bending, shear_coefficient(void / outer, poisson) * shear)


def density_scale(line: Line, position: Array) -> Array:
    """Return the bat's density at positions in m over its catalogue density: factor and gradient of the fit.

    All walls of a hollow bat, sleeve and handle included, are scaled alike; fills are not.
    """
    return line.density_factor * (1 + line.density_gradient * (2 * position / line.bat.length - 1))


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


def _of_walls(parts: list[WallPart], outer: Array, scale: Array) -> Section:
    """Return the section properties of concentric walls that bend as one bat: everything adds.

    A laminate counts with its effective moduli along the bat and in shear [jones1999].
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
    return Section(mass, rotary, bending, shear)


def _moduli(part: WallPart) -> tuple[float, float, float]:
    """Return Young's modulus along the bat, shear modulus (Pa) and Poisson ratio of a wall."""
    if part.laminate is not None:
        found = effective_moduli(part.laminate)
        return found.axial, found.shear, min(max(found.poisson_ratio, 0.0), 0.5)  # Cowper's range
    material = part.material
    poisson = DEFAULT_POISSON if material.poisson_ratio is None else material.poisson_ratio
    return material.longitudinal_modulus, material.shear, poisson


def integrate(line: Line, density_of: Callable[[Array], Array]) -> float:
    """Integrate a function of position over the bat, piece by piece between its breakpoints."""
    places, weights = quadrature(line.bat.breakpoints())
    return float(np.sum(weights * density_of(places)))


def quadrature(edges: tuple[float, ...]) -> tuple[Array, Array]:
    """Return Gauss-Legendre positions and weights on every piece between ``edges``, one after the other."""
    nodes, weights = np.polynomial.legendre.leggauss(GAUSS_POINTS)
    left, width = np.array(edges[:-1]), np.diff(edges)
    places = left[:, None] + width[:, None] * (nodes + 1) / 2
    return places.ravel(), (width[:, None] * weights / 2).ravel()


def moments(line: Line) -> tuple[float, float, float]:
    """Return mass (kg), first moment (kg m) and second moment (kg m^2) about the knob end.

    The second moment includes the rotary inertia of the sections and the point masses.
    """
    places, weights = quadrature(line.bat.breakpoints())
    at = section(line, places)
    zeroth = float(np.sum(weights * at.mass))
    first = float(np.sum(weights * at.mass * places))
    second = float(np.sum(weights * (at.mass * places**2 + at.rotary_inertia)))
    for weight in line.point_masses:
        zeroth += weight.mass
        first += weight.mass * weight.position
        second += weight.mass * weight.position**2
    return zeroth, first, second


def _inclusions(bat: Bat) -> Iterator[tuple[float, float, float, Material | None]]:
    """Yield (start, stop, radius, material or None) of every hole and fill, widest first."""
    for bore in sorted(bat.bores, key=lambda bore: -bore.diameter):
        yield bat.length - bore.depth, bat.length - bore.plug, bore.diameter / 2, bore.fill


def _void_radius(bat: Bat, position: Array) -> Array:
    """Return the radius within which there is nothing at all: in the cup."""
    if bat.cup is None:
        return np.zeros_like(position)
    into_cup = 1 - (bat.length - position) / bat.cup.depth
    return bat.cup.diameter / 2 * np.sqrt(np.maximum(into_cup, 0.0))


def _own_point_masses(bat: Bat) -> tuple[Lump, ...]:
    """Return the weights the description itself names: added ones, knob, joint and end cap of a shell."""
    masses = [Lump(weight.position, weight.mass) for weight in bat.point_masses]
    if bat.shell is not None and bat.shell.knob_mass:
        masses.append(Lump(0.0, bat.shell.knob_mass))
    if bat.shell is not None and bat.shell.joint is not None and bat.shell.joint_mass:
        masses.append(Lump(bat.shell.joint, bat.shell.joint_mass))
    if bat.shell is not None and bat.shell.end_cap_mass:
        masses.append(Lump(bat.length, bat.shell.end_cap_mass))
    return tuple(masses)


def _carried_masses(bat: Bat, line: Line) -> tuple[Lump, ...]:
    """Return the point masses of a modified bat: its own, and what the fit put at the original's knob."""
    fitted = line.point_masses[len(_own_point_masses(line.bat)) :]
    return _own_point_masses(bat) + fitted


def _fitted(bat: Bat) -> Line:
    """Fit density factor, gradient and knob mass to what was measured: three linear equations at most."""
    plain = Line(bat, 1.0, 0.0, _own_point_masses(bat))
    if bat.mass is None:
        if bat.balance_point is not None or bat.moi is not None:
            raise InputError(f"{bat.name} has a measured balance point or moi but no mass; weigh it and give the mass")
        return plain
    base = np.array(moments(plain))
    nothing = np.array(moments(replace(plain, density_factor=0.0)))  # fills and point masses alone
    tilted = np.array(moments(replace(plain, density_gradient=1.0)))
    effects = np.array([base - nothing, tilted - base, [1.0, 0.0, 0.0]]).T  # of density, gradient, knob mass
    axis = bat.moi_axis
    about_axis = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [axis**2, -2 * axis, 1.0]])
    measured = (bat.mass, None if bat.balance_point is None else bat.mass * bat.balance_point, bat.moi)
    rows = [row for row, value in enumerate(measured) if value is not None]
    targets = np.array([measured[row] for row in rows], dtype=float) - (about_axis @ nothing)[rows]
    unknowns = np.zeros(3)
    unknowns[: len(rows)] = np.linalg.solve((about_axis @ effects)[rows, : len(rows)], targets)
    factor, gradient, knob_mass = unknowns[0], unknowns[1] / unknowns[0], unknowns[2]
    _check_fit(bat, base, factor, gradient, knob_mass)
    masses = plain.point_masses
    if knob_mass:
        masses = (*masses, Lump(0.0, float(knob_mass)))
    return Line(bat, float(factor), float(gradient), masses)


def _check_fit(bat: Bat, base: Array, factor: float, gradient: float, knob_mass: float) -> None:
    """Refuse measured values that this outline cannot have, saying by how much they miss."""
    material = bat.material
    laminate = None if bat.shell is None else bat.shell.laminate
    usual = material.density if laminate is None else laminate.density
    light, heavy = material.density_range or (material.density, material.density)
    low, high = usual * light / material.density, usual * heavy / material.density
    density, slack = factor * usual, 1e-9 * usual
    fits = low - slack <= density <= high + slack
    lightest, heaviest = KNOB_MASS_LIMITS
    if bat.balance_point is None and bat.moi is None:
        if not fits:
            raise InputError(
                f"{bat.name} weighs {bat.mass:.4g} kg, which this outline has only at a density of "
                f"{density:.0f} kg/m^3; {material.name} can be {low:.0f} to {high:.0f} kg/m^3. "
                "Check the weight, the diameters and the material"
            )
    elif not fits or abs(gradient) > GRADIENT_LIMIT or not lightest <= knob_mass <= heaviest:
        mass, first, second = base * (bat.mass or 0.0) / base[0]
        about = second - 2 * bat.moi_axis * first + bat.moi_axis**2 * mass
        measured = [f"balance point {bat.balance_point:.4g} m"] if bat.balance_point is not None else []
        measured += [f"moi {bat.moi:.4g} kg m^2"] if bat.moi is not None else []
        raise InputError(
            f"{bat.name}: at {bat.mass:.4g} kg the outline gives balance point {first / mass:.4g} m and moi "
            f"{about:.4g} kg m^2 about {bat.moi_axis:.4g} m, but {' and '.join(measured)} was measured. To fit, "
            f"the density would have to be {density:.0f} kg/m^3 (allowed {low:.0f} to {high:.0f}), change by "
            f"{100 * gradient:.0f} % towards the tip (allowed {100 * GRADIENT_LIMIT:.0f} %), and the knob weigh "
            f"{1e3 * knob_mass:.0f} g more (allowed {1e3 * lightest:.0f} to {1e3 * heaviest:.0f} g). "
            "Check the profile or the measurement"
        )
