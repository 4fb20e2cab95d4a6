"""The command `parks`: every park in a line, one park all the way round."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot.units import FOOT

Run = Callable[..., tuple[int, str, str]]


def test_all_parks(run_json: Callable[..., Any]) -> None:
    found = run_json("parks")["parks"]
    assert len(found) == 30
    coors = next(park for park in found if park["key"] == "coors-field")
    assert coors["elevation_m"] == pytest.approx(5190 * FOOT)
    assert coors["center_field_m"] == pytest.approx(415 * FOOT)
    assert coors["roof"] == "open" and coors["lowest_fence_m"] < coors["highest_fence_m"]


def test_one_park_all_the_way_round(run_json: Callable[..., Any], run: Run) -> None:
    fence = run_json("parks", "red sox")["fence"]
    assert fence[0]["direction_rad"] == pytest.approx(-0.785398, abs=1e-6)
    assert fence[0]["height_m"] == pytest.approx(37.3 * FOOT)
    code, out, _ = run("parks", "BOS", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert code == 0 and len(rows) == len(fence) and list(rows[0]) == list(fence[0])


@pytest.mark.parametrize("arguments", [(), ("fenway",)])
def test_tables_for_people(run: Run, arguments: tuple[str, ...]) -> None:
    code, out, _ = run("parks", *arguments)
    assert code == 0 and "309" in out


@pytest.mark.parametrize(("arguments", "name"), [((), "parks"), (("fenway",), "park")])
def test_files_and_units(run: Run, tmp_path: Path, arguments: tuple[str, ...], name: str) -> None:
    code, out, _ = run("parks", *arguments, "--units", "si", "--out", str(tmp_path))
    assert code == 0 and "94" in out and " ft" not in out
    assert {path.name for path in tmp_path.iterdir()} == {f"{name}{end}" for end in (".html", ".json", ".png", ".svg")}
