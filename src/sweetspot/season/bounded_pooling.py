"""Intervals of groups' means that have bounds: those of a rate lie between 0 and 1, however few balls there are.

On the scale from 0 to 1 a group's mean theta is Beta distributed about mu with the concentration kappa, and a group's
balls tell of it as s = w n m successes in N = w n trials do; w is how many trials a ball is worth by its variance:
mu (1 - mu) - tau^2 over sigma^2, 1 for yes or no, more for a probability. Then theta is Beta(kappa mu + s,
kappa (1 - mu) + N - s), for the one is the other's conjugate, and its mean is that of the one-way analysis of
variance, mu + R (m - mu), for kappa = mu (1 - mu) / tau^2 - 1 gives R = N / (N + kappa).

How much groups differ is itself badly known, most of all where rates are near 0 or 1, and one kappa taken for true
makes intervals too narrow. So kappa is summed over, by the likelihood of all groups. With it goes mu: of each kappa it
is the groups' weighted mean, whose variance comes on top, and the likelihood is summed over it by Laplace's rule. The
prior is flat in 1 / (1 + r), r = kappa times mu or 1 - mu, the smaller, as that of numbers of events is
[christiansen1997]: flat in tau^2 (`likely_spreads`) while groups differ by less than the way to the nearer bound, and
populations that crowd at a bound are as likely as others. The interval is that of the Beta distribution with the mean
and variance of all this. Groups that are too few to be pooled, or of which no ball or every ball counts, have Jeffreys'
intervals, Beta(s + 1/2, N - s + 1/2) [brown2001].
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import ENDS
from sweetspot.season.likely_spreads import spread_weights

Bounds = tuple[float, float]
"""The least and the greatest value that there can be."""
TAILS: Mapping[int, tuple[float, float]] = {50: (0.25, 0.75), 90: ENDS}
"""Parts of a distribution below the two ends of what holds so many percent."""
MOST = 0.99
"""Greatest tau that is summed over, over its greatest possible, sqrt(mu (1 - mu))."""


@dataclass(frozen=True)
class Scatter:
    """How balls and groups scatter about the mean of all: mu, sigma^2, tau^2; whether groups are enough to pool."""

    mean: float
    within: float
    between: float
    pooled: bool


def bounded_intervals(
    counts: Array, means: Array, centre: Array, scatter: Scatter, *, bounds: Bounds
) -> tuple[Array, dict[int, tuple[Array, Array]]]:
    """Return the standard deviation of each group's mean, and the ends of its intervals by their percent.

    An interval always holds the centre.

    Parameters
    ----------
    counts : balls of each group, > 0, shape (g,).
    means : of the groups, within the bounds.
    centre : what is told of each group.
    scatter : of balls and groups.
    bounds : least and greatest value.
    """
    from scipy.special import betaincinv

    low, span = bounds[0], bounds[1] - bounds[0]
    rates, mu = np.clip((means - low) / span, 0, 1), (scatter.mean - low) / span
    room, within = mu * (1 - mu) - scatter.between / span**2, scatter.within / span**2
    trials = counts * max(room / within if within > 0 else 1.0, 1.0)
    hits = trials * rates
    if scatter.pooled and 0 < mu < 1:  # else nothing tells how much groups differ
        mean, variance = _summed(hits, trials)
    else:
        mean = (hits + 0.5) / (trials + 1)
        variance = mean * (1 - mean) / (trials + 2)
    kappa = mean * (1 - mean) / variance - 1
    ends = {}
    for percent, (lower, upper) in TAILS.items():
        below, above = (low + span * betaincinv(kappa * mean, kappa * (1 - mean), tail) for tail in (lower, upper))
        ends[percent] = (np.minimum(below, centre), np.maximum(above, centre))
    return span * np.sqrt(variance), ends


def _summed(hits: Array, trials: Array) -> tuple[Array, Array]:
    """Return mean and variance of each group's rate, summed over how much groups may differ.

    Parameters
    ----------
    hits, trials : of each group, shape (g,); need not be whole; neither none nor all of them hits.
    """
    from scipy.special import gammaln

    def population(spreads: Array) -> tuple[Array, Array, Array]:
        """Return kappa, mu and its variance at some tau over the greatest possible, each of shape (k, 1)."""
        kappa = (1 / spreads**2 - 1)[:, None]
        weight = trials / (kappa + trials)
        mu = np.sum(weight * hits / trials, axis=1, keepdims=True) / weight.sum(axis=1, keepdims=True)
        return kappa, mu, mu * (1 - mu) / ((kappa + 1) * weight.sum(axis=1, keepdims=True))

    def likelihood(spreads: Array) -> Array:
        kappa, mu, unsure = population(spreads)
        alpha, beta = kappa * mu, kappa * (1 - mu)
        told = gammaln(alpha + hits) - gammaln(alpha) + gammaln(beta + trials - hits) - gammaln(beta)
        total = np.sum(told + gammaln(kappa) - gammaln(kappa + trials), axis=1) + 0.5 * np.log(unsure[:, 0])
        nearer = np.minimum(mu, 1 - mu)[:, 0]
        return np.asarray(total + np.log(nearer / spreads**3) - 2 * np.log1p(kappa[:, 0] * nearer))

    spreads, part = spread_weights(likelihood, most=MOST)
    kappa, mu, unsure = population(spreads)
    mean = (kappa * mu + hits) / (kappa + trials)
    variance = mean * (1 - mean) / (kappa + trials + 1) + (kappa / (kappa + trials)) ** 2 * unsure
    middle = part @ mean
    return middle, part @ (variance + (mean - middle) ** 2)
