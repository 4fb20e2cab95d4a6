"""Intervals and Sobol indices of draws against closed forms and another program."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import scipy.stats

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, LEVEL, REACH
from sweetspot.uncertainty.intervals import TOGETHER, interval_ends, reach_of_draws, variance_shares

NAMES = ("a", "b", "c")


@pytest.fixture(scope="module")
def normal() -> Array:
    even = scipy.stats.qmc.Sobol(3, seed=3).random(1024)
    return np.vstack([np.zeros((1, 3)), scipy.stats.norm.ppf(np.clip(even, 1e-9, 1 - 1e-9))])


def crooked(z: Array) -> Array:
    return np.asarray(2 * z[0] + z[1] ** 2 + z[0] * z[2])


def test_shares_of_a_known_function(normal: Array) -> None:
    """2 a + b^2 + a c has the variance 4 + 2 + 1."""
    shares = variance_shares(normal[1:], NAMES, crooked(normal[1:].T))
    assert shares == pytest.approx({"a": 4 / 7, "b": 2 / 7, "c": 0.0, TOGETHER: 1 / 7}, abs=0.02)
    assert list(shares)[:2] == ["a", "b"]


def test_shares_against_the_estimator_of_scipy(normal: Array) -> None:
    """Saltelli's way with its own 5 x 4096 calls of the function, as `scipy.stats` has it."""
    independent: list[Any] = [scipy.stats.norm()] * 3
    theirs = scipy.stats.sobol_indices(func=crooked, n=4096, dists=independent, random_state=1).first_order
    ours = variance_shares(normal[1:], NAMES, crooked(normal[1:].T))
    assert [ours[name] for name in NAMES] == pytest.approx(np.ravel(theirs).tolist(), abs=0.04)


def test_sources_of_one_name_are_one(normal: Array) -> None:
    shares = variance_shares(normal[1:], ("bat", "bat", "bat"), crooked(normal[1:].T))
    assert shares["bat"] == pytest.approx(1.0, abs=0.02)


def test_the_level_its_ends_and_its_reach_are_one() -> None:
    """Exact: the normal distribution."""
    assert (1 - ENDS[0] - (1 - ENDS[1]), math.erf(REACH / math.sqrt(2))) == pytest.approx((LEVEL, LEVEL), abs=1e-12)


def test_interval_of_a_normal_answer(normal: Array) -> None:
    reach = reach_of_draws(5 + 0.1 * normal[:, 0])
    assert (float(reach.below), float(reach.above)) == pytest.approx((0.1 * REACH, 0.1 * REACH), rel=0.01)
    assert np.isnan(interval_ends(np.full((len(normal), 2), np.nan))[0]).all()


def test_one_source_alone_causes_everything() -> None:
    """A flight as it is usually asked for doubts its drag only."""
    normal = np.random.default_rng(1).standard_normal((200, 1))
    shares = variance_shares(normal, ("drag",), 2 * normal[:, 0])
    assert shares["drag"] == pytest.approx(1.0)
