"""Finite elements of a line: straight between an element's ends, and inside it polynomials that vanish there.

On an element, s = -1..1 from its left end to its right one, the functions are (1 - s) / 2, (1 + s) / 2 and, inside, the
integrals of Legendre's polynomials of order p - 1 from -1 to s, times the root of (2 p - 1) / 2, p = 2 ... degree:
hierarchical, so that a higher degree leaves the lower functions as they are.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import Legendre, Polynomial

from sweetspot.numerics.arrays import Array, IntArray
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


@dataclass(frozen=True, eq=False)
class Basis:
    """The functions of one degree on all elements of a line, which are continuous where elements meet.

    Parameters
    ----------
    edges : the elements' ends, m, increasing, shape (elements + 1,).
    degree : >= 1.
    """

    edges: Array
    degree: int

    @property
    def size(self) -> int:
        """How many unknowns there are."""
        return self.degree * (len(self.edges) - 1) + 1

    @property
    def numbers(self) -> IntArray:
        """Which unknown belongs to each function of each element, shape (elements, functions)."""
        first = self.degree * np.arange(len(self.edges) - 1)
        return np.asarray(first[:, None] + np.arange(self.degree + 1))

    @property
    def values(self) -> Array:
        """The functions at each element's Gauss points, shape (elements, points, functions)."""
        values, _ = at_gauss_points(self.degree)
        return np.broadcast_to(values, (len(self.edges) - 1, *values.shape))

    @property
    def slopes(self) -> Array:
        """Their derivatives along the line, 1/m, shape (elements, points, functions)."""
        _, slopes = at_gauss_points(self.degree)
        return np.asarray(slopes * (2 / np.diff(self.edges))[:, None, None])

    def number_at(self, place: float) -> int:
        """Return the unknown that is the value at the element end nearest to a place in m."""
        return self.degree * int(np.argmin(np.abs(self.edges - place)))

    def local_polynomials(self, vectors: Array) -> Array:
        """Return functions by their unknowns (size, n) as polynomials of t = 0..1, shape (degree + 1, elements, n)."""
        return np.asarray(np.einsum("pi,eim->pem", powers(self.degree), vectors[self.numbers]))


def gauss_places(edges: Array) -> tuple[Array, Array]:
    """Return places in m and weights in m of every element's Gauss points, both of shape (elements, points)."""
    nodes, weights = rule()
    half = np.diff(edges)[:, None] / 2
    return edges[:-1, None] + half * (nodes + 1), half * weights
