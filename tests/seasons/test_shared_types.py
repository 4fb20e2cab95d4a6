"""Parts of one run have the same columns of the same types, whatever tables they come from."""

from __future__ import annotations

from collections.abc import Callable
from datetime import date
from pathlib import Path

import polars as pl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from polars.testing import assert_frame_equal

from sweetspot.seasons.season_table import analyse_season, season_setting
from sweetspot.seasons.shared_types import common_type, in_types
from tests.seasons.conftest import made_up

COUNT = 60


def _tables(write: Callable[..., Path]) -> list[Path]:
    """Return tables as clubs write them: numbers here and words there, a column empty, missing, or elsewhere."""
    plain = made_up(COUNT).with_columns(
        release_spin_rate=pl.Series(range(2000, 2000 + COUNT)), sprint=pl.lit(27.5), fielder=pl.lit(7)
    )
    other = made_up(COUNT, seed=2).with_columns(
        game_pk=pl.col("game_pk") + 5000, release_spin_rate=pl.lit(2100.5), sprint=pl.lit(None), fielder=pl.lit("LF")
    )
    later = made_up(COUNT, seed=3).with_columns(
        game_pk=pl.col("game_pk") + 9000, game_date=pl.lit(date(2024, 5, 1)), surface=pl.lit("turf")
    )
    return [write("a.csv", plain), write("b.csv", other.drop("umpire")), write("c.parquet", later)]


def test_all_parts_are_read_back_as_one_table(table: Callable[..., Path], tmp_path: Path) -> None:
    season = analyse_season(_tables(table), setting=season_setting(contact=False), folder=tmp_path / "out")
    files = sorted((tmp_path / "out" / "balls").glob("*.parquet"))
    schemas = [pl.read_parquet_schema(file) for file in files]
    assert len(files) == 3 and schemas[0] == schemas[1] == schemas[2]
    together = pl.read_parquet(tmp_path / "out" / "balls" / "*.parquet")
    assert_frame_equal(together, season.balls().collect())
    assert together.schema["release_spin_rate"] == together.schema["sprint"] == pl.Float64
    assert together.schema["fielder"] == together.schema["game_date"] == pl.String
    spins = together.group_by("table").agg(pl.col("release_spin_rate").mean()).sort("table")
    assert spins["release_spin_rate"].to_list() == [2000 + (COUNT - 1) / 2, 2100.5, None]
    assert together.filter(table="b.csv")["umpire"].null_count() == COUNT
    assert together["surface"].drop_nulls().to_list() == ["turf"] * COUNT


def test_the_columns_of_one_table_stay_as_they_are(table: Callable[..., Path], tmp_path: Path) -> None:
    frame = made_up(COUNT).with_columns(day=pl.lit(date(2024, 5, 1)), some=pl.lit([1, 2]))
    season = analyse_season(
        [table("only.parquet", frame)], setting=season_setting(contact=False), folder=tmp_path / "out"
    )
    assert_frame_equal(season.balls().select(frame.columns).collect(), frame)


KINDS = st.sampled_from([
    pl.Int64(), pl.Int32(), pl.Float64(), pl.Float32(), pl.Boolean(), pl.String(), pl.Date(), pl.Datetime("us"),
    pl.Datetime("us", "UTC"), pl.Null(), pl.List(pl.Int64()), pl.Categorical(),
])  # fmt: skip


@given(st.lists(KINDS, min_size=1, max_size=4))
def test_every_column_goes_into_the_type_that_several_share(kinds: list[pl.DataType]) -> None:
    shared = common_type(kinds)
    assert shared == common_type(kinds[::-1]) and shared == common_type([*kinds, shared])
    for kind in kinds:
        column = pl.Series("column", [None], dtype=kind)
        (found,) = in_types(column.to_frame(), {"column": shared})
        assert found.dtype == shared and found.to_list() == [None]


@pytest.mark.parametrize(("values", "kind", "expected"), [
    ([1, None], pl.Float64(), [1.0, None]), ([1, None], pl.String(), ["1", None]),
    ([date(2024, 5, 1)], pl.String(), ["2024-05-01"]), ([[1, 2], None], pl.String(), ["[1, 2]", None]),
    ([True, None], pl.Int64(), [1, None]),
])  # fmt: skip
def test_values_keep_what_they_say(values: list[object], kind: pl.DataType, expected: list[object]) -> None:
    (found,) = in_types(pl.DataFrame({"column": values}), {"column": kind})
    assert found.to_list() == expected
