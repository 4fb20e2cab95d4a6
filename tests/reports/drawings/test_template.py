"""Templates: at full size on every page, and joined by marks at the same places of the bat."""

from __future__ import annotations

import re
import zlib
from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.reports.drawings.drawing_file import Workshop, drawing_bytes
from sweetspot.reports.drawings.template import MARGIN, OVERLAP, PAPERS
from sweetspot.reports.quantities import SI

POINT = 25.4 / 72
"""mm."""
LINE = re.compile(r"([\d.]+) ([\d.]+) m\n([\d.]+) ([\d.]+) l\n\s*S")
STREAM = re.compile(rb"stream\r?\n(.*?)\r?\nendstream", re.DOTALL)


def pages(content: bytes) -> list[str]:
    """Return the drawing commands of every page."""
    found = []
    for stream in STREAM.findall(content):
        try:
            words = zlib.decompress(stream).decode("latin-1")
        except zlib.error:
            continue
        if " l\n" in words:
            found.append(words)
    return found


@pytest.mark.parametrize("paper", ["a4", "letter"])
def test_the_check_lines_have_their_length(paper: str) -> None:
    content = drawing_bytes(catalog.bat("mlb-a"), Path("a.pdf"), workshop=Workshop(paper=paper))
    found = pages(content)
    assert len(found) == 4
    for page in found:
        lengths = [np.hypot(float(c) - float(a), float(d) - float(b)) * POINT for a, b, c, d in LINE.findall(page)]
        assert min(abs(length - 100) for length in lengths) < 1e-3
        assert min(abs(length - 101.6) for length in lengths) < 1e-3
    size = re.search(rb"/MediaBox \[ ?0 0 ([\d.]+) ([\d.]+) ?\]", content)
    assert size is not None
    assert [float(each) * POINT for each in size.groups()] == pytest.approx(PAPERS[paper], abs=0.01)


def test_the_contour_is_at_full_size() -> None:
    """Highest and lowest point of a page's lines over its axis: the barrel's radius, to a hundredth of a mm."""
    bat = catalog.bat("mlb-a")
    last = pages(drawing_bytes(bat, Path("a.pdf"), reading=SI))[-1]
    room = PAPERS["a4"][0] - 2 * MARGIN
    start = 3 * (room - OVERLAP)
    path = re.findall(r"(?:[\d.]+ [\d.]+ [ml]\n){20,}", last)
    ys = np.array([line.split()[1] for each in path for line in each.splitlines()], float) * POINT
    assert ys.max() - ys.min() == pytest.approx(1e3 * float(bat.diameter_at(0.79)), abs=0.02)
    tip = 1e3 * float(bat.diameter_at(bat.length))
    lines = np.array(LINE.findall(last), float) * POINT
    (end,) = {round(x, 3) for x, a, _, b in lines.tolist() if abs(abs(a - b) - tip) < 0.01}
    assert end - MARGIN + start == pytest.approx(1e3 * bat.length, abs=0.02)


def test_a_template_says_what_must_stand_on_it_and_is_the_same_every_time() -> None:
    bat = catalog.bat("corked-r161")
    workshop = Workshop(("NOT LEGAL: corked",))
    first = drawing_bytes(bat, Path("a.pdf"), workshop=workshop)
    assert first == drawing_bytes(bat, Path("a.pdf"), workshop=workshop)
    assert first != drawing_bytes(bat, Path("a.pdf"))


def test_every_view_of_a_blade_is_on_it() -> None:
    assert len(pages(drawing_bytes(catalog.load_implement("cricket-bat"), Path("a.pdf")))) >= 12
