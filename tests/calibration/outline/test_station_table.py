"""Outlines from tables of stations: any unit, either end, diameters or circumferences."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.errors import InputError
from tests.real_data import real_file

INCH = 0.0254
INCHES = np.arange(0, 34.01, 0.5)


def table(path: Path, heading: str, rows: list[tuple[float, float]]) -> Path:
    path.write_text("\n".join([heading, *(f"{place!r},{size!r}" for place, size in rows)]), encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("heading", "place", "size"),
    [
        ("position_in,diameter_in", lambda x: x / 0.0254, lambda d: d / 0.0254),
        ("in from tip,Circumference (cm)", lambda x: (0.8636 - x) / 0.0254, lambda d: math.pi * d * 100),
        ("x [mm],radius [mm]", lambda x: 1e3 * x, lambda d: 500 * d),
    ],
)
def test_units_ends_and_girths(
    tmp_path: Path, heading: str, place: Callable[[float], float], size: Callable[[float], float]
) -> None:
    bat = catalog.bat("mlb-a")
    assert bat.length == pytest.approx(0.8636)
    places = np.minimum(INCHES * 0.0254, bat.length)
    rows = [(float(place(x)), float(size(float(bat.diameter_at(x))))) for x in places]
    outline = read_outline(table(tmp_path / "bat.csv", heading, rows), length=bat.length)
    assert outline.assumed == ()
    found = np.array(outline.profile)
    np.testing.assert_allclose(found[:, 0], places, atol=1e-9)
    np.testing.assert_allclose(found[:, 1], bat.diameter_at(places), rtol=1e-9)


def test_a_real_bat_by_caliper() -> None:
    """33 readings of a 34-in bat from the tip; the ends are assumed, and it weighs what bats weigh."""
    outline = read_outline(real_file("caliper_bat.csv"), length=34 * 0.0254)
    sizes = dict(outline.profile)
    assert len(outline.profile) == 33 + len(outline.assumed)
    assert max(sizes.values()) == pytest.approx(63.1e-3)
    assert 0.0 in outline.assumed
    assert outline.profile[-1][0] == pytest.approx(34 * 0.0254)


def test_refusals(tmp_path: Path) -> None:
    rows = [(float(x), 50.0) for x in range(35)]
    for heading, more, length, message in (
        ("in_from_tip,diameter_mm", [], None, "--length"),
        ("a,b", [], None, "begins with"),
        ("position_in,diameter_mm", [(40.0, 50.0)], 0.8636, "off the bat"),
        ("position_in,diameter_mm", [], 1.1, "both ends"),
        ("position_in,diameter_mm", [(30.5, math.nan)], None, "line 37"),
        ("in_from_tip,diameter_mm", [(6.0, 51.0)], 0.8636, r"two stations 0.1524 m \(6 in\) from the tip"),
        ("position_in,diameter_mm", [(30.5, 200.0)], None, "call the column so"),
    ):
        with pytest.raises(InputError, match=message):
            read_outline(table(tmp_path / "bat.csv", heading, [*rows, *more]), length=length)
    with pytest.raises(InputError, match="allowed are a heading"):
        read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", rows[:3]))
    with pytest.raises(InputError, match="no such file"):
        read_outline(tmp_path / "none.csv")


def test_what_is_no_bat_is_told(tmp_path: Path) -> None:
    """A cone, a table's leg and a bottle are slender, straight and thicker at one end, as bats are."""
    things = {
        "cone": ([0, 34], [24, 64], "Unlike a bat: no knob."),
        "leg": ([0, 2, 17, 24, 34], [40, 38, 50, 45, 60], "handle 38 mm thick"),
        "bottle": ([0, 1, 10, 15, 34], [40, 28, 30, 100, 100], "barrel 100 mm thick"),
    }
    for name, (places, widths, words) in things.items():
        everywhere = [(float(inch), float(np.interp(inch, places, widths))) for inch in range(35)]
        path = table(tmp_path / f"{name}.csv", "position_in,diameter_mm", everywhere)
        assert any(words in note for note in read_outline(path).notes), name
    drawn = [(place / INCH, 1e3 * width) for place, width in catalog.bat("r161-ash").profile or ()]
    assert not read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", drawn)).notes
