"""Tables read in stretches: the same rows whatever the pieces of the file, each piece once."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import BinaryIO
from unittest.mock import patch

import polars as pl
import pytest

from sweetspot.errors import InputError, UnwritableError
from sweetspot.seasons import table_copies, table_file, table_reader
from sweetspot.seasons.season_table import analyse_season, season_setting
from sweetspot.seasons.survey import survey_tables
from sweetspot.seasons.table_copies import row_groups_of
from sweetspot.seasons.table_file import TableFile, open_table
from sweetspot.seasons.table_look import TableLook
from sweetspot.seasons.table_reader import TableReader
from tests.full_disk import no_file_beyond
from tests.seasons.conftest import files_of, made_up


@pytest.mark.parametrize("rows", [70, 100, 256, 400])
def test_row_groups_are_those_that_were_written(rows: int, tmp_path: Path) -> None:
    table = tmp_path / "table.parquet"
    made_up(400).write_parquet(table, row_group_size=rows, statistics="full")
    groups = tuple(group.rows for group in row_groups_of(table))
    assert groups == tuple(len(part) for part in made_up(400).iter_slices(rows))


def test_ranges_are_those_of_the_columns(tmp_path: Path) -> None:
    """Of no column that has nothing, or something that is not finite; a piece may have nothing."""
    nowhere, table = pl.int_range(pl.len()) < 150, tmp_path / "table.parquet"
    frame = made_up(400).with_columns(
        hc_x=pl.when(~nowhere).then("hc_x"),
        vz0=pl.lit(None, pl.Float64),
        hc_y=pl.when(pl.int_range(pl.len()) == 3).then(float("inf")).otherwise("hc_y"),
    )
    frame.write_parquet(table, row_group_size=100)
    ranges = open_table(table, staging=tmp_path).ranges
    assert {"launch_speed", "vx0", "plate_x", "hc_x"} < set(ranges) and not {"vz0", "hc_y", "events"} & set(ranges)
    assert all(ranges[name] == (frame[name].min(), frame[name].max()) for name in ranges)


def test_a_first_look_reads_no_measurement_that_is_surely_possible(tmp_path: Path) -> None:
    frame = made_up(400)
    frame.with_columns(az=pl.lit(-32000.0)).write_parquet(tmp_path / "table.parquet", row_group_size=100)
    wanted = TableLook(0, open_table(tmp_path / "table.parquet", staging=tmp_path)).wanted()
    assert {"exit_speed", "bat_speed", "velocity_y", "acceleration_z"} < set(wanted)
    assert not {"velocity_x", "acceleration_x", "plate_side"} & set(wanted)


@pytest.mark.parametrize("torn", [0, 4, 8, 200])
def test_no_footer_no_row_groups(torn: int, tmp_path: Path) -> None:
    whole, table = tmp_path / "whole.parquet", tmp_path / "table.parquet"
    made_up(30).write_parquet(whole)
    held = whole.read_bytes()
    size = int.from_bytes(held[-8:-4], "little")
    table.write_bytes(
        held[: -8 - size // 2] + (size // 2).to_bytes(4, "little") + b"PAR1" if torn == 200 else held[:torn]
    )
    assert row_groups_of(table) == ()


@pytest.mark.parametrize("group", [70, 100, 256, 1000])
@pytest.mark.parametrize("headings", [None, ["launch_speed", "events"]])
def test_parts_are_the_rows_of_the_table_and_each_piece_is_read_once(
    group: int, headings: list[str] | None, tmp_path: Path
) -> None:
    frame = made_up(1000)
    frame.write_parquet(tmp_path / "table.parquet", row_group_size=group)
    table = open_table(tmp_path / "table.parquet", staging=tmp_path)
    wanted = frame if headings is None else frame.select(headings)
    read: list[int] = []
    whole = TableFile.part

    def counted(self: TableFile, start: int, count: int, **asked: list[str] | None) -> pl.DataFrame:
        read.append(count)
        return whole(self, start, count, **asked)

    with patch.object(TableFile, "part", counted), patch.object(table_reader, "CELLS", 128 * wanted.width):
        reader = TableReader([table], part_rows=64)
        for start in range(0, 1000, 64):
            assert reader.part(0, start, 64, headings=headings).equals(wanted.slice(start, 64))
    assert sum(read) == 1000 and max(read) <= 128


def test_a_part_over_stretches_that_were_read_for_other_columns(tmp_path: Path) -> None:
    frame = made_up(1000)
    frame.write_parquet(tmp_path / "table.parquet", row_group_size=100)
    reader = TableReader([open_table(tmp_path / "table.parquet", staging=tmp_path)], part_rows=64)
    with patch.object(table_reader, "CELLS", 1):
        reader.part(0, 0, 64, headings=["launch_speed", "events", "launch_angle"])
        for start, count in ((0, 150), (100, 250)):
            part = reader.part(0, start, count, headings=["events", "launch_speed"])
            assert part.equals(frame.select("events", "launch_speed").slice(start, count))


@pytest.mark.parametrize("name", ["table.parquet", "table.csv"])
def test_wide_tables_are_worked_on_by_fewer_rows_with_the_same_answers(name: str, tmp_path: Path) -> None:
    frame = made_up(300).with_columns(**{f"more_{number}": pl.lit(number) for number in range(60)})
    frame.write_csv(tmp_path / name) if name.endswith("csv") else frame.write_parquet(tmp_path / name)
    setting = season_setting(contact=False)
    usual = analyse_season([tmp_path / name], setting=setting, folder=tmp_path / "usual")
    with patch.object(table_copies, "MOST_CELLS", 40 * frame.width):
        wide = analyse_season([tmp_path / name], setting=setting, folder=tmp_path / "wide")
    assert len(files_of(tmp_path / "usual" / "balls")) == 1 and len(files_of(tmp_path / "wide" / "balls")) == 8
    assert wide.balls().collect().equals(usual.balls().collect())
    assert wide.ledger().collect().equals(usual.ledger().collect())


def test_tables_in_large_row_groups_are_laid_out_anew_with_the_same_answers(tmp_path: Path) -> None:
    """Numbers, words, whole numbers, days and lists pass through; one row group of several is enough to need it."""
    few = {f"more_{number}": pl.lit(number) for number in range(60)}
    frame = made_up(300).with_columns(
        **few, word=pl.col("home_team").cast(pl.Categorical), day=pl.date(2024, 4, 1), two=pl.concat_list("batter", 2)
    )
    frame.write_parquet(tmp_path / "table.parquet", row_group_size=200)
    setting = season_setting(contact=False)
    usual = analyse_season([tmp_path / "table.parquet"], setting=setting, folder=tmp_path / "usual")
    read = []
    whole = table_copies.joined

    def counted(strips: Sequence[Path], start: int, count: int, **asked: list[str] | None) -> pl.DataFrame:
        read.append(len(strips))
        return whole(strips, start, count, **asked)

    sizes = [group.size for group in row_groups_of(tmp_path / "table.parquet")]
    with (
        patch.object(table_copies, "MOST_PACKED", max(sizes) - 1),
        patch.object(table_copies, "MOST_CELLS", 40 * frame.width),
        patch.object(table_file, "joined", counted),
    ):
        strips = analyse_season([tmp_path / "table.parquet"], setting=setting, folder=tmp_path / "strips")
    columns = 40 * frame.width // 300
    assert set(read) == {-(-frame.width // columns)} and min(sizes) < max(sizes)
    assert strips.balls().collect().equals(usual.balls().collect())
    assert strips.ledger().collect().equals(usual.ledger().collect())
    assert strips.survey.warnings == usual.survey.warnings


def test_what_the_writer_of_tables_does_not_name_the_system_does(tmp_path: Path) -> None:
    """A full disk shows as a fault of transport; one that is not full is not made one."""

    def broken(self: pl.LazyFrame, file: BinaryIO, **_: object) -> None:
        raise pl.exceptions.ComputeError("transport error")

    table = tmp_path / "table.csv"
    made_up(30).write_csv(table)
    with patch.object(pl.LazyFrame, "sink_parquet", broken):
        with pytest.raises(InputError, match="cannot be read as a table: transport error"):
            open_table(table, staging=tmp_path / "copies")
        with no_file_beyond(100_000), pytest.raises(UnwritableError, match="file too large; make room"):
            open_table(table, staging=tmp_path / "copies")


def test_no_room_to_lay_a_table_out_anew_is_not_the_table_s_fault(tmp_path: Path) -> None:
    table = tmp_path / "table.parquet"
    made_up(300).write_parquet(table)
    with (
        patch.object(table_copies, "MOST_PACKED", 1),
        no_file_beyond(1000),
        pytest.raises(
            UnwritableError, match=r"written: file too large; make room .* row groups of a few thousand rows"
        ),
    ):
        survey_tables([table], staging=tmp_path / "copies")
    assert not [path for path in (tmp_path / "copies").rglob("*") if path.is_file()]
