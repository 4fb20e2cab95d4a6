"""The relation of places learnt from a table: what makes its exit speeds most likely, the places summed over.

Expectation tells where balls may have been met, maximisation what fits best there, in turn (`place_relation` has the
relation itself).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.threads import in_parts
from sweetspot.seasons.place_kernel import EVIDENCE, MIDDLE, PRODUCT, SCATTER, SHARE, SQUARE, expect, fill_products
from sweetspot.seasons.place_relation import (
    LEVEL,
    LEVEL_WIDTHS,
    NOISE,
    NOISE_WIDTHS,
    PLACE,
    PLACE_WIDTHS,
    SPREAD,
    SPREAD_WIDTHS,
    UNLEARNT,
    USUAL_LEVELS,
    USUAL_NOISES,
    USUAL_SPREADS,
    USUAL_WEIGHTS,
    Circumstances,
    PlaceRelation,
    summed,
    variance_of,
)
from sweetspot.units import INCH, MPH

NOISES = math.log(0.05 * MPH), math.log(40 * MPH)
"""Least and greatest noise of usual swings, as the logarithm of m/s."""
ROUNDS = 50
"""Most leaps; a dozen are usual."""
SIZES = np.array([*[1.8 * INCH] * len(PLACE), *[1.0] * len(SPREAD), *LEVEL_WIDTHS, *[1.0] * len(NOISE)])
"""By which the relation's weights are measured in saying how far a step went."""
NEAR = 1e-3
"""In these, steps that change nothing: 0.05 mm, 2e-5 of level, a thousandth of the noise."""
CHUNK = 2500
"""Balls per task handed to a thread."""
ENOUGH = 50
"""Balls below which nothing is learnt and the usual numbers stand."""


START = replace(
    UNLEARNT,
    weights=np.array([6.5 * INCH, -2 * INCH, *np.zeros(len(PLACE) - 2)]),
    spread_weights=np.array([math.log(1.8 * INCH), *np.zeros(len(SPREAD) - 1)]),
)
"""Where learning begins: about the middle of the barrel. Where pitches do not tell, the side that a table's balls are
met on has two answers."""


@dataclass(frozen=True)
class Sample:
    """Balls to learn from.

    ``places``: m from the tip, even, shape (k,). ``predicted``: m/s, exit speed at every place, shape (n, k); NaN where
    none. ``measured``, ``error``: m/s, exit speeds and their measuring errors, shape (n,). ``place``, ``spread``,
    ``level``, ``noise``: what the relation's sums are over, shape (terms, n). ``measured_places``: m from the tip,
    places that were measured, 0 where none was, shape (n,). ``sure``: 1 / m^2, one over the variance of their errors, 0
    where none was, shape (n,).
    """

    places: Array
    predicted: Array
    measured: Array
    error: Array
    place: Array
    spread: Array
    level: Array
    noise: Array
    measured_places: Array
    sure: Array


def learn_places(
    conditions: Circumstances, *, places: Array, predicted: Array, measured: Array, error: Array, turned: Array,
    measured_places: Array,
) -> PlaceRelation:  # fmt: skip
    """Return the relation that makes measured exit speeds, and places where there are such, most likely.

    ``places``: m from the tip, even, shape (k,). ``predicted``: m/s, exit speed at every place, shape (n, k); NaN where
    none. ``measured``, ``error``: m/s, exit speeds and their measuring errors, shape (n,). ``turned``: of the balls,
    from `turn_term`. ``measured_places``: m from the tip, and 1 / m^2, one over the variance of its error; both 0 where
    none was measured, shape (2, n).
    """
    good = np.asarray(np.isfinite(predicted).any(axis=1)) & np.isfinite(error)
    if good.sum() < ENOUGH:
        return UNLEARNT
    conditions, turned = conditions.some(good), turned[good]
    usual = np.array([1.0, *np.zeros(len(PLACE) - 1)])
    readings = places, np.ascontiguousarray(predicted[good]), measured[good], error[good]
    of_place = np.where(conditions.placed, conditions.terms(PLACE), usual[:, None]), conditions.terms(SPREAD)
    of_speed = conditions.terms(LEVEL, turned), conditions.terms(NOISE, turned)
    sample = Sample(*readings, *of_place, *of_speed, *measured_places[:, good])
    now, evidence = _climbed(START, sample)
    everywhere = summed(sample.place, now.weights)[conditions.placed if conditions.placed.any() else slice(None)]
    spread = np.sqrt(np.mean(np.exp(2 * summed(sample.spread, now.spread_weights))))
    return replace(
        now,
        evidence=evidence,
        balls=int(good.sum()),
        marginal=(float(everywhere.mean()), float(np.hypot(spread, everywhere.std()))),
    )


def _climbed(now: PlaceRelation, sample: Sample) -> tuple[PlaceRelation, float]:
    """Return the most likely weights, from some to begin with, and the logarithm of their likelihood.

    Two steps of expectation and maximisation tell how far the way still is, and a leap goes there; it counts where the
    next step is no longer than the first was [varadhan_roland2008].
    """
    moments = np.zeros((len(sample.measured), 6))

    def stepped(now: PlaceRelation) -> PlaceRelation:
        inverse = np.exp(-2 * summed(sample.spread, now.spread_weights))
        both = inverse + sample.sure
        mean = (inverse * summed(sample.place, now.weights) + sample.sure * sample.measured_places) / both
        prior = np.stack([mean, 1 / np.sqrt(both)], axis=-1)
        scatter = np.hypot(sample.error, np.exp(summed(sample.noise, now.noise_weights)))
        level = summed(sample.level, now.level_weights)

        def work(part: slice) -> None:
            seen = sample.predicted[part], sample.measured[part], scatter[part], prior[part], level[part]
            expect(sample.places, *seen, moments[part])

        in_parts(work, len(moments), size=CHUNK)
        return _maximised(now, sample, moments)

    for _ in range(ROUNDS):
        first = stepped(now)
        second = stepped(first)
        leapt = _with_numbers(_leapt(_numbers(now), _numbers(first), _numbers(second)))
        third = stepped(leapt)
        before, now = now, third if _apart(third, leapt) <= _apart(first, now) else second
        if _apart(now, before) < NEAR:
            break
    return _with_covariances(now, sample, moments), float(moments[:, EVIDENCE].sum())


def _leapt(first: Array, second: Array, third: Array) -> Array:
    """Return the limit of three steps, each shorter than the one before in the same proportion."""
    step, bend = (second - first) / SIZES, (third - 2 * second + first) / SIZES
    far = max(float(np.linalg.norm(step)) / max(float(np.linalg.norm(bend)), 1e-12), 1.0)
    return np.asarray(first + (2 * far * step + far**2 * bend) * SIZES)


def _apart(first: PlaceRelation, second: PlaceRelation) -> float:
    return float(np.linalg.norm((_numbers(first) - _numbers(second)) / SIZES))


def _numbers(relation: PlaceRelation) -> Array:
    return np.concatenate([relation.weights, relation.spread_weights, relation.level_weights, relation.noise_weights])


def _with_numbers(numbers: Array) -> PlaceRelation:
    ends = np.cumsum([len(PLACE), len(SPREAD), len(LEVEL)])
    weights, spreads, levels, noises = np.split(numbers, ends)
    return PlaceRelation(weights, spreads, levels, noises)


def _maximised(now: PlaceRelation, sample: Sample, moments: Array) -> PlaceRelation:
    """Return the weights that fit best where the balls are thought to have been met."""
    inverse, noise, heavy = _scatters(now, sample)
    weights = _solved(sample.place, inverse, moments[:, MIDDLE], USUAL_WEIGHTS, PLACE_WIDTHS)
    square = _squares_of_places(weights, inverse, _place_covariance(inverse, sample, moments), sample, moments)
    spreads = now.spread_weights + _scored(
        sample.spread, np.ones_like(square), square - 1, now.spread_weights - USUAL_SPREADS, SPREAD_WIDTHS
    )
    product, square = moments[:, PRODUCT], moments[:, SQUARE]
    levels = _solved(sample.level, heavy * square, product / np.maximum(square, 1e-12) - 1, USUAL_LEVELS, LEVEL_WIDTHS)
    part = noise * heavy  # of the variance that is noise
    off = _noise_scores(levels, part, heavy, sample, moments)
    step = _scored(sample.noise, part**2 * moments[:, SHARE], off, now.noise_weights - USUAL_NOISES, NOISE_WIDTHS)
    noises = now.noise_weights + np.clip(step, -0.5, 0.5)
    noises[0] = np.clip(noises[0], *NOISES)
    return PlaceRelation(weights, spreads, levels, noises)


def _scatters(now: PlaceRelation, sample: Sample) -> tuple[Array, Array, Array]:
    """Return of each ball 1 / tau^2, the square of its own noise, and 1 over that with the measuring error's."""
    noise = np.exp(2 * summed(sample.noise, now.noise_weights))
    return np.exp(-2 * summed(sample.spread, now.spread_weights)), noise, 1 / (sample.error**2 + noise)


def _squares_of_places(weights: Array, inverse: Array, covariance: Array, sample: Sample, moments: Array) -> Array:
    """Return the squared distances of balls from their mean place that are expected, over what they should be."""
    square = moments[:, SCATTER] + (moments[:, MIDDLE] - summed(sample.place, weights)) ** 2
    doubt = variance_of(sample.place, covariance)  # balls pull the mean towards themselves
    return np.asarray((square + doubt) * inverse)


def _noise_scores(levels: Array, part: Array, heavy: Array, sample: Sample, moments: Array) -> Array:
    """Return the score of each ball for the logarithm of its noise, which is a part of its variance."""
    out, share, product, square = sample.measured, moments[:, SHARE], moments[:, PRODUCT], moments[:, SQUARE]
    grown = 1 + summed(sample.level, levels)
    missed = share * out**2 - 2 * grown * product + grown**2 * square
    return np.asarray(part * (heavy * missed - share))


def _place_covariance(inverse: Array, sample: Sample, moments: Array) -> Array:
    """Return the covariance of the place's weights: a ball tells less, the less its place is known [louis1982]."""
    return _covariance(sample.place, inverse * np.maximum(1 - moments[:, SCATTER] * inverse, 0.0), PLACE_WIDTHS)


def _with_covariances(now: PlaceRelation, sample: Sample, moments: Array) -> PlaceRelation:
    """Return the relation with its weights' covariances, of the logarithms' weights by the squares of their scores."""
    inverse, noise, heavy = _scatters(now, sample)
    of_place = _place_covariance(inverse, sample, moments)
    off = _squares_of_places(now.weights, inverse, of_place, sample, moments) - 1
    off_noise = _noise_scores(now.level_weights, noise * heavy, heavy, sample, moments)
    return replace(
        now,
        covariance=of_place,
        spread_covariance=_covariance(sample.spread, off**2, SPREAD_WIDTHS),
        noise_covariance=_covariance(sample.noise, off_noise**2, NOISE_WIDTHS),
    )


def _covariance(terms: Array, information: Array, widths: Array) -> Array:
    """Return the covariance of weights of which each ball tells something, and which are known to some widths."""
    return np.asarray(np.linalg.inv(_products(terms, information) + np.diag(1 / widths**2)), dtype=np.float64)


def _solved(terms: Array, weight: Array, wanted: Array, usual: Array, widths: Array) -> Array:
    """Return weights by least squares, known beforehand to be about the usual ones with some widths."""
    heavy = _products(terms, weight) + np.diag(1 / widths**2)
    return np.asarray(np.linalg.solve(heavy, _along(terms, weight * wanted) + usual / widths**2))


def _scored(terms: Array, share: Array, off: Array, beside: Array, widths: Array) -> Array:
    """Return the step of weights of a logarithm of a scatter towards the likeliest (scoring)."""
    slope = _along(terms, off) - beside / widths**2
    return np.asarray(np.linalg.solve(2 * _products(terms, share) + np.diag(1 / widths**2), slope))


def _products(terms: Array, weight: Array) -> Array:
    """Return the weighted sums over balls of all products of two terms; see `summed`."""
    products = np.empty((len(terms), len(terms)))
    fill_products(np.ascontiguousarray(terms), weight, products)
    return products


def _along(terms: Array, values: Array) -> Array:
    """Return the sums over balls of each term times a value."""
    return np.asarray(np.einsum("jn,n->j", terms, values))
