"""What the swings say about the player: draws from the posterior, how well they have mixed, and what was learned."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Literal

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, Interval
from sweetspot.player.importance import Weighted, drawn_further, importance_draws
from sweetspot.player.model import PlayerModel
from sweetspot.player.prior import NAMES, Population, natural, prior_draws, standardised

WALKERS = 40
STEPS, WARM_UP = 1200, 500
"""Steps kept, and steps thrown away before them."""
EVERY = 25
"""Steps between two reports of progress."""
WELL_MIXED = 1.2
"""Split R-hat up to which chains count as mixed: half a chain holds some ten independent draws, which alone gives 1.05,
and more where the contact point has two sides [gelman_bda]."""
ENOUGH = 200.0
"""Independent draws from which 90 % intervals are steady to a few per cent of their width."""
NOTHING_LEARNED = 0.85
"""PlayerPosterior over prior width above which the data cannot tell."""
PRIOR_DRAWS = 20_000
SCATTERED, ROUNDS, BEST = 600, 4, 60
"""Draws from the prior that the walkers' places are found from, in how many rounds, and how many are kept of each."""
FARTHEST_START = 3.0
"""Prior standard deviations."""
USUAL_CLOSING = 68.0
"""m/s, a pitch and a swing together, at which the bat's best place is read off."""
RESAMPLED, LIGHT = 6000, 200
"""Draws taken from the weighted ones, each as often as it weighs, and how many of them a league keeps."""
Progress = Callable[[int, int], None]
Method = Literal["draws", "walkers"]


@dataclass(frozen=True)
class Learned:
    """One parameter after the fit.

    Parameters
    ----------
    name : of the parameter, one of `NAMES`.
    interval : median and 90 % interval of the posterior, SI.
    before : the same of the prior.
    width_ratio : standard deviation of the posterior over that of the prior, in the prior's own scale.
    mixing : split R-hat; 1 when all parts of all chains tell the same.
    independent_draws : number of draws that a chain without memory would have taken for the same precision.
    """

    name: str
    interval: Interval
    before: Interval
    width_ratio: float
    mixing: float
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
    model : what was fitted.
    draws : shape (draws, 10), SI, in the order of `NAMES`.
    learned : by name.
    seed : that the draws can be repeated with.
    weighted : the draws as they were weighted, standard parameters; None: of walkers.
    """

    model: PlayerModel
    draws: Array
    learned: dict[str, Learned]
    seed: int
    weighted: Weighted | None = field(default=None, repr=False)

    @property
    def converged(self) -> bool:
        """Whether every parameter is well mixed and has enough independent draws."""
        return all(one.mixing <= WELL_MIXED and one.independent_draws >= ENOUGH for one in self.learned.values())

    def lighter(self) -> PlayerPosterior:
        """Return the fit with few of its draws, which a league of hundreds has room for; intervals stay."""
        return replace(self, draws=self.thinned(LIGHT))

    def thinned(self, count: int) -> Array:
        """Return about ``count`` draws, evenly taken, shape (count, 10)."""
        every = max(1, len(self.draws) // count)
        return self.draws[::every][:count]


def fit_player(
    model: PlayerModel, *, method: Method = "draws", seed: int = 1, progress: Progress | None = None
) -> PlayerPosterior:
    """Return draws from the posterior of a player's parameters.

    Parameters
    ----------
    method : "draws" weighs independent draws (`importance_draws`), in a fraction of a second, and walks only where too
        few of them count; "walkers" walks at once (`walked`), which takes minutes on a slow machine.
    seed : of the random numbers; the same seed gives the same draws.
    progress : called with (steps done, steps in all) while walking.
    """
    if method == "walkers":
        return walked(model, seed=seed, progress=progress)
    weighted = importance_draws(
        model.log_posterior,
        along=NAMES.index("position"),
        skewed=NAMES.index("position_spread"),
        size=len(NAMES),
        seed=seed,
    )
    if weighted.effective < ENOUGH:
        return walked(model, seed=seed, progress=progress)
    if progress is not None:
        progress(1, 1)
    return _resampled(model, weighted, seed)


def refitted(posterior: PlayerPosterior, population: Population) -> PlayerPosterior:
    """Return the fit of a player of whom it is known how the others of the league differ.

    The draws that there are count again, as they are likely now; new ones are drawn where too few do.

    Parameters
    ----------
    posterior : the fit without the league, with weighted draws.
    population : the league.
    """
    model, known, seed = posterior.model, posterior.weighted, posterior.seed
    if known is None:
        return posterior
    apart = (known.draws - population.mean) / population.spread
    heights = known.heights + 0.5 * np.sum(known.draws**2 - apart**2, axis=1)  # -inf stays what is forbidden
    weighted = drawn_further(known, heights, lambda rows: model.log_posterior(rows, population), seed=seed)
    return _resampled(model, weighted, seed)


def _resampled(model: PlayerModel, weighted: Weighted, seed: int) -> PlayerPosterior:
    taken = np.random.default_rng(seed).choice(len(weighted.weights), RESAMPLED, p=weighted.weights)
    draws = weighted.draws[taken]
    learned = summarised(draws[:, None], independent=weighted.effective)
    return PlayerPosterior(model, natural(draws), learned, seed, weighted)


def walked(
    model: PlayerModel,
    *,
    seed: int = 1,
    steps: int = STEPS,
    warm_up: int = WARM_UP,
    progress: Progress | None = None,
) -> PlayerPosterior:
    """Return draws from the posterior by an ensemble of walkers [foreman2013].

    The walkers begin where draws from the prior were gathered, on both sides of the bat's best place, and move by
    differences between one another.

    Parameters
    ----------
    seed : of the random numbers; the same seed gives the same draws.
    steps, warm_up : steps kept and steps thrown away before them.
    progress : called with (steps done, steps in all).
    """
    import emcee

    start = _start(model, seed)
    # the second kind steps by whole differences, from one side of the best place to the other
    # (not emcee's third of this family, the snooker: its draws of a ten-dimensional normal are a fifth too narrow)
    moves = [(emcee.moves.DEMove(), 0.85), (emcee.moves.DEMove(gamma0=1.0), 0.15)]
    sampler = emcee.EnsembleSampler(WALKERS, len(NAMES), model.log_posterior, moves=moves, vectorize=True)
    sampler.log_prob_fn = model.log_posterior  # as it is: emcee's wrapper prints every walker when interrupted
    sampler.random_state = np.random.RandomState(seed).get_state()
    total = warm_up + steps
    for done, _ in enumerate(sampler.sample(start, iterations=total, skip_initial_state_check=False), start=1):
        if progress is not None and (done % EVERY == 0 or done == total):
            progress(done, total)
    chains = sampler.get_chain(discard=warm_up)
    return PlayerPosterior(model, natural(chains.reshape(-1, len(NAMES))), summarised(chains), seed)


def summarised(chains: Array, *, independent: float | None = None) -> dict[str, Learned]:
    """Return what chains of standard parameters, shape (steps, walkers, 10), say about each of them.

    Parameters
    ----------
    independent : how many draws count, where they are no chains but weighted draws; None: worked out from the chains.
    """
    flat = chains.reshape(-1, chains.shape[-1])
    values = natural(flat)
    learned = {}
    for index, name in enumerate(NAMES):
        learned[name] = Learned(
            name=name,
            interval=interval(values[:, index]),
            before=_before()[index][0],
            width_ratio=float(flat[:, index].std() / _before()[index][1]),
            mixing=1.0 if independent else split_r_hat(chains[:, :, index]),
            independent_draws=independent or independent_draws(chains[:, :, index]),
        )
    return learned


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


def split_r_hat(chains: Array) -> float:
    """Return split R-hat of chains of one parameter, shape (steps, walkers) [gelman_bda].

    Every chain is cut into halves; R^2 = ((N - 1) / N W + B / N) / W, W the mean variance within the pieces and B / N
    the variance of their means.

    >>> round(split_r_hat(np.random.default_rng(0).standard_normal((1000, 10))), 2)
    1.0
    """
    half = len(chains) // 2
    pieces = np.concatenate([chains[:half], chains[half : 2 * half]], axis=1)
    within = pieces.var(axis=0, ddof=1).mean()
    between = pieces.mean(axis=0).var(ddof=1)
    return float(np.sqrt(((half - 1) / half * within + between) / within))


def independent_draws(chains: Array) -> float:
    """Return the number of draws over the integrated autocorrelation time, shape (steps, walkers) to one number."""
    import emcee

    time = float(emcee.autocorr.integrated_time(chains, quiet=True, tol=0)[0])
    return chains.size / max(time, 1.0)


def _start(model: PlayerModel, seed: int) -> Array:
    """Return a good place per walker, half of them on either side of the bat's best place.

    Exit speed hardly tells the sides apart, and walkers that all begin on one would seldom find the other.
    """
    generator = np.random.default_rng(seed)
    first = _gathered(model, prior_draws(SCATTERED, seed), generator)
    mirrored = _mirrored(model, first)
    second = _gathered(
        model, np.concatenate([mirrored + 0.2 * generator.standard_normal(mirrored.shape)] * 4), generator
    )
    return np.concatenate([first[-WALKERS // 2 :], second[-WALKERS // 2 :]])


def _mirrored(model: PlayerModel, standard: Array) -> Array:
    """Return places with the contact point as far on the other side of the bat's best place, shape as given."""
    own, at = model.bats[0], NAMES.index("position")
    fastest = float(own.from_tip[np.argmax(own.efficiency + USUAL_CLOSING * own.efficiency_slope)])
    values = natural(standard)
    values[..., at] = 2 * fastest - values[..., at]
    return np.clip(standardised(values), -FARTHEST_START, FARTHEST_START)


def _gathered(model: PlayerModel, places: Array, generator: np.random.Generator) -> Array:
    """Return places drawn together where the swings are likely, the likeliest last."""
    for _ in range(ROUNDS):
        best = places[np.argsort(model.log_posterior(places))[-BEST:]]
        spread = np.maximum(best.std(axis=0), 0.02)
        fresh = best.mean(axis=0) + spread * generator.standard_normal((4 * BEST, len(NAMES)))
        places = np.concatenate([best, fresh])
    return places[np.argsort(model.log_posterior(places))[-BEST:]]
