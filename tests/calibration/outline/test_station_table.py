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
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.drawing_file import drawing_bytes
from sweetspot.reports.drawings.meridian import radius_at, smooth_outline
from sweetspot.tables.headings import GivenColumns
from tests.real_data import real_file

INCH = 0.0254
BAT = catalog.bat("mlb-a")
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
        ("a,b", [], None, "no column says where.*no column says how thick"),
        ("position_in,diameter_mm", [(40.0, 50.0)], 0.8636, "off the bat"),
        ("position_in,diameter_mm", [], 1.1, "both ends"),
        ("position_in,diameter_mm", [(30.5, math.nan)], None, "line 37"),
        ("in_from_tip,diameter_mm", [(6.0, 51.0)], 0.8636, r"two stations 0.1524 m \(6 in\) from the tip"),
        ("position_in,diameter_mm", [(30.5, 200.0)], None, "taken as circumferences"),
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
        "cone": ([0, 34], [24, 64], "Unlike a bat: no knob. It was taken as round"),
        "leg": ([0, 2, 17, 24, 34], [40, 38, 50, 45, 60], "handle 38 mm thick"),
        "bottle": ([0, 1, 10, 15, 34], [40, 28, 30, 100, 100], "barrel 100 mm thick"),
    }
    for name, (places, widths, words) in things.items():
        everywhere = [(float(inch), float(np.interp(inch, places, widths))) for inch in range(35)]
        path = table(tmp_path / f"{name}.csv", "position_in,diameter_mm", everywhere)
        assert any(words in note for note in read_outline(path).notes), name
    drawn = [(place / INCH, 1e3 * width) for place, width in catalog.bat("r161-ash").profile or ()]
    assert not read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", drawn)).notes


PLACES_IN = [min(float(inch), 34.0) for inch in range(35)]
SIZES_MM = [1e3 * float(catalog.bat("mlb-a").diameter_at(inch * INCH)) for inch in PLACES_IN]


def written(path: Path, heading: str, places: list[str], sizes: list[str], separator: str = ",") -> Path:
    lines = [heading, *(f"{place}{separator}{size}" for place, size in zip(places, sizes, strict=True))]
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def sixty_fourths(inches: float) -> str:
    whole, part = divmod(round(64 * inches), 64)
    return f"{whole} {part}/64" if part else str(whole)


IN, MM = [f"{place:g}" for place in PLACES_IN], [f"{size:.3f}" for size in SIZES_MM]


@pytest.mark.parametrize(
    ("heading", "places", "sizes", "separator", "near"),
    [
        ("position_in,diameter_in", IN, [sixty_fourths(size / 25.4) for size in SIZES_MM], ",", 2e-4),
        ("position,diameter", [f"{place} in" for place in IN], [f"{size} mm" for size in MM], ",", 1e-6),
        ("position (cm),diameter (mm)", [f'"{2.54 * float(place):.2f}"'.replace(".", ",") for place in IN],
         [f'"{size[:-1]}"'.replace(".", ",") for size in MM], ",", 1e-5),
        ('sep=;\nDistance from knob (");Diameter in mm', IN, MM, ";", 1e-6),
        ("# caliper\nMy bat\nno,Distance from the barrel end (inches),OD [mm],wall thickness mm",
         [f"1,{34 - float(place):g}" for place in IN], [f"{size},3" for size in MM], ",", 1e-6),
        ("x (millimetres)\tØ (mm)", [f"{25.4 * float(place):.1f}" for place in IN], MM, "\t", 1e-6),
        ("position_ft,radius_cm", [f"{float(place) / 12:.7f}" for place in IN],
         [f"{size / 20:.5f}" for size in SIZES_MM], ",", 2e-6),
    ],
)  # fmt: skip
def test_the_ways_in_which_people_write_tables(
    tmp_path: Path, heading: str, places: list[str], sizes: list[str], separator: str, near: float
) -> None:
    outline = read_outline(written(tmp_path / "bat.csv", heading, places, sizes, separator), length=34 * INCH)
    found = np.array(outline.profile)
    np.testing.assert_allclose(found[:, 0], np.array(PLACES_IN) * INCH, atol=1e-6)
    np.testing.assert_allclose(found[:, 1], 1e-3 * np.array(SIZES_MM), atol=near)


def test_a_person_says_what_columns_of_an_outline_mean(tmp_path: Path) -> None:
    plain = read_outline(written(tmp_path / "bat.csv", "position_in,diameter_mm", IN, MM))
    path = written(tmp_path / "own.csv", "Ort,Dicke", IN, MM)
    said = GivenColumns({"position": "Ort", "diameter": "Dicke:mm"}, units="us")
    assert read_outline(path, given=said).profile == plain.profile
    both = written(tmp_path / "two.csv", "position_in,diameter_in,Dicke", IN, [f"1,{size}" for size in MM])
    assert read_outline(both, given=GivenColumns({"diameter": "Dicke:mm"})).profile == plain.profile
    for wrong, words in (({"diameter": "Dike:mm"}, "no column 'Dike'"), ({"mood": "Dicke"}, "mood is no quantity")):
        with pytest.raises(InputError, match=words):
            read_outline(path, given=GivenColumns(wrong))
    with pytest.raises(InputError, match="--column position=HEADING:in"):
        read_outline(path)


def test_all_that_is_wrong_is_told_at_once(tmp_path: Path) -> None:
    wrong = [*MM[:3], "thick", *MM[4:9], "-3", *MM[10:]]
    with pytest.raises(InputError, match=r"line 5: diameter_mm is 'thick'.*line 11: diameter_mm is '-3'"):
        read_outline(written(tmp_path / "bat.csv", "position_in,diameter_mm", IN, wrong))
    with pytest.raises(InputError, match=r"columns position and diameter have no unit.*station=position:in"):
        read_outline(written(tmp_path / "bat.csv", "position,diameter", IN, MM))


def test_half_an_inch_in_one_sign(tmp_path: Path) -> None:
    halves = [f"{inch}½" for inch in range(34)]
    path = written(tmp_path / "bat.csv", "position_in,diameter_mm", halves, MM[:34])
    assert read_outline(path, length=34 * INCH).profile[1][0] == pytest.approx(0.5 * INCH)


@pytest.mark.parametrize(
    ("heading", "places", "sizes", "words"),
    [
        ("position_cm,diameter_mm", 1.0, 1.0, r"position_cm counted in inches \(0.8636 m \(34 in\) long\)"),
        ("position_in,diameter_mm", 2.54, 1.0, "position_in counted in cm"),
        ("position_in,diameter_cm", 1.0, 1 / 25.4, "diameter_cm measured in inches"),
        ("position_in,diameter_mm", 1.0, 0.1, "diameter_mm measured in cm"),
        ("position_in,diameter_mm", 1.0, 0.5, "diameter_mm taken as radii"),
        ("position_in,diameter_mm", 1.0, math.pi, "diameter_mm taken as circumferences"),
        ("position_in,circumference_mm", 1.0, 1.0, "circumference_mm taken as diameters"),
        ("position_cm,diameter_cm", 1.0, 1 / 25.4, r"both columns in inches \(0.8636 m"),
    ],
)
def test_a_slip_of_units_is_told_by_what_would_be_a_bat(
    tmp_path: Path, heading: str, places: float, sizes: float, words: str
) -> None:
    rows = [(places * place, sizes * size) for place, size in zip(PLACES_IN, SIZES_MM, strict=True)]
    with pytest.raises(InputError, match=words):
        read_outline(table(tmp_path / "bat.csv", heading, rows))


def test_places_from_the_other_end_are_told(tmp_path: Path) -> None:
    rows = list(zip(PLACES_IN, SIZES_MM, strict=True))
    with pytest.raises(InputError, match="call the column so, as in in_from_knob"):
        read_outline(table(tmp_path / "bat.csv", "in_from_tip,diameter_mm", rows), length=34 * INCH)
    turned = [(34 - place, size) for place, size in rows]
    with pytest.raises(InputError, match="call the column so, as in in_from_tip"):
        read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", turned))


def test_doubtful_stations_are_told(tmp_path: Path) -> None:
    rows = list(zip(PLACES_IN, SIZES_MM, strict=True))
    notes = read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", rows[:14] + rows[20:])).notes
    assert any("from 0.3302 m (13 in) to 0.508 m (20 in)" in note for note in notes)
    slipped = [*rows[:12], (12.0, rows[12][1] + 18), *rows[13:]]
    notes = read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", slipped)).notes
    assert any("12 in) from the knob" in note and " mm more than the line" in note for note in notes)
    notes = read_outline(table(tmp_path / "bat.csv", "position_in,diameter_mm", rows[:-1])).notes
    assert any("33 in), was taken as the tip" in note for note in notes)
    path = written(tmp_path / "bat.csv", "position_in,diameter_mm", IN, [*MM[:7], "", *MM[8:]])
    assert len(read_outline(path).profile) == 34
    three = written(tmp_path / "bat.csv", "position_in,diameter_mm,diameter_in", IN, [f"{size},1" for size in MM])
    with pytest.raises(InputError, match="both give diameter; keep one"):
        read_outline(three)
    bare = written(tmp_path / "bat.csv", "position_in,diameter", IN, MM)
    with pytest.raises(InputError, match="no unit"):
        read_outline(bare)


DENSE = np.linspace(0.0, BAT.length, 700)
RADII = BAT.diameter_at(DENSE) / 2


def rows_of(columns: list[Array], head: str, separator: str = ",") -> str:
    lines = [separator.join(f"{cell:.5f}" for cell in row) for row in zip(*columns, strict=True)]
    return "\n".join([head, *lines]) + "\n"


def lying(columns: list[Array], heads: list[str]) -> str:
    return "\n".join(
        f"{head},{','.join(f'{cell:.5f}' for cell in column)}" for head, column in zip(heads, columns, strict=True)
    )


SHAPES = {
    "dense": rows_of([1e3 * DENSE, 2e3 * RADII], "position_mm,diameter_mm"),
    "closed at the axis": rows_of(
        [1e3 * np.array([0, *DENSE, BAT.length]), 1e3 * np.array([0, *RADII, 0])], "z_mm,radius_mm"
    ),
    "lying": lying([DENSE[::10] / INCH, 2 * RADII[::10] / INCH], ["Measurement Interval (in)", "Diameter (in)"]),
    "lying, comment above": "# measured\n" + lying([2e3 * RADII, 1e3 * DENSE], ["diameter_mm", "place_mm"]),
    "lathe, diameters": rows_of([1e3 * (DENSE - BAT.length), 2e3 * RADII], "Z (mm),X (mm)"),
    "lathe, radii": rows_of([1e3 * (BAT.length - DENSE), 1e3 * RADII], "Z mm;X mm", ";").replace(".", ","),
    "lathe, X first": rows_of([1e3 * RADII[::-1], 1e3 * DENSE[::-1]], "X_radius_mm,Z_mm"),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_tables_of_any_shape_give_the_profile_back(shape: str, tmp_path: Path) -> None:
    """Within 0.05 mm of diameter and 0.1 % of volume, in no more stations than a bat file holds."""
    path = tmp_path / "bat.csv"
    path.write_text(SHAPES[shape], encoding="utf-8")
    profile = np.array(read_outline(path).profile)
    assert len(profile) <= 150
    at = np.linspace(0, BAT.length, 2001)[1:-1]
    step = 10 if shape == "lying" else 1
    true = np.interp(at, DENSE[::step], 2 * RADII[::step])
    found = np.interp(at, *profile.T)
    assert np.abs(found - true).max() < 5e-5
    assert np.sum(found**2) == pytest.approx(np.sum(true**2), rel=1e-3)


def test_its_own_lathe_table_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "bat.lathe.csv"
    path.write_bytes(drawing_bytes(BAT, path))
    profile = np.array(read_outline(path).profile)
    smooth = smooth_outline(BAT)
    at = np.linspace(0, BAT.length, 2001)[1:-1]
    assert np.abs(np.interp(at, *profile.T) - 2 * radius_at(smooth, at)).max() < 5e-5


def test_a_point_of_a_round_end_weighs_nothing(tmp_path: Path) -> None:
    path = tmp_path / "bat.csv"
    path.write_text(rows_of([1e3 * DENSE, 1e3 * np.array([*RADII[:-1], 0])], "place_mm,radius_mm"))
    profile = np.array(read_outline(path).profile)
    assert profile[-1] == pytest.approx([BAT.length, 1e-3])


def test_inches_from_the_knob_that_end_within_the_barrel_are_asked_about(tmp_path: Path) -> None:
    """1 to 33 in of a bat of 34 in is no bat of 33 in; from 0 to a blunt end, as of metal bats, it is one."""
    inches = [float(inch) for inch in range(1, 34)]
    path = table(tmp_path / "bat.csv", "in_from_knob,diameter_mm",
                 [(x, 1e3 * float(BAT.diameter_at(x * INCH))) for x in inches])  # fmt: skip
    with pytest.raises(InputError, match=r"ends at 0.8382 m \(33 in\) in the full barrel.*--length"):
        read_outline(path)
    assert read_outline(path, length=BAT.length).profile[-1][0] == pytest.approx(BAT.length)
