"""Two functions of a first answer that SciPy has too, whose import takes a fifth of its time."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.numerics.arrays import Array

NODES = 24
"""Of the integral of `bessel_j1` at x = 0: what is left out goes as J of the order 2 NODES."""


def normal_distribution(values: Array) -> Array:
    """Return the part of a standard normal distribution below each value, erfc(-x / sqrt 2) / 2.

    >>> normal_distribution(np.array([0.0, 1.6448536269514722])).round(12).tolist()
    [0.5, 0.95]
    """
    parts = [math.erfc(-value) / 2 for value in (np.ravel(values) / math.sqrt(2)).tolist()]
    return np.reshape(parts, np.shape(values))


def bessel_j1(values: Array) -> Array:
    """Return Bessel's function J_1(x) = (1 / pi) int_0^pi cos(t - x sin t) dt by the midpoint rule.

    The rule is exact up to J of an order that is 40 and more above |x|, below 1e-17.

    >>> bessel_j1(np.array([1.0, 10.0])).round(12).tolist()
    [0.440050585745, 0.043472746169]
    """
    nodes = NODES + math.ceil(float(np.abs(values).max(initial=0.0)) / 2)
    angle = math.pi * (np.arange(nodes) + 0.5) / nodes
    total = np.zeros_like(values)
    for place in angle.tolist():
        total += np.cos(place - values * math.sin(place))
    return total / nodes
