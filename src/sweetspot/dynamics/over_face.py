"""Smooth functions over a face that is symmetric about its line: splines along it and across it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise, cubic_spline


@dataclass(frozen=True, eq=False)
class OverFace:
    """Functions of position and lateral place.

    Parameters
    ----------
    along : values at columns from one edge to the other by position in m, shape (columns, ...).
    half_width : m, from the line to the edge, by position in m.
    across : cardinal splines of the columns by the lateral place over ``half_width``, -1 to 1, shape (columns,).
    """

    along: Piecewise
    half_width: Piecewise
    across: Piecewise

    @classmethod
    def through(cls, x: Array, half_width: Array, values: Array) -> OverFace:
        """Return the functions through values at rows of places.

        Parameters
        ----------
        x, half_width : m, of every row, increasing, shape (rows,).
        values : at even columns from one edge to the other, shape (rows, columns, ...).
        """
        columns = np.linspace(-1.0, 1.0, values.shape[1])
        straight = Piecewise(np.stack([np.diff(half_width) / np.diff(x), half_width[:-1]]), x)
        return cls(cubic_spline(x, values), straight, cubic_spline(columns, np.eye(len(columns))))

    def __call__(self, position: Array, lateral: Array | float = 0.0) -> Array:
        """Return the values at places in m of shape (...), shape (..., functions); beyond the edge those of it."""
        along = np.asarray(self.along(position))
        part = np.clip(lateral / np.asarray(self.half_width(position)), -1.0, 1.0)
        weights = np.asarray(self.across(part))
        return np.asarray(np.einsum("...c,...cn->...n", weights, along))

    def holds(self, position: Array, lateral: Array) -> Array:
        """Return whether places lie on it, shape (...)."""
        return np.asarray(np.abs(lateral) <= np.asarray(self.half_width(position)) * (1 + 1e-12))

    @property
    def middle(self) -> Piecewise:
        """Values on the line by position in m."""
        return Piecewise(self.along.coefficients[:, :, self.along.coefficients.shape[2] // 2], self.along.ends)
