"""Weighted draws: known densities come back, and players come out as the walkers find them."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.numerics.arrays import Array
from sweetspot.player.importance import highest, importance_draws
from sweetspot.player.model import PlayerModel, player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import ENOUGH, fit_player, walked
from sweetspot.player.prior import NAMES, natural, standardised
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
    """18,000 draws: the scatter is uncertain by 0.429; normals that do not reach down to small ones give 0.398."""
    model = modelled(60, -1.0 * (np.arange(10) == NAMES.index("position_spread")))
    drawn = [importance_draws(model.log_posterior, along=3, skewed=4, size=10, seed=seed) for seed in range(8)]
    deviations = [np.sqrt(np.cov(one.draws[:, 4], aweights=one.weights)) for one in drawn]
    assert np.mean(deviations) == pytest.approx(0.429, rel=0.05)


def test_without_data_the_draws_are_the_prior() -> None:
    model = player_model([PlayerSwing(2, None, None, None, None, None, None, "")], bat=BAT, ball=BALL)
    result = fit_player(model, seed=3)
    for name, one in result.learned.items():
        assert one.independent_draws > ENOUGH
        assert abs(np.mean(standardised(result.draws)[:, NAMES.index(name)])) < 0.2, name
        assert one.width_ratio == pytest.approx(1.0, abs=0.15), name


def test_a_player_comes_out_as_the_walkers_find_it() -> None:
    """Agreement with an independent sampler: means to 0.35 standard deviations, widths to 35 %, both samplers noisy."""
    model = modelled(60)
    drawn, walking = fit_player(model), walked(model, steps=500, warm_up=250)
    assert drawn.converged
    mine, theirs = standardised(drawn.draws), standardised(walking.draws)
    assert np.abs((mine.mean(axis=0) - theirs.mean(axis=0)) / theirs.std(axis=0)).max() < 0.35
    assert mine.std(axis=0) / theirs.std(axis=0) == pytest.approx(np.ones(10), abs=0.35)


def test_the_same_seed_gives_the_same_draws() -> None:
    model = modelled(20)
    first, second, other = (fit_player(model, seed=seed) for seed in (1, 1, 2))
    assert np.array_equal(first.draws, second.draws) and not np.array_equal(first.draws, other.draws)
