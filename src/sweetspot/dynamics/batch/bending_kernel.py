"""Bending modes and slow compliance of many beams, compiled; the equations are in `batch.bending` and
`residual_flexibility`.

On each element the deflection is quartic and the rotation cubic: straight lines between its ends and integrated
Legendre polynomials that vanish there, so that element after element gives a narrow band.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sweetspot.dynamics.batch.mesh import at_gauss_points, powers
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.banded import WIDTH, lowest_pairs
from sweetspot.numerics.gauss_legendre import GAUSS_POINTS
from sweetspot.numerics.kernel_cache import compiled, inner

DEGREE = 4
"""Of the deflection; the rotation has one less."""
SHIFT = 0.1
"""Part of an even beam's first eigenvalue by which the problem is shifted; the answers do not depend on it."""
EVEN_BEAM = 500.0
"""omega^2 M L^2 (L / EI) of an even free beam: (beta L)^4 = 500.6 (4.7300^4), rounded."""
DEFLECTIONS, ROTATIONS = np.array([0, 2, 3, 4, 7]), np.array([1, 5, 6, 8])
"""Places of deflection's and rotation's functions among an element's nine: left end, inside, right end."""
STEP = 7
"""Unknowns from one element to the next."""
LOCAL = 9

GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(GAUSS_POINTS)[1]
VALUES, SLOPES = at_gauss_points(DEGREE)
POWERS = powers(DEGREE)
ROTATION_OF = np.array([0, 1, 2, 4])
"""Which of the five functions the rotation uses."""


class Elements(NamedTuple):
    """Elements of many beams: sections at their Gauss points (elements, points), widths, beams' first elements."""

    first: IntArray
    width: Array
    mass: Array
    rotary_inertia: Array
    bending_stiffness: Array
    shear_stiffness: Array


class Points(NamedTuple):
    """Point masses, shape (beams, k): kg, kg m^2, m, and the element end that each sits on."""

    mass: Array
    moi: Array
    position: Array
    node: IntArray


@compiled(nogil=True, fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def bend(elements: Elements, ends: Array, points: Points, mass: Array, squares: Array, coefficients: Array) -> int:
    """Fill in squared angular frequencies (beams, count) and shapes (elements, 5 powers, count) of many beams.

    Parameters
    ----------
    ends : where every element of every beam begins, m, shape (elements,).
    mass : kg of every beam.

    Returns
    -------
    int
        The first beam that has no such modes, or -1.
    """
    beams, count = squares.shape
    for beam in range(beams):
        start, number = elements.first[beam], elements.first[beam + 1] - elements.first[beam]
        size = STEP * number + 2
        rows = size + WIDTH
        stiff, stiff_below = np.zeros(rows), np.zeros((rows, WIDTH))
        heavy, heavy_below = np.zeros(rows), np.zeros((rows, WIDTH))
        rigid, vectors = np.zeros((2, rows)), np.zeros((count, rows))
        flexible, length = 0.0, 0.0
        for element in range(start, start + number):
            _add_element(element, STEP * (element - start), elements, stiff, stiff_below, heavy, heavy_below)
            length += elements.width[element]
            flexible += elements.width[element] / elements.bending_stiffness[element, GAUSS_POINTS // 2]
            at = STEP * (element - start)
            rigid[0, at], rigid[1, at], rigid[1, at + 1] = 1.0, ends[element], 1.0
        last = STEP * number
        rigid[0, last], rigid[1, last], rigid[1, last + 1] = 1.0, ends[start] + length, 1.0
        for k in range(points.mass.shape[1]):
            at = STEP * points.node[beam, k]
            heavy[at] += points.mass[beam, k]
            heavy[at + 1] += points.moi[beam, k]
        shift = SHIFT * EVEN_BEAM / (flexible * mass[beam] * length**2)
        if not lowest_pairs(size, (stiff, stiff_below), (heavy, heavy_below), shift, rigid, squares[beam], vectors):
            return beam
        _write_shapes(start, number, vectors, coefficients)
    return -1


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _add_element(
    element: int, at: int, elements: Elements, stiff: Array, stiff_below: Array, heavy: Array, heavy_below: Array
) -> None:
    """Add one element's stiffness and mass, its unknowns beginning at ``at``."""
    width = elements.width[element]
    strain, curvature = np.zeros(LOCAL), np.zeros(LOCAL)
    along, tilt = np.zeros(LOCAL), np.zeros(LOCAL)
    local_k, local_m = np.zeros((LOCAL, LOCAL)), np.zeros((LOCAL, LOCAL))
    for q in range(GAUSS_POINTS):
        for i in range(5):
            strain[DEFLECTIONS[i]] = SLOPES[q, i] * 2.0 / width
            along[DEFLECTIONS[i]] = VALUES[q, i]
        for i in range(4):
            strain[ROTATIONS[i]] = -VALUES[q, ROTATION_OF[i]]
            curvature[ROTATIONS[i]] = SLOPES[q, ROTATION_OF[i]] * 2.0 / width
            tilt[ROTATIONS[i]] = VALUES[q, ROTATION_OF[i]]
        weight = GAUSS_WEIGHTS[q] * width / 2
        shear, bending = elements.shear_stiffness[element, q] * weight, elements.bending_stiffness[element, q] * weight
        mass, turning = elements.mass[element, q] * weight, elements.rotary_inertia[element, q] * weight
        for i in range(LOCAL):
            a, b, c, d = shear * strain[i], bending * curvature[i], mass * along[i], turning * tilt[i]
            for j in range(LOCAL):
                local_k[i, j] += a * strain[j] + b * curvature[j]
                local_m[i, j] += c * along[j] + d * tilt[j]
    for i in range(LOCAL):
        stiff[at + i] += local_k[i, i]
        heavy[at + i] += local_m[i, i]
        for j in range(i + 1, LOCAL):
            stiff_below[at + i, j - i - 1] += local_k[i, j]
            heavy_below[at + i, j - i - 1] += local_m[i, j]


@inner(error_model="numpy")
def _write_shapes(start: int, number: int, vectors: Array, coefficients: Array) -> None:
    """Write every mode's deflection as a polynomial in t = 0..1 on each element, positive at the tip."""
    for mode in range(len(vectors)):
        sign = 1.0 if vectors[mode, STEP * number] >= 0 else -1.0
        for element in range(number):
            for power in range(5):
                total = 0.0
                for i in range(5):
                    total += POWERS[power, i] * vectors[mode, STEP * element + DEFLECTIONS[i]]
                coefficients[start + element, power, mode] = sign * total


@inner(error_model="numpy")
def _behind(rising: Array, start: int, stop: int, value: float) -> int:
    """Return the index from ``start`` to ``stop`` of the first number above a value; ``stop``: none is."""
    low, high = start, stop
    while low < high:
        middle = (low + high) // 2
        if rising[middle] > value:
            high = middle
        else:
            low = middle + 1
    return low


@compiled(nogil=True, error_model="numpy")
def shapes_at(first: IntArray, ends: Array, width: Array, coefficients: Array, position: Array, shapes: Array) -> None:
    """Fill in the elastic shapes (beams, places, count) at places (beams, places) in m; they go on beyond the ends."""
    count = coefficients.shape[2]
    for beam in range(len(position)):
        start, stop = first[beam], first[beam + 1]
        for place in range(position.shape[1]):
            x = position[beam, place]
            element = max(_behind(ends, start, stop, x) - 1, start)
            t = (x - ends[element]) / width[element]
            for mode in range(count):
                c = coefficients[element]
                shapes[beam, place, mode] = (((c[0, mode] * t + c[1, mode]) * t + c[2, mode]) * t + c[3, mode]) * t + c[
                    4, mode
                ]


@compiled(nogil=True, error_model="numpy")
def merged(first: IntArray, ends: Array, position: Array, cells: Array, counts: IntArray) -> None:
    """Fill in the rising ends of cells of every beam, those of its mesh and given places together, each once.

    Parameters
    ----------
    position : rising, shape (beams, places).
    cells, counts : filled: (beams, most) and how many of them are used.
    """
    for beam in range(len(position)):
        i, j, used = first[beam], 0, 0
        while i < first[beam + 1] or j < position.shape[1]:
            if j == position.shape[1] or (i < first[beam + 1] and ends[i] <= position[beam, j]):
                value = ends[i]
                i += 1
            else:
                value = position[beam, j]
                j += 1
            if used == 0 or value > cells[beam, used - 1]:
                cells[beam, used] = value
                used += 1
        counts[beam] = used


@compiled(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
def give_slowly(
    first: IntArray,
    middle: Array,
    cells: tuple[Array, Array, Array, Array, Array],
    points: Points,
    position: Array,
    compliance: Array,
) -> None:
    """Fill in the static compliance of every free beam, m/N at places (beams, places) in m.

    The sums over cells of `static_compliance`, taken apart so that each is made once and not for every place.

    Parameters
    ----------
    first, middle : of every beam's first cell, and the middles of all cells in m.
    cells : their widths, and the sections there: mass, rotary inertia, bending and shear stiffness.
    """
    width, mass, rotary, bending, shear = cells
    most = 0
    for beam in range(len(position)):
        most = max(most, first[beam + 1] - first[beam])
    for beam in range(len(position)):
        start, number = first[beam], first[beam + 1] - first[beam]
        total, centre, moi = 0.0, 0.0, 0.0
        for i in range(start, start + number):
            total += mass[i] * width[i]
            centre += mass[i] * width[i] * middle[i]
        for k in range(points.mass.shape[1]):
            total += points.mass[beam, k]
            centre += points.mass[beam, k] * points.position[beam, k]
        centre /= total
        for i in range(start, start + number):
            moi += (mass[i] * ((middle[i] - centre) ** 2 + width[i] ** 2 / 12) + rotary[i]) * width[i]
        for k in range(points.mass.shape[1]):
            moi += points.mass[beam, k] * (points.position[beam, k] - centre) ** 2 + points.moi[beam, k]
        sums = np.zeros(6)  # over all cells: a^2, a b, b^2 of bending and of shear
        passed = np.zeros(3)  # mass, first and second moment before a cell
        beyond = np.zeros((most + 1, 9))
        for cell in range(number):
            i = start + cell
            arm = middle[i] - centre
            lump = mass[i] * width[i]
            spread = (mass[i] * (arm**2 + width[i] ** 2 / 12) + rotary[i]) * width[i]
            inertia, moment, turning = passed[0] + lump / 2, passed[1] + lump * arm / 2, passed[2] + spread / 2
            for k in range(points.mass.shape[1]):
                if points.position[beam, k] <= middle[i]:
                    away = points.position[beam, k] - centre
                    inertia += points.mass[beam, k]
                    moment += points.mass[beam, k] * away
                    turning += points.mass[beam, k] * away**2 + points.moi[beam, k]
            passed[0] += lump
            passed[1] += lump * arm
            passed[2] += spread
            p, q = width[i] / bending[i], width[i] / shear[i]
            a, b = (moment - arm * inertia) / total, (turning - arm * moment) / moi
            c, d = inertia / total, moment / moi
            sums[0] += p * a * a
            sums[1] += p * a * b
            sums[2] += p * b * b
            sums[3] += q * c * c
            sums[4] += q * c * d
            sums[5] += q * d * d
            row = beyond[cell]
            row[0], row[1], row[2] = p, p * arm, p * arm * arm
            row[3], row[4], row[5], row[6] = p * a, p * arm * a, p * b, p * arm * b
            row[7], row[8] = q * (1 - 2 * c), q * d
        for back in range(number - 1):
            cell = number - 2 - back
            for column in range(9):
                beyond[cell, column] += beyond[cell + 1, column]
        for place in range(position.shape[1]):
            x = position[beam, place]
            cell = _behind(middle, start, start + number, x) - start
            s, t = beyond[cell] if cell < number else beyond[most], x - centre
            bent = s[0] * t * t - 2 * t * s[1] + s[2]
            bent -= 2 * ((t * s[3] - s[4]) + t * (t * s[5] - s[6]))
            bent += sums[0] + 2 * t * sums[1] + t * t * sums[2]
            slid = s[7] - 2 * t * s[8] + sums[3] + 2 * t * sums[4] + t * t * sums[5]
            compliance[beam, place] = bent + slid
