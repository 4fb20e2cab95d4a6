"""Polynomials on pieces and cubic splines beside scipy's."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, PPoly

from sweetspot.numerics.piecewise import MANY, Piecewise, cubic_spline

seeds = st.integers(0, 2**32 - 1)


@given(seeds, st.integers(4, 12), st.sampled_from([(), (3,), (2, 4)]))
def test_splines_are_those_of_scipy(seed: int, count: int, shape: tuple[int, ...]) -> None:
    chance = np.random.default_rng(seed)
    places, values = np.cumsum(chance.uniform(0.1, 1.0, count)), chance.normal(size=(count, *shape))
    ours, theirs = cubic_spline(places, values), CubicSpline(places, values)
    asked = chance.uniform(places[0] - 0.5, places[-1] + 0.5, (5, 2))  # beyond its ends too
    for order in range(5):
        assert ours(asked, order) == pytest.approx(theirs(asked, order), rel=1e-9, abs=1e-9)
    assert ours(places) == pytest.approx(values, rel=1e-12, abs=1e-12)


@given(seeds)
def test_roots_are_those_of_scipy(seed: int) -> None:
    chance = np.random.default_rng(seed)
    ends = np.cumsum(chance.uniform(0.1, 1.0, 9))
    quartics = chance.normal(size=(5, 8))
    quartics[:2, 0] = 0.0  # a piece of a lower degree
    expected = PPoly(quartics, ends, extrapolate=False).roots(discontinuity=False)
    assert Piecewise(quartics, ends).roots() == pytest.approx(np.unique(expected), rel=1e-9)


def test_a_function_that_is_zero_on_a_piece_has_no_roots_there() -> None:
    still = Piecewise(np.array([[0.0, 1.0], [0.0, -0.25]]), np.array([0.0, 1.0, 2.0]))
    assert still.roots() == pytest.approx([1.25])


@pytest.mark.parametrize("functions", [(), (3,)])
def test_many_places_are_few_places_to_the_last_digit(functions: tuple[int, ...]) -> None:
    """From `MANY` places on compiled code does the sums."""
    generator = np.random.default_rng(5)
    curve = Piecewise(generator.normal(size=(4, 6, *functions)), np.array([0.0, 0.1, 0.3, 0.4, 0.7, 0.9, 1.0]))
    places = generator.uniform(-0.1, 1.1, (MANY, 2))
    for order in (0, 1):
        one_by_one = np.array([[curve(place, order) for place in row] for row in places])
        assert np.array_equal(curve(places, order), one_by_one)
