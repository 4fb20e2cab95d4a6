"""Draws from a player's posterior in a fraction of a second: Laplace's normals, then importance sampling about them.

From the likeliest parameters and the curvature there (Laplace) begins a mixture of wide-tailed normals side by side
along the contact point, which swings tell worst: it has two sides, and what else is likely bends with it. The mixture
is fitted to the weighted draws, round by round [cappe2008]. No draw is thrown away: each is weighted by how likely it
is against how often the mixtures of all rounds together give it [cornuet2012]. Their effective number says when that is
enough.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray

ROUNDS, MOST_ROUNDS, DRAWS = 3, 10, 600
"""Rounds of draws at least and at most, and how many draws in each."""
GOOD = 300.0
"""Effective draws at which the rounds end."""
FREEDOM = 5.0
"""Degrees of freedom of the wide tails."""
WIDER = 1.6
"""Factor by which the draws' variance exceeds that of the density found."""
LEAST_SHARE = 0.05
"""Of any part of the mixture."""
TAIL = 1.0
"""How far below the others, in standard deviations of the prior, the parts lie that reach into a long tail."""
RIDGE_STEP, RIDGE_REACH = 1.0, 3.0
"""Between the parts of the mixture, and how far they go, in standard deviations of the prior."""
CLIMBS, CLIMB_PARTS, LONGEST_CLIMB = 2, (1.0, 0.4), 1.5
"""Newton's steps to where the others are likeliest, what parts of each are tried, and how long one may be."""
HEAVIEST = 0.02
"""Most that one draw may weigh while the mixture is fitted to them."""
KEPT = 0.1
"""Part of a covariance that stays from the round before."""
FLATTEST = 0.8
"""Least curvature: that of the prior is 1, and no direction can be wider for long."""
GRADIENT_STEP, CURVATURE_STEP = 1e-4, 0.05
"""Of standard parameters, whose prior has a standard deviation of 1."""
Density = Callable[[Array], Array]


@dataclass(frozen=True)
class Mixture:
    """Wide-tailed normals of one covariance: shares, shape (parts,), places, shape (parts, n), and (n, n)."""

    shares: Array
    places: Array
    covariance: Array

    @property
    def root(self) -> Array:
        """Lower triangle whose square is the covariance that draws are taken with."""
        return np.asarray(np.linalg.cholesky(WIDER * self.covariance), float)


@dataclass(frozen=True)
class Weighted:
    """Weighted draws, and the mixture that they were drawn from.

    ``draws``: shape (draws, n). ``weights``: shape (draws,); they add to one. ``heights``: shape (draws,), logarithm of
    the density at every draw. ``mixtures``: of every round, each with as many draws.
    """

    draws: Array
    weights: Array
    heights: Array
    mixtures: tuple[Mixture, ...]

    @property
    def effective(self) -> float:
        """Number of equally heavy draws that would tell as much: 1 / sum of squared weights."""
        return float(1 / np.sum(self.weights**2))


def importance_draws(log_density: Density, *, along: int, skewed: int, size: int, seed: int) -> Weighted:
    """Return weighted draws of a density of ``size`` parameters that a standard normal is the scale of.

    ``log_density``: of rows of parameters, shape (rows, size) to (rows,), up to a constant; -inf where not allowed.

    >>> log_density = lambda rows: -0.5 * ((rows - 1) ** 2).sum(axis=1)
    >>> drawn = importance_draws(log_density, along=0, skewed=1, size=3, seed=1)
    >>> bool(np.all(abs(drawn.weights @ drawn.draws - 1) < 0.1)), drawn.effective > 500
    (True, True)
    """
    place = highest(log_density, np.zeros(size))
    mixture = _ridge(log_density, place, _precision(log_density, place), along, skewed)
    nothing = Weighted(np.empty((0, size)), np.empty(0), np.empty(0), ())
    return _drawn_on(nothing, mixture, log_density, rounds=ROUNDS, seed=seed)


def drawn_further(before: Weighted, heights: Array, log_density: Density, *, seed: int) -> Weighted:
    """Return weighted draws of another density not far from that of draws that there are, which count again.

    ``heights``: shape (draws,), logarithm of the other density at each of them.
    """
    again = _weighted(before.draws, heights, before.mixtures)
    if again.effective > GOOD:
        return again
    return _drawn_on(again, _fitted(before.mixtures[-1], again), log_density, rounds=1, seed=seed)


def _drawn_on(before: Weighted, mixture: Mixture, log_density: Density, *, rounds: int, seed: int) -> Weighted:
    """Return draws with so many rounds at least beyond those known, begun with a mixture, until enough count."""
    generator = np.random.default_rng(seed)
    weighted = before
    for turn in range(1, MOST_ROUNDS + 1):
        fresh = _drawn(mixture, DRAWS, generator)
        weighted = _weighted(
            np.concatenate([weighted.draws, fresh]),
            np.concatenate([weighted.heights, log_density(fresh)]),
            (*weighted.mixtures, mixture),
        )
        if turn >= rounds and weighted.effective > GOOD:
            break
        mixture = _fitted(mixture, weighted)
    return weighted


def _weighted(draws: Array, heights: Array, mixtures: tuple[Mixture, ...]) -> Weighted:
    """Return draws weighted by the density, whose logarithms are given, over the mean of all rounds' mixtures."""
    often = np.logaddexp.reduce(np.concatenate([_log_parts(mixture, draws) for mixture in mixtures]), axis=0)
    log_weight = heights - often
    weights = np.exp(log_weight - log_weight.max())
    return Weighted(draws, weights / weights.sum(), heights, mixtures)


def highest(log_density: Density, start: Array) -> Array:
    """Return a place where the density is highest near ``start``, found with slopes from differences."""
    from scipy.optimize import minimize

    steps = GRADIENT_STEP * np.eye(len(start))

    def low(place: Array) -> tuple[float, Array]:
        values = np.nan_to_num(-log_density(np.concatenate([place[None], place + steps])), nan=1e6, posinf=1e6)
        return float(values[0]), (values[1:] - values[0]) / GRADIENT_STEP

    minimum = minimize(low, start, jac=True, method="BFGS", options={"gtol": 0.05, "maxiter": 40})
    return np.asarray(minimum.x)


def _precision(log_density: Density, place: Array) -> Array:
    """Return less the matrix of second derivatives at a place, no direction flatter than about the prior."""
    size = len(place)
    steps = CURVATURE_STEP * np.eye(size)
    first, second = np.tril_indices(size, -1)
    rows = [place[None], place + steps, place - steps, place + steps[first] + steps[second]]
    values = -log_density(np.concatenate(rows))
    middle, ahead, behind = values[0], values[1 : size + 1], values[size + 1 : 2 * size + 1]
    with np.errstate(invalid="ignore"):  # infinite where not allowed: there nothing is known, as of the prior
        curvature = np.diag(ahead + behind - 2 * middle)
        both = values[2 * size + 1 :] + middle
        curvature[first, second] = curvature[second, first] = both - ahead[first] - ahead[second]
    scale, axes = np.linalg.eigh(np.nan_to_num(curvature / CURVATURE_STEP**2, posinf=1.0, neginf=1.0))
    return np.asarray((axes * np.clip(scale, FLATTEST, None)) @ axes.T)


def _ridge(log_density: Density, place: Array, curvature: Array, along: int, skewed: int) -> Mixture:
    """Return normals side by side along one parameter, each where the others are likeliest, and as likely as there.

    As many lie below them in the skewed parameter. All have one covariance: that of the others at the highest place,
    where the one parameter is held.
    """
    rest = np.delete(np.arange(len(place)), along)
    within = np.asarray(np.linalg.inv(curvature[np.ix_(rest, rest)]), float)
    nodes = np.arange(-RIDGE_REACH, RIDGE_REACH + RIDGE_STEP / 2, RIDGE_STEP)
    places = np.tile(place, (len(nodes) + 1, 1))
    places[1:, along] = nodes
    places, heights = _climbed(log_density, places, rest, within)
    lower = places.copy()
    lower[:, skewed] -= TAIL
    free = rest[rest != skewed]
    alone = np.asarray(np.linalg.inv(curvature[np.ix_(free, free)]), float)
    lower, below = _climbed(log_density, lower, free, alone)
    places, heights = np.concatenate([places, lower]), np.concatenate([heights, below])
    covariance = np.zeros_like(curvature)
    covariance[np.ix_(rest, rest)] = within
    covariance[along, along] = min(np.linalg.inv(curvature)[along, along], (RIDGE_STEP / 2) ** 2)
    shares = np.exp(heights - heights.max())
    shares = np.maximum(shares / shares.sum(), LEAST_SHARE)
    return Mixture(shares / shares.sum(), places, covariance)


def _climbed(log_density: Density, places: Array, rest: IntArray, within: Array) -> tuple[Array, Array]:
    """Return places moved uphill in the density, some parameters free, and its logarithms there.

    Newton's steps with one curvature for all places, whose inverse is ``within``; the best part of each is taken.
    """
    count, size = places.shape
    every, steps = np.arange(count), GRADIENT_STEP * np.eye(size)[rest]
    heights = log_density(places)
    for _ in range(CLIMBS):
        ahead = log_density((places[:, None] + steps).reshape(-1, size)).reshape(count, -1)
        slope = np.nan_to_num((ahead - heights[:, None]) / GRADIENT_STEP, posinf=0.0, neginf=0.0)
        move = slope @ within
        move *= np.minimum(1.0, LONGEST_CLIMB / np.maximum(np.abs(move).max(axis=1), GRADIENT_STEP))[:, None]
        tried = np.repeat(places[:, None], 1 + len(CLIMB_PARTS), axis=1)
        tried[:, 1:, rest] += np.array(CLIMB_PARTS)[:, None] * move[:, None]
        fresh = log_density(tried[:, 1:].reshape(-1, size)).reshape(count, -1)
        values = np.concatenate([heights[:, None], fresh], axis=1)
        best = np.argmax(values, axis=1)
        places, heights = tried[every, best], values[every, best]
    return places, heights


def _drawn(mixture: Mixture, count: int, generator: np.random.Generator) -> Array:
    """Return draws of the mixture of wide-tailed normals, shape (count, n)."""
    which = generator.choice(len(mixture.shares), count, p=mixture.shares)
    normal = generator.standard_normal((count, mixture.places.shape[1]))
    normal /= np.sqrt(generator.chisquare(FREEDOM, count) / FREEDOM)[:, None]
    return np.asarray(mixture.places[which] + normal @ mixture.root.T)


def _log_parts(mixture: Mixture, draws: Array) -> Array:
    """Return the logarithm of share times density of each part, shape (parts, draws), up to a constant."""
    root, size = mixture.root, draws.shape[1]
    straight = np.linalg.inv(root).T
    apart = (draws @ straight)[None] - (mixture.places @ straight)[:, None]
    square = np.einsum("pdn,pdn->pd", apart, apart)
    least = np.log(mixture.shares) - np.log(np.diag(root)).sum()
    return np.asarray(least[:, None] - (FREEDOM + size) / 2 * np.log1p(square / FREEDOM))


def _fitted(mixture: Mixture, weighted: Weighted) -> Mixture:
    """Return the mixture moved towards the weighted draws; a component with few of them stays.

    One covariance for all: of few draws a part's own would be too narrow.
    """
    logs, draws = _log_parts(mixture, weighted.draws), weighted.draws
    belongs = np.exp(logs - np.logaddexp.reduce(logs, axis=0))
    weights = np.minimum(weighted.weights, HEAVIEST)
    mine = belongs * (weights / weights.sum())
    shares = mine.sum(axis=1)
    moved = (mine @ draws) / np.maximum(shares, np.finfo(float).tiny)[:, None]
    places = np.where(shares[:, None] > LEAST_SHARE / 2, moved, mixture.places)
    covariance = KEPT * mixture.covariance
    for place, belonging in zip(places, mine, strict=True):
        apart = draws - place
        covariance = covariance + (1 - KEPT) * (apart * belonging[:, None]).T @ apart
    shares = np.maximum(shares, LEAST_SHARE)
    return Mixture(shares / shares.sum(), places, covariance)
