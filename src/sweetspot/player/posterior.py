"""The posterior of a player: weighted draws and summaries of the parameters; and of the players of one league.

How players of a league differ is learned from all of them, and every one is fitted again knowing it. What player i's
own swings say of the standard parameters z is about a normal law, of precision P_i and with h_i = P_i times its mean:
those of the posterior less those of the prior. With z normal about mu with the variances T of the league, its
likelihood is a closed form [gelman_bda]:

    log L = sum_i (-log |T| - log |P_i + T^-1| + b_i' (P_i + T^-1)^-1 b_i - mu' T^-1 mu) / 2,   b_i = h_i + T^-1 mu
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cache

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, Interval
from sweetspot.player.importance import Weighted, drawn_further, importance_draws
from sweetspot.player.model import PlayerModel
from sweetspot.player.prior import ANYBODY, NAMES, Population, natural, prior_draws

ENOUGH = 200.0
"""Independent draws from which 90 % intervals are steady to a few per cent of their width."""
NOTHING_LEARNED = 0.85
"""Width of the posterior over that of the prior above which the data cannot tell."""
PRIOR_DRAWS = 20_000
RESAMPLED, LIGHT = 6000, 200
"""Draws taken from the weighted ones, each as often as it weighs, and how many of them a league keeps."""


@dataclass(frozen=True)
class Learned:
    """One parameter after the fit.

    ``name``: of the parameter, one of `NAMES`. ``interval``: median and 90 % interval of the posterior, SI. ``before``:
    the same of the prior. ``width_ratio``: standard deviation of the posterior over that of the prior, in the prior's
    own scale. ``independent_draws``: number of equally heavy draws that would be as precise.
    """

    name: str
    interval: Interval
    before: Interval
    width_ratio: float
    independent_draws: float

    @property
    def told(self) -> bool:
        """Whether the data say anything beyond the prior."""
        return self.width_ratio < NOTHING_LEARNED


@dataclass(frozen=True)
class PlayerPosterior:
    """The fit of a player.

    ``draws``: shape (draws, 10), SI, in the order of `NAMES`. ``seed``: that the draws can be repeated with.
    ``weighted``: the draws as they were weighted, standard parameters; None: they were let go. ``population``: the
    players that this one was taken for one of before any swing.
    """

    model: PlayerModel
    draws: Array
    learned: dict[str, Learned]
    seed: int
    weighted: Weighted | None = field(default=None, repr=False)
    population: Population = field(default=ANYBODY, repr=False)

    @property
    def converged(self) -> bool:
        """Whether every parameter has enough independent draws."""
        return all(learned.independent_draws >= ENOUGH for learned in self.learned.values())

    def lighter(self) -> PlayerPosterior:
        """Return the fit with few of its draws, which a league of hundreds has room for; intervals stay."""
        return replace(self, draws=self.thinned(LIGHT))

    def thinned(self, count: int) -> Array:
        """Return about ``count`` draws, evenly taken, shape (count, 10)."""
        every = max(1, len(self.draws) // count)
        return self.draws[::every][:count]


def fit_player(model: PlayerModel, *, seed: int = 1) -> PlayerPosterior:
    """Return weighted draws from the posterior of a player's parameters, see `importance_draws`."""
    population = model.population
    weighted = importance_draws(
        lambda rows: model.log_posterior(rows, population),
        along=NAMES.index("position"),
        skewed=NAMES.index("position_spread"),
        size=len(NAMES),
        seed=seed,
    )
    return replace(_resampled(model, weighted, seed), population=population)


def refitted(posterior: PlayerPosterior, population: Population) -> PlayerPosterior:
    """Return the fit of a player of whom it is known how the others of the league differ.

    The draws that there are count again, as they are likely now; new ones are drawn where too few do.
    """
    model, earlier, seed = posterior.model, posterior.weighted, posterior.seed
    if earlier is None:
        return posterior
    before, apart = ((earlier.draws - players.mean) / players.spread for players in (posterior.population, population))
    heights = earlier.heights + 0.5 * np.sum(before**2 - apart**2, axis=1)  # -inf stays what is forbidden
    weighted = drawn_further(earlier, heights, lambda rows: model.log_posterior(rows, population), seed=seed)
    return replace(_resampled(model, weighted, seed), population=population)


def _resampled(model: PlayerModel, weighted: Weighted, seed: int) -> PlayerPosterior:
    taken = np.random.default_rng(seed).choice(len(weighted.weights), RESAMPLED, p=weighted.weights)
    draws = weighted.draws[taken]
    return PlayerPosterior(model, natural(draws), summarised(draws, independent=weighted.effective), seed, weighted)


def summarised(draws: Array, *, independent: float) -> dict[str, Learned]:
    """Return the parameters learned from draws of standard parameters, shape (draws, 10)."""
    values = natural(draws)
    return {
        name: Learned(
            name=name,
            interval=interval(values[:, index]),
            before=_before()[index][0],
            width_ratio=float(draws[:, index].std() / _before()[index][1]),
            independent_draws=independent,
        )
        for index, name in enumerate(NAMES)
    }


@cache
def _before() -> tuple[tuple[Interval, float], ...]:
    """Return interval and standard deviation, in its own scale, of every parameter before any data."""
    draws = prior_draws(PRIOR_DRAWS, seed=0)
    values = natural(draws)
    return tuple((interval(values[:, index]), float(draws[:, index].std())) for index in range(len(NAMES)))


def interval(values: Array) -> Interval:
    """Return median and 90 % interval of draws.

    >>> interval(np.arange(1001.0))
    Interval(value=500.0, low=50.0, high=950.0)
    """
    low, middle, high = np.percentile(values, [100 * ENDS[0], 50, 100 * ENDS[1]])
    return Interval(float(middle), float(low), float(high))


FEWEST_PLAYERS = 5
"""Players below which nothing is known of how they differ, and nothing is pooled."""
BETWEEN_LEAGUES = 0.5
"""Variance of leagues' means, where that of single players is 1; our choice, of no weight for a league of many."""
LEANING = 5.0
"""As many players as the other half is worth when a league's spread is learned. Our choice."""
MODEL_DOUBT = 0.3
"""What a league's mean may be off by because the model is, alike for all players, in deviations of the prior:
up to 0.29 of players made by full collisions before the tables knew the place, 0.08 now (docs/theory/player.md)."""
TELLS = 0.1
"""Precision, where the prior's is 1, below which a player's swings are taken as uninformative in a direction."""


@dataclass(frozen=True)
class SwingEvidence:
    """What players' own swings say, without any prior.

    ``precision``: shape (players, n, n). ``pull``: precision times mean, shape (players, n).
    """

    precision: Array
    pull: Array


def population_of(fits: Sequence[PlayerPosterior]) -> Population | None:
    """Return the distribution of a league's players, None of fewer than five with weighted draws.

    The spread holds what is not known of the league's mean as well.
    """
    weighted = [(fit.weighted, fit.population) for fit in fits if fit.weighted is not None]
    if len(weighted) < FEWEST_PLAYERS:
        return None
    return likeliest_population(evidence_of(weighted))


def evidence_of(weighted: Sequence[tuple[Weighted, Population]]) -> SwingEvidence:
    """Return the evidence of players' swings: their posteriors less their priors."""
    usual = prior_draws(20_000, seed=0)
    usual_before = np.linalg.inv(np.cov(usual.T))
    precisions, pulls = [], []
    for fit, population in weighted:
        before = usual_before / np.outer(population.spread, population.spread)
        prior = population.mean + population.spread * usual
        mean = fit.weights @ fit.draws
        apart = fit.draws - mean
        after = np.linalg.inv((apart * fit.weights[:, None]).T @ apart)
        size, axes = np.linalg.eigh(after - before)
        informed = size > TELLS
        along = axes.T @ (after @ mean - before @ prior.mean(axis=0))
        precisions.append((axes * np.where(informed, size, 0.0)) @ axes.T)
        pulls.append(axes @ np.where(informed, along, 0.0))
    return SwingEvidence(np.array(precisions), np.array(pulls))


def likeliest_population(evidence: SwingEvidence) -> Population:
    """Return mean and spread of a league that are likeliest.

    >>> pull = 1e6 * np.random.default_rng(1).normal(2, 0.5, (400, 1))
    >>> evidence = SwingEvidence(np.tile(1e6 * np.eye(1), (400, 1, 1)), pull)
    >>> population = likeliest_population(evidence)
    >>> bool(abs(population.mean[0] - 2) < 0.1), bool(abs(population.spread[0] - 0.5) < 0.05)
    (True, True)
    """
    from scipy.optimize import minimize

    size = evidence.pull.shape[1]

    def low(places: Array) -> tuple[float, Array]:
        value, slope = _height(evidence, places[:size], np.exp(places[size:]))
        return -value, -slope

    within = 1 - BETWEEN_LEAGUES
    start = np.concatenate([np.zeros(size), np.full(size, np.log(within))])
    best = minimize(low, start, jac=True, method="L-BFGS-B", options={"maxiter": 300}).x
    mean, variance = best[:size], np.exp(best[size:])
    # (T + P^-1)^-1 = T^-1 - T^-1 (P + T^-1)^-1 T^-1, also where P has no inverse
    knowing = np.diag(1 / variance)
    marginal = knowing - knowing @ np.linalg.inv(evidence.precision + knowing) @ knowing
    unsure = np.linalg.inv(marginal.sum(axis=0) + np.eye(size) / BETWEEN_LEAGUES)
    return Population(mean, np.sqrt(variance + np.diag(unsure) + MODEL_DOUBT**2))


def _height(evidence: SwingEvidence, mean: Array, variance: Array) -> tuple[float, Array]:
    """Return the log-likelihood that `likeliest_population` maximizes, and its gradient by mean and log variance."""
    count, within = len(evidence.pull), 1 - BETWEEN_LEAGUES
    posterior = evidence.precision + np.diag(1 / variance)
    pull = evidence.pull + mean / variance
    scatter = np.linalg.inv(posterior)
    centre = np.einsum("pij,pj->pi", scatter, pull)
    value = 0.5 * (np.einsum("pi,pi->", centre, pull) - np.linalg.slogdet(posterior)[1].sum())
    value -= 0.5 * count * (np.log(variance).sum() + np.sum(mean**2 / variance))
    value -= 0.5 * np.sum(mean**2) / BETWEEN_LEAGUES
    value -= 0.5 * LEANING * np.sum(np.log(variance) + within / variance)
    apart = (centre - mean) ** 2 + np.einsum("pii->pi", scatter)
    by_mean = (centre - mean).sum(axis=0) / variance - mean / BETWEEN_LEAGUES
    by_variance = 0.5 * (apart.sum(axis=0) / variance - count) + 0.5 * LEANING * (within / variance - 1)
    return float(value), np.concatenate([by_mean, by_variance])


def own_share(posterior: PlayerPosterior, league: Population) -> dict[str, float]:
    """Return the information of a player's own swings by parameter: 1 minus the variance over the league's.

    0: the player is taken for the league's average; 1: the league says nothing.
    """
    return {
        name: float(np.clip(1 - (posterior.learned[name].width_ratio / league.spread[index]) ** 2, 0.0, 1.0))
        for index, name in enumerate(NAMES)
    }
