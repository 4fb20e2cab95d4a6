"""Who bats in tables, read from the columns of batters alone: a player asked for is known or not before the work."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import polars as pl

from sweetspot.errors import InputError, nearest_names
from sweetspot.season.rows import tidy
from sweetspot.season.table_file import text_columns

BATTER, NAME = "batter", "batter_name"


def require_batter(paths: Sequence[Path], batter: str, *, given: Mapping[str, str] | None = None) -> None:
    """Refuse a player whom no table has; tables that cannot be read are left to who reads them.

    Parameters
    ----------
    paths : tables, CSV or Parquet.
    batter : number or name.
    given : heading by quantity, as `headings_of` takes it.

    Raises
    ------
    InputError
        for such a player, with the nearest ones, and where tables have no column of batters.
    """
    tables = []
    for path in paths:
        try:
            tables.append(text_columns(path, (BATTER, NAME), given=given))
        except InputError:
            continue
    if not tables:
        return
    try:
        found = {name: _values([table for table in tables if name in table.collect_schema()], name)
                 for name in (BATTER, NAME)}  # fmt: skip
    except (pl.exceptions.PolarsError, OSError):  # a damaged table, which is told of when it is read
        return
    if not found[BATTER]:
        raise InputError("no table has a column of batters, so there is no player to tell of")
    if batter not in found[BATTER] and batter not in found[NAME]:
        raise unknown_batter(batter, found[BATTER] if batter.isdigit() else found[NAME] or found[BATTER])


def unknown_batter(batter: str, known: Sequence[str]) -> InputError:
    """Return the error that says that no batter has this number or name, and who there is."""
    return InputError(f"no batter {batter!r} in the tables. {nearest_names(batter, known)}")


def _values(tables: Sequence[pl.LazyFrame], column: str) -> list[str]:
    if not tables:
        return []
    together = pl.concat([table.select(tidy(pl.col(column))) for table in tables])
    values: list[str] = together.unique().drop_nulls().collect(engine="streaming").to_series().sort().to_list()
    return values
