"""The compiled look-up in a bat's table; see `bat_surface`."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import sine_and_cosine

Axes = tuple[Array, Array, Array, Array]
TURNS = 12
"""Most steps of the search for the line of centres; started from the neighbouring place two or three are enough."""
CLOSE = 1e-5
"""rad by which the direction may miss."""


@inner(forceinline=True, error_model="numpy")
def part_of(nodes: Array, value: float) -> tuple[int, float]:
    """Return the node below a value of an even axis and how far on to the next it is; the straight line goes on."""
    at = (value - nodes[0]) / (nodes[1] - nodes[0])
    low = min(max(int(at), 0), len(nodes) - 2)
    return low, at - low


@inner(forceinline=True, error_model="numpy", fastmath={"contract", "nsz"})
def velocity_after(
    after: Array, place: int, speed: tuple[int, float], spin: tuple[int, float], at: float
) -> tuple[float, float, float, float]:
    """Return velocity after the hit over closing speed, back and up, and its changes per node of the line of centres.

    Parameters
    ----------
    speed, spin : node and part, from `part_of`.
    at : line of centres in nodes.
    """
    low = min(max(int(at), 0), after.shape[3] - 2)
    part = at - low
    i, pi = speed
    j, pj = spin
    back, up, back_2, up_2 = 0.0, 0.0, 0.0, 0.0
    for corner in range(4):
        a, b = corner >> 1, corner & 1
        weight = (pi if a else 1 - pi) * (pj if b else 1 - pj)
        line = after[i + a, j + b, place]
        back += weight * line[low, 0]
        up += weight * line[low, 1]
        back_2 += weight * line[low + 1, 0]
        up_2 += weight * line[low + 1, 1]
    return back + part * (back_2 - back), up + part * (up_2 - up), back_2 - back, up_2 - up


@inner(forceinline=True, error_model="numpy", fastmath={"contract", "nsz"})
def hit_towards(
    axes: Axes, after: Array, reach: float, place: int, there: float, ahead: float, up: float, tangent: float,
    cos: float, sin: float, guess: float,
) -> tuple[float, float, float]:  # fmt: skip
    """Return exit speed, offset and the line of centres in nodes of the hit that leaves in a direction.

    Parameters
    ----------
    there : bat speed at the place, m/s.
    ahead, up : pitch along the bat's path and square to it, m/s.
    tangent : spin of the pitch about the bat's axis times the ball's radius, m/s.
    cos, sin : of the angle by which the ball leaves the bat's path.
    guess : line of centres in nodes to begin with.

    Returns
    -------
    tuple
        NaN where no line of centres does it.
    """
    way, across = there - ahead, -up
    closing = math.sqrt(way * way + across * across)
    way, across = way / closing, across / closing
    speed, spin = part_of(axes[0], closing), part_of(axes[1], tangent / closing)
    last = after.shape[3] - 1.0
    at = min(max(guess, 0.0), last)
    for _ in range(TURNS):
        back, lift, d_back, d_lift = velocity_after(after, place, speed, spin, at)
        out = there + closing * (way * back - across * lift)
        high = closing * (across * back + way * lift)
        if not math.isfinite(out):
            return math.nan, math.nan, guess
        size = out * cos + high * sin
        miss = high * cos - out * sin
        if abs(miss) < CLOSE * abs(size):
            step = axes[3][1] - axes[3][0]
            sine, cosine = sine_and_cosine(axes[3][0] + at * step)
            offset = reach * (way * sine + across * cosine)
            return (size, offset, at) if size > 0 else (math.nan, math.nan, at)
        d_out = closing * (way * d_back - across * d_lift)
        d_high = closing * (across * d_back + way * d_lift)
        slope = d_high * cos - d_out * sin
        if not slope > 0:
            return math.nan, math.nan, guess
        before = at
        at = min(max(at - miss / slope, at - 12.0), at + 12.0)
        at = min(max(at, 0.0), last)
        low = min(max(int(before), 0), after.shape[3] - 2)
        inside = at - (before - miss / slope)
        if low <= at <= low + 1 and inside == 0.0:  # between two nodes all is a straight line: this step is exact
            size += (d_out * cos + d_high * sin) * (at - before)
            sine, cosine = sine_and_cosine(axes[3][0] + at * (axes[3][1] - axes[3][0]))
            offset = reach * (way * sine + across * cosine)
            return (size, offset, at) if size > 0 else (math.nan, math.nan, at)
        if at == before:
            return math.nan, math.nan, guess
    return math.nan, math.nan, guess


@compiled(nogil=True, error_model="numpy")
def look_up(axes: Axes, after: Array, reach: Array, arm: Array, given: Array, fast: Array, above: Array) -> None:
    """Fill exit speed in the plane and offset of n hits, straight lines between the table's places.

    Parameters
    ----------
    given : (6, n) bat speed, pitch ahead, pitch up, spin times the ball's radius, angle turned, place.
    """
    middle = (len(axes[3]) - 1) / 2
    for i in range(len(fast)):
        low, part = part_of(axes[2], given[5, i])
        part = min(max(part, 0.0), 1.0)
        total, over = 0.0, 0.0
        cos, sin = math.cos(given[4, i]), math.sin(given[4, i])
        guess = middle
        for k in range(2):
            size, offset, guess = hit_towards(
                axes, after, reach[low + k], low + k, given[0, i] * arm[low + k], given[1, i], given[2, i], given[3, i],
                cos, sin, guess,
            )  # fmt: skip
            weight = part if k else 1 - part
            total += weight * size
            over += weight * offset
        fast[i], above[i] = total, over


@compiled(nogil=True, error_model="numpy")
def fill_ceilings(
    axes: Axes, after: Array, arm: Array, nodes: tuple[Array, Array, Array], ceiling: Array, best: Array
) -> None:
    """Fill the greatest exit speed over bat speed, without spin, and the place where it is.

    Parameters
    ----------
    nodes : bat speed (m/s), pitch speed over it, and rad between the pitch's way and the bat's.
    """
    tops = np.empty(len(arm))
    spin = part_of(axes[1], 0.0)
    for i in range(len(nodes[0])):
        for j in range(len(nodes[1])):
            for k in range(len(nodes[2])):
                coming = nodes[1][j] * nodes[0][i]
                for place in range(len(arm)):
                    there = nodes[0][i] * arm[place]
                    way, across = there + coming * math.cos(nodes[2][k]), coming * math.sin(nodes[2][k])
                    closing = math.sqrt(way * way + across * across)
                    way, across = way / closing, across / closing
                    speed = part_of(axes[0], closing)
                    tops[place] = 0.0
                    for line in range(4 * after.shape[3] - 3):
                        back, lift, _, _ = velocity_after(after, place, speed, spin, line / 4)
                        out = there + closing * (way * back - across * lift)
                        high = closing * (across * back + way * lift)
                        if math.isfinite(out):
                            tops[place] = max(tops[place], math.sqrt(out * out + high * high))
                top = min(max(int(np.argmax(tops)), 1), len(arm) - 2)
                bend = tops[top - 1] - 2 * tops[top] + tops[top + 1]
                shift = (tops[top - 1] - tops[top + 1]) / (2 * bend) if bend < 0 else 0.0
                height = tops[top] - (tops[top - 1] - tops[top + 1]) ** 2 / (8 * bend) if bend < 0 else tops[top]
                ceiling[i, j, k] = height / nodes[0][i]
                best[i, j, k] = axes[2][0] + (top + shift) * (axes[2][1] - axes[2][0])
