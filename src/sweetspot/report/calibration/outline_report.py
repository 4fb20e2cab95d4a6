"""A measured outline in words and as JSON."""

from __future__ import annotations

from typing import Any

from sweetspot.calibration.outline import Outline
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.sentences import Sentence, Slot, joined, say


def outline_json(outline: Outline, body: RigidBody) -> dict[str, Any]:
    """Return stations, those that were assumed, and what the bat would weigh at the catalogue's density; SI."""
    positions, diameters = zip(*outline.profile, strict=True)
    return cleaned(
        {
            "profile": {"position_m": positions, "diameter_m": diameters},
            "assumed_position_m": outline.assumed,
            "mass_kg": body.mass,
            "balance_point_m": body.balance_point,
        }
    )


def outline_words(outline: Outline, bat: Bat, body: RigidBody) -> Sentence:
    """Return in words how thick the bat is and what it would weigh."""
    beyond_knob = [size for place, size in outline.profile if place > 0.15 * bat.length]
    words = [
        say(
            "{count} stations: handle {thin}, barrel {thick}, length {length}.", count=len(outline.profile),
            thin=Slot(min(beyond_knob), "length"), thick=Slot(max(beyond_knob), "length"),
            length=Slot(bat.length, "length"),
        ),
        say(
            "In {wood} of the catalogue's density it would weigh {mass} and balance {balance} from the knob.",
            wood=bat.material.name, mass=Slot(body.mass, "mass"), balance=Slot(body.balance_point, "length"),
        ),
    ]  # fmt: skip
    if outline.assumed:
        words.append(say("{count} stations at the ends were not measured but assumed.", count=len(outline.assumed)))
    return joined(words)
