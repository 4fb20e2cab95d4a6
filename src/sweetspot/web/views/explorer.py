"""Explorer: one bat, one swing, everything along the bat, and the hit where the ball is."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from sweetspot.analysis import Reduction, check_conditions
from sweetspot.collision.kernel import hits
from sweetspot.collision.momentum import bbcor, exit_speed
from sweetspot.report.border import bat_json, conditions_json
from sweetspot.scan import scan
from sweetspot.sweet_spots import sweet_spots
from sweetspot.swing import Conditions
from sweetspot.units import INCH
from sweetspot.vibration.modes import Modes
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.faults import FieldError
from sweetspot.web.outline import outline
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
    hit = _hit(state, found, conditions, found.modes)
    return {
        "bat": {**bat_json(found.bat.name, found.bat.length, found.body), **outline(found.bat)},
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
        "lost_m_s": best - hit["exit_speed_m_s"],
        "ball_radius_m": conditions.ball.radius,
        "conditions": conditions_json(conditions),
    }


def _hit(state: ExplorerState, found: Reduction, conditions: Conditions, modes: Modes) -> dict[str, Any]:
    """Return the collision at the chosen place, from the same compiled solution as the curves."""
    place = found.bat.length - state.impact_from_tip_in * INCH
    if place < conditions.hands.position:
        most = (found.bat.length - conditions.hands.position) / INCH
        raise FieldError(
            "impact_from_tip_in", f"the ball would meet the hands; allowed is up to {most:.1f} in from the tip"
        )
    bat_speed = conditions.swing.speed_at(place)
    closing = conditions.pitch.speed + bat_speed
    done = hits(modes, ball=conditions.ball, position=place, closing_speed=closing)
    efficiency = float(done.collision_efficiency[0])
    leaving = exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed)
    restitution = bbcor(efficiency, body=found.body, ball=conditions.ball, position=place)
    return {
        "position_m": place,
        "bat_speed_m_s": bat_speed,
        "exit_speed_m_s": leaving,
        "collision_efficiency": efficiency,
        "bbcor": restitution,
        "contact_time_s": float(done.contact_time[0]),
        "peak_force_n": float(done.peak_force[0]),
        "peak_compression_m": float(done.peak_compression[0]),
    }


VIEW = View("explorer", "Explorer", ExplorerState, answer)
