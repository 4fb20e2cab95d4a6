"""A bat, or any other implement, reduced to a beam: mass, bending and shear stiffness per length, point masses.

Everything about a bat is a polynomial between its breakpoints (conical pieces, straight bores, a paraboloid cup),
so Gauss-Legendre quadrature on each piece gives the mass integrals exactly, to rounding.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import DensityRange, Implement, Lump
from sweetspot.equipment.mass_fit import Correction, least_departure, nearest
from sweetspot.equipment.section import CrossSection
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.gauss_legendre import quadrature
from sweetspot.units import INCH, OUNCE_INCH_SQUARED, format_density, format_length, format_mass

BALANCE_SCATTER = 0.3 * INCH
"""By how much a measured balance point may differ from the drawing's before the drawing is corrected: 3 standard
deviations of 0.1 in, which diameters and balance points taken at home scatter by (assumed)."""
MOI_SCATTER = 0.03
"""The same for the moment of inertia, relative: 3 standard deviations of 1 % (assumed)."""
USUAL_GRADIENT, GRADIENT_LIMIT = 0.02, 0.25
"""Usual and largest relative change of density from the middle to an end that may explain measurements (assumed)."""
USUAL_GRIP_MASS, HEAVIEST_GRIP = 0.010, 0.085
"""Usual and most mass at the grip that may explain measurements, kg (assumed: tape, knob weight, oversize knob)."""
LIGHTEST_GRIP = -0.4
"""Least relative change of density at the knob end (assumed: a knob and handle smaller than drawn)."""
CALIBRATED_BEYOND = 2.0
"""Factor by which a calibrated implement's density may lie beyond its material's (assumed: walls are not as drawn)."""
HALVINGS = 20
"""Bisections between a drawing and the measured values, to report the nearest possible: beyond any digit shown."""
GRIP_POWER = 6
"""Mass at the grip falls as (1 - x / L)^6: to a third where the upper hand begins, and most of it is in the knob."""


@dataclass(frozen=True)
class BeamModel:
    """A bat as a beam.

    Parameters
    ----------
    bat : the description it came from; a racket, club or stick serves as well.
    density_factor : measured mass over mass at catalogue density, for the bat's own material.
    density_gradient : relative change of density from the middle of the bat to its tip.
    point_masses : everything that sits at one place: knob, end cap, head of a club, added weights.
    grip_excess : relative change of density at the knob end, which fades along the handle.
    unplaced : what was measured beyond the distribution, within the scatter of measurements: first moment (kg m) and
        second moment about the knob end (kg m^2). It counts for the motion as a whole, not for bending.
    """

    bat: Implement
    density_factor: float
    density_gradient: float
    point_masses: tuple[Lump, ...]
    grip_excess: float = 0.0
    unplaced: tuple[float, float] = (0.0, 0.0)


def beam_model(bat: Implement) -> BeamModel:
    """Reduce a bat to a line whose mass, balance and moment of inertia are the measured ones, if any.

    A measured mass scales the density of the bat's own material. A measured balance point and moment of inertia are
    those of the line, exactly. Where they differ from the drawing's by more than such measurements scatter
    (`BALANCE_SCATTER`, `MOI_SCATTER`), density also changes along the bat and at the grip, by as little as brings the
    difference down to that. Within the scatter they say nothing of where the mass lies: a gram at the knob lowers the
    first bending mode by nearly 1 %, and a tenth of an inch of balance is four grams.

    Parameters
    ----------
    bat : or any other implement.

    Of a calibrated implement the measured values count even where only an unusual density gives them, up to
    `CALIBRATED_BEYOND`; where no density gives them the nearest does, and what is left moves as they say.

    Raises
    ------
    InputError
        when no allowed density gives what was measured; the message has the nearest values that can be.

    >>> from sweetspot import beam_model, catalog, rigid_body
    >>> bat = catalog.bat("r161-ash")
    >>> round(rigid_body(beam_model(bat)).mass, 4), round(bat.mass, 4)  # kg: the line weighs what was measured
    (0.8788, 0.8788)
    """
    *changed, piece = bat.lineage()
    gradient = piece.density_gradient if isinstance(piece, Bat) else 0.0
    beam = _fitted(BeamModel(piece, 1.0, gradient, piece.lumps()))
    for copy in reversed(changed):  # each starts from the line of what it was made from
        beam = replace(beam, bat=copy, point_masses=copy.lumps())
        if copy.as_measured() is copy:
            beam = _fitted(beam)
    weights = [Lump(weight.position, weight.mass, roll_moi=weight.mass * weight.lateral**2) for weight in bat.added]
    return replace(beam, point_masses=(*beam.point_masses, *weights)) if weights else beam


def turning_as(beam: BeamModel, moi: float, *, axis: float) -> BeamModel:
    """Return a line of the same mass whose density changes along it so that it has a moment of inertia.

    Parameters
    ----------
    moi : kg m^2 about an axis across the bat.
    axis : m from the knob end.
    """

    def turning(gradient: float) -> float:
        mass, first, second = moments(_shifted(beam, gradient, 0.0))
        return second - 2 * axis * first + axis**2 * mass

    plain = turning(0.0)  # and by a straight law from there
    gradient = USUAL_GRADIENT * (moi - plain) / (turning(USUAL_GRADIENT) - plain)
    return _shifted(beam, gradient, 0.0)


def bat_of_beam(beam: BeamModel) -> Bat:
    """Return the bat of a line, or refuse any other implement where the question makes sense for a bat only."""
    if not isinstance(beam.bat, Bat):
        raise InputError(f"{beam.bat.name} is not a bat with a round barrel; this answer exists for bats only")
    return beam.bat


def section(beam: BeamModel, position: Array) -> CrossSection:
    """Return the section properties at positions in m (not exactly at a jump: there the inner side is taken)."""
    return beam.bat.section_at(position, density_scale(beam, position))


def density_scale(beam: BeamModel, position: Array) -> Array:
    """Return the bat's density at positions in m over its catalogue density: factor, gradient and grip of the fit.

    All walls of a hollow bat, sleeve and handle included, are scaled alike; fills are not.
    """
    part = position / beam.bat.length
    grip = beam.grip_excess * (1 - part) ** GRIP_POWER if beam.grip_excess else 0.0
    return beam.density_factor * (1 + beam.density_gradient * (2 * part - 1) + grip)


def moments(beam: BeamModel) -> tuple[float, float, float]:
    """Return mass (kg), first moment (kg m) and second moment (kg m^2) about the knob end; see `moments_with_roll`."""
    return moments_with_roll(beam)[:3]


@lru_cache(maxsize=64)  # fitting a line to what was measured asks for the same one again and again
def moments_with_roll(beam: BeamModel) -> tuple[float, float, float, float]:
    """Return mass (kg), first moment (kg m) and second moment (kg m^2) about the knob end, and about the bat's axis.

    The second moment includes the rotary inertia of the sections, the point masses, and what was measured beyond them;
    the last one what point masses have of their own.
    """
    places, weights = quadrature(beam.bat.breakpoints())
    at = section(beam, places)
    zeroth = float(np.sum(weights * at.mass))
    first = float(np.sum(weights * at.mass * places)) + beam.unplaced[0]
    second = float(np.sum(weights * (at.mass * places**2 + at.rotary_inertia))) + beam.unplaced[1]
    roll = float(np.sum(weights * at.roll_inertia))
    for weight in beam.point_masses:
        zeroth += weight.mass
        first += weight.mass * weight.position
        second += weight.mass * weight.position**2 + weight.moi
        roll += weight.roll_moi
    return zeroth, first, second, roll


def _fitted(plain: BeamModel) -> BeamModel:
    """Fit density factor, gradient and grip of a beam to what was measured on its implement, if anything was."""
    bat, limits = plain.bat, plain.bat.density_range
    if limits is None:
        return plain
    if bat.calibrated:
        usual, low, high = limits
        limits = DensityRange(usual, low / CALIBRATED_BEYOND, high * CALIBRATED_BEYOND)
    if bat.mass is None and bat.original is None:
        if bat.balance_point is not None or bat.moi is not None:
            raise InputError(f"{bat.name} has a measured balance point or moi but no mass; weigh it and give the mass")
        return plain
    beam = plain
    if bat.mass is not None:
        others = _mass_of_others(plain)
        heavier = (bat.mass - others) / (moments(plain)[0] - others)
        beam = replace(plain, density_factor=plain.density_factor * heavier)
        _check_density(beam, limits)
    if bat.balance_point is None and bat.moi is None:
        return beam
    corrected = _corrected(beam)
    if not _within(corrected, limits):
        raise InputError(_what_it_takes(beam, corrected, limits))
    return corrected


def _mass_of_others(beam: BeamModel) -> float:
    """Return the mass in kg of fills and point masses."""
    return moments(replace(beam, density_factor=0.0))[0]


def _corrected(drawn: BeamModel) -> BeamModel:
    """Return the line of a drawing and its mass with the balance point and moi that were measured."""
    bat = drawn.bat
    measured = np.array([bat.balance_point or np.nan, bat.moi or np.nan])
    is_measured = np.isfinite(measured)
    plain = _balance_and_moi(drawn)
    scatter = np.array([BALANCE_SCATTER, MOI_SCATTER * plain[1]])
    grip_mass = moments(replace(drawn, grip_excess=drawn.grip_excess + 1.0))[0] - moments(drawn)[0]
    kinds = (
        ((1.0, 0.0), USUAL_GRADIENT, (-GRADIENT_LIMIT, GRADIENT_LIMIT)),
        ((0.0, 1.0), USUAL_GRIP_MASS / grip_mass, (LIGHTEST_GRIP, HEAVIEST_GRIP / grip_mass)),
    )
    effects = [(_balance_and_moi(_shifted(drawn, *unit)) - plain)[is_measured] for unit, _, _ in kinds]
    corrections = [
        Correction(tuple(effect), usual, limits) for effect, (_, usual, limits) in zip(effects, kinds, strict=True)
    ]
    misses = (measured - plain)[is_measured]
    amounts = least_departure(corrections, misses=misses, scatter=scatter[is_measured])
    if amounts is None:
        amounts = nearest(corrections, misses=misses, scatter=scatter[is_measured])
        if not bat.calibrated:
            raise InputError(_what_can_be(drawn, _shifted(drawn, *amounts), measured, scatter))
    beam = _shifted(drawn, *amounts)
    return replace(beam, unplaced=_unplaced(beam, measured))


def _shifted(beam: BeamModel, gradient: float, grip: float) -> BeamModel:
    """Return a line of the same mass whose density changes along it; gradient and grip over the line's own density."""
    gradient, grip = beam.density_gradient + gradient, beam.grip_excess + grip  # beyond what the drawing has
    scaled_mass = moments(replace(beam, density_gradient=0.0, grip_excess=0.0))[0] - _mass_of_others(beam)
    added = moments(replace(beam, density_gradient=gradient, grip_excess=grip))[0] - moments(beam)[0]
    part = 1 - added / scaled_mass
    return replace(
        beam, density_factor=beam.density_factor * part, density_gradient=gradient / part, grip_excess=grip / part
    )


def _balance_and_moi(beam: BeamModel) -> Array:
    """Return balance point in m and moment of inertia in kg m^2 about the axis that its measurement uses."""
    mass, first, second = moments(beam)
    axis = beam.bat.moi_axis
    return np.array([first / mass, second - 2 * axis * first + axis**2 * mass])


def _unplaced(beam: BeamModel, measured: Array) -> tuple[float, float]:
    """Return first and second moment that were measured beyond the line's; I_cm stays where moi was not measured."""
    mass, first, second = moments(beam)
    balance, moi = measured
    wanted = first if np.isnan(balance) else mass * balance
    about = beam.bat.moi_axis
    moi_known = not np.isnan(moi)
    total = moi + 2 * about * wanted - about**2 * mass if moi_known else second + (wanted**2 - first**2) / mass
    return beam.unplaced[0] + float(wanted - first), beam.unplaced[1] + float(total - second)


def _check_density(beam: BeamModel, limits: DensityRange) -> None:
    """Refuse a mass that the outline has only at a density that its material cannot have."""
    if _within(beam, limits):
        return
    others, bat, (usual, low, high) = _mass_of_others(beam), beam.bat, limits
    mass = ((bat.mass or 0.0) - others) / (beam.density_factor * usual)
    raise InputError(
        f"{bat.name} weighs {format_mass(bat.mass or 0.0)}, which this outline has {_only_at(beam, limits)}, so that "
        f"the nearest it can weigh is {format_mass(others + mass * low)} to {format_mass(others + mass * high)}. Check "
        "the weight, the diameters and the material" + _hollow_advice(bat, usual)
    )


METALS_FROM = 2000.0
"""kg/m^3 above which no bat is solid: hickory has 806, aluminium 2820 [our choice]."""


def _hollow_advice(bat: Implement, density: float) -> str:
    """Return advice on a solid bat of metal; nothing for one of wood."""
    if density < METALS_FROM or getattr(bat, "shell", None) is not None:
        return ""
    return '. A metal bat is hollow: give its wall, [shell] wall = "2.5 mm", or begin with like = "college-alloy"'


def _within(beam: BeamModel, limits: DensityRange) -> bool:
    usual, low, high = limits
    slack = 1e-9 * usual
    return low - slack <= beam.density_factor * usual <= high + slack


def _only_at(beam: BeamModel, limits: DensityRange) -> str:
    """Return at which density alone the material would do, and which it can have."""
    usual, low, high = limits
    density = beam.density_factor * usual
    at = f"only at a density of {format_density(density)}" if density > 0 else "at no density"
    return f"{at}; {beam.bat.made_of} can be {format_density(low)} to {format_density(high)}"


def _what_it_takes(drawn: BeamModel, corrected: BeamModel, limits: DensityRange) -> str:
    """Return why a balance point and moi are refused that leave the material a density which it cannot have."""
    bat, measured = drawn.bat, np.array([drawn.bat.balance_point or np.nan, drawn.bat.moi or np.nan])
    part = corrected.density_factor / drawn.density_factor
    amounts = (
        corrected.density_gradient * part - drawn.density_gradient,
        corrected.grip_excess * part - drawn.grip_excess,
    )
    nearest, here, beyond = drawn, 0.0, 1.0  # parts of the way from the drawing to what was measured
    for _ in range(HALVINGS):
        part = (here + beyond) / 2
        tried = _shifted(drawn, part * amounts[0], part * amounts[1])
        if _within(tried, limits):
            nearest, here = tried, part
        else:
            beyond = part
    return (
        f"{bat.name}: at {format_mass(moments(drawn)[0])} the outline gives {_told(drawn, _balance_and_moi(drawn))}, "
        f"but {_told(drawn, measured)} was measured, which it has {_only_at(corrected, limits)}, so that the nearest "
        f"that can be is {_told(drawn, _balance_and_moi(nearest))}. Check the profile or the measurement"
    )


def _what_can_be(drawn: BeamModel, closest: BeamModel, measured: Array, scatter: Array) -> str:
    """Return why a balance point and moi are refused, and the nearest that are not."""
    bat = drawn.bat
    within = 0.98 * scatter  # so that the values still serve when they are rounded
    possible = _balance_and_moi(closest) + np.clip(measured - _balance_and_moi(closest), -within, within)

    return (
        f"{bat.name}: at {format_mass(moments(drawn)[0])} the outline gives {_told(drawn, _balance_and_moi(drawn))}, "
        f"but {_told(drawn, measured)} was measured. With density that changes by {100 * GRADIENT_LIMIT:.0f} % "
        f"towards the tip, and at the grip by {-100 * LIGHTEST_GRIP:.0f} % less or {format_mass(HEAVIEST_GRIP)} more, "
        f"the nearest that can be is {_told(drawn, possible)}. Check the profile or the measurement"
    )


def _told(beam: BeamModel, values: Array) -> str:
    """Return in words a balance point and moi, as far as they were measured."""
    bat = beam.bat
    moi = f"{values[1]:.4g} kg m^2 ({values[1] / OUNCE_INCH_SQUARED:.5g} oz in^2)"
    texts = (f"balance point {format_length(values[0])}", f"moi {moi} about {format_length(bat.moi_axis)}")
    measured = (bat.balance_point, bat.moi)
    return " and ".join(text for text, value in zip(texts, measured, strict=True) if value is not None)
