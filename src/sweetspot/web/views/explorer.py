"""Explorer: one bat, one swing, everything along the bat, the hit where the ball is, and why it is what it is."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.analysis.bat_analysis import analyse_reduced
from sweetspot.answers.conditions import HitConditions, hit_conditions
from sweetspot.answers.hit import CollisionNumbers, numbers_in_batch
from sweetspot.answers.records import Angle, Impulse, Length, Ratio, Speed, Spin
from sweetspot.answers.report import SweetSpotPlaces, report_of, sweet_spot_places
from sweetspot.answers.setups import SwungWith
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impacts, Outcome
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Interval, values_of
from sweetspot.reports.bat.words import answer_words, speed_difference, why_backwards, why_here, why_off_axis
from sweetspot.reports.hit.document import touched_again_at
from sweetspot.reports.notebook import effort_words
from sweetspot.reports.page_words import energy_names, energy_words, hits_fastest, leaves_here, place_words
from sweetspot.reports.sport_words import words_of
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH, SPEED, VIBRATION, System
from sweetspot.web.bats import changed_bat, place_of
from sweetspot.web.controls import HitState
from sweetspot.web.documents import ReadDocument, Sentences, in_both_systems, in_either_system, page_document
from sweetspot.web.drawings import BallPicture, BatPicture, ball_picture, bat_picture
from sweetspot.web.offline.bat_numbers import OfflineBat
from sweetspot.web.offline.page import FileHead, OneFile, offline_file
from sweetspot.web.recipes import Ask, bat_source, bat_text, lines_of, options_of, place_option, swing_options
from sweetspot.web.view import View
from sweetspot.web.views.explorer_curves import (
    CurvesOfHits,
    HitsAlongBat,
    Met,
    Publication,
    along,
    beside,
    curves,
    head_on,
    jumps_at,
    leaving,
    power_map,
    published,
    scans_at,
    struck,
    touched_twice,
)
from sweetspot.web.views.explorer_standing import standing


class ExplorerState(HitState):
    """The explorer's controls: the bat, the swing, the ball, and where they meet."""


@dataclass(frozen=True)
class SpeedParts:
    """The parts of the difference in exit speed from the best place; see `SpeedDifference`."""

    motion: float
    giving: float
    keeping: float
    whole: float


@dataclass(frozen=True, kw_only=True)
class ExplorerHit(CollisionNumbers):
    """The hit at the chosen place.

    Parameters
    ----------
    exit_speed, launch_angle, backspin : of the ball; None: it does not leave. Beyond a right angle it goes backwards.
    energy_shares : where the energy goes, by part.
    hand_impulse, sting : where values jump beside the place; elsewhere the curves tell.
    """

    touched_again: Sentences
    bat_speed: Speed
    exit_speed: Speed | None
    launch_angle: Angle | None
    backspin: Spin | None
    bbcor: Ratio
    energy_shares: Mapping[str, float]
    hand_impulse: Impulse | None = None
    sting: Annotated[float | None, VIBRATION] = None


@dataclass(frozen=True, kw_only=True)
class ExplorerAnswer:
    """Bat, sweet spots, curves along the bat, where the energy goes, the hit at the chosen place, and why.

    Parameters
    ----------
    place : of the hit, in words.
    headline : where the bat hits best, and what the ball does here.
    lost : against the best place; None: the ball does not leave forwards.
    """

    bat: BatPicture
    hands: Annotated[tuple[float, ...], LENGTH]
    sweet_spots: SweetSpotPlaces
    scan: CurvesOfHits
    energy_shares: Mapping[str, Array]
    energy_names: Mapping[str, str]
    touched_again: Sentences
    hit: ExplorerHit
    place: Mapping[System, str]
    headline: Sentences
    why: Sentences
    where_energy_goes: Sentences
    difference: Annotated[SpeedParts, SPEED]
    best_exit_speed: Speed
    lost: Speed | None
    ball: BallPicture
    published: tuple[Publication, ...]
    conditions: HitConditions


@dataclass(frozen=True)
class SpeedSpan:
    """Exit speed at a place by two laws of the ball."""

    position: Length
    low: Speed
    high: Speed


@dataclass(frozen=True)
class ReportWords:
    """The report's answer, and the cost of misses by two laws of the ball."""

    sentences: Sentences
    other_law: tuple[SpeedSpan, ...]


def answer(state: ExplorerState) -> ExplorerAnswer:
    """Return bat, sweet spots, curves along the bat, where the energy goes, the hit at the chosen place, and why."""
    setup = along(state)
    bat, conditions, spots, words = (
        setup.reduced.bat,
        setup.conditions,
        setup.spots,
        words_of(setup.reduced.bat.sport),
    )
    found = curves(state)
    hit, middle = _hit(state, setup, found)
    fastest = float(np.nanmax(setup.scan.exit_speed[beside(setup.scan, spots.max_exit_speed)]))
    difference = speed_difference(setup.scan, float(hit.position), best=spots.max_exit_speed, exit_speed=middle)
    backwards = hit.launch_angle is not None and abs(float(hit.launch_angle)) > math.pi / 2
    lost = None if backwards or hit.exit_speed is None else fastest - float(hit.exit_speed)
    if backwards:
        why = [why_backwards(state.offset_in * INCH, words=words)]
    else:
        why = [
            why_here(
                difference,
                body=setup.reduced.body,
                conditions=conditions,
                best=spots.max_exit_speed,
                words=words,
                in_the_middle=state.offset_in == 0,
            )
        ]
        if lost is not None and state.offset_in != 0:
            why.append(why_off_axis(state.offset_in * INCH, -lost - difference.whole, words=words))
    speed = None if hit.exit_speed is None else float(hit.exit_speed)
    headline = [
        hits_fastest(bat.name, bat.length - spots.max_exit_speed, fastest, words=words),
        *setup.doubts,
        leaves_here(bat.length - float(hit.position), speed, ends=hit.outcome_text, backwards=backwards, words=words),
    ]
    return ExplorerAnswer(
        bat=bat_picture(state, setup.reduced),
        hands=conditions.hands.places,
        sweet_spots=sweet_spot_places(spots),
        scan=found.curves,
        energy_shares=found.shares,
        energy_names=energy_names(found.shares, words),
        touched_again=found.touched_again,
        hit=hit,
        place=in_either_system(place_words(bat.length - float(hit.position), words=words)),
        headline=in_both_systems(headline),
        why=in_both_systems(why),
        where_energy_goes=in_both_systems(energy_words(hit.energy_shares, words)),
        difference=SpeedParts(difference.motion, difference.giving, difference.keeping, difference.whole),
        best_exit_speed=fastest,
        lost=lost,
        ball=ball_picture(state, conditions.ball),
        published=published(state, length=bat.length, most_efficient=spots.max_collision_efficiency),
        conditions=hit_conditions(conditions),
    )


def why(state: ExplorerState) -> ReportWords:
    """Return the report's answer on this bat and swing, and the cost of misses by two laws of the ball."""
    setup = along(state)
    report = report_of(analyse_reduced(setup.reduced, setup.conditions))
    best, top = float(report.sweet_spots.max_exit_speed), float(np.nanmax(values_of(report.scan.exit_speed)))
    sides = [
        (best + way * float(miss.distance), loss)
        for miss in report.misses
        for way, loss in ((-1, miss.inside), (1, miss.outside))
        if isinstance(loss, Interval)
    ]
    spans = [SpeedSpan(place, top - loss.high, top - loss.low) for place, loss in sides]
    return ReportWords(
        in_both_systems(answer_words(report)), tuple(sorted(spans, key=lambda span: float(span.position)))
    )


def sure(state: ExplorerState) -> ReadDocument:
    """Return the report with an interval beside each number, and what they come from; speeds are taken as they are."""
    from sweetspot.reports.bat.document import report_document
    from sweetspot.web.how_sure import PAGE_DRAWS, sources_for

    setup = along(state)
    analysis = analyse_reduced(setup.reduced, setup.conditions)
    sources = sources_for(state, setup.reduced.bat, analysis.conditions)
    return page_document(report_document(report_of(analysis, sources, drawn=True, draws=PAGE_DRAWS)))


def file(state: ExplorerState) -> OneFile:
    """Return a file of HTML that computes the hits of a state's bat itself; the ball is met on the bat's axis."""
    from sweetspot.web.how_sure import sources_for

    setup = along(state)
    bat, conditions, changed = setup.reduced.bat, setup.conditions, changed_bat(state)
    notes = [effort_words(SwungWith.of(changed, conditions, same_speed=state.same == "speed"))] if changed else []
    offline = OfflineBat(setup.reduced, conditions, sources_for(state, bat, conditions))
    from_tip = bat.length - place_of(state, bat, conditions)
    return OneFile.of(bat.name, offline_file(offline, head=FileHead(notes=notes), from_tip=from_tip))


def recipe(state: ExplorerState) -> dict[str, str]:
    """Return the lines that give the hit, and the curves of a ball met in the middle."""
    bat, options = (bat_source(state),), swing_options(state)
    place = place_option(state)
    if state.offset_in == 0:
        asks = [Ask("report", bat, options), Ask("hit", bat, place | options)]
    else:
        level = {"attack_angle": "0deg", "tilt": "0deg", "approach_angle": "0deg", "pitch_backspin": "0rpm"}
        off = place | options_of(state, "offset_in") | level | options
        note = f"of the ball met {abs(state.offset_in):.12g} in off the bat's axis"
        asks = [
            Ask("report", bat, options, note="all along the bat, of a ball met in the middle"),
            Ask("play", bat, off, note=note),
        ]
    return {**lines_of(*asks), "toml": bat_text(state)}


def _hit(state: ExplorerState, setup: Met, found: HitsAlongBat) -> tuple[ExplorerHit, float | None]:
    """Return the collision at the chosen place, and the exit speed there of a ball met in the middle.

    Off the bat's axis it is a level swing at a ball that comes level. Head-on the part along the line of centres is all
    there is, and is found three times as fast alone.
    """
    bat, conditions, modes = setup.reduced.bat, setup.conditions, setup.reduced.modes
    place = place_of(state, bat, conditions)
    coming, bat_speed = conditions.pitch.speed, conditions.swing.speed_at(place)
    if state.offset_in == 0:
        closing = coming + bat_speed
        hit: Impacts | Strikes
        hit, speed = head_on(setup, place)
        angle = spin = 0.0
    else:
        hit = struck(setup, position=[place], offset=state.offset_in * INCH)
        closing = float(hit.closing_speed[0])
        speed, angle, spin = (float(values[0]) for values in leaving(hit))
    numbers = numbers_in_batch(hit, position=place, closing_speed=closing)
    leaves = hit.outcome[0] == Outcome.SEPARATED
    again = touched_again_at(
        bool(hit.touches[0] > 1) or touched_twice(setup.scan, place, within=INCH),
        words_of(bat.sport),
        modes=modes,
        ball=conditions.ball,
        position=place,
        closing_speed=closing,
    )
    at = found.curves.position
    shares = {name: float(np.interp(place, at, part)) for name, part in found.shares.items()}
    middle = speed if state.offset_in == 0 else None
    push = felt = None
    if jumps_at(setup, place):  # between the neighbours lies nothing that happens
        on_axis, here = scans_at(state, place)
        middle = speed if state.offset_in == 0 else float(on_axis.exit_speed[0])
        push, felt = float(here.hand_impulse[0]), float(here.sting[0])
        shares = {name: round(float(part[0]), 5) for name, part in here.energy._asdict().items() if name in shares}
    result = ExplorerHit(
        **vars(numbers),
        touched_again=in_both_systems(again),
        bat_speed=bat_speed,
        exit_speed=speed if leaves else None,
        launch_angle=angle if leaves else None,
        backspin=spin if leaves else None,
        bbcor=bbcor(float(numbers.collision_efficiency), body=setup.reduced.body, ball=conditions.ball, position=place),
        energy_shares=shares,
        hand_impulse=push,
        sting=felt,
    )
    return result, middle if leaves or state.offset_in != 0 else None


VIEW = View(
    "explorer",
    "Explorer",
    ExplorerState,
    answer,
    recipe,
    asides={"map": power_map, "why": why, "standing": standing, "sure": sure, "file": file},
)
