"""What was published of a bat of the catalogue and is drawn beside its curves: places and values with their source."""

from __future__ import annotations

from functools import cache
from typing import Any

from sweetspot.references import cite, reference
from sweetspot.units import INCH
from sweetspot.validation.cases import Case, Row, sources
from sweetspot.web.recipes import is_catalogued
from sweetspot.web.states import BatState

UNITS = {"in": INCH, "cm": 0.01}
PLACES = {
    "best_from_tip": "exit_speed_m_s", "best_efficiency_from_tip": "collision_efficiency", "node_from_tip": "sting_m_s",
}  # fmt: skip
"""Computations of places on a bat, and the curve beside which such a place is drawn."""
VALUES = {"whole_efficiency": "collision_efficiency"}
"""Computations of a curve's greatest value, whose place was not published."""


def published(state: BatState) -> list[dict[str, Any]]:
    """Return what is known of a state's bat, as long as nothing of it was changed; see `_mark`."""
    return _of_bat(state.bat) if is_catalogued(state) else []


@cache
def _of_bat(name: str) -> list[dict[str, Any]]:
    marks = [_mark(row, case, name) for case in sources() for row in case.rows if row.inputs.get("bat") == name]
    return [one for one in marks if one is not None]


def _mark(row: Row, case: Case, name: str) -> dict[str, Any] | None:
    """Return one published number: its curve, the stretch from the tip in m, or the values of a greatest one."""
    low, high = (row.value if end is None else end for end in (row.low, row.high))
    assert low is not None and high is not None
    words = row.quantity.partition(",")[0].removesuffix(f" of {name}")
    source = reference(case.source)
    by = f"{source.authors.split(',')[0]} {source.fields.get('year', '')}".strip()
    told = {"words": words, "by": by, "source": cite(case.source), "places_m": None, "values": None}
    if row.computation in PLACES and row.unit in UNITS:
        ends = [UNITS[row.unit] * end for end in (low, high)]
        return {**told, "curve": PLACES[row.computation], "places_m": ends}
    if row.computation in VALUES:
        return {**told, "curve": VALUES[row.computation], "values": [*row.allowed]}
    return None
