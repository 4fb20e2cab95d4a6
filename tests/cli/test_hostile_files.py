"""Files that are none, or claim to be what would fill a machine: every reader refuses at once and in one line."""

from __future__ import annotations

import gzip
import importlib
import resource
import struct
import time
import zlib
from collections.abc import Callable
from pathlib import Path

import polars as pl
import pytest

from sweetspot.analysis.certification.shots import read_shots
from sweetspot.calibration import bat_table
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.calibration.recording import read_recording
from sweetspot.catalog.bats import load_bat
from sweetspot.design.batter_files import contacts_of_file
from sweetspot.errors import InputError
from sweetspot.player.swings import read_swings
from sweetspot.season.bat_table import read_bats
from sweetspot.season.table_file import open_table

Reader = Callable[[Path], object]
READERS: dict[str, Reader] = {
    "bat": lambda path: load_bat(str(path)),
    "swings": lambda path: read_swings(path, length=0.84, pitch_speed=36.0),
    "shots": lambda path: read_shots(path, length=0.84),
    "measured bats": bat_table.read_bats,
    "whose bats": read_bats,
    "contacts": contacts_of_file,
    "season": lambda path: open_table(path, staging=path.parent / "staging"),
    "outline": lambda path: read_outline(path, length=0.84),
    "sound": read_recording,
}
ENDINGS = {
    "bat": ("toml",), "swings": ("csv", "csv.gz"), "shots": ("csv",), "measured bats": ("csv",), "whose bats": ("csv",),
    "contacts": ("csv",), "season": ("csv", "csv.gz", "tsv", "parquet"),
    "outline": ("csv", "svg", "dxf", "jpg", "png", "tif"), "sound": ("wav", "flac", "mp3"),
}  # fmt: skip
HUGE = 300 << 30
"""Bytes that a file claims to have; nothing of it is on the disk."""
ENDLESS, MOST = 60.0, 200
"""s of the processor, a hundred times what any machine needs: a guard against endless work, no speed; and MB."""


def packed(path: Path, head: bytes, block: bytes, times: int) -> None:
    with gzip.open(path, "wb") as file:
        file.write(head)
        for _ in range(times):
            file.write(block)


def png(path: Path, side: int) -> None:
    """An empty picture of two colours."""
    packer = zlib.compressobj(9)
    rows = [packer.compress(bytes(1 + (side + 7) // 8)) for _ in range(side)]
    parts = (b"IHDR", struct.pack(">IIBBBBB", side, side, 1, 0, 0, 0, 0)), (b"IDAT", b"".join(rows) + packer.flush())
    content = [struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
               for name, data in (*parts, (b"IEND", b""))]  # fmt: skip
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(content))


def wav(path: Path, claim: int) -> None:
    """A second of silence that claims to be longer."""
    form = struct.pack("<IHHIIHH", 16, 1, 1, 48000, 96000, 2, 16)
    head = b"RIFF" + struct.pack("<I", claim) + b"WAVEfmt " + form + b"data" + struct.pack("<I", claim)
    path.write_bytes(head + bytes(96000))


SVG = '<svg xmlns="http://www.w3.org/2000/svg">'
MORE = "".join(f'<!ENTITY {new} "{f"&{old};" * 10}">' for old, new in zip("abcdefgh", "bcdefghi", strict=True))
ENTITIES = f'<!DOCTYPE s [<!ENTITY a "a">{MORE}]>'
BOMBS: dict[str, Callable[[Path], object]] = {
    "dots.toml": lambda path: path.write_text(".".join(["a"] * 100_000) + " = 1"),
    "keys.toml": lambda path: path.write_text("".join(f"key{number} = 1\n" for number in range(15_000))),
    "swings.csv.gz": lambda path: packed(path, b"bat_speed_mph,exit_speed_mph\n", b"70,95\n" * 100_000, 100),
    "season.csv.gz": lambda path: packed(path, b"exit_speed_mph,launch_angle_deg\n", b"99,12\n" * 100_000, 100),
    "line.csv.gz": lambda path: packed(path, b"exit_speed_mph,launch_angle_deg\n", b"0" * 1_000_000, 60),
    "line.csv": lambda path: path.write_bytes(b"exit_speed_mph" * 200_000),
    "deep.svg": lambda path: path.write_text(SVG + "<g>" * 100_000 + "</g>" * 100_000 + "</svg>"),
    "long.svg": lambda path: path.write_text(f'{SVG}<path d="M0 0 {"L1 1 " * 200_000}"/></svg>'),
    "entities.svg": lambda path: path.write_text(f"{ENTITIES}{SVG}<text>&i;</text></svg>"),
    "long.dxf": lambda path: path.write_text("0\nSECTION\n2\nENTITIES\n" + "0\nLINE\n8\n0\n10\n0\n20\n0\n" * 200_000),
    "wide.png": lambda path: png(path, 10_000),
    "wider.png": lambda path: png(path, 13_000),
    "claims.wav": lambda path: wav(path, 0xFFFFFFF0),
    "claims.parquet": lambda path: pl.DataFrame({"exit_speed_mph": [99.0]}).select(
        pl.col("exit_speed_mph").repeat_by(3_000_000).explode()
    ).write_parquet(path),
}  # fmt: skip
USES = {
    "toml": "bat", "swings.csv.gz": "swings", "csv.gz": "season", "csv": "season", "parquet": "season", "wav": "sound",
}  # fmt: skip


@pytest.fixture(scope="module", autouse=True)
def _libraries() -> None:
    """Load what readers load when they need it: it is no part of what a refusal takes."""
    for name in ("PIL.Image", "ezdxf", "soundfile"):
        importlib.import_module(name)


def check_refused(read: Reader, path: Path) -> None:
    start, before = time.process_time(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(InputError) as refused:
        read(path)
    assert time.process_time() - start < ENDLESS, path
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024 < MOST, path
    assert len(str(refused.value)) < 600 and "\n" not in str(refused.value), path


@pytest.mark.parametrize(("reader", "ending"), [(name, ending) for name in READERS for ending in ENDINGS[name]])
def test_devices_folders_and_endless_files(tmp_path: Path, reader: str, ending: str) -> None:
    endless, folder, empty = (tmp_path / f"{name}.{ending}" for name in ("endless", "folder", "empty"))
    zeros = tmp_path / f"zeros.{ending}"
    zeros.symlink_to("/dev/zero")
    folder.mkdir()
    empty.touch()
    with endless.open("wb") as file:
        file.truncate(HUGE)
    for path in (zeros, folder, empty, endless, tmp_path / f"none.{ending}"):
        check_refused(READERS[reader], path)


@pytest.mark.parametrize("name", BOMBS)
def test_bombs(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    BOMBS[name](path)
    use = next((USES[part] for part in (name, name.partition(".")[2]) if part in USES), "outline")
    check_refused(READERS[use], path)
