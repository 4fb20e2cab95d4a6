"""Piecewise polynomials at many places: the sums of `Piecewise`, place by place instead of power by power."""

from __future__ import annotations

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import compiled


def values_at(coefficients: Array, piece: IntArray, part: Array) -> Array:
    """Return values at places of shape (...): those of `Piecewise`, to the last digit.

    Parameters
    ----------
    coefficients : highest power first, shape (degree + 1, pieces) of one polynomial, (degree + 1, pieces, n) of n.
    piece, part : which piece, and the distance from its left end, shape (...).
    """
    functions = coefficients.shape[2:]
    values = np.empty((*piece.shape, *functions))
    by_piece = np.ascontiguousarray(coefficients.reshape(*coefficients.shape[:2], -1).transpose(1, 0, 2))
    _fill(by_piece, piece.ravel(), part.ravel(), values.reshape(piece.size, -1))
    return values


@compiled(nogil=True)
def _fill(coefficients: Array, piece: IntArray, part: Array, values: Array) -> None:
    """Fill values (places, n) by Horner's scheme, from coefficients (pieces, degree + 1, n)."""
    for place in range(len(piece)):
        of_piece, distance, value = coefficients[piece[place]], part[place], values[place]
        for i in range(len(value)):
            value[i] = of_piece[0, i]
        for power in range(1, len(of_piece)):
            for i in range(len(value)):
                value[i] = value[i] * distance + of_piece[power, i]
