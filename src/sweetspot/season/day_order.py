"""Whether the dates of a table begin with the day or the month."""

from __future__ import annotations

from dataclasses import replace

import polars as pl

from sweetspot.season.headings import DAY_FIRST
from sweetspot.tables.headings import Headings

SLASHED = r"^\s*(\d{1,2})[/-](\d{1,2})[/-]\d{2,4}\b"
PEEK = 1000
"""Rows in which a date is looked for that may begin with the day."""


def with_days(headings: Headings, frame: pl.LazyFrame) -> tuple[Headings, list[str]]:
    """Return headings that know whether dates begin with the day, and what to say of dates that do not tell.

    One order holds for a whole table: 25/04/2024 anywhere in it says that 05/04/2024 is in April too.
    """
    column = headings.columns.get("date")
    if column is None or frame.collect_schema()[column.heading] not in (pl.String, pl.Categorical, pl.Enum):
        return headings, []
    text = pl.col(column.heading).cast(pl.String)
    if not frame.head(PEEK).select(text.str.contains(SLASHED).any()).collect().item():
        return headings, []
    numbers = [text.str.extract(SLASHED, group).cast(pl.Int32) for group in (1, 2)]
    ahead, behind = frame.select(text).unique().select(first=numbers[0].max(), second=numbers[1].max()).collect().row(0)
    if ahead > 12 >= behind:
        columns = {**headings.columns, "date": replace(column, unit=DAY_FIRST)}
        return replace(headings, columns=columns), []
    if behind > 12 >= ahead:
        return headings, []
    what = "may begin with month or day" if behind <= 12 else "begin with the month in some rows and the day in others"
    return headings, [f"dates in {column.heading} {what}; they are read as month, day, year"]
