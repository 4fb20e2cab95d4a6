"""Draws from a player's posterior in a fraction of a second: Laplace's normal, then importance sampling about it.

From the likeliest parameters and the curvature there (Laplace) begins a mixture of two wide-tailed normals, the second
with the contact point on the other side of the bat's best place. The mixture is fitted to the weighted draws, round by
round [cappe2008]. No draw is thrown away: each is weighted by how likely it is against how often the mixtures of all
rounds together give it [cornuet2012]. Their effective number says when that is enough; `posterior.fit_player` walks
where it never is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array

ROUNDS, MOST_ROUNDS, DRAWS = 3, 8, 600
"""Rounds of draws at least and at most, and how many draws in each."""
GOOD = 300.0
"""Effective draws at which the rounds end."""
FREEDOM = 3.0
"""Degrees of freedom of the wide tails."""
WIDER = 1.25
"""Times the variance that the draws are wider than what was found."""
LEAST_SHARE = 0.08
"""Of either part of the mixture."""
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
class Part:
    """One part of the mixture: share, place, shape (n,), and covariance, shape (n, n)."""

    share: float
    place: Array
    covariance: Array


@dataclass(frozen=True)
class Weighted:
    """Weighted draws, and what they were drawn from.

    Parameters
    ----------
    draws : shape (draws, n).
    weights : shape (draws,); they add to one.
    heights : shape (draws,), logarithm of the density at every draw.
    mixtures : of every round, each with as many draws.
    """

    draws: Array
    weights: Array
    heights: Array
    mixtures: tuple[list[Part], ...]

    @property
    def effective(self) -> float:
        """Number of equally heavy draws that would tell as much: 1 / sum of squared weights."""
        return float(1 / np.sum(self.weights**2))


def importance_draws(log_density: Density, *, other_side: Callable[[Array], Array], size: int, seed: int) -> Weighted:
    """Return weighted draws of a density of ``size`` parameters that a standard normal is the scale of.

    Parameters
    ----------
    log_density : of rows of parameters, shape (rows, size) to (rows,), up to a constant; -inf where not allowed.
    other_side : gives the place whose density may be about as high as that of the highest.

    >>> log_density = lambda rows: -0.5 * ((rows - 1) ** 2).sum(axis=1)
    >>> drawn = importance_draws(log_density, other_side=lambda place: -place, size=2, seed=1)
    >>> bool(np.all(abs(drawn.weights @ drawn.draws - 1) < 0.1)), drawn.effective > 500
    (True, True)
    """
    place = highest(log_density, np.zeros(size))
    covariance = _covariance(log_density, place)
    parts = [Part(0.75, place, covariance), Part(0.25, other_side(place), covariance)]
    nothing = Weighted(np.empty((0, size)), np.empty(0), np.empty(0), ())
    return _drawn_on(nothing, parts, log_density, rounds=ROUNDS, seed=seed)


def drawn_further(known: Weighted, heights: Array, log_density: Density, *, seed: int) -> Weighted:
    """Return weighted draws of another density not far from that of draws that there are, which count again.

    Parameters
    ----------
    known : draws of the first density.
    heights : shape (draws,), logarithm of the other density at each of them.
    log_density : of rows of parameters, the other density.
    """
    again = _weighted(known.draws, heights, known.mixtures)
    if again.effective > GOOD:
        return again
    return _drawn_on(again, _fitted(list(known.mixtures[-1]), again), log_density, rounds=1, seed=seed)


def _drawn_on(known: Weighted, parts: list[Part], log_density: Density, *, rounds: int, seed: int) -> Weighted:
    """Return draws with so many rounds at least beyond those known, begun with a mixture, until enough count."""
    generator = np.random.default_rng(seed)
    weighted = known
    for turn in range(1, MOST_ROUNDS + 1):
        fresh = _drawn(parts, DRAWS, generator)
        weighted = _weighted(
            np.concatenate([weighted.draws, fresh]),
            np.concatenate([weighted.heights, log_density(fresh)]),
            (*weighted.mixtures, parts),
        )
        if turn >= rounds and weighted.effective > GOOD:
            break
        parts = _fitted(parts, weighted)
    return weighted


def _weighted(draws: Array, heights: Array, mixtures: tuple[list[Part], ...]) -> Weighted:
    """Return draws weighted by the density, whose logarithms are given, over the mean of all rounds' mixtures."""
    often = np.logaddexp.reduce(np.concatenate([_log_parts(parts, draws) for parts in mixtures]), axis=0)
    log_weight = heights - often
    weights = np.exp(log_weight - log_weight.max())
    return Weighted(draws, weights / weights.sum(), heights, mixtures)


def highest(log_density: Density, start: Array) -> Array:
    """Return a place where the density is highest near ``start``, found with slopes from differences."""
    from scipy.optimize import minimize

    steps = GRADIENT_STEP * np.eye(len(start))

    def low(place: Array) -> tuple[float, Array]:
        rows = np.concatenate([place[None], place + steps, place - steps])
        values = np.nan_to_num(-log_density(rows), nan=1e6, posinf=1e6)
        size = len(start)
        return float(values[0]), (values[1 : size + 1] - values[size + 1 :]) / (2 * GRADIENT_STEP)

    minimum = minimize(low, start, jac=True, method="BFGS", options={"gtol": 0.05, "maxiter": 40})
    return np.asarray(minimum.x)


def _covariance(log_density: Density, place: Array) -> Array:
    """Return the inverse of the curvature at a place, no direction wider than about the prior."""
    size = len(place)
    steps = CURVATURE_STEP * np.eye(size)
    first, second = np.tril_indices(size, -1)
    rows = [place[None], place + steps, place - steps, place + steps[first] + steps[second],
            place - steps[first] - steps[second]]  # fmt: skip
    values = -log_density(np.concatenate(rows))
    middle, ahead, behind = values[0], values[1 : size + 1], values[size + 1 : 2 * size + 1]
    curvature = np.diag(ahead + behind - 2 * middle)
    both = values[2 * size + 1 :].reshape(2, -1).sum(axis=0) + 2 * middle
    curvature[first, second] = curvature[second, first] = (
        both - ahead[first] - behind[first] - ahead[second] - behind[second]
    ) / 2
    scale, axes = np.linalg.eigh(np.nan_to_num(curvature / CURVATURE_STEP**2, posinf=1.0, neginf=1.0))
    return np.asarray((axes / np.clip(scale, FLATTEST, None)) @ axes.T)


def _drawn(parts: list[Part], count: int, generator: np.random.Generator) -> Array:
    """Return draws of the mixture of wide-tailed normals, shape (count, n)."""
    size = len(parts[0].place)
    which = generator.choice(len(parts), count, p=[part.share for part in parts])
    normal = generator.standard_normal((count, size))
    normal /= np.sqrt(generator.chisquare(FREEDOM, count) / FREEDOM)[:, None]
    draws = np.empty((count, size))
    for index, part in enumerate(parts):
        mine = which == index
        draws[mine] = part.place + normal[mine] @ np.linalg.cholesky(WIDER * part.covariance).T
    return draws


def _log_parts(parts: list[Part], draws: Array) -> Array:
    """Return the logarithm of share times density of each part, shape (parts, draws), up to a constant."""
    logs = []
    for part in parts:
        root = np.linalg.cholesky(WIDER * part.covariance)
        square = np.sum(np.linalg.solve(root, (draws - part.place).T) ** 2, axis=0)
        size = len(part.place)
        logs.append(
            np.log(part.share) - np.log(np.diag(root)).sum() - (FREEDOM + size) / 2 * np.log1p(square / FREEDOM)
        )
    return np.array(logs)


def _fitted(parts: list[Part], weighted: Weighted) -> list[Part]:
    """Return the mixture moved to where the weighted draws are; a part that few of them belong to stays."""
    logs = _log_parts(parts, weighted.draws)
    belongs = np.exp(logs - np.logaddexp.reduce(logs, axis=0))
    weights = np.minimum(weighted.weights, HEAVIEST)
    weights = weights / weights.sum()
    moved = []
    for part, mine in zip(parts, belongs * weights, strict=True):
        share = float(mine.sum())
        if share < LEAST_SHARE / 4:
            moved.append(Part(LEAST_SHARE, part.place, part.covariance))
            continue
        place = mine @ weighted.draws / share
        apart = weighted.draws - place
        covariance = (apart * mine[:, None]).T @ apart / share
        moved.append(Part(max(share, LEAST_SHARE), place, (1 - KEPT) * covariance + KEPT * part.covariance))
    total = sum(part.share for part in moved)
    return [Part(part.share / total, part.place, part.covariance) for part in moved]
