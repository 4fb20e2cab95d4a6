"""Many answers as one document: hits by their number, where balls come down, a grid of what was varied."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sweetspot.answers.records import plain_data
from sweetspot.answers.what_if import FlyTableAnswer, cells_as_columns
from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impacts, Outcome
from sweetspot.flight.kernel import Flights
from sweetspot.reports.document import (
    Block,
    Document,
    Paragraph,
    Picture,
    drawn,
)
from sweetspot.reports.grid import Grid, varied
from sweetspot.reports.quantities import key
from sweetspot.reports.sentences import Sentence, Slot, Span, joined, say
from sweetspot.units import grouped


def impacts_document(hits: Impacts | Strikes) -> Document:
    """Return many collisions as a document, without their bat's name or swing speed."""
    columns = {
        "outcome": [Outcome(int(each)).name.lower() for each in hits.outcome.ravel()],
        **{key(name): getattr(hits, name).ravel().tolist()
           for name in ("collision_efficiency", "contact_time", "peak_force", "peak_compression")},
    }  # fmt: skip
    picture = Picture(
        "hits",
        drawn("sweetspot.reports.hit.picture:impacts_figure", hits),
        "Collision efficiency, contact time and peak force of every hit.",
        "In the order in which they were asked for.",
    )
    lists = plain_data(columns)
    valid = bool(np.isfinite(hits.collision_efficiency).any())
    return Document(
        name="hits",
        title="",
        kind="Hits",
        blocks=[Paragraph(_hit_words(hits)), *([picture] if valid else [])],
        data=lists,
        rows=lists,
        drawing=picture if valid else None,
    )


def _hit_words(hits: Impacts | Strikes) -> Sentence:
    efficiency, count = hits.collision_efficiency.ravel(), len(hits.outcome.ravel())
    finite = np.isfinite(efficiency)
    noun = "hit" if count == 1 else "hits"
    if not finite.any():
        return say("{count} {noun}, none of which has an answer.", count=grouped(count), noun=noun)
    best = int(np.nanargmax(efficiency))
    return say(
        "{count} {noun}, {known} with an answer: collision efficiency {q}, greatest in number {best}; contact {time}; "
        "peak force {force}.",
        count=grouped(count),
        noun=noun,
        known=grouped(int(finite.sum())),
        best=grouped(best + 1),
        q=Span(float(efficiency[finite].min()), float(efficiency[best]), "ratio"),
        time=_span(hits.contact_time, "contact"),
        force=_span(hits.peak_force, "blow"),
    )


def _span(values: Any, scale: str) -> Span | Slot:
    finite = values[np.isfinite(values)]
    return Span(float(finite.min()), float(finite.max()), scale) if len(finite) else Slot(float("nan"), scale)


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
        name="flights",
        title="",
        kind="Flights",
        blocks=[Paragraph(_flight_words(flown)), picture],
        data=lists,
        rows=lists,
        drawing=picture if flown.landed.any() else None,
    )


def _flight_words(flown: Flights) -> Sentence:
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
    document = grid_document(grid, name="fly", kind="Table of flights", data=data, rows=cells_as_columns(data))
    blocks = [Paragraph(_greatest(grid)), *document.blocks, Paragraph(_held(answer), "note")]
    return replace(document, blocks=blocks)


def _greatest(grid: Grid) -> Sentence:
    """Return the greatest answer of a table, and where in it."""
    name, values = grid.answer.replace("_", " "), grid.values
    if not np.isfinite(values).any():
        return say("No ball of this table came down.")
    row, column = map(int, np.unravel_index(int(np.nanargmax(values)), values.shape))
    sides = [(grid.down, row)] if grid.across is None else [(grid.down, row), (grid.across, column)]
    at = [say("{what} {value}", what=what.replace("_", " "), value=replace(varied(what, float(each[place])), unit=True))
          for (what, each), place in sides]  # fmt: skip
    greatest = replace(grid.cell(float(values[row, column])), unit=True)
    most = "Farthest" if grid.answer == "carry" else f"Greatest {name}"
    return say("{most} of this table: {greatest}, at {at}.", most=most, greatest=greatest,
               at=joined(at, " and "))  # fmt: skip


def _held(answer: FlyTableAnswer) -> Sentence:
    """Return the conditions that every cell shares: launch, spin and air, as far as they are not varied."""
    hit = answer.question.hit
    free = {side[0] for side in (answer.rows.varied, answer.columns.varied) if side is not None}
    parts = [
        say("{name} {value}", name=name.replace("_", " "), value=Slot(getattr(hit, name), HELD[name]))
        for name in HELD
        if name not in free and getattr(hit, name) is not None
    ]
    usual = [name for name in ("backspin", "sidespin") if name not in free and getattr(hit, name) is None]
    parts += [say("{spins} as such hits usually have", spins=" and ".join(usual))] if usual else []
    return say("In every cell: {ball}; {parts}.", ball=answer.question.ball.name, parts=joined(parts, ", "))


HELD = {
    "exit_speed": "speed",
    "launch_angle": "angle",
    "spray": "angle",
    "backspin": "spin",
    "sidespin": "spin",
    "temperature": "temperature",
    "humidity": "share",
    "elevation": "elevation",
    "wind_speed": "speed",
}
"""Numbers of a hit and its air that a table of flights says it holds, with their scales."""


def grid_document(
    grid: Grid,
    *,
    name: str,
    kind: str,
    data: Mapping[str, Any],
    rows: Mapping[str, Sequence[Any]],
    notes: Sequence[Block] = (),
    title: str = "",
) -> Document:
    """Return a grid as a document: its table, ``notes``, its picture; ``title`` says what it is about."""
    picture = Picture("grid", drawn("sweetspot.reports.pictures.grid:grid_figure", grid, title=title), label=grid.title)
    return Document(
        name=name, title=title, kind=kind, blocks=[grid.table(), *notes, picture], data=data, rows=rows, drawing=picture
    )
