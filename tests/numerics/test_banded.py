"""The compiled banded eigenproblem beside LAPACK's dense one."""

from __future__ import annotations

import numpy as np
import scipy.linalg

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.banded import WIDTH, lowest_pairs
from tests.dense_bending import lowest


def banded(matrix: Array) -> tuple[Array, Array]:
    """Return a dense symmetric matrix as the kernel keeps it."""
    size = len(matrix) + WIDTH
    diagonal, below = np.zeros(size), np.zeros((size, WIDTH))
    diagonal[: len(matrix)] = np.diag(matrix)
    for k in range(WIDTH):
        row = np.diag(matrix, -k - 1)
        below[: len(row), k] = row
    return diagonal, below


def chain(size: int, held: bool) -> Array:
    """Return the stiffness of equal springs in a row, one end held or both free."""
    matrix = 2 * np.eye(size) - np.eye(size, k=1) - np.eye(size, k=-1)
    matrix[-1, -1] = 1.0
    if not held:
        matrix[0, 0] = 1.0
    return np.asarray(matrix)


def test_springs_in_a_row_have_their_textbook_frequencies() -> None:
    """omega_k^2 = 2 - 2 cos((2 k - 1) pi / (2 n + 1)) of n unit masses, one end held: exact."""
    size, count = 80, 6
    stiffness, inertia = banded(chain(size, held=True)), banded(np.eye(size))
    values, vectors = np.empty(count), np.zeros((count, size + WIDTH))
    assert lowest_pairs(size, stiffness, inertia, 0.0, np.zeros((0, size + WIDTH)), values, vectors)
    k = np.arange(1, count + 1)
    assert np.allclose(values, 2 - 2 * np.cos((2 * k - 1) * np.pi / (2 * size + 1)), rtol=1e-11, atol=0)
    assert np.allclose(vectors[:, :size] @ vectors[:, :size].T, np.eye(count), atol=1e-11)


def test_free_ends_need_the_rigid_motion() -> None:
    size, count = 60, 5
    rng = np.random.default_rng(3)
    mass = np.diag(rng.uniform(0.5, 2.0, size))
    stiffness = chain(size, held=False)
    values, vectors = np.empty(count), np.zeros((count, size + WIDTH))
    rigid = np.zeros((1, size + WIDTH))
    rigid[0, :size] = 1.0
    assert lowest_pairs(size, banded(stiffness), banded(mass), 1e-3, rigid, values, vectors)
    expected, shapes = scipy.linalg.eigh(stiffness, mass, subset_by_index=[1, count])
    assert np.allclose(values, expected, rtol=1e-10, atol=0)
    assert np.allclose(np.abs(vectors[:, :size]), np.abs(shapes.T), atol=1e-9)


def test_what_is_not_positive_is_refused() -> None:
    size = 30
    matrix = chain(size, held=True)
    matrix[12, 12] = -1.0
    values, vectors = np.empty(3), np.zeros((3, size + WIDTH))
    nothing = np.zeros((0, size + WIDTH))
    assert not lowest_pairs(size, banded(matrix), banded(np.eye(size)), 0.0, nothing, values, vectors)


def test_the_dense_solver_keeps_the_first_mode_beside_a_very_stiff_one() -> None:
    """Rounding is a part of the largest eigenvalue; solved for inverses, the lowest are the largest: exact chain."""
    size = 40
    stiffness = chain(size, held=True)
    stiffness[-1, -1] += 1e9
    values, _ = lowest(stiffness, np.eye(size), first=0, last=2)
    k = np.arange(1, 4)
    assert np.allclose(values, 2 - 2 * np.cos(k * np.pi / size), rtol=1e-8, atol=0)
