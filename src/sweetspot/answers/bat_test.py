"""The bat test of a laboratory: what the model computes of it, and what measured shots say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.analysis.certification.rules import Check, Rule
from sweetspot.analysis.certification.shot_statistics import Estimate, Outlier, ShotStatistics
from sweetspot.analysis.certification.shots import Shots
from sweetspot.analysis.certification.simulated_test import CLAMP, BatTest, Certification, SwungTest, besr
from sweetspot.answers.records import INTERNAL, Length, Ratio, Speed
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.tables.cells import BadRow
from sweetspot.uncertainty.drawn_tests import DrawnTest
from sweetspot.units.dimensions import LENGTH, SPEED, STIFFNESS

Ends = tuple[float, float]
"""The least and the greatest value."""


@dataclass(frozen=True)
class MeasureSpreads:
    """Between which values something leaves each measure; see `Certification.spreads`."""

    bbcor: Ends
    besr: Ends
    bpf: Ends
    batted_ball_speed: Annotated[Ends, SPEED]


@dataclass(frozen=True)
class ScanAtRest:
    """Hits along the barrel of a bat at rest, arrays of shape (places,); see `BatTest`."""

    closing_speed: Speed
    ball_restitution: Ratio
    best_position: Length
    best_at_edge: bool
    position: Annotated[Array, LENGTH]
    collision_efficiency: Array
    bbcor: Array


@dataclass(frozen=True, kw_only=True)
class SimulatedTest:
    """The measures of a bat from the model, at its best place; see `Certification`.

    Parameters
    ----------
    pivot : the clamp's axis, from the knob end.
    spread, spread_by_law, spread_by_moi, spread_by_wall : what the ball's patch, the law of the ball, the moment of
        inertia and the wall leave open; None where it was measured, or is not known.
    fast, slow : the scans at the game's closing speed and at 60 mph.
    swung : the swing and the pitch that the fast test stands for.
    """

    pivot: Length
    bbcor: Ratio
    collision_efficiency: Ratio
    besr: Ratio
    bpf: Ratio
    batted_ball_speed: Speed
    spread: MeasureSpreads
    spread_by_law: MeasureSpreads | None = None
    spread_by_moi: MeasureSpreads | None = None
    spread_by_wall: MeasureSpreads | None = None
    best_position: Length
    fast: ScanAtRest
    slow: ScanAtRest
    swung: Annotated[SwungTest, INTERNAL]


def simulated_test(certification: Certification) -> SimulatedTest:
    """Return a simulated test as people ask for it."""
    return SimulatedTest(
        pivot=CLAMP,
        bbcor=certification.bbcor,
        collision_efficiency=certification.fast.best_efficiency,
        besr=certification.besr,
        bpf=certification.bpf,
        batted_ball_speed=certification.batted_ball_speed,
        spread=MeasureSpreads(**certification.spreads),
        spread_by_law=MeasureSpreads(**certification.law_spreads) if certification.law_spreads else None,
        spread_by_moi=MeasureSpreads(**certification.moi_spreads) if certification.moi_spreads else None,
        spread_by_wall=MeasureSpreads(**certification.wall_spreads) if certification.wall_spreads else None,
        best_position=certification.fast.best_position,
        fast=_scan(certification.fast),
        slow=_scan(certification.slow),
        swung=certification.swung,
    )


def _scan(test: BatTest) -> ScanAtRest:
    return ScanAtRest(
        closing_speed=test.closing_speed,
        ball_restitution=test.ball_restitution,
        best_position=test.best_position,
        best_at_edge=test.at_edge,
        position=test.position,
        collision_efficiency=test.collision_efficiency,
        bbcor=test.bbcor,
    )


@dataclass(frozen=True)
class SpeedEstimate:
    """The mean of measured speeds with its standard error and 90 % interval; see `Estimate`."""

    mean: Speed
    standard_error: Speed
    low: Speed
    high: Speed
    count: int


@dataclass(frozen=True)
class ShotsAtPlace:
    """How many shots hit one place, from the knob end, and their mean BBCOR."""

    position: Length
    count: int
    bbcor: Ratio


@dataclass(frozen=True, kw_only=True)
class MeasuredShots:
    """What measured shots say of a bat, at its best place; see `ShotStatistics`.

    Parameters
    ----------
    good_rows, bad_rows, ignored_columns : how many rows were used, those that were not and why, and unused columns.
    rows : lines of the file that the means are made of.
    bbcor, raw_bbcor : normalized to ``standard_ball_cor``, where that is not None, and as measured.
    outliers, bbcor_without_outliers : hits that stand out, and BBCOR without them; None where none does.
    slowest_closing_speed, fastest_closing_speed, ball_stiffness : of the shots there.
    """

    good_rows: int
    bad_rows: tuple[BadRow, ...]
    ignored_columns: tuple[str, ...]
    places: tuple[ShotsAtPlace, ...]
    best_position: Length
    rows: tuple[int, ...]
    bbcor: Estimate
    raw_bbcor: Estimate
    standard_ball_cor: float | None
    collision_efficiency: Estimate
    besr: Ratio
    bpf: Estimate | None
    batted_ball_speed: SpeedEstimate
    outliers: tuple[Outlier, ...]
    bbcor_without_outliers: Estimate | None
    slowest_closing_speed: Speed
    fastest_closing_speed: Speed
    ball_stiffness: Annotated[float | None, STIFFNESS]
    notes: tuple[str, ...]
    swung: Annotated[SwungTest, INTERNAL]


def measured_shots(measured: ShotStatistics, shots: Shots) -> MeasuredShots:
    """Return the results of measured shots in the quantities of the rules."""
    return MeasuredShots(
        good_rows=len(shots.shots),
        bad_rows=tuple(shots.bad_rows),
        ignored_columns=tuple(shots.ignored_columns),
        places=tuple(ShotsAtPlace(place.position, place.count, place.bbcor) for place in measured.places),
        best_position=measured.best_position,
        rows=measured.rows,
        bbcor=measured.bbcor,
        raw_bbcor=measured.raw_bbcor,
        standard_ball_cor=measured.standard_restitution,
        collision_efficiency=measured.efficiency,
        besr=besr(measured.efficiency.mean),
        bpf=measured.bpf,
        batted_ball_speed=SpeedEstimate(**vars(measured.batted_ball_speed)),
        outliers=measured.outliers,
        bbcor_without_outliers=measured.without_outliers,
        slowest_closing_speed=measured.slowest,
        fastest_closing_speed=measured.fastest,
        ball_stiffness=measured.ball_stiffness,
        notes=tuple(measured.notes),
        swung=measured.swung,
    )


OF_SHOTS = ("bbcor", "bpf", "batted_ball_speed")
"""Quantities of rules that shots estimate, as fields of `ShotStatistics`."""
BY_RECOIL = ("bbcor", "bpf")
"""Those that are worked out with the bat's moment of inertia."""
NODES = 2001
"""Moments of inertia, equally probable, over which a probability is averaged."""


def chance_of_draws(check: Check, drawn: DrawnTest) -> float | None:
    """Return the part of the draws that keep a rule's limits; None where draws do not answer what it limits."""
    margins = drawn_margin(check, drawn)
    return None if margins is None else float(np.mean(margins[1:] >= 0))


def drawn_margin(check: Check, drawn: DrawnTest) -> Array | None:
    """Return the margin of every draw to a rule's nearer limit, shape (draws,); None for quantities without draws."""
    values = drawn.of_rule(check.rule.quantity) if _is_limited(check) else None
    if values is None:
        return None
    sides = [sign * (values - limit) for sign, limit in _limits(check.rule)]
    return np.asarray(np.min(sides, axis=0))


def _is_limited(check: Check) -> bool:
    return check.margin is not None and bool(_limits(check.rule))


def _limits(rule: Rule) -> list[tuple[int, float]]:
    """Return a rule's limits with the side of each on which it is kept."""
    return [(sign, limit) for sign, limit in ((1, rule.least), (-1, rule.most)) if limit is not None]


def chance_by_shots(check: Check, measured: ShotStatistics) -> float | None:
    """Return the probability that a rule is kept by the standard error of shots; None where they do not estimate it."""
    rule = check.rule
    if not _is_limited(check) or rule.quantity not in OF_SHOTS:
        return None
    estimate: Estimate | None = getattr(measured, rule.quantity)
    if estimate is None or not estimate.standard_error > 0:
        return None
    by_moi = measured.by_moi / REACH * estimate.mean if rule.quantity in BY_RECOIL else 0.0
    return within_limits(estimate, rule.least, rule.most, by_moi=by_moi)


def within_limits(estimate: Estimate, least: float | None, most: float | None, *, by_moi: float = 0.0) -> float:
    """Return the probability that what shots estimate lies within limits.

    The mean follows Student's t of its standard error, and what a moment of inertia in doubt adds is normal.

    ``by_moi``: one standard deviation that the moment leaves open, in the estimate's unit; 0: it was measured.
    """
    import scipy.special

    nodes = NODES if by_moi else 1
    off = by_moi * scipy.special.ndtri((np.arange(nodes) + 0.5) / nodes)

    def below(limit: float) -> float:
        apart = (limit - estimate.mean - off) / estimate.standard_error
        return float(np.mean(scipy.special.stdtr(max(estimate.count - 1, 1), apart)))

    return (1.0 if most is None else below(most)) - (0.0 if least is None else below(least))
