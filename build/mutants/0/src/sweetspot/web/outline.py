"""A bat's shape as numbers for a drawing."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot.bat import Bat

POINTS = 120
"""Places along a bat whose outline is a formula."""


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
    }
