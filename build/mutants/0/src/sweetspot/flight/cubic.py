"""The cubic through both ends of a time step, given values and slopes there.

Plain arithmetic: the readable flight calls it as it is, the kernel compiles it.
"""

from __future__ import annotations

import math

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
    if sign * linear > 0:  # of the two ways to write the root, the one that subtracts nothing
        return min(1.0, -(linear + sign * root) / (2 * square))
    return min(1.0, 2 * abs(slope_before) / (root - sign * linear))


def root_on_cubic(
    before: float, after: float, slope_before: float, slope_after: float, low: float, high: float
) -> float:  # fmt: skip
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
