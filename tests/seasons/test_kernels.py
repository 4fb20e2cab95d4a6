"""Compiled sums over places along the bat, against the same sums written out."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import norm

from sweetspot.seasons.place_kernel import (
    EVIDENCE,
    MIDDLE,
    SCATTER,
    WRONG,
    WRONG_RANGE,
    expect,
    fill_products,
    fill_variances,
    weigh,
)

PLACES = np.linspace(0.0, 0.5, 57)
FAST = np.where(PLACES < 0.45, 45 - 120 * (PLACES - 0.15) ** 2, np.nan)
OUT, SPREAD, MEAN, WIDTH, LEVEL = 43.0, 0.9, 0.17, 0.045, 0.01


def test_sums_over_terms_are_those_of_matrices() -> None:
    """Agreement with numpy, over more balls than are worked on together."""
    rng = np.random.default_rng(2)
    terms, weight, root = rng.normal(size=(5, 1300)), rng.uniform(size=1300), rng.normal(size=(5, 5))
    products, variances = np.empty((5, 5)), np.empty(1300)
    fill_products(terms, weight, products)
    assert products == pytest.approx(terms * weight @ terms.T, rel=1e-12)
    fill_variances(root @ root.T, terms, variances)
    assert variances == pytest.approx(np.diag(terms.T @ root @ root.T @ terms), rel=1e-12)


def test_weights_of_places_are_bayes_rule_written_out() -> None:
    """Agreement: with scipy's normal distribution, to the 8e-8 of the formula for its tail."""
    part, work = np.empty(len(PLACES)), np.empty((4, len(PLACES)))
    total, before, rank, fast = weigh(PLACES, FAST, OUT, SPREAD, MEAN, WIDTH, LEVEL, part, work)
    known = np.isfinite(FAST)
    here = np.where(known, np.exp(-0.5 * ((PLACES - MEAN) / WIDTH) ** 2), 0.0)
    speed = np.nan_to_num((1 + LEVEL) * FAST)
    match = (1 - WRONG) * norm.pdf(OUT, speed, SPREAD) + WRONG / WRONG_RANGE
    assert part == pytest.approx(here * match, rel=1e-12, abs=1e-300)
    assert (total, before) == pytest.approx(((here * match).sum(), here.sum()), rel=1e-12)
    assert rank == pytest.approx((here * norm.cdf(OUT, speed, SPREAD)).sum(), abs=8e-8 * before)
    assert fast == pytest.approx((here * np.nan_to_num(FAST)).sum(), rel=1e-12)
    found = np.empty((1, 6))
    expect(PLACES, FAST[None], np.array([OUT]), np.array([SPREAD]), np.array([[MEAN, WIDTH]]), np.array([LEVEL]), found)
    weights = np.where(np.abs(PLACES - MEAN) < 5 * WIDTH, here, 0.0)
    both = weights * match / (weights * match).sum()
    middle = (both * PLACES).sum()
    assert found[0, MIDDLE] == pytest.approx(middle, rel=1e-12)
    assert found[0, SCATTER] == pytest.approx((both * (PLACES - middle) ** 2).sum(), rel=1e-9)
    assert found[0, EVIDENCE] == pytest.approx(np.log((weights * match).sum() / weights.sum()), rel=1e-12)
