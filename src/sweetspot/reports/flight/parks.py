"""Ball parks as documents: all of them in a line each, or one fence all the way round."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from sweetspot.flight.park import Park
from sweetspot.reports.document import Cell, Column, Document, Picture, Table
from sweetspot.reports.json_shapes import as_columns
from sweetspot.reports.quantities import Reader
from sweetspot.reports.sentences import Sentence, Span

NAMED = {"left_field": -45.0, "left_center": -22.5, "center_field": 0.0, "right_center": 22.5, "right_field": 45.0}
"""Directions that people know by name, degrees from centre field."""
ROOFS = {"open": "", "retractable": "moves", "fixed": "fixed"}


def parks_document(parks: Mapping[str, Park], fields: Mapping[str, Park] | None = None) -> Document:
    """Return many parks as a document, by their names in the catalogue.

    Parameters
    ----------
    fields : of leagues whose fences have recommended or usual distances.
    """
    rows: list[list[Cell]] = []
    for name, park in parks.items():
        heights = [height for _, _, height in park.fence]
        wall = Sentence((Span(min(heights), max(heights), "distance", unit=False),))
        rows.append([name, park.team, park.elevation, ROOFS[park.roof], *_distances(park), wall])
    far = [Column(name, "distance", digits=0) for name in ("LF", "LC", "CF", "RC", "RF")]
    columns = [Column("name"), Column("team"), Column("elev.", "distance", digits=0), Column("roof")]
    records = [{"key": name, **_json(park)} for name, park in parks.items()]
    picture = _picture(list(parks.values()), None)
    blocks = [Table("Parks: elevation, fence and wall", [*columns, *far, Column("wall", "distance")], rows, "parks")]
    if fields:
        blocks.append(_fields(fields))
    return Document(
        name="parks", title="", kind="Ball parks",
        blocks=[*blocks, picture],
        data={"parks": records}, rows=as_columns(records), drawing=picture,
    )  # fmt: skip


def _fields(fields: Mapping[str, Park]) -> Table:
    columns = [Column("name"), Column("of")]
    columns += [Column(name, "distance", digits=0) for name in ("LF", "LC", "CF", "RC", "RF")]
    rows: list[list[Cell]] = [
        [name, field.team, *_distances(field), max(high for _, _, high in field.fence)]
        for name, field in fields.items()
    ]
    return Table(
        "Fields of other leagues, with usual distances", [*columns, Column("wall", "distance")], rows, "fields"
    )


def park_document(park: Park, others: Sequence[Park]) -> Document:
    """Return one park's fence all the way round as a document; ``others`` are drawn behind it."""
    columns = [
        Column("from centre", "angle", digits=0, sign=True), Column("distance", "distance"),
        Column("height", "distance", digits=1),
    ]  # fmt: skip
    fence = [{"direction_rad": turn, "distance_m": far, "height_m": high} for turn, far, high in park.fence]
    picture = _picture(others, park)
    return Document(
        name="park", title=park.name, subtitle=park.team, kind="Ball park",
        blocks=[Table("The fence from left to right", columns, [list(vertex) for vertex in park.fence]), picture],
        data={**_json(park), "fence": fence}, rows=as_columns(fence), drawing=picture,
    )  # fmt: skip


def _distances(park: Park) -> list[float]:
    return [park.distance_at(math.radians(angle)) for angle in NAMED.values()]


def _json(park: Park) -> dict[str, Any]:
    """Return a park's facts; distances in the directions people have names for."""
    heights = [height for _, _, height in park.fence]
    return {
        "name": park.name,
        "team": park.team,
        "city": park.city,
        "elevation_m": park.elevation,
        "roof": park.roof,
        **{f"{name}_m": far for name, far in zip(NAMED, _distances(park), strict=True)},
        "lowest_fence_m": min(heights),
        "highest_fence_m": max(heights),
    }


def _picture(parks: Sequence[Park], named: Park | None) -> Picture:
    label = "Fences from above." if named is None else f"The fence of {named.name} from above, over those of others."
    return Picture(
        "fences", lambda reading: _drawn(parks, named, reading, (7.0, 5.6)), label=label,
        sheet=lambda reading: _drawn(parks, named, reading, (4.6, 3.7)),
    )  # fmt: skip


def _drawn(parks: Sequence[Park], named: Park | None, reading: Reader, size: tuple[float, float]) -> Any:
    from sweetspot.reports.flight.picture import parks_figure

    return parks_figure(parks, [named] if named else [], reading, size=size)
