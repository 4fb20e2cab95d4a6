"""Pieces of many beams in one row: where each beam begins and ends, and into how many elements its pieces are cut.

Finite elements of a line: straight between an element's ends, and inside it polynomials that vanish there.

On an element, s = -1..1 from its left end to its right one, the functions are (1 - s) / 2, (1 + s) / 2 and, inside, the
integrals of Legendre's polynomials of order p - 1 from -1 to s, times the root of (2 p - 1) / 2, p = 2 ... degree:
hierarchical, so that a higher degree leaves the lower functions as they are.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.polynomial import Legendre, Polynomial
from numpy.typing import NDArray

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


ELEMENTS = 16
"""Elements at least for a dozen modes; every bat of the catalogue then has twelve converged to 4e-4 and the first five
to 1e-4. Four dozen on a badminton racket need as many for each: with 29 in all they missed up to 6e-4 of q."""
MODES = 12
WIDENING, WIDENING_OF_SHORT = 0.4, 1.4
"""By how much of its thin end a piece may widen within one element, the second of pieces shorter than half an element,
which bend little. Between a handle of 16 mm and a barrel one element left the first mode 2e-4 too quick, and what was
missed of that slow mode's give counted as give at once, up to 0.018 of q; it is now about 1e-5."""
CLOSEST = 1e-6
"""m; ends nearer to each other than this are one: an element between them would only hold rounding."""


@dataclass(frozen=True)
class Mesh:
    """Ends of pieces, beam after beam.

    Parameters
    ----------
    ends : m from the knob end, increasing within a beam, shape (pieces + beams,).
    first : index of every beam's first end, and the number of all ends, shape (beams + 1,).
    """

    ends: Array
    first: IntArray

    def __len__(self) -> int:
        return len(self.first) - 1

    @property
    def first_piece(self) -> IntArray:
        """Index of every beam's first piece, and the number of all pieces, shape (beams + 1,)."""
        return self.first - np.arange(len(self.first))

    @property
    def left(self) -> Array:
        """Start of every piece, m, shape (pieces,)."""
        return self.ends[self._inner]

    @property
    def width(self) -> Array:
        """Length of every piece, m, shape (pieces,)."""
        return np.diff(self.ends)[self._inner[:-1]]

    @property
    def owner(self) -> IntArray:
        """Owner of every piece, shape (pieces,)."""
        return np.repeat(np.arange(len(self)), np.diff(self.first_piece))

    @property
    def _inner(self) -> NDArray[np.bool_]:
        """Whether every end is one where a piece begins."""
        inner = np.ones(len(self.ends), bool)
        inner[self.first[1:] - 1] = False
        return inner

    def divided(self, longest: Array, *, slack: float = 0.0, least: IntArray | None = None) -> Mesh:
        """Return the mesh with its pieces cut into equal ones.

        Parameters
        ----------
        longest : m that a piece of each beam may be long, shape (beams,).
        slack : part of ``longest`` by which a piece may be longer for rounding.
        least : into how many at least each piece is cut, shape (pieces,); None: one.
        """
        owner, width = self.owner, self.width
        parts = np.maximum(1 if least is None else least, np.ceil(width / longest[owner] - slack)).astype(np.int64)
        whole = np.repeat(np.arange(len(parts)), parts)
        number = np.arange(len(whole)) - np.repeat(np.cumsum(parts) - parts, parts)
        left = self.left[whole] + number * (width / parts)[whole]
        counts = np.bincount(owner, weights=parts, minlength=len(self)).astype(np.int64)
        first = np.concatenate([[0], np.cumsum(counts + 1)])
        ends = np.empty(first[-1])
        inner = np.ones(len(ends), bool)
        inner[first[1:] - 1] = False
        ends[inner], ends[first[1:] - 1] = left, self.ends[self.first[1:] - 1]
        return Mesh(ends, first)


def mesh_of(rows: list[Array]) -> Mesh:
    """Return the mesh of beams whose ends are given one by one."""
    return Mesh(np.concatenate(rows), np.concatenate([[0], np.cumsum([len(row) for row in rows])]))


def apart(ends: list[float]) -> tuple[float, ...]:
    """Return increasing ends without those that are as good as the one before; the first and the last stay."""
    apart = [ends[0]]
    apart += [end for before, end in pairwise(ends[:-1]) if end - before > CLOSEST and ends[-1] - end > CLOSEST]
    return (*apart, ends[-1])


def least_elements(count: int) -> int:
    """Return the least number of elements for ``count`` modes: `ELEMENTS` for every dozen."""
    return ELEMENTS * -(-count // MODES)


def least_parts(bending_stiffness: Array, width: Array) -> IntArray:
    """Return into how many elements pieces must be cut at least, for how much they widen.

    Parameters
    ----------
    bending_stiffness : EI in N m^2 at their left and their right ends, shape (2, pieces); its fourth root is taken for
        their width.
    width : of the pieces, in elements, shape (pieces,).

    >>> least_parts(np.array([[1.0, 1.0, 1.0], [1.0, 16.0, 16.0]]), np.array([1.0, 0.2, 1.0])).tolist()
    [1, 1, 3]
    """
    widening = np.exp(np.abs(np.log(bending_stiffness[1] / bending_stiffness[0])) / 4) - 1
    allowed = np.where(width < 0.5, WIDENING_OF_SHORT, WIDENING)
    return np.asarray(np.maximum(1, np.ceil(widening / allowed)), np.int64)
