"""A document for a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from textwrap import fill

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table as RichTable
from rich.text import Text

from sweetspot.references import cite
from sweetspot.report import document as parts
from sweetspot.report.quantities import Reader
from sweetspot.report.sentences import read

NARROW = 8
"""Characters of a column that its heading may take at least."""
STYLES = {"text": "", "note": "dim", "warning": "yellow"}


def to_terminal(document: parts.Document, reader: Reader) -> Group:
    """Return a document as `rich` prints it: title, sentences, tables, notes."""
    title = Text(read(document.title, reader), style="bold")
    if subtitle := read(document.subtitle, reader):
        title.append(f"  {subtitle}", style="dim")
    if document.made_for:
        title.append(f"  for {document.made_for}")
    heading = [title, Text()] if title.plain else []
    return Group(*heading, *_rendered([*document.blocks, *document.details], reader))


def _rendered(blocks: Sequence[parts.Block], reader: Reader) -> Iterator[RenderableType]:
    for block in blocks:
        match block:
            case parts.Paragraph():
                if words := read(block.words, reader):
                    yield Padding(Text(words, style=STYLES[block.kind]), (0, 0, 1, 0))
            case parts.Bullets():
                yield from (Text(f"- {read(item, reader)}") for item in block.items)
                yield Text()
            case parts.Question():
                yield Text(read(block.question, reader), style="bold")
                yield Padding(Text(read(block.answer, reader)), (0, 0, 1, 2))
            case parts.Table():
                if title := read(block.title, reader):
                    yield Text(title, style="bold")
                yield table(block, reader)
                yield Text()
            case parts.Sources():
                yield from (Text(f"[{key}] {cite(key)}", style="dim") for key in block.keys)
            case parts.Section():
                yield Text(read(block.title, reader), style="bold")
                yield from _rendered(block.blocks, reader)
            case parts.Cards() | parts.Picture():
                continue


def table(block: parts.Table, reader: Reader) -> RichTable:
    """Return a table as `rich` prints it; the last column of words takes what room there is."""
    made = RichTable(header_style="bold", box=None, pad_edge=False)
    doubted = any("±" in column.shown(row[number], reader) for number, column in enumerate(block.columns)
                  if column.is_number for row in block.rows)  # fmt: skip
    for number, column in enumerate(block.columns):
        texts = [column.shown(row[number], reader) for row in block.rows]
        lopsided = [text for text in texts if column.is_number and " (" in text]  # too long for a line among others
        whole = (column.is_number and not lopsided) or (number == 0 and len(block.columns) < 7)
        head = column.head(reader)
        if column.is_number and doubted:  # intervals take the room that headings had
            widths = [len(text) for text in texts if text not in lopsided]
            head = fill(head, max([*widths, NARROW]), break_long_words=False)
        made.add_column(head, justify="right" if column.is_number else "left", no_wrap=whole)
    for row in block.rows:
        cells = zip(block.columns, row, strict=True)
        made.add_row(*(Text(column.shown(cell, reader)) for column, cell in cells))
    return made
