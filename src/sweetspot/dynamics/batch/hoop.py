"""Hoop modes of hollow barrels by the compiled banded solver: the same elements, strains and points as `hoop`.

Unknowns go along the barrel: u, v, w and the slope of w at an element's end, then two of u and two of v inside it.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.hoop import (
    AXIAL_MODES,
    ELEMENTS,
    EVEN_PART,
    HARMONICS,
    barrel_range,
    felt_by_ball,
    is_capped,
)
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.wall import wall_stiffness
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.banded import WIDTH, lowest_pairs
from sweetspot.numerics.kernel_cache import compiled

POINTS = 5
"""Gauss points of an element: exact to degree 9, as in `hoop`."""
STEP, LOCAL = 8, 12
AXIAL, AROUND, OUTWARD = np.array([0, 4, 5, 8]), np.array([1, 6, 7, 9]), np.array([2, 3, 10, 11])
"""Places of u's, v's and w's functions among an element's twelve."""


def _functions() -> tuple[Array, Array, Array, Array, Array]:
    """Return plane values and slopes, and outward values, slopes and bends, (points, 4), s -1..1, width 2.

    Plane: straight lines and two integrated Legendre polynomials; outward: Hermite's cubics.
    """
    s = np.polynomial.legendre.leggauss(POINTS)[0]
    line = np.polynomial.Polynomial
    plane = [line([0.5, -0.5]), line([-1, 0, 1]), line([0, -1, 0, 1]), line([0.5, 0.5])]
    outward = [
        line([0.5, -0.75, 0, 0.25]), line([0.25, -0.25, -0.25, 0.25]), line([0.5, 0.75, 0, -0.25]),
        line([-0.25, -0.25, 0.25, 0.25]),
    ]  # fmt: skip
    rows = [[f(s) for f in plane], [f.deriv()(s) for f in plane]]
    rows += [[f.deriv(order)(s) if order else f(s) for f in outward] for order in (0, 1, 2)]
    p, p1, w, w1, w2 = (np.ascontiguousarray(np.array(row).T) for row in rows)
    return p, p1, w, w1, w2


P, P1, W, W1, W2 = _functions()
NODES, WEIGHTS = np.polynomial.legendre.leggauss(POINTS)


def fast_hoop_modes(
    line: BeamModel, *, patch: float, harmonics: tuple[int, ...] = HARMONICS, axial_modes: int = AXIAL_MODES
) -> Modes:
    """Return the hoop modes of a hollow bat's barrel; see `hoop_modes`, which they are to 1e-9.

    Raises
    ------
    InputError
        when the wall has no modes: a mass or stiffness that is not above zero.
    """
    start, end = barrel_range(line)
    nodes = np.linspace(start, end, ELEMENTS + 1)
    width = (end - start) / ELEMENTS
    places = (nodes[:-1, None] + width * (NODES + 1) / 2).ravel()
    wall = wall_stiffness(line, places)
    law = np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART
    shape = (ELEMENTS, POINTS)
    size = STEP * ELEMENTS + 4
    squares, vectors = np.empty(axial_modes), np.zeros((axial_modes, size + WIDTH))
    found = []
    for n in harmonics:
        done = _ring(
            n, width, law.reshape(*shape, 6, 6), wall.mean_radius.reshape(shape), wall.mass_per_area.reshape(shape),
            is_capped(line), squares, vectors,
        )  # fmt: skip
        if not done:
            raise InputError(f"{line.bat.name} has no hoop modes; check its wall")
        values, slopes = vectors[:, 2:size:STEP].T, vectors[:, 3:size:STEP].T
        found.append((squares.copy(), CubicHermiteSpline(nodes, values.copy(), slopes.copy())))
    return felt_by_ball(line, found, patch=patch, harmonics=harmonics)


@compiled(nogil=True, fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _ring(
    n: int, width: float, law: Array, radius: Array, mass: Array, capped: bool, squares: Array, vectors: Array
) -> bool:
    """Fill in the lowest squares of angular frequency of harmonic n, and mass-normalised vectors (modes, n + WIDTH)."""
    elements = len(radius)
    size = STEP * elements + 4
    stiff, stiff_below = np.zeros(size + WIDTH), np.zeros((size + WIDTH, WIDTH))
    heavy, heavy_below = np.zeros(size + WIDTH), np.zeros((size + WIDTH, WIDTH))
    strain, stress = np.zeros((6, LOCAL)), np.zeros((6, LOCAL))
    motion = np.zeros((3, LOCAL))
    local_k, local_m = np.empty((LOCAL, LOCAL)), np.empty((LOCAL, LOCAL))
    for element in range(elements):
        local_k[:], local_m[:] = 0.0, 0.0
        for q in range(POINTS):
            _strains(n, width, radius[element, q], q, strain, motion)
            weight = np.pi * radius[element, q] * WEIGHTS[q] * width / 2
            for a in range(6):
                for j in range(LOCAL):
                    total = 0.0
                    for b in range(6):
                        total += law[element, q, a, b] * strain[b, j]
                    stress[a, j] = weight * total
            for a in range(6):
                for i in range(LOCAL):
                    for j in range(LOCAL):
                        local_k[i, j] += strain[a, i] * stress[a, j]
            inertia = weight * mass[element, q]
            for a in range(3):
                for i in range(LOCAL):
                    for j in range(LOCAL):
                        local_m[i, j] += inertia * motion[a, i] * motion[a, j]
        at = STEP * element
        for i in range(LOCAL):
            stiff[at + i] += local_k[i, i]
            heavy[at + i] += local_m[i, i]
            for j in range(i + 1, LOCAL):
                stiff_below[at + i, j - i - 1] += local_k[i, j]
                heavy_below[at + i, j - i - 1] += local_m[i, j]
    for held in (1, 2):  # v and w at the taper and, with a cap, at the tip
        _hold(held, stiff_below, heavy, heavy_below)
        if capped:
            _hold(STEP * elements + held, stiff_below, heavy, heavy_below)
    nothing = np.zeros((0, size + WIDTH))
    return bool(lowest_pairs(size, (stiff, stiff_below), (heavy, heavy_below), 0.0, nothing, squares, vectors))


@compiled(nogil=True, error_model="numpy")
def _strains(n: int, width: float, radius: float, q: int, strain: Array, motion: Array) -> None:
    """Fill in every function's six strains and its displacements at a Gauss point; see `hoop`."""
    half = width / 2
    for k in range(4):
        u, v, w = AXIAL[k], AROUND[k], OUTWARD[k]
        p, p1 = P[q, k], P1[q, k] / half
        scale = half if k % 2 else 1.0  # functions of a slope are as long as the element
        y, y1, y2 = W[q, k] * scale, W1[q, k] * scale / half, W2[q, k] * scale / half**2
        strain[0, u], strain[2, u], strain[5, u] = p1, -n * p / radius, n * p / (2 * radius**2)
        strain[1, v], strain[2, v], strain[4, v] = n * p / radius, p1, n * p / radius**2
        strain[5, v] = 1.5 * p1 / radius
        strain[1, w], strain[3, w], strain[4, w], strain[5, w] = (
            y / radius,
            -y2,
            n**2 * y / radius**2,
            2 * n * y1 / radius,
        )
        motion[0, u], motion[1, v], motion[2, w] = p, p, y


@compiled(nogil=True, error_model="numpy")
def _hold(at: int, stiff_below: Array, heavy: Array, heavy_below: Array) -> None:
    """Keep an unknown at zero: it moves alone, stiffly and without mass."""
    heavy[at], heavy_below[at, :], stiff_below[at, :] = 0.0, 0.0, 0.0
    for k in range(WIDTH):
        if at - 1 - k >= 0:
            heavy_below[at - 1 - k, k] = 0.0
            stiff_below[at - 1 - k, k] = 0.0
