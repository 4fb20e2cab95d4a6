"""The compiled weights of places along a bat, and the expectation step of `place_learning` that sums over them."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import exp

WRONG, WRONG_RANGE = 0.01, 60.0
"""Part of the exit speeds taken as wrong readings, spread evenly over this many m/s, so that one cannot rule."""
FARTHEST = 5.0
"""Standard deviations of the place before the exit speed is known, beyond which no place counts."""
BLOCK = 512
"""Balls whose sums are worked out together: their terms stay in a core's own memory."""
ROOT_TWO_PI, HALF_ROOT = math.sqrt(2 * math.pi), math.sqrt(0.5)
A1, A2, A3, A4, A5 = 0.254829592, -0.284496736, 1.421413741, -1.453152027, 1.061405429
MIDDLE, SCATTER, SHARE, PRODUCT, SQUARE, EVIDENCE = range(6)
"""What is kept of a ball: mean and variance of its place; and over the places, times the chance that the reading is
right: that chance, exit speed times the table's, the table's squared; and the logarithm of its likelihood."""


@inner(error_model="numpy", fastmath={"contract", "nsz"})
def _bells(
    places: Array, fast: Array, out: float, spread: float, mean: float, width: float, level: float, work: Array
) -> None:
    """Fill, for every place, exit speed (0 for none), how far off it is, and both bells; four or eight at a time."""
    for k in range(len(places)):
        speed = fast[k] if fast[k] > 0 else 0.0
        beside = (places[k] - mean) / width
        off = (out - (1 + level) * speed) / spread
        here = exp(-0.5 * beside * beside)
        work[0, k], work[1, k], work[2, k] = speed, off, here if fast[k] > 0 else 0.0
        work[3, k] = exp(-0.5 * off * off)


@compiled(error_model="numpy", fastmath={"contract", "nsz", "reassoc"})
def weigh(
    places: Array, fast: Array, out: float, spread: float, mean: float, width: float, level: float, part: Array,
    work: Array,
) -> tuple[float, float, float, float]:  # fmt: skip
    """Fill how likely every place is, times a constant; places without an exit speed count nothing.

    The normal distribution is Abramowitz's and Stegun's 7.1.26, right to 8e-8 [abramowitz_stegun1964].

    ``fast``: m/s, exit speed at every place, NaN where none. ``out``, ``spread``: m/s, the exit speed and what it
    scatters by. ``mean``, ``width``: m, of the place before the exit speed is known. ``level``: exit speeds are 1 +
    level times the table's. Sums over places of what was filled and of what was known before; and of the latter times
    the chance of a lower exit speed, and times the table's exit speed.
    """
    _bells(places, fast, out, spread, mean, width, level, work)
    total, before, rank, sum_fast = 0.0, 0.0, 0.0, 0.0
    height = (1 - WRONG) / (spread * ROOT_TWO_PI)
    for k in range(len(places)):
        here, off, bell = work[2, k], work[1, k], work[3, k]
        t = 1.0 / (1.0 + 0.3275911 * HALF_ROOT * abs(off))
        tail = 0.5 * bell * t * (A1 + t * (A2 + t * (A3 + t * (A4 + t * A5))))
        part[k] = here * (height * bell + WRONG / WRONG_RANGE)
        total += part[k]
        before += here
        rank += here * (tail if off < 0 else 1 - tail)
        sum_fast += here * work[0, k]
    return total, before, rank, sum_fast


@compiled(nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
def fill_variances(covariance: Array, terms: Array, variances: Array) -> None:
    """Fill the variance of each ball's sum of terms by the doubt about its weights, shape (n,).

    ``covariance``: of the weights, shape (terms, terms), the same either way. ``terms``: shape (terms, n).
    """
    for first in range(0, len(variances), BLOCK):
        sums = variances[first : first + BLOCK]
        sums[:] = 0.0
        for row in range(len(terms)):
            mine = terms[row, first : first + BLOCK]
            for other in range(row + 1):
                its = terms[other, first : first + BLOCK]
                weight = covariance[row, other] * (1.0 if other == row else 2.0)
                for i in range(len(sums)):
                    sums[i] += weight * mine[i] * its[i]


@compiled(nogil=True, error_model="numpy", fastmath={"contract", "nsz", "reassoc"})
def fill_products(terms: Array, weight: Array, result: Array) -> None:
    """Fill the weighted sums over balls of all products of two terms, shape (terms, terms).

    ``terms``: shape (terms, n). ``weight``: of each ball, shape (n,).
    """
    result[:] = 0.0
    for first in range(0, len(weight), BLOCK):
        heavy = weight[first : first + BLOCK]
        for row in range(len(terms)):
            mine = heavy * terms[row, first : first + BLOCK]
            for other in range(row + 1):
                its = terms[other, first : first + BLOCK]
                total = 0.0
                for i in range(len(mine)):
                    total += mine[i] * its[i]
                result[row, other] += total
    for row in range(len(terms)):
        for other in range(row):
            result[other, row] = result[row, other]


@compiled(nogil=True, error_model="numpy")
def expect(places: Array, table: Array, out: Array, spread: Array, prior: Array, level: Array, result: Array) -> None:
    """Fill what is expected of every ball under given parameters.

    ``table``: (n, places) m/s, NaN where none. ``out``, ``spread``: (n,) m/s, exit speeds and what they scatter by.
    ``prior``: (n, 2) mean and standard deviation of the place. ``level``: (n,), exit speeds are 1 + level times the
    table's. ``result``: (n, 6).
    """
    work = np.empty((4, len(places)))
    for i in range(len(out)):
        _bells(places, table[i], out[i], spread[i], prior[i, 0], prior[i, 1], level[i], work)
        _expect(places, out[i], spread[i], prior[i, 0], prior[i, 1], work, result[i])


@inner(error_model="numpy", fastmath={"contract", "nsz", "reassoc"})
def _expect(places: Array, out: float, spread: float, mean: float, width: float, work: Array, result: Array) -> None:
    total, before, share, product, square, first, second = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    height = (1 - WRONG) / (spread * ROOT_TWO_PI)
    for k in range(len(places)):
        here, speed, beside = work[2, k], work[0, k], places[k] - mean
        here = here if abs(beside) < FARTHEST * width else 0.0
        right = here * height * work[3, k]
        both = right + here * (WRONG / WRONG_RANGE)
        before += here
        total += both
        first += both * beside
        second += both * beside * beside
        share += right
        product += right * speed
        square += right * speed * speed
    if not total > 0:
        for value in range(len(result)):
            result[value] = 0.0
        return
    result[MIDDLE] = mean + first / total
    result[SCATTER] = max(second / total - (first / total) ** 2, 0.0)
    result[SHARE], result[PRODUCT], result[SQUARE] = share / total, product * out / total, square / total
    result[EVIDENCE] = math.log(total / before)
