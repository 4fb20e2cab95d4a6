"""The compiled look-up in a table over three even axes; see `launch_table`."""

from __future__ import annotations

import math

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled


@compiled(nogil=True, error_model="numpy")
def fill_between(
    axes: tuple[Array, Array, Array], table: Array, asked: Array, part: Array, values: Array
) -> None:  # fmt: skip
    """Fill what stands in a table between its nodes, in straight lines; beyond its ends the nearest counts.

    Parameters
    ----------
    axes : even nodes of the three axes.
    table : shape (nodes of each axis, 6), three values in thin air and the same in thick.
    asked : (3, n); NaN counts as the first node.
    part : (n,), how far on each ball's air is from the thin one to the thick.
    values : (3, n).
    """
    first, second, third = axes
    for i in range(len(part)):
        a, x = _place(first, asked[0, i])
        b, y = _place(second, asked[1, i])
        c, z = _place(third, asked[2, i])
        one, two, three = 0.0, 0.0, 0.0
        thin, thick = 1 - part[i], part[i]
        for corner in range(8):
            p, q, r = corner >> 2, (corner >> 1) & 1, corner & 1
            weight = (x if p else 1 - x) * (y if q else 1 - y) * (z if r else 1 - z)
            node = table[a + p, b + q, c + r]
            one += weight * (thin * node[0] + thick * node[3])
            two += weight * (thin * node[1] + thick * node[4])
            three += weight * (thin * node[2] + thick * node[5])
        values[0, i], values[1, i], values[2, i] = one, two, three


@compiled(forceinline=True, error_model="numpy")
def _place(nodes: Array, value: float) -> tuple[int, float]:
    last = len(nodes) - 1.0
    at = (value - nodes[0]) / (nodes[1] - nodes[0])
    at = min(max(at, 0.0), last) if math.isfinite(at) else 0.0
    low = min(int(at), len(nodes) - 2)
    return low, at - low
