"""A document for a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from textwrap import fill

from rich.console import Group, RenderableType
from rich.constrain import Constrain
from rich.padding import Padding
from rich.table import Table as RichTable
from rich.text import Text

from sweetspot.references import cite
from sweetspot.reports import document as parts
from sweetspot.reports.plain_signs import spelled_for
from sweetspot.reports.quantities import Reader
from sweetspot.reports.sentences import Words, read

NARROW = 8
"""Characters of a column that its heading may take at least."""
ROOM = 110
"""Default characters of a line."""
SHORT = 32
"""Characters of a cell that a line may be kept whole for."""
DOUBT = "±"
MORE = "More with --details."
WORD = 14
"""Characters of a word that no column is too narrow for, however narrow the screen."""
STYLES = {"text": "", "note": "dim", "warning": "yellow"}


def to_terminal(document: parts.Document, reader: Reader, *, encoding: str = "utf-8", room: int = ROOM) -> Group:
    """Return a document as `rich` prints it: title, sentences, tables, notes.

    Parameters
    ----------
    encoding : of the terminal; signs that it lacks are spelled, before columns get their widths.
    room : characters of a table's width above which headings are broken into lines.
    """
    screen = Screen(reader, encoding, room)
    title = Text(screen.read(document.title), style="bold")
    if subtitle := screen.read(document.subtitle):
        title.append(f"  {subtitle}", style="dim")
    if document.made_for:
        title.append(f"  for {document.made_for}")
    heading: list[RenderableType] = [screen.as_lines(title), Text()] if title.plain else []
    more = [Text(MORE, style="dim"), Text()] if document.appendix else []
    return Group(*heading, *_rendered([*document.blocks, *document.details], screen), *more)


@dataclass(frozen=True)
class Screen:
    """Who reads, with which signs, and how many characters a line has."""

    reader: Reader
    encoding: str = "utf-8"
    room: int = ROOM

    def as_lines(self, words: RenderableType) -> Constrain:
        """Return words in lines as long as the screen is wide, however much room a table beside them takes."""
        return Constrain(words, self.room)

    def read(self, words: Words) -> str:
        return spelled_for(self.encoding, read(words, self.reader))

    def head(self, column: parts.Column) -> str:
        return spelled_for(self.encoding, column.head(self.reader))

    def cells(self, column: parts.Column, cells: Iterable[parts.Cell]) -> list[str]:
        return [spelled_for(self.encoding, column.shown(cell, self.reader)) for cell in cells]


def _rendered(blocks: Sequence[parts.Block], screen: Screen) -> Iterator[RenderableType]:
    for block in blocks:
        match block:
            case parts.Paragraph():
                if words := screen.read(block.words):
                    yield screen.as_lines(Padding(Text(words, style=STYLES[block.kind]), (0, 0, 1, 0)))
            case parts.Bullets():
                yield from (screen.as_lines(Text(f"- {screen.read(item)}")) for item in block.items)
                yield Text()
            case parts.Question():
                yield screen.as_lines(Text(screen.read(block.question), style="bold"))
                yield screen.as_lines(Padding(Text(screen.read(block.answer)), (0, 0, 1, 2)))
            case parts.Table():
                if title := screen.read(block.title):
                    yield Text(title, style="bold")
                yield table(block, screen)
                yield Text()
            case parts.SourceList():
                yield from (
                    screen.as_lines(Text(f"[{key}] {screen.read(cite(key))}", style="dim")) for key in block.keys
                )
            case parts.Section():
                yield Text(screen.read(block.title), style="bold")
                yield from _rendered(block.blocks, screen)
            case parts.Cards() | parts.Picture():
                continue


def table(block: parts.Table, screen: Screen) -> RichTable:
    """Return a table as `rich` prints it; the last column of words takes what room there is."""
    made = RichTable(header_style="bold", box=None, pad_edge=False)
    by_column = [[row[number] for row in block.rows] for number in range(len(block.columns))]
    text_columns = [screen.cells(column, cells) for column, cells in zip(block.columns, by_column, strict=True)]
    heads = [screen.head(column) for column in block.columns]
    doubted = any(DOUBT in column.shown(row[number], screen.reader) for number, column in enumerate(block.columns)
                  if column.is_number for row in block.rows)  # fmt: skip
    widths = [max(len(head), *(len(text) for text in texts if len(text) <= SHORT and " (" not in text), 0) + 2
              for head, texts in zip(heads, text_columns, strict=True)]  # fmt: skip
    wide = sum(widths) > screen.room
    for number, (column, head, texts) in enumerate(zip(block.columns, heads, text_columns, strict=True)):
        lopsided = [text for text in texts if column.is_number and " (" in text]  # too long for a line among others
        whole = (column.is_number and not lopsided) or (number == 0 and len(block.columns) < 7 and not wide)
        whole = whole and not any(len(text) > SHORT for text in texts)
        if column.is_number and (doubted or wide):  # intervals and many columns take the room that headings had
            whole_ones = [len(text) for text in texts if text not in lopsided]
            heads[number] = fill(head, max([*whole_ones, NARROW]), break_long_words=False)
        lines = [line for text in [heads[number], *texts] for line in text.split("\n")]
        longest = max((len(word) for line in lines for word in line.split()), default=0)
        least = max(map(len, lines)) if whole and column.is_number else min(longest, WORD)
        made.add_column(heads[number], justify="right" if column.is_number else "left", no_wrap=whole, overflow="fold",
                        min_width=least)  # fmt: skip
    for row in zip(*text_columns, strict=True):
        made.add_row(*map(Text, row))
    return made
