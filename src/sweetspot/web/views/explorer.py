"""Explorer: one bat, one swing, everything along the bat, and the hit where the ball is."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import numpy as np

from sweetspot.analysis.bat_analysis import check_conditions
from sweetspot.analysis.position_scan import scan
from sweetspot.analysis.sweet_spot import sweet_spots
from sweetspot.collision.closed_form import bbcor, exit_speed
from sweetspot.collision.hit_in_space import Contact, Strikes, strikes
from sweetspot.collision.impact import Impacts, Outcome
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.report.hit.json import conditions_json
from sweetspot.units import INCH
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.drawings import ball_picture, bat_picture
from sweetspot.web.errors import FieldError
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, swing_options
from sweetspot.web.states import HitState
from sweetspot.web.view import View


class ExplorerState(HitState):
    """The explorer's controls: the bat, the swing, the ball, and where they meet."""


def answer(state: ExplorerState) -> dict[str, Any]:
    """Return bat, sweet spots, curves along the bat and the hit at the chosen place."""
    found = reduced(state, ball_of(state))
    conditions = conditions_of(state, found.bat)
    check_conditions(found.bat, conditions, body=found.body)
    along = scan(found.bat, body=found.body, modes=found.modes, conditions=conditions)
    spots = sweet_spots(along, body=found.body, modes=found.modes, conditions=conditions)
    best = float(np.nanmax(along.exit_speed))
    hit = _hit(state, found, conditions)
    return {
        "bat": bat_picture(state, found),
        "hands_m": conditions.hands.places,
        "sweet_spots": {
            **{f"{name}_m": place for name, place in asdict(spots).items() if name != "zone"},
            "zone_m": spots.zone,
        },
        "scan": {
            "position_m": along.position,
            "exit_speed_m_s": along.exit_speed,
            "rigid_exit_speed_m_s": along.rigid_exit_speed,
            "collision_efficiency": along.collision_efficiency,
            "bbcor": along.bbcor,
            "hand_impulse_n_s": along.hand_impulse,
            "sting": along.sting,
        },
        "hit": hit,
        "best_exit_speed_m_s": best,
        "lost_m_s": None if hit["exit_speed_m_s"] is None else best - hit["exit_speed_m_s"],
        "ball": ball_picture(state, conditions.ball),
        "conditions": conditions_json(conditions),
    }


def recipe(state: ExplorerState) -> dict[str, str]:
    """Return the lines that give the curves and, for a ball met in the middle, the hit."""
    bat, options = bat_name(state), swing_options(state)
    command = f"sweetspot report {bat}{options}"
    python = (
        conditions_lines(state) + "result = analyse(bat, conditions)\nresult.scan.exit_speed  # m/s along the bat\n"
    )
    if state.offset_in == 0:
        command += f"\nsweetspot hit {bat} --at {state.impact_from_tip_in:.12g}in-from-tip{options}"
        python += (
            f"impact = hit_at(bat.length - {state.impact_from_tip_in!r} * INCH, modes=result.modes, "
            "conditions=conditions)\n"
        )
    return {"command": command, "python": python, "toml": bat_text(state)}


def _hit(state: ExplorerState, found: ReducedBat, conditions: Conditions) -> dict[str, Any]:
    """Return the collision at the chosen place; off the bat's axis by a level swing at a ball that comes level."""
    place = found.bat.length - state.impact_from_tip_in * INCH
    if place < conditions.hands.position:
        most = (found.bat.length - conditions.hands.position) / INCH
        raise FieldError(
            "impact_from_tip_in", f"the ball would meet the hands; allowed is up to {most:.1f} in from the tip"
        )
    met, leaving = _met(state, found, conditions, place)
    outcome = Outcome(int(met.outcome[0]))
    speed, angle, backspin = leaving if outcome is Outcome.SEPARATED else (None, None, None)
    efficiency = float(met.collision_efficiency[0])
    return {
        "position_m": place,
        "outcome": outcome.name.lower(),
        "outcome_text": outcome.sentence,
        "bat_speed_m_s": conditions.swing.speed_at(place),
        "exit_speed_m_s": speed,
        "launch_angle_rad": angle,
        "backspin_rad_s": backspin,
        "collision_efficiency": efficiency,
        "bbcor": bbcor(efficiency, body=found.body, ball=conditions.ball, position=place),
        "contact_time_s": met.contact_time[0],
        "peak_force_n": met.peak_force[0],
        "peak_compression_m": met.peak_compression[0],
    }


def _met(
    state: ExplorerState, found: ReducedBat, conditions: Conditions, place: float
) -> tuple[Impacts | Strikes, tuple[float, float, float]]:
    """Return the collision, and how the ball leaves: speed, launch angle and backspin.

    Head-on the part along the line of centres is all there is, and is found three times as fast alone.
    """
    ball, coming, bat_speed = conditions.ball, conditions.pitch.speed, conditions.swing.speed_at(place)
    if state.offset_in == 0:
        done = hits(found.modes, ball=ball, position=place, closing_speed=coming + bat_speed)
        leaving = exit_speed(float(done.collision_efficiency[0]), ball_speed=coming, bat_speed=bat_speed)
        return done, (leaving, 0.0, 0.0)
    struck = strikes(
        found,
        ball=ball,
        swings=Swings(bat_speed, SwingPath().axes, conditions.swing.pivot),
        pitches=BallMotions(velocity=(0.0, -coming, 0.0), spin=(0.0, 0.0, 0.0)),
        contact=Contact(place, state.offset_in * INCH),
    )
    if int(struck.outcome[0]) != Outcome.SEPARATED:
        return struck, (math.nan, math.nan, math.nan)
    launched = BallMotion(np.zeros(3), struck.velocity[0], struck.spin[0])
    return struck, (launched.speed, launched.launch_angle, launched.backspin)


VIEW = View("explorer", "Explorer", ExplorerState, answer, recipe)
