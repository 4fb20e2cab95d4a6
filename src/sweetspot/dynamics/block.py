"""A block of material that a ball falls on, as motions for the same collision code that hits bats.

A pressed face deflects in three manners, and each becomes modes:

* it is dented: a cone of material under the patch is compressed, with its own thickness modes;
* it bends: plate modes of a block that is clamped at its edges or free;
* it moves away: the translation of a free block.

The ball hits the middle of the face, so only motions that are even about both middle lines exist here.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.polynomial import legendre
from pydantic import model_validator

from sweetspot.dynamics.modes import Family, Modes
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.equipment.base import Positive, Validated
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import FLAT_SHEAR
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import eigenpairs
from sweetspot.numerics.piecewise import Piecewise

Support = Literal["clamped", "floor", "free"]

THICKNESS_RANGE, SIDE_RANGE = (0.0005, 2.0), (0.02, 10.0)
FLOOR_MODULUS, FLOOR_POISSON = 30e9, 0.2
"""Pa; a concrete floor (assumed: 25 to 40 GPa are usual [recalled])."""
ROLLING_SHEAR = 0.32
"""Shear modulus across the grain over the one along it: 79 666 / 249 797 psi [umass2022, appendix A]."""
STIFF_FREQUENCY = 30e3
"""Hz. Anything faster follows the force without delay; it is kept as a spring: this frequency, its own compliance."""
FUNCTIONS = 8
"""Polynomials per direction of the plate; two more change the rebound of a 3 mm plate by less than 0.3 %."""
PLATE_MODES, THICKNESS_MODES = 24, 4


class Block(Validated):
    """A rectangular block, hit in the middle of its face.

    Parameters
    ----------
    material : wood lies with its grain along ``length`` and is hit across the grain.
    thickness : m, 0.0005 to 2.
    length, width : m, 0.02 to 10.
    support : "clamped" (held all round its edges, back free), "floor" (lies flat on a floor) or "free".
    floor_modulus : Pa, of the half-space of concrete under the block; None: a rigid floor.
    """

    material: Material
    thickness: float
    length: float = 0.2
    width: float = 0.2
    support: Support = "floor"
    floor_modulus: Positive | None = FLOOR_MODULUS

    @model_validator(mode="after")
    def _has_a_size(self) -> Block:
        for name, value, (low, high) in (
            ("thickness", self.thickness, THICKNESS_RANGE),
            ("length", self.length, SIDE_RANGE),
            ("width", self.width, SIDE_RANGE),
        ):
            if not low <= value <= high:
                raise ValueError(f"{name} is {1e3 * value:g} mm; allowed is {1e3 * low:g} to {1e3 * high:g} mm")
        return self

    @property
    def mass(self) -> float:
        """Mass in kg."""
        return self.material.density * self.thickness * self.length * self.width


@dataclass(frozen=True)
class SurfaceModes:
    """Even motions of a face at the patch: frequency (Hz, shape (n,)) and face shape (1/sqrt(kg), shape (n,))."""

    frequency: Array
    shape: Array

    @property
    def compliance(self) -> float:
        """Static compliance in m/N of all motions that have a frequency."""
        moving = self.frequency > 0
        return float(np.sum((self.shape[moving] / (2 * np.pi * self.frequency[moving])) ** 2))


def expected_patch(ball: Ball, speed: float) -> float:
    """Return the radius in m of the contact patch with which a linear block stores the energy that a real one does.

    a = sqrt(R U) (Hertz) at the compression U that takes the whole energy of the ball at ``speed`` (m/s) on a rigid
    wall. The patch grows with the compression, so the dent is no linear spring. For F = k u^n it holds the energy
    F w (n - 1/2) / (2 n - 1/2), w the dent, and the patch is enlarged until the linear F w / 2 is the same.
    """
    exponent = ball.exponent
    return math.sqrt(ball.radius * peak_compression(ball, speed)) * (2 * exponent - 0.5) / (2 * exponent - 1)


def block_modes(block: Block, *, patch: float) -> Modes:
    """Return every motion of a block that a ball in the middle of its face excites; position 0 is that middle.

    Raises `InputError` when the patch is wider than the face.

    Parameters
    ----------
    patch : m, radius over which the ball presses, from `expected_patch`.

    Notes
    -----
    Plate motions are those of the middle plane, so on a clamped or free block the dent goes half the thickness
    deep; on a floor all of it. Damping: the material's ratio for every mode, which is low for crushed wood.
    """
    if 2 * patch >= min(block.length, block.width):
        raise InputError(
            f"the ball presses on a circle of {2e3 * patch:.3g} mm, wider than the face of "
            f"{1e3 * block.length:.4g} mm x {1e3 * block.width:.4g} mm; use a larger block or a slower ball"
        )
    on_floor = block.support == "floor"
    parts = [local_modes(block, patch=patch, depth=block.thickness if on_floor else block.thickness / 2)]
    if not on_floor:
        parts.append(plate(block, patch=patch))
    if block.support == "free":
        parts.insert(0, SurfaceModes(np.zeros(1), np.array([1 / math.sqrt(block.mass)])))
    frequency = np.concatenate([part.frequency for part in parts])
    shape = np.concatenate([part.shape for part in parts])
    return modes_of_surface(SurfaceModes(frequency, shape), damping_ratio=block.material.damping_ratio)


def modes_of_surface(surface: SurfaceModes, *, damping_ratio: float = 0.0) -> Modes:
    """Return motions as the list that a collision sees; those without frequency are translations."""
    count = len(surface.frequency)
    rigid = surface.frequency == 0
    families: list[Family] = ["rigid" if still else "bending" for still in rigid]
    numbers = np.cumsum(~rigid) * ~rigid
    return Modes(
        families=tuple(families),
        harmonics=tuple(int(number) for number in numbers),
        frequency=surface.frequency,
        damping_rate=4 * np.pi * damping_ratio * surface.frequency,
        shapes=Piecewise(surface.shape.reshape(1, 1, count), np.array([0.0, 1.0])),
        rigid_part=np.vstack([rigid.astype(float), np.zeros(count)]),
        dashpots=np.zeros((0, count)),
    )


def spring(compliance: float, *, frequency: float = STIFF_FREQUENCY) -> SurfaceModes:
    """Return a spring (m/N) as one mode so fast that its mass does not matter: s^2 / omega^2 is the compliance.

    >>> round(1 / spring(1e-8).compliance)  # N/m
    100000000
    """
    return SurfaceModes(np.array([frequency]), np.array([2 * np.pi * frequency * math.sqrt(compliance)]))


def local_modes(block: Block, *, patch: float, depth: float) -> SurfaceModes:
    """Return the modes of the material under the patch, down to ``depth`` (m).

    The load spreads in a cone of area A(z) = pi a^2 (1 + z / z0)^2, no wider than the block, with
    z0 = pi a (1 - nu^2) / 2: then a deep block has Boussinesq's 2 E a / (1 - nu^2) for a stiff round patch, a thin
    one on a rigid floor E pi a^2 / h, a column E A / h. Displacements are polynomials in t, the part of the
    compliance above; the first alone gives the exact static dent.
    """
    material = block.material
    modulus = material.across
    poisson = material.poisson
    apex = math.pi * patch * (1 - poisson**2) / 2
    area, section = math.pi * patch**2, block.length * block.width
    reach = apex * (math.sqrt(section / area) - 1)  # depth at which the cone fills the block
    cone = min(depth, reach)
    in_cone = apex / area * cone / (apex + cone)  # integral of dz / A
    below = max(0.0, depth - reach) / section
    total = in_cone + below
    nodes, weights = legendre.leggauss(12)
    split = in_cone / total
    pieces = [(0.0, split)] + ([(split, 1.0)] if below else [])
    place = np.concatenate([low + (high - low) * (nodes + 1) / 2 for low, high in pieces])
    weight = np.concatenate([(high - low) * weights / 2 for low, high in pieces])
    wide = np.where(place <= split, area / (1 - np.minimum(place, split) * total * area / apex) ** 2, section)
    bottom = _floor_compliance(block, radius=patch * (1 + cone / apex)) * modulus / total
    degrees = range(THICKNESS_MODES)
    # (1 + bottom - t) lets the floor deflect under the block; times t^k (1 - t) for the higher ones
    shapes = [1 + bottom - place, *(place**k * (1 - place) for k in degrees[1:])]
    slopes = [-np.ones_like(place), *(k * place ** (k - 1) - (k + 1) * place**k for k in degrees[1:])]
    values, rates = np.array(shapes), np.array(slopes)
    stiffness = modulus / total * (rates * weight) @ rates.T
    stiffness[0, 0] += modulus / total * bottom
    inertia = material.density * total * (values * weight * wide**2) @ values.T
    squares, vectors = eigenpairs(stiffness, inertia)
    face = (1 + bottom) * vectors[0]
    return _without_the_fast(SurfaceModes(np.sqrt(squares) / (2 * np.pi), face))


def plate(block: Block, *, patch: float) -> SurfaceModes:
    """Return the bending modes of a block clamped all round or free, averaged over the patch, shear included.

    Mindlin's plate by Ritz's method with Legendre polynomials, times (1 - x^2)(1 - y^2) where it is clamped;
    orthotropic for wood. The translation of a free plate is left out here.
    """
    material, thickness = block.material, block.thickness
    along, across, poisson = material.longitudinal_modulus, material.across, material.poisson
    bending = thickness**3 / 12 / (1 - poisson**2 * across / along)
    rolling = ROLLING_SHEAR if material.family == "wood" else 1.0
    shear = FLAT_SHEAR * material.shear * thickness
    twist = material.shear * thickness**3 / 12
    half_x, half_y = block.length / 2, block.width / 2
    nodes, weights = legendre.leggauss(2 * FUNCTIONS + 4)
    x, y = (grid.ravel() for grid in np.meshgrid((nodes + 1) / 2, (nodes + 1) / 2))
    weight = np.outer(weights, weights).ravel() * half_x * half_y  # four equal quarters
    clamped = block.support == "clamped"

    def basis(odd_x: int, odd_y: int, points: tuple[Array, Array] = (x, y)) -> tuple[Array, Array, Array]:
        in_x, slope_x = _polynomials(points[0], odd_x, clamped)
        in_y, slope_y = _polynomials(points[1], odd_y, clamped)
        pairs = [(i, j) for i in range(FUNCTIONS) for j in range(FUNCTIONS)]
        value = np.array([in_x[i] * in_y[j] for i, j in pairs])
        by_x = np.array([slope_x[i] * in_y[j] for i, j in pairs]) / half_x
        return value, by_x, np.array([in_x[i] * slope_y[j] for i, j in pairs]) / half_y

    w, turn_x, turn_y = basis(0, 0), basis(1, 0), basis(0, 1)
    size = FUNCTIONS**2
    nothing = np.zeros_like(w[0])

    def energy(factor: float, *strains: tuple[Array, Array, Array]) -> Array:
        left, right = (np.vstack(strain) for strain in (strains[0], strains[-1]))
        product = factor * (left * weight) @ right.T
        return np.asarray((product + product.T) / 2)

    bent_x, bent_y = (nothing, turn_x[1], nothing), (nothing, nothing, turn_y[2])
    stiffness = energy(along * bending, bent_x) + energy(across * bending, bent_y)
    stiffness += energy(2 * poisson * across * bending, bent_x, bent_y)
    stiffness += energy(twist, (nothing, turn_x[2], turn_y[1]))
    stiffness += energy(shear, (w[1], turn_x[0], nothing)) + energy(rolling * shear, (w[2], nothing, turn_y[0]))
    mass = material.density * thickness
    inertia = energy(mass, (w[0], nothing, nothing))
    inertia += energy(mass * thickness**2 / 12, (nothing, turn_x[0], nothing))
    inertia += energy(mass * thickness**2 / 12, (nothing, nothing, turn_y[0]))
    squares, vectors = eigenpairs(stiffness, inertia)
    face = _over_patch(basis, patch, half_x, half_y) @ vectors[:size]
    first = 0 if clamped else 1  # the lowest motion of a free plate is its translation
    frequency = np.sqrt(np.maximum(squares[first:], 0.0)) / (2 * np.pi)
    return _without_the_fast(SurfaceModes(frequency, face[first:]), most=PLATE_MODES)


def _polynomials(points: Array, odd: int, clamped: bool) -> tuple[Array, Array]:
    """Return even or odd Legendre polynomials and slopes at points of [-1, 1], zero at the ends where clamped."""
    values, slopes = [], []
    for k in range(FUNCTIONS):
        series = np.zeros(2 * k + odd + 1)
        series[-1] = math.sqrt(2 * (2 * k + odd) + 1)
        value, slope = legendre.legval(points, series), legendre.legval(points, legendre.legder(series))
        if clamped:
            value, slope = value * (1 - points**2), slope * (1 - points**2) - 2 * points * value
        values.append(value)
        slopes.append(slope + np.zeros_like(points))
    return np.array(values), np.array(slopes)


def _over_patch(basis: object, patch: float, half_x: float, half_y: float) -> Array:
    """Return the mean of the deflection's functions over a disc in the middle."""
    radii = patch * np.sqrt((np.arange(4) + 0.5) / 4)
    turns = (np.arange(4) + 0.5) * math.pi / 8
    x, y = np.outer(radii, np.cos(turns)).ravel() / half_x, np.outer(radii, np.sin(turns)).ravel() / half_y
    return np.asarray(basis(0, 0, (x, y))[0].mean(axis=1))  # type: ignore[operator]


def _floor_compliance(block: Block, *, radius: float) -> float:
    """Return the compliance of the floor in m/N under a loaded circle; nothing unless the block lies on one."""
    if block.support != "floor" or block.floor_modulus is None:
        return 0.0
    return (1 - FLOOR_POISSON**2) / (2 * block.floor_modulus * radius)


def _without_the_fast(surface: SurfaceModes, *, most: int | None = None) -> SurfaceModes:
    """Return the slow modes, and one spring with the compliance of all that are too fast or too many to follow."""
    slow = np.arange(len(surface.frequency)) < (most or len(surface.frequency))
    slow &= surface.frequency < STIFF_FREQUENCY
    rest = SurfaceModes(surface.frequency[~slow], surface.shape[~slow]).compliance
    slow_modes = SurfaceModes(surface.frequency[slow], surface.shape[slow])
    if not rest:
        return slow_modes
    stiff = spring(rest)
    return SurfaceModes(np.append(slow_modes.frequency, stiff.frequency), np.append(slow_modes.shape, stiff.shape))
