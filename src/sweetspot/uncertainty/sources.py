"""The unknowns of an answer: bat, ball, the ball's patch, swing and pitch, each with its distribution."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.unknowns import Unknown
from sweetspot.catalog.balls import ball_spreads
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.patch import PATCH_SPREAD
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.implement_doubt import NO_DOUBT, ImplementDoubt, doubt_of

BAT, PATCH, SWING, PITCH = "bat", "patch of the ball", "swing", "pitch"
"""Names of the sources that are no property of the ball."""
OF_BALL = "ball "
"""What the names of the ball's properties begin with."""
DRAWS = 1024
"""A power of two, as Sobol's sequence wants."""


@dataclass(frozen=True)
class Source:
    """One thing that is not known exactly.

    ``name``: of what; all unknowns of a bat are together "bat", those of a racket "racket". ``spread``: one standard
    deviation; of an even distribution, between which its values lie.
    """

    name: str
    spread: float | tuple[float, float]
    where: str


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
        import scipy.special

        of_bat, rest = np.split(normal, [len(self.doubt.behind)], axis=1)
        others = np.empty_like(rest)
        for column, source in enumerate(self.others):
            if isinstance(source.spread, tuple):
                low, high = source.spread
                others[:, column] = low + (high - low) * scipy.special.ndtr(rest[:, column])
            else:
                others[:, column] = source.spread * rest[:, column]
        return np.hstack([of_bat @ self.doubt.factor.T, others])

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
    """Return the unknowns of a ball: the catalogue's spreads are half widths of 90 % intervals."""
    where = f"spread of {ball.name} in the catalogue"
    spreads = ball_spreads(ball)
    return tuple(Source(f"{OF_BALL}{name}".replace("_", " "), size / REACH, where) for name, size in spreads.items())


def _speeds(bat: float, pitch: float) -> list[Source]:
    where = "as the speed was written"
    return [Source(name, error, where) for name, error in ((SWING, bat), (PITCH, pitch)) if error > 0]


def error_by_ball(reduced: ReducedBat[Implement], conditions: Conditions, position: float) -> float | None:
    """Return the standard deviation in m/s that the ball alone leaves to an exit speed; None: no spread is known.

    Balls of a kind differ, and what one returns at game speed is not known better; the bat's modes are as they are.
    """
    place, spreads = np.array([position]), ball_spreads(conditions.ball)
    if not spreads:
        return None

    def speed(name: str, off: float) -> float:
        with_ball = conditions.replaced(ball=conditions.ball.deviated({name: off}))
        return float(scan(reduced, with_ball, place).exit_speed[0])

    halves = [(speed(name, size / REACH) - speed(name, -size / REACH)) / 2 for name, size in spreads.items()]
    return float(np.linalg.norm(halves))


def one_by_one(count: int) -> Array:
    """Return every source one standard deviation up, then every one down, shape (2 * count, count)."""
    return np.vstack([np.eye(count), -np.eye(count)])
