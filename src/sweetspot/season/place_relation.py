"""Where along the bat balls are met, learnt from the table itself: it hangs on where the pitch passes the plate.

A pitch inside is met nearer the hands, one outside nearer the tip. The place b of a ball is normal about
mu = beta . x with standard deviation tau exp(k v), x = (1, o, h, o h, v) of the pitch's place outside o, its height h
and bat speed v; its exit speed is (1 + level) times the table's at b, with scatter. The mean goes one way with o on
purpose: exit speed falls to both sides of the best place and cannot tell them apart, geometry can. The level goes in a
straight line with v: a bat speed is measured with an error, so swings that were read as fast were on average not quite
so fast, and exit speeds do not keep up with what was read. beta, tau, level and the scatter are what makes the measured
exit speeds most likely, the places summed over (expectation and maximisation).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.season.balls import Balls
from sweetspot.season.place_kernel import EVIDENCE, MIDDLE, PRODUCT, SCATTER, SHARE, SQUARE, expect
from sweetspot.units import INCH, MPH

TERMS = 5
USUAL_PLACE, USUAL_SPREAD = 6.5 * INCH, 1.8 * INCH
"""Before a table is read: middle of the stretch where hits are squared up [statcast], and scatter of contact."""
LEVEL_WIDTH = 0.02
"""Standard deviation of the level known beforehand: restitution of balls, and bats that are not as described."""
SLOPE_WIDTH = 0.01
"""The same of what the level changes by for 5 mph of bat speed."""
USUAL_SPEED = 71.5 * MPH
"""Mean of 20,023 tracked balls in play [sure2026]."""
LEAST_NOISE = 0.05 * MPH
ROUNDS = 150
ENOUGH = 200
"""Balls below which nothing is learnt and the usual numbers stand."""
CENTRE, SCALE = np.array([0.0, 0.75]), np.array([0.3, 0.25])
"""m, by which places over the plate are brought to about 0 and 1: outside, height."""


@dataclass(frozen=True)
class PlaceRelation:
    """Where along the bat balls of a table are met.

    Parameters
    ----------
    weights : beta, m from the tip, shape (5,).
    weight_errors : standard errors of the same, as if the places themselves had been seen.
    spread : tau, m.
    marginal : mean and standard deviation of all places, for balls whose pitch has no place, m.
    level : by how much exit speeds of usual swings are above the table's, as a part.
    noise : m/s that exit speeds scatter beyond measuring errors.
    balls : how many it was learnt from; 0: nothing, the usual numbers stand.
    spread_slope : change of the logarithm of tau for 5 mph of bat speed.
    noise_slope : the same of the noise.
    level_slope : change of the level for 5 mph of bat speed.
    evidence : logarithm of the likelihood of the balls it was learnt from.
    ranks : which part of the balls it was learnt from are hit less hard than the model says for every twentieth; what
        the model's shape misses.
    """

    weights: Array
    weight_errors: Array
    spread: float
    marginal: tuple[float, float]
    level: float
    noise: float
    balls: int
    spread_slope: float = 0.0
    noise_slope: float = 0.0
    level_slope: float = 0.0
    evidence: float = 0.0
    ranks: tuple[float, ...] = ()

    def prior(self, balls: Balls) -> Array:
        """Return mean and standard deviation of the place of each ball, m from the tip, shape (n, 2)."""
        terms = place_terms(balls)
        known = np.asarray(np.isfinite(terms).all(axis=1))
        mean = np.where(known, np.nan_to_num(terms) @ self.weights, self.marginal[0])
        return np.stack([mean, np.where(known, self.spreads(speed_term(balls)), self.marginal[1])], axis=-1)

    def spreads(self, swung: Array) -> Array:
        """Return tau of balls by their `speed_term`, m."""
        return self.spread * np.exp(self.spread_slope * np.clip(swung, -3, 3))

    def noises(self, swung: Array) -> Array:
        """Return the noise of balls by their `speed_term`, m/s."""
        return self.noise * np.exp(self.noise_slope * np.clip(swung, -3, 3))

    def levels(self, swung: Array) -> Array:
        """Return the level of balls by their `speed_term`."""
        return np.asarray(self.level + self.level_slope * np.clip(swung, -3, 3))

    def ranked(self, rank: Array) -> Array:
        """Return ranks of exit speeds as the table's own balls have them, from those of the model."""
        if not self.ranks:
            return rank
        return np.where(np.isnan(rank), np.nan, np.interp(rank, self.ranks, np.linspace(0, 1, len(self.ranks))))

    def near(self, other: PlaceRelation) -> bool:
        """Return whether two relations are the same for every purpose: 0.01 mm, 1e-5 of level, 1 mm/s."""
        lengths = np.abs([*(self.weights - other.weights), self.spread - other.spread])
        return (
            bool(lengths.max() < 1e-5)
            and abs(self.level - other.level) < 1e-5
            and abs(self.level_slope - other.level_slope) < 1e-5
            and abs(self.noise - other.noise) < 1e-3
        )


UNLEARNT = PlaceRelation(
    np.array([USUAL_PLACE, *np.zeros(TERMS - 1)]),
    np.zeros(TERMS),
    USUAL_SPREAD,
    (USUAL_PLACE, USUAL_SPREAD),
    0.0,
    1.0 * MPH,
    0,
)
"""What stands where a table is too small to learn from."""
START = replace(UNLEARNT, weights=np.array([USUAL_PLACE, -2 * INCH, *np.zeros(TERMS - 2)]))
"""Where learning begins: outside pitches nearer the tip."""


def place_terms(balls: Balls) -> Array:
    """Return what the relation is a sum of, shape (n, 5); NaN where the pitch's place is not known."""
    outside = np.clip((balls.outside - CENTRE[0]) / SCALE[0], -2, 2)
    height = np.clip((balls.plate_height - CENTRE[1]) / SCALE[1], -2, 2)
    outside = np.where(balls.sided, outside, np.nan)
    return np.stack([np.ones_like(outside), outside, height, outside * height, speed_term(balls)], axis=-1)


def speed_term(balls: Balls) -> Array:
    """Return how much faster than usual the bats were, in 5 mph, at most 3 either way."""
    return np.clip(np.nan_to_num((balls.bat_speed - USUAL_SPEED) / (5 * MPH)), -3, 3)


def learn_places(
    balls: Balls, *, places: Array, predicted: Array, measured: Array, spread: Array
) -> PlaceRelation:  # fmt: skip
    """Return the relation that makes measured exit speeds most likely.

    Parameters
    ----------
    balls : n of them, all with a swing.
    places : m from the tip, even, shape (k,).
    predicted : m/s, exit speed at every place, shape (n, k); NaN where none.
    measured, spread : m/s, exit speeds and their measuring errors, shape (n,).
    """
    terms = place_terms(balls)
    known = np.asarray(np.isfinite(terms).all(axis=1))
    good = np.asarray(np.isfinite(predicted).any(axis=1)) & np.isfinite(spread)
    if good.sum() < ENOUGH:
        return UNLEARNT
    terms = np.where(known[:, None], np.nan_to_num(terms), [1.0, *np.zeros(TERMS - 1)])[good]
    table = np.ascontiguousarray(predicted[good])
    out, error, seen, swung = measured[good], spread[good], known[good], speed_term(balls)[good]
    now = START
    result = np.zeros((len(out), 6))
    for _ in range(ROUNDS):
        tau = now.spreads(swung)
        prior = np.stack([terms @ now.weights, tau], axis=-1)
        expect(places, table, out, np.hypot(error, now.noises(swung)), prior, now.levels(swung), result)
        before, now = now, _maximised(now, terms, swung, out, error, result)
        if now.near(before):
            break
    errors = now.spread * np.sqrt(np.diag(np.linalg.pinv(terms.T @ terms)))
    everywhere = terms[seen] @ now.weights if seen.any() else terms @ now.weights
    marginal = (float(everywhere.mean()), float(np.hypot(now.spread, everywhere.std())))
    return replace(now, weight_errors=errors, marginal=marginal, balls=int(good.sum()),
                   evidence=float(result[:, EVIDENCE].sum()))  # fmt: skip


def _maximised(
    now: PlaceRelation, terms: Array, swung: Array, out: Array, error: Array, moments: Array
) -> PlaceRelation:
    """Return the parameters that fit best where the balls are thought to have been met."""
    inverse = 1 / now.spreads(swung) ** 2
    weights = np.linalg.solve(
        (terms.T * inverse) @ terms + 1e-6 * np.eye(TERMS), (terms.T * inverse) @ moments[:, MIDDLE]
    )
    square = moments[:, SCATTER] + (moments[:, MIDDLE] - terms @ weights) ** 2
    pull = square * inverse  # 1 on average where the spread is right
    slope = now.spread_slope + 0.5 * float(np.sum((pull - pull.mean()) * swung) / np.sum(2 * pull * swung**2))
    slope = min(max(slope, -0.5), 0.5)
    tau = float(np.sqrt(np.mean(square * np.exp(-2 * slope * swung))))
    own = now.noises(swung)
    heavy = 1 / (error**2 + own**2)
    off, square_speed = heavy * (moments[:, PRODUCT] - moments[:, SQUARE]), heavy * moments[:, SQUARE]
    powers = [float(np.sum(square_speed * swung**power)) for power in range(3)]
    level, tilt = np.linalg.solve(
        [[powers[0] + 1 / LEVEL_WIDTH**2, powers[1]], [powers[1], powers[2] + 1 / SLOPE_WIDTH**2]],
        [float(np.sum(off)), float(np.sum(off * swung))],
    ).tolist()
    grown = 1 + level + tilt * swung
    share = moments[:, SHARE]
    missed = share * out**2 - 2 * grown * moments[:, PRODUCT] + grown**2 * moments[:, SQUARE]
    gain = own**2 * heavy
    fresh = gain**2 * missed + share * gain * error**2  # variance of the noise alone, times the share
    pull = fresh / own**2
    mean = pull.sum() / share.sum()
    bend = now.noise_slope + 0.5 * float(np.sum((pull - mean * share) * swung) / np.sum(2 * pull * swung**2))
    bend = min(max(bend, -0.5), 0.5)
    noise = float(np.sqrt(max(np.sum(fresh * np.exp(-2 * bend * swung)) / share.sum(), LEAST_NOISE**2)))
    return replace(
        now,
        weights=np.asarray(weights, float),
        spread=tau,
        spread_slope=slope,
        level=level,
        level_slope=tilt,
        noise=noise,
        noise_slope=bend,
    )
