"""Partial pooling: what a league tells of its players, and what it does to players of few and of many swings."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.numerics.arrays import Array
from sweetspot.player import posterior
from sweetspot.player.model import player_model
from sweetspot.player.posterior import (
    PlayerPosterior,
    SwingEvidence,
    fit_player,
    likeliest_population,
    own_share,
    population_of,
    refitted,
)
from sweetspot.player.prior import ANYBODY, NAMES, Population, natural, standardised
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import MPH

BALL, BAT = catalog.ball(), catalog.bat("r161-ash")
SWINGS = (8, 8, 8, 8, 8, 8, 8, 60)
"""Of each made-up batter: seven of few, one of many."""


def test_the_slope_is_that_of_the_height() -> None:
    """Exact: central differences of the height in every mean and logarithm of a variance."""
    draw = np.random.default_rng(3).standard_normal
    roots = draw((6, 3, 3))
    told = SwingEvidence(roots @ roots.transpose(0, 2, 1), draw((6, 3)))
    place = np.array([0.3, -0.2, 0.5, -0.7, 0.1, -1.2])

    def height(at: Array) -> tuple[float, Array]:
        return posterior._height(told, at[:3], np.exp(at[3:]))

    steps = 1e-5 * np.eye(6)
    differences = [(height(place + step)[0] - height(place - step)[0]) / 2e-5 for step in steps]
    assert height(place)[1] == pytest.approx(differences, abs=1e-6)


def test_what_no_swing_tells_keeps_its_prior() -> None:
    """Exact: half of the prior's variance between leagues and half within are the prior, but for the model's doubt."""
    found = likeliest_population(SwingEvidence(np.zeros((30, 2, 2)), np.zeros((30, 2))))
    assert found.mean == pytest.approx(np.zeros(2), abs=1e-6)
    assert found.spread**2 == pytest.approx(np.full(2, 1 + posterior.MODEL_DOUBT**2), abs=1e-3)


def test_a_told_league_comes_back_through_noise() -> None:
    """Exact in law: players about 0.8 with 0.3, told with precisions of 4 to 16; to 4 standard errors."""
    generator = np.random.default_rng(5)
    truth, precision = generator.normal(0.8, 0.3, 600), generator.uniform(4, 16, 600)
    seen = truth + generator.standard_normal(600) / np.sqrt(precision)
    found = likeliest_population(SwingEvidence(precision[:, None, None], (precision * seen)[:, None]))
    assert found.mean[0] == pytest.approx(0.8, abs=0.07)
    assert np.sqrt(found.spread[0] ** 2 - posterior.MODEL_DOUBT**2) == pytest.approx(0.3, abs=0.08)


@pytest.fixture(scope="module")
def alone() -> list[PlayerPosterior]:
    """Batters of one league, alike but for a little, each fitted alone."""
    draw = np.random.default_rng(9).standard_normal
    fits = []
    for number, count in enumerate(SWINGS):
        swings = simulated_swings(
            natural(0.5 + 0.2 * draw(10)), bats=[BAT], ball=BALL, count=count, pitch_speed=82 * MPH, seed=number
        )
        fits.append(fit_player(player_model(swings, bat=BAT, ball=BALL), seed=number))
    return fits


def test_few_swings_lean_on_the_league_and_many_hardly_move(alone: list[PlayerPosterior]) -> None:
    found = population_of(alone)
    assert found is not None
    narrow = Population(found.mean, np.minimum(found.spread, 0.4))
    pooled = [refitted(one, narrow) for one in alone]
    scatter = NAMES.index("bat_speed_spread")

    def middle(fit: PlayerPosterior) -> float:
        return float(standardised(fit.draws)[:, scatter].mean())

    moved = [abs(middle(after) - middle(before)) for before, after in zip(alone, pooled, strict=True)]
    assert np.mean(moved[:-1]) > 2 * moved[-1]
    apart = [np.std([middle(one) for one in fits]) for fits in (alone, pooled)]
    assert apart[1] < apart[0]
    shares = [own_share(one, narrow)["bat_speed_spread"] for one in pooled]
    assert shares[-1] > max(shares[:-1])
    assert all(0 <= share <= 1 for share in own_share(pooled[0], narrow).values())


def test_a_league_that_is_the_prior_changes_nothing(alone: list[PlayerPosterior]) -> None:
    """Exact: the same draws with the same weights."""
    again = refitted(alone[0], ANYBODY)
    assert alone[0].weighted is not None and again.weighted is not None
    assert np.array_equal(again.weighted.draws, alone[0].weighted.draws)
    assert again.weighted.weights == pytest.approx(alone[0].weighted.weights, abs=1e-15)


@pytest.mark.parametrize(("width", "share"), [(1.0, 0.0), (0.5, 0.75), (1.2, 0.0)])
def test_the_own_share_is_what_the_variance_falls_by(alone: list[PlayerPosterior], width: float, share: float) -> None:
    """Exact: as wide as the league nothing is the batter's own, half as wide three quarters are."""
    narrow = Population(np.zeros(10), np.full(10, 0.4))
    learned = {name: replace(one, width_ratio=width * 0.4) for name, one in alone[0].learned.items()}
    found = own_share(replace(alone[0], learned=learned), narrow)
    assert set(found) == set(NAMES) and list(found.values()) == pytest.approx([share] * 10)


def test_four_batters_are_no_league(alone: list[PlayerPosterior]) -> None:
    assert population_of(alone[:4]) is None
    heavy = alone[0].lighter()
    assert len(heavy.draws) == 200 and heavy.learned is alone[0].learned
