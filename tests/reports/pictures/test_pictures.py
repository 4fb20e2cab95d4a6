"""The pictures: drawn for every kind of bat, to scale, on one axis, nothing on top of anything else."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.analysis.sweet_spot import SweetSpots
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.shell import Shell
from sweetspot.errors import InputError
from sweetspot.reports.bat.figure import report_figure
from sweetspot.reports.bat.outline_picture import bat_figure
from sweetspot.reports.files import save, write_all
from sweetspot.reports.hit.picture import hit_figure
from sweetspot.reports.pictures import style
from sweetspot.reports.pictures.marks import ladder
from sweetspot.reports.pictures.style import png_bytes, svg_bytes
from sweetspot.reports.quantities import ENERGY_NAMES
from sweetspot.reports.sport_words import words_of
from sweetspot.reports.sweet_spots import SPOTS
from sweetspot.units import INCH, MPH
from tests.conftest import FEWER_DOTS
from tests.reports.pictures.labels import check_labels, texts
from tests.reports.told import reported


def _corked() -> Bat:
    return catalog.bat("r161-ash").corked(
        diameter=1 * INCH, depth=10 * INCH, fill=catalog.material("cork"), plug=1 * INCH
    )


def _cupped() -> Bat:
    return catalog.bat("r161-ash").cupped(diameter=1.4 * INCH, depth=0.9 * INCH)


def _shell() -> Bat:
    return Bat(
        name="plain aluminium bat",
        length=0.84,
        material=catalog.material("aluminium_7xxx"),
        profile=((0.0, 0.05), (0.02, 0.05), (0.03, 0.0225), (0.3, 0.0225), (0.6, 0.0667), (0.84, 0.0667)),
        shell=Shell(wall=((0.0, 0.0025), (0.84, 0.003)), end_cap_mass=0.03, knob_mass=0.08),
    )


def _long_name() -> Bat:
    name = "a very long name of a bat $with \\frac{signs}$ that no title has room for, ever"
    return catalog.bat("youth-30").replaced(name=name)


BATS: dict[str, Callable[[], Bat]] = {
    "solid": lambda: catalog.bat("r161-ash"),
    "corked": _corked,
    "cupped": _cupped,
    "shell": _shell,
    "rod": lambda: catalog.bat("uniform-rod"),
    "youth": _long_name,
}


@pytest.fixture(scope="module", params=BATS)
def analysed(request: pytest.FixtureRequest) -> Analysis:
    bat = BATS[request.param]()
    return analyse(bat, standard_conditions(bat))


@pytest.fixture(scope="module")
def picture(analysed: Analysis) -> Figure:
    figure = report_figure(reported(analysed))
    figure.draw_without_rendering()
    return figure


def test_no_label_lies_on_another_or_is_cut_off(picture: Figure) -> None:
    check_labels(picture)


def test_labels_of_the_hit_and_of_the_bat_alone_are_clear_of_each_other(analysed: Analysis) -> None:
    for figure in (hit_figure(analysed.best), bat_figure(analysed)):
        check_labels(figure)


def test_all_panels_share_the_horizontal_axis_of_the_bat(picture: Figure) -> None:
    limits = {tuple(axes.get_xlim()) for axes in picture.axes}
    assert len(limits) == 1
    sides = [(axes.bbox.x0, axes.bbox.x1) for axes in picture.axes]
    assert np.ptp(np.array(sides), axis=0).max() < 1e-6


def test_the_bat_is_drawn_to_scale(picture: Figure) -> None:
    corner, across, up = picture.axes[0].transData.transform([(0.0, 0.0), (0.1, 0.0), (0.0, 0.1)])
    assert up[1] - corner[1] == pytest.approx(across[0] - corner[0], rel=1e-9)


def test_zone_and_best_place_run_where_the_numbers_say(picture: Figure, analysed: Analysis) -> None:
    def place(pixel: float) -> float:
        return float(picture.axes[0].transData.inverted().transform((pixel, 0.0))[0])

    spots = analysed.sweet_spots
    band = picture.findobj(lambda artist: artist.get_gid() == "zone")
    boxes = [artist.get_window_extent() for artist in band]
    zones = [] if spots.zone is None else [spots.zone]
    assert [(place(box.x0), place(box.x1)) for box in boxes] == [pytest.approx(zone, abs=1e-6) for zone in zones]
    lowest = min(axes.bbox.y0 for axes in picture.axes)
    assert [box.y0 for box in boxes] == pytest.approx([lowest] * len(zones), abs=1e-6)
    (line,) = picture.findobj(lambda artist: artist.get_gid() == "best")
    assert place(line.get_window_extent().x0) == pytest.approx(spots.max_exit_speed, abs=1e-3)


def test_every_sweet_spot_is_marked_with_its_number(picture: Figure, analysed: Analysis) -> None:
    words = [text for text, _ in texts(picture)]
    for field, spot in SPOTS.items():
        inches = (analysed.bat.length - getattr(analysed.sweet_spots, field)) / INCH
        assert spot.labelled(words_of(analysed.bat.sport)) in words
        assert f"{inches:.1f}" in words
    marked = [line for line in picture.axes[0].lines if line.get_marker() == "o"]
    drawn = sorted(float(np.asarray(line.get_xdata())[0]) for line in marked)
    assert drawn == pytest.approx(sorted(getattr(analysed.sweet_spots, field) for field in SPOTS))


def test_leaders_do_not_cross(analysed: Analysis) -> None:
    left, right = ladder(analysed)
    assert [mark.place for mark in right] == sorted(mark.place for mark in right)
    assert [mark.place for mark in left] == sorted((mark.place for mark in left), reverse=True)
    assert {mark.field for mark in [*left, *right]} == set(SPOTS)


def _panel(figure: Figure, title: str) -> Axes:
    return next(axes for axes in figure.axes if any(text.get_text() == title for text in axes.texts))


def test_curves_are_the_scan(picture: Figure, analysed: Analysis) -> None:
    scan = analysed.scan
    for title, curve in (
        ("Exit speed", scan.exit_speed / MPH),
        ("Collision efficiency q", scan.collision_efficiency),
        ("Jolt at the top hand", scan.hand_impulse),
        ("Sting", scan.sting),
    ):
        lines = [np.asarray(line.get_ydata()) for line in _panel(picture, title).lines]
        assert any(len(line) == len(curve) and np.array_equal(line, curve, equal_nan=True) for line in lines), title


def test_energy_steps_add_up(analysed: Analysis) -> None:
    axes = _panel(hit_figure(analysed.best), "Where the energy goes")
    drawn = sum(patch.get_width() for patch in axes.patches if hasattr(patch, "get_width"))
    assert drawn == pytest.approx(analysed.best.energy.incoming, rel=1e-3)


def test_names_cover_every_field() -> None:
    fields = set(SweetSpots.__dataclass_fields__) - {"zone"}
    assert fields == set(SPOTS)
    from sweetspot.collision.impact import EnergyLedger

    assert set(ENERGY_NAMES) == set(EnergyLedger.__dataclass_fields__) - {"incoming"}


def test_a_bat_without_a_zone_says_so(analysis: Analysis) -> None:
    without = replace(analysis, sweet_spots=replace(analysis.sweet_spots, zone=None))
    figure = report_figure(reported(without))
    assert "no sweet zone" in [text for text, _ in texts(figure)]
    assert not figure.findobj(lambda artist: artist.get_gid() == "zone")


def test_files_are_the_same_every_time_and_settings_stay(analysis: Analysis, tmp_path: Path) -> None:
    before = dict(matplotlib.rcParams)
    first, second = (svg_bytes(hit_figure(analysis.best)) for _ in range(2))
    assert first == second
    assert png_bytes(hit_figure(analysis.best)).startswith(b"\x89PNG")
    path = save(hit_figure(analysis.best), tmp_path / "hit.SVG")
    assert path.read_bytes() == first
    assert dict(matplotlib.rcParams) == before
    assert [file.name for file in tmp_path.iterdir()] == ["hit.SVG"]


def test_a_picture_has_200_dots_an_inch(analysis: Analysis, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(style, "DOTS_PER_INCH", FEWER_DOTS * style.DOTS_PER_INCH)
    figure = hit_figure(analysis.best)
    png = png_bytes(figure)
    sides = [int.from_bytes(png[place : place + 4], "big") for place in (16, 20)]  # as PNG has them
    assert sides == pytest.approx(200 * figure.get_size_inches(), abs=1)


def test_a_name_in_another_script_is_no_trouble(analysis: Analysis) -> None:
    bat = analysis.bat.replaced(name="\u6728\u306e\u30d0\u30c3\u30c8")
    assert png_bytes(bat_figure(replace(analysis, bat=bat)))
    assert png_bytes(report_figure(reported(replace(analysis, bat=bat))))


def test_saving_refuses_what_it_cannot_do(analysis: Analysis, tmp_path: Path) -> None:
    figure = hit_figure(analysis.best)
    with pytest.raises(InputError, match=r"ends in \.png or \.svg"):
        save(figure, tmp_path / "hit.bmp")
    with pytest.raises(InputError, match="cannot be written"):
        save(figure, tmp_path / "nowhere" / "hit.svg")
    assert not list(tmp_path.iterdir())


def test_either_all_files_are_written_or_none(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("old")
    (tmp_path / "taken").mkdir()
    with pytest.raises(InputError, match="taken is a folder"):
        write_all({tmp_path / "old": b"new", tmp_path / "taken": b"new"})
    assert (tmp_path / "old").read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["old", "taken"]
