"""The catalogue as a document: bats, and implements of other sports."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sweetspot import catalog
from sweetspot.answers.conditions import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.sports import sport_implements, sport_names
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import moi_doubt, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.reports.document import Cell, Document, Paragraph, Table, as_columns, table_head
from sweetspot.reports.sentences import PLUS_MINUS, Slot, with_doubt
from sweetspot.reports.sport_words import reader_of


def catalogue_document() -> Document:
    """Return the catalogue's bats with weight, balance and swing weight, and a short table of every other implement."""
    bats = [(key, catalog.bat(key)) for key in catalog.bat_names()]
    rows: list[dict[str, object]] = []
    cells: list[list[Cell]] = []
    for key, bat in bats:
        body = rigid_body(beam_model(bat))
        mass, doubt = mass_properties(bat, body), moi_doubt(bat, body, STANDARD_AXIS)
        rows.append({"key": key, **to_dict(mass), "moi_6in_doubt_kg_m2": doubt})
        sizes = [float(mass.length), float(mass.mass), float(mass.balance_point)]
        cells.append([key, bat.name, *sizes, with_doubt(float(mass.moi_6in), doubt, "moi")])
    columns = table_head("name | what | length: length, 1 | mass: mass | balance point: length | moment of inertia >")
    keys = {key for key, _ in bats}
    notes = [Paragraph(words, "note") for words in (PLUS_MINUS, _assumed_balances(bats), HOW_TO_SHOW)]
    return Document(
        name="bats",
        title="Bats of the catalogue",
        kind="Catalogue",
        blocks=[Table("", columns, cells), _others(keys), *notes],
        data={"bats": rows, "others": _other_rows(keys)},
        rows=as_columns(rows),
        reader=reader_of(bats[0][1].sport),
    )


def _assumed_balances(bats: Sequence[tuple[str, Bat]]) -> str:
    """Return which bats' balance points follow from an outline that was assumed."""
    outlines = ((key, implement_tables()[key].get("profile")) for key, bat in bats if bat.balance_point is None)
    names = [key for key, outline in outlines if isinstance(outline, Mapping) and outline["kind"] == "assumed"]
    return f"Assumed outlines, and with them balance points: {', '.join(names)}."


HOW_TO_SHOW = (
    '`sweetspot show NAME` prints any of them as a file to change; a file that begins with like = "NAME" needs only '
    "what is different; what it adds is added to the weight, and a mass that it gives is that of the finished one."
)


def _other_rows(bats: set[str]) -> list[dict[str, object]]:
    """Return every other implement for other programs."""
    rows: list[dict[str, object]] = []
    for key in (key for key in catalog.implement_names() if key not in bats):
        implement = catalog.implement(key)
        described = to_dict(mass_properties(implement, rigid_body(beam_model(implement))))
        rows.append({"key": key, "sport": implement.sport, **described})
    return rows


def _others(bats: set[str]) -> Table:
    """Return the implements of other sports, each in the words of its sport."""
    columns = table_head("name | what | sport | length > | mass > | swing weight >")
    rows: list[list[Cell]] = []
    for key in (key for name in sport_names() for key in sport_implements(name) if key not in bats):
        implement = catalog.implement(key)
        body = rigid_body(beam_model(implement))
        convention = swing_weight(implement.sport)
        sizes = [Slot(implement.length, "place"), Slot(body.mass, "mass")]
        rows.append([key, implement.name, implement.sport, *sizes, convention.text_of(body)])
    return Table("Of other sports", columns, rows)
