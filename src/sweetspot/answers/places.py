"""Places on an implement by name: its tip, the middle of its barrel, where the ball leaves fastest."""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np

from sweetspot.analysis.bat_analysis import analyse
from sweetspot.catalog.records import canonical
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions

PlaceName = Literal["tip", "barrel", "sweet-spot"]
"""1 in from the tip, the middle of what is almost as thick as the barrel, the fastest place."""
END = 0.0254
"""m from the tip at which a ball is still hit whole [our choice]."""
THICK = 0.98
"""Part of the greatest diameter from which on a bat counts as barrel [our choice]."""


def place_name(text: str) -> PlaceName | None:
    """Return the name of a place as people write it; None: it is none.

    >>> place_name("Sweet Spot"), place_name("6in-from-tip")
    ('sweet-spot', None)
    """
    found = canonical(text).replace("sweetspot", "sweet-spot")
    return next((name for name in get_args(PlaceName) if name == found), None)


def position_of(at: float | PlaceName, implement: Implement, conditions: Conditions) -> float:
    """Return a place in m from the knob end.

    Raises
    ------
    InputError
        for the barrel of what has none.
    """
    if not isinstance(at, str):
        return at
    if at == "tip":
        return implement.length - END
    if at == "sweet-spot":
        return float(analyse(implement, conditions).sweet_spots.max_exit_speed)
    if not isinstance(implement, Bat):
        raise InputError(f"at was given as {at}, which bats alone have; write a place, or sweet-spot")
    places = np.linspace(0.0, implement.length, 400)
    diameters = implement.diameter_at(places)
    return float(places[diameters >= THICK * diameters.max()].mean())
