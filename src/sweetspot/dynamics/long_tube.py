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

from sweetspot.dynamics.dent import blunting
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


def local_compliance(wall: WallSection, *, outer: Array, patch: float) -> Array:
    """Return c in m/N at the places of a wall, shape (places,).

    Parameters
    ----------
    outer : radius of the outside there, m, shape (places,).
    patch : radius in m of the ball's contact, > 0.
    """
    law = np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART
    return np.array([
        _one(stiffness, middle, outside, patch)
        for stiffness, middle, outside in zip(law, wall.mean_radius, outer, strict=True)
    ])  # fmt: skip


def _one(law: Array, middle: float, outer: float, patch: float) -> float:
    nodes, weights = GAUSS
    half, centre = np.diff(EDGES) / 2, (EDGES[1:] + EDGES[:-1]) / 2
    waves = np.concatenate([[SLOWEST], (centre[:, None] + half[:, None] * nodes).ravel()]) / middle
    weights = np.concatenate([[SLOWEST], (half[:, None] * weights).ravel()]) / middle  # constant below the slowest
    breathing = _work(0, law, waves, middle, outer, patch)
    shifting = _work(1, law, waves, middle, outer, patch)
    bending, shearing = _beam(law, middle, outer)
    beam = transform(patch * waves) ** 2 * (bending / waves**4 + shearing / waves**2)
    blunt = blunting(patch, bending=bending, shearing=shearing)
    return float((breathing + shifting - beam) @ weights / np.pi - blunt)


def _beam(law: Array, middle: float, outer: float) -> tuple[float, float]:
    """Return B in 1/(N m^2) and S in 1/N of the tube under slow waves, pushed at a point."""
    slow = np.array([SLOWER, SLOWEST]) / middle
    give = _work(1, law, slow, middle, outer, 0.0)
    bending, shearing = np.linalg.solve(np.stack([slow**-4.0, slow**-2.0], axis=1), give)
    return float(bending), float(shearing)


def _work(n: int, law: Array, waves: Array, middle: float, outer: float, patch: float) -> Array:
    """Return the work of harmonic ``n`` under the pressure of 1 N along the ball's path, m/N times 1/m, by wave."""
    strain = np.zeros((len(waves), 6, 3))  # of (U sin kx, V cos kx, W cos kx)
    strain[:, 0, 0] = waves
    strain[:, 1, 1], strain[:, 1, 2] = n / middle, 1 / middle
    strain[:, 2, 0], strain[:, 2, 1] = -n / middle, -waves
    strain[:, 3, 2] = waves**2
    strain[:, 4, 1], strain[:, 4, 2] = n / middle**2, n**2 / middle**2
    strain[:, 5, 0], strain[:, 5, 1], strain[:, 5, 2] = (
        n / (2 * middle**2),
        -1.5 * waves / middle,
        -2 * n * waves / middle,
    )
    stiffness = np.einsum("kai,ab,kbj->kij", strain, law, strain) * np.pi * middle
    before, after = (transform(patch * np.hypot(m / outer, waves)) for m in (n - 1, n + 1))
    outwards, around, lift = (before + after) / 2, (after - before) / 2, (outer - middle) / middle
    push = np.stack([np.zeros_like(waves), around * (1 + lift), outwards + around * n * lift], axis=1)
    if n == 0:  # no twist
        stiffness, push = 2 * stiffness[:, [0, 2]][:, :, [0, 2]], push[:, [0, 2]]
    return np.asarray(np.einsum("ki,ki->k", push, np.linalg.solve(stiffness, push[..., None])[..., 0]))
