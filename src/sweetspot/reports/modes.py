"""The motions of a bat as a document: what rings, how high, and where it stands still."""

from __future__ import annotations

from sweetspot.answers.records import plain_data
from sweetspot.dynamics.modes import Modes
from sweetspot.reports.document import Block, Cell, Document, Paragraph, Picture, Table, as_columns, drawn, table_head
from sweetspot.reports.sentences import Slot, UnitName, joined, say

KINDS = {"rigid": "rigid motion", "bending": "bending", "hoop": "wall (hoop)", "face": "face", "hand": "hands"}
MOST_NODES = 4
"""Nodes of a mode that its row names."""


def modes_document(modes: Modes) -> Document:
    """Return all motions as a document; places count from the end of the grip, as its length is not given."""
    rows: list[list[Cell]] = []
    data: list[dict[str, object]] = []
    for index, family in enumerate(modes.families):
        frequency, damping = float(modes.frequency[index]), float(modes.damping_ratio[index])
        nodes = [float(node) for node in modes.nodes(index)] if family == "bending" else []
        places = joined([Slot(node, "place", unit=False) for node in nodes[:MOST_NODES]], ", ")
        stands = say("{places} {unit}", places=places, unit=UnitName("place")) if nodes else ""
        rigid, number = family == "rigid", modes.harmonics[index]
        kind = KINDS[family] if rigid else f"{KINDS[family]} {number}"
        rows.append([kind, None if rigid else frequency, None if rigid else damping, stands])
        numbers = {"frequency_hz": frequency, "damping_ratio": damping, "nodes_m": nodes}
        data.append({"family": family, "harmonic": number, **numbers})
    columns = table_head("motion | rings at: frequency | damping: share, 2 | stands still, from the end of the grip")
    picture = Picture(
        "modes",
        drawn("sweetspot.reports.pictures.modes:modes_figure", modes),
        label="How the bat bends in its first modes.",
    )
    bends = bool(len(modes.of_family("bending")))
    blocks: list[Block] = [Table("", columns, rows), *([picture] if bends else [])]
    if not bends:
        blocks.append(Paragraph("None of these bends the bat along its length: there is nothing to draw.", "note"))
    return Document(
        name="modes",
        title="Modes",
        kind="Modes",
        blocks=blocks,
        data=plain_data({"modes": data}),
        rows=as_columns(data),
        drawing=picture if bends else None,
    )
