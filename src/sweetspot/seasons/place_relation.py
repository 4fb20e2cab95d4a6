"""Where along the bat balls are met, learnt from the table itself: it hangs on the pitch's place and on the swing.

A pitch inside is met nearer the hands, one outside nearer the tip; a bat that still goes down is late, one that goes
far up is early, and both meet the ball elsewhere than a bat on time, inside pitches most of all; so do swings that were
broken off (`swing_speeds`). The place of a ball is normal about a mean, a sum over `PLACE`, with a standard deviation
whose logarithm is a sum over `SPREAD`; its exit speed is (1 + level) times the table's there, the level a sum over
`LEVEL`, with a scatter whose logarithm is a sum over `NOISE`. The mean's slope has a given sign in how far outside a
pitch is: exit speed falls to both sides of the best place and cannot tell them apart, geometry can. The level goes with
how much faster than usual a full swing was read: those were on average not quite so fast, and exit speeds do not keep
up with what was read; from 80 mph on they do not grow at all. A ball that is only grazed scatters by more than one met
squarely, up and down by different amounts, and so does one met by a bat that goes up or down unusually; of balls turned
by more than `GRAZED` the level is another too, for the bat's table is least right there, and from there on both change
at a rate of their own. All weights are what makes the measured exit speeds most likely, the places summed over
(expectation and maximisation); a place that was measured is one more measurement of its ball.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array
from sweetspot.seasons.balls import Balls
from sweetspot.seasons.place_kernel import fill_variances
from sweetspot.seasons.swings import ATTACK_SPREAD, USUAL_ATTACK, USUAL_SPEEDS, USUAL_TILT, SwingSpeeds
from sweetspot.units import DEGREE, INCH, MPH

SIX = ("outside", "height", "faster", "lost", "attack", "tilt")
PLACE = ("one", *SIX, *(f"outside {name}" for name in SIX), *(f"{name} {name}" for name in SIX[1:]))
SPREAD = ("one", *SIX)
FAR = ("far up", "far down")
LEVEL = ("one", "faster", "fastest", "turned", *FAR)
NOISE = ("one", *SIX, "attack attack", "turned", "turned either way", *FAR)
"""What each quantity is a sum over; `FAR` is how much further than `GRAZED` a ball was turned up or down, "fastest" how
much faster than `FAST` a swing was, other two words are products. See `Circumstances` for their units."""
USUAL_SUMS = (6.02, -3.02, 1.42, 0.06, 0.26, -0.71, 0.25)
USUAL_PRODUCTS = (0.27, -0.63, -0.23, 0.43, 0.41, -0.15, -0.08, -0.06, -0.19, -0.07, -0.07)
USUAL_WEIGHTS = np.array([*USUAL_SUMS, *USUAL_PRODUCTS]) * INCH
USUAL_SPREADS = np.array([-3.18, -0.43, 0.05, 0.04, 0.07, -0.01, -0.03])
USUAL_LEVELS = np.array([0.004, -0.016, -0.039, 0.004, 0.055, -0.118])
USUAL_NOISES = np.array([-1.06, -0.07, -0.05, 0.04, 0.04, -0.07, 0.05, 0.08, -0.41, 1.65, -0.59, -2.11])
USUAL_MARGINAL = 5.57 * INCH, 2.74 * INCH
"""Before a table is read: weights learned from 20,188 tracked balls of the league [sure2026] with the usual ash bat,
over `PLACE`, `SPREAD`, `LEVEL` and `NOISE`, and mean and standard deviation of all places
(``python -m studies.held_out --usual`` prints them)."""
PLACE_WIDTHS = np.array([0.7, 1.0, *[0.5] * 5, *[0.25] * (len(PLACE) - 7)]) * INCH
SPREAD_WIDTHS = np.array([0.25, *[0.1] * (len(SPREAD) - 1)])
LEVEL_WIDTHS = np.array([0.02, 0.01, 0.05, 0.02, 0.05, 0.05])
NOISE_WIDTHS = np.array([0.3, *[0.1] * (len(NOISE) - 5), *[0.2] * 4])
"""By what a table's weights may differ from those, standard deviations: players of a league that is as reliable as the
real one differ by 0.5 in of place (`made_up.LIKE_THE_LEAGUE`), tables of other leagues by more; the rest is judgement.
Of the level as a part (restitution of balls, and bats that are not as described), of scatters as logarithms."""
TURNED = 0.7
"""rad by which a ball leaves the bat's path that is hit about 1.4 in over or under the axis."""
GRAZED, MOST_TURNED = 1.2, 2.2
"""Of that: 48 degrees, beyond which exit speeds go another way than before, and 88, the most there can be."""
FAST = 1.25
"""Of 5 mph, by which full swings are faster than usual that are read at 80 mph: beyond, hardly any really are."""
CENTRE, SCALE = (0.0, 0.75), (0.3, 0.25)
"""m, by which places over the plate are brought to about 0 and 1: outside, height."""
SPEED, TILT = 5 * MPH, 6 * DEGREE
"""By which bat speeds and tilts are."""


class Circumstances(NamedTuple):
    """The covariates of n balls, each about 0 for a usual one and where it is not known.

    ``outside``, ``height``: of the pitch over the plate, in `SCALE` from `CENTRE`, at most 2 either way. ``faster``,
    ``lost``: of the bat speed, in 5 mph from the mean; see `SwingSpeeds.parts`. ``attack``, ``tilt``: of the swing, in
    7 and 6 degrees from the usual, at most 3 either way. ``placed``: whether the pitch's place is known.
    """

    outside: Array
    height: Array
    faster: Array
    lost: Array
    attack: Array
    tilt: Array
    placed: NDArray[np.bool_]

    def some(self, rows: NDArray[np.int64] | NDArray[np.bool_]) -> Circumstances:
        """Return those of some balls."""
        return self._replace(**{name: values[rows] for name, values in self._asdict().items()})

    def terms(self, names: tuple[str, ...], turned: Array | None = None) -> Array:
        """Return the terms of a sum, shape (names, n).

        ``turned``: of the balls, from `turn_term`.
        """
        values = {**self._asdict(), "one": np.ones(len(self.outside)), "fastest": np.maximum(self.faster - FAST, 0.0)}
        if turned is not None:
            values |= {"turned": turned, "turned either way": np.abs(turned)}
            values |= dict(zip(FAR, (np.maximum(way * turned - GRAZED, 0.0) for way in (1, -1)), strict=True))
        terms = (
            values[name] if name in values else np.prod([values[part] for part in name.split()], 0) for name in names
        )
        return np.stack(list(terms))


def circumstances(balls: Balls, bat_speeds: SwingSpeeds) -> Circumstances:
    """Return the circumstances of balls: the covariates of the relation."""

    def scaled(values: Array, centre: float, size: float, most: float) -> Array:
        return np.nan_to_num(np.clip((values - centre) / size, -most, most))

    outside = np.where(balls.sided, balls.outside, np.nan)
    faster, lost = bat_speeds.parts(balls.bat_speed)
    return Circumstances(
        scaled(outside, CENTRE[0], SCALE[0], 2),
        scaled(balls.plate_height, CENTRE[1], SCALE[1], 2),
        scaled(faster, 0.0, SPEED, 5),
        scaled(lost, bat_speeds.lost_speed, SPEED, 5),
        scaled(balls.attack_angle, USUAL_ATTACK, ATTACK_SPREAD, 3),
        scaled(balls.tilt, USUAL_TILT, TILT, 3),
        np.isfinite(outside) & np.isfinite(balls.plate_height),
    )


def turn_term(turned: Array) -> Array:
    """Return the angle by which balls left the bat's path upwards, in `TURNED`; 0 where not known."""
    return np.clip(np.nan_to_num(turned / TURNED), -MOST_TURNED, MOST_TURNED)


@dataclass(frozen=True)
class PlaceRelation:
    """Where along the bat balls of a table are met.

    Parameters
    ----------
    weights : of the mean place, over `PLACE`, m from the tip.
    spread_weights : of the logarithm of tau in m, over `SPREAD`.
    level_weights : of the level, over `LEVEL`: exit speeds are 1 + level times the table's.
    noise_weights : of the logarithm of what exit speeds scatter beyond measuring errors in m/s, over `NOISE`.
    bat_speeds : how bat speeds of the table are spread.
    marginal : mean and standard deviation of all places, for balls whose pitch has no place, m.
    balls : how many it was learnt from; 0: nothing, the usual numbers stand.
    covariance : of `weights`, m^2, shape (terms, terms).
    spread_covariance, noise_covariance : of `spread_weights` and of `noise_weights`, shape (terms, terms).
    evidence : logarithm of the likelihood of the balls it was learnt from.
    ranks : which part of the balls it was learnt from are hit less hard than the model says for every twentieth; what
        the model's shape misses.
    """

    weights: Array
    spread_weights: Array
    level_weights: Array
    noise_weights: Array
    bat_speeds: SwingSpeeds = USUAL_SPEEDS
    marginal: tuple[float, float] = USUAL_MARGINAL
    balls: int = 0
    covariance: Array = field(default_factory=lambda: np.zeros((len(PLACE), len(PLACE))))
    spread_covariance: Array = field(default_factory=lambda: np.zeros((len(SPREAD), len(SPREAD))))
    noise_covariance: Array = field(default_factory=lambda: np.zeros((len(NOISE), len(NOISE))))
    evidence: float = 0.0
    ranks: tuple[float, ...] = ()

    @property
    def spread(self) -> float:
        """Tau of usual swings at usual pitches, m."""
        return float(np.exp(self.spread_weights[0]))

    @property
    def level(self) -> float:
        """By how much exit speeds of usual swings are above the table's, as a part."""
        return float(self.level_weights[0])

    @property
    def noise(self) -> float:
        """Standard deviation of exit speeds of usual swings beyond measuring errors, m/s."""
        return float(np.exp(self.noise_weights[0]))

    def prior(self, conditions: Circumstances) -> Array:
        """Return mean and standard deviation of the place of each ball, m from the tip, shape (n, 2)."""
        place = conditions.terms(PLACE)
        mean = np.where(conditions.placed, summed(place, self.weights), self.marginal[0])
        variance = scatter_of(conditions.terms(SPREAD), self.spread_weights, self.spread_covariance) ** 2
        spread = np.where(conditions.placed, np.sqrt(variance + variance_of(place, self.covariance)), self.marginal[1])
        return np.stack([mean, spread], axis=-1)

    def level_of(self, conditions: Circumstances, turned: Array) -> Array:
        """Return the level of balls.

        ``turned``: of the balls, from `turn_term`.
        """
        return summed(conditions.terms(LEVEL, turned), self.level_weights)

    def noise_of(self, conditions: Circumstances, turned: Array) -> Array:
        """Return the noise of balls, m/s."""
        return scatter_of(conditions.terms(NOISE, turned), self.noise_weights, self.noise_covariance)

    def ranked(self, rank: Array) -> Array:
        """Return ranks of exit speeds as the table's own balls have them, from those of the model."""
        if not self.ranks:
            return rank
        return np.where(np.isnan(rank), np.nan, np.interp(rank, self.ranks, np.linspace(0, 1, len(self.ranks))))


def summed(terms: Array, weights: Array) -> Array:
    """Return each ball's sum of terms times weights, shape (n,).

    Not by BLAS, here and wherever terms of balls are added up: its threads wait for each other in a loop, which for
    such narrow tables costs many times the sums where other programs run, and how it adds up hangs on how many there
    are.

    ``terms``: shape (terms, n).
    """
    return np.asarray(np.einsum("j,jn->n", weights, terms))


def variance_of(terms: Array, covariance: Array) -> Array:
    """Return the variance of each ball's sum by the doubt about its weights, shape (n,)."""
    variances = np.empty(terms.shape[1])
    fill_variances(covariance, np.ascontiguousarray(terms), variances)
    return variances


def scatter_of(terms: Array, weights: Array, covariance: Array) -> Array:
    """Return the root mean square of a scatter whose logarithm is a sum with doubtful weights, shape (n,)."""
    return np.asarray(np.exp(summed(terms, weights) + variance_of(terms, covariance)))


UNLEARNT = PlaceRelation(
    *(USUAL_WEIGHTS, USUAL_SPREADS, USUAL_LEVELS, USUAL_NOISES),
    covariance=np.diag(PLACE_WIDTHS**2),
    spread_covariance=np.diag(SPREAD_WIDTHS**2),
    noise_covariance=np.diag(NOISE_WIDTHS**2),
)
"""What stands where a table is too small to learn from: the league's numbers, and how far others may be from them."""
