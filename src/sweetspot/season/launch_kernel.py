"""The compiled look-up in a table over three even axes; see `launch_table`."""

from __future__ import annotations

import math

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled


@compiled(nogil=True, error_model="numpy")
def fill_between(axes: tuple[Array, Array, Array], table: Array, asked: Array, values: Array) -> None:
    """Fill what stands in a table between its nodes, in straight lines; beyond its ends the nearest counts.

    Parameters
    ----------
    axes : even nodes of the three axes.
    table : shape (nodes of each axis, k).
    asked : (3, n); NaN counts as the first node.
    values : (n, k).
    """
    first, second, third = axes
    for i in range(len(values)):
        a, x = _place(first, asked[0, i])
        b, y = _place(second, asked[1, i])
        c, z = _place(third, asked[2, i])
        for value in range(table.shape[3]):
            total = 0.0
            for corner in range(4):
                p, q = corner >> 1, corner & 1
                weight = (x if p else 1 - x) * (y if q else 1 - y)
                low, high = table[a + p, b + q, c, value], table[a + p, b + q, c + 1, value]
                total += weight * (low + z * (high - low))
            values[i, value] = total


@compiled(error_model="numpy")
def _place(nodes: Array, value: float) -> tuple[int, float]:
    last = len(nodes) - 1.0
    at = (value - nodes[0]) / (nodes[1] - nodes[0])
    at = min(max(at, 0.0), last) if math.isfinite(at) else 0.0
    low = min(int(at), len(nodes) - 2)
    return low, at - low
