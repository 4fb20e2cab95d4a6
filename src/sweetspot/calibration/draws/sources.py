"""What an answer does not know exactly: bat, ball, the ball's patch, swing and pitch, each with its distribution."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.naming import ModeName
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import Unknown, described, unknowns_of
from sweetspot.catalog.balls import ball_spreads
from sweetspot.catalog.bats import other_files
from sweetspot.catalog.implements import implement
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.outline_doubt import OF_CENTRE, is_balanced, is_swung, moi_doubt
from sweetspot.dynamics.patch import PATCH_SPREAD
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.constants import STANDARD_AXIS

BAT, PATCH, SWING, PITCH = "bat", "patch of the ball", "swing", "pitch"
"""Names of the sources that are no property of the ball."""
OF_BALL = "ball "
"""What the names of the ball's properties begin with."""
DRAWS = 1024
"""A power of two, as Sobol's sequence wants."""
WEIGHED, BALANCED, HUNG, RUNG = 0.003, 0.0025, 0.01, 0.03
"""One sigma of a weight, of a balance point in m, of a moment of inertia and of a first frequency, that a file gives
without an error: 0.1 oz of 31, 0.1 in, 1 %, 3 % (assumed; a frequency may come from a shop's stiffness)."""


@dataclass(frozen=True)
class Source:
    """One thing that is not known exactly.

    Parameters
    ----------
    name : of what; all unknowns of a bat are together "bat", those of a racket "racket".
    spread : one standard deviation; of an even distribution, between which its values lie.
    where : what the distribution rests on, in words.
    """

    name: str
    spread: float | tuple[float, float]
    where: str


@dataclass(frozen=True)
class Sources:
    """Everything that an answer does not know exactly.

    Parameters
    ----------
    unknowns : of the bat.
    covariance : of them, shape (k, k).
    others : ball, patch, swing and pitch, independent of each other and of the bat.
    bat_where : what the bat's covariance rests on, in words.
    implement : what people call it: a bat, a racket, a club.
    """

    unknowns: tuple[Unknown, ...]
    covariance: Array
    others: tuple[Source, ...]
    bat_where: str = ""
    implement: str = BAT

    @property
    def names(self) -> tuple[str, ...]:
        """Name of every column of a draw."""
        return (self.implement,) * len(self.unknowns) + tuple(one.name for one in self.others)

    @property
    def described(self) -> dict[str, str]:
        """What each source's distribution rests on, by its name."""
        bat = {self.implement: self.bat_where} if self.bat_where else {}
        return bat | {one.name: one.where for one in self.others}

    def without(self, *names: str) -> Sources:
        """Return the sources but those of these names."""
        others = tuple(one for one in self.others if one.name not in names)
        return replace(self, others=others)

    def with_source(self, one: Source) -> Sources:
        """Return the sources and one more."""
        return replace(self, others=(*self.others, one))

    def normal(self, count: int, *, seed: int = 1) -> Array:
        """Return independent standard normal numbers, shape (count, n), spread evenly by Sobol's sequence.

        Parameters
        ----------
        count : a power of two.
        """
        return even_normal(count, len(self.names), seed=seed)

    def deviations(self, normal: Array) -> Array:
        """Return deviations from what was described for standard normal numbers, both of shape (count, n)."""
        import scipy.special

        count = len(self.unknowns)
        values, vectors = np.linalg.eigh(self.covariance)
        drawn = np.empty_like(normal)
        drawn[:, :count] = normal[:, :count] @ (vectors * np.sqrt(np.maximum(values, 0.0))).T
        for column, one in enumerate(self.others, start=count):
            if isinstance(one.spread, tuple):
                low, high = one.spread
                drawn[:, column] = low + (high - low) * scipy.special.ndtr(normal[:, column])
            else:
                drawn[:, column] = one.spread * normal[:, column]
        return drawn

    def of(self, name: str, deviations: Array) -> Array:
        """Return the deviations of one source that is not the bat's, shape (count,); 0 where it is no source."""
        names = self.names
        return deviations[:, names.index(name)] if name in names else np.zeros(len(deviations))


def even_normal(count: int, columns: int, *, seed: int = 1) -> Array:
    """Return independent standard normal numbers, shape (count, columns), spread evenly by Sobol's sequence.

    Parameters
    ----------
    count : a power of two.
    """
    import scipy.special
    import scipy.stats

    even = scipy.stats.qmc.Sobol(columns, seed=seed).random(count)
    return np.asarray(scipy.special.ndtri(np.clip(even, 1e-9, 1 - 1e-9)))


NOTHING = Sources((), np.zeros((0, 0)), ())
"""Everything is known."""


def sources_of(
    bat: Implement,
    conditions: Conditions,
    *,
    known: tuple[Sequence[Unknown], Array] | None = None,
    bat_speed_error: float = 0.0,
    pitch_speed_error: float = 0.0,
) -> Sources:
    """Return what is not known about a hit.

    Parameters
    ----------
    bat, conditions : what hits, and how.
    known : what is not known of the bat and its covariance, as `sweetspot calibrate` left it; None: what the catalogue
        allows for bats of this kind, after the weight, balance point and moment of inertia in its file.
    bat_speed_error, pitch_speed_error : one standard deviation in m/s; 0: exactly as given.
    """
    unknowns, covariance = _with_outline(bat, *(expected_deviations(bat) if known is None else known))
    of_kind = "materials of the catalogue" if isinstance(bat, Bat) else "how much others of its kind differ (assumed)"
    where = f"{of_kind}, after what its file says was measured" if known is None else "its calibration"
    where = where if unknowns else "taken as described: how its plies may differ is not modelled"
    return Sources(
        tuple(unknowns), np.asarray(covariance, dtype=np.float64),
        (*ball_sources(conditions), *patch_sources(bat), *_speeds(bat_speed_error, pitch_speed_error)), where,
        sport(bat.sport).words.implement,
    )  # fmt: skip


def _with_outline(bat: Implement, unknowns: Sequence[Unknown], covariance: Array) -> tuple[tuple[Unknown, ...], Array]:
    """Return unknowns and covariance with what a bat's outline leaves open of a moment that was not measured.

    Nothing but the outline tells the radius of gyration about the balance point, and the balance point itself where
    that was not measured either: then it is off by so much that both together are the doubt of `moi_doubt`.
    """
    measured = bat.as_measured()
    if not isinstance(measured, Bat) or is_swung(measured) or not unknowns:
        return tuple(unknowns), covariance
    more = [Unknown("gyration", OF_CENTRE / 2)]
    if not is_balanced(measured):
        body = rigid_body(beam_model(measured))
        rest = moi_doubt(measured, body, STANDARD_AXIS) ** 2 - (OF_CENTRE * body.moi_cm) ** 2
        moved = max(rest, 0.0) ** 0.5 / (2 * body.mass * (body.balance_point - STANDARD_AXIS))  # I_cm + M (x - axis)^2
        more.append(Unknown("balance_point", moved / body.balance_point))
    spreads = [one.spread for one in more]
    return (*unknowns, *more), np.pad(covariance, (0, len(more))) + np.diag([*np.zeros(len(unknowns)), *spreads]) ** 2


def expected_deviations(bat: Implement) -> tuple[tuple[Unknown, ...], Array]:
    """Return what is not known of a bat that was not calibrated, after what its file says was measured.

    What is laid up of plies has none: its doubt is not modelled.
    """
    measured = bat.as_measured()
    try:
        unknowns = unknowns_of(measured)
    except InputError:
        return (), np.zeros((0, 0))
    given = _written(measured)
    if not given:
        return unknowns, np.diag([one.spread**2 for one in unknowns])
    return unknowns, calibrate(described(measured), unknowns, given).covariance


def _written(own: Implement) -> list[Measurement]:
    """Return what a file says was measured; of a racket, club or stick the catalogue's own values were not."""
    others = () if isinstance(own, Bat) else map(implement, other_files())
    usual = next((one for one in others if one.sport == own.sport), None)
    mass, balance_point, moi, frequency = (
        None if name in own.fitted or (usual and getattr(own, name) == getattr(usual, name)) else getattr(own, name)
        for name in ("mass", "balance_point", "moi", "frequency")
    )
    given = []
    if mass is not None:
        given.append(Measurement("mass", Measured(mass, WEIGHED * mass)))
    if balance_point is not None:
        given.append(Measurement("balance_point", Measured(balance_point, BALANCED)))
    if moi is not None:
        given.append(Measurement("moi", Measured(moi, HUNG * moi), axis=own.moi_axis))
    if frequency is not None:
        given.append(Measurement("frequency", Measured(frequency, RUNG * frequency), mode=ModeName("bending", 1)))
    return given


def ball_sources(conditions: Conditions) -> tuple[Source, ...]:
    """Return what is not known of the ball: the catalogue's spreads are half widths of 90 % intervals."""
    return sources_of_ball(conditions.ball)


def sources_of_ball(ball: Ball) -> tuple[Source, ...]:
    """Return what is not known of a ball by itself; see `ball_sources`."""
    where = f"spread of {ball.name} in the catalogue"
    spreads = ball_spreads(ball)
    return tuple(Source(f"{OF_BALL}{name}".replace("_", " "), size / REACH, where) for name, size in spreads.items())


def patch_sources(bat: Implement) -> tuple[Source, ...]:
    """Return how large the patch is through which a ball presses a round bat: its logarithm, even between limits."""
    if not isinstance(bat, Bat):
        return ()
    low, high = (math.log(limit) for limit in PATCH_SPREAD)
    return (Source(PATCH, (low, high), "even between the shapes that a pressed ball can take"),)


def _speeds(bat: float, pitch: float) -> list[Source]:
    where = "as the speed was written"
    return [Source(name, error, where) for name, error in ((SWING, bat), (PITCH, pitch)) if error > 0]
