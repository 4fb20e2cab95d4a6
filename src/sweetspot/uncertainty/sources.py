"""The unknowns of an answer: bat, ball, the ball's patch, swing and pitch, each with its distribution."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.unknowns import Unknown
from sweetspot.catalog.balls import BALL_LAW, MEAN_BALL, THIS_BALL, ball_doubts
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.patch import PATCH_SPREAD
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.special import normal_distribution
from sweetspot.uncertainty.implement_doubt import NO_DOUBT, ImplementDoubt, doubt_of

BAT, PATCH, SWING, PITCH = "bat", "patch of the ball", "swing", "pitch"
"""Names of the sources that are no property of the ball."""
BALL_SOURCES = (THIS_BALL, MEAN_BALL, BALL_LAW)
"""Names of the sources that are properties of the ball."""
DRAWS = 1024
"""A power of two, as Sobol's sequence wants."""


@dataclass(frozen=True)
class Source:
    """One thing that is not known exactly.

    ``name``: of what; all unknowns of a bat are together "bat", those of a racket "racket". ``spread``: one standard
    deviation; of an even distribution, between which its values lie. ``ball``: what a unit of it does to the ball, as
    `Ball.deviated` takes it; empty: nothing.
    """

    name: str
    spread: float | tuple[float, float]
    where: str
    ball: tuple[tuple[str, float], ...] = ()

    def deviated(self, ball: Ball, deviation: float) -> Ball:
        """Return the ball with a deviation of this source."""
        return ball.deviated({name: deviation * size for name, size in self.ball}) if self.ball else ball


@dataclass(frozen=True)
class Sources:
    """All unknowns of an answer.

    ``others``: ball, patch, swing and pitch, independent of each other and of the bat. ``bat_where``: what the bat's
    doubt rests on, in words. ``implement``: what people call it: a bat, a racket, a club.
    """

    doubt: ImplementDoubt
    others: tuple[Source, ...]
    bat_where: str = ""
    implement: str = BAT

    @property
    def names(self) -> tuple[str, ...]:
        """Name of every column of a draw."""
        return (self.implement,) * len(self.doubt.behind) + tuple(other.name for other in self.others)

    @property
    def unknowns(self) -> tuple[Unknown, ...]:
        """Of the bat."""
        return self.doubt.unknowns

    @property
    def described(self) -> dict[str, str]:
        """What each source's distribution rests on, by its name."""
        bat = {self.implement: self.bat_where} if self.bat_where else {}
        return bat | {other.name: other.where for other in self.others}

    def without(self, *names: str) -> Sources:
        """Return the sources but those of these names."""
        others = tuple(other for other in self.others if other.name not in names)
        return replace(self, others=others)

    def with_source(self, source: Source) -> Sources:
        """Return the sources and one more."""
        return replace(self, others=(*self.others, source))

    def normal(self, count: int, *, seed: int = 1) -> Array:
        """Return independent standard normal numbers, shape (count, n), by Sobol's sequence; see `even_normal`."""
        return even_normal(count, len(self.names), seed=seed)

    def deviations(self, normal: Array) -> Array:
        """Return deviations from what was described, of the bat's unknowns and then of the others, shape (count, m)."""
        of_bat, rest = np.split(normal, [len(self.doubt.behind)], axis=1)
        others = np.empty_like(rest)
        for column, source in enumerate(self.others):
            if isinstance(source.spread, tuple):
                low, high = source.spread
                others[:, column] = low + (high - low) * normal_distribution(rest[:, column])
            else:
                others[:, column] = source.spread * rest[:, column]
        return np.hstack([of_bat @ self.doubt.factor.T, others])

    def balls(self, ball: Ball, deviations: Array) -> tuple[Ball, ...]:
        """Return the ball of every draw, its parts deviating together, from deviations of shape (draws, m)."""
        properties = sorted({name for source in self.others for name, _ in source.ball})
        if not properties:
            return (ball,) * len(deviations)
        sizes = np.array([[dict(source.ball).get(name, 0.0) for name in properties] for source in self.others])
        moved = deviations[:, len(self.unknowns) :] @ sizes
        return tuple(ball.deviated(dict(zip(properties, row, strict=True))) for row in moved.tolist())

    def of(self, name: str, deviations: Array) -> Array:
        """Return the deviations of one source that is not the bat's, shape (count,); 0 where it is no source."""
        names = [other.name for other in self.others]
        column = len(self.unknowns) + names.index(name) if name in names else None
        return np.zeros(len(deviations)) if column is None else deviations[:, column]


def even_normal(count: int, columns: int, *, seed: int = 1) -> Array:
    """Return standard normal numbers by Sobol's sequence, shape (count, columns), the count a power of two."""
    import scipy.special
    import scipy.stats

    even = scipy.stats.qmc.Sobol(columns, seed=seed).random(count)
    return np.asarray(scipy.special.ndtri(np.clip(even, 1e-9, 1 - 1e-9)))


PATCH_SOURCES = (
    Source(
        PATCH,
        (math.log(PATCH_SPREAD[0]), math.log(PATCH_SPREAD[1])),
        "even between the shapes that a pressed ball can take",
    ),
)
"""The size of the patch through which a ball presses a round bat: its logarithm, even between limits."""
NOTHING = Sources(NO_DOUBT, ())
"""Everything is known."""


def sources_of(
    bat: Implement,
    conditions: Conditions,
    *,
    calibration: tuple[Sequence[Unknown], Array] | None = None,
    bat_speed_error: float = 0.0,
    pitch_speed_error: float = 0.0,
) -> Sources:
    """Return the unknowns of a hit.

    ``calibration``: the unknowns of the bat and their covariance, as `sweetspot calibrate` left them; None: what the
    catalogue allows for bats of this kind, after the weight, balance point and moment of inertia in its file.
    ``bat_speed_error``, ``pitch_speed_error``: one standard deviation in m/s; 0: exactly as given.
    """
    doubt = doubt_of(bat, calibration)
    of_kind = "materials of the catalogue" if isinstance(bat, Bat) else "how much others of its kind differ (assumed)"
    where = f"{of_kind}, after what its file says was measured" if calibration is None else "its calibration"
    where = where if doubt.unknowns else "taken as described: how its plies may differ is not modelled"
    patch = PATCH_SOURCES if isinstance(bat, Bat) else ()
    others = (*sources_of_ball(conditions.ball), *patch, *_speeds(bat_speed_error, pitch_speed_error))
    return Sources(doubt, others, where, sport(bat.sport).words.implement)


def sources_of_ball(ball: Ball) -> tuple[Source, ...]:
    """Return the unknowns of a ball: of this one, of the mean of its kind, and of the law it follows."""
    return tuple(Source(doubt.part, 1.0, doubt.where, doubt.deviation) for doubt in ball_doubts(ball))


def _speeds(bat: float, pitch: float) -> list[Source]:
    where = "as the speed was written"
    return [Source(name, error, where) for name, error in ((SWING, bat), (PITCH, pitch)) if error > 0]


@dataclass(frozen=True)
class BallErrors:
    """Standard deviations that the ball alone leaves to an exit speed, m/s.

    ``scatter``: from ball to ball. ``common``: of all balls of the kind alike: their mean and their law.
    """

    scatter: float
    common: float

    @property
    def whole(self) -> float:
        """Of one ball, with all that is not known of it."""
        return math.hypot(self.scatter, self.common)


def errors_by_ball(reduced: ReducedBat[Implement], conditions: Conditions, position: float) -> BallErrors | None:
    """Return the errors that the ball alone leaves to an exit speed, the bat as described; None: no spread is known."""
    place, sources = np.array([position]), sources_of_ball(conditions.ball)
    if not sources:
        return None

    def speed(source: Source, off: float) -> float:
        with_ball = conditions.replaced(ball=source.deviated(conditions.ball, off))
        return float(scan(reduced, with_ball, place).exit_speed[0])

    halves = [((speed(source, 1.0) - speed(source, -1.0)) / 2, source.name == THIS_BALL) for source in sources]
    scatter, common = (
        float(np.linalg.norm([half for half, scatters in halves if scatters == which])) for which in (True, False)
    )
    return BallErrors(scatter, common)


def one_by_one(count: int) -> Array:
    """Return every source one standard deviation up, then every one down, shape (2 * count, count)."""
    return np.vstack([np.eye(count), -np.eye(count)])
