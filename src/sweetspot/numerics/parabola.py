"""Top and end of a sampled curve, by the parabola through three neighbours.

Plain arithmetic on numbers: readable code calls it as it is, kernels compile it.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.numerics.arrays import Array


def vertex(before: float, middle: float, after: float) -> tuple[float, float]:
    """Return (shift, height) of the top of the parabola through three values one step apart.

    The shift is counted in steps from the middle one. Where the three do not bend down it is the middle one itself.

    >>> vertex(0.0, 3.0, 2.0)
    (0.25, 3.125)
    """
    bend = before - 2 * middle + after
    if not (math.isfinite(bend) and bend < 0):
        return 0.0, middle
    return (before - after) / (2 * bend), middle - (before - after) ** 2 / (8 * bend)


def crossing(before: float, middle: float, after: float) -> float:
    """Return where the parabola through three values one step apart comes down through zero, in steps after the middle.

    The middle one is above zero, the last is not; where the first is not above zero either it is a straight line.

    >>> round(crossing(3.0, 2.0, -1.0), 12), crossing(0.0, 1.0, -1.0)  # 2 - 2 x - x^2
    (0.732050807569, 0.5)
    """
    if before <= 0:
        return middle / (middle - after)
    slope, bend = (after - before) / 2, (before - 2 * middle + after) / 2
    return 2 * middle / (math.sqrt(slope**2 - 4 * bend * middle) - slope)


def top(values: Array) -> tuple[int, float, float]:
    """Return (index, shift, height) of the highest of evenly sampled values, nan left out.

    An end of the curve is its own top. Raises ValueError where every value is nan.
    """
    index = int(np.argmax(values))
    if math.isnan(values[index]):  # counts as the highest there; left out from the first it takes three times as long
        index = int(np.nanargmax(values))
    if index in (0, len(values) - 1):
        return index, 0.0, float(values[index])
    shift, height = vertex(*values[index - 1 : index + 2].tolist())
    return index, shift, height


def tops(values: Array) -> tuple[Array, Array]:
    """Return (place, height) of the top of every row of evenly sampled values, shape (rows, n); see `top`.

    Places are counted in steps from the first value; a row of nothing but nan has neither.

    >>> place, height = tops(np.array([[0.0, 3.0, 2.0, 0.0], [5.0, 4.0, 3.0, 2.0]]))
    >>> place.tolist(), height.tolist()
    ([1.25, 0.0], [3.125, 5.0])
    """
    rows, last = np.arange(len(values)), values.shape[1] - 1
    known = np.where(np.isnan(values), -np.inf, values)
    index = np.argmax(known, axis=1)
    before, middle, after = (known[rows, np.clip(index + step, 0, last)] for step in (-1, 0, 1))
    with np.errstate(invalid="ignore", divide="ignore"):
        bend = before - 2 * middle + after
        inside = (index > 0) & (index < last) & np.isfinite(bend) & (bend < 0)
        shift = np.where(inside, (before - after) / (2 * bend), 0.0)
        height = np.where(inside, middle - (before - after) ** 2 / (8 * bend), middle)
    nothing = np.isneginf(middle)
    return np.where(nothing, np.nan, index + shift), np.where(nothing, np.nan, height)


def peak(values: Array) -> float:
    """Return the height of the top of evenly sampled values."""
    return top(values)[2]
