"""The type that each column of some tables has when they are written as one: settled once, over all of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import polars as pl

from sweetspot.seasons.table_file import TableFile


def common_type(kinds: Iterable[pl.DataType]) -> pl.DataType:
    """Return the narrowest type that holds columns of several types; text where they are of different sorts.

    Numbers, truths among them, stay numbers, and days with and without a time stay days.

    >>> common_type([pl.Int64(), pl.Float64()]), common_type([pl.Int64(), pl.String()])
    (Float64, String)
    """
    several = [kind for kind in dict.fromkeys(kinds) if kind != pl.Null] or [pl.Float64()]
    if len(several) == 1:
        return several[0]
    numbers = all(kind.is_numeric() or kind == pl.Boolean for kind in several)
    days = all(kind == pl.Date or isinstance(kind, pl.Datetime) for kind in several)
    if not (numbers or days):
        return pl.String()
    frames = [pl.DataFrame(schema={"column": kind}) for kind in several]
    try:
        return pl.concat(frames, how="vertical_relaxed").schema["column"]
    except pl.exceptions.PolarsError:  # days of different time zones
        return pl.String()


def column_types(tables: Sequence[TableFile]) -> dict[str, pl.DataType]:
    """Return the type of every column of some tables, in the order in which they are met.

    Where tables differ, one in which the column holds nothing has no say: the text that an empty column of a CSV file
    is read as would make text of the others' numbers.
    """
    kinds: dict[str, list[pl.DataType]] = {}
    for table in tables:
        for name, kind in table.schema.items():
            kinds.setdefault(name, []).append(kind)
    differing = [name for name, several in kinds.items() if len(set(several)) > 1]
    witnesses: dict[str, list[pl.DataType]] = {name: [] for name in differing}
    for table in tables:
        schema = table.schema
        held = [name for name in differing if name in schema]
        nothing = table.holding_nothing(held) if held else set()
        for name in held:
            if name not in nothing:
                witnesses[name].append(schema[name])
    return {name: common_type(witnesses.get(name) or several) for name, several in kinds.items()}


def in_types(frame: pl.DataFrame, types: Mapping[str, pl.DataType]) -> list[pl.Series]:
    """Return a table's columns in settled types and their order; what it lacks is missing in every row.

    >>> rows = pl.DataFrame({"pitcher": [7, 8]})
    >>> [column.to_list() for column in in_types(rows, {"day": pl.String(), "pitcher": pl.String()})]
    [[None, None], ['7', '8']]
    """
    held = set(frame.columns)
    return [
        _in_type(frame[name], kind) if name in held else pl.Series(name, [None], kind).new_from_index(0, len(frame))
        for name, kind in types.items()
    ]


def _in_type(column: pl.Series, kind: pl.DataType) -> pl.Series:
    if column.dtype == kind:
        return column
    if column.dtype.is_nested() or column.dtype == pl.Object:
        texts = [None if value is None else str(value) for value in column.to_list()]
        return pl.Series(column.name, texts, pl.String)
    return column.cast(kind)
