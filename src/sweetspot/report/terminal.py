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
ROOM = 110
"""Characters of a table's width above which headings are broken into lines."""
SHORT = 32
"""Characters of a cell that a line may be kept whole for."""
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
    shown = [[column.shown(row[number], reader) for row in block.rows] for number, column in enumerate(block.columns)]
    heads = [column.head(reader) for column in block.columns]
    widths = [max(len(head), *(len(text) for text in texts if len(text) <= SHORT and " (" not in text), 0) + 2
              for head, texts in zip(heads, shown, strict=True)]  # fmt: skip
    wide = sum(widths) > ROOM
    for number, (column, head, texts) in enumerate(zip(block.columns, heads, shown, strict=True)):
        lopsided = [text for text in texts if column.is_number and " (" in text]  # too long for a line among others
        whole = (column.is_number and not lopsided) or (number == 0 and len(block.columns) < 7)
        whole = whole and not any(len(text) > SHORT for text in texts)
        if column.is_number and (doubted or wide):  # intervals and many columns take the room that headings had
            whole_ones = [len(text) for text in texts if text not in lopsided]
            heads[number] = fill(head, max([*whole_ones, NARROW]), break_long_words=False)
        made.add_column(heads[number], justify="right" if column.is_number else "left", no_wrap=whole, overflow="fold")
    for row in block.rows:
        cells = zip(block.columns, row, strict=True)
        made.add_row(*(Text(column.shown(cell, reader)) for column, cell in cells))
    return made
