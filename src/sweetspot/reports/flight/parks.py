"""Ball parks as documents: all of them in a line each, or one fence all the way round."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot import catalog
from sweetspot.answers.catalogued import ParkAnswer, ParkFacts, ParksAnswer
from sweetspot.flight.park import Park
from sweetspot.reports.document import Cell, Column, Document, Picture, Table, as_columns, drawn, table_head
from sweetspot.reports.sentences import Sentence, Span

PARKS = "sweetspot.reports.flight.picture:parks_figure"
ROOFS = {"open": "", "retractable": "moves", "fixed": "fixed"}
FAR = [Column(name, "distance", digits=0) for name in ("LF", "LC", "CF", "RC", "RF")]


def parks_document(answer: ParksAnswer) -> Document:
    """Return many parks as a document, by their names in the catalogue."""
    columns = table_head("name | team | elev.: distance, 0 | roof")
    columns += [*FAR, Column("wall", "distance")]
    data = answer.to_dict()
    picture = _picture(catalog.parks(), None)
    return Document(
        name="parks",
        title="",
        kind="Ball parks",
        blocks=[
            Table("Parks: elevation, fence and wall", columns, [_row(park) for park in answer.parks], "parks"),
            _fields(answer.fields),
            picture,
        ],
        data=data,
        rows=as_columns(data["parks"]),
        drawing=picture,
    )


def _row(park: ParkFacts) -> list[Cell]:
    wall = Sentence((Span(float(park.lowest_fence), float(park.highest_fence), "distance", unit=False),))
    return [park.key, park.team, float(park.elevation), ROOFS[park.roof], *park.distances, wall]


def _fields(fields: Sequence[ParkFacts]) -> Table:
    columns = [Column("name"), Column("of"), *FAR, Column("wall", "distance")]
    rows: list[list[Cell]] = [[field.key, field.team, *field.distances, float(field.highest_fence)] for field in fields]
    return Table("Fields of other leagues, with usual distances", columns, rows, "fields")


def park_document(answer: ParkAnswer) -> Document:
    """Return one park's fence all the way round as a document; other parks are drawn behind it."""
    columns = table_head("from centre: angle, 0, sign | distance: distance | height: distance, 1")
    data, picture = answer.to_dict(), _picture(catalog.parks(), answer.park)
    corners = [list(corner) for corner in answer.park.fence]
    return Document(
        name="park",
        title=answer.name,
        subtitle=answer.team,
        kind="Ball park",
        blocks=[Table("The fence from left to right", columns, corners), picture],
        data=data,
        rows=as_columns(data["fence"]),
        drawing=picture,
    )


def _picture(parks: Sequence[Park], named: Park | None) -> Picture:
    coloured = [named] if named else []
    label = "Fences from above." if named is None else f"The fence of {named.name} from above, over those of others."
    return Picture(
        "fences", drawn(PARKS, parks, coloured, size=(7.0, 5.6)), label=label,
        sheet=drawn(PARKS, parks, coloured, size=(4.6, 3.7)),
    )  # fmt: skip
