"""Large CSV files and Parquet: the same swings as from a small CSV file, by the columns and rows that are needed."""

from __future__ import annotations

import gzip
from dataclasses import replace
from pathlib import Path

import polars as pl
import pytest

from sweetspot.errors import InputError
from sweetspot.numerics.text_files import is_larger
from sweetspot.player import swing_table
from sweetspot.player.player_swing import PlayerSwing, columns_of
from sweetspot.player.swing_table import ScannedTable, open_swings
from sweetspot.player.swings import batters, read_swings

TEXT = """game_date,batter,launch_speed,launch_angle,bat_speed,release_speed,description,des
2024-04-01,660271,101.3,24,75.1,94.2,hit_into_play,"single, to left"
2024-04-01,592450,88.25,-3,71,95,hit_into_play,out
2024-04-02,660271,,,70.3,91,swinging_strike,
2024-04-02,660271,75.5,60,73.9,88.4,foul,
2024-04-03,660271,NA,,69,bad,swinging_strike,
2024-04-03,592450,93.1,12,72.5,90.2,hit_into_play,
"""


@pytest.fixture
def small(tmp_path: Path) -> Path:
    path = tmp_path / "small.csv"
    path.write_text(TEXT, encoding="utf-8")
    return path


def swings(path: Path, batter: str = "660271") -> tuple[tuple[PlayerSwing, ...], list[str]]:
    found = read_swings(path, length=0.84, batter=batter)
    return tuple(replace(one, row=0) for one in found.swings), [row.reason for row in found.bad_rows]


@pytest.mark.parametrize("packed", [False, True])
def test_a_large_csv_file_is_read_as_a_small_one(
    small: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, packed: bool
) -> None:
    expected, lines = swings(small), [one.row for one in read_swings(small, length=0.84, batter="660271").swings]
    large = tmp_path / ("large.csv.gz" if packed else "large.csv")
    large.write_bytes(gzip.compress(TEXT.encode()) if packed else TEXT.encode())
    monkeypatch.setattr(swing_table, "MOST_TABLE_BYTES", 100)
    assert isinstance(open_swings(large), ScannedTable)
    assert swings(large) == expected
    assert [one.row for one in read_swings(large, length=0.84, batter="660271").swings] == lines
    assert batters(large) == ("592450", "660271")
    assert swings(large) == expected  # from the rows of all, which are kept by now


@pytest.mark.parametrize("kind", [pl.Int64, pl.Float64, pl.String])
def test_parquet_is_read_as_csv_whatever_the_batters_are_written_as(
    small: Path, tmp_path: Path, kind: type[pl.DataType]
) -> None:
    path = tmp_path / "swings.parquet"
    frame = pl.read_csv(small, null_values=["NA"]).with_columns(pl.col("batter").cast(kind))
    frame.with_columns(pl.col("release_speed").replace("bad", None).cast(pl.Float64)).write_parquet(path)
    there, _ = swings(path)
    here = swings(small)[0]
    assert there[: len(here)] == here and len(there) == len(here) + 1  # the row that was no number is empty now
    assert batters(path) == ("592450", "660271")
    assert read_swings(path, length=0.84, batter="592450").first_day is not None


def test_only_what_is_needed_is_read(small: Path, tmp_path: Path) -> None:
    """A column that means nothing and rows of others are not among the cells."""
    path = tmp_path / "swings.parquet"
    pl.read_csv(small, infer_schema=False).write_parquet(path)
    table = open_swings(path)
    columns = columns_of(table.headings, file_name="swings.parquet")
    rows = table.rows(columns, "592450")
    assert [line for line, _ in rows] == [2, 6]
    assert all(len(cells) == table.width(columns) == 7 for _, cells in rows)
    assert columns.passed == ("des",)
    with pytest.raises(InputError, match="is not in"):
        read_swings(path, length=0.84, batter="1")
    with pytest.raises(InputError, match="of 2 batters"):
        read_swings(path, length=0.84)


def test_what_is_no_table_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "broken.parquet"
    broken.write_bytes(b"PAR1 and no more")
    with pytest.raises(InputError, match="no whole Parquet file"):
        batters(broken)
    with pytest.raises(InputError, match="is not a file"):
        batters(tmp_path / "none.parquet")
    bomb = tmp_path / "bomb.csv.gz"
    bomb.write_bytes(gzip.compress(b"0" * 3_000_000))
    with pytest.raises(InputError, match="unpacks to more than"):
        is_larger(bomb, most=1000)
    monkeypatch.setattr(swing_table, "MOST_TABLE_BYTES", 100)
    above = tmp_path / "above.csv"
    above.write_text("Player: Ann\n\nbat_speed_mph;batter\n" + 20 * "70,5;Ann\n", encoding="utf-8")
    table = open_swings(above)
    assert table.rows(columns_of(table.headings, file_name="above.csv"))[0] == (4, ["70.5", "Ann"])
    preamble = tmp_path / "preamble.csv"
    preamble.write_text("Player: Ann\n" + 20 * "a,b,c\n", encoding="utf-8")
    with pytest.raises(InputError, match="none of its first lines names a column"):
        batters(preamble)
