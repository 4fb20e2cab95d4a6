"""How a hollow barrel gives way as a breathing and as a shifted ring: harmonics 0 and 1 of a long tube.

Both die out within a centimetre or two, so the barrel counts as a long tube of the local wall: one wave along it,
cos(k x), at a time, Sanders' strains, integrated over k. Of harmonic 1 the tube as a beam is taken away, which the
bending modes hold: with the pressure's transform P and the tube's bending and shear compliances B and S for slow waves

    c = (1/pi) int_0^inf (h_0(k) + h_1(k) - P(0, k)^2 (B / k^4 + S / k^2)) dk - K,

K being what a beam gives way less under the patch than under a push at one point, as for a solid bat (`dent`).
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.legendre import leggauss

from sweetspot.dynamics.local_compliance import blunting
from sweetspot.dynamics.patch import transform
from sweetspot.dynamics.shell_elements import EVEN_PART
from sweetspot.dynamics.wall import WallSection
from sweetspot.numerics.arrays import Array

SLOWEST = 0.12
"""k R below which the tube is a beam."""
EDGES = np.concatenate([np.linspace(SLOWEST, 1.0, 6), np.linspace(1.5, 14.0, 16)])
"""k R between which the integral is taken piece by piece; beyond them the patch no longer pushes."""
GAUSS = leggauss(8)
SLOWER = 0.02
"""k R at which the tube's bending compliance is read off."""


def local_compliance(wall: WallSection, *, outer: Array, radii: Array) -> Array:
    """Return c in m/N at the places of a wall under patches, shape (places, radii).

    Parameters
    ----------
    outer : radius of the outside there, m, shape (places,).
    radii : of the ball's contact, m, > 0, shape (radii,).
    """
    law = np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART
    nodes, weights = GAUSS
    half, centre = np.diff(EDGES) / 2, (EDGES[1:] + EDGES[:-1]) / 2
    middle = wall.mean_radius[:, None]
    waves = np.concatenate([[SLOWEST], (centre[:, None] + half[:, None] * nodes).ravel()]) / middle
    weights = np.concatenate([[SLOWEST], (half[:, None] * weights).ravel()]) / middle  # constant below the slowest
    bending, shearing = _beam(law, middle, outer[:, None])
    tube = sum(work(law, waves, middle, outer[:, None], radii) for work in (_breathing, _shifting))
    beam = transform(radii[:, None, None] * waves) ** 2 * (bending / waves**4 + shearing / waves**2)
    blunt = blunting(radii, bending=bending, shearing=shearing)
    return np.asarray(np.sum((tube - beam) * weights, axis=-1).T / np.pi - blunt)


def _beam(law: Array, middle: Array, outer: Array) -> tuple[Array, Array]:
    """Return B in 1/(N m^2) and S in 1/N of the tube under slow waves, pushed at a point; shapes (places, 1)."""
    slow = np.array([SLOWER, SLOWEST]) / middle
    give = _shifting(law, slow, middle, outer, np.zeros(1))[0]
    both = np.linalg.solve(np.stack([slow**-4.0, slow**-2.0], axis=-1), give[..., None])
    return both[:, 0], both[:, 1]


def _breathing(law: Array, waves: Array, middle: Array, outer: Array, radii: Array) -> Array:
    """Return the work of harmonic 0 under pressures of 1 N along the ball's path, m/N times 1/m, by wave.

    Parameters
    ----------
    law : stiffnesses of the wall, shape (places, 6, 6).
    waves : k in 1/m, shape (places, waves).
    middle, outer : radii of the wall's middle and of the outside, m, shape (places, 1).
    radii : of the patches, m, shape (radii,); the answer has shape (radii, places, waves).
    """
    strain = np.zeros((len(waves), 6, 2, waves.shape[1]))  # of (U sin kx, W cos kx); there is no twist
    strain[:, 0, 0] = waves
    strain[:, 1, 1], strain[:, 3, 1] = 1 / middle, waves**2
    outwards = transform(radii[:, None, None] * np.hypot(1 / outer, waves))
    return _work(2 * law, strain, middle, np.stack([np.zeros_like(outwards), outwards]))


def _shifting(law: Array, waves: Array, middle: Array, outer: Array, radii: Array) -> Array:
    """Return the work of harmonic 1; see `_breathing`.

    With R the middle's radius the unknowns are U + k R V, V + W and (k R)^2 W instead of U sin kx, V cos kx and
    W cos kx: a section that is only shifted, which costs nothing, is then one of them alone, and rounding does not
    drown it.
    """
    turn = waves * middle
    strain = np.zeros((len(waves), 6, 3, waves.shape[1]))
    strain[:, 0, 0], strain[:, 0, 1], strain[:, 0, 2] = waves, -waves * turn, 1 / middle
    strain[:, 1, 1], strain[:, 2, 0] = 1 / middle, -1 / middle
    strain[:, 3, 2], strain[:, 4, 1] = 1 / middle**2, 1 / middle**2
    strain[:, 5, 0], strain[:, 5, 1] = 1 / (2 * middle**2), -2 * waves / middle
    before, after = (transform(radii[:, None, None] * np.hypot(m / outer, waves)) for m in (0, 2))
    around = (after - before) / 2 * outer / middle
    return _work(law, strain, middle, np.stack([np.zeros_like(before), around, before / turn**2]))


def _work(law: Array, strain: Array, middle: Array, push: Array) -> Array:
    """Return p^T K^-1 p of a ring of wall, one unknown after the other eliminated.

    Parameters
    ----------
    strain : by unknown, shape (places, 6, unknowns, waves).
    push : by unknown, shape (unknowns, radii, places, waves).
    """
    stress = (law @ strain.reshape(*law.shape[:2], -1)).reshape(strain.shape)
    stiffness = np.einsum("piuw,pivw->uvpw", strain, stress) * np.pi * middle
    work = np.zeros(push.shape[1:])
    while len(push):
        share = stiffness[1:, 0] / stiffness[0, 0]
        work += push[0] ** 2 / stiffness[0, 0]
        push = push[1:] - share[:, None] * push[0]
        stiffness = stiffness[1:, 1:] - share[:, None] * stiffness[0, 1:]
    return work
