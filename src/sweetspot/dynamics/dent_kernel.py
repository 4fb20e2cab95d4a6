"""The surface of a long round body under one wave at a time, compiled; see `dent`."""

from __future__ import annotations

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled

MOTIONS = 3
"""Unknowns of a node: U along the axis, V around it and W outwards."""
SIDE_BY_SIDE = 8
"""Waves worked on at once."""


@compiled(nogil=True, fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def surface_compliance(parts: Array, factors: Array, compliance: Array) -> None:
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
    kept = size - MOTIONS
    block = np.zeros((size, size, SIDE_BY_SIDE))
    for start in range(0, len(factors), SIDE_BY_SIDE):
        count = min(SIDE_BY_SIDE, len(factors) - start)
        for e in range(parts.shape[1]):
            for i in range(size):
                for j in range(i + 1):
                    for b in range(count):
                        total = block[kept + i, kept + j, b] if e > 0 and i < MOTIONS else 0.0
                        for p in range(len(parts)):
                            total += parts[p, e, i, j] * factors[start + b, p]
                        block[i, j, b] = total
            for k in range(kept):
                _eliminated(block, k)
        _eliminated(block, kept)
        for b in range(count):
            around, outwards = block[kept + 1, kept + 1, b], block[kept + 2, kept + 2, b]
            both = block[kept + 2, kept + 1, b]
            whole = around * outwards - both * both
            compliance[0, start + b] = around / whole
            compliance[1, start + b] = -both / whole
            compliance[2, start + b] = outwards / whole


@compiled(nogil=True, fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _eliminated(block: Array, k: int) -> None:
    """Eliminate one unknown of symmetric matrices side by side; what is above their diagonals is room to work in."""
    for i in range(k + 1, len(block)):
        for b in range(SIDE_BY_SIDE):
            block[k, i, b] = block[i, k, b] / block[k, k, b]
        for j in range(k + 1, i + 1):
            for b in range(SIDE_BY_SIDE):
                block[i, j, b] -= block[k, i, b] * block[j, k, b]
