"""`sweetspot outline`: a table of diameters becomes a bat file that reports can read."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot import beam_model, catalog, rigid_body

CUPPED = """
name = "cupped"
length = "33 in"
turned = { knob = "2 in", handle = "1 in", barrel = "2.5 in", taper_start = "9 in", taper_end = "29 in" }
material = { like = "sugar maple", density = "680 kg/m^3" }
cup = { diameter = "1.4 in", depth = "0.8 in" }
"""


def test_a_bat_there_and_back(
    run: Callable[..., tuple[int, str, str]], run_json: Callable[..., Any], tmp_path: Path
) -> None:
    own = catalog.bat("mlb-a")
    assert own.profile is not None
    table, file = tmp_path / "mine.csv", tmp_path / "mine.toml"
    lines = [f"{1e3 * place!r},{1e3 * size!r}" for place, size in own.profile]
    table.write_text("\n".join(["position_mm,diameter_mm", *lines]), encoding="utf-8")
    found = run_json("outline", str(table), "--material", "sugar maple", "--out", str(file))
    bat = catalog.load_bat(str(file))
    assert bat.name == "mine"
    assert bat.profile is not None
    for read, drawn in zip(bat.profile, own.profile, strict=True):
        assert read == pytest.approx(drawn)
    assert found["mass_kg"] == pytest.approx(rigid_body(beam_model(bat)).mass)
    code, out, _ = run("outline", str(table))
    assert code == 0
    assert "stations: handle" in out


def test_drawings_from_the_catalogue_and_back(run: Callable[..., tuple[int, str, str]], tmp_path: Path) -> None:
    names = [tmp_path / f"bat{ending}" for ending in (".csv", ".svg", ".dxf", ".stl", ".toml")]
    code, out, told = run("outline", "r161-ash", *(word for path in names for word in ("--out", str(path))))
    assert code == 0
    assert "it weighs" in " ".join(out.split())
    assert all(path.stat().st_size > 300 for path in names)
    assert told.count("bat.") == len(names)
    for path in names[:3]:
        code, out, _ = run("outline", str(path), "--units", "si")
        assert code == 0
        assert "length 83.8 cm" in out


def test_what_a_drawing_does_not_tell_is_said(run: Callable[..., tuple[int, str, str]], tmp_path: Path) -> None:
    """A cup is drawn and not read back, and the density is the file's own where it has one."""
    cupped = tmp_path / "cupped.toml"
    cupped.write_text(CUPPED, encoding="utf-8")
    out = " ".join(run("outline", str(cupped), "--out", str(tmp_path / "cupped.dxf"), "--units", "si")[1].split())
    assert "In sugar maple of 680 kg/m³ it would weigh" in out
    out = " ".join(run("outline", str(tmp_path / "cupped.dxf"), "--units", "si")[1].split())
    assert "Solid, without cup or holes, in white ash" in out
