"""sweetspot: the open laboratory of the ball-bat collision.

Describe a real bat, find where it hits best and why. Names here load their module when first used, so that
``import sweetspot`` stays fast::

    from sweetspot import analyse, catalog, standard_conditions

    bat = catalog.bat("r161-ash")
    result = analyse(bat, standard_conditions(bat))
    result.sweet_spots.max_exit_speed  # m from the knob end
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from sweetspot import catalog
    from sweetspot.air import Air, Wind
    from sweetspot.analysis import Analysis, analyse, exit_speed_of, hit_at
    from sweetspot.ball import Ball, RestitutionLaw
    from sweetspot.bat import Bat
    from sweetspot.collision.coupled import hit
    from sweetspot.collision.kernel import hits
    from sweetspot.collision.strike import strike, strikes
    from sweetspot.errors import InputError, SweetspotError
    from sweetspot.flight.everywhere import landings_everywhere
    from sweetspot.flight.kernel import flights
    from sweetspot.flight.trajectory import fly
    from sweetspot.line import Line, reduce
    from sweetspot.material import Material
    from sweetspot.motion import BallMotion, launched
    from sweetspot.paper_rows import paper_rows
    from sweetspot.play import plays
    from sweetspot.reduction import Reduction
    from sweetspot.rigid import RigidBody, centre_of_percussion, effective_mass, rigid_body
    from sweetspot.standard import standard_conditions
    from sweetspot.swing import Conditions, Hands, Pitch, Swing
    from sweetspot.swing_path import SwingPath
    from sweetspot.vibration.beam import bending_modes
    from sweetspot.vibration.hands import gripped
    from sweetspot.vibration.hoop import hoop_modes
    from sweetspot.vibration.whole import modes_of

_HOMES = {
    "catalog": "catalog",
    "Bat": "bat",
    "Material": "material",
    "Ball": "ball",
    "RestitutionLaw": "ball",
    "Pitch": "swing",
    "Swing": "swing",
    "Hands": "swing",
    "Conditions": "swing",
    "standard_conditions": "standard",
    "Line": "line",
    "reduce": "line",
    "RigidBody": "rigid",
    "rigid_body": "rigid",
    "centre_of_percussion": "rigid",
    "effective_mass": "rigid",
    "bending_modes": "vibration.beam",
    "hoop_modes": "vibration.hoop",
    "modes_of": "vibration.whole",
    "gripped": "vibration.hands",
    "hit": "collision.coupled",
    "hits": "collision.kernel",
    "Analysis": "analysis",
    "analyse": "analysis",
    "hit_at": "analysis",
    "exit_speed_of": "analysis",
    "BallMotion": "motion",
    "launched": "motion",
    "SwingPath": "swing_path",
    "Reduction": "reduction",
    "strike": "collision.strike",
    "strikes": "collision.strike",
    "plays": "play",
    "Air": "air",
    "Wind": "air",
    "fly": "flight.trajectory",
    "flights": "flight.kernel",
    "landings_everywhere": "flight.everywhere",
    "paper_rows": "paper_rows",
    "InputError": "errors",
    "SweetspotError": "errors",
}
"""Public name: the module below the package where it lives, in the order of the story."""

__all__ = [
    "Air",
    "Analysis",
    "Ball",
    "BallMotion",
    "Bat",
    "Conditions",
    "Hands",
    "InputError",
    "Line",
    "Material",
    "Pitch",
    "Reduction",
    "RestitutionLaw",
    "RigidBody",
    "SweetspotError",
    "Swing",
    "SwingPath",
    "Wind",
    "analyse",
    "bending_modes",
    "catalog",
    "centre_of_percussion",
    "effective_mass",
    "exit_speed_of",
    "flights",
    "fly",
    "gripped",
    "hit",
    "hit_at",
    "hits",
    "hoop_modes",
    "landings_everywhere",
    "launched",
    "modes_of",
    "paper_rows",
    "plays",
    "reduce",
    "rigid_body",
    "standard_conditions",
    "strike",
    "strikes",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'sweetspot' has no attribute {name!r}")
    module = import_module(f"sweetspot.{_HOMES[name]}")
    value = module if name == _HOMES[name] == "catalog" else getattr(module, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
