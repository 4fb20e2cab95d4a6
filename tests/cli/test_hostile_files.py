"""Files that are none, or claim to be what would fill a machine: every reader refuses at once and in one line."""

from __future__ import annotations

import gzip
import importlib
import resource
import struct
import time
import zlib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

from sweetspot.analysis.certification.shots import read_shots
from sweetspot.calibration import bat_table
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.calibration.recording import BAT_BAND, FASTEST_RATE, SLOWEST_RATE, in_band, read_recording
from sweetspot.catalog.bats import load_bat
from sweetspot.designs.batter_files import contacts_of_file
from sweetspot.errors import InputError
from sweetspot.player.swings import read_swings
from sweetspot.seasons.batters import read_bats
from sweetspot.seasons.table_file import open_table

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
    content = [
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in (*parts, (b"IEND", b""))
    ]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(content))


def wav(path: Path, claim: int) -> None:
    """A second of silence that claims to be longer."""
    form = struct.pack("<IHHIIHH", 16, 1, 1, 48000, 96000, 2, 16)
    head = b"RIFF" + struct.pack("<I", claim) + b"WAVEfmt " + form + b"data" + struct.pack("<I", claim)
    path.write_bytes(head + bytes(96000))


def big_endian_80(number: int) -> bytes:
    """As AIFF writes its rate: 80 bits, most significant first."""
    return struct.pack(">HQ", 16383 + number.bit_length() - 1, number << (64 - number.bit_length()))


SOUND_HEADERS: dict[tuple[str, str], Callable[[bytes], slice]] = {
    ("wav", "rate"): lambda _: slice(24, 28),
    ("wav", "channels"): lambda _: slice(22, 24),
    ("wav", "bits"): lambda _: slice(34, 36),
    ("wav", "bytes of a block"): lambda _: slice(32, 34),
    ("wav", "length"): lambda data: slice(data.index(b"data") + 4, data.index(b"data") + 8),
    ("aiff", "rate"): lambda data: slice(data.index(b"COMM") + 16, data.index(b"COMM") + 26),
    ("aiff", "channels"): lambda data: slice(data.index(b"COMM") + 8, data.index(b"COMM") + 10),
    ("aiff", "length"): lambda data: slice(data.index(b"COMM") + 10, data.index(b"COMM") + 14),
    ("flac", "rate, channels, bits and length"): lambda _: slice(18, 26),
    ("ogg", "channels"): lambda _: slice(39, 40),
    ("ogg", "rate"): lambda _: slice(40, 44),
    ("m4a", "rate"): lambda data: slice(data.index(b"mp4a") + 28, data.index(b"mp4a") + 32),
    ("m4a", "channels"): lambda data: slice(data.index(b"mp4a") + 20, data.index(b"mp4a") + 22),
    ("m4a", "time scale"): lambda data: slice(data.index(b"mdhd") + 16, data.index(b"mdhd") + 20),
    ("m4a", "length"): lambda data: slice(data.index(b"mdhd") + 20, data.index(b"mdhd") + 24),
}
"""Where a header's number stands in a sound file, by format and what it is."""
EXTREMES: dict[str, Callable[[int], bytes]] = {
    "nothing": bytes,
    "one": lambda size: (bytes(size - 1) + b"\1") if size == 1 else b"\1" + bytes(size - 1),
    "the most": lambda size: b"\xff" * size,
    "the most with a sign": lambda size: b"\xff" * (size - 1) + b"\x7f",
    "the most with a sign, big-endian": lambda size: b"\x7f" + b"\xff" * (size - 1),
    "two gigahertz": lambda size: big_endian_80(2**31) if size == 10 else (2**31 - 1).to_bytes(size + 4, "big")[-size:],
}


@pytest.fixture(scope="module")
def sounds(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """A second of a tone in every format."""
    import av
    import soundfile

    folder = tmp_path_factory.mktemp("sounds")
    tone = (0.5 * np.sin(0.1 * np.arange(44100))).astype(np.float32)
    for ending in ("wav", "aiff", "flac", "ogg"):
        soundfile.write(folder / f"tone.{ending}", tone, 44100)
    with av.open(str(folder / "tone.m4a"), "w") as container:
        stream = container.add_stream("aac", rate=44100, layout="mono")
        assert isinstance(stream, av.AudioStream)
        shape = av.AudioResampler(format="fltp", layout="mono", rate=44100, frame_size=1024)
        frame = av.AudioFrame.from_ndarray(tone[None], "fltp", "mono")
        frame.sample_rate, frame.pts = 44100, 0
        for part in (*shape.resample(frame), *shape.resample(None)):
            container.mux(stream.encode(part))
        container.mux(stream.encode(None))
    return {path.suffix[1:]: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("value", EXTREMES)
@pytest.mark.parametrize(("ending", "number"), SOUND_HEADERS)
def test_no_number_of_a_sound_s_header_takes_memory(
    tmp_path: Path, sounds: dict[str, bytes], ending: str, number: str, value: str
) -> None:
    """A header is believed between limits, before memory is taken for the sound or for the search of taps in it."""
    content = bytearray(sounds[ending])
    place = SOUND_HEADERS[ending, number](sounds[ending])
    content[place] = EXTREMES[value](place.stop - place.start)
    path = tmp_path / f"false.{ending}"
    path.write_bytes(content)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with suppress(InputError):
        sound = read_recording(path)
        assert SLOWEST_RATE <= sound.rate <= FASTEST_RATE
        in_band(sound, BAT_BAND)
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024 < MOST


@pytest.mark.parametrize("ending", ["wav", "m4a", "mp3"])
def test_a_list_of_other_files_is_no_sound(tmp_path: Path, sounds: dict[str, bytes], ending: str) -> None:
    (tmp_path / "secret.wav").write_bytes(sounds["wav"])
    path = tmp_path / f"list.{ending}"
    path.write_text("ffconcat version 1.0\nfile secret.wav\n")
    with pytest.raises(InputError, match="cannot be read as a sound"):
        read_recording(path)


@pytest.mark.parametrize("coding", ["zstd", "snappy", "uncompressed"])
@pytest.mark.parametrize("reader", ["season", "swings"])
def test_no_damage_of_parquet_is_a_crash(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], reader: str, coding: Any
) -> None:
    """Bits flipped in pages and footer: polars raises, or its Rust core panics, which is no Exception."""
    draw = np.random.default_rng(8)
    columns = {name: draw.normal(80, 5, 600).round(1) for name in ("exit_speed_mph", "bat_speed_mph")}
    frame = pl.DataFrame(columns).with_columns(
        game_date=pl.lit("2024-05-0") + pl.Series(draw.integers(1, 9, 600)).cast(pl.String)
    )
    path = tmp_path / "damaged.parquet"
    frame.write_parquet(path, compression=coding)
    whole = path.read_bytes()
    READERS[reader](path)
    refused = 0
    for number in range(16):
        content = bytearray(whole)
        for at in draw.integers(4, len(whole) - (4 if number % 2 else len(whole) // 4), 1 + 20 * (number % 2)):
            content[at] ^= 1 << int(draw.integers(8))
        path.write_bytes(content)
        try:
            READERS[reader](path)
        except InputError as error:
            refused += 1
            assert "\n" not in str(error)
    assert refused
    assert "panicked" not in capfd.readouterr().err


@pytest.mark.parametrize("damage", ["cut", "flipped", "zeros"])
@pytest.mark.parametrize(
    ("reader", "ending"), [(name, end) for name in READERS for end in ENDINGS[name] if "csv" in end]
)
def test_no_damage_of_a_table_is_a_crash(tmp_path: Path, reader: str, ending: str, damage: str) -> None:
    draw = np.random.default_rng(9)
    rows = b"bat_speed_mph,exit_speed_mph,batter,game_date\n" + b"70.5,95.25,A,2024-05-02\n" * 500
    whole = gzip.compress(rows, mtime=0) if ending.endswith("gz") else rows
    for _ in range(6):
        content = bytearray(whole)
        places = draw.integers(0, len(whole), 5)
        if damage == "cut":
            del content[places[0] :]
        for at in places[1:] if damage != "cut" else ():
            content[at] = 0 if damage == "zeros" else content[at] ^ 1 << int(draw.integers(8))
        path = tmp_path / f"damaged.{ending}"
        path.write_bytes(content)
        with suppress(InputError):
            READERS[reader](path)


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
    "claims.parquet": lambda path: (
        pl.DataFrame({"exit_speed_mph": [99.0]})
        .select(pl.col("exit_speed_mph").repeat_by(3_000_000).explode())
        .write_parquet(path)
    ),
}
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
