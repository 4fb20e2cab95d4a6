"""Many beams that one description may mean, followed from a few that are solved.

What a beam answers is smooth in the independent standard normal numbers z behind its deviations. It is followed by
f(z) = f0 + sum_i (a_i z_i + b_i z_i^2 + c_i z_i^3 + d_i z_i^4) + sum_i<j e_ij z_i z_j, whose coefficients are those
that go through the beams solved: the one described, each number alone at 1 and `FAR` standard deviations to either
side, and each pair at one, both up or both down in turn, as all of one sign would add up what the third degree leaves
out. A model of n numbers takes 1 + 4 n + n (n - 1) / 2 beams, 73 of wood and 100 of alloy, in place of 1,024 draws.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import numpy as np

from sweetspot.dynamics.batch.bending import BendingBatch
from sweetspot.numerics.arrays import Array

FAR = 2.2
"""Standard deviations at which a number alone is solved beside 1: beyond it lie 3 of 100 draws."""


def places_to_solve(count: int) -> Array:
    """Return the numbers behind every beam that is solved, shape (beams, count), the described one first.

    >>> len(places_to_solve(9)), len(places_to_solve(11))
    (73, 100)
    """
    unit = np.eye(count)
    alone = [np.zeros((1, count)), unit, -unit, FAR * unit, -FAR * unit]
    pairs = [(-1.0) ** (i + j) * (unit[i] + unit[j]) for i, j in combinations(range(count), 2)]
    return np.vstack([*alone, np.reshape(pairs, (-1, count))])


def _terms(normal: Array) -> Array:
    """Return the model's terms, shape (rows, terms) for numbers of shape (rows, count)."""
    pairs = [(normal[:, i] * normal[:, j])[:, None] for i, j in combinations(range(normal.shape[1]), 2)]
    powers = [normal**power for power in (1, 2, 3, 4)]
    return np.hstack([np.ones((len(normal), 1)), *powers, *pairs])


@dataclass(frozen=True)
class FollowedBeams:
    """Many beams by those that were solved; answers as `BendingBatch` does.

    Parameters
    ----------
    solved : the beams of `places_to_solve`.
    normal : numbers behind every beam that is asked for, shape (beams, count).
    """

    solved: BendingBatch
    normal: Array

    def __len__(self) -> int:
        return len(self.normal)

    @cached_property
    def mass(self) -> Array:
        """Return kg, shape (beams,)."""
        return self._positive(self.solved.mass)

    @cached_property
    def balance_point(self) -> Array:
        """Return m from the knob end, shape (beams,)."""
        return self._positive(self.solved.balance_point)

    @cached_property
    def moi_cm(self) -> Array:
        """Return kg m^2 about an axis across the balance point, shape (beams,)."""
        return self._positive(self.solved.moi_cm)

    @cached_property
    def roll_moi(self) -> Array:
        """Return kg m^2 about the beam's own line, shape (beams,)."""
        return self._positive(self.solved.roll_moi)

    @cached_property
    def omega(self) -> Array:
        """Return rad/s of the bending modes, shape (beams, modes)."""
        return self._positive(self.solved.omega)

    @cached_property
    def damping_ratio(self) -> Array:
        """Return the damping ratio, shape (beams,); nothing that is unknown changes it."""
        return np.full(len(self), self.solved.damping_ratio[0])

    def moi(self, axis: Array | float) -> Array:
        """Return moments of inertia in kg m^2 about axes across the beams, m from the knob end, shape (beams,)."""
        return np.asarray(self.moi_cm + self.mass * (axis - self.balance_point) ** 2)

    def shapes_at(self, position: Array) -> Array:
        """Return rigid motions and modes at places (beams, places) in m, shape (beams, places, modes + 2)."""
        return self._along(position, lambda places: _alike(self.solved.shapes_at(places)))

    def left_out_at(self, position: Array) -> Array:
        """Return the residual compliance of the modes at places (beams, places) in m, m/N."""
        return self._along(position, self.solved.left_out_at)

    def _along(self, position: Array, answer: Callable[[Array], Array]) -> Array:
        """Return an answer of the beams at their own places, or at one row of places for all."""
        if not np.ptp(position, axis=0).any():
            return self._followed(answer(np.tile(position[:1], (len(self.solved), 1))))
        each = answer(np.tile(position.reshape(1, -1), (len(self.solved), 1)))
        every = each.reshape(len(self.solved), *position.shape, *each.shape[2:])
        return np.asarray(np.einsum("bs,sb...->b...", self._weights, every))

    @cached_property
    def _weights(self) -> Array:
        """Weight of every solved beam in every one that is asked for, shape (beams, solved)."""
        solved = _terms(places_to_solve(self.normal.shape[1]))
        return np.asarray(np.linalg.solve(solved.T, _terms(self.normal).T).T)

    def _followed(self, values: Array) -> Array:
        """Return values of the beams from those of the solved ones, shapes (solved, ...) and (beams, ...)."""
        flat = self._weights @ values.reshape(len(values), -1)
        return np.asarray(flat.reshape(len(self), *values.shape[1:]))

    def _positive(self, values: Array) -> Array:
        """Return the same of what is above zero, whose logarithm is straighter: a product of what is unknown."""
        return np.asarray(np.exp(self._followed(np.log(values))))


def _alike(shapes: Array) -> Array:
    """Return shapes of modes (solved, places, modes) with the signs of the first beam's."""
    signs = np.where(np.einsum("bpn,pn->bn", shapes, shapes[0]) < 0, -1.0, 1.0)
    return np.asarray(shapes * signs[:, None, :])
