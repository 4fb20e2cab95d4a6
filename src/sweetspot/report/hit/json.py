"""What a hit was computed under as JSON: SI, the unit in every key, positions from the knob end."""

from __future__ import annotations

from typing import Any

from sweetspot.motion.swing import Conditions


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
