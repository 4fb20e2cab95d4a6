"""A narrowed table is read as the file that it was made of."""

from __future__ import annotations

import gzip
from dataclasses import replace
from pathlib import Path

import polars as pl
import pytest

from sweetspot.errors import InputError
from sweetspot.player.swing_table import narrow_csv
from sweetspot.player.swings import read_swings
from tests.real_data import real_file

PLAIN = (
    "made by somebody\n\nbat_speed_mph,shoe size,exit_speed_mph,note\n"
    '60,42,85,"a, b"\n\nfast,42,90,x\n62,42,,x\n61,42,86\n' + "63,42,87,x\n" * 4
)


def alike(path: Path, folder: Path) -> str:
    """Check that both are read alike, and return the narrowed text."""
    text = narrow_csv(path)
    narrow = folder / "narrow.csv"
    narrow.write_text(text, encoding="utf-8")
    whole, short = (read_swings(one, length=0.84, pitch_speed=24.0) for one in (path, narrow))
    below = 1 if path.suffix == ".parquet" else 0
    assert [replace(one, row=one.row - below) for one in short.swings] == list(whole.swings)
    assert [(one.row, one.reason.partition(" ")[2][:5]) for one in short.bad_rows] == [
        (one.row, one.reason.partition(" ")[2][:5]) for one in whole.bad_rows
    ]
    assert (short.system, short.without_swing, short.first_day) == (whole.system, whole.without_swing, whole.first_day)
    return text


def test_rows_and_their_faults_stay_in_their_lines(tmp_path: Path) -> None:
    path = tmp_path / "swings.csv"
    path.write_text(PLAIN, encoding="utf-8")
    text = alike(path, tmp_path)
    assert "shoe" not in text and "note" not in text and len(text) < len(PLAIN)


@pytest.mark.parametrize("form", ["csv.gz", "parquet"])
def test_a_packed_file_and_parquet_are_narrowed_too(tmp_path: Path, form: str) -> None:
    path = tmp_path / f"swings.{form}"
    rows = {"bat_speed_mph": [60.5, 61.0, None, 62.0, 63.0, 64.0], "exit_speed_mph": [85.0] * 6, "shoe": ["x"] * 6}
    frame = pl.DataFrame(rows)
    if form == "parquet":
        frame.write_parquet(path)
    else:
        path.write_bytes(gzip.compress(frame.write_csv().encode()))
    assert "shoe" not in alike(path, tmp_path)


def test_a_statcast_export_is_known_as_one(tmp_path: Path) -> None:
    path = real_file("savant_2024-07-25_cease_nohitter_full118col.csv.gz")
    text = narrow_csv(path)
    (tmp_path / "narrow.csv").write_text(text, encoding="utf-8")
    batter = text.splitlines()[1].split(",")[text.splitlines()[0].split(",").index("batter")]
    read = [read_swings(one, length=0.84, pitch_speed=None, batter=batter) for one in (path, tmp_path / "narrow.csv")]
    assert read[0].system == read[1].system == "Statcast" and read[0].swings == read[1].swings


def test_what_holds_no_swings_is_told(tmp_path: Path) -> None:
    path = tmp_path / "milk.csv"
    path.write_text("milk,eggs\n1,2\n", encoding="utf-8")
    with pytest.raises(InputError, match="no column for bat speed or exit speed"):
        narrow_csv(path)
