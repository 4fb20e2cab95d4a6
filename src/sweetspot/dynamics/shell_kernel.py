"""The walls of hollow barrels solved, compiled: their modes, what a patch feels of them, and how far they give way."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.banded import WIDTH, factorised, lowest_pairs
from sweetspot.numerics.kernel_cache import compiled, inner

UNKNOWNS, STEP = 12, 8
"""Unknowns of an element, and how many of them are not the next one's: its matrix fits into a band."""
SHARED = UNKNOWNS - STEP
SIDE_BY_SIDE = 8
"""Pushes solved for at once."""


class Pushes(NamedTuple):
    """Pushes at points on the wall, each of P pushes with S points.

    Parameters
    ----------
    element : in which each point lies, shape (P, S).
    plane, outward : that element's functions of V and of W there, shape (P, S, 4).
    around, outwards : forces in N by harmonic, shape (H, P, S).
    """

    element: IntArray
    plane: Array
    outward: Array
    around: Array
    outwards: Array


class Solved(NamedTuple):
    """What `solved_walls` fills in: of the first D of H harmonics, M modes each.

    Parameters
    ----------
    squares : omega^2 in 1/s^2, lowest first, shape (D, M).
    felt : the modes' shapes under the pushes, 1/sqrt(kg), shape (D, P, M).
    give : m/N, how far the wall gives way under a slow push, at that push, shape (H, P).
    """

    squares: Array
    felt: Array
    give: Array


@compiled(nogil=True, error_model="numpy")
def solved_walls(stiffness: Array, inertia: Array, held: IntArray, pushes: Pushes, solved: Solved) -> bool:
    """Fill in what follows from the matrices of a wall's elements; see `ShellElements` for what they are.

    Returns
    -------
    bool
        False where a matrix is not positive definite or the modes do not converge.
    """
    squares, felt, give = solved
    size = STEP * stiffness.shape[1] + SHARED
    followed, modes = squares.shape
    none = np.zeros((0, size + WIDTH))
    vectors = np.zeros((modes, size + WIDTH))
    for h in range(len(stiffness)):
        diagonal, below = _assembled(size, stiffness[h], held, 1.0)
        if h < followed:
            mass = _assembled(size, inertia[h], held, 0.0)
            if not lowest_pairs(size, (diagonal, below), mass, 0.0, none, squares[h], vectors):
                return False
        elif not factorised(size, diagonal, below):
            return False
        _pushed(size, (diagonal, below), held, pushes, h, vectors if h < followed else none, felt, give)
    return True


@inner(error_model="numpy")
def _assembled(size: int, matrices: Array, held: IntArray, of_held: float) -> tuple[Array, Array]:
    """Return elements' matrices (elements, 12, 12) as one band, with ``of_held`` on the diagonal of what is held."""
    diagonal, below = np.zeros(size + WIDTH), np.zeros((size + WIDTH, WIDTH))
    for e in range(len(matrices)):
        for i in range(UNKNOWNS):
            row = STEP * e + i
            diagonal[row] += matrices[e, i, i]
            for j in range(i):
                below[STEP * e + j, i - j - 1] += matrices[e, i, j]
    for row in held:
        diagonal[row] = of_held
        below[row] = 0.0
        for k in range(min(WIDTH, row)):
            below[row - 1 - k, k] = 0.0
    return diagonal, below


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _pushed(
    size: int, factor: tuple[Array, Array], held: IntArray, pushes: Pushes, h: int, vectors: Array, felt: Array,
    give: Array,
) -> None:  # fmt: skip
    """Fill in what harmonic ``h`` feels of every push and how far it gives way: p^T K^-1 p = |L^-1 p|^2.

    L^-1 p goes on from the last element that is pushed to the tip; what is left there is four unknowns' work.
    """
    block = np.zeros((size + WIDTH, SIDE_BY_SIDE))
    sums = np.empty(SIDE_BY_SIDE)
    beyond = _beyond(size, factor, block, sums)
    for start in range(0, len(pushes.element), SIDE_BY_SIDE):
        count = min(SIDE_BY_SIDE, len(pushes.element) - start)
        first, last = size, 0
        for b in range(count):
            for s in range(pushes.element.shape[1]):
                base = STEP * pushes.element[start + b, s]
                around, outwards = pushes.around[h, start + b, s], pushes.outwards[h, start + b, s]
                first, last = min(first, base), max(last, base + STEP)
                plane, outward = pushes.plane[start + b, s], pushes.outward[start + b, s]
                for row, value in ((1, plane[0]), (6, plane[1]), (7, plane[2]), (9, plane[3])):
                    block[base + row, b] += around * value
                for row, value in ((2, outward[0]), (3, outward[1]), (10, outward[2]), (11, outward[3])):
                    block[base + row, b] += outwards * value
        for row in held:
            block[row] = 0.0
        for m in range(len(vectors)):
            sums[:] = 0.0
            for row in range(first, last + SHARED):
                for b in range(SIDE_BY_SIDE):
                    sums[b] += block[row, b] * vectors[m, row]
            for b in range(count):
                felt[h, start + b, m] = sums[b]
        _eliminated(factor, block, first, last, sums)
        left = block[last : last + SHARED]
        for i in range(SHARED):
            for j in range(SHARED):
                for b in range(SIDE_BY_SIDE):
                    sums[b] += beyond[last // STEP, i, j] * left[i, b] * left[j, b]
        for b in range(count):
            give[h, start + b] = sums[b]
        block[first : last + SHARED] = 0.0


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _eliminated(factor: tuple[Array, Array], block: Array, first: int, last: int, sums: Array) -> None:
    """Solve L x = b in so many rows for several b side by side, and fill in each one's |x|^2 there."""
    diagonal, below = factor
    sums[:] = 0.0
    for j in range(first, last):
        for b in range(SIDE_BY_SIDE):
            value = block[j, b] * diagonal[j]
            block[j, b] = value
            sums[b] += value * value
        for k in range(WIDTH):
            part = below[j, k]
            for b in range(SIDE_BY_SIDE):
                block[j + 1 + k, b] -= part * block[j, b]


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _beyond(size: int, factor: tuple[Array, Array], block: Array, sums: Array) -> Array:
    """Return the compliance of the wall from every element's begin to the tip, of the four unknowns that begin it.

    Parameters
    ----------
    block, sums : as `_pushed` has them; the block is left as it is found, zero.
    """
    count = size // STEP
    compliance = np.zeros((count + 2, SHARED, SHARED))
    for back in range(count + 1):
        number = count - back
        first = STEP * number
        last = min(first + STEP, size)
        for i in range(SHARED):
            block[first + i, i] = 1.0
        _eliminated(factor, block, first, last, sums)
        for i in range(SHARED):
            for j in range(SHARED):
                total = 0.0
                for row in range(first, last):
                    total += block[row, i] * block[row, j]
                for k in range(SHARED):
                    for m in range(SHARED):
                        total += block[last + k, i] * compliance[number + 1, k, m] * block[last + m, j]
                compliance[number, i, j] = total
        block[first : last + SHARED] = 0.0
    return compliance
