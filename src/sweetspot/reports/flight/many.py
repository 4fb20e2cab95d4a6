"""Many flights as a document: how far they carry, and where they come down."""

from __future__ import annotations

import numpy as np

from sweetspot.answers.records import plain_data
from sweetspot.answers.what_if import FlyTableAnswer
from sweetspot.flight.kernel import Flights
from sweetspot.reports.document import Document, Paragraph, Picture, cells_as_columns, drawn
from sweetspot.reports.grid.document import grid_document
from sweetspot.reports.grid.grid import Grid
from sweetspot.reports.quantities import key
from sweetspot.reports.sentences import Sentence, Span, say
from sweetspot.units import grouped


def flights_document(flown: Flights) -> Document:
    """Return many flights as a document, without bat or field."""
    columns = {
        "outcome": flown.outcome, key("carry"): flown.carry, key("hang_time"): flown.hang_time,
        key("apex"): flown.apex_height, key("bearing"): flown.bearing, key("landing_angle"): flown.landing_angle,
    }  # fmt: skip
    picture = Picture(
        "flights",
        drawn("sweetspot.reports.flight.picture:flights_figure", flown),
        "Where the balls come down, from above, and how far they carry.",
        "A dot for each ball that came down.",
    )
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
        "{count} {balls}, {landed} of which came down: {far} from home plate, half of them beyond {middle:distance}, "
        "after {time}.",
        count=grouped(count),
        balls=balls,
        landed=grouped(landed),
        far=Span(carry.min(), carry.max(), "distance"),
        middle=float(np.median(carry)),
        time=Span(time.min(), time.max(), "time"),
    )


def fly_table_document(answer: FlyTableAnswer) -> Document:
    """Return a table of flights as a document."""
    cell, down, data = answer.question.cell, answer.rows.varied, answer.to_dict()
    assert down is not None
    grid = Grid(cell, down, answer.columns.varied, getattr(answer.answers, cell))
    return grid_document(grid, name="fly", kind="Table of flights", data=data, rows=cells_as_columns(data))
