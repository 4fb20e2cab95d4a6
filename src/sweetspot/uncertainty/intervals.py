"""From answers of many draws to an interval beside each number, and to what each of them comes from.

The draws are standard normal numbers z and what followed from them. An answer is fitted, by least squares over the
draws, with Hermite polynomials of z up to the second degree, c0 + sum c_i z_i + sum c_ii (z_i^2 - 1) / sqrt 2 +
sum c_ij z_i z_j, which are orthonormal: its variance is the sum of the squares c^2, and the part that a source causes
alone is its first Sobol index, sum c^2 over the terms of that source only over the variance [sudret2008]. All of a
bat's unknowns, which depend on each other once the bat was weighed, are one source.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, REACH

TOGETHER = "together"
"""What sources cause only together with others, or more crookedly than the second degree."""


@dataclass(frozen=True)
class Reach:
    """The widths of an interval below and above its number, SI; shapes () or (n,) as the number's own."""

    below: Array
    above: Array


def interval_ends(values: Array) -> tuple[Array, Array]:
    """Return the ends of the 90 % interval of draws, shape (draws, ...); those that are not finite are left out."""
    if np.isfinite(values).all():  # most are, and many columns together take a tenth of the time
        low, high = np.quantile(values, ENDS, axis=0)
        return np.asarray(low), np.asarray(high)
    finite = np.isfinite(values).any(axis=0)
    with np.errstate(all="ignore"):
        low, high = np.nanquantile(np.where(finite, values, 0.0), ENDS, axis=0)
    return np.where(finite, low, np.nan), np.where(finite, high, np.nan)


def reach_of_draws(values: Array) -> Reach:
    """Return the reach of the interval of draws, shape (draws, ...), about the first, which is as described."""
    low, high = interval_ends(values[1:])
    return Reach(np.maximum(values[0] - low, 0.0), np.maximum(high - values[0], 0.0))


def variance_shares(normal: Array, names: Sequence[str], values: Array) -> dict[str, float]:
    """Return which part of the variance of an answer each source causes alone, the greatest first.

    ``normal``: independent standard normal numbers, shape (draws, n). ``values``: the answer to each draw, shape
    (draws,); those that are not finite are left out.

    >>> normal = np.random.default_rng(1).standard_normal((500, 2))
    >>> shares = variance_shares(normal, ("a", "b"), 3 * normal[:, 0] + normal[:, 1])
    >>> {name: round(share, 3) for name, share in shares.items()}  # 9 and 1 of 10
    {'a': 0.9, 'b': 0.1, 'together': 0.0}
    """
    finite = np.isfinite(values)
    z, answer = normal[finite], values[finite]
    count = z.shape[1]
    pairs = list(combinations(range(count), 2))
    terms = [(i,) for i in range(count)] * 2 + pairs
    together = [(z[:, i] * z[:, j])[:, None] for i, j in pairs]  # none where there is one source
    design = np.hstack([np.ones((len(z), 1)), z, (z**2 - 1) / np.sqrt(2), *together])
    normal_matrix, right = (
        design.T @ design,
        design.T @ (answer - answer.mean()),
    )  # nearly diagonal: terms are orthonormal
    coefficients = np.linalg.lstsq(normal_matrix, right, rcond=None)[0][1:]
    whole = max(float(np.var(answer)), float(coefficients @ coefficients), 1e-300)
    shares = dict.fromkeys(names, 0.0)
    for term, size in zip(terms, coefficients.tolist(), strict=True):
        sources = {names[index] for index in term}
        if len(sources) == 1:
            shares[sources.pop()] += size**2 / whole
    left = max(1.0 - sum(shares.values()), 0.0)
    return {**dict(sorted(shares.items(), key=lambda share: -share[1])), TOGETHER: left}


def linear_reach(values: Array) -> Reach:
    """Return the half widths of the interval of an answer that is linear in every source.

    ``values``: as described, then with every source one standard deviation up, then down, shape (1 + 2 * count, ...).
    """
    up, down = np.split(values[1:], 2)
    half = REACH * np.sqrt((((up - down) / 2) ** 2).sum(axis=0))
    return Reach(half, half)
