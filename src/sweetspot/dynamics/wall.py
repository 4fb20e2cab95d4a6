"""The wall of a hollow barrel as a thin shell: mass and stiffness per area at each place along the bat.

Coordinates are (axial, hoop, shear), z outwards. Two walls that are bonded act as one laminate through both; a
sleeve that is only pushed in, with or without a gap, shares the load with the outer wall but passes no shear to it.

How a flat ring inside a barrel resists being made oval: plane stress, one circumferential harmonic at a time.

In the ring u_r = W(r) cos(n theta), u_theta = V(r) sin(n theta):

    e_r = W', e_t = (W + n V) / r, g = V' - V / r - n W / r.

W and V are polynomials along the radius; what lies within is condensed onto the outer edge, so that a static push there
is answered exactly. Its mass moves along in the same shape.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from sweetspot.dynamics.beam import BeamModel, bat_of_beam, density_scale
from sweetspot.equipment.laminate import Plate, laminate_stiffness, sheet
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import WallPart
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array


@dataclass(frozen=True)
class WallSection:
    """A wall at an array of positions of shape S.

    Parameters
    ----------
    mass_per_area : kg/m^2 of the mean surface, shape S.
    mean_radius : m, middle of the wall; of two separate walls, the mean weighted with their thicknesses; shape S.
    thickness : m of material, gaps left out, shape S.
    stretching : A, N/m, shape S + (3, 3).
    coupling : B, N, shape S + (3, 3).
    bending : D, N m, shape S + (3, 3).
    """

    mass_per_area: Array
    mean_radius: Array
    thickness: Array
    stretching: Array
    coupling: Array
    bending: Array


def wall_stiffness(beam: BeamModel, position: Array) -> WallSection:
    """Return mass and stiffness of the wall of a hollow or drilled bat at positions in m.

    Mass per area times the circumference of the mean surface is the mass per length of the walls exactly. Where a
    drilled bat is solid the wall is as thick as the radius; what fills a hole is left out.

    Raises `InputError` when the bat is solid all over.
    """
    places = np.asarray(position, dtype=float)
    parts = _parts(beam, places)
    scale = density_scale(beam, places)
    thickness = sum((part.thickness for part in parts), np.zeros_like(places))
    middle = sum((part.thickness * part.middle for part in parts), np.zeros_like(places)) / thickness
    shell = bat_of_beam(beam).shell
    bonded = shell is not None and shell.bonded
    plate = _nothing(places)
    ring = np.zeros_like(places)  # mass per length over 2 pi
    for part in parts:
        plate_of_part = _plate(part)
        plate = plate + (plate_of_part.seen_from(part.middle - middle) if bonded else plate_of_part)
        ring = ring + part.density * scale * part.thickness * part.middle
    return WallSection(ring / middle, middle, thickness, plate.stretching, plate.coupling, plate.bending)


def _parts(beam: BeamModel, position: Array) -> list[WallPart]:
    bat = bat_of_beam(beam)
    outer = bat.diameter_at(position) / 2
    if bat.shell is not None:
        return bat.shell.parts(position, outer, bat.material)
    if not bat.bores:
        raise InputError(f"{bat.name} is solid and has no wall; give a bat with a shell or a bore")
    void = np.zeros_like(position)
    for bore in bat.bores:
        hollow = (position > bat.length - bore.depth) & (position <= bat.length - bore.plug)
        void = np.where(hollow, np.maximum(void, bore.diameter / 2), void)
    return [WallPart(bat.material, None, outer, outer - void)]


def _plate(part: WallPart) -> Plate:
    if part.laminate is not None:
        return laminate_stiffness(part.laminate, part.thickness)
    return sheet(part.material, part.thickness)


def _nothing(position: Array) -> Plate:
    zero = np.zeros((*position.shape, 3, 3))
    return Plate(zero, zero, zero)


DEGREE = 9


def ring_at_edge(material: Material, *, harmonic: int, outer: float, hole: float) -> tuple[Array, Array]:
    """Return stiffness (N/m^2) and mass (kg/m) per metre of the ring's width, for (W, V) at its outer edge: (2, 2).

    Energy per width is d^T K d / 2 with d = (W, V), all around the ring.

    Parameters
    ----------
    harmonic : n >= 2.
    outer, hole : radii in m; hole 0: a solid disc.
    """
    nodes, weights = legendre.leggauss(DEGREE + 3)
    half = (outer - hole) / 2
    radius = hole + half * (nodes + 1)
    # integrated Legendre polynomials: all but the last two vanish at both ends
    values, slopes = _shapes(nodes)
    slopes = slopes / half
    if hole == 0:  # nothing moves on the axis
        values, slopes = values[1:], slopes[1:]
    zero = np.zeros_like(values)
    strain = np.array(
        [
            np.concatenate([slopes, zero]),
            np.concatenate([values, harmonic * values]) / radius,
            np.concatenate([-harmonic * values / radius, slopes - values / radius]),
        ]
    )
    poisson = material.poisson
    modulus = material.longitudinal_modulus / (1 - poisson**2)
    law = modulus * np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]])
    area = np.pi * weights * half * radius
    stiffness = np.einsum("aiq,ab,bjq,q->ij", strain, law, strain, area)
    half_mass = np.einsum("iq,jq,q->ij", values, values, material.density * area)
    inertia = np.block([[half_mass, np.zeros_like(half_mass)], [np.zeros_like(half_mass), half_mass]])
    edge = np.array([len(values) - 1, 2 * len(values) - 1])
    within = np.setdiff1d(np.arange(2 * len(values)), edge)
    motion = np.zeros((2 * len(values), 2))
    motion[edge] = np.eye(2)
    motion[within] = -np.linalg.solve(stiffness[np.ix_(within, within)], stiffness[np.ix_(within, edge)])
    return np.asarray(motion.T @ stiffness @ motion), np.asarray(motion.T @ inertia @ motion)


def _shapes(places: Array) -> tuple[Array, Array]:
    """Return functions on -1 to 1 and their slopes: 1 at the left end, bubbles, 1 at the right end."""
    values, slopes = [(1 - places) / 2], [np.full_like(places, -0.5)]
    for degree in range(2, DEGREE + 1):
        bubble = legendre.Legendre.basis(degree) - legendre.Legendre.basis(degree - 2)
        values.append(bubble(places))
        slopes.append(bubble.deriv()(places))
    return np.array([*values, (1 + places) / 2]), np.array([*slopes, np.full_like(places, 0.5)])
