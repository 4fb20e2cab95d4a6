"""Tables of a terminal: no cell loses its end, however long."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from sweetspot.cli.options.output import OutputOptions
from sweetspot.cli.output import present
from sweetspot.reports.document import Column, Document, Table
from sweetspot.reports.quantities import US
from sweetspot.reports.terminal import to_terminal


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


@pytest.mark.parametrize("columns", [40, 60, 80, 110])
def test_a_narrow_terminal_loses_no_name_and_no_unit(
    columns: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A table of two bats: what does not fit is broken between words, or the line is longer than the terminal."""
    heads = ["bat", "mass oz", "balance in", "MOI", "f1 Hz", "q max", "BBCOR in play"]
    columns_of = [Column(heads[0]), *(Column(head, right=True) for head in heads[1:])]
    rows = [
        ["R161, white ash", "31.0", "22.05", "10,300 ± 1000 oz in²", "172", "0.216", "0.478"],
        ["Russell B6, hollow", "31.0", "20.40", "9590 oz in²", "164", "0.263", "0.538"],
    ]
    document = Document(name="x", title="", kind="", blocks=[Table("", columns_of, rows)], data={}, rows={}, reader=US)
    monkeypatch.setenv("COLUMNS", str(columns))
    assert present(document, OutputOptions()) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert all(cell in told for row in rows for cell in row[1:])
    assert all(word in told for row in rows for word in row[0].split())
