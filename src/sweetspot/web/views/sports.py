"""Every sport: a racket, bat, club or stick at its own stroke, hit anywhere on its face."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from functools import lru_cache
from typing import Annotated

import numpy as np
from pydantic import Field

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced
from sweetspot.analysis.face_maps import face_map
from sweetspot.analysis.position_scan import sting
from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.hit import CollisionNumbers, numbers_in_batch
from sweetspot.answers.records import GAPS, Length, Speed
from sweetspot.answers.report import HitsOnFace, SweetSpotPlaces, report_of, sweet_spot_places
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.motion.swing import Conditions, Pitch
from sweetspot.numerics.arrays import Array
from sweetspot.plausibility import bounds
from sweetspot.reports.bat.words import answer_words
from sweetspot.reports.hit.document import touched_again_at, touched_again_between
from sweetspot.reports.page_words import hits_fastest, leaves_here
from sweetspot.reports.sport_words import words_of
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import INCH, MPH
from sweetspot.units.dimensions import LENGTH, SPEED, VIBRATION
from sweetspot.web.bats import implement_of
from sweetspot.web.controls import Name, Toml, ViewState, within
from sweetspot.web.documents import Sentences, in_both_systems
from sweetspot.web.errors import FieldError, about
from sweetspot.web.offline.bat_numbers import OfflineBat
from sweetspot.web.offline.page import OneFile, offline_file
from sweetspot.web.recipes import Ask, lines_of, number, options_of
from sweetspot.web.view import View

ALONG, ACROSS = 48, 30
FILE = "mine.toml"


class SportsState(ViewState):
    """The implement, its speed, and the place of the ball; empty: as is usual in its sport."""

    implement: Name = Field(
        "tennis-racket", description="name in the catalogue; not looked at when implement_toml is given"
    )
    implement_toml: Toml | None = Field(None, description="the text of a file of one's own")
    swing_mph: Annotated[float, within("bat_speed", "mph", "tennis")] | None = Field(
        None, description="of the implement, where measured"
    )
    incoming_mph: Annotated[float, within("pitch_speed", "mph", "tennis")] | None = Field(
        None, description="of the ball before"
    )
    met_from_tip_in: Annotated[float, Field(ge=0, le=bounds("length").high)] | None = Field(
        None, description="where the ball meets it"
    )
    aside_in: float = Field(0.0, ge=-6, le=6, description="across the face, from its line")


@dataclass(frozen=True)
class ToolFacts(MassProperties):
    """An implement, and what it is made of."""

    made_of: str


@dataclass(frozen=True, kw_only=True)
class SportsHit(CollisionNumbers):
    """The hit at the chosen place; ``exit_speed`` None: the ball does not leave."""

    touched_again: Sentences
    bat_speed: Speed
    exit_speed: Speed
    sting: Annotated[float, VIBRATION]


@dataclass(frozen=True)
class CurvesAlongTool:
    """Hits along an implement, shape (n,)."""

    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED, GAPS]
    rigid_exit_speed: Annotated[Array, SPEED, GAPS]
    collision_efficiency: Annotated[Array, GAPS]
    sting: Annotated[Array, VIBRATION, GAPS]


@dataclass(frozen=True)
class SportsBall:
    """The ball of the sport."""

    name: str
    radius: Length


@dataclass(frozen=True, kw_only=True)
class SportsPicture:
    """An implement's sweet spots, curves along it, and the hit at the chosen place, in its sport's words."""

    implement: str
    has_face: bool
    sport: str
    words: Terms
    tool: ToolFacts
    ball: SportsBall
    swing_mph: float
    incoming_mph: float
    sweet_spots: SweetSpotPlaces
    scan: CurvesAlongTool
    hit: SportsHit
    headline: Sentences
    touched_again: Sentences


@dataclass(frozen=True)
class FaceMapPicture(HitsOnFace):
    """Hits all over a face, and the best of them."""

    best: Length
    best_lateral: Length


@dataclass(frozen=True)
class SportsFace:
    """Hits all over the face; None: there is none."""

    face: FaceMapPicture | None


@dataclass(frozen=True)
class SportsWords:
    """The place of the best hits and the reasons."""

    sentences: Sentences


def answer(state: SportsState) -> SportsPicture:
    """Return the implement's sweet spots, curves along it, and the hit at the chosen place."""
    analysis = _played(state)
    tool, conditions, along = analysis.bat, analysis.conditions, analysis.scan
    words, hit = words_of(tool.sport), _hit(state, analysis)
    again = touched_again_between(tool.length - along.position, along.touches, words)
    fastest = float(np.interp(analysis.sweet_spots.max_exit_speed, along.position, along.exit_speed))
    headline = [
        hits_fastest(tool.name, tool.length - analysis.sweet_spots.max_exit_speed, fastest, words=words),
        leaves_here(
            tool.length - float(hit.position),
            float(hit.exit_speed),
            ends=hit.outcome_text,
            aside=float(hit.lateral),
            words=words,
        ),
    ]
    return SportsPicture(
        implement=state.implement,
        has_face=_has_face(tool),
        sport=catalog.sport(tool.sport).name,
        words=words,
        tool=ToolFacts(**vars(mass_properties(tool, analysis.body)), made_of=tool.made_of),
        ball=SportsBall(conditions.ball.name, conditions.ball.radius),
        swing_mph=conditions.swing.bat_speed / MPH,
        incoming_mph=conditions.pitch.speed / MPH,
        sweet_spots=sweet_spot_places(analysis.sweet_spots),
        scan=CurvesAlongTool(*(getattr(along, field.name).round(6) for field in fields(CurvesAlongTool))),
        hit=hit,
        headline=in_both_systems(headline),
        touched_again=in_both_systems(again),
    )


def sentences(state: SportsState) -> SportsWords:
    """Return the place of the best hits and the reasons, in either system of units."""
    report = replace(report_of(_played(state)), misses=())  # they stand in the picture
    return SportsWords(in_both_systems(answer_words(report)))


def face(state: SportsState) -> SportsFace:
    """Return the outcome of a hit at every place of the face; nothing where an implement has none."""
    return SportsFace(_face(_played(state)))


def _played(state: SportsState) -> Analysis[Implement]:
    return _analysed(state.implement, state.implement_toml, state.swing_mph, state.incoming_mph)


@lru_cache(maxsize=32)
def _reduced(name: str, text: str | None) -> ReducedBat[Implement]:
    """Return an implement with its modes under its usual ball."""
    tool = implement_of(name, text)
    with about("implement" if text is None else "implement_toml"):
        return reduced_bat(tool, ball=standard_conditions(tool).ball)


@lru_cache(maxsize=64)
def _analysed(name: str, text: str | None, swing: float | None, incoming: float | None) -> Analysis[Implement]:
    """Return an implement with its usual or chosen stroke."""
    reduced = _reduced(name, text)
    tool = reduced.bat
    usual = standard_conditions(tool)
    with about("swing_mph"):
        conditions = Conditions(
            pitch=usual.pitch if incoming is None else Pitch(speed=incoming * MPH),
            swing=usual.swing if swing is None else usual.swing.replaced(bat_speed=swing * MPH),
            hands=usual.hands,
            ball=usual.ball,
        )
        return analyse_reduced(reduced, conditions)


def _face(analysis: Analysis[Implement]) -> FaceMapPicture | None:
    if not _has_face(analysis.bat):
        return None
    hits = face_map(analysis.reduced, analysis.conditions, columns=ALONG, rows=ACROSS)
    return FaceMapPicture(
        np.round(hits.position, 5),
        np.round(hits.lateral, 5),
        np.round(hits.collision_efficiency, 4),
        np.round(hits.exit_speed, 3),
        np.round(hits.sting, 4),
        *hits.best(),
    )


def _has_face(tool: Implement) -> bool:
    return tool.outline is not None and tool.face is not None


def _hit(state: SportsState, analysis: Analysis[Implement]) -> SportsHit:
    tool, conditions = analysis.bat, analysis.conditions
    start, end = float(analysis.scan.position[0]), float(analysis.scan.position[-1])
    wanted = analysis.sweet_spots.max_exit_speed
    if state.met_from_tip_in is not None:
        wanted = tool.length - state.met_from_tip_in * INCH
    place = min(end, max(start, wanted))
    aside = state.aside_in * INCH
    if aside and (tool.outline is None or not bool(tool.outline.holds(np.array(place), np.array(aside)))):
        raise FieldError("aside_in", f"{tool.name} has no face there; move the ball nearer to its line")
    bat_speed = conditions.swing.speed_at(place)
    closing = conditions.pitch.speed + bat_speed
    hit = hits_with_motion(analysis.modes, ball=conditions.ball, position=place, lateral=aside, closing_speed=closing)
    where = {"position": place, "lateral": aside, "closing_speed": closing}
    numbers = numbers_in_batch(hit, **where)
    perhaps = bool(hit.touches[0] > 1)
    again = touched_again_at(perhaps, words_of(tool.sport), modes=analysis.modes, ball=conditions.ball, **where)
    felt = sting(analysis.modes, hands=conditions.hands, displacement=hit.displacement, velocity=hit.velocity)
    efficiency = float(numbers.collision_efficiency)
    return SportsHit(
        **vars(numbers),
        touched_again=in_both_systems(again),
        bat_speed=bat_speed,
        exit_speed=exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed),
        sting=float(felt[0]),
    )


def file(state: SportsState) -> OneFile:
    """Return a file of HTML that computes the hits of an implement itself; they are on its line."""
    analysis = _played(state)
    bat = analysis.bat
    offline = OfflineBat(analysis.reduced, analysis.conditions, sources_of(bat, analysis.conditions))
    from_tip = None if state.met_from_tip_in is None else state.met_from_tip_in * INCH
    return OneFile.of(bat.name, offline_file(offline, from_tip=from_tip))


def recipe(state: SportsState) -> dict[str, str]:
    """Return command line and Python lines that give the same numbers, and the file they read, if there is one."""
    things = (state.implement if state.implement_toml is None else FILE,)
    coming = "tee" if state.incoming_mph == 0 else number(state.incoming_mph, "mph")
    options = options_of(state, bat_speed="swing_mph") | {"pitch_speed": coming}
    asks = [Ask("report", things, options)]
    if state.met_from_tip_in is not None and not state.aside_in:  # the command meets the ball on the middle line
        asks.append(Ask("hit", things, {"at": f"{state.met_from_tip_in:.12g}in-from-tip", **options}))
    return lines_of(*asks) | ({} if state.implement_toml is None else {FILE: state.implement_toml})


VIEW = View(
    "sports", "Every sport", SportsState, answer, recipe, asides={"face": face, "sentences": sentences, "file": file}
)
