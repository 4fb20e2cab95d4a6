"""Intervals of groups' means that have bounds: those of a rate lie between 0 and 1, however few balls there are.

On the scale from 0 to 1 a group's mean theta is Beta distributed about mu with the concentration kappa, and a group's
balls tell of it as s = w n m successes in N = w n trials do; w is how many trials a ball is worth by its variance:
mu (1 - mu) - tau^2 over sigma^2, 1 for yes or no, more for a probability. Then theta is Beta(kappa mu + s,
kappa (1 - mu) + N - s), for the one is the other's conjugate, and its mean is that of the one-way analysis of
variance, mu + R (m - mu), for kappa = mu (1 - mu) / tau^2 - 1 gives R = N / (N + kappa).

How much groups differ is itself badly known where rates are near 0 or 1, and one kappa taken for true makes intervals
too narrow: where 300 groups of 3 to 120 balls have rates of 0.004 +- 0.002, such intervals of 90 % hold 70 % of them,
and these 91 %. So kappa is summed over, by the likelihood of all groups and a flat prior of tau / sqrt(mu (1 - mu))
[gelman2006]; the variance of mu comes on top, and the interval is that of the Beta distribution
with the mean and variance of all this. Groups that are too few to be pooled, or of which no ball or every ball
counts, have Jeffreys' intervals, Beta(s + 1/2, N - s + 1/2) [brown2001].
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import ENDS

Bounds = tuple[float, float]
"""The least and the greatest value that there can be."""
TAILS: Mapping[int, tuple[float, float]] = {50: (0.25, 0.75), 90: ENDS}
"""Parts of a distribution below the two ends of what holds so many percent."""
SPREADS: Array = 0.99 * (np.arange(1, 41) / 40) ** 1.5
"""tau over its greatest possible, sqrt(mu (1 - mu)), that are summed over: denser near zero, where it is mostly."""


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
        mean, variance = _summed(hits, trials, mu=mu)
    else:
        mean = (hits + 0.5) / (trials + 1)
        variance = mean * (1 - mean) / (trials + 2)
    kappa = mean * (1 - mean) / variance - 1
    ends = {}
    for percent, (lower, upper) in TAILS.items():
        below, above = (low + span * betaincinv(kappa * mean, kappa * (1 - mean), tail) for tail in (lower, upper))
        ends[percent] = (np.minimum(below, centre), np.maximum(above, centre))
    return span * np.sqrt(variance), ends


def _summed(hits: Array, trials: Array, *, mu: float) -> tuple[Array, Array]:
    """Return mean and variance of each group's rate, summed over how much groups may differ.

    Parameters
    ----------
    hits, trials : of each group, shape (g,); need not be whole.
    mu : rate of all.
    """
    from scipy.special import gammaln

    kappa = (1 / SPREADS**2 - 1)[:, None]
    alpha, beta = kappa * mu, kappa * (1 - mu)
    likely = gammaln(alpha + hits) - gammaln(alpha) + gammaln(beta + trials - hits) - gammaln(beta)
    total = np.sum(likely + gammaln(kappa) - gammaln(kappa + trials), axis=1)
    weight = np.exp(total - total.max()) * np.gradient(SPREADS)
    weight /= weight.sum()
    mean = (alpha + hits) / (kappa + trials)
    unsure = 1 / np.sum(trials * (kappa + 1) / (kappa + trials), axis=1, keepdims=True)  # of mu, over mu (1 - mu)
    scatter = mean * (1 - mean)
    variance = scatter / (kappa + trials + 1) + (kappa / (kappa + trials)) ** 2 * unsure * scatter
    middle = weight @ mean
    return middle, weight @ (variance + (mean - middle) ** 2)
