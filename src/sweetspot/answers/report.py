"""Where an implement hits best, and why: sweet spots, curves along it, its best hit, what misses cost, how it rings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, Loss, analyse_reduced, exit_speed_of, miss_costs, too_soft
from sweetspot.analysis.face_maps import FaceMap, face_map
from sweetspot.analysis.sweet_spot import SweetSpots
from sweetspot.answers.answer import Answer, Uncertainty, with_draws
from sweetspot.answers.conditions import HitConditions, hit_conditions
from sweetspot.answers.description import Description, described
from sweetspot.answers.handling import HitBeside, hits_beside
from sweetspot.answers.hit import Hit, hit_of
from sweetspot.answers.records import (
    GAPS,
    GRID,
    INTERNAL,
    Frequency,
    Length,
    Mass,
    Ratio,
    Speed,
)
from sweetspot.answers.report_draws import drawn_report
from sweetspot.answers.setups import SwungWith
from sweetspot.answers.worth_measuring import WorthMeasuring, worth_measuring_of
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, Curve, Interval
from sweetspot.uncertainty.drawn_hits import SpeedDoubt, speed_doubt
from sweetspot.uncertainty.sources import DRAWS, Sources, errors_by_ball
from sweetspot.units import INCH
from sweetspot.units.dimensions import IMPULSE, LENGTH, SPEED

WRITTEN_MODES = ("bending", "hoop", "face")
"""Families of modes that are answered; rigid motions and the hands' own are not."""
MISSES = {"in": (1 * INCH, 2 * INCH, 3 * INCH), "cm": (0.02, 0.04, 0.06)}
"""m, by the unit in which a sport's people read places; half of that on faces too short for two of them."""


@dataclass(frozen=True)
class VibrationMode:
    """One mode: its family, number, tone, damping, and where it does not move, from the knob end."""

    family: str
    harmonic: int
    frequency: Frequency
    damping_ratio: Ratio
    nodes: Annotated[Curve, LENGTH]


@dataclass(frozen=True)
class SweetSpotPlaces:
    """Every meaning of "sweet spot", from the knob end; see `SweetSpots`.

    ``zone``, ``zone_width``: its two ends, shape (2,), and how far they lie apart; None where there is none.
    """

    center_of_percussion: Length
    node_1: Length
    node_2: Length
    max_collision_efficiency: Length
    max_exit_speed: Length
    min_sting: Length
    zone: Annotated[Curve, LENGTH] | None
    zone_width: Annotated[Length, INTERNAL] | None


@dataclass(frozen=True)
class CurvesAlong:
    """What a hit does at every place along the implement, arrays of one shape (n,); see `Scan`."""

    position: Annotated[Array, LENGTH]
    collision_efficiency: Curve
    bbcor: Curve
    bat_speed: Annotated[Curve, SPEED]
    exit_speed: Annotated[Curve, SPEED]
    rigid_exit_speed: Annotated[Curve, SPEED]
    hand_impulse: Annotated[Curve, IMPULSE]
    sting: Curve


@dataclass(frozen=True)
class Miss:
    """Exit speed lost by hitting beside the best place, towards the hands and towards the tip.

    ``inside``, ``outside``: with the interval that the law of the ball leaves open, or that of draws; nan where nothing
    is hit.
    """

    distance: Length
    inside: Speed
    outside: Speed


@dataclass(frozen=True)
class AtTheTip:
    """The last place to be hit beside the best one.

    Parameters
    ----------
    bat_speed_gain : how much faster it moves.
    exit_speed_loss : how much slower the ball leaves.
    effective_mass, best_effective_mass : what the ball meets there and at the best place.
    exit_speed, rigid_exit_speed : of a hit there, and as if the implement were rigid.
    """

    bat_speed_gain: Speed
    exit_speed_loss: Speed
    effective_mass: Mass
    best_effective_mass: Mass
    exit_speed: Speed
    rigid_exit_speed: Speed


@dataclass(frozen=True, kw_only=True)
class BestHit(Hit):
    """The hit at the best place.

    ``exit_speed_half``: of the interval of its exit speed where no draws were made; None: not known, or draws were.
    """

    exit_speed_half: Speed | None = None


@dataclass(frozen=True)
class HitsOnFace:
    """Hits on a grid over a face, rows across it; nan off the face."""

    position: Annotated[Array, LENGTH]
    lateral: Annotated[Array, LENGTH]
    collision_efficiency: Annotated[Array, GRID, GAPS]
    exit_speed: Annotated[Array, SPEED, GRID, GAPS]
    sting: Annotated[Array, GRID, GAPS]


@dataclass(frozen=True, kw_only=True)
class ReportAnswer(Description, Answer):
    """Everything about one implement and one swing; see `Description` for what it is unswung.

    Parameters
    ----------
    grip_effect : relative change of the best exit speed by typical hands.
    face_map : of what has a face.
    off_center : hits beside the middle, of what has a flat face; the ball leaves at an angle.
    misses : what they cost; none on a face too short for one.
    at_the_tip : None where the tip is the best place, or moves no faster.
    uncertainty : of the best exit speed, where draws were made.
    worth_measuring : what was not measured on it and would narrow that interval, the least work first.
    analysis : what the answer was read from.
    doubt : of the best exit speed without draws; None: not known, or draws were made.
    half_by_ball : of the interval that the ball alone leaves to the best exit speed, where nothing else was asked.
    greatest_efficiency, lowest_hoop : greatest q along it; the lowest tone of its wall, None where it has no wall.
    """

    modes: tuple[VibrationMode, ...]
    sweet_spots: SweetSpotPlaces
    scan: CurvesAlong
    best_hit: BestHit
    grip_effect: Ratio
    conditions: HitConditions
    misses: tuple[Miss, ...]
    at_the_tip: AtTheTip | None
    off_center: tuple[HitBeside, ...] = ()
    face_map: HitsOnFace | None = None
    uncertainty: Uncertainty | None = None
    worth_measuring: tuple[WorthMeasuring, ...] = ()
    swung_with: SwungWith | None = None
    analysis: Annotated[Analysis[Implement], INTERNAL]
    doubt: Annotated[SpeedDoubt | None, INTERNAL] = None
    half_by_ball: Annotated[float | None, INTERNAL] = None
    greatest_efficiency: Annotated[Ratio, INTERNAL]
    lowest_hoop: Annotated[Frequency | None, INTERNAL]


@dataclass(frozen=True)
class ReportQuestion:
    """A report that is asked for.

    ``sources``: what is not known; None: the exit speed is answered with what the ball alone leaves to it. ``drawn``:
    whether every number gets its interval, from ``draws`` draws of the sources; else the best exit speed alone.
    """

    reduced: ReducedBat[Implement]
    conditions: Conditions
    sources: Sources | None = None
    drawn: bool = False
    draws: int = field(default=DRAWS, kw_only=True)


def report_answer(question: ReportQuestion) -> ReportAnswer:
    """Return the places where an implement hits best, and the reasons.

    Raises
    ------
    InputError
        when the swing or the hands do not go with it, or the ball outweighs it.
    """
    analysis = analyse_reduced(question.reduced, question.conditions)
    return report_of(analysis, question.sources, drawn=question.drawn, draws=question.draws)


def report_of(
    analysis: Analysis[Implement], sources: Sources | None = None, *, drawn: bool = False, draws: int = DRAWS
) -> ReportAnswer:
    """Return the report of an analysis; see `ReportQuestion`."""
    plain = _described(analysis)
    best, place = plain.best_hit, analysis.sweet_spots.max_exit_speed
    if sources is None:
        errors = None if too_soft(analysis) else errors_by_ball(analysis.held, analysis.conditions, place)
        return replace(plain, half_by_ball=None if errors is None else REACH * errors.whole)
    doubt = None if too_soft(analysis) else speed_doubt(analysis, sources)
    worth = () if doubt is None else worth_measuring_of(doubt.narrowings, [plain.bat.name])
    if not drawn:
        half = None if doubt is None else REACH * doubt.error
        return replace(plain, doubt=doubt, worth_measuring=worth, best_hit=replace(best, exit_speed_half=half))
    found = drawn_report(analysis, sources, misses=plain.misses, count=draws)
    return replace(with_draws(plain, found, sources, of="best_hit.exit_speed"), worth_measuring=worth)


def _described(analysis: Analysis[Implement]) -> ReportAnswer:
    """Return the report of an implement as it is described."""
    bat, body, scan, spots = analysis.bat, analysis.body, analysis.scan, analysis.sweet_spots
    hoops, face = analysis.modes.of_family("hoop"), bat.face is not None
    best = hit_of(analysis.best, body=body, conditions=analysis.conditions)
    return ReportAnswer(
        **vars(described(analysis.beam, body)),
        modes=vibration_modes(analysis.modes),
        sweet_spots=sweet_spot_places(spots),
        scan=CurvesAlong(
            position=scan.position,
            collision_efficiency=scan.collision_efficiency,
            bbcor=scan.bbcor,
            bat_speed=scan.bat_speed,
            exit_speed=scan.exit_speed,
            rigid_exit_speed=scan.rigid_exit_speed,
            hand_impulse=scan.hand_impulse,
            sting=scan.sting,
        ),
        best_hit=BestHit(**vars(best)),
        grip_effect=analysis.grip_effect,
        conditions=hit_conditions(analysis.conditions),
        misses=misses_of(analysis),
        at_the_tip=_at_the_tip(analysis),
        off_center=hits_beside(bat, body, analysis.modes, analysis.conditions),
        face_map=hits_on_face(face_map(analysis.reduced, analysis.conditions)) if face else None,
        analysis=analysis,
        greatest_efficiency=float(np.nanmax(scan.collision_efficiency)),
        lowest_hoop=float(analysis.modes.frequency[hoops].min()) if hoops else None,
    )


def vibration_modes(modes: Modes) -> tuple[VibrationMode, ...]:
    """Return the vibrating modes of an implement; rigid motions and the hands' own are left out."""
    ratio = modes.damping_ratio
    return tuple(
        VibrationMode(family, modes.harmonics[index], float(modes.frequency[index]), float(ratio[index]), nodes)
        for index, family in enumerate(modes.families)
        if family in WRITTEN_MODES
        for nodes in [modes.nodes(index)]
    )


def sweet_spot_places(spots: SweetSpots) -> SweetSpotPlaces:
    """Return every meaning of "sweet spot" as people ask for it."""
    return SweetSpotPlaces(
        center_of_percussion=spots.center_of_percussion,
        node_1=spots.node_1,
        node_2=spots.node_2,
        max_collision_efficiency=spots.max_collision_efficiency,
        max_exit_speed=spots.max_exit_speed,
        min_sting=spots.min_sting,
        zone=None if spots.zone is None else np.array(spots.zone),
        zone_width=None if spots.zone is None else spots.zone[1] - spots.zone[0],
    )


def hits_on_face(hits: FaceMap) -> HitsOnFace:
    """Return hits all over a face as people ask for them."""
    return HitsOnFace(hits.position, hits.lateral, hits.collision_efficiency, hits.exit_speed, hits.sting)


def misses_of(analysis: Analysis[Implement]) -> tuple[Miss, ...]:
    """Return the costs of up to three misses that still hit the face on the hands' side."""
    best, nearest = analysis.sweet_spots.max_exit_speed, float(analysis.scan.position[0])
    usual = MISSES[sport(analysis.bat.sport).words.place_unit]
    fitting = [tuple(part * each for each in usual if best - part * each >= nearest) for part in (1.0, 0.5)]
    distances = fitting[0] if len(fitting[0]) > 1 else fitting[1]  # half as far on a short face
    costs: Sequence[tuple[Loss, Loss]] = miss_costs(analysis, distances) if distances else []
    return tuple(
        Miss(distance, *(Interval(*loss) if loss.low < loss.high else loss.value for loss in both))
        for distance, both in zip(distances, costs, strict=True)
    )


def _at_the_tip(analysis: Analysis[Implement]) -> AtTheTip | None:
    """Return the last place to be hit beside the best one; None where it is the best, or moves no faster."""
    scan, body, swing = analysis.scan, analysis.body, analysis.conditions.swing
    best, last = analysis.sweet_spots.max_exit_speed, float(scan.position[-1])
    top, end = exit_speed_of(analysis.best, analysis.conditions), float(scan.exit_speed[-1])
    gain = swing.speed_at(last) - swing.speed_at(best)
    if not gain > 0 or not top > end:
        return None
    return AtTheTip(
        bat_speed_gain=gain,
        exit_speed_loss=top - end,
        effective_mass=effective_mass(body, last),
        best_effective_mass=effective_mass(body, best),
        exit_speed=end,
        rigid_exit_speed=float(scan.rigid_exit_speed[-1]),
    )
