"""Polynomials on the pieces of a line, and the cubic spline through points.

As `scipy.interpolate.PPoly` and `CubicSpline`, whose import alone takes a fifth of the first answer's time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sweetspot.numerics.arrays import Array

MANY = 512
"""Places from which on compiled code is faster, its loading included."""
RECENT = 6
"""Rows of fewer places whose values are kept, as every swing of a bat asks for its shapes at the same ones; a hollow
bat's take about 150 kB."""


@dataclass(frozen=True, eq=False)
class Piecewise:
    """Polynomials on the pieces of a line; the outermost ones go on beyond its ends.

    Parameters
    ----------
    coefficients : of the distance from each piece's left end, highest power first, shape (degree + 1, pieces, ...).
    ends : of the pieces, increasing, shape (pieces + 1,).
    """

    coefficients: Array
    ends: Array

    def __call__(self, position: ArrayLike, order: int = 0) -> Array:
        """Return the values at positions of shape (...), or their derivative; where pieces meet the right one holds.

        Parameters
        ----------
        order : of the derivative, >= 0.

        Returns
        -------
        Array
            of the positions' shape, then that of one value.

        >>> square = Piecewise(np.array([[1.0], [0.0], [0.0]]), np.array([0.0, 2.0]))
        >>> float(square(3.0)), float(square(3.0, 1))
        (9.0, 6.0)
        """
        places = np.asarray(position, float)
        if places.ndim != 1 or places.size >= MANY:
            return self._values(places, order)
        key = (order, places.tobytes())
        found = self._recent.get(key)
        if found is None:
            found = self._values(places, order)
            found.flags.writeable = False
            self._recent[key] = found
            for oldest in list(self._recent)[:-RECENT]:
                self._recent.pop(oldest, None)  # another thread may have been here too
        return found

    @cached_property
    def _recent(self) -> dict[tuple[int, bytes], Array]:
        """Values at the rows of places asked for last, by order and place; the oldest first."""
        return {}

    def _values(self, places: Array, order: int) -> Array:
        pieces = np.searchsorted(self.ends, places, side="right") - 1
        piece = np.minimum(np.maximum(pieces, 0), len(self.ends) - 2)  # as np.clip, in a third of its time
        part = (places - self.ends[piece]).reshape(places.shape + (1,) * (self.coefficients.ndim - 2))
        coefficients = self.derivative(order).coefficients if order else self.coefficients
        if coefficients.ndim <= 3 and places.size >= MANY:
            from sweetspot.numerics.many_polynomials import values_at

            return values_at(coefficients, piece, part)
        value = coefficients[0, piece]
        for row in coefficients[1:]:
            value = value * part + row[piece]
        return np.asarray(value)

    def derivative(self, order: int = 1) -> Piecewise:
        """Return the derivative of an order >= 1."""
        degree = len(self.coefficients) - 1
        if order > degree:
            return Piecewise(np.zeros((1, *self.coefficients.shape[1:])), self.ends)
        factors = np.array([math.perm(power, order) for power in range(degree, order - 1, -1)], float)
        shape = (-1,) + (1,) * (self.coefficients.ndim - 1)
        return Piecewise(self.coefficients[: degree + 1 - order] * factors.reshape(shape), self.ends)

    def roots(self) -> Array:
        """Return the zeros of one function between its ends, increasing; none of a stretch where it is zero throughout.

        >>> line = Piecewise(np.array([[1.0, 1.0], [-0.5, 0.5]]), np.array([0.0, 1.0, 2.0]))
        >>> line.roots()
        array([0.5])
        """
        width = np.diff(self.ends)
        powers = np.arange(len(self.coefficients) - 1, -1, -1)[:, None]
        sizes = np.abs(self.coefficients) * width**powers
        asked = np.flatnonzero(sizes[:-1].sum(axis=0) >= sizes[-1])
        roots = [np.zeros(0)]
        for piece, every in zip(asked, _roots_of_each(self.coefficients[:, asked]), strict=True):
            real = every.real[every.imag == 0]
            roots.append(self.ends[piece] + real[(real >= 0) & (real <= width[piece])])
        return np.unique(np.concatenate(roots))


def _roots_of_each(coefficients: Array) -> list[NDArray[np.generic]]:
    """Return the roots of each of many polynomials, highest power first, shape (degree + 1, n); as `np.roots` of each.

    Those of full degree are the eigenvalues of companion matrices, found together: many times faster than one by one.
    """
    degree = len(coefficients) - 1
    full = np.flatnonzero((coefficients[0] != 0) & (coefficients[-1] != 0)) if degree > 1 else np.zeros(0, int)
    companions = np.tile(np.eye(degree, k=-1), (len(full), 1, 1))
    companions[:, :1] = -(coefficients[1:, full] / coefficients[0, full]).T[:, None]
    together = dict(zip(full.tolist(), np.linalg.eigvals(companions), strict=True))
    return [together[i] if i in together else np.roots(coefficients[:, i]) for i in range(coefficients.shape[1])]


def cubic_spline(places: ArrayLike, values: ArrayLike) -> Piecewise:
    """Return the cubic spline through points, whose first two pieces are one cubic, and so its last two.

    Parameters
    ----------
    places : increasing, shape (n,), n >= 4.
    values : shape (n, ...).

    >>> spline = cubic_spline([0.0, 1.0, 2.0, 4.0], [0.0, 1.0, 8.0, 64.0])
    >>> round(float(spline(3.0)), 12)
    27.0
    """
    x, y = np.asarray(places, float), np.asarray(values, float)
    width = np.diff(x)
    wide = width.reshape((-1,) + (1,) * (y.ndim - 1))
    rise = np.diff(y, axis=0) / wide
    right = np.empty_like(y)
    # slopes s: second derivatives agree where two pieces meet, third derivatives at the second point from either end
    right[1:-1] = 3 * (wide[1:] * rise[:-1] + wide[:-1] * rise[1:])
    first, last = x[2] - x[0], x[-1] - x[-3]
    above, below = np.append(first, width[:-1]), np.append(width[1:], last)
    main = np.concatenate([width[1:2], 2 * (width[:-1] + width[1:]), width[-2:-1]])
    right[0] = ((width[0] + 2 * first) * width[1] * rise[0] + width[0] ** 2 * rise[1]) / first
    right[-1] = (width[-1] ** 2 * rise[-2] + (2 * last + width[-1]) * width[-2] * rise[-1]) / last
    slope = _tridiagonal(above, main, below, right.reshape(len(x), -1)).reshape(y.shape)
    bend = (slope[:-1] + slope[1:] - 2 * rise) / wide
    return Piecewise(np.stack([bend / wide, (rise - slope[:-1]) / wide - bend, slope[:-1], y[:-1]]), x)


def _tridiagonal(above: Array, main: Array, below: Array, right: Array) -> Array:
    """Return the solution of a tridiagonal system, shape (n, columns) as that of ``right``, by elimination.

    Rows are not exchanged: a spline's need not be. The import of SciPy's solver takes a tenth of a first answer's
    time, and a dense solve wakes the threads of BLAS, which takes a hundred times as long as the work.
    """
    pivot, factor, solved = main.tolist(), [], right.copy()
    for row, (over, under) in enumerate(zip(above.tolist(), below.tolist(), strict=True)):
        factor.append(under / pivot[row])
        pivot[row + 1] -= factor[row] * over
        solved[row + 1] -= factor[row] * solved[row]
    solved[-1] /= pivot[-1]
    for row in range(len(pivot) - 2, -1, -1):
        solved[row] = (solved[row] - above[row] * solved[row + 1]) / pivot[row]
    return solved
