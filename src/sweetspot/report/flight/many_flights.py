"""Many flights as a document: how far they carry, and where they come down."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from sweetspot.flight.kernel import Flights
from sweetspot.report.document import Document, Paragraph, Picture
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import Reader, key
from sweetspot.report.sentences import Sentence, Slot, Span, say
from sweetspot.units import grouped


def flights_document(flown: Flights) -> Document:
    """Return many flights as a document; nobody says here what was hit, or on which field."""
    columns = {
        "outcome": flown.outcome, key("carry"): flown.carry, key("hang_time"): flown.hang_time,
        key("apex"): flown.apex_height, key("bearing"): flown.bearing, key("landing_angle"): flown.landing_angle,
    }  # fmt: skip
    picture = Picture(
        "flights", partial(_drawn, flown), label="Where the balls come down, from above, and how far they carry.",
        caption="A dot for each ball that came down.",
    )  # fmt: skip
    lists = cleaned({name: values.tolist() for name, values in columns.items()})
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
    from sweetspot.report.flight.many_picture import flights_figure

    return flights_figure(flown, reading)
