"""The posterior of a player: weighted draws, their effective number, and summaries of the parameters."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, Interval
from sweetspot.player.importance import Weighted, drawn_further, importance_draws
from sweetspot.player.model import PlayerModel
from sweetspot.player.prior import NAMES, Population, natural, prior_draws

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

    Parameters
    ----------
    name : of the parameter, one of `NAMES`.
    interval : median and 90 % interval of the posterior, SI.
    before : the same of the prior.
    width_ratio : standard deviation of the posterior over that of the prior, in the prior's own scale.
    independent_draws : number of equally heavy draws that would be as precise.
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

    Parameters
    ----------
    draws : shape (draws, 10), SI, in the order of `NAMES`.
    seed : that the draws can be repeated with.
    weighted : the draws as they were weighted, standard parameters; None: they were let go.
    """

    model: PlayerModel
    draws: Array
    learned: dict[str, Learned]
    seed: int
    weighted: Weighted | None = field(default=None, repr=False)

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
    weighted = importance_draws(
        model.log_posterior,
        along=NAMES.index("position"),
        skewed=NAMES.index("position_spread"),
        size=len(NAMES),
        seed=seed,
    )
    return _resampled(model, weighted, seed)


def refitted(posterior: PlayerPosterior, population: Population) -> PlayerPosterior:
    """Return the fit of a player of whom it is known how the others of the league differ.

    The draws that there are count again, as they are likely now; new ones are drawn where too few do.
    """
    model, earlier, seed = posterior.model, posterior.weighted, posterior.seed
    if earlier is None:
        return posterior
    apart = (earlier.draws - population.mean) / population.spread
    heights = earlier.heights + 0.5 * np.sum(earlier.draws**2 - apart**2, axis=1)  # -inf stays what is forbidden
    weighted = drawn_further(earlier, heights, lambda rows: model.log_posterior(rows, population), seed=seed)
    return _resampled(model, weighted, seed)


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
