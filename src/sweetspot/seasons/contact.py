"""On which place of which bat each ball was hit: ceilings, what was lost where, and the posterior of the contact.

Exit speed tells how far from the best place a ball was met, launch angle less attack angle how far above or below the
axis; which side of the best place it was, only the pitch's place tells. Errors are stated (`swings.Errors`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from sweetspot.catalog.league_batters import LEAGUE_BAT, LEAGUE_PITCH, SQUARED_UP
from sweetspot.equipment.ball import Ball
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.numerics.threads import in_parts
from sweetspot.seasons import contact_kernel as kernel
from sweetspot.seasons.balls import Balls, taken
from sweetspot.seasons.place_learning import learn_places
from sweetspot.seasons.place_relation import UNLEARNT, Circumstances, PlaceRelation, circumstances, turn_term
from sweetspot.seasons.plane_hits import PLACES, BatInPlane
from sweetspot.seasons.swings import OUTCOMES, USUAL_ERRORS, Errors, InPlane, ceilings, in_plane, likeliest_speeds
from sweetspot.units import MPH

BLAST = 164.0
"""Percent of the league's greatest exit speed and mph of bat speed together, from which it is a blast [statcast]."""
CHUNK = 8192
"""Balls that are worked on together: what is made of them on the way stays in a core's own memory."""
RANKS = 21
"""Quantiles of exit speeds at which the model's shape is corrected."""
RANKED_FROM = 2000
"""Balls from which on that is done; the ranks of fewer scatter by more than they are off."""
LEARNT_FROM = 10_000
"""Balls that the relation of places is learnt from, at most."""


@dataclass(frozen=True)
class OtherBat:
    """A bat that every swing is tried with.

    ``moi``: kg m^2 about the swing law's axis.
    """

    name: str
    surface: BatInPlane
    moi: float


@dataclass(frozen=True)
class ContactSetting:
    """The parameters that all balls of a table share.

    ``surfaces``: tables of the bats that occur. ``mois``: of the same about the swing law's axis, kg m^2. ``others``:
    bats that every swing is tried with. ``law``: of bat speed against moment of inertia. ``relation``: of places along
    the bat to the pitch's. ``threads``: workers; None: one per core.
    """

    ball: Ball
    surfaces: tuple[BatInPlane, ...]
    mois: tuple[float, ...]
    others: tuple[OtherBat, ...]
    law: SwingLaw
    errors: Errors = USUAL_ERRORS
    relation: PlaceRelation = UNLEARNT
    threads: int | None = None


@dataclass(frozen=True)
class Contacts:
    """Answers for n balls; NaN where there is none.

    Parameters
    ----------
    outcome : index into `OUTCOMES`.
    ceiling, league_ceiling : m/s, of this bat and by the league's formula.
    best_place : m from the tip where this bat's is.
    above_chance : that the true exit speed was above the true ceiling, measuring errors considered.
    above_improbable : of a ball met perfectly, to be measured at least so far above the ceiling.
    results : rows of `contact_kernel`, shape (n, rows).
    others : (mean, low, high) of the exit speed with each other bat, m/s; 90 % interval.
    """

    outcome: NDArray[np.int64]
    ceiling: Array
    league_ceiling: Array
    best_place: Array
    above_chance: Array
    above_improbable: Array
    results: Array
    others: Mapping[str, tuple[Array, Array, Array]]


def contacts(balls: Balls, bat_of: NDArray[np.int64], setting: ContactSetting) -> Contacts:
    """Return the places on their bats at which balls were hit.

    ``bat_of``: which of the setting's bats each ball was hit with, -1 where not known.
    """
    count = len(balls)
    outcome = np.full(count, OUTCOMES.index("no bat speed"), np.int64)
    ceiling, best, chance, improbable = np.full((4, count), np.nan)
    results = np.full((kernel.ROWS, count), np.nan).T  # columns are asked for one by one
    others = {
        other.name: (np.full(count, np.nan), np.full(count, np.nan), np.full(count, np.nan)) for other in setting.others
    }

    def work(number: int, everyone: NDArray[np.int64], part: slice) -> None:
        mine = everyone[part]
        surface, some = setting.surfaces[number], taken(balls, mine)
        plane = in_plane(some, surface, setting.errors, ball=setting.ball)
        ceiling[mine], best[mine] = ceilings(plane, surface)
        solved = plane.outcome == 0
        conditions = circumstances(some, setting.relation.bat_speeds)
        posteriors, weights = _posteriors(some, plane, conditions, best[mine], surface, setting, solved)
        results[mine] = posteriors
        grazed = solved & np.isnan(posteriors[:, kernel.KEPT])
        outcome[mine] = np.where(grazed, OUTCOMES.index("grazed"), plane.outcome)
        chance[mine], improbable[mine] = _above(some, plane, conditions, ceiling[mine], setting)
        swung = OtherBat("", surface, setting.mois[number])
        level = setting.relation.level_of(conditions, turn_term(plane.turned))
        for other in setting.others:
            answer = _with_other(some, plane, level, posteriors, weights, swung, other, setting.law, solved)
            for held, values in zip(others[other.name], answer, strict=True):
                held[mine] = values

    for number in range(len(setting.surfaces)):
        everyone = np.flatnonzero(bat_of == number)
        in_parts(partial(work, number, everyone), len(everyone), size=CHUNK, threads=setting.threads)
    league = LEAGUE_BAT * balls.bat_speed + LEAGUE_PITCH * balls.plate_speed
    return Contacts(outcome, ceiling, league, best, chance, improbable, results, others)


def asked_of(plane: InPlane) -> Array:
    """Return the kernel's query of a bat's table, shape (n, 7)."""
    return np.stack(
        [plane.bat_speed, plane.ahead, plane.up, plane.tangent, plane.turned, plane.angle_error, plane.speed_error],
        axis=-1,
    )


def learnt(balls: Balls, bat_of: NDArray[np.int64], setting: ContactSetting) -> PlaceRelation:
    """Return the relation of places learnt from some balls; an evenly drawn sample is enough.

    ``bat_of``: which of the setting's bats each ball was hit with, -1 where not known.
    """
    chosen: list[NDArray[np.int64]] = []
    tables, outs, widths, turns = [], [], [], []
    for number, surface in enumerate(setting.surfaces):
        mine = np.flatnonzero(bat_of == number)
        plane = in_plane(taken(balls, mine), surface, setting.errors, ball=setting.ball)
        good = plane.outcome == 0
        asked = asked_of(plane)[good]
        fast, spread = np.full((len(asked), len(PLACES)), np.nan), np.empty(len(asked))
        kernel.fill_predictions(surface.table, asked, fast, spread, _error_array(setting.errors))
        chosen.append(mine[good])
        tables.append(fast)
        outs.append(plane.exit_speed[good])
        widths.append(spread)
        turns.append(plane.turned[good])
    if not chosen or not sum(map(len, chosen)):
        return UNLEARNT
    everyone = np.concatenate(chosen)
    used = taken(balls, everyone)
    speeds = likeliest_speeds(used.bat_speed)
    relation = learn_places(
        circumstances(used, speeds),
        places=PLACES,
        predicted=np.concatenate(tables),
        measured=np.concatenate(outs),
        error=np.concatenate(widths),
        turned=turn_term(np.concatenate(turns)),
        measured_places=_measured_places(used, setting.errors),
    )
    relation = replace(relation, bat_speeds=speeds)
    if relation.balls < RANKED_FROM:
        return relation
    bare = replace(setting, relation=relation, others=())
    rank = contacts(used, bat_of[everyone], bare).results[:, kernel.RANK]
    ends = np.nanquantile(rank, np.linspace(0, 1, RANKS)[1:-1])
    return replace(relation, ranks=(0.0, *np.maximum.accumulate(ends).tolist(), 1.0))


def _measured_places(balls: Balls, errors: Errors) -> Array:
    """Return measured places, m from the tip, and one over the variance of their errors; 0 where none was measured."""
    tracked = np.isfinite(balls.axial_offset)
    return np.stack([np.where(tracked, SPEED_FROM_TIP - balls.axial_offset, 0.0), tracked / errors.axial_offset**2])


def _chances_of(balls: Balls) -> Array:
    """Return a number between 0 and 1 for each ball that is as good as drawn, and the same however rows are cut."""
    mixed = 7919.13 * balls.exit_speed + 104729.7 * balls.launch_angle + 1299.71 * balls.bat_speed
    return np.nan_to_num(mixed - np.floor(mixed))


def _error_array(errors: Errors) -> Array:
    return np.array([errors.exit_speed, errors.bat_speed])


def _posteriors(
    balls: Balls, plane: InPlane, conditions: Circumstances, best: Array, surface: BatInPlane, setting: ContactSetting,
    solved: NDArray[np.bool_],
) -> tuple[Array, Array]:  # fmt: skip
    places, sure = _measured_places(balls, setting.errors)
    measured = np.stack([places, np.full(len(places), setting.errors.axial_offset)], axis=-1)
    prior = np.where(sure[:, None] > 0, measured, setting.relation.prior(conditions))
    rows = np.flatnonzero(solved)
    asked = np.ascontiguousarray(asked_of(plane)[rows])
    posteriors = np.full((len(rows), kernel.ROWS), np.nan)
    weights = np.zeros((len(rows) if setting.others else 0, len(PLACES)))
    relation = setting.relation
    aims = np.stack([best, _chances_of(balls)], axis=-1)[rows]
    swing = conditions.some(rows), turn_term(plane.turned)[rows]
    given = asked, plane.exit_speed[rows], prior[rows], aims, _error_array(setting.errors)
    scatter = relation.level_of(*swing), relation.noise_of(*swing)
    kernel.fill_posteriors(surface.table, *given, *scatter, posteriors, weights)
    results = np.full((len(balls), kernel.ROWS), np.nan)
    posteriors[:, kernel.RANK] = relation.ranked(posteriors[:, kernel.RANK])
    results[rows] = posteriors
    everything = np.zeros((len(balls) if setting.others else 0, len(PLACES)))
    if setting.others:
        everything[rows] = weights
    return results, everything


def _above(
    balls: Balls, plane: InPlane, conditions: Circumstances, ceiling: Array, setting: ContactSetting
) -> tuple[Array, Array]:
    """Return the chance that a ball was truly above its ceiling, and how improbable a perfect hit would read so.

    Known beforehand is that a true exit speed is at most the ceiling with what balls and bats differ by; both are
    normal here, with the errors of exit and bat speed.
    """
    from scipy.special import ndtr

    coming = np.hypot(plane.ahead, plane.up)
    per_speed = (ceiling + coming) / np.maximum(plane.bat_speed + coming, 1.0)
    perfect = conditions, np.zeros(len(balls))
    parts = (
        setting.errors.exit_speed,
        plane.speed_error,
        per_speed * setting.errors.bat_speed,
        setting.relation.noise_of(*perfect),
    )
    spread = np.sqrt(sum(np.square(part) for part in parts))
    off = (balls.exit_speed - (1 + setting.relation.level_of(*perfect)) * ceiling) / spread
    return np.asarray(ndtr(off)), np.asarray(ndtr(-off))


def _with_other(
    balls: Balls, plane: InPlane, level: Array, posteriors: Array, weights: Array, swung: OtherBat, other: OtherBat,
    law: SwingLaw, solved: NDArray[np.bool_],
) -> tuple[Array, Array, Array]:  # fmt: skip
    """Return exit speeds that the same swings would have given with another bat, and their 90 % intervals."""
    rows = np.flatnonzero(solved)
    asked, offset, parts = asked_of(plane)[rows], posteriors[rows, kernel.OFFSET], weights[rows]

    def mean_with(bat: OtherBat, ratio: float) -> Array:
        mean, spread = np.empty((2, len(rows)))
        kernel.fill_other_bat(bat.surface.table, asked, offset, parts, ratio, mean, spread)
        return mean

    arms = [bat.length - bat.choke - SPEED_FROM_TIP for bat in (swung.surface.bat, other.surface.bat)]
    exponents = law.exponents
    mean, low, high = (
        mean_with(other, law.speed_ratio(other.moi, reference_moi=swung.moi, exponent=exponent) * arms[1] / arms[0])
        for exponent in (exponents.value, exponents.low, exponents.high)
    )
    level = 1 + level[rows]
    reach = REACH * level * (np.abs(low - high) / (2 * REACH))
    fast = plane.exit_speed[rows] + level * (mean - mean_with(swung, 1.0))
    answer = np.sqrt(fast**2 + balls.exit_speed[rows] ** 2 - plane.exit_speed[rows] ** 2)
    full = np.full((3, len(solved)), np.nan)
    full[:, rows] = answer, answer - reach, answer + reach
    return full[0], full[1], full[2]


def measures(balls: Balls, contacts: Contacts) -> dict[str, Array]:
    """Return the quantities that are counted and averaged over players; chances are from 0 to 1."""
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = balls.exit_speed / contacts.ceiling
        league = np.where(np.isnan(ratio), np.nan, balls.exit_speed / contacts.league_ceiling)
        blast = 100 * league + balls.bat_speed / MPH >= BLAST
        rated = np.isfinite(league)
        return {
            "squared_up_ratio": ratio,
            "squared_up": np.where(np.isfinite(ratio), ratio >= SQUARED_UP, np.nan),
            "league_ratio": league,
            "league_squared_up": np.where(rated, league >= SQUARED_UP, np.nan),
            "blast": np.where(rated, blast, np.nan),
            "kept_vertically": np.minimum(contacts.results[:, kernel.KEPT] / contacts.ceiling, 1.0),
        }
