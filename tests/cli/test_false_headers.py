"""Numbers in the headers of pictures, packed tables and Parquet, at both ends of what they can say: no memory is taken.

Those of sounds are in test_hostile_files.py, those of drawings in test_hostile_drawings.py.
"""

from __future__ import annotations

import gzip
import importlib
import io
import resource
import struct
import time
import zlib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
import polars as pl
import pytest
from PIL import Image

from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.errors import InputError
from sweetspot.player.swings import read_swings
from sweetspot.seasons.table_file import open_table

MOST, LONGEST = 250, 60.0
"""MB, and s of the processor: guards against what a header says, no speeds."""
SIZE = (64, 48)


def picture(kind: str) -> bytes:
    noise = np.random.default_rng(1).integers(0, 255, (*SIZE[::-1], 3), dtype=np.uint8)
    held = io.BytesIO()
    options: dict[str, object] = {"lossless": True} if kind == "WEBP" else {}
    Image.fromarray(noise).save(held, kind, **options)
    return held.getvalue()


def after(mark: bytes, skip: int, size: int) -> Callable[[bytes], slice]:
    """Return where a number of so many bytes stands, so far behind a mark."""
    return lambda data: slice(data.index(mark) + len(mark) + skip, data.index(mark) + len(mark) + skip + size)


def at(begin: int, size: int) -> Callable[[bytes], slice]:
    return lambda _: slice(begin, begin + size)


def entry(tag: int) -> Callable[[bytes], slice]:
    """Return where a TIFF's directory has the value of a tag (little-endian, no more than four bytes)."""

    def place(data: bytes) -> slice:
        (first,) = struct.unpack_from("<I", data, 4)
        (count,) = struct.unpack_from("<H", data, first)
        entries = [first + 2 + 12 * number for number in range(count)]
        found = next(where for where in entries if struct.unpack_from("<H", data, where) == (tag,))
        return slice(found + 8, found + 12)

    return place


NUMBERS: dict[tuple[str, str], Callable[[bytes], slice]] = {
    ("PNG", "width"): at(16, 4), ("PNG", "height"): at(20, 4), ("PNG", "bits"): at(24, 1),
    ("PNG", "colours"): at(25, 1),
    ("PNG", "length of the data"): lambda data: slice(data.index(b"IDAT") - 4, data.index(b"IDAT")),
    ("JPEG", "height"): after(b"\xff\xc0", 3, 2), ("JPEG", "width"): after(b"\xff\xc0", 5, 2),
    ("JPEG", "bits"): after(b"\xff\xc0", 2, 1), ("JPEG", "components"): after(b"\xff\xc0", 7, 1),
    ("JPEG", "length of the frame"): after(b"\xff\xc0", 0, 2),
    ("BMP", "width"): at(18, 4), ("BMP", "height"): at(22, 4), ("BMP", "bits"): at(28, 2), ("BMP", "offset"): at(10, 4),
    ("BMP", "packing"): at(30, 4), ("BMP", "colours"): at(46, 4), ("BMP", "size of the header"): at(14, 4),
    ("TIFF", "width"): entry(256), ("TIFF", "length"): entry(257), ("TIFF", "packing"): entry(259),
    ("TIFF", "rows in a strip"): entry(278), ("TIFF", "samples"): entry(277), ("TIFF", "first directory"): at(4, 4),
    ("WEBP", "sizes"): after(b"VP8L", 5, 4), ("WEBP", "length"): at(4, 4),
    ("WEBP", "length of the data"): after(b"VP8L", 0, 4),
}  # fmt: skip
"""Where a header's number stands in a picture, by format and what it is."""
VALUES: dict[str, Callable[[int], bytes]] = {
    "nothing": bytes,
    "one": lambda size: (1).to_bytes(size, "little"),
    "one, big-endian": lambda size: (1).to_bytes(size, "big"),
    "the most": lambda size: b"\xff" * size,
    "the most with a sign": lambda size: b"\xff" * (size - 1) + b"\x7f",
    "the most with a sign, big-endian": lambda size: b"\x7f" + b"\xff" * (size - 1),
    "ten thousand": lambda size: (min(10_900, 256**size - 1)).to_bytes(size, "little"),
    "ten thousand, big-endian": lambda size: (min(10_900, 256**size - 1)).to_bytes(size, "big"),
}


@pytest.fixture(scope="module", autouse=True)
def _libraries() -> None:
    """Load what readers load when they need it: it is no part of what a header takes."""
    for name in ("PIL.TiffImagePlugin", "PIL.WebPImagePlugin", "PIL.BmpImagePlugin", "PIL.JpegImagePlugin"):
        importlib.import_module(name)


@pytest.fixture(scope="module")
def pictures() -> dict[str, bytes]:
    return {kind: picture(kind) for kind, _ in NUMBERS}


def with_sums(kind: str, content: bytearray) -> bytes:
    """Return a PNG whose header has the check sum of what it says now, as whoever forges it would write it."""
    if kind == "PNG":
        content[29:33] = struct.pack(">I", zlib.crc32(content[12:29]))
    return bytes(content)


def check(read: Callable[[], object]) -> None:
    start, before = time.process_time(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    try:
        read()
    except InputError as error:
        assert "\n" not in str(error) and len(str(error)) < 600
    assert time.process_time() - start < LONGEST
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024 < MOST


@pytest.mark.parametrize(("kind", "number"), NUMBERS)
def test_no_number_of_a_picture_s_header_takes_memory(
    tmp_path: Path, pictures: dict[str, bytes], kind: str, number: str
) -> None:
    place = NUMBERS[kind, number](pictures[kind])
    for name, value in VALUES.items():
        content = bytearray(pictures[kind])
        content[place] = value(place.stop - place.start)
        path = tmp_path / f"{name}.{kind.lower()}"
        path.write_bytes(with_sums(kind, content))
        check(lambda path=path: read_outline(path, length=0.84))  # type: ignore[misc]


def test_no_number_of_a_packed_table_takes_memory(tmp_path: Path) -> None:
    """The header's ten bytes and the length at the end, which gzip writes as four bytes and nobody need believe."""
    whole = gzip.compress(b"bat_speed_mph,exit_speed_mph\n" + b"70.5,95.2\n" * 300, mtime=0)
    for place in (slice(3, 4), slice(8, 10), slice(len(whole) - 4, len(whole)), slice(len(whole) - 8, len(whole) - 4)):
        for value in VALUES.values():
            content = bytearray(whole)
            content[place] = value(place.stop - place.start)
            path = tmp_path / "false.csv.gz"
            path.write_bytes(content)
            check(lambda: read_swings(path, length=0.84, pitch_speed=36.0))  # noqa: B023 - called at once
            check(lambda: open_table(path, staging=tmp_path / "staging"))  # noqa: B023 - called at once


def test_no_number_of_a_parquet_footer_takes_memory(tmp_path: Path) -> None:
    """Its length, and anything in it: counts of rows, sizes and offsets stand there as numbers of any length."""
    frame = pl.DataFrame({"bat_speed_mph": [70.5] * 40, "exit_speed_mph": [95.2] * 40})
    path = tmp_path / "false.parquet"
    frame.write_parquet(path, compression="zstd")
    whole = path.read_bytes()
    (length,) = struct.unpack("<I", whole[-8:-4])
    chance = np.random.default_rng(2)
    places = [slice(len(whole) - 8, len(whole) - 4)]
    places += [
        slice(begin, begin + 4) for begin in chance.integers(len(whole) - 8 - length, len(whole) - 12, 24).tolist()
    ]
    for place in places:
        for value in (b"\xff\xff\xff\x7f", b"\xff" * 4, bytes(4), b"\x01\0\0\0"):
            content = bytearray(whole)
            content[place] = value
            path.write_bytes(content)
            check(lambda: read_swings(path, length=0.84, pitch_speed=36.0))
            with suppress(InputError):
                open_table(path, staging=tmp_path / "staging")
