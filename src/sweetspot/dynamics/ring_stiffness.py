"""How a flat ring inside a barrel resists being made oval: plane stress, one circumferential harmonic at a time.

In the ring u_r = W(r) cos(n theta), u_theta = V(r) sin(n theta):

    e_r = W', e_t = (W + n V) / r, g = V' - V / r - n W / r.

W and V are polynomials along the radius; what lies within is condensed onto the outer edge, so that a static push there
is answered exactly. Its mass moves along in the same shape.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre

from sweetspot.equipment.material import Material
from sweetspot.numerics.arrays import Array

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
    strain = np.array([
        np.concatenate([slopes, zero]),
        np.concatenate([values, harmonic * values]) / radius,
        np.concatenate([-harmonic * values / radius, slopes - values / radius]),
    ])  # fmt: skip
    poisson = material.poisson
    modulus = material.longitudinal_modulus / (1 - poisson**2)
    law = modulus * np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]])
    area = np.pi * weights * half * radius
    stiffness = np.einsum("aiq,ab,bjq,q->ij", strain, law, strain, area)
    one = np.einsum("iq,jq,q->ij", values, values, material.density * area)
    inertia = np.block([[one, np.zeros_like(one)], [np.zeros_like(one), one]])
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
