"""Files that people hand in: honest ones are read, bombs and devices cost no more than honest ones."""

from __future__ import annotations

import gzip
import os
import resource
from pathlib import Path

import pytest

from sweetspot.errors import InputError
from sweetspot.numerics.text_files import check_ordinary, harmless, read_text
from sweetspot.tables.text_encoding import table_rows

MEGABYTE = 1_000_000


def read(path: Path, most: int = MEGABYTE) -> str:
    return read_text(path, most=most, advice="make it shorter")


def test_honest_files(tmp_path: Path) -> None:
    for name, content in (
        ("plain", "näme,1\r\n".encode()),
        ("mark", b"\xef\xbb\xbf" + "näme,1\r\n".encode()),
        ("packed.gz", gzip.compress("näme,1\r\n".encode())),
        ("wide", "näme,1\r\n".encode("utf-16")),
    ):
        (tmp_path / name).write_bytes(content)
        assert read(tmp_path / name) == "näme,1\r\n"


@pytest.mark.parametrize("bomb", ["device", "gzip", "large"])
def test_bombs_are_refused(tmp_path: Path, bomb: str) -> None:
    """Within 200 MB: a device that never ends, 1 GB packed into 1 MB, a large file."""
    if bomb == "device":
        path = Path("/dev/zero")
    elif bomb == "gzip":
        path = tmp_path / "bomb.gz"
        path.write_bytes(gzip.compress(b"1,2,3\n" * (10 * MEGABYTE)) * 10)
    else:
        path = tmp_path / "large"
        with path.open("wb") as file:
            file.truncate(2**33)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(InputError, match=r"larger than 16 MB; make it shorter"):
        read(path, 16 * MEGABYTE)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 200_000  # kB


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"no gzip at all", "cannot be read: not a gzipped file"),
        (gzip.compress(b"cut off" * 500)[:30], "is damaged"),
        (gzip.compress(b"turned over" * 500)[:20] + b"\xff" * 40, "is damaged|cannot be read"),
        (gzip.compress(b"\xff\xff"), "not a text file in UTF-8"),
    ],
    ids=("no gzip", "cut off", "overwritten", "no text"),
)
def test_damaged_files(tmp_path: Path, content: bytes, said: str) -> None:
    path = tmp_path / "damaged.csv.gz"
    path.write_bytes(content)
    with pytest.raises(InputError, match=said):
        read(path)


def test_what_is_no_file(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "missing", tmp_path / ("x" * 2000), Path("a\0b"), tmp_path / "missing" / "x"):
        with pytest.raises(InputError, match="cannot be read") as caught:
            read(path)
        assert len(str(caught.value)) < 400
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDWR)  # so that neither end waits
    os.write(reader, b"x" * 100)
    with pytest.raises(InputError, match="larger"):
        read(pipe, 10)
    os.close(reader)


def test_a_spreadsheet_is_told_to_be_saved_as_text(tmp_path: Path) -> None:
    path = tmp_path / "swings.xlsx"
    path.write_bytes(b"PK\x03\x04 and what a workbook holds")
    with pytest.raises(InputError, match="is a spreadsheet, no text; save it as CSV, and make it shorter"):
        read(path)


def test_what_another_library_reads_is_an_ordinary_file(tmp_path: Path) -> None:
    path = tmp_path / "tap.wav"
    path.write_bytes(b"x" * 100)
    check_ordinary(path, most=100, advice="cut it")
    refused = {path: "larger than 9.9e-05 MB; cut it", tmp_path: "not an ordinary file; cut it",
               Path("/dev/zero"): "not an ordinary file", tmp_path / "no": "there is no such file"}  # fmt: skip
    for bad, said in refused.items():
        with pytest.raises(InputError, match=said):
            check_ordinary(bad, most=99, advice="cut it")


def test_tables_as_programs_of_different_countries_write_them() -> None:
    def rows(text: str) -> list[tuple[int, list[str]]]:
        return list(table_rows(text, Path("swings.csv"), is_heading=lambda cells: "speed" in cells))

    for separator in ";\t":
        assert rows(f"speed{separator}name\n\n66,5{separator}a,b\n") == [(1, ["speed", "name"]), (3, ["66.5", "a,b"])]
    assert rows('speed,name\n66.5,"a,b"\n') == [(1, ["speed", "name"]), (2, ["66.5", "a,b"])]
    assert rows("no,headings\n") == [(1, ["no", "headings"])]
    with pytest.raises(InputError, match=r"swings\.csv cannot be read as CSV text"):
        rows("speed\n" + "x" * 200_000)


def test_a_spreadsheet_takes_no_name_for_a_formula() -> None:
    for text in ("=HYPERLINK(1)", "+A1", "-A1", "@SUM(A1)", "\t=1", "\r=1"):
        assert harmless(text) == f"'{text}"
    for same in ("-1.5", "+2e3", "r161-ash", "", None, -2.0, 7):
        assert harmless(same) == same
