"""The picture of several bats: every bat in it, tips aligned, nothing on top of anything else."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from sweetspot import catalog
from sweetspot.analysis.comparison import Comparison, compare
from sweetspot.answers.compare import compare_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.reports.comparison.picture import compare_figure
from sweetspot.reports.pictures.style import png_bytes, svg_bytes
from sweetspot.units import MPH

LONG = "a very long name of a bat $with \\frac{signs}$ that no row has room for, ever"
SETS = {
    "one": ["r161-ash"],
    "three": ["r161-ash", "youth-30", "mlb-a"],
    "nine": ["youth-30", *["mlb-a", "mlb-b", "russell-b1", "russell-b5"] * 2],
}


@pytest.fixture(scope="module", params=SETS)
def found(request: pytest.FixtureRequest) -> Comparison:
    bats = [catalog.bat(name) for name in SETS[request.param]]
    labels = [bat.name for bat in bats[:-1]] + [LONG]
    return compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law(), labels=labels)


@pytest.fixture(scope="module")
def picture(found: Comparison) -> Figure:
    return compare_figure(compare_of(found))


def test_no_label_lies_on_another_or_is_cut_off(picture: Figure) -> None:
    picture.draw_without_rendering()
    texts = [text for text in picture.findobj(Text) if isinstance(text, Text) and text.get_visible()]
    boxes = [(text.get_text(), Text.get_window_extent(text)) for text in texts if text.get_text().strip()]
    page = picture.bbox
    for words, box in boxes:
        assert page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1, words
    for (words, box), (others, other) in itertools.combinations(boxes, 2):
        shrunk = Bbox.from_extents(box.x0 + 1, box.y0 + 1, box.x1 - 1, box.y1 - 1)
        assert not shrunk.overlaps(other), f"{words!r} lies on {others!r}"


def test_curves_are_the_scans_with_tips_aligned(picture: Figure, found: Comparison) -> None:
    length = max(bat.analysis.bat.length for bat in found.compared)
    lines = [line for line in picture.axes[0].lines if line.get_linestyle() != "None"]  # not marks, not dots
    assert len(lines) == len(found.compared)
    for line, bat in zip(lines, reversed(found.compared), strict=True):
        assert np.asarray(line.get_xdata())[-1] == pytest.approx(length)
        drawn, speed = np.asarray(line.get_ydata()), bat.analysis.scan.exit_speed / MPH
        outer = np.asarray(line.get_xdata()) > 0.6 * length  # nobody means to hit nearer the hands
        assert np.array_equal(drawn[outer], speed[outer], equal_nan=True) and np.isnan(drawn[~outer]).all()
    looks = {(line.get_color(), str(line.get_linestyle()), line.is_dashed()) for line in lines}
    assert len(looks) == len(lines)


def test_zones_are_where_the_numbers_say(picture: Figure, found: Comparison) -> None:
    length = max(bat.analysis.bat.length for bat in found.compared)
    expected = [
        (zone[0] + length - bat.analysis.bat.length, zone[1] - zone[0])
        for bat in found.compared
        if (zone := bat.analysis.sweet_spots.zone) is not None
    ]
    drawn = [(patch.get_x(), patch.get_width()) for patch in picture.axes[1].patches if patch.get_gid() == "zone"]  # type: ignore[attr-defined]
    assert drawn == [pytest.approx(zone) for zone in expected]
    assert len({tuple(axes.get_xlim()) for axes in picture.axes}) == 1


def test_every_bat_is_named_with_its_speed(picture: Figure, found: Comparison) -> None:
    words = [text.get_text() for text in picture.findobj(Text) if isinstance(text, Text)]
    for bat in found.compared[:-1]:
        assert any(text and bat.label.startswith(text.rstrip("\N{HORIZONTAL ELLIPSIS}")) for text in words)
        assert any(text.startswith(f"{bat.exit_speed.value / MPH:.1f} mph") for text in words)


@pytest.mark.parametrize("found", ["three"], indirect=True)
def test_files_are_the_same_every_time(found: Comparison, picture: Figure) -> None:
    assert svg_bytes(compare_figure(compare_of(found))) == svg_bytes(compare_figure(compare_of(found)))
    assert png_bytes(picture).startswith(b"\x89PNG")
