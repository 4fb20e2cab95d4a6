"""Published values of a catalogue bat, drawn beside its curves: places and values with their source."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated

from sweetspot.references import cite, reference
from sweetspot.reports.sentences import Sentence, Slot, joined, say
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH, System
from sweetspot.validation.cases import Row, sources
from sweetspot.web.controls import BatState
from sweetspot.web.documents import in_either_system
from sweetspot.web.recipes import is_catalogued

UNITS = {"in": INCH, "cm": 0.01}
PLACES = {
    "best_from_tip": "exit_speed_m_s",
    "best_efficiency_from_tip": "collision_efficiency",
    "node_from_tip": "sting_m_s",
}
"""Computations of places on a bat, and the curve beside which such a place is drawn."""
VALUES = {"whole_efficiency": "collision_efficiency"}
"""Computations of a curve's greatest value, whose place was not published."""


@dataclass(frozen=True)
class Publication:
    """One published number of a bat.

    Parameters
    ----------
    curve : beside which it is drawn.
    words, source : what it is and who published it, and where.
    place : the stretch of the bat of which it tells, from the knob end.
    values : ends of a curve's greatest value, whose place was not published.
    """

    curve: str
    words: Mapping[System, str]
    source: str
    place: Annotated[tuple[float, float], LENGTH]
    values: tuple[float, float] | None


def published(state: BatState, *, length: float, most_efficient: float) -> tuple[Publication, ...]:
    """Return the publications about a state's bat, as long as nothing of it was changed.

    Parameters
    ----------
    length, most_efficient : m; of the bat, and to the place of its greatest collision efficiency, from the knob end.
    """
    return _of_bat(state.bat, length, most_efficient) if is_catalogued(state) else ()


@cache
def _of_bat(name: str, length: float, most_efficient: float) -> tuple[Publication, ...]:
    rows = [(row, case) for case in sources() for row in case.rows if row.inputs.get("bat") == name]
    marks = (_mark(row, case.source, name, length, most_efficient) for row, case in rows)
    return tuple(mark for mark in marks if mark is not None)


def _mark(row: Row, key: str, name: str, length: float, most_efficient: float) -> Publication | None:
    low, high = (row.value if end is None else end for end in (row.low, row.high))
    assert low is not None and high is not None
    source = reference(key)
    by = f"{source.authors.split(',')[0]} {source.fields.get('year', '')}".strip()
    about = f"{by}: {row.quantity.partition(',')[0].removesuffix(f' of {name}')}"
    if row.computation in PLACES and row.unit in UNITS:
        near, far = UNITS[row.unit] * low, UNITS[row.unit] * high
        words = say("{about}: {place} from the tip", about=about, place=_span(near, far, "place"))
        return Publication(
            PLACES[row.computation], in_either_system(words), cite(key), (length - far, length - near), None
        )
    if row.computation in VALUES:
        words = say("{about}: {value}", about=about, value=_span(*row.allowed, "ratio"))
        place = (most_efficient, most_efficient)
        return Publication(VALUES[row.computation], in_either_system(words), cite(key), place, row.allowed)
    return None


def _span(low: float, high: float, scale: str) -> Sentence:
    ends = [say("{end}", end=Slot(end, scale)) for end in ((low, high) if low < high else (low,))]
    return joined(ends, " to ")
