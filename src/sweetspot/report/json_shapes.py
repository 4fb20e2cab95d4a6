"""Results as JSON for other programs: SI, the unit in every key, positions from the knob end."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.face_maps import FaceMap, face_map
from sweetspot.analysis.strain import Damage
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.paper.formulas import Row


def report_json(analysis: Analysis[Implement]) -> dict[str, Any]:
    """Return everything `sweetspot report` knows, with the keys of the border contract."""
    spots, along = analysis.sweet_spots, analysis.scan
    return cleaned(
        {
            "bat": {
                **bat_json(analysis.bat.name, analysis.bat.length, analysis.body),
                "moi_6in_doubt_kg_m2": moi_doubt(analysis.bat, analysis.body, STANDARD_AXIS),
            },
            "modes": modes_json(analysis),
            "sweet_spots": {
                **{f"{name}_m": value for name, value in asdict(spots).items() if name != "zone"},
                "zone_m": spots.zone,
            },
            "scan": {
                "position_m": along.position,
                "collision_efficiency": along.collision_efficiency,
                "bbcor": along.bbcor,
                "bat_speed_m_s": along.bat_speed,
                "exit_speed_m_s": along.exit_speed,
                "rigid_exit_speed_m_s": along.rigid_exit_speed,
                "hand_impulse_n_s": along.hand_impulse,
                "sting": along.sting,
            },
            "best_hit": hit_json(analysis.best, body=analysis.body, conditions=analysis.conditions),
            "grip_effect": analysis.grip_effect,
            "conditions": conditions_json(analysis.conditions),
            **({} if analysis.bat.face is None else _of_face(analysis)),
        }
    )


def _of_face(analysis: Analysis[Implement]) -> dict[str, Any]:
    """Return what only an implement with a face has: its sport, how that weighs a swing, and the map."""
    convention = swing_weight(analysis.bat.sport)
    told = {"name": convention.name, "text": convention.shown(analysis.body)}
    found = face_map(analysis.reduced, analysis.conditions)
    return {"sport": analysis.bat.sport, "swing_weight": told, "face_map": face_map_json(found)}


def face_map_json(found: FaceMap) -> dict[str, Any]:
    """Return hits all over a face as lists of rows across it; None off the face."""
    return cleaned(
        {
            "position_m": found.position,
            "lateral_m": found.lateral,
            "collision_efficiency": found.collision_efficiency,
            "exit_speed_m_s": found.exit_speed,
            "sting": found.sting,
        }
    )


def bat_json(name: str, length: float, body: RigidBody) -> dict[str, Any]:
    """Return a bat's name and mass properties."""
    return {
        "name": name,
        "length_m": length,
        "mass_kg": body.mass,
        "balance_point_m": body.balance_point,
        "moi_cm_kg_m2": body.moi_cm,
        "moi_knob_kg_m2": body.moi(0.0),
        "moi_6in_kg_m2": body.moi(STANDARD_AXIS),
        "roll_moi_kg_m2": body.roll_moi,
    }


def modes_json(analysis: Analysis[Implement]) -> list[dict[str, Any]]:
    """Return the bat's vibrating modes; rigid motions and the hands' own are left out."""
    modes = analysis.modes
    ratio = modes.damping_ratio
    return [
        {
            "family": modes.families[index],
            "harmonic": modes.harmonics[index],
            "frequency_hz": float(modes.frequency[index]),
            "damping_ratio": float(ratio[index]),
            "nodes_m": modes.nodes(index).tolist(),
        }
        for index in range(len(modes))
        if modes.families[index] in ("bending", "hoop", "face")
    ]


def hit_json(impact: Impact, *, body: RigidBody, conditions: Conditions) -> dict[str, Any]:
    """Return one collision."""
    return cleaned(
        {
            "position_m": impact.position,
            "lateral_m": impact.lateral,
            "collision_efficiency": impact.collision_efficiency,
            "closing_speed_m_s": impact.closing_speed,
            "bat_speed_m_s": conditions.swing.speed_at(impact.position),
            "exit_speed_m_s": exit_speed_of(impact, conditions),
            "bbcor": bbcor(impact.collision_efficiency, body=body, ball=conditions.ball, position=impact.position),
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


def damage_json(found: Damage) -> dict[str, Any]:
    """Return the strains of one hit; strains are ratios."""
    return cleaned(
        {
            "handle_strain": found.handle_strain,
            "handle_position_m": found.handle_position,
            "handle_strain_limit": found.strain_limit,
            "wall_strain": found.wall_strain,
            "wall_strain_limit": found.wall_limit,
            "warnings": list(found.warnings),
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


def paper_json(rows: list[Row]) -> dict[str, Any]:
    """Return the paper's chain."""
    return cleaned({"rows": [asdict(row) for row in rows]})


def as_columns(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    """Return rows with equal keys as columns; no columns where there are no rows."""
    return {name: [row[name] for row in rows] for name in rows[0]} if rows else {}


def cleaned(table: dict[str, Any]) -> dict[str, Any]:
    """Return a table with arrays as lists and every number that is not finite as None, as JSON has neither."""
    return {key: _clean(item) for key, item in table.items()}


def _clean(value: Any) -> Any:
    if isinstance(value, dict):
        return cleaned(value)
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiu" and np.isfinite(value).all():
        return value.tolist()
    if isinstance(value, np.ndarray | list | tuple):
        return [_clean(item) for item in value]
    if isinstance(value, np.floating | float):
        return float(value) if math.isfinite(value) else None
    return value
