"""Top and end of a sampled curve by the parabola through three neighbours, and the cubic through both ends of a step.

Plain arithmetic on numbers: readable code calls it as it is, kernels compile it.
"""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np

from sweetspot.numerics.arrays import Array

Values = TypeVar("Values", float, Array)


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


def on_parabola(part: Values, before: Values, middle: Values, after: Values) -> Values:
    """Return the parabola through values at -1, 0 and 1, at ``part``: numbers or arrays that fit each other.

    >>> on_parabola(0.5, 0.0, 3.0, 2.0)
    3.0
    """
    return middle + part * (after - before) / 2 + part**2 * ((after + before) / 2 - middle)


def crossing(before: float, middle: float, after: float) -> float:
    """Return the downward zero crossing of the parabola through three values one step apart, in steps after the middle.

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

    Places are counted in steps from the first value; a row of nan alone has neither.

    >>> place, height = tops(np.array([[0.0, 3.0, 2.0, 0.0], [5.0, 4.0, 3.0, 2.0]]))
    >>> place.tolist(), height.tolist()
    ([1.25, 0.0], [3.125, 5.0])
    """
    rows, last = np.arange(len(values)), values.shape[1] - 1
    heights = np.where(np.isnan(values), -np.inf, values)
    index = np.argmax(heights, axis=1)
    before, middle, after = (heights[rows, np.clip(index + step, 0, last)] for step in (-1, 0, 1))
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


ROUNDS = 60
"""Most halvings of an interval of length one; Newton's steps need about five rounds."""
CLOSE = 1e-14
"""Of the step; a root is known no better."""


def on_cubic(part: float, before: float, after: float, slope_before: float, slope_after: float) -> float:
    """Return the cubic's value at a part of the step, 0 to 1.

    Parameters
    ----------
    before, after : values at both ends.
    slope_before, slope_after : change per whole step at both ends.

    >>> on_cubic(0.5, 0.0, 1.0, 0.0, 2.0)  # part^2
    0.25
    """
    rise = after - before
    bend = 3 * rise - 2 * slope_before - slope_after
    twist = slope_before + slope_after - 2 * rise
    return before + part * (slope_before + part * (bend + part * twist))


def turn_on_cubic(before: float, after: float, slope_before: float, slope_after: float) -> float:
    """Return the part of the step where the cubic is level; its slopes at the ends must differ in sign.

    >>> turn_on_cubic(0.0, 0.0, 1.0, -1.0)
    0.5
    """
    rise = after - before
    linear = 2 * (3 * rise - 2 * slope_before - slope_after)
    square = 3 * (slope_before + slope_after - 2 * rise)
    sign = 1.0 if slope_before > 0 else -1.0
    root = math.sqrt(max(linear * linear - 4 * square * slope_before, 0.0))
    if sign * linear > 0 and square != 0:  # of the two ways to write the root, the one that subtracts nothing
        return min(1.0, -(linear + sign * root) / (2 * square))
    beside = root - sign * linear  # zero where the slopes are so small that their squares are
    return min(1.0, 2 * abs(slope_before) / beside) if beside > 0 else 0.0


def root_on_cubic(
    before: float, after: float, slope_before: float, slope_after: float, low: float, high: float
) -> float:
    """Return the part of the step between ``low`` and ``high`` where the cubic crosses zero, by guarded Newton steps.

    Parameters
    ----------
    low, high : parts of the step at which the cubic has different signs.

    >>> round(root_on_cubic(-1.0, 3.0, 0.0, 8.0, 0.0, 1.0), 12)  # 4 part^2 - 1
    0.5
    """
    rise = after - before
    bend = 3 * rise - 2 * slope_before - slope_after
    twist = slope_before + slope_after - 2 * rise
    rising = before + high * (slope_before + high * (bend + high * twist)) > 0
    part = (low + high) / 2
    for _ in range(ROUNDS):
        value = before + part * (slope_before + part * (bend + part * twist))
        if (value > 0) == rising:
            high = part
        else:
            low = part
        slope = slope_before + part * (2 * bend + part * 3 * twist)
        following = part - value / slope if slope != 0 else low
        if not low < following < high:
            following = (low + high) / 2
        if abs(following - part) <= CLOSE:
            return following
        part = following
    return part


def first_crossing(before: float, after: float, slope_before: float, slope_after: float) -> float:
    """Return the part of the step where the cubic first reaches zero, -1 where it does not; a start at zero is none.

    >>> round(first_crossing(1.0, -1.0, -2.0, -2.0), 12), first_crossing(1.0, 2.0, 1.0, 1.0)
    (0.5, -1.0)
    >>> round(first_crossing(0.0, -3.0, 1.0, -7.0), 9)  # part - 4 part^2
    0.25
    """
    turn, middle = 0.0, before
    if slope_before > 0 > slope_after or slope_before < 0 < slope_after:
        turn = turn_on_cubic(before, after, slope_before, slope_after)
        middle = on_cubic(turn, before, after, slope_before, slope_after)
        if middle == 0:  # it just touches, or the hop is too small for a number
            return turn
        if before > 0 > middle or before < 0 < middle:
            return root_on_cubic(before, after, slope_before, slope_after, 0.0, turn)
    if middle > 0 >= after or middle < 0 <= after:
        return root_on_cubic(before, after, slope_before, slope_after, turn, 1.0)
    return -1.0
