"""Explorer: one bat, one swing, everything along the bat, the hit where the ball is, and why it is what it is."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import numpy as np

from sweetspot.analysis.bat_analysis import analyse_reduced
from sweetspot.answers.conditions import hit_conditions
from sweetspot.answers.records import to_dict
from sweetspot.answers.report import report_of
from sweetspot.collision.closed_form import bbcor, exit_speed
from sweetspot.collision.impact import Impacts, Outcome
from sweetspot.collision.kernel import hits
from sweetspot.numerics.interval import Interval, values_of
from sweetspot.report.bat.place_words import speed_difference, why_backwards, why_here, why_off_axis
from sweetspot.report.bat.words import answer_words
from sweetspot.report.hit.second_touch import touched_again_at
from sweetspot.report.sport_words import words_of
from sweetspot.units import INCH
from sweetspot.web.documents import in_both_systems, told
from sweetspot.web.drawings import ball_picture, bat_picture
from sweetspot.web.errors import FieldError
from sweetspot.web.publications import published
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, swing_options
from sweetspot.web.states import HitState
from sweetspot.web.view import View
from sweetspot.web.views.explorer_curves import (
    Met,
    along,
    beside,
    curves,
    here,
    leaving,
    power_map,
    struck,
    touched_twice,
)


class ExplorerState(HitState):
    """The explorer's controls: the bat, the swing, the ball, and where they meet."""


def answer(state: ExplorerState) -> dict[str, Any]:
    """Return bat, sweet spots, curves along the bat, where the energy goes, the hit at the chosen place, and why."""
    met = along(state)
    conditions, spots, shown = met.conditions, met.spots, curves(state)
    hit = _hit(state, met)
    at_middle, exact = here(state, hit["position_m"])
    middle = hit["exit_speed_m_s"] if state.offset_in == 0 else at_middle
    fastest = float(np.nanmax(met.scan.exit_speed[beside(met.scan, spots.max_exit_speed)]))
    difference = speed_difference(met.scan, hit["position_m"], best=spots.max_exit_speed, exit_speed=middle)
    angle, words, lost = hit["launch_angle_rad"], words_of(met.reduced.bat), None
    if angle is not None and abs(angle) > math.pi / 2:
        why = [why_backwards(state.offset_in * INCH, words=words)]
    else:
        why = [
            why_here(
                difference, body=met.reduced.body, conditions=conditions, best=spots.max_exit_speed, words=words,
                in_the_middle=state.offset_in == 0,
            )
        ]  # fmt: skip
        lost = None if hit["exit_speed_m_s"] is None else fastest - hit["exit_speed_m_s"]
        if lost is not None and state.offset_in != 0:
            why.append(why_off_axis(state.offset_in * INCH, -lost - difference.whole, words=words))
    return {
        "bat": bat_picture(state, met.reduced),
        "hands_m": conditions.hands.places,
        "sweet_spots": {
            **{f"{name}_m": place for name, place in asdict(spots).items() if name != "zone"},
            "zone_m": spots.zone,
        },
        "scan": shown["curves"],
        "energy_shares": shown["energy"],
        "touched_again": shown["touched_again"],
        "best_in_doubt": in_both_systems(met.doubts),
        "hit": hit | exact,
        "why": in_both_systems(why),
        "difference_m_s": {name: getattr(difference, name) for name in ("motion", "giving", "keeping", "whole")},
        "best_exit_speed_m_s": fastest,
        "lost_m_s": lost,
        "ball": ball_picture(state, conditions.ball),
        "published": published(state),
        "conditions": to_dict(hit_conditions(conditions)),
    }


def why(state: ExplorerState) -> dict[str, Any]:
    """Return what the report says of this bat and swing, and what misses cost by two laws of the ball."""
    met = along(state)
    report = report_of(analyse_reduced(met.reduced, met.conditions))
    best, top = float(report.sweet_spots.max_exit_speed), float(np.nanmax(values_of(report.scan.exit_speed)))
    sides = [
        (best + way * float(one.distance), loss)
        for one in report.misses
        for way, loss in ((-1, one.inside), (1, one.outside))
        if isinstance(loss, Interval)
    ]
    points = [
        {"position_m": place, "low_m_s": top - loss.high, "high_m_s": top - loss.low}
        for place, loss in sorted(sides, key=lambda side: side[0])
    ]
    return {"sentences": in_both_systems(answer_words(report)), "other_law": points}


def sure(state: ExplorerState) -> dict[str, Any]:
    """Return the report with an interval beside each number, and what they come from; speeds are taken as they are."""
    from sweetspot.report.bat.document import report_document
    from sweetspot.web.how_sure import PAGE_DRAWS, sources_for

    met = along(state)
    analysis = analyse_reduced(met.reduced, met.conditions)
    sources = sources_for(state, met.reduced.bat, analysis.conditions)
    return told(report_document(report_of(analysis, sources, drawn=True, draws=PAGE_DRAWS)))


def recipe(state: ExplorerState) -> dict[str, str]:
    """Return the lines that give the hit, and the curves of a ball met in the middle."""
    bat, options = bat_name(state), swing_options(state)
    command, place = f"sweetspot report {bat}{options}", f"--at {state.impact_from_tip_in:.12g}in-from-tip"
    python = (
        conditions_lines(state) + "result = analyse(bat, conditions)\nresult.scan.exit_speed  # m/s along the bat\n"
    )
    if state.offset_in == 0:
        command += f"\nsweetspot hit {bat} {place}{options}"
        python += (
            f"impact = hit_at(bat.length - {state.impact_from_tip_in!r} * INCH, modes=result.modes, "
            "conditions=conditions)\n"
        )
    else:
        told = "# all along the bat, of a ball met in the middle:\n"
        off = f"# of the ball met {abs(state.offset_in):.12g} in off the bat's axis:\n"
        level = "--attack-angle 0deg --tilt 0deg --approach-angle 0deg --pitch-backspin 0rpm"
        command = (
            f"{told}{command}\n{off}sweetspot play {bat} {place} --offset={state.offset_in:.12g}in {level}{options}"
        )
        python = f"{told}{python}{off}" + (
            "from sweetspot import BallMotion, Contact, SwingPath, strike\n"
            "from sweetspot.dynamics.reduction import reduced_bat\n\n"
            f"met = Contact(bat.length - {state.impact_from_tip_in!r} * INCH, {state.offset_in!r} * INCH)\n"
            "level = BallMotion(position=(0.0, 0.0, 0.0), velocity=(0.0, -conditions.pitch.speed, 0.0),\n"
            "                   spin=(0.0, 0.0, 0.0))\n"
            "struck = strike(reduced_bat(bat, ball=conditions.ball), ball=conditions.ball,\n"
            "                swing=conditions.swing, path=SwingPath(), pitch=level, contact=met)\n"
            "struck.launched  # m/s and rad\n"
        )
    return {"command": command, "python": python, "toml": bat_text(state)}


def _hit(state: ExplorerState, met: Met) -> dict[str, Any]:
    """Return the collision at the chosen place; off the bat's axis by a level swing at a ball that comes level."""
    bat, conditions = met.reduced.bat, met.conditions
    place = bat.length - state.impact_from_tip_in * INCH
    if place < conditions.hands.position:
        most = (bat.length - conditions.hands.position) / INCH
        raise FieldError(
            "impact_from_tip_in", f"the ball would meet the hands; allowed is up to {most:.1f} in from the tip"
        )
    done, (speed, angle, backspin) = _met(state, met, place)
    outcome = Outcome(int(done.outcome[0]))
    apart = outcome is Outcome.SEPARATED
    efficiency, bat_speed = float(done.collision_efficiency[0]), conditions.swing.speed_at(place)
    closing = conditions.pitch.speed + bat_speed if isinstance(done, Impacts) else float(done.closing_speed[0])
    again = touched_again_at(
        float(done.touches[0]) > 1 or touched_twice(met.scan, place, within=INCH), words_of(bat),
        modes=met.reduced.modes, ball=conditions.ball, position=place, closing_speed=closing,
    )  # fmt: skip
    return {
        "position_m": place,
        "outcome": outcome.name.lower(),
        "outcome_text": outcome.sentence,
        "touched_again": in_both_systems(again),
        "bat_speed_m_s": bat_speed,
        "exit_speed_m_s": speed if apart else None,
        "launch_angle_rad": angle if apart else None,
        "backspin_rad_s": backspin if apart else None,
        "collision_efficiency": efficiency,
        "bbcor": bbcor(efficiency, body=met.reduced.body, ball=conditions.ball, position=place),
        "contact_time_s": done.contact_time[0],
        "peak_force_n": done.peak_force[0],
        "peak_compression_m": done.peak_compression[0],
    }


def _met(state: ExplorerState, met: Met, place: float) -> tuple[Any, tuple[float, float, float]]:
    """Return the collision, and how the ball leaves: speed, launch angle and backspin.

    Head-on the part along the line of centres is all there is, and is found three times as fast alone.
    """
    coming, bat_speed = met.conditions.pitch.speed, met.conditions.swing.speed_at(place)
    if state.offset_in == 0:
        done: Impacts = hits(
            met.reduced.modes, ball=met.conditions.ball, position=place, closing_speed=coming + bat_speed
        )
        speed = exit_speed(float(done.collision_efficiency[0]), ball_speed=coming, bat_speed=bat_speed)
        return done, (speed, 0.0, 0.0)
    off = struck(met, position=[place], offset=state.offset_in * INCH)
    speeds, angles, spins = leaving(off)
    return off, (float(speeds[0]), float(angles[0]), float(spins[0]))


VIEW = View("explorer", "Explorer", ExplorerState, answer, recipe, asides={"map": power_map, "why": why, "sure": sure})
