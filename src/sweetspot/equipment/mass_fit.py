"""Distribution of an implement's mass along it, when only weight, balance and swing weight were measured.

`tilt`: mu(x) = base(x) exp(a + b z + c z^2), z = 2 x / L - 1: of all distributions that have the three measured
values, the one that departs least from the drawn one (least relative entropy). It is positive everywhere, whatever was
measured.

`least_departure`: where the drawing is to be trusted as far as measurements do not contradict it, how much less or more
mass must lie where the drawing may be wrong.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.least_squares import nonnegative_least_squares

TRIALS = 60
FEASIBLE = 1e-9
"""Residual of the non-negative least squares, at most 1, below which inequalities contradict each other."""
GREATEST_RATIO = 1e4
"""Between the densest and the lightest place against the drawn one; more means that the measurements are wrong."""


def maximum_entropy_mass(
    base: Callable[[Array], Array], *, places: Array, weights: Array, length: float, targets: Array
) -> Array:
    """Return (a, b, c) for which integral mu (1, z, z^2) dx has the given values.

    Raises `InputError` when no smooth distribution has them.

    Parameters
    ----------
    base : drawn mass per length, > 0, at positions in m.
    places, weights : quadrature over the implement, m.
    length : L in m.
    targets : the three integrals, kg.
    """
    powers = np.vander(2 * places / length - 1, 3, increasing=True)
    drawn = weights * base(places)
    unknowns = np.array([np.log(targets[0] / drawn.sum()), 0.0, 0.0])
    for _ in range(TRIALS):
        density = drawn * np.exp(powers @ unknowns)
        miss = targets - powers.T @ density
        if np.abs(miss).max() < 1e-14 * targets[0]:
            return unknowns
        step = np.linalg.solve(powers.T @ (density[:, None] * powers), miss)
        unknowns = unknowns + step / max(1.0, np.abs(step).max())  # Newton, at most a factor e at once
        if np.ptp(powers @ unknowns) > np.log(GREATEST_RATIO):
            break
    else:
        if np.abs(miss).max() < 1e-10 * targets[0]:
            return unknowns
    raise InputError(
        "no plausible distribution of mass has this weight, balance point and swing weight together; check the units, "
        "and about which axis the swing weight was measured"
    )


@dataclass(frozen=True)
class Correction:
    """A way in which an implement may differ from its drawing, its mass unchanged.

    Parameters
    ----------
    effects : what one unit of it adds to every measured quantity.
    usual : how much of it is usual; corrections share the work in proportion to its square and their effect.
    limits : how much of it there can be, 0 within.
    """

    effects: tuple[float, ...]
    usual: float
    limits: tuple[float, float]


def least_departure(corrections: Sequence[Correction], *, misses: Array, scatter: Array) -> Array | None:
    """Return the least corrections that bring all misfits within what measurements scatter, None where none do.

    Minimises sum (u / usual)^2 with |miss - effects u| <= scatter and u within its limits: least distance programming,
    solved by non-negative least squares [lawson1995, ch. 23].

    Parameters
    ----------
    corrections : at least one.
    misses : measured less drawn, one a measured quantity.
    scatter : by how much each may disagree, > 0.

    >>> one = Correction(effects=(2.0,), usual=1.0, limits=(-5.0, 5.0))
    >>> least_departure([one], misses=np.array([3.0]), scatter=np.array([1.0])).round(12)
    array([1.])
    >>> least_departure([one], misses=np.array([30.0]), scatter=np.array([1.0])) is None
    True
    """
    usual, effects, low, high = _arrays(corrections)
    identity = np.eye(len(usual))
    sides = np.vstack([effects / scatter[:, None], -effects / scatter[:, None], identity, -identity])
    bounds = np.concatenate([misses / scatter - 1, -misses / scatter - 1, low, -high])
    if np.all(bounds <= 0):
        return np.zeros(len(usual))
    system = np.vstack([sides.T, bounds])
    aim = np.append(np.zeros(len(usual)), 1.0)
    residual = system @ nonnegative_least_squares(system, aim) - aim
    if np.linalg.norm(residual) < FEASIBLE:
        return None
    return np.asarray(-residual[:-1] / residual[-1] * usual)


def nearest(corrections: Sequence[Correction], *, misses: Array, scatter: Array) -> Array:
    """Return the corrections within their limits that leave the least misfit, by the sum of squares over scatter.

    >>> one = Correction(effects=(2.0,), usual=1.0, limits=(-5.0, 5.0))
    >>> nearest([one], misses=np.array([30.0]), scatter=np.array([1.0])).round(6)
    array([5.])
    """
    from scipy.optimize import lsq_linear

    usual, effects, low, high = _arrays(corrections)
    return np.asarray(lsq_linear(effects / scatter[:, None], misses / scatter, bounds=(low, high)).x * usual)


def _arrays(corrections: Sequence[Correction]) -> tuple[Array, Array, Array, Array]:
    """Return usual amounts, effects (quantity, correction) and limits, the last three in units of the usual amounts."""
    usual = np.array([correction.usual for correction in corrections])
    low, high = np.array([correction.limits for correction in corrections]).T / usual
    return usual, np.array([correction.effects for correction in corrections]).T * usual, low, high
