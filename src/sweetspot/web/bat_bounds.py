"""Bounds of a bat's controls, which come with an answer so that no slider has dead travel."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.weight_match import weights
from sweetspot.equipment.bat import Bat
from sweetspot.units import INCH, OUNCE
from sweetspot.web.bats import KEPT, plain
from sweetspot.web.controls import BatState, SwungState

Range = tuple[float, float]
STEP = 0.05
"""in; bounds are rounded inwards to it, for a hole must be narrower than the wood."""


HOLES = ("bore", "hole")
"""Names of holes: the bore of a workshop, and the hole of a question about drilling."""


def bounds(state: BatState, bat: Bat) -> dict[str, Range]:
    """Return least and most of a state's controls, by field, in the units of the controls.

    Those of the schema hold besides; a control that is not named has no others.
    """
    tip = (0.0, _inside(bat.length / INCH))
    limits = {"weight_from_tip_in": tip, "tap_from_tip_in": tip, "mass_oz": _masses(plain(state))}
    if isinstance(state, SwungState):
        limits["impact_from_tip_in"] = (0.0, _inside((bat.length - bat.choke) / INCH - state.hands_in))
    limits["choke_up_in"] = (0.0, _inside(bat.length / 3 / INCH))
    if bat.shell is None and bat.profile is not None:
        limits["cup_diameter_in"] = (0.0, _inside(_width_at(bat, bat.length)))
        for hole in HOLES:
            if (depth := getattr(state, f"{hole}_depth_in", None)) is not None:
                limits |= _hole(bat, hole, width=getattr(state, f"{hole}_diameter_in"), depth=depth)
    return limits


def _hole(bat: Bat, name: str, *, width: float, depth: float) -> dict[str, Range]:
    """Return the greatest diameter of a hole of this depth, and the greatest depth at this diameter, in."""
    edges = np.asarray(bat.breakpoints())
    widths = bat.diameter_at(edges) / INCH
    end = bat.length - depth * INCH
    limits = {f"{name}_diameter_in": (0.0, _inside(float(min(widths[edges >= end].min(), _width_at(bat, end)))))}
    if width:
        narrow = edges[widths <= width]
        deepest = bat.length - (float(narrow.max()) if len(narrow) else 0.0)
        limits[f"{name}_depth_in"] = (0.5, _inside(deepest / INCH))
    return limits


@lru_cache(maxsize=KEPT)
def _masses(bat: Bat) -> Range:
    """Return the weights that a bat can have: by other wood, or by a hollow bat's end cap and walls."""
    if bat.shell is not None:
        low, high = (limit / OUNCE for limit in weights(bat))
        return (math.ceil(10 * low) / 10, math.floor(10 * high) / 10)
    beam = beam_model(bat)
    mass = rigid_body(beam).mass / OUNCE
    densities = bat.material.density_range
    if densities is None:
        return (10.0, 60.0)
    others = sum(lump.mass for lump in beam.point_masses) / OUNCE
    wood = (mass - others) / (bat.material.density * beam.density_factor)
    return (math.ceil(10 * (others + wood * densities[0])) / 10, math.floor(10 * (others + wood * densities[1])) / 10)


def _width_at(bat: Bat, position: float) -> float:
    return float(bat.diameter_at(max(0.0, position))) / INCH


def _inside(most: float) -> float:
    """Return the last step below a limit."""
    return round(max(0.0, math.ceil(most / STEP - 1e-6) - 1) * STEP, 6)
