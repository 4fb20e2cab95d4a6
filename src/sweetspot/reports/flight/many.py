"""Many flights as a document: how far they carry, and where they come down."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from sweetspot.answers.records import plain_data
from sweetspot.flight.kernel import Flights
from sweetspot.flight.sweep import FlightTable, cells_of
from sweetspot.numerics.arrays import Array
from sweetspot.reports.document import Document, Paragraph, Picture
from sweetspot.reports.grid.document import grid_document
from sweetspot.reports.grid.grid import Grid
from sweetspot.reports.quantities import Reader, key
from sweetspot.reports.sentences import Sentence, Slot, Span, say
from sweetspot.units import grouped


def flights_document(flown: Flights) -> Document:
    """Return many flights as a document, without bat or field."""
    columns = {
        "outcome": flown.outcome, key("carry"): flown.carry, key("hang_time"): flown.hang_time,
        key("apex"): flown.apex_height, key("bearing"): flown.bearing, key("landing_angle"): flown.landing_angle,
    }  # fmt: skip
    picture = Picture(
        "flights", partial(_drawn, flown), label="Where the balls come down, from above, and how far they carry.",
        caption="A dot for each ball that came down.",
    )  # fmt: skip
    lists = plain_data({name: values.tolist() for name, values in columns.items()})
    return Document(
        name="flights", title="", kind="Flights", blocks=[Paragraph(_words(flown)), picture], data=lists, rows=lists,
        drawing=picture if flown.landed.any() else None,
    )  # fmt: skip


def _words(flown: Flights) -> Sentence:
    count, landed = len(flown), int(flown.landed.sum())
    balls = "ball" if count == 1 else "balls"
    if not landed:
        return say("{count} {balls}, none of which came down.", count=grouped(count), balls=balls)
    carry, time = flown.carry[flown.landed], flown.hang_time[flown.landed]
    return say(
        "{count} {balls}, {landed} of which came down: {far} from home plate, half of them beyond {middle}, after "
        "{time}.",
        count=grouped(count), balls=balls, landed=grouped(landed), far=Span(carry.min(), carry.max(), "distance"),
        middle=Slot(float(np.median(carry)), "distance"), time=Span(time.min(), time.max(), "time"),
    )  # fmt: skip


def _drawn(flown: Flights, reading: Reader) -> Any:
    from sweetspot.reports.flight.picture import flights_figure

    return flights_figure(flown, reading)


def answers(table: FlightTable) -> dict[str, Array]:
    """Return the results of every cell, row by row, SI; nan where a ball did not land."""
    flown = table.flights
    return {
        "carry": flown.carry,
        "hang_time": flown.hang_time,
        "apex": flown.apex_height,
        "landing_angle": flown.landing_angle,
        "landing_speed": np.linalg.norm(flown.landing_velocity, axis=1),
    }


def sweep_document(table: FlightTable, answer: str) -> Document:
    """Return a table of flights as a document.

    Parameters
    ----------
    answer : what its cells show, a name of `answers`.
    """
    values = np.array([list(row) for row in table.values(answers(table)[answer])], dtype=float)
    grid = Grid(answer, table.rows, table.columns, values)
    return grid_document(grid, name="fly", kind="Table of flights", data=_json(table), rows=_rows(table))


def _json(table: FlightTable) -> dict[str, Any]:
    return dict(
        plain_data(
            {
                "rows": {key(table.rows[0]): list(table.rows[1])},
                "columns": {} if table.columns is None else {key(table.columns[0]): list(table.columns[1])},
                "answers": {key(name): table.values(values) for name, values in answers(table).items()},
            }
        )
    )


def _rows(table: FlightTable) -> dict[str, list[Any]]:
    """Return one row per cell, as columns."""
    cells = cells_of(table.rows, table.columns)
    sides = {key(name): [dict(cell)[name] for cell in cells] for name, _ in cells[0]}
    return dict(plain_data(sides | {key(name): values for name, values in answers(table).items()}))
