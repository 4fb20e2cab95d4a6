"""A bat and a ball as numbers for a drawing and for their controls."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot import catalog
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.report.swung_with import effort_words
from sweetspot.web.bat_bounds import bounds
from sweetspot.web.bats import changed_bat, conditions_of, swung, usual
from sweetspot.web.documents import in_both_systems
from sweetspot.web.one_system import in_one_system
from sweetspot.web.states import BatState, SwungState

POINTS = 120
"""Places along a bat whose outline is a formula."""


def bat_picture(state: BatState, reduced: ReducedBat) -> dict[str, Any]:
    """Return a state's bat: its facts, its outline, how far its controls may go, and what is usual in its sport."""
    return {
        **to_dict(mass_properties(reduced.bat, reduced.body)),
        "moi_6in_half_kg_m2": moi_half(reduced.bat, reduced.body),
        **outline(reduced.bat),
        "bounds": bounds(state, reduced.bat),
        "sport": reduced.bat.sport,
        "usual": usual(reduced.bat)._asdict(),
        "swung": _how_swung(state, reduced.bat) if isinstance(state, SwungState) else None,
    }


def _how_swung(state: SwungState, bat: Bat) -> dict[str, str] | None:
    """Return in a sentence how a changed bat is swung, in either system; None: nothing was changed of it."""
    changed = changed_bat(state)
    if changed is None:
        return None
    words = effort_words(changed, conditions_of(state, bat), same_speed=state.same == "speed")
    return {system: sentence for system, [sentence] in in_both_systems([words]).items()}


def moi_half(bat: Bat, body: RigidBody) -> float:
    """Return half the 90 % interval of a bat's swing weight in kg m^2; 0: it was measured."""
    return REACH * moi_doubt(bat, body, STANDARD_AXIS)


def ball_picture(state: SwungState, ball: Ball) -> dict[str, float]:
    """Return the ball's size, and what its controls stand at where nobody has moved them."""
    own = catalog.ball(swung(state).ball or "")
    return {
        "radius_m": ball.radius,
        "mass_kg": ball.mass,
        "cor": own.restitution.reference,
        "humidity": own.reference_humidity,
        "temperature_degf": own.reference_temperature * 1.8 + 32,
    }


def outline(bat: Bat) -> dict[str, Any]:
    """Return stations and what is inside, m from the knob end: what a drawing of the bat to scale needs."""
    edges = np.asarray(bat.breakpoints())
    places = edges if bat.profile is not None else np.union1d(edges, np.linspace(0, bat.length, POINTS))
    return {
        "outline": {"position_m": places, "diameter_m": bat.diameter_at(places)},
        "stations": [{"position_m": place, "diameter_m": width} for place, width in bat.profile or ()],
        "hollow": bat.shell is not None,
        "wall_m": None if bat.shell is None else bat.wall_at(places),
        "bores": [
            {
                "diameter_m": bore.diameter,
                "start_m": bat.length - bore.depth,
                "stop_m": bat.length - bore.plug,
                "fill": None if bore.fill is None else bore.fill.name,
            }
            for bore in bat.bores
        ],
        "cup": None if bat.cup is None else {"diameter_m": bat.cup.diameter, "depth_m": bat.cup.depth},
        "weights": [{"position_m": weight.position, "mass_kg": weight.mass} for weight in bat.point_masses],
        "material": bat.material.name,
        "remark": in_one_system(bat.remark),
    }
