"""A bat and its report as JSON for other programs: SI, the unit in every key, positions from the knob end."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.face_maps import FaceMap, face_map
from sweetspot.answers.hit import hit_of
from sweetspot.answers.records import to_dict
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.report.hit.json import conditions_json
from sweetspot.report.json_shapes import cleaned

WRITTEN_MODES = ("bending", "hoop", "face")
"""Families whose modes are in the data; rigid motions and the hands' own are not."""


def report_json(analysis: Analysis[Implement]) -> dict[str, Any]:
    """Return everything `sweetspot report` knows, with the keys of the border contract."""
    spots, along = analysis.sweet_spots, analysis.scan
    return cleaned(
        {
            "bat": {
                **bat_json(analysis.bat.name, analysis.bat.length, analysis.body),
                "moi_6in_doubt_kg_m2": moi_doubt(analysis.bat, analysis.body, STANDARD_AXIS),
            },
            "modes": modes_json(analysis.modes),
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
            "best_hit": to_dict(hit_of(analysis.best, body=analysis.body, conditions=analysis.conditions)),
            "grip_effect": analysis.grip_effect,
            "conditions": conditions_json(analysis.conditions),
            **({} if analysis.bat.face is None else _face_json(analysis)),
        }
    )


def _face_json(analysis: Analysis[Implement]) -> dict[str, Any]:
    """Return what only an implement with a face has: its sport, how that weighs a swing, and the map."""
    convention = swing_weight(analysis.bat.sport)
    return {
        "sport": analysis.bat.sport,
        "swing_weight": {"name": convention.name, "text": convention.shown(analysis.body)},
        "face_map": face_map_json(face_map(analysis.reduced, analysis.conditions)),
    }


def face_map_json(hits: FaceMap) -> dict[str, Any]:
    """Return hits all over a face as lists of rows across it; None off the face."""
    return cleaned(
        {
            "position_m": hits.position,
            "lateral_m": hits.lateral,
            "collision_efficiency": hits.collision_efficiency,
            "exit_speed_m_s": hits.exit_speed,
            "sting": hits.sting,
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


def modes_json(modes: Modes) -> list[dict[str, Any]]:
    """Return the bat's vibrating modes; rigid motions and the hands' own are left out."""
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
        if modes.families[index] in WRITTEN_MODES
    ]
