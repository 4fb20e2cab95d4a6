"""What --resume keeps is byte for byte what the very same tables gave; anything else is computed anew."""

from __future__ import annotations

from pathlib import Path

import polars as pl
import pytest

from sweetspot.seasons.season_table import analyse_season, season_setting
from tests.seasons.conftest import files_of, made_up

SETTING = season_setting(contact=False, threads=1)


def answered(table: Path, folder: Path, *, resume: bool = False) -> dict[str, str]:
    analyse_season([table], setting=SETTING, folder=folder, resume=resume)
    return files_of(folder)


@pytest.mark.parametrize("name", ["table.csv", "table.parquet"])
def test_a_table_mended_in_its_middle_is_computed_anew(name: str, tmp_path: Path) -> None:
    """The same rows, bytes and name; what changed lies more than 64 kB from both ends."""
    table = tmp_path / name
    frame = made_up(3000, seed=3).with_columns(launch_speed=pl.lit(90.0))
    middle = pl.int_range(pl.len()).is_between(1400, 1600)
    mended = frame.with_columns(launch_speed=pl.when(middle).then(60.0).otherwise(90.0))

    def written(one: pl.DataFrame) -> int:
        one.write_csv(table) if name.endswith("csv") else one.write_parquet(table, compression="uncompressed")
        return table.stat().st_size

    size = written(frame)
    assert size > 4 << 16
    first = answered(table, tmp_path / "out")
    assert name.endswith("parquet") or written(mended) == size
    written(mended)
    resumed = answered(table, tmp_path / "out", resume=True)
    assert resumed != first and resumed == answered(table, tmp_path / "fresh")


@pytest.mark.parametrize("part", ["balls", "ledger", "counted"])
def test_answers_with_one_wrong_byte_are_computed_anew(part: str, tmp_path: Path) -> None:
    """At the end of the numbers of the first column; a Parquet reader notices nothing."""
    made_up(300, seed=5).write_parquet(table := tmp_path / "table.parquet")
    whole = answered(table, tmp_path / "out")
    (file,) = (tmp_path / "out" / part).glob("*.parquet")
    content = bytearray(file.read_bytes())
    content[len(content) // 3] ^= 1
    file.write_bytes(content)
    assert files_of(tmp_path / "out") != whole
    assert answered(table, tmp_path / "out", resume=True) == whole


def test_whole_answers_are_kept(tmp_path: Path) -> None:
    made_up(300, seed=5).write_csv(table := tmp_path / "table.csv")
    whole = answered(table, tmp_path / "out")
    times = {path: path.stat().st_mtime_ns for path in (tmp_path / "out").rglob("[0-9]*.*")}
    assert len(times) == 4  # three parts and the note that they are done
    assert answered(table, tmp_path / "out", resume=True) == whole
    assert {path: path.stat().st_mtime_ns for path in (tmp_path / "out").rglob("[0-9]*.*")} == times
