"""The bat test of a laboratory: what the model computes of it, and what measured shots say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from sweetspot.analysis.certification.shot_statistics import Estimate, Outlier, ShotStatistics
from sweetspot.analysis.certification.shots import Shots
from sweetspot.analysis.certification.simulated_test import CLAMP, BatTest, Certification, SwungTest, besr
from sweetspot.answers.records import INTERNAL, Length, Ratio, Speed
from sweetspot.numerics.arrays import Array
from sweetspot.tables.cells import BadRow
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
    spread, spread_by_moi, spread_by_wall : what the ball's patch, the moment of inertia and the wall leave open; None
        where it was measured.
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
