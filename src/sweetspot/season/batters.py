"""Who bats in tables, read from the columns of batters alone: a player asked for is known or not before the work."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import polars as pl

from sweetspot.errors import InputError, nearest_names
from sweetspot.numerics.whole_parquet import reading_parquet
from sweetspot.season.rows import tidy
from sweetspot.season.table_file import text_columns
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns

BATTER, NAME = "batter", "batter_name"
MOST_LISTED = 5
"""Batters that are named in a message."""


def require_batter(paths: Sequence[Path], batter: str, *, given: GivenColumns = NOTHING_GIVEN) -> None:
    """Refuse a player whom no table has; tables that cannot be read are left to who reads them.

    Parameters
    ----------
    paths : tables, CSV or Parquet.
    batter : number or name.
    given : what a person says of the columns.

    Raises
    ------
    InputError
        for such a player, with the nearest ones, and where tables have no column of batters.
    """
    found = _batters(paths, given)
    if found is None:
        return
    if not any(found.values()):
        raise InputError("no table has a column of batters, so there is no player to tell of")
    if batter not in found[BATTER] and batter not in found[NAME]:
        raise unknown_batter(batter, found[BATTER] if batter.isdigit() else found[NAME] or found[BATTER])


def strangers(paths: Sequence[Path], batters: Sequence[str], *, given: GivenColumns = NOTHING_GIVEN) -> list[str]:
    """Return those of some batters, numbers or names, that no table has.

    Parameters
    ----------
    paths, given : as `require_batter` takes them.

    Raises
    ------
    InputError
        when the tables have none of them: then their bats are nobody's.
    """
    found = _batters(paths, given)
    if found is None:
        return []
    known = {*found[BATTER], *found[NAME]}
    missing = [batter for batter in batters if batter not in known]
    if missing and len(missing) == len(batters):
        some = found[BATTER] if missing[0].isdigit() else found[NAME] or found[BATTER]
        raise InputError(f"no batter of the table of bats is in the tables: {_listed(missing)}. "
                         f"{nearest_names(missing[0], some)}")  # fmt: skip
    return missing


def _listed(names: Sequence[str]) -> str:
    return ", ".join(map(repr, names[:MOST_LISTED])) + (f" and {len(names) - MOST_LISTED} more"
                                                        if len(names) > MOST_LISTED else "")  # fmt: skip


def _batters(paths: Sequence[Path], given: GivenColumns) -> dict[str, list[str]] | None:
    """Return numbers and names of the batters of some tables; None where none can be read, or one only in part."""
    with TemporaryDirectory(prefix="sweetspot-batters-") as folder:
        tables = []
        for number, path in enumerate(paths):
            with suppress(InputError):
                tables.append(text_columns(path, (BATTER, NAME), staging=Path(folder) / str(number), given=given))
        if not tables:
            return None
        with suppress(InputError), reading_parquet(paths[0]):  # a damaged table is reported where it is read
            return {
                name: _values([table for table in tables if name in table.collect_schema()], name)
                for name in (BATTER, NAME)
            }
    return None


def unknown_batter(batter: str, known: Sequence[str]) -> InputError:
    """Return the error that says that no batter has this number or name, and who there is."""
    return InputError(f"no batter {batter!r} in the tables. {nearest_names(batter, known)}")


def _values(tables: Sequence[pl.LazyFrame], column: str) -> list[str]:
    if not tables:
        return []
    together = pl.concat([table.select(tidy(pl.col(column))) for table in tables])
    values: list[str] = together.unique().drop_nulls().collect(engine="streaming").to_series().sort().to_list()
    return values
