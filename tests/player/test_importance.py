"""Weighted draws: known densities come back, and players come out as the walkers find them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import emcee
import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.numerics.arrays import Array
from sweetspot.player.importance import highest, importance_draws
from sweetspot.player.model import PlayerModel, player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import ENOUGH, fit_player
from sweetspot.player.prior import NAMES, natural, prior_draws, standardised
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import MPH

BALL, BAT = catalog.ball(), catalog.bat("r161-ash")
TYPICAL = np.array([0.4, 0.3, 0.4, 0.3, -0.3, 0.2, -0.2, 0.1, 0.2, 0.0])


def modelled(count: int, standard: Array = TYPICAL) -> PlayerModel:
    swings = simulated_swings(natural(standard), bats=[BAT], ball=BALL, count=count, pitch_speed=82 * MPH, seed=3)
    return player_model(swings, bat=BAT, ball=BALL)


def test_a_slanted_normal_comes_back() -> None:
    """Exact: mean and covariance of a normal density, to 5 standard errors."""
    covariance = np.array([[1.0, 0.6, 0.0], [0.6, 0.5, 0.1], [0.0, 0.1, 0.2]])
    mean, inverse = np.array([0.5, -1.0, 0.2]), np.linalg.inv(covariance)

    def density(rows: Array) -> Array:
        return np.asarray(-0.5 * np.einsum("ri,ij,rj->r", rows - mean, inverse, rows - mean))

    found = importance_draws(density, along=0, skewed=1, size=3, seed=4)
    assert found.weights.sum() == pytest.approx(1.0) and found.effective > 500
    average = found.weights @ found.draws
    apart = found.draws - average
    assert average == pytest.approx(mean, abs=5 / np.sqrt(found.effective))
    assert (apart * found.weights[:, None]).T @ apart == pytest.approx(covariance, abs=0.2)
    assert highest(density, np.zeros(3)) == pytest.approx(mean, abs=0.05)


def test_a_density_that_ends_beside_its_peak_comes_back() -> None:
    """Exact: the mean of half a standard normal is -sqrt(2 / pi); what is not allowed beside it warns of nothing."""

    def density(rows: Array) -> Array:
        return np.where(rows[:, 2] > 0.001, -np.inf, -0.5 * np.sum(rows**2, axis=1))

    found = importance_draws(density, along=0, skewed=1, size=3, seed=5)
    assert found.weights @ found.draws[:, 2] == pytest.approx(-np.sqrt(2 / np.pi), abs=0.1)


def test_both_of_two_hills_are_found() -> None:
    """Exact: two normals at -2 and 2 in one direction, with shares 0.7 and 0.3."""

    def density(rows: Array) -> Array:
        rest = -0.5 * np.sum(rows[:, 1:] ** 2, axis=1)
        hills = [np.log(share) - 0.5 * ((rows[:, 0] - at) / 0.4) ** 2 for share, at in ((0.7, -2.0), (0.3, 2.0))]
        return np.asarray(rest + np.logaddexp(*hills))

    found = importance_draws(density, along=0, skewed=1, size=3, seed=2)
    assert found.weights[found.draws[:, 0] < 0].sum() == pytest.approx(0.7, abs=0.08)


def test_the_long_tail_towards_a_small_scatter_along_the_bat_is_drawn() -> None:
    """300,000 draws of emcee from the same posterior: uncertain by 0.392 ± 0.01, 1 % below -1.45 ± 0.05."""
    model = modelled(60, -1.0 * (np.arange(10) == NAMES.index("position_spread")))
    drawn = [importance_draws(model.log_posterior, along=3, skewed=4, size=10, seed=seed) for seed in range(8)]
    deviations = [np.sqrt(np.cov(one.draws[:, 4], aweights=one.weights)) for one in drawn]
    assert np.mean(deviations) == pytest.approx(0.392, rel=0.06)
    every = np.concatenate([one.draws[:, 4] for one in drawn])
    by_place = np.argsort(every)
    below = np.cumsum(np.concatenate([one.weights for one in drawn])[by_place]) / len(drawn)
    assert every[by_place][np.searchsorted(below, 0.01)] == pytest.approx(-1.45, abs=0.15)


def test_without_data_the_draws_are_the_prior() -> None:
    model = player_model([PlayerSwing(2, None, None, None, None, None, None, "")], bat=BAT, ball=BALL)
    result = fit_player(model, seed=3)
    for name, one in result.learned.items():
        assert one.independent_draws > ENOUGH
        assert abs(np.mean(standardised(result.draws)[:, NAMES.index(name)])) < 0.2, name
        assert one.width_ratio == pytest.approx(1.0, abs=0.15), name


def walked(model: PlayerModel, start: Array, *, steps: int, warm_up: int) -> Array:
    """Return standard parameters from an ensemble of walkers [foreman2013]."""
    moves = [(emcee.moves.DEMove(), 0.85), (emcee.moves.DEMove(gamma0=1.0), 0.15)]
    sampler = emcee.EnsembleSampler(40, len(NAMES), model.log_posterior, moves=moves, vectorize=True)
    sampler.random_state = np.random.RandomState(1).get_state()
    sampler.run_mcmc(start, warm_up + steps)
    return np.asarray(sampler.get_chain(discard=warm_up, flat=True))


def test_a_player_comes_out_as_the_walkers_find_it() -> None:
    """Agreement with an independent sampler: means to 0.35 standard deviations, widths to 35 %, both samplers noisy."""
    model = modelled(60)
    drawn = fit_player(model)
    assert drawn.converged
    mine = standardised(drawn.draws)
    apart = mine.mean(axis=0) + 2 * (mine - mine.mean(axis=0))
    begin = apart[np.isfinite(model.log_posterior(apart))][:40]
    theirs = walked(model, begin, steps=500, warm_up=250)
    assert np.abs((mine.mean(axis=0) - theirs.mean(axis=0)) / theirs.std(axis=0)).max() < 0.35
    assert mine.std(axis=0) / theirs.std(axis=0) == pytest.approx(np.ones(10), abs=0.35)


@pytest.mark.parametrize(
    "left_out",
    [(), ("attack_angle",), ("attack_angle", "launch_angle"), ("attack_angle", "launch_angle", "bat_speed"),
     ("attack_angle", "launch_angle", "exit_speed")], ids=len,
)  # fmt: skip
@pytest.mark.parametrize("side", [-1.5, 1.5])
def test_enough_draws_count_whatever_was_measured(left_out: tuple[str, ...], side: float) -> None:
    """Also of players at the edge of what is known before; docs/decisions/samplers.md has 373 files."""
    swings = modelled(20, np.where(np.arange(10) == NAMES.index("exponent"), 0.0, side)).swings
    nothing: dict[str, Any] = dict.fromkeys(left_out)
    bare = [replace(swing, **nothing) for swing in swings]
    assert fit_player(player_model(bare, bat=BAT, ball=BALL)).converged


def test_one_swing_copied_is_told_as_too_few_draws() -> None:
    player = natural(prior_draws(1, seed=21)[0])
    swings = simulated_swings(player, bats=[BAT], ball=BALL, count=1, pitch_speed=82 * MPH, seed=0)
    copied = fit_player(player_model([*swings] * 40, bat=BAT, ball=BALL))
    assert not copied.converged and all(one.independent_draws < ENOUGH for one in copied.learned.values())


def test_the_same_seed_gives_the_same_draws() -> None:
    model = modelled(20)
    first, second, other = (fit_player(model, seed=seed) for seed in (1, 1, 2))
    assert np.array_equal(first.draws, second.draws) and not np.array_equal(first.draws, other.draws)
