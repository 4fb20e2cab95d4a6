"""A hit as JSON: SI, the unit in every key, positions from the knob end."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.analysis.strain import Damage
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.motion.swing import Conditions
from sweetspot.report.json_shapes import cleaned


def hit_json(impact: Impact, *, body: RigidBody, conditions: Conditions) -> dict[str, Any]:
    """Return one collision under its conditions."""
    return impact_json(impact) | cleaned(
        {
            "bat_speed_m_s": conditions.swing.speed_at(impact.position),
            "exit_speed_m_s": exit_speed_of(impact, conditions),
            "bbcor": bbcor(impact.collision_efficiency, body=body, ball=conditions.ball, position=impact.position),
        }
    )


def impact_json(impact: Impact) -> dict[str, Any]:
    """Return one collision as the bat at rest sees it."""
    again = {} if impact.unrecovered is None else {"unrecovered_gain_m_s": impact.unrecovered_gain}
    return again | cleaned(
        {
            "position_m": impact.position,
            "lateral_m": impact.lateral,
            "collision_efficiency": impact.collision_efficiency,
            "closing_speed_m_s": impact.closing_speed,
            "contact_time_s": impact.contact_time,
            "release_time_s": impact.release_time,
            "peak_force_n": impact.peak_force,
            "peak_compression_m": impact.peak_compression,
            "energy_j": asdict(impact.energy),
            "energy_imbalance": impact.energy.imbalance,
            "outcome": impact.outcome.name.lower(),
            "outcome_text": impact.outcome.sentence,
            "history": {
                "time_s": impact.times,
                "force_n": impact.force,
                "compression_m": impact.compression,
            },
        }
    )


def damage_json(damage: Damage) -> dict[str, Any]:
    """Return the strains of one hit; strains are ratios."""
    return cleaned(
        {
            "handle_strain": damage.handle_strain,
            "handle_position_m": damage.handle_position,
            "handle_strain_limit": damage.strain_limit,
            "wall_strain": damage.wall_strain,
            "wall_strain_limit": damage.wall_limit,
            "warnings": list(damage.warnings),
        }
    )


def conditions_json(conditions: Conditions) -> dict[str, Any]:
    """Return what the hit was computed under."""
    swing, hands, ball = conditions.swing, conditions.hands, conditions.ball
    return {
        "pitch_speed_m_s": conditions.pitch.speed,
        "bat_speed_m_s": swing.bat_speed,
        "bat_speed_at_m": swing.measured_at,
        "pivot_m": swing.pivot,
        "hands_m": hands.position,
        "ball": ball.name,
        "ball_mass_kg": ball.mass,
        "ball_restitution": ball.restitution.reference,
        "ball_restitution_speed_m_s": ball.restitution.reference_speed,
        "ball_restitution_slope_s_m": ball.restitution.slope,
    }
