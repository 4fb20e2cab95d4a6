"""Small least-squares problems of a first answer, without the import of SciPy's optimizers, a third of its time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sweetspot.numerics.arrays import Array

ZERO = 1e-12
"""Of the greatest gradient at the start, below which one counts as zero."""
ROUNDS = 3
"""Most exchanges of each unknown with zero."""


def nonnegative_least_squares(system: Array, right: Array) -> Array:
    """Return x >= 0 with the least |system x - right|, by active sets [lawson1995, ch. 23, algorithm NNLS].

    Parameters
    ----------
    system : shape (rows, n).
    right : shape (rows,).

    >>> nonnegative_least_squares(np.eye(2), np.array([2.0, -1.0])).tolist()
    [2.0, 0.0]
    """
    count = system.shape[1]
    x, free = np.zeros(count), np.zeros(count, bool)
    least = ZERO * max(float(np.abs(system.T @ right).max(initial=0.0)), 1e-300)
    for _ in range(ROUNDS * count):
        gradient = np.where(free, -np.inf, system.T @ (right - system @ x))
        entering = int(np.argmax(gradient))
        if not gradient[entering] > least:
            return x
        free[entering] = True
        while True:
            best = np.zeros(count)
            best[free] = np.linalg.lstsq(system[:, free], right)[0]
            if not np.any(free & (best <= 0)):
                break
            if best[entering] <= 0:  # by rounding alone: it does not enter
                return x
            leaving = free & (best <= 0)
            part = float(np.min(x[leaving] / (x[leaving] - best[leaving])))
            x = np.where(free, x + part * (best - x), 0.0)
            free &= x > ZERO * np.abs(x).max()
            x = np.where(free, x, 0.0)
        x = best
    return x


STEPS = 12
"""Of Gauss and Newton at most; what takes more is not straight enough."""


def nearly_straight_least_squares(
    misses: Callable[[Array], Array], slopes: Callable[[Array], Array], count: int, *, farthest: float, close: float
) -> Array | None:
    """Return x with the least sum of squared misses by the steps of Gauss and Newton from 0; None where they fail.

    They fail where a step leaves the limits, or does not lower the sum.

    Parameters
    ----------
    misses, slopes : of x: shape (m,), and their derivatives, shape (m, count).
    farthest : limit of every |x|.
    close : length of a step, in the unit of x, that ends it.

    >>> found = nearly_straight_least_squares(
    ...     lambda x: np.exp(x) - 1.1, lambda x: np.diag(np.exp(x)), 1, farthest=1.0, close=1e-9
    ... )
    >>> round(float(np.exp(found[0])), 9)
    1.1
    """
    x = np.zeros(count)
    off = misses(x)
    for _ in range(STEPS):
        step = np.linalg.lstsq(slopes(x), -off)[0]
        following = x + step
        if not np.all(np.abs(following) < farthest):
            return None
        next_off = misses(following)
        if not next_off @ next_off <= off @ off * (1 + ZERO):
            return None
        x, off = following, next_off
        if np.abs(step).max() < close:
            return x
    return None
