"""Local compliance of a solid round barrel under the ball, beyond its beam's, from a three-dimensional elastic body.

A beam's section keeps its shape. In truth the wood under the ball is dented, the section is squeezed, and the load
spreads into the barrel over a length. A long round body of radius R, isotropic across its axis, is solved exactly along
the axis and around it (one Fourier harmonic cos(n theta) cos(k z) at a time) and by finite elements along the radius.
With the pressure of a Hertz patch of radius a, whose transform is P = 3 (sin s - s cos s) / s^3 at s = a hypot(n/R, k),
the mean displacement under the patch per newton is

    c = (1/pi) int_0^inf (sum_n h_n(k) - P(0, k)^2 (1/(EI k^4) + 1/(S k^2))) dk - K,

where h_n is the work of harmonic n, the subtracted term is the same body as a beam, S its shear stiffness for slow
waves, and K the excess of a beam's compliance at one point, as its modes have it, over that under the patch.

All wood is taken as alike across the grain. What fills a hole is left out: it is a hundred times softer than wood.
"""

from __future__ import annotations

from functools import cache, lru_cache

import numpy as np
from numpy.polynomial.legendre import leggauss

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.patch import ByPatch, PatchLaw, transform
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.material import Material
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.piecewise import cubic_spline

ACROSS_POISSON = 0.4
"""Poisson's ratio of wood across its grain; 0.3 to 0.6 in its two directions: 6 % of the dent [recalled]."""
ACROSS_RATIO = 0.085
"""Modulus across the grain over that along it, for a wood that states none: 0.05 to 0.12 [recalled]."""
HARMONICS = 13
SLOWEST, FASTEST = 0.12, 14.0
"""k R: below it the body is a beam; above it a patch of half the barrel's radius or more no longer pushes."""
PATCHES = np.linspace(0.45, 1.25, 9)
"""a / R between which the dent is interpolated; smaller and larger patches are taken as the nearest of them."""
ELEMENTS, DEGREE = 5, 4
POWERS = (0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)
"""Of n and k that parts of the stiffness go with."""
FINE = leggauss(64)
PLACES = 81
MOTIONS = 3
"""Unknowns of a node: U along the axis, V around it and W outwards."""
SIDE_BY_SIDE = 8
"""Waves worked on at once."""
KEPT = 8192
"""Sections whose dent is kept, nine numbers each: a hundred drilled bats."""


def solid_bat_compliance(beam: BeamModel, *, law: PatchLaw) -> ByPatch:
    """Return the dent of a solid or drilled round bat in m/N by position in m and closing speed.

    Parameters
    ----------
    beam : a bat without a shell.
    law : how the ball's patch goes with the closing speed.
    """
    places = np.linspace(0.0, beam.bat.length, PLACES)
    tables = _along(beam, places, law.radii)
    return ByPatch(law, cubic_spline(places, tables))


def blade_compliance(beam: BeamModel, *, law: PatchLaw) -> ByPatch:
    """Return the dent of a flat blade of solid wood in m/N by position and closing speed: that of a round body as wide.

    Under a patch that is less than half as wide as the blade its own wood deflects most, whatever stands behind it.
    Taking a round body twice as thick or half as thick changes it by a third.

    Parameters
    ----------
    beam : an implement with a material and a width.
    law : how the ball's patch goes with the closing speed.
    """
    blade = beam.bat
    assert isinstance(blade, CricketBat)
    places = np.linspace(0.0, blade.length, PLACES)
    radius = np.asarray(blade.width_at(places)) / 2
    tables = np.stack([round_compliance(blade.material, a / radius, void=0.0) / radius for a in law.radii], axis=1)
    return ByPatch(law, cubic_spline(places, tables))


def _along(beam: BeamModel, places: Array, patches: Array) -> Array:
    """Return the dent in m/N at places under patches of some radii, m; shape (places, radii)."""
    bat = beam.bat
    assert isinstance(bat, Bat) and bat.shell is None
    radius = np.asarray(bat.diameter_at(places))[:, None] / 2
    compliance = round_compliance(bat.material, patches / radius, void=0.0) / radius
    for bore in bat.bores:
        within = ((places > bat.length - bore.depth) & (places <= bat.length - bore.plug))[:, None]
        void = round(bore.diameter / 2 / float(radius[within].max(initial=bore.diameter)), 2)
        hollow = round_compliance(bat.material, patches / radius, void=void) / radius
        compliance = np.where(within, np.maximum(compliance, hollow), compliance)
    return compliance


def across_grain(material: Material) -> float:
    """Return Young's modulus across the grain or the fibers in Pa, as far as it is known."""
    wood = ACROSS_RATIO if material.family == "wood" else 1.0
    return material.transverse_modulus or wood * material.longitudinal_modulus


def round_compliance(material: Material, patch_ratio: Array, *, void: float) -> Array:
    """Return c R in m^2/N of a long round body at ratios a / R of the patch's radius to its own.

    Parameters
    ----------
    void : radius of a hole along its axis over its own, 0 to 0.9.
    """
    along, shear = material.longitudinal_modulus, material.shear
    poisson = material.poisson
    wood, across = material.family == "wood", across_grain(material)
    across_poisson = ACROSS_POISSON if wood else poisson
    table = _table(along, across, shear, poisson, across_poisson, void)
    return np.asarray(cubic_spline(PATCHES, table)(np.clip(patch_ratio, PATCHES[0], PATCHES[-1])))


@lru_cache(maxsize=KEPT)
def _table(along: float, across: float, shear: float, poisson: float, across_poisson: float, void: float) -> Array:
    """Return c of a body of radius 1 for every one of `PATCHES`; moduli in Pa."""
    stiffness = _stiffness(along, across, shear, poisson, across_poisson)
    nodes, weights = leggauss(8)
    edges = np.array([SLOWEST, 0.5, 1.0, 2.0, 3.5, 5.5, 8.0, FASTEST])
    half, middle = np.diff(edges) / 2, (edges[1:] + edges[:-1]) / 2
    waves = np.concatenate([[SLOWEST], (middle[:, None] + half[:, None] * nodes).ravel()])
    weights = np.concatenate([[SLOWEST], (half[:, None] * weights).ravel()])  # even and smooth: constant below SLOWEST
    give = _surface_compliance(stiffness, waves, void)
    bending = 4 / (np.pi * along * (1 - void**4))
    point = _work(give, waves, 0.0)[1]
    shearing = float((point[0] - bending / SLOWEST**4) * SLOWEST**2)
    beam = bending / waves**4 + shearing / waves**2
    totals = []
    for patch in PATCHES:
        work = _work(give, waves, patch).sum(axis=0) - transform(patch * waves) ** 2 * beam
        totals.append(work @ weights / np.pi - blunting(patch, bending=bending, shearing=shearing))
    return np.array(totals)


def _stiffness(along: float, across: float, shear: float, poisson: float, across_poisson: float) -> Array:
    """Return the stiffness matrix for strains (r, theta, z, r-theta, r-z, theta-z) in Pa."""
    give = np.zeros((6, 6))
    give[:3, :3] = np.array(
        [
            [1 / across, -across_poisson / across, -poisson / along],
            [-across_poisson / across, 1 / across, -poisson / along],
            [-poisson / along, -poisson / along, 1 / along],
        ]
    )
    give[3, 3] = 2 * (1 + across_poisson) / across
    give[4, 4] = give[5, 5] = 1 / shear
    return np.asarray(np.linalg.inv(give), dtype=np.float64)


def _surface_compliance(stiffness: Array, waves: Array, void: float) -> Array:
    """Return outward by outward, either by the other, and sideways by sideways traction, shape (3, harmonics, waves).

    The motion is u_r = W cos(n theta) cos(k z), u_theta = V sin(n theta) cos(k z), u_z = U cos(n theta) sin(k z).
    """
    numbers = np.arange(float(HARMONICS))[:, None]
    factors = np.stack([numbers**i * waves**j for i, j in POWERS], axis=-1).reshape(-1, len(POWERS))
    compliance = np.empty((3, HARMONICS, len(waves)))
    _eliminated_to_surface(_radial_parts(stiffness, void), factors, compliance.reshape(3, -1))
    compliance[1:, 0] = 0.0  # harmonic 0 turns the body about its axis: no ball does that
    return compliance


def _radial_parts(stiffness: Array, void: float) -> Array:
    """Return the parts of elements' stiffness that go with n^i k^j of `POWERS`, shape (powers, elements, n, n).

    Unknowns are U, V and W of every node, from the axis outwards.
    """
    fine = void + (1 - void) * (1 - (1 - np.linspace(0, 1, ELEMENTS + 1)) ** 2)
    gauss, weights = leggauss(DEGREE + 3)
    nodes = -np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
    powers = np.linalg.inv(np.vander(nodes, increasing=True))
    values = (np.vander(gauss, DEGREE + 1, increasing=True) @ powers).T
    slopes = (np.vander(gauss, DEGREE, increasing=True) * np.arange(1, DEGREE + 1) @ powers[1:]).T
    half = np.diff(fine)[:, None, None] / 2
    radius = fine[:-1, None, None] + half * (gauss + 1)
    slope, over = slopes / half, values / radius
    strains = np.zeros((3, ELEMENTS, 6, 3 * (DEGREE + 1), len(gauss)))  # without n or k, with n, with k
    u, v, w = (slice(motion, None, MOTIONS) for motion in range(MOTIONS))
    strains[0, :, 0, w], strains[0, :, 1, w] = slope, over
    strains[0, :, 3, v], strains[0, :, 4, u] = slope - over, slope
    strains[1, :, 1, v], strains[1, :, 3, w], strains[1, :, 5, u] = over, -over, -over
    strains[2, :, 2, u], strains[2, :, 4, w], strains[2, :, 5, v] = values, -values, -values
    area = weights * half * radius
    stress = np.einsum("ab,kebug->keaug", stiffness, strains) * area[:, :, None]
    between = np.einsum("keaug,meavg->kmeuv", strains, stress)
    return np.stack(
        [
            between[0, 0],
            between[0, 1] + between[1, 0],
            between[0, 2] + between[2, 0],
            between[1, 1],
            between[1, 2] + between[2, 1],
            between[2, 2],
        ]
    )


def _work(give: Array, waves: Array, patch: float) -> Array:
    """Return h_n(k) of a push by the ball, along its path all over the patch, shape (harmonics, waves)."""
    number = np.arange(-1, HARMONICS + 1)[:, None]
    pressure = transform(patch * np.hypot(number, waves)) / (2 * np.pi)
    before, after = pressure[:-2], pressure[2:]
    outward, sideways = before + after, after - before
    outward[0] /= 2
    work = np.pi * (outward**2 * give[0] + 2 * outward * sideways * give[1] + sideways**2 * give[2])
    work[0] *= 2
    return np.asarray(work)


def blunting(patch: Array | float, *, bending: Array | float, shearing: Array | float) -> Array:
    """Return the deficit of a beam's compliance under a patch from that at one point, m/N.

    Beside the point its deflection is less by S |x| / 2 - B |x|^3 / 12 (shear and bending compliances S and B); this is
    the mean over pairs of places with weights 1 - (x/a)^2.
    """
    once, cubed = _mean_distances()
    return np.asarray(shearing * patch * once / 2 - bending * np.power(patch, 3) * cubed / 12)


@cache
def _mean_distances() -> tuple[float, float]:
    """Return the means of |x - y| and of its cube over pairs of places in a patch of radius 1."""
    nodes, weights = FINE
    weights = weights * (1 - nodes**2)
    apart = np.abs(nodes[:, None] - nodes)
    once, cubed = (float(weights @ apart**power @ weights / weights.sum() ** 2) for power in (1, 3))
    return once, cubed


@compiled(nogil=True, fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _eliminated_to_surface(parts: Array, factors: Array, compliance: Array) -> None:
    """Fill in how far the surface moves per unit of traction.

    From the axis outwards every element's motion is eliminated, so that what stays is the stiffness of the surface.

    Parameters
    ----------
    parts : whose sum is the stiffness of every element, shape (parts, elements, n, n); an element's last node is the
        next one's first.
    factors : of each part, shape (waves, parts).
    compliance : W by a traction outwards, either by the other's, V by one around, shape (3, waves); filled.
    """
    size = parts.shape[2]
    inner = size - MOTIONS
    block = np.zeros((size, size, SIDE_BY_SIDE))
    for start in range(0, len(factors), SIDE_BY_SIDE):
        count = min(SIDE_BY_SIDE, len(factors) - start)
        for e in range(parts.shape[1]):
            for i in range(size):
                for j in range(i + 1):
                    for b in range(count):
                        total = block[inner + i, inner + j, b] if e > 0 and i < MOTIONS else 0.0
                        for p in range(len(parts)):
                            total += parts[p, e, i, j] * factors[start + b, p]
                        block[i, j, b] = total
            for k in range(inner):
                _eliminated(block, k)
        _eliminated(block, inner)
        for b in range(count):
            around, outwards = block[inner + 1, inner + 1, b], block[inner + 2, inner + 2, b]
            both = block[inner + 2, inner + 1, b]
            whole = around * outwards - both * both
            compliance[0, start + b] = around / whole
            compliance[1, start + b] = -both / whole
            compliance[2, start + b] = outwards / whole


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _eliminated(block: Array, k: int) -> None:
    """Eliminate one unknown of symmetric matrices side by side; what is above their diagonals is room to work in."""
    for i in range(k + 1, len(block)):
        for b in range(SIDE_BY_SIDE):
            block[k, i, b] = block[i, k, b] / block[k, k, b]
        for j in range(k + 1, i + 1):
            for b in range(SIDE_BY_SIDE):
                block[i, j, b] -= block[k, i, b] * block[j, k, b]
