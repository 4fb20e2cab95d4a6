"""A season's tables of players, pitchers, clubs and so on as CSV and Parquet."""

from __future__ import annotations

import io
from pathlib import Path

import polars as pl

from sweetspot.answers.season import SeasonAnswer
from sweetspot.numerics.text_files import harmless
from sweetspot.reports.files import write_all
from sweetspot.seasons.batters import table_stem


def write_tables(answer: SeasonAnswer, folder: Path) -> list[str]:
    """Write each grouping's table as CSV and as Parquet and return the files' names.

    Raises
    ------
    InputError
        when one cannot be written.
    """
    contents: dict[Path, bytes] = {}
    for key in answer.standings:
        table = answer.to_frame(answer.question.system, key=key)
        stem = table_stem(key)
        texts = [column.name for column in table if column.dtype == pl.String]
        harmless_table = table.with_columns(pl.col(texts).map_elements(harmless, return_dtype=pl.String))
        contents[folder / f"{stem}.csv"] = harmless_table.write_csv().encode()
        held = io.BytesIO()
        table.write_parquet(held)
        contents[folder / f"{stem}.parquet"] = held.getvalue()
    if contents:
        write_all(contents)
    return sorted(path.name for path in contents)
