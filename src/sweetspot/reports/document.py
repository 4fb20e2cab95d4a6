"""An answer as a small tree, built once: headline, sentences, tables of quantities, figures, notes.

Terminal, HTML, notebook, JSON and CSV are renderers of this tree, in the units of any reader. Nothing outside them
puts a number beside its unit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Any, Literal

from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.reports.quantities import NOTHING, SYSTEMS, US, Reader, System
from sweetspot.reports.sentences import Sentence, Slot, Words, read

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Marked:
    """Words with a mark: the name of a sweet spot gives its coloured dot, "hit" and "missed" their colours."""

    words: Words
    mark: str


@dataclass(frozen=True)
class Linked:
    """Words that lead somewhere: a web address, or "#source-KEY" on the same page."""

    words: Words
    target: str
    note: Words = ""


@dataclass(frozen=True)
class Cited:
    """A work of the bibliography: a terminal names it by its key, a page by who wrote it and when."""

    key: str
    year: str = ""
    note: str = ""

    @property
    def words(self) -> str:
        """The key, with year and note."""
        return ", ".join(part for part in (f"{self.key} {self.year}".strip(), self.note) if part)


Cell = Words | Slot | Marked | Linked | Cited | float | None
"""Of a table: words, a number with its own scale, a number in the column's scale, or nothing."""


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Parameters
    ----------
    heading : what it shows; the unit of its scale is put behind it.
    scale : of its plain numbers; "" for words and for cells that carry their own.
    digits, sign : of its plain numbers.
    right : whether cells that carry their own scale stand to the right.
    """

    heading: Words
    scale: str = ""
    digits: int | None = None
    sign: bool = False
    right: bool = False

    def head(self, reader: Reader) -> str:
        """Return the heading as a reader sees it."""
        unit = reader.unit(self.scale) if self.scale else ""
        return f"{read(self.heading, reader)} {unit}".strip()

    def shown(self, cell: Cell, reader: Reader) -> str:
        """Return a cell as a reader sees it."""
        if cell is None:
            return NOTHING
        if isinstance(cell, (Slot, Sentence)):
            return cell.read(reader)
        if isinstance(cell, (Marked, Linked, Cited)):
            return read(cell.words, reader)
        if isinstance(cell, str):
            return cell
        return reader.number(cell, self.scale, digits=self.digits, sign=self.sign)

    @property
    def is_number(self) -> bool:
        """Whether its cells are numbers and stand to the right."""
        return bool(self.scale) or self.right


def table_head(heads: str) -> list[Column]:
    """Return columns by their heads between bars, with ": scale, digits, sign" or, of other numbers, ">" behind them.

    >>> [column.scale for column in table_head("bat | mass: mass, 1 | change: speed, sign | limit >")]
    ['', 'mass', 'speed', '']
    """
    return [_column(head) for head in heads.split(" | ")]


def _column(head: str) -> Column:
    heading, _, shown_as = head.partition(": ")
    scale, *options = shown_as.split(", ")
    digits = next((int(option) for option in options if option.isdecimal()), None)
    return Column(heading.removesuffix(">").rstrip(), scale, digits, "sign" in options, heading.endswith(">"))


@dataclass(frozen=True)
class Table:
    """A table whose first column names its rows; ``name`` is its style on a page."""

    title: Words
    columns: Sequence[Column]
    rows: Sequence[Sequence[Cell]]
    name: str = ""


def values_table(rows: Sequence[Sequence[Cell]], title: Words = "") -> Table:
    """Return a table of names and values."""
    return Table(title, [Column(""), Column("value", right=True)], rows)


@dataclass(frozen=True)
class Paragraph:
    """Running text: the answer itself, a note in small print, or a warning."""

    words: Words
    kind: Literal["text", "note", "warning"] = "text"


@dataclass(frozen=True)
class Bullets:
    """A list of short texts."""

    items: Sequence[Words]


@dataclass(frozen=True)
class Question:
    """A question that people ask, with its answer."""

    question: Words
    answer: Words


@dataclass(frozen=True)
class Cards:
    """The numbers asked for first, large on a page: (number, what it is)."""

    cards: Sequence[tuple[Words, Words]]


@dataclass(frozen=True)
class Picture:
    """A figure, drawn when a renderer needs it.

    Parameters
    ----------
    name : its anchor on a page.
    draw : makes it for a reader.
    label : what it shows, for people who do not see it.
    caption : below it.
    sheet : makes it for a printed sheet, in whose room its letters stay readable; None: as it is.
    """

    name: str
    draw: Callable[[Reader], Figure]
    label: Words
    caption: Words = ""
    sheet: Callable[[Reader], Figure] | None = None


def drawn(figure: str, *answer: Any, **options: Any) -> Callable[[Reader], Figure]:
    """Return a figure that a renderer draws for its reader, by a function named "module:name" that is loaded then."""
    return partial(_draw, figure, answer, options)


def _draw(figure: str, answer: Sequence[Any], options: Mapping[str, Any], reading: Reader) -> Figure:
    made: Figure = resolve_name(figure)(*answer, reading=reading, **options)
    return made


@dataclass(frozen=True)
class SourceList:
    """The works behind an answer, by their keys in the bibliography."""

    keys: Sequence[str]


@dataclass(frozen=True)
class Section:
    """A part with its heading; ``name`` is its anchor, ``level`` that of its heading."""

    name: str
    title: Words
    blocks: Sequence[Block]
    level: Literal[2, 3] = 2


Block = Paragraph | Bullets | Question | Cards | Table | Picture | SourceList | Section


@dataclass(frozen=True)
class Document(ShownInNotebooks):
    """An answer.

    Parameters
    ----------
    name : of its files: report, play, compare, ...
    title, subtitle : its first lines.
    blocks : the answer; a terminal leaves out cards and pictures.
    data : the answer for other programs: SI, a unit in every name.
    rows : the same as columns of equal length, for CSV.
    reader : who reads unless somebody says otherwise: the sport's people.
    kind : what it is, over the title of a page.
    details : tables that a terminal shows too, and a page when it is opened.
    appendix : what a page shows when it is opened and a terminal with --details, or what makes it.
    drawing : the picture that is written as a file of its own.
    passed : whether what was checked holds.
    made_for : the person it is for; "": not given.
    made : when, and what it was made from: the head of a page.
    attachments : further files that go along with it, by name: made for a reader.
    """

    name: str
    title: Words
    blocks: Sequence[Block]
    data: Mapping[str, Any]
    rows: Mapping[str, Sequence[Any]]
    subtitle: Words = ""
    reader: Reader = US
    kind: str = ""
    details: Sequence[Block] = ()
    appendix: Sequence[Block] | Callable[[], Sequence[Block]] = ()
    drawing: Picture | None = None
    passed: bool = True
    made_for: str = ""
    made: str = ""
    attachments: Mapping[str, Callable[[Reader], bytes]] = field(default_factory=dict)

    @cached_property
    def appended(self) -> Sequence[Block]:
        """The appendix, made when first asked for."""
        return self.appendix() if callable(self.appendix) else self.appendix

    @property
    def unfolded(self) -> Document:
        """The same with details and appendix among its blocks."""
        return replace(self, blocks=[*self.blocks, *self.details, *self.appended], details=(), appendix=())

    def reader_of(self, system: System | None) -> Reader:
        """Return who reads: of a system of units, or the sport's people where none is named."""
        return self.reader if system is None else SYSTEMS[system]


def one_row(data: Mapping[str, object]) -> dict[str, list[object]]:
    """Return values as columns of one row."""
    return {name: [value] for name, value in data.items()}


def as_columns(rows: Sequence[Mapping[str, object]]) -> dict[str, list[object]]:
    """Return rows as columns, None where a row lacks a key; no columns where there are no rows."""
    return {name: [row.get(name) for row in rows] for name in dict.fromkeys(name for row in rows for name in row)}
