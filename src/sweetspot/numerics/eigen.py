"""Eigenvalues of a stiffness and a mass matrix, dense and symmetric."""

from __future__ import annotations

import numpy as np

from sweetspot.numerics.arrays import Array


def eigenpairs(stiffness: Array, inertia: Array, *, kept: slice = slice(None)) -> tuple[Array, Array]:
    """Return eigenvalues, rising, and mass-normalised eigenvectors of K v = lambda M v.

    By Cholesky's factor of M, as `scipy.linalg.eigh`, whose import takes an eighth of a first answer's time.

    Parameters
    ----------
    stiffness, inertia : K and M, dense and symmetric, shape (n, n); M positive definite.
    kept : which of the n pairs are wanted; all when left out.

    >>> values, vectors = eigenpairs(np.diag([8.0, 3.0]), np.diag([2.0, 1.0]))
    >>> values
    array([3., 4.])
    """
    lower = np.linalg.cholesky(inertia)
    half = np.linalg.solve(lower, stiffness)
    values, vectors = np.linalg.eigh(np.linalg.solve(lower, half.T))
    return values[kept], np.linalg.solve(lower.T, vectors[:, kept])


def lowest(stiffness: Array, inertia: Array, *, first: int, last: int, shift: float = 0.0) -> tuple[Array, Array]:
    """Return eigenvalues and mass-normalised eigenvectors ``first`` to ``last`` of K v = lambda M v.

    Solved as M v = (K + s M) v / (lambda + s): the lowest are then the largest, and rounding, which is a part of the
    largest eigenvalue, no longer drowns them (the other way round, a short element costs the first mode seven digits).

    Parameters
    ----------
    stiffness, inertia : K and M, dense and symmetric, shape (n, n); M positive definite, K at least not negative.
    first, last : 0 is the lowest.
    shift : s, > 0 where K does not resist every motion; best below the first eigenvalue above zero.
    """
    size = len(stiffness)
    largest = slice(size - 1 - last, size - first)
    inverse, vectors = eigenpairs(inertia, stiffness + shift * inertia, kept=largest)
    inverse, vectors = inverse[::-1], vectors[:, ::-1]
    return 1 / inverse - shift, vectors / inverse**0.5
