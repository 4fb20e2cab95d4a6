"""What to beware of in some tables: each thing once, with the tables that it concerns."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from sweetspot.seasons.survey import Survey
from sweetspot.seasons.table_file import TableWarning

SEVERAL = ("part off", "headings", "unit", "swapped", "empty column", "not measured")
"""Warnings that one table may have several of: they are apart by what exactly is the matter."""
DETAILS = 3
"""Details of one caution that are listed, where its tables differ."""
NUMBER = re.compile(r"\d[\d.,]*")


@dataclass(frozen=True)
class AffectedTable:
    """A table that a caution concerns.

    ``rows``: how many. ``first_rows``: the first of them; none: the table as a whole. ``detail``: what exactly; ""
    where the caution's name says all.
    """

    file: str
    rows: int
    first_rows: Sequence[int]
    detail: str


@dataclass(frozen=True)
class Caution:
    """Something to beware of, and the tables in which it is; see `TableWarning`."""

    name: str
    tables: tuple[AffectedTable, ...]

    @property
    def rows(self) -> int:
        """Number of rows of all tables."""
        return sum(table.rows for table in self.tables)

    @property
    def detail(self) -> str:
        """What exactly, of each of the first tables where these differ in it; "" where the name says all."""
        details: dict[str, str] = {}
        for table in self.tables:
            if table.detail:
                details.setdefault(table.detail, Path(table.file).name)
        if len(details) == 1:
            return next(iter(details))
        every = [f"{file}: {detail}" for detail, file in details.items()]
        return "; ".join(every[:DETAILS]) + ("; …" if len(every) > DETAILS else "")


def cautions_of(survey: Survey) -> tuple[Caution, ...]:
    """Return the cautions of some tables in the order in which they are met; the same of several tables is one."""
    found: dict[tuple[str, str], list[AffectedTable]] = {}
    for warning in survey.warnings:
        table = AffectedTable(str(survey.tables[warning.table].path), warning.count, warning.rows, warning.detail)
        found.setdefault(_kind(warning), []).append(table)
    return tuple(Caution(name, tuple(tables)) for (name, _), tables in found.items())


def _kind(warning: TableWarning) -> tuple[str, str]:
    """Name the kind of a warning: its name, and of some the words of the detail, whatever its numbers."""
    return warning.name, NUMBER.sub("", warning.detail) if warning.name in SEVERAL else ""


def cautioned_files(cautions: Iterable[Caution]) -> set[str]:
    """Return the files of the rows that cautions name."""
    return {table.file for caution in cautions for table in caution.tables if table.first_rows}
