"""The uncertainty of a view's numbers: its answer as a document with an interval beside each number, and the sources.

Speeds, places and weather are taken as the controls say; bat, ball and drag are drawn.
"""

from __future__ import annotations

from sweetspot.calibration.calibrated_file import known_deviations
from sweetspot.catalog.files.bat import table_of_text
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Conditions
from sweetspot.uncertainty.sources import Sources, sources_of
from sweetspot.web.controls import BatState

PAGE_DRAWS = 256
"""Draws of what is not known, a quarter of the command's: an interval's ends are then known to a tenth of it."""


def sources_for(state: BatState, bat: Bat, conditions: Conditions) -> Sources:
    """Return the uncertain quantities of a hit; a calibrated bat's own file gives its part."""
    deviations = known_deviations(table_of_text(state.bat_toml, "the bat's file")) if state.bat_toml else None
    return sources_of(bat, conditions, calibration=deviations)
