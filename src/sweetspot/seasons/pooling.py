"""Means of groups, partly pooled: few balls pull a player towards all others, many leave him where he is.

Balls y of group j are normal about theta_j with variance sigma^2, and theta_j about mu with variance tau^2, both learnt
from all groups (one-way analysis of variance). Then theta_j given n balls of mean m has the mean
mu + R (m - mu) and the variance tau^2 (1 - R), R = tau^2 / (tau^2 + sigma^2 / n), which is the reliability at n balls:
the correlation to be expected between two halves of n balls each.

Neither variance is known well, of a few groups, or a few balls each, least of all. So the intervals sum over tau, by
the likelihood of all groups (`spread_weights`): each tau says what a group's mean is and how surely it is known, and an
interval has the mean and variance of all of them [kass1989]. It is Student's, with as many degrees of freedom as sigma
has. A group's estimate is still mu + R (m - mu), which the interval always holds. Fewer than `FEWEST_GROUPS` tell
nothing of tau: nothing is pooled there, and reliability is missing. One ball a group tells nothing of sigma: then
intervals are missing too, for any would be a guess.

What has bounds, as a rate has 0 and 1, has intervals within them (`bounded_intervals`), and those also of one ball
each, for yes or no says by itself how it scatters. What is only never negative, as a distance, has those of the gamma
distribution with the same mean and variance: they begin above 0, and of groups with few balls they are as long upwards
as such means scatter.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import polars as pl

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, REACH, Interval

NODES = 24
"""Values that are summed over; two to three within a standard deviation of tau."""
LEFT_OUT = 10.0
"""Logarithm of the likelihood below its greatest from which on a value is left out."""
CLOSER = 2
"""Refinements of the values about the likely ones."""


def spread_weights(likelihood: Callable[[Array], Array], *, most: float) -> tuple[Array, Array]:
    """Return values of tau, shape (k,), and their weights, as the spread of groups is not known.

    The prior is flat in the variance tau^2. It has no scale of its own, the means it leads to are better than plain
    ones however groups differ [morris2012], and its intervals hold in repeated leagues about as often as they say
    [tak2017]. One flat in tau [gelman2006] makes them too narrow where groups differ by less than their means
    scatter: of 60 groups whose R is 0.4 those of a rate hold 84 % instead of 90.

    ``most``: greatest value there can be, > 0.

    >>> values, parts = spread_weights(lambda tau: -((tau - 0.3) ** 2) / (2 * 0.001**2), most=4.0)
    >>> round(float(parts @ values), 6), round(float(np.sqrt(parts @ (values - 0.3) ** 2)), 6)
    (0.3, 0.001)
    """
    values = most * (np.arange(1, NODES + 1) / NODES) ** 1.5
    logs = likelihood(values)
    for _ in range(CLOSER):
        likely = np.flatnonzero(logs > logs.max() - LEFT_OUT)
        first, last = likely[0], min(likely[-1] + 1, NODES - 1)
        values = np.linspace(values[first - 1] if first else values[0] / 100, values[last], NODES)
        logs = likelihood(values)
    parts = np.exp(logs - logs.max())
    return values, parts / parts.sum()


Bounds = tuple[float, float]
"""The least and the greatest value that there can be."""
TAILS: Mapping[int, tuple[float, float]] = {50: (0.25, 0.75), 90: ENDS}
"""Parts of a distribution below the two ends of what holds so many percent."""
GREATEST_RATE_SPREAD = 0.99
"""Greatest tau that is summed over, over its greatest possible, sqrt(mu (1 - mu))."""


@dataclass(frozen=True)
class Scatter:
    """The scatter of balls and groups about the mean of all: mu, sigma^2, tau^2; whether groups are enough to pool."""

    mean: float
    within: float
    between: float
    pooled: bool


def bounded_intervals(
    counts: Array, means: Array, centre: Array, scatter: Scatter, *, bounds: Bounds
) -> tuple[Array, dict[int, tuple[Array, Array]]]:
    """Return the standard deviation of each group's mean, and the ends of its intervals by their percent.

    On the scale from 0 to 1 a group's mean theta is Beta distributed about mu with the concentration kappa, and a
    group's balls tell of it as s = w n m successes in N = w n trials do; w is how many trials a ball is worth by
    its variance: mu (1 - mu) - tau^2 over sigma^2, 1 for yes or no, more for a probability. Then theta is
    Beta(kappa mu + s, kappa (1 - mu) + N - s), for the one is the other's conjugate, and its mean is that of the
    one-way analysis of variance, mu + R (m - mu), for kappa = mu (1 - mu) / tau^2 - 1 gives R = N / (N + kappa).

    How much groups differ is itself badly known, most of all where rates are near 0 or 1, and one kappa taken for
    true makes intervals too narrow. So kappa is summed over, by the likelihood of all groups. With it goes mu: of
    each kappa it is the groups' weighted mean, whose variance comes on top, and the likelihood is summed over it by
    Laplace's rule. The prior is flat in 1 / (1 + r), r = kappa times mu or 1 - mu, the smaller, as that of numbers
    of events is [christiansen1997]: flat in tau^2 (`spread_weights`) while groups differ by less than the way to
    the nearer bound, and populations that crowd at a bound are as likely as others. The interval is that of the
    Beta distribution with the mean and variance of all this. Groups that are too few to be pooled, or of which no
    ball or every ball counts, have Jeffreys' intervals, Beta(s + 1/2, N - s + 1/2) [brown2001].

    An interval always holds the centre.

    ``counts``: balls of each group, > 0, shape (g,).
    """
    from scipy.special import betaincinv

    low, span = bounds[0], bounds[1] - bounds[0]
    rates, mu = np.clip((means - low) / span, 0, 1), (scatter.mean - low) / span
    room, within = mu * (1 - mu) - scatter.between / span**2, scatter.within / span**2
    trials = counts * max(room / within if within > 0 else 1.0, 1.0)
    hits = trials * rates
    if scatter.pooled and 0 < mu < 1:  # else nothing tells how much groups differ
        mean, variance = _rate_moments(hits, trials)
    else:
        mean = (hits + 0.5) / (trials + 1)
        variance = mean * (1 - mean) / (trials + 2)
    kappa = mean * (1 - mean) / variance - 1
    ends = {}
    for percent, (lower, upper) in TAILS.items():
        below, above = (low + span * betaincinv(kappa * mean, kappa * (1 - mean), tail) for tail in (lower, upper))
        ends[percent] = (np.minimum(below, centre), np.maximum(above, centre))
    return span * np.sqrt(variance), ends


def _rate_moments(hits: Array, trials: Array) -> tuple[Array, Array]:
    """Return mean and variance of each group's rate, summed over the spread of groups.

    ``hits``, ``trials``: of each group, shape (g,); need not be whole; neither none nor all of them hits.
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
        each = gammaln(alpha + hits) - gammaln(alpha) + gammaln(beta + trials - hits) - gammaln(beta)
        total = np.sum(each + gammaln(kappa) - gammaln(kappa + trials), axis=1) + 0.5 * np.log(unsure[:, 0])
        nearer = np.minimum(mu, 1 - mu)[:, 0]
        return np.asarray(total + np.log(nearer / spreads**3) - 2 * np.log1p(kappa[:, 0] * nearer))

    spreads, part = spread_weights(likelihood, most=GREATEST_RATE_SPREAD)
    kappa, mu, unsure = population(spreads)
    mean = (kappa * mu + hits) / (kappa + trials)
    variance = mean * (1 - mean) / (kappa + trials + 1) + (kappa / (kappa + trials)) ** 2 * unsure
    middle = part @ mean
    return middle, part @ (variance + (mean - middle) ** 2)


HALF = 0.674490
"""Standard deviations to either side that hold half of a normal distribution."""
REACHES = {50: HALF, 90: REACH}
"""Standard deviations to either side that hold so many percent of a normal distribution."""
GREATEST_SPREAD = 6.0
"""Greatest tau over what groups' means scatter by that is summed over."""
BALLS, MEAN, SQUARES = "balls", "mean", "squares"
"""Columns of what is added up of groups."""
FEWEST_BALLS = 5.0
"""Balls of a group below which nothing is said of reliability [our choice]."""
FEWEST_GROUPS = 5
"""Groups below which nothing is known of how groups differ, and nothing is pooled."""
POSITIVE: Bounds = (0.0, np.inf)
"""Bounds of what is never negative and has no greatest value."""


@dataclass(frozen=True)
class Spread:
    """The scatter of balls and groups.

    ``mean``: mu, of the groups. ``within``, ``between``: sigma^2 and tau^2; NaN where nothing tells of them: sigma with
    one ball a group, tau also with fewer than `FEWEST_GROUPS`. ``mean_balls``: of a group, by moments.
    ``variance_ratio``: F, the mean square between groups over that within.
    """

    mean: float
    within: float
    between: float
    balls: int
    groups: int
    mean_balls: float = np.nan
    variance_ratio: float = np.nan

    def reliability_interval(self, count: float) -> Interval | None:
        """Return R at a number of balls with its 90 % interval; None where a group has too few balls to tell.

        With F the mean square between groups over that within, F / (1 + n tau^2 / sigma^2) has the F distribution, for
        normal balls and groups of n each. So (tau / sigma)^2 lies between (F / F_95 - 1) / n and (F / F_5 - 1) / n.
        Groups of unlike size count as so many balls each as their moments do, `mean_balls`.

        >>> Spread(0.0, 9.0, 1.0, 57, 19, 3.0, 1.3).reliability_interval(34) is None
        True
        """
        from scipy.special import fdtri

        if self.groups < FEWEST_GROUPS or not (self.mean_balls >= FEWEST_BALLS and self.variance_ratio >= 0):
            return None
        freedom = self.groups - 1.0, float(self.balls - self.groups)
        low, high = (
            max(self.variance_ratio / float(fdtri(*freedom, part)) - 1, 0.0) / self.mean_balls for part in ENDS[::-1]
        )
        value = float(self.reliability(count))
        return Interval(value, *(count * ratio / (1 + count * ratio) for ratio in (low, high)))

    def reliability(self, count: Array | float) -> Array:
        """Return R at some numbers of balls, NaN where nothing tells how groups differ.

        >>> float(Spread(0.0, 9.0, 1.0, 100, 10).reliability(9.0))
        0.5
        """
        several = np.asarray(count, float)
        noise = self.within / np.maximum(several, 1e-9)
        ratio = np.where((several > 0) & (self.between > 0), self.between / np.maximum(self.between + noise, 1e-300), 0)
        return np.where(np.isnan(self.between), np.nan, ratio)


def spread_of(counts: Array, means: Array, squares: Array) -> Spread:
    """Return the scatter of balls and groups, by the moments of a one-way analysis of variance.

    ``counts``: balls of each group, > 0, shape (g,). ``squares``: sum of squares about the group's own mean.
    """
    total, groups = counts.sum(), len(counts)
    grand = float(np.average(means, weights=counts))
    within = float(squares.sum() / (total - groups)) if total > groups else np.nan
    if groups < FEWEST_GROUPS or np.isnan(within):
        return Spread(grand, within, np.nan, int(total), groups)
    scatter = np.sum(counts * (means - grand) ** 2) - (groups - 1) * within
    weight = total - np.sum(counts**2) / total
    between = max(scatter / weight, 0.0)
    weights = 1 / np.maximum(between + within / counts, 1e-300)
    each, ratio = float(weight / (groups - 1)), np.nan
    if within > 0:
        ratio = 1 + float(scatter) / ((groups - 1) * within)
    return Spread(float(np.average(means, weights=weights)), within, float(between), int(total), groups, each, ratio)


def pooled(
    frame: pl.DataFrame | pl.LazyFrame, *, key: str, measure: str, bounds: Bounds | None = None
) -> tuple[pl.DataFrame, Spread]:
    """Return the groups' means, partly pooled, with 50 and 90 % intervals.

    ``bounds``: least and greatest value there can be, both finite or `POSITIVE`, between which the intervals then lie;
    None: there are none. A row per group: key, balls, mean, pooled, spread, low50, high50, low90, high90, reliability
    and percentile among the groups by the pooled mean; and how balls and groups scatter. What nothing tells is missing.
    """
    value = pl.col(measure).cast(pl.Float64)
    table = (
        frame.lazy()
        .select(key, measure)
        .drop_nulls()
        .group_by(key)
        .agg(pl.len().alias(BALLS), value.mean().alias(MEAN), ((value - value.mean()) ** 2).sum().alias(SQUARES))
        .sort(key)
        .collect()
    )
    return pooled_groups(table, key=key, bounds=bounds)


def pooled_groups(table: pl.DataFrame, *, key: str, bounds: Bounds | None = None) -> tuple[pl.DataFrame, Spread]:
    """Return the result of `pooled`, computed from sums over the balls of each group.

    ``table``: a row a group: ``key``, ``balls`` (above 0), ``mean``, and ``squares``: their sum about the group's mean.
    ``bounds``: least and greatest value there can be, both finite or `POSITIVE`; None: there are none.
    """
    if not len(table):
        return table.select(key, "balls", "mean"), Spread(np.nan, np.nan, np.nan, 0, 0)
    counts, means = table["balls"].cast(pl.Float64).to_numpy(), table["mean"].to_numpy()
    spread = spread_of(counts, means, table["squares"].to_numpy())
    trust = spread.reliability(counts)
    centre = means if np.isnan(spread.between) else spread.mean + trust * (means - spread.mean)
    if bounds is None or bounds == POSITIVE:
        middle, error = _mean_moments(counts, means, centre, spread)
        reaches = {percent: error * wider for percent, wider in _wider(spread).items()}
        apart = (
            _positive_ends(middle, reaches)
            if bounds == POSITIVE
            else {
                percent: (middle - REACHES[percent] * reach, middle + REACHES[percent] * reach)
                for percent, reach in reaches.items()
            }
        )
        ends = {percent: (np.minimum(low, centre), np.maximum(high, centre)) for percent, (low, high) in apart.items()}
    else:
        within, between = (0.0 if np.isnan(part) else part for part in (spread.within, spread.between))
        scatter = Scatter(spread.mean, within, between, spread.groups >= FEWEST_GROUPS)
        error, ends = bounded_intervals(counts, means, centre, scatter, bounds=bounds)
    rank = pl.Series(centre).rank("average")  # groups that nothing tells apart are all in the middle
    columns = {"pooled": centre, "spread": error}
    columns |= {f"{side}{percent}": ends[percent][end] for percent in ends for end, side in enumerate(("low", "high"))}
    columns["reliability"] = trust
    pooled = table.select(key, "balls", "mean").with_columns(
        **{name: pl.Series(values, nan_to_null=True) for name, values in columns.items()},
        percentile=100 * (rank - 0.5) / len(centre),
    )
    return pooled, spread


def _wider(spread: Spread) -> dict[int, float]:
    """Return the factors of intervals' widths by their percent, for a sigma from few balls: Student's."""
    from scipy.special import stdtrit

    freedom = spread.balls - spread.groups
    return {
        percent: float(stdtrit(freedom, upper)) / REACHES[percent] if freedom else np.nan
        for percent, (_, upper) in TAILS.items()
    }


def _positive_ends(centre: Array, errors: dict[int, Array]) -> dict[int, tuple[Array, Array]]:
    """Return the ends of gamma distributed intervals by their percent; one of no width where nothing scatters."""
    from scipy.special import gammaincinv

    ends = {}
    for percent, error in errors.items():
        finite = (centre > 0) & (error > 0)
        shape = np.divide(centre, error, out=np.ones_like(centre), where=finite) ** 2
        both = (
            np.where(finite, centre / shape * gammaincinv(shape, tail), centre + 0 * error) for tail in TAILS[percent]
        )
        ends[percent] = (next(both), next(both))
    return ends


def _mean_moments(counts: Array, means: Array, centre: Array, spread: Spread) -> tuple[Array, Array]:
    """Return mean and standard deviation of each group's mean, summed over tau; NaN where nothing tells the latter."""
    noise = spread.within / counts
    size = float(np.std(means))
    if np.isnan(spread.between) or not size > 0 or not spread.within > 0:
        return centre, np.sqrt(noise)

    def population(spreads: Array) -> tuple[Array, Array, Array, Array]:
        """Return tau^2 and the groups' weights, shapes (k, 1) and (k, g), mu and its variance, (k,)."""
        between = (size * spreads[:, None]) ** 2
        weight = 1 / (between + noise)
        total = weight.sum(axis=1)
        return between, weight, (weight @ means) / total, 1 / total

    def likelihood(spreads: Array) -> Array:
        _, weight, mu, unsure = population(spreads)
        each = 0.5 * np.sum(np.log(weight) - weight * (means - mu[:, None]) ** 2, axis=1) + 0.5 * np.log(unsure)
        return np.asarray(each + np.log(spreads))

    spreads, part = spread_weights(likelihood, most=GREATEST_SPREAD)
    between, weight, mu, unsure = population(spreads)
    trust = between * weight
    middles = mu[:, None] + trust * (means - mu[:, None])
    variance = between * (1 - trust) + (1 - trust) ** 2 * unsure[:, None]
    middle = part @ middles
    return middle, np.asarray(np.sqrt(part @ (variance + (middles - middle) ** 2)))
