"""Small least-squares problems against SciPy's solvers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import least_squares, nnls

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.least_squares import nearly_straight_least_squares, nonnegative_least_squares


@given(st.integers(0, 10**6), st.integers(1, 12), st.integers(1, 12), st.booleans())
def test_no_other_nonnegative_vector_comes_nearer(seed: int, rows: int, count: int, twice: bool) -> None:
    generator = np.random.default_rng(seed)
    system, right = generator.normal(size=(rows, count)), generator.normal(size=rows)
    if twice:  # a column that is there twice leaves the best vector open
        system[:, 0] = system[:, -1]
    found = nonnegative_least_squares(system, right)
    _, distance = nnls(system, right)
    assert np.all(found >= 0)
    assert np.linalg.norm(system @ found - right) == pytest.approx(distance, abs=1e-9)


def bent(x: Array) -> Array:
    return np.array([np.exp(0.3 * x[0]) - 1.4 + 0.1 * x[1], x[1] ** 2 / 10 + x[1] - 0.5, 0.2 * (x[0] - x[1])])


def slopes_of_bent(x: Array) -> Array:
    return np.array([[0.3 * np.exp(0.3 * x[0]), 0.1], [0.0, x[1] / 5 + 1], [0.2, -0.2]])


def test_nearly_straight_misses_have_scipys_least_squares() -> None:
    found = nearly_straight_least_squares(bent, slopes_of_bent, 2, farthest=8.0, close=1e-10)
    assert found == pytest.approx(least_squares(bent, np.zeros(2), xtol=1e-12, ftol=1e-14).x, abs=1e-7)


@pytest.mark.parametrize(
    ("misses", "slopes"),
    [
        (lambda x: x - 9.0, lambda x: np.ones((1, len(x)))),  # the least lies beyond the limits
        (lambda x: np.arctan(5 * (x - 1.0)), lambda x: np.diag(5 / (1 + 25 * (x - 1.0) ** 2))),  # a step too far
    ],
)
def test_a_search_that_fails_says_so(misses: object, slopes: object) -> None:
    assert callable(misses) and callable(slopes)
    assert nearly_straight_least_squares(misses, slopes, 1, farthest=8.0, close=1e-9) is None
