"""Every sport: a racket, bat, club or stick at its own stroke, hit anywhere on its face."""

from __future__ import annotations

from dataclasses import asdict, replace
from functools import lru_cache
from shlex import quote
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced
from sweetspot.analysis.face_maps import face_map
from sweetspot.analysis.position_scan import sting
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.answers.report import report_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.impact import Outcome
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions, Pitch
from sweetspot.report.bat.words import answer_words
from sweetspot.report.hit.second_touch import touched_again_at, touched_again_between
from sweetspot.report.sport_words import words_of
from sweetspot.units import INCH, MPH
from sweetspot.web.bats import implement_of
from sweetspot.web.documents import in_both_systems
from sweetspot.web.errors import FieldError, about
from sweetspot.web.states import Name, Toml, ViewState, within
from sweetspot.web.view import View

ALONG, ACROSS = 48, 30
FILE = "mine.toml"


class SportsState(ViewState):
    """What one hits with, how fast, and where the ball meets it; empty: as is usual in its sport."""

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
    met_from_tip_in: Annotated[float, Field(ge=0, le=52)] | None = Field(None, description="where the ball meets it")
    aside_in: float = Field(0.0, ge=-6, le=6, description="across the face, from its line")


def answer(state: SportsState) -> dict[str, Any]:
    """Return the implement's sweet spots, curves along it, and the hit at the chosen place."""
    analysis = _played(state)
    tool, conditions, spots = analysis.bat, analysis.conditions, analysis.sweet_spots
    sport = catalog.sport(tool.sport)
    along = analysis.scan
    curves = {
        "position_m": along.position, "exit_speed_m_s": along.exit_speed,
        "rigid_exit_speed_m_s": along.rigid_exit_speed, "collision_efficiency": along.collision_efficiency,
        "sting_m_s": along.sting,
    }  # fmt: skip
    return {
        "implement": state.implement,
        "has_face": _has_face(tool),
        "sport": sport.name,
        "words": words_of(tool).model_dump(),
        "tool": {**to_dict(mass_properties(tool, analysis.body)), "made_of": tool.made_of},
        "ball": {"name": conditions.ball.name, "radius_m": conditions.ball.radius},
        "swing_mph": conditions.swing.bat_speed / MPH,
        "incoming_mph": conditions.pitch.speed / MPH,
        "sweet_spots": {
            **{f"{name}_m": place for name, place in asdict(spots).items() if name != "zone"},
            "zone_m": spots.zone,
        },
        "scan": {name: np.round(values, 6) for name, values in curves.items()},
        "hit": _hit(state, analysis),
        "touched_again": in_both_systems(
            touched_again_between(tool.length - along.position, along.touches, words_of(tool))
        ),
    }


def sentences(state: SportsState) -> dict[str, Any]:
    """Return where it hits best and why, in either system of units."""
    report = replace(report_of(_played(state)), misses=())  # they stand in the picture
    return {"sentences": in_both_systems(answer_words(report))}


def face(state: SportsState) -> dict[str, Any]:
    """Return what a hit gives at every place of the face; nothing where an implement has none."""
    return {"face": _face(_played(state))}


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
            hands=usual.hands, ball=usual.ball,
        )  # fmt: skip
        return analyse_reduced(reduced, conditions)


def _face(analysis: Analysis[Implement]) -> dict[str, Any] | None:
    if not _has_face(analysis.bat):
        return None
    hits = face_map(analysis.reduced, analysis.conditions, columns=ALONG, rows=ACROSS)
    place, across = hits.best()
    return {
        "position_m": np.round(hits.position, 5),
        "lateral_m": np.round(hits.lateral, 5),
        "exit_speed_m_s": np.round(hits.exit_speed, 3),
        "collision_efficiency": np.round(hits.collision_efficiency, 4),
        "sting_m_s": np.round(hits.sting, 4),
        "best_m": place,
        "best_lateral_m": across,
    }


def _has_face(tool: Implement) -> bool:
    return tool.outline is not None and tool.face is not None


def _hit(state: SportsState, analysis: Analysis[Implement]) -> dict[str, Any]:
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
    done = hits_with_motion(
        analysis.modes, ball=conditions.ball, position=place, lateral=aside, closing_speed=closing
    )  # fmt: skip
    efficiency = float(done.collision_efficiency[0])
    again = touched_again_at(
        bool(done.touches[0] > 1), words_of(tool), modes=analysis.modes, ball=conditions.ball, position=place,
        closing_speed=closing, lateral=aside,
    )  # fmt: skip
    felt = sting(analysis.modes, hands=conditions.hands, displacement=done.displacement, velocity=done.velocity)
    return {
        "position_m": place,
        "lateral_m": aside,
        "outcome_text": Outcome(int(done.outcome[0])).sentence,
        "touched_again": in_both_systems(again),
        "tool_speed_m_s": bat_speed,
        "exit_speed_m_s": exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed),
        "collision_efficiency": efficiency,
        "contact_time_s": done.contact_time[0],
        "peak_force_n": done.peak_force[0],
        "sting_m_s": float(felt[0]),
    }


def recipe(state: SportsState) -> dict[str, str]:
    """Return command line and Python lines that give the same numbers, and the file they read, if there is one."""
    name, options, change = state.implement if state.implement_toml is None else FILE, "", ""
    if state.swing_mph is not None:
        options += f" --bat-speed {state.swing_mph:.12g}mph"
        change += f"swing=usual.swing.replaced(bat_speed={state.swing_mph!r} * MPH), "
    if state.incoming_mph is not None:
        options += " --pitch-speed " + ("tee" if state.incoming_mph == 0 else f"{state.incoming_mph:.12g}mph")
        change += f"pitch=Pitch(speed={state.incoming_mph!r} * MPH), "
    changed = f".replaced({change.rstrip(', ')})" if change else ""
    python = (
        "from sweetspot import Pitch, analyse, catalog\n"
        "from sweetspot.catalog.standard_hit import standard_conditions\nfrom sweetspot.units import MPH\n\n"
        f"tool = catalog.implement({name!r})\nusual = standard_conditions(tool)\n"
        f"conditions = usual{changed}\n"
        "result = analyse(tool, conditions)\nresult.scan.exit_speed  # m/s along it\n"
    )
    command = f"sweetspot report {quote(name)}{options}"
    if state.met_from_tip_in is not None and not state.aside_in:  # the command meets the ball on the middle line
        command += f"\nsweetspot hit {quote(name)} --at {state.met_from_tip_in:.12g}in-from-tip{options}"
    lines = {"command": command, "python": python}
    return lines if state.implement_toml is None else {**lines, FILE: state.implement_toml}


VIEW = View("sports", "Every sport", SportsState, answer, recipe, asides={"face": face, "sentences": sentences})
