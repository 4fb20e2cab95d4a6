"""The catalogue's bats under the standard conditions, analysed once per build."""

from __future__ import annotations

from functools import cache
from typing import Any

from sweetspot import analyse, catalog, standard_conditions
from sweetspot.analysis import Analysis
from sweetspot.units import INCH

FLAGSHIP = "r161-ash"


@cache
def analysed(name: str = FLAGSHIP) -> Analysis:
    """Return the full answer for a bat of the catalogue."""
    bat = catalog.bat(name)
    return analyse(bat, standard_conditions(bat))


def from_tip(analysis: Analysis, position: Any) -> Any:
    """Return a position, or an array of them, as inches from the tip."""
    return (analysis.bat.length - position) / INCH
