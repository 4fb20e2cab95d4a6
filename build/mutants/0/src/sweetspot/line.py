"""A bat, or any other implement, reduced to a beam: mass, bending and shear stiffness per length, point masses.

Everything about a bat is a polynomial between its breakpoints (conical pieces, straight bores, a paraboloid cup),
so Gauss-Legendre quadrature on each piece gives the mass integrals exactly, to rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sweetspot.bat import Bat
from sweetspot.errors import InputError
from sweetspot.implement import DensityRange, Implement, Lump
from sweetspot.quadrature import quadrature
from sweetspot.section import Section

Array = NDArray[np.float64]

GRADIENT_LIMIT = 0.25
"""Largest density change from the middle to an end that may explain a measured balance or MOI (assumed)."""
KNOB_MASS_LIMITS = (-0.025, 0.085)
"""Mass at the knob that may explain measured values, kg (assumed: a knob smaller than drawn; tape, a knob weight)."""


@dataclass(frozen=True)
class Line:
    """A bat as a beam.

    Parameters
    ----------
    bat : the description it came from; a racket, club or stick serves as well.
    density_factor : measured mass over mass at catalogue density, for the bat's own material.
    density_gradient : relative change of density from the middle of the bat to its tip.
    point_masses : everything that sits at one place: knob, end cap, head of a club, added weights.
    """

    bat: Implement
    density_factor: float
    density_gradient: float
    point_masses: tuple[Lump, ...]


def reduce(bat: Implement) -> Line:
    """Reduce a bat to a line whose mass, balance and moment of inertia are the measured ones, if any.

    A measured mass scales the density of the bat's own material. A measured balance point or moment of
    inertia then sets a density gradient along the bat, and both together also a mass at the knob.

    Raises
    ------
    InputError
        when no allowed density, gradient or knob mass gives what was measured; the message has the misfit.
    """
    measured = bat.as_measured()
    known = measured.density_range
    line = Line(measured, 1.0, 0.0, measured.lumps()) if known is None else _fitted(measured, known)
    return line if measured is bat else replace(line, bat=bat, point_masses=_carried_masses(bat, line))


def line_of_bat(line: Line) -> Bat:
    """Return the bat of a line, or refuse any other implement where the question makes sense for a bat only."""
    if not isinstance(line.bat, Bat):
        raise InputError(f"{line.bat.name} is not a bat with a round barrel; this answer exists for bats only")
    return line.bat


def section(line: Line, position: Array) -> Section:
    """Return the section properties at positions in m (not exactly at a jump: there the inner side is taken)."""
    return line.bat.section_at(position, density_scale(line, position))


def density_scale(line: Line, position: Array) -> Array:
    """Return the bat's density at positions in m over its catalogue density: factor and gradient of the fit.

    All walls of a hollow bat, sleeve and handle included, are scaled alike; fills are not.
    """
    return line.density_factor * (1 + line.density_gradient * (2 * position / line.bat.length - 1))


def integrate(line: Line, density_of: Callable[[Array], Array]) -> float:
    """Integrate a function of position over the bat, piece by piece between its breakpoints."""
    places, weights = quadrature(line.bat.breakpoints())
    return float(np.sum(weights * density_of(places)))


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
        second += weight.mass * weight.position**2 + weight.moi
    return zeroth, first, second


def _carried_masses(bat: Implement, line: Line) -> tuple[Lump, ...]:
    """Return the point masses of a modified bat: its own, and what the fit put at the original's knob."""
    fitted = line.point_masses[len(line.bat.lumps()) :]
    return bat.lumps() + fitted


def _fitted(bat: Implement, known: DensityRange) -> Line:
    """Fit density factor, gradient and knob mass to what was measured: three linear equations at most."""
    plain = Line(bat, 1.0, 0.0, bat.lumps())
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
    _check_fit(bat, known, base, (float(factor), float(gradient), float(knob_mass)))
    masses = plain.point_masses
    if knob_mass:
        masses = (*masses, Lump(0.0, float(knob_mass)))
    return Line(bat, float(factor), float(gradient), masses)


def _check_fit(bat: Implement, known: DensityRange, base: Array, fit: tuple[float, float, float]) -> None:
    """Refuse measured values that this outline cannot have, saying by how much they miss."""
    factor, gradient, knob_mass = fit
    usual, low, high = known
    density, slack = factor * usual, 1e-9 * usual
    fits = low - slack <= density <= high + slack
    lightest, heaviest = KNOB_MASS_LIMITS
    if bat.balance_point is None and bat.moi is None:
        if not fits:
            raise InputError(
                f"{bat.name} weighs {bat.mass:.4g} kg, which this outline has only at a density of "
                f"{density:.0f} kg/m^3; {bat.made_of} can be {low:.0f} to {high:.0f} kg/m^3. "
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
