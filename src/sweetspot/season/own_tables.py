"""The tables of players, clubs and so on that a season writes: what their files are called, and how to know them again.

They lie beside the balls in the folder that was asked for, and are no balls themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import polars as pl

from sweetspot.errors import InputError
from sweetspot.season.standings import GROUPS, PLAIN
from sweetspot.season.table_file import no_table

ENDINGS = (".csv", ".parquet")
PLAINLY = 5
"""Columns behind the group's by which a table is known: every one has them."""


def table_stem(key: str) -> str:
    """Return what the files of a grouping's table are called.

    >>> table_stem("pitch_type")
    'pitch_types'
    """
    return GROUPS[key].replace(" ", "_")


def tables_of_balls(files: Sequence[Path], *, out: Path | None) -> tuple[list[Path], list[Path]]:
    """Return the files that are worth reading, and those that a season wrote itself.

    Parameters
    ----------
    files : tables.
    out : folder where answers are to go.

    Raises
    ------
    InputError
        when nothing is there or left, or answers would be written over one of the tables.
    """
    if files and not any(path.exists() for path in files):
        raise no_table(files[0])  # before kernels are compiled
    own = [path for path in files if _is_own(path)]
    others = [path for path in files if path not in own]
    if own and not others:
        raise InputError(f"{own[0]} is a table that season itself wrote; give the tables of balls it was made from")
    written = {table_stem(key) + ending for key in GROUPS for ending in ENDINGS}
    for path in others:
        if out is not None and path.name in written and path.parent.resolve() == out.resolve():
            raise InputError(f"{path} is where season writes a table of its own; give another --out, or another name")
    return others, own


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
