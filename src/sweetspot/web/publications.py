"""Published values of a catalogue bat, drawn beside its curves: places and values with their source."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Annotated

from sweetspot.references import cite, reference
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH
from sweetspot.validation.cases import Case, Row, sources
from sweetspot.web.controls import BatState
from sweetspot.web.recipes import is_catalogued

UNITS = {"in": INCH, "cm": 0.01}
PLACES = {
    "best_from_tip": "exit_speed_m_s", "best_efficiency_from_tip": "collision_efficiency", "node_from_tip": "sting_m_s",
}  # fmt: skip
"""Computations of places on a bat, and the curve beside which such a place is drawn."""
VALUES = {"whole_efficiency": "collision_efficiency"}
"""Computations of a curve's greatest value, whose place was not published."""


@dataclass(frozen=True, kw_only=True)
class Publication:
    """One published number of a bat.

    Parameters
    ----------
    words, by, source : what it is, who published it, and where.
    curve : beside which it is drawn.
    places : from the tip, where it is a stretch of the bat.
    values : ends of a curve's greatest value, whose place was not published.
    """

    words: str
    by: str
    source: str
    curve: str
    places: Annotated[tuple[float, float] | None, LENGTH]
    values: tuple[float, float] | None


def published(state: BatState) -> tuple[Publication, ...]:
    """Return the publications about a state's bat, as long as nothing of it was changed."""
    return _of_bat(state.bat) if is_catalogued(state) else ()


@cache
def _of_bat(name: str) -> tuple[Publication, ...]:
    rows = [(row, case) for case in sources() for row in case.rows if row.inputs.get("bat") == name]
    return tuple(mark for row, case in rows if (mark := _mark(row, case, name)) is not None)


def _mark(row: Row, case: Case, name: str) -> Publication | None:
    low, high = (row.value if end is None else end for end in (row.low, row.high))
    assert low is not None and high is not None
    place = row.computation in PLACES and row.unit in UNITS
    if not place and row.computation not in VALUES:
        return None
    source = reference(case.source)
    return Publication(
        words=row.quantity.partition(",")[0].removesuffix(f" of {name}"),
        by=f"{source.authors.split(',')[0]} {source.fields.get('year', '')}".strip(),
        source=cite(case.source),
        curve=PLACES[row.computation] if place else VALUES[row.computation],
        places=(UNITS[row.unit] * low, UNITS[row.unit] * high) if place else None,
        values=None if place else row.allowed,
    )
