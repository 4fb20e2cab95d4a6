"""Finite elements of a line: straight between an element's ends, and inside it polynomials that vanish there.

On an element, s = -1..1 from its left end to its right one, the functions are (1 - s) / 2, (1 + s) / 2 and, inside, the
integrals of Legendre's polynomials of order p - 1 from -1 to s, times the root of (2 p - 1) / 2, p = 2 ... degree:
hierarchical, so that a higher degree leaves the lower functions as they are.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from numpy.polynomial import Legendre, Polynomial

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.gauss_legendre import rule


@cache
def polynomials(degree: int) -> tuple[Polynomial, ...]:
    """Return an element's functions as polynomials in s = -1..1, in the order left end, inside, right end.

    Parameters
    ----------
    degree : >= 1.

    >>> [float(one(0.0)) for one in polynomials(2)]
    [0.5, -0.6123724356957945, 0.5]
    """
    inside = []
    for order in range(2, degree + 1):
        legendre = Legendre.basis(order - 1).convert(kind=Polynomial)
        inside.append(legendre.integ(lbnd=-1) * math.sqrt((2 * order - 1) / 2))
    return Polynomial([0.5, -0.5]), *inside, Polynomial([0.5, 0.5])


@cache
def at_gauss_points(degree: int) -> tuple[Array, Array]:
    """Return values and slopes by s of an element's functions at its Gauss points, shape (points, functions)."""
    nodes, _ = rule()
    functions = polynomials(degree)
    return (
        np.array([function(nodes) for function in functions]).T,
        np.array([function.deriv()(nodes) for function in functions]).T,
    )


@cache
def powers(degree: int) -> Array:
    """Return the functions' coefficients of t^degree ... t^0, t = 0..1 along the element, shape (powers, functions)."""
    rows = [function(Polynomial([-1.0, 2.0])).coef for function in polynomials(degree)]
    return np.ascontiguousarray(np.array([np.pad(row, (0, degree + 1 - len(row)))[::-1] for row in rows]).T)
