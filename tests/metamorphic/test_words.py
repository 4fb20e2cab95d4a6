"""One thing in other words: other units, other numerals, other file formats, other order of rows and columns."""

from __future__ import annotations

import gzip
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import cast

import numpy as np
import polars as pl
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweetspot
from sweetspot import catalog
from sweetspot.analysis.certification.shot_statistics import measure
from sweetspot.analysis.certification.shots import read_shots
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.plausibility import parse
from sweetspot.player.swings import read_swings
from sweetspot.units import INCH, MPH, OUNCE, Kind
from sweetspot.units.usual_units import WRITTEN
from tests.random_bats import examples, solid_bats

KINDS = sorted(kind for kind, units in WRITTEN.items() if len(units) > 1)


@examples(60)
@given(kind=st.sampled_from(KINDS), number=st.floats(0.01, 90.0), units=st.randoms())
def test_a_quantity_in_another_unit(kind: str, number: float, units: st.DrawFn) -> None:
    """Exact, but for rounding: what one unit says the other does."""
    one, other = units.sample(sorted(WRITTEN[kind]), 2)  # type: ignore[attr-defined]
    value = parse(f"{number!r} {one}", cast(Kind, kind))
    again = value / WRITTEN[kind][other]
    assert parse(f"{again!r} {other}", cast(Kind, kind)) == pytest.approx(value, rel=1e-12)
    assert parse(f"{number!r}{one}", cast(Kind, kind)) == value  # a space is none


SIZES = {"in": INCH, "mm": 1e-3, "cm": 1e-2, "m": 1.0, "ft": 0.3048}
WEIGHTS = {"oz": OUNCE, "g": 1e-3, "kg": 1.0, "lb": 16 * OUNCE}


@examples(6)
@given(bat=solid_bats(plain=True), units=st.tuples(st.sampled_from(list(SIZES)), st.sampled_from(list(WEIGHTS))))
def test_a_bat_file_in_other_units(bat: Bat, units: tuple[str, str]) -> None:
    """Exact, but for rounding."""
    long, heavy = SIZES[units[0]], WEIGHTS[units[1]]
    assert bat.profile is not None
    stations = [[f"{x / long!r} {units[0]}", f"{wide / long!r} {units[0]}"] for x, wide in bat.profile]
    mass = rigid_body(beam_model(bat)).mass
    table = {
        "name": bat.name, "length": f"{bat.length / long!r} {units[0]}", "material": bat.material.name,
        "profile": stations, "mass": f"{mass / heavy!r} {units[1]}",
    }  # fmt: skip
    try:
        read = implement_from_table(table, "bat")
    except InputError:  # an outline that no file may have, or no piece of this wood
        return
    assert read.length == pytest.approx(bat.length, rel=1e-12)
    assert rigid_body(beam_model(read)).mass == pytest.approx(mass, rel=1e-9)


def shots(rng: np.random.Generator, count: int = 24) -> pl.DataFrame:
    place = np.repeat([5.0, 6.0, 7.0, 8.0], count // 4)
    fast = rng.normal(136, 0.8, count)
    return pl.DataFrame({
        "ball_in_mph": fast.round(2), "position_in_from_tip": place,
        "ball_out_mph": (fast * 0.22 - (place - 6) ** 2 + rng.normal(0, 0.5, count)).round(2),
    })  # fmt: skip


def swings(rng: np.random.Generator, count: int = 40) -> pl.DataFrame:
    fast = rng.normal(70, 3, count)
    return pl.DataFrame({
        "bat_speed_mph": fast.round(1), "pitch_speed_mph": rng.normal(88, 3, count).round(1),
        "exit_speed_mph": (0.2 * 88 + 1.2 * fast - rng.exponential(5, count)).round(1),
        "launch_angle_deg": rng.normal(12, 15, count).round(1),
    })  # fmt: skip


def kmh(frame: pl.DataFrame) -> pl.DataFrame:
    factor = MPH * 3.6
    return frame.select(
        (pl.col(name) * factor).alias(name.replace("_mph", "_kmh")) if name.endswith("_mph") else pl.col(name)
        for name in frame.columns
    )


def metres(frame: pl.DataFrame) -> pl.DataFrame:
    return frame.select(
        (pl.col(name) * MPH).alias(name.replace("_mph", "_m_s"))
        if name.endswith("_mph")
        else (pl.col(name) * 2.54).alias(name.replace("_in_", "_cm_"))
        if "_in_" in name
        else pl.col(name)
        for name in frame.columns
    )


def shuffled(frame: pl.DataFrame) -> pl.DataFrame:
    return frame.sample(fraction=1.0, shuffle=True, seed=3)


def other_columns(frame: pl.DataFrame) -> pl.DataFrame:
    return frame.select(reversed(frame.columns)).with_columns(remark=pl.lit("windy, cold"))


def unchanged(frame: pl.DataFrame) -> pl.DataFrame:
    return frame


def plain(frame: pl.DataFrame) -> bytes:
    return frame.write_csv().encode()


def of_windows(frame: pl.DataFrame) -> bytes:
    return b"\xef\xbb\xbf" + frame.write_csv(line_terminator="\r\n").encode()


def of_europe(frame: pl.DataFrame) -> bytes:
    text = frame.select(pl.all().cast(pl.String)).write_csv(separator=";", quote_style="never")
    return text.replace(".", ",").encode()


def with_tabs(frame: pl.DataFrame) -> bytes:
    return frame.write_csv(separator="\t").encode()


def quoted(frame: pl.DataFrame) -> bytes:
    return frame.write_csv(quote_style="always").encode()


def with_blank_lines(frame: pl.DataFrame) -> bytes:
    return (frame.write_csv().replace("\n", "\n\n") + "\n\n").encode()


CHANGES = [unchanged, kmh, metres, shuffled, other_columns]
WRITERS = [plain, of_windows, of_europe, with_tabs, quoted, with_blank_lines]


def shot_values(path: Path) -> Array:
    bat = catalog.bat("r161-ash")
    body = rigid_body(beam_model(bat))
    found = measure(read_shots(path, length=bat.length).shots, bat=bat, body=body, ball=catalog.ball())
    return np.array([found.bbcor.mean, found.bbcor.standard_error, found.efficiency.mean, found.best_position])


def swing_values(path: Path) -> Array:
    read = read_swings(path, length=0.84).swings
    values = [(each.bat_speed, each.pitch_speed, each.exit_speed, each.launch_angle) for each in read]
    return np.array(sorted(values), dtype=float)


@pytest.mark.parametrize("write", WRITERS)
@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize(("make", "values"), [(shots, shot_values), (swings, swing_values)], ids=["shots", "swings"])
def test_a_table_in_other_words(
    tmp_path: Path,
    make: Callable[[np.random.Generator], pl.DataFrame],
    values: Callable[[Path], Array],
    change: Callable[[pl.DataFrame], pl.DataFrame],
    write: Callable[[pl.DataFrame], bytes],
) -> None:
    """Exact, but for rounding: units, order, ends of lines, signs between cells, decimal commas."""
    frame = make(np.random.default_rng(len(change.__name__)))
    one, other = tmp_path / "one.csv", tmp_path / "other.csv"
    one.write_bytes(plain(frame))
    other.write_bytes(write(change(frame)))
    assert values(other) == pytest.approx(values(one), rel=1e-9)


@pytest.mark.parametrize("ending", [".csv.gz", ".parquet"])
def test_packed_swings(tmp_path: Path, ending: str) -> None:
    """Exact: packing is no property of swings."""
    frame = swings(np.random.default_rng(5))
    one, other = tmp_path / "one.csv", tmp_path / f"other{ending}"
    one.write_bytes(plain(frame))
    if ending == ".parquet":
        frame.write_parquet(other)
    else:
        other.write_bytes(gzip.compress(plain(frame)))
    assert swing_values(other) == pytest.approx(swing_values(one), rel=1e-12)


def test_twice_the_shots_are_twice_as_sure(tmp_path: Path) -> None:
    """Derived: every shot twice leaves means as they are, and errors shrink by about the root of two."""
    frame = shots(np.random.default_rng(8))
    one, other = tmp_path / "one.csv", tmp_path / "other.csv"
    one.write_bytes(plain(frame))
    other.write_bytes(plain(pl.concat([frame, frame])))
    before, after = shot_values(one), shot_values(other)
    assert after[[0, 2, 3]] == pytest.approx(before[[0, 2, 3]], rel=1e-9)
    assert 0.55 * before[1] < after[1] < 0.8 * before[1]


OUTLINE = ((0.0, 49.0), (15.0, 49.0), (32.0, 25.0), (200.0, 26.0), (420.0, 38.0), (700.0, 64.0), (838.0, 60.0))
"""mm, of a bat: place and diameter."""


def drawing(path: Path, *, angle: float = 0.0, size: float = 1.0, moved: float = 0.0, flip: int = 1) -> Path:
    """Write a drawing of it in units of a millimetre over ``size``."""
    edge = [*((x, wide / 2) for x, wide in OUTLINE), *((x, -wide / 2) for x, wide in reversed(OUTLINE))]
    sine, cosine, middle = math.sin(angle), math.cos(angle), 1500 + moved
    points = [
        (size * (middle + x * cosine - flip * y * sine), size * (middle + x * sine + flip * y * cosine))
        for x, y in edge
    ]
    line = " L".join(f"{x!r} {y!r}" for x, y in points)
    sheet = f'width="3000mm" height="3000mm" viewBox="0 0 {3000 * size} {3000 * size}"'
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {sheet}><path d="M{line} Z"/></svg>', encoding="utf-8")
    return path


@pytest.mark.parametrize("angle", [0.0, 0.6457718, math.pi / 2, math.pi, -2.0])
@pytest.mark.parametrize("flip", [1, -1])
@pytest.mark.parametrize("size", [1.0, 0.5])
def test_a_drawing_turned_flipped_and_moved(tmp_path: Path, angle: float, flip: int, size: float) -> None:
    """Exact, but for the outline's tolerance: how it lies on the sheet and in what units is no property of a bat."""
    here = read_outline(drawing(tmp_path / "here.svg"))
    there = read_outline(drawing(tmp_path / "there.svg", angle=angle, flip=flip, size=size, moved=31.0))
    places = np.linspace(0.0, 0.83, 60)
    one, other = (np.interp(places, *np.array(outline.profile).T) for outline in (here, there))
    assert there.profile[-1][0] == pytest.approx(here.profile[-1][0], rel=1e-4)
    assert other == pytest.approx(one, abs=3e-4)


USUAL: Sequence[dict[str, object]] = (
    {"bat_speed": "70mph"}, {"bat_speed": "70.00 mph"}, {"bat_speed": "112.65408km/h"}, {"bat_speed": 31.2928},
    {"pitch_speed": "90mph"}, {"pitch_speed": "40.2336 m/s", "bat_speed": "102.6666666667ft/s"}, {"ball": "baseball"},
)  # fmt: skip


@pytest.mark.parametrize("given", USUAL, ids=str)
def test_what_is_usual_may_be_said(given: dict[str, object]) -> None:
    """By definition: a swing that is typed and the usual one are the same question, intervals and all."""
    one, other = sweetspot.report("r161-ash"), sweetspot.report("r161-ash", **given)  # type: ignore[arg-type]
    assert other.best_hit.exit_speed == pytest.approx(one.best_hit.exit_speed, rel=1e-9)
    assert other.best_hit.exit_speed_half == pytest.approx(one.best_hit.exit_speed_half, rel=1e-9)


def test_bats_side_by_side_in_any_order() -> None:
    """Exact, at equal bat speed: what a bat does there does not depend on which bat it stands beside."""
    names = ["r161-ash", "mlb-a", "mlb-c"]
    one, other = (sweetspot.compare(*each, same_speed=True) for each in (names, names[::-1]))
    for first, second in zip(one.bats, other.bats[::-1], strict=True):
        assert float(first.max_collision_efficiency) == pytest.approx(float(second.max_collision_efficiency), rel=1e-9)
        assert float(first.exit_speed) == pytest.approx(float(second.exit_speed), rel=1e-9)
