"""The bat that measurements and expectations allow: most likely values, their errors, and who contradicts whom.

Unknowns x are counted in their spreads, so that before the measurements x is standard normal. The most likely x has the
least sum of squares of (model(x) - measured) / error and of x itself, with the Jacobian J by differences; its
covariance is C = (J^T J)^-1. Every row of J, measurement or expectation, is one independent source with unit error: of
the variance of unknown j, source i causes (C J^T)_ji^2. Against all others together a source lies off by
r_i / sqrt(1 - J_i C J_i^T) sigma, its studentised residual r.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.unknowns import OF_BALL, Unknown, deviated
from sweetspot.dynamics.beam import BeamModel
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.least_squares import nearly_straight_least_squares

CONTRADICTION = 3.0
"""Sigma from which on a source contradicts the others."""
FARTHEST = 8.0
"""Spreads that an unknown may deviate; only measurements that contradict each other go there."""
SHOT_STEP = 0.3
"""Of a spread, in the differences of what shots say."""
STEP = 0.02
"""Of a spread, in the differences."""
STRAIGHT = 1e-4
"""Of a spread: a step as short as this ends the search where the misses are nearly straight."""
LOOKS = 5
"""Linearizations at most, in the test whether measurements must contradict each other."""
HARDLY = 0.02
"""Part of a source's own variance that the others must leave it, for it to be able to contradict them. The bat meets
one that has less, unless contradictions elsewhere draw it away: then it is off by its own errors."""
IMPOSSIBLE = (InputError, np.linalg.LinAlgError)
"""The errors raised by deviations that no bat can have."""


@dataclass(frozen=True)
class BatPosterior:
    """The posterior of a bat's unknowns, given its measurements.

    Parameters
    ----------
    deviations : of the most likely bat from the description, shape (n,).
    covariance : of the deviations, shape (n, n).
    predictions : what the most likely bat says to the measurements, SI.
    pulls : of every measurement, then every unknown's expectation: its distance from all others together in sigma.
    gains : change of every deviation per sigma of every source, shape (n, sources).
    """

    prior: BeamModel
    beam: BeamModel
    unknowns: tuple[Unknown, ...]
    measurements: tuple[Measurement, ...]
    deviations: Array
    covariance: Array
    predictions: Array
    pulls: Array
    gains: Array

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of measurements and expectations, in the order of `pulls`."""
        return (
            *(measurement.name for measurement in self.measurements),
            *(f"expected {unknown.name}" for unknown in self.unknowns),
        )

    @property
    def contradictions(self) -> dict[str, float]:
        """Sources that lie more than three sigma from all others together, the farthest first."""
        off = {name: float(pull) for name, pull in zip(self.sources, self.pulls, strict=True)}
        return dict(sorted(((n, p) for n, p in off.items() if abs(p) > CONTRADICTION), key=lambda e: -abs(e[1])))

    @property
    def livelier(self) -> float:
        """Logarithm of the shot balls' restitution over that of their law; 0 where none was shot."""
        return sum(
            float(off) for entry, off in zip(self.unknowns, self.deviations, strict=True) if entry.name == OF_BALL
        )

    def deviation(self, name: str) -> Measured:
        """Return an unknown's deviation and its error."""
        index = [unknown.name for unknown in self.unknowns].index(name)  # type: ignore[arg-type]
        return Measured(float(self.deviations[index]), float(np.sqrt(self.covariance[index, index])))

    def budget(self, name: str) -> dict[str, float]:
        """Return the part of an unknown's variance that each source causes, the greatest first; they add up to 1."""
        index = [unknown.name for unknown in self.unknowns].index(name)  # type: ignore[arg-type]
        shares = self.gains[index] ** 2 / self.covariance[index, index]
        return dict(sorted(zip(self.sources, shares.tolist(), strict=True), key=lambda entry: -entry[1]))

    def draws(self, count: int, generator: np.random.Generator) -> Array:
        """Return deviations drawn from the posterior, shape (count, n)."""
        return generator.multivariate_normal(self.deviations, self.covariance, size=count, method="cholesky")


def residuals(x: Array, *, beam: BeamModel, unknowns: Sequence[Unknown], measurements: Sequence[Measurement]) -> Array:
    """Return (model(x) - measured) / error of every measurement, then x.

    Minus half the sum of their squares is the logarithm of the posterior.
    """
    spreads = np.array([unknown.spread for unknown in unknowns])
    values = np.array([measurement.value.value for measurement in measurements])
    errors = np.array([measurement.error for measurement in measurements])
    predictions = _predictions(beam, unknowns, x * spreads, measurements)
    return np.concatenate([(predictions - values) / errors, x])


def _misses(
    beam: BeamModel, unknowns: Sequence[Unknown], measurements: Sequence[Measurement]
) -> Callable[[Array], Array]:
    """Return the residuals that least squares minimizes; those of shots are linearized around the fit to all else.

    A shot takes the bat's whole vibration, and q hardly bends over the doubt that scale and tap leave.
    """
    shot = [index for index, entry in enumerate(measurements) if entry.shooting is not None]
    others = [measurement for measurement in measurements if measurement.shooting is None]

    def exact(x: Array) -> Array:
        return residuals(x, beam=beam, unknowns=unknowns, measurements=others)

    if not shot:
        return exact
    of_shots = [measurements[index] for index in shot]
    spreads = np.array([unknown.spread for unknown in unknowns])
    around = calibrate(beam, unknowns, others).deviations / spreads if others else np.zeros(len(unknowns))

    def shot_misses(x: Array) -> Array:
        return residuals(x, beam=beam, unknowns=unknowns, measurements=of_shots)[: len(shot)]

    here = shot_misses(around)
    steps = SHOT_STEP * np.eye(len(unknowns))
    slopes = np.array([(shot_misses(around + step) - here) / SHOT_STEP for step in steps]).T
    order = np.argsort([*(index for index in range(len(measurements)) if index not in shot), *shot])

    def quick(x: Array) -> Array:
        of_others, expected = np.split(exact(x), [len(others)])
        return np.concatenate([np.concatenate([of_others, here + slopes @ (x - around)])[order], expected])

    return quick


def _predictions(
    beam: BeamModel, unknowns: Sequence[Unknown], deviations: Array, measurements: Sequence[Measurement]
) -> Array:
    """Return the values that the bat and ball with these deviations predict for measurements, SI."""
    livelier = sum(float(off) for entry, off in zip(unknowns, deviations, strict=True) if entry.name == OF_BALL)
    return predicted(deviated(beam, unknowns, deviations), measurements, livelier=livelier)


def calibrate(
    beam: BeamModel, unknowns: Sequence[Unknown], measurements: Sequence[Measurement], *, agreeing: bool = False
) -> BatPosterior:
    """Return the most likely bat for measurements on it.

    ``agreeing``: whether a bat that contradicts them is of no use, and the search ends once it is clear that all do.
    """
    if not measurements:
        raise InputError("nothing was measured; give at least a weight, a balance point, a pendulum's period or a tap")
    spreads = np.array([unknown.spread for unknown in unknowns])
    misses = _misses(beam, unknowns, measurements)

    try:
        most_likely = _least_squares(misses, len(unknowns), agreeing=agreeing)
    except IMPOSSIBLE as error:
        raise InputError(f"nothing of this kind comes near what was measured: {error}") from None
    steps = STEP * np.eye(len(unknowns))
    slopes = np.array([misses(most_likely + step) - misses(most_likely - step) for step in steps]).T / (2 * STEP)
    nearer = most_likely + np.linalg.lstsq(slopes, -misses(most_likely))[0]
    if np.all(np.abs(nearer) < FARTHEST):
        most_likely = nearer
    covariance = np.linalg.inv(slopes.T @ slopes)
    off = misses(most_likely)
    left = 1 - np.einsum("ij,jk,ik->i", slopes, covariance, slopes)
    pulls = np.where(left > HARDLY, off / np.sqrt(np.maximum(left, HARDLY)), off)
    best = deviated(beam, unknowns, most_likely * spreads)
    return BatPosterior(
        prior=beam,
        beam=best,
        unknowns=tuple(unknowns),
        measurements=tuple(measurements),
        deviations=most_likely * spreads,
        covariance=np.asarray(covariance * np.outer(spreads, spreads), dtype=np.float64),
        predictions=_predictions(beam, unknowns, most_likely * spreads, measurements),
        pulls=pulls,
        gains=spreads[:, None] * (covariance @ slopes.T),
    )


def _least_squares(misses: Callable[[Array], Array], count: int, *, agreeing: bool) -> Array:
    """Return the least-squares estimate of the unknowns, in units of their spreads, shape (count,).

    A bat that cannot be, or cannot hang, is infinitely far off, so that the solver takes shorter steps.

    ``agreeing``: whether to give up, by an `InputError`, where no place is without a contradiction.
    """
    first = misses(np.zeros(count))

    def possible(x: Array) -> Array:
        try:
            return misses(x)
        except IMPOSSIBLE:
            return np.full(len(first), np.inf)

    def slopes(x: Array) -> Array:
        here = misses(x)
        return np.array([(misses(x + step) - here) / STEP for step in STEP * np.eye(count)]).T

    if agreeing and _hopeless(misses, slopes, count):
        raise InputError("the measurements contradict each other")
    with suppress(*IMPOSSIBLE):
        straight = nearly_straight_least_squares(misses, slopes, count, farthest=FARTHEST, close=STRAIGHT)
        if straight is not None:
            return straight
    from scipy.optimize import least_squares

    reach = (-FARTHEST, FARTHEST)
    return np.asarray(least_squares(possible, np.zeros(count), jac=slopes, bounds=reach, xtol=1e-4, ftol=1e-6).x)


def _hopeless(misses: Callable[[Array], Array], slopes_at: Callable[[Array], Array], count: int) -> bool:
    """Return whether it is clear that every place has a contradiction.

    Without one no miss is more than three sigma. Expectations are among the misses, so such a place is less than three
    spreads from the description. There the misses are taken as straight lines, from a better place each time. It is
    clear where these promise less than a half off the sum of squares, and leave more than three sigma everywhere make.
    """
    from scipy.optimize import lsq_linear

    x = np.zeros(count)
    for _ in range(LOOKS):
        try:
            off, slopes = misses(x), slopes_at(x)
        except IMPOSSIBLE:
            return False
        best = lsq_linear(slopes, slopes @ x - off, bounds=(-CONTRADICTION, CONTRADICTION))
        least = 2 * best.cost
        if least < CONTRADICTION**2 * len(off) or least > off @ off / 2:
            return bool(least >= CONTRADICTION**2 * len(off))
        x = best.x
    return False
