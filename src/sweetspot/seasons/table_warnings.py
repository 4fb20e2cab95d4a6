"""Warnings about a table of batted balls."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sweetspot.seasons.table_file import TableFile


@dataclass
class TableWarning:
    """Something to beware of.

    Parameters
    ----------
    name : a key of `WARNINGS`.
    table : number of the table, from 0.
    rows : the first of them, by the numbers that people find them by (`TableFile.numbers`).
    detail : what exactly; "" where the name says all.
    """

    name: str
    table: int
    count: int = 0
    rows: list[int] = field(default_factory=list)
    detail: str = ""


with Path(__file__).with_name("warnings.toml").open("rb") as file:
    _TEXTS: Mapping[str, Mapping[str, str]] = tomllib.load(file)
WARNINGS, CANNOT_TELL = _TEXTS["warnings"], _TEXTS["cannot_tell"]
"""Possible faults of a table of batted balls, by name; and the answers that such tables cannot give."""


def cannot_tell(tables: Sequence[TableFile]) -> tuple[str, ...]:
    """Return the answers that tables cannot give; tables with measured places along the bat can give the side."""
    measured = all(table.headings.has("axial_offset") for table in tables)
    return tuple(words for name, words in CANNOT_TELL.items() if name != "side" or not measured)
