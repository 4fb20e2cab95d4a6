"""Tables of a terminal: no cell loses its end, however long."""

from __future__ import annotations

import io

from rich.console import Console

from sweetspot.report.document import Column, Document, Table
from sweetspot.report.quantities import US
from sweetspot.report.terminal import to_terminal


def printed(table: Table, width: int = 90) -> str:
    screen = io.StringIO()
    document = Document(name="x", title="", kind="", blocks=[table], data={}, rows={}, reader=US)
    Console(file=screen, width=width).print(to_terminal(document, US))
    return screen.getvalue()


def test_long_cells_are_folded_not_cut() -> None:
    name, made = "a_table_with_a_name_of_many_characters_2024.csv.gz", "aluminium alloy, 3.0 mm thick, lying on a floor"
    told = printed(Table("", [Column("table"), Column("block", right=True)], [[name, made], ["short", made]]), width=60)
    assert "…" not in told
    assert name[-13:] in told and "floor" in told


def test_many_long_headings_break_over_lines() -> None:
    heads = [f"expected home runs per ball in play, the {number}th" for number in range(6)]
    told = printed(Table("", [Column("who"), *(Column(head, right=True) for head in heads)], [["a", *"123456"]]))
    assert "…" not in told and "expected" in told and "5th" in told
