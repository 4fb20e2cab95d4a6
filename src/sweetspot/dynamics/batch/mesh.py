"""Pieces of many beams in one row: where each beam begins and ends, and the places within its pieces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array, IntArray


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
        """Where every piece begins, m, shape (pieces,)."""
        return self.ends[self._inner]

    @property
    def width(self) -> Array:
        """How long every piece is, m, shape (pieces,)."""
        return np.diff(self.ends)[self._inner[:-1]]

    @property
    def owner(self) -> IntArray:
        """Whose every piece is, shape (pieces,)."""
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
