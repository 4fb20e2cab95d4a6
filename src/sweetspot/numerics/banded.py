"""The lowest eigenpairs of a banded stiffness and mass matrix, compiled: for beams and walls, one after the other.

A matrix is kept by columns of its lower triangle: the diagonal, and `WIDTH` numbers below it. Arrays have `WIDTH` rows
more than the matrix, all zero, so that no loop needs to know where the matrix ends.

The eigenvalues are found by Lanczos' method on L^-1 M L^-T with K + s M = L L^T (shift and invert): a few dozen steps
of two banded solves, every new vector made orthogonal to all before. Nothing is random.

Slices are copied by loops, and numpy sorts nothing here: the compiler takes longer for one of those than for a solve.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import inner

WIDTH = 12
"""Numbers kept below the diagonal: enough for one finite element of any line or wall here."""
FIRST_STEPS, MORE_STEPS, MOST_STEPS = 36, 8, 120
"""Lanczos steps before convergence is asked for, between two such questions, and at most, for up to 30 pairs; more
pairs take more, see `lowest_pairs`."""
NEAR = 1e-11
"""Part of the largest eigenvalue of the inverse that the residual of every wanted pair must lie below."""
QL_ROUNDS = 60


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def factorised(size: int, diagonal: Array, below: Array) -> bool:
    """Replace a positive definite matrix by its Cholesky factor, its diagonal inverted; return whether it was one."""
    for j in range(size):
        pivot = diagonal[j]
        if not pivot > 0.0:
            return False
        inverse = 1.0 / math.sqrt(pivot)
        diagonal[j] = inverse
        for k in range(WIDTH):
            below[j, k] *= inverse
        for k in range(WIDTH):
            part = below[j, k]
            row = j + 1 + k
            diagonal[row] -= part * part
            for m in range(WIDTH - 1 - k):
                below[row, m] -= part * below[j, k + 1 + m]
        for k in range(WIDTH):  # what lies beyond the matrix stays zero
            if j + 1 + k >= size:
                diagonal[j + 1 + k] = 0.0
    return True


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def solved_forward(size: int, diagonal: Array, below: Array, vector: Array) -> None:
    """Replace b by the solution of L x = b."""
    for j in range(size):
        value = vector[j] * diagonal[j]
        vector[j] = value
        for k in range(WIDTH):
            vector[j + 1 + k] -= below[j, k] * value


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def solved_backward(size: int, diagonal: Array, below: Array, vector: Array) -> None:
    """Replace b by the solution of L^T x = b."""
    for back in range(size):
        j = size - 1 - back
        total = vector[j]
        for k in range(WIDTH):
            total -= below[j, k] * vector[j + 1 + k]
        vector[j] = total * diagonal[j]


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def multiplied(size: int, diagonal: Array, below: Array, vector: Array, product: Array) -> None:
    """Fill ``product`` with the matrix times a vector."""
    for j in range(len(product)):
        product[j] = 0.0
    for j in range(size):
        value, total = vector[j], diagonal[j] * vector[j]
        for k in range(WIDTH):
            total += below[j, k] * vector[j + 1 + k]
        for k in range(WIDTH):
            product[j + 1 + k] += below[j, k] * value
        product[j] += total
    for j in range(size, len(product)):
        product[j] = 0.0


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def lowest_pairs(
    size: int,
    stiffness: tuple[Array, Array],
    inertia: tuple[Array, Array],
    shift: float,
    rigid: Array,
    values: Array,
    vectors: Array,
) -> bool:
    """Fill in the lowest eigenvalues above those of the rigid motions, and their mass-normalised vectors.

    Parameters
    ----------
    size : n.
    stiffness : its diagonal and what is below; replaced by the factor of K + s M.
    inertia : the same of the mass matrix, kept.
    shift : s > 0, small against the first eigenvalue; 0 where there are no rigid motions.
    rigid : vectors that the stiffness does not resist, shape (r, n + WIDTH); r may be 0.
    values, vectors : filled; shapes (count,) and (count, n + WIDTH).

    Returns
    -------
    bool
        False where the matrices are not positive definite or the method does not converge.
    """
    diagonal, below = stiffness
    for j in range(size):
        diagonal[j] += shift * inertia[0][j]
        for k in range(WIDTH):
            below[j, k] += shift * inertia[1][j, k]
    count, rigid_count = len(values), len(rigid)
    most = min(max(MOST_STEPS, 4 * count), size - rigid_count)
    if not factorised(size, diagonal, below) or most < count:
        return False
    basis = np.zeros((rigid_count + most + 1, size + WIDTH))
    _begun(size, stiffness, rigid, basis)
    along, beside = np.zeros(most), np.zeros(most + 1)
    turned, roots, off, order = np.empty((most, most)), np.empty(most), np.empty(most + 1), np.empty(count, np.int64)
    work, product = np.zeros(size + WIDTH), np.zeros(size + WIDTH)
    asked = min(max(FIRST_STEPS, 2 * count), most)
    for step in range(most):
        for j in range(size + WIDTH):
            work[j] = basis[rigid_count + step, j]
        solved_backward(size, diagonal, below, work)
        multiplied(size, inertia[0], inertia[1], work, product)
        solved_forward(size, diagonal, below, product)
        along[step] = _without_neighbours(size, basis[rigid_count:], step, beside[step], product)
        _against(basis, rigid_count + step + 1, product)
        beside[step + 1] = _scaled(product, basis[rigid_count + step + 1], size)
        steps, ended = step + 1, beside[step + 1] == 0.0
        if steps < asked and not ended:
            continue
        for i in range(steps):
            roots[i], off[i] = along[i], beside[i]
        off[steps] = beside[steps]
        if steps < count or not _tridiagonal(steps, roots, off, turned):
            return False
        _largest(steps, roots, order)
        worst = 0.0
        for i in range(count):
            worst = max(worst, abs(beside[steps] * turned[order[i], steps - 1]) / roots[order[i]])
        if worst < NEAR or steps == most or ended:
            _from_steps(size, stiffness, basis[rigid_count:], (roots, turned, order), steps, shift, values, vectors)
            return worst < 1e3 * NEAR
        asked += max(MORE_STEPS, count // 4)
    return False


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _begun(size: int, factor: tuple[Array, Array], rigid: Array, basis: Array) -> None:
    """Fill in the first orthonormal vectors: those of the rigid motions, then the one from which the steps begin."""
    diagonal, below = factor
    vector = np.zeros(size + WIDTH)
    for r in range(len(rigid)):  # L^T x of a rigid motion is an eigenvector
        for j in range(size):
            total = rigid[r, j] / diagonal[j]
            for k in range(WIDTH):
                total += below[j, k] * rigid[r, j + 1 + k]
            vector[j] = total
        _against(basis, r, vector)
        _scaled(vector, basis[r], size)
    for j in range(size):  # anything without a symmetry
        vector[j] = 1.0 + ((j * 7919) % 101) / 101.0
    _against(basis, len(rigid), vector)
    _scaled(vector, basis[len(rigid)], size)


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _without_neighbours(size: int, basis: Array, step: int, beside: float, vector: Array) -> float:
    """Take the parts along this step's vector and the one before out of a vector; return the first of them."""
    current, total = basis[step], 0.0
    for j in range(size):
        total += vector[j] * current[j]
    for j in range(size):
        vector[j] -= total * current[j]
    if step > 0:
        before = basis[step - 1]
        for j in range(size):
            vector[j] -= beside * before[j]
    return total


@inner(error_model="numpy")
def _largest(size: int, roots: Array, order: IntArray) -> None:
    """Fill in where the largest numbers are, the largest first; sorting all takes the compiler longer than the rest."""
    for i in range(len(order)):
        best = -1
        for j in range(size):
            used = False
            for k in range(i):
                used = used or order[k] == j
            if not used and (best < 0 or roots[j] > roots[best]):
                best = j
        order[i] = best


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _against(basis: Array, number: int, vector: Array) -> None:
    """Take the parts along the first ``number`` orthonormal vectors out of a vector."""
    for i in range(number):
        total = 0.0
        row = basis[i]
        for j in range(len(vector)):
            total += row[j] * vector[j]
        for j in range(len(vector)):
            vector[j] -= total * row[j]


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _scaled(vector: Array, target: Array, size: int) -> float:
    """Fill ``target`` with the vector at length one, and return the length that it had."""
    total = 0.0
    for j in range(size):
        total += vector[j] * vector[j]
    length = math.sqrt(total)
    for j in range(size):
        target[j] = vector[j] / length
    return float(length)


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _from_steps(
    size: int,
    factor: tuple[Array, Array],
    basis: Array,
    ritz: tuple[Array, Array, IntArray],
    steps: int,
    shift: float,
    values: Array,
    vectors: Array,
) -> None:
    """Fill in eigenvalues and mass-normalised vectors from those of the tridiagonal matrix."""
    roots, turned, order = ritz
    for i in range(len(values)):
        root, row = roots[order[i]], vectors[i]
        for j in range(len(row)):
            row[j] = 0.0
        for step in range(steps):
            part, each = turned[order[i], step], basis[step]
            for j in range(size):
                row[j] += part * each[j]
        solved_backward(size, factor[0], factor[1], row)
        scale = 1.0 / math.sqrt(root)  # x^T M x = theta for y of length one
        for j in range(size):
            row[j] *= scale
        values[i] = 1.0 / root - shift


@inner(error_model="numpy")
def _tridiagonal(size: int, diagonal: Array, beside: Array, turned: Array) -> bool:
    """Replace a symmetric tridiagonal matrix by its eigenvalues, by implicit QL steps.

    Parameters
    ----------
    diagonal : (n,), then the eigenvalues in no order.
    beside : (n + 1,), element i couples rows i - 1 and i; destroyed.
    turned : the eigenvectors, one a row.
    """
    for i in range(size):
        for k in range(size):
            turned[i, k] = 0.0
        turned[i, i] = 1.0
        beside[i] = beside[i + 1]
    beside[size - 1] = 0.0
    for low in range(size):
        for rounds in range(QL_ROUNDS + 1):
            split = low
            while split < size - 1:
                scale = abs(diagonal[split]) + abs(diagonal[split + 1])
                if abs(beside[split]) <= 1e-17 * scale:
                    break
                split += 1
            if split == low:
                break
            if rounds == QL_ROUNDS:
                return False
            g = (diagonal[low + 1] - diagonal[low]) / (2.0 * beside[low])
            r = math.hypot(g, 1.0)
            g = diagonal[split] - diagonal[low] + beside[low] / (g + (r if g >= 0 else -r))
            s, c, p = 1.0, 1.0, 0.0
            early = False
            for back in range(split - low):
                i = split - 1 - back
                f, b = s * beside[i], c * beside[i]
                r = math.hypot(f, g)
                beside[i + 1] = r
                if r == 0.0:
                    diagonal[i + 1] -= p
                    beside[split] = 0.0
                    early = True
                    break
                s, c = f / r, g / r
                g = diagonal[i + 1] - p
                r = (diagonal[i] - g) * s + 2.0 * c * b
                p = s * r
                diagonal[i + 1] = g + p
                g = c * r - b
                _rotated(turned[i], turned[i + 1], size, s, c)
            if early:
                continue
            diagonal[low] -= p
            beside[low] = g
            beside[split] = 0.0
    return True


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _rotated(first: Array, second: Array, size: int, s: float, c: float) -> None:
    """Turn two rows into each other."""
    for k in range(size):
        f = second[k]
        second[k] = s * first[k] + c * f
        first[k] = c * first[k] - s * f
