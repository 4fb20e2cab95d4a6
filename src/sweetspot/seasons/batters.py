"""Who bats in tables, which tables a season wrote itself: what is known of the files before the work."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import polars as pl

from sweetspot.catalog.bats import load_bat
from sweetspot.errors import InputError, nearest_names
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.numerics.whole_parquet import reading_parquet
from sweetspot.seasons.ball_columns import UNKNOWN_BAT
from sweetspot.seasons.rows import tidy
from sweetspot.seasons.standings import GROUPS, PLAIN
from sweetspot.seasons.table_file import no_table, text_columns
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, names_one_of, read_headings
from sweetspot.tables.text_encoding import table_rows

ENDINGS = (".csv", ".parquet")
PLAINLY = 5
"""Columns behind the group's by which a table is known: every one has them."""


def table_stem(key: str) -> str:
    """Return the file names of a grouping's table.

    >>> table_stem("pitch_type")
    'pitch_types'
    """
    return GROUPS[key].replace(" ", "_")


def tables_of_balls(files: Sequence[Path], *, out: Path | None) -> tuple[list[Path], list[Path]]:
    """Return the files that are worth reading, and those that a season wrote itself."""
    if files and not any(path.exists() for path in files):
        raise no_table(files[0])  # before kernels are compiled
    ours = [path for path in files if _is_own(path)]
    others = [path for path in files if path not in ours]
    if ours and not others:
        raise InputError(f"{ours[0]} is a table that season itself wrote; give the tables of balls it was made from")
    written = {table_stem(key) + ending for key in GROUPS for ending in ENDINGS}
    for path in others:
        if out is not None and path.name in written and path.parent.resolve() == out.resolve():
            raise InputError(f"{path} is where season writes a table of its own; give another --out, or another name")
    return others, ours


def _is_own(path: Path) -> bool:
    """Return whether a file is called like a table of ours and begins with its columns; an unreadable one is not."""
    key = next((key for key in GROUPS if path.stem == table_stem(key) and path.suffix in ENDINGS), None)
    if key is None:
        return False
    try:
        frame = pl.scan_csv(path, n_rows=0) if path.suffix == ".csv" else pl.scan_parquet(path)
        names = frame.collect_schema().names()
    except (pl.exceptions.PolarsError, OSError):
        return False
    begins = (key, *PLAIN[:PLAINLY])
    return len(names) >= len(begins) and all(map(str.startswith, names, begins))


BATTER, NAME = "batter", "batter_name"
MOST_LISTED = 5
"""Batters that are named in a message."""


def require_batter(paths: Sequence[Path], batter: str, *, given: GivenColumns = NOTHING_GIVEN) -> None:
    """Refuse a player whom no table has; tables that cannot be read are left to who reads them."""
    found = _batters(paths, given)
    if found is None:
        return
    if not any(found.values()):
        raise InputError("no table has a column of batters, so there is no player to tell of")
    if batter not in found[BATTER] and batter not in found[NAME]:
        raise unknown_batter(batter, found[BATTER] if batter.isdigit() else found[NAME] or found[BATTER])


def strangers(paths: Sequence[Path], batters: Sequence[str], *, given: GivenColumns = NOTHING_GIVEN) -> list[str]:
    """Return those of some batters, numbers or names, that no table has.

    ``paths``, ``given``: as `require_batter` takes them.
    """
    found = _batters(paths, given)
    if found is None:
        return []
    names = {*found[BATTER], *found[NAME]}
    missing = [batter for batter in batters if batter not in names]
    if missing and len(missing) == len(batters):
        some = found[BATTER] if missing[0].isdigit() else found[NAME] or found[BATTER]
        raise InputError(
            f"no batter of the table of bats is in the tables: {_listed(missing)}. {nearest_names(missing[0], some)}"
        )
    return missing


def _listed(names: Sequence[str]) -> str:
    return ", ".join(map(repr, names[:MOST_LISTED])) + (
        f" and {len(names) - MOST_LISTED} more" if len(names) > MOST_LISTED else ""
    )


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


def unknown_batter(batter: str, batters: Sequence[str]) -> InputError:
    """Return the error that says that no batter has this number or name, and who there is."""
    return InputError(f"no batter {batter!r} in the tables. {nearest_names(batter, batters)}")


def _values(tables: Sequence[pl.LazyFrame], column: str) -> list[str]:
    if not tables:
        return []
    together = pl.concat([table.select(tidy(pl.col(column))) for table in tables])
    values: list[str] = together.unique().drop_nulls().collect(engine="streaming").to_series().sort().to_list()
    return values


WHO = ("batter", "batter_name", "player_name", "person")
"""Quantities that name the batter in a table of bats, the first that is there."""


def read_bats(path: Path) -> dict[str, str]:
    """Return the bat of each batter, a name of the catalogue or a file; "" is the bat of all others.

    Batters who are not in the table and have no row for all others count as batters with an unknown bat.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice="give a CSV table of bats")
    lines = table_rows(text, path, is_heading=lambda cells: names_one_of(cells, ("bat",)))
    _, headings = next(lines, (0, []))
    if not headings:
        raise InputError(f"{path} is empty; give a table with the columns batter and bat")
    columns = read_headings([name.strip() for name in headings], wanted=(*WHO, "bat"), file_name=str(path)).columns
    who = next((columns[name] for name in WHO if name in columns), None)
    if who is None or "bat" not in columns:
        missing = "bat" if who is not None else "batter"
        raise InputError(f"{path} has no column {missing}; it has: {', '.join(headings)}; give batter and bat")
    places = who.index, columns["bat"].index
    bats: dict[str, str] = {}
    faults = []
    for line, cells in lines:
        batter, bat = (cells[place].strip() if place < len(cells) else "" for place in places)
        if batter.removesuffix(".0").isdigit():  # as spreadsheets write it
            batter = batter.removesuffix(".0")
        try:
            _require_bat(bat, beside=bats.setdefault(batter, bat), whose=batter or "all others")
        except InputError as error:
            faults.append(f"line {line}: {error}")
    if faults:
        raise InputError(f"{path}, {'; '.join(faults)}")
    if not bats:
        raise InputError(f"{path} names no bat; give a row per batter")
    return {"": UNKNOWN_BAT} | bats


def _require_bat(bat: str, *, beside: str, whose: str) -> None:
    if not bat:
        raise InputError("no bat is given; give a name of the catalogue or a file")
    if bat != beside:
        raise InputError(f"{whose} has two bats, {beside} and {bat}")
    load_bat(bat)
