"""The kinds of arrays that all functions speak of."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
"""Numbers, of any shape; docstrings say which."""
IntArray = NDArray[np.int64]
"""Counts, indices and outcomes."""


def vectors(*parts: ArrayLike) -> Array:
    """Return vectors of shape (..., k) from their k components, which are broadcast together.

    In memory each component lies by itself, which makes sums and products of many short vectors several times as fast.

    >>> vectors([1.0, 2.0], 0.0, [5.0, 6.0]).tolist()
    [[1.0, 0.0, 5.0], [2.0, 0.0, 6.0]]
    """
    return np.moveaxis(np.stack(np.broadcast_arrays(*(np.asarray(part, float) for part in parts))), 0, -1)
