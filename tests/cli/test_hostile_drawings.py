"""Drawings that are damaged, endless or degenerate: one message, soon, and no traceback."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from ezdxf.filemanagement import new

from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.errors import InputError

SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
BAT = "M0 10 L300 10 L700 33 L840 33 L840 -33 L700 -33 L300 -10 L0 -10 Z"
SIZED = 'width="840mm" height="100mm" viewBox="0 0 840 100"'


def drawn(inside: str, head: str = SIZED) -> str:
    return f"{SVG}{head}>{inside}</svg>"


def bat(transform: str) -> str:
    return drawn(f'<path transform="{transform}" d="{BAT}"/>')


SVGS: dict[str, str] = {
    "nothing left of it": bat("scale(0)"),
    "flat": bat("scale(1 0)"),
    "too large": bat("scale(1e200)"),
    "too small": bat("scale(1e-200)"),
    "no number": bat("matrix(1e400 0 0 1 0 0)"),
    "a transformation without numbers": bat("rotate()"),
    "a matrix of three": bat("matrix(1 2 3)"),
    "uses itself": drawn('<g id="a"><use xlink:href="#a"/></g>'),
    "uses of uses": drawn("".join(f'<g id="g{n}">' + f'<use href="#g{n + 1}"/>' * 9 + "</g>" for n in range(9))),
    "many curves": drawn(f'<path d="{"M0 0L9 1 5 7" * 20_000}"/>'),
    "a view box without size": drawn(f'<path d="{BAT}"/>', 'width="840mm" height="100mm" viewBox="0 0 1e-300 1e-300"'),
    "a huge view box": drawn(f'<path d="{BAT}"/>', 'width="840mm" height="100mm" viewBox="0 0 1e300 1e300"'),
    "a width that is no number": drawn(f'<path d="{BAT}"/>', 'width="e-+mm" height="100mm"'),
    "an endless width": drawn(f'<path d="{BAT}"/>', 'width="1e999mm" height="1e999mm" viewBox="0 0 840 100"'),
}


def dxf(path: Path, draw: Callable[[Any, Any], object]) -> None:
    drawing = new()
    block = drawing.blocks.new("B")
    draw(drawing, block)
    drawing.saveas(path)


def grid(drawing: Any, block: Any) -> None:
    block.add_line((0, 0), (1, 1))
    drawing.modelspace().add_blockref("B", (0, 0), {"row_count": 30_000, "column_count": 30_000, "row_spacing": 1})


def empty_grid(drawing: Any, _: Any) -> None:
    drawing.modelspace().add_blockref("B", (0, 0), {"row_count": 30_000, "column_count": 30_000, "row_spacing": 1})


def itself(drawing: Any, block: Any) -> None:
    block.add_line((0, 0), (1, 1))
    block.add_blockref("B", (0, 0))
    drawing.modelspace().add_blockref("B", (0, 0))


def nested(drawing: Any, block: Any) -> None:
    block.add_line((0, 0), (1, 1))
    for number in range(12):
        outer = drawing.blocks.new(f"B{number}")
        for _ in range(10):
            outer.add_blockref("B" if not number else f"B{number - 1}", (0, 0))
    drawing.modelspace().add_blockref("B11", (0, 0))


def deep(drawing: Any, block: Any) -> None:
    block.add_line((0, 0), (1, 1))
    for number in range(2000):
        drawing.blocks.new(f"B{number}").add_blockref("B" if not number else f"B{number - 1}", (0, 0))
    drawing.modelspace().add_blockref("B1999", (0, 0))


def spline(*points: tuple[float, float]) -> Callable[[Any, Any], object]:
    return lambda drawing, _: drawing.modelspace().add_open_spline([(x, y, 0) for x, y in points])


DXFS: dict[str, Callable[[Any, Any], object]] = {
    "a block 30,000 x 30,000 times": grid,
    "an empty block 30,000 x 30,000 times": empty_grid,
    "a block that holds itself": itself,
    "ten of ten of ten": nested,
    "blocks 2000 deep": deep,
    "a spline to the end of numbers": spline((0, 0), (1e300, 1e300), (-1e300, 1e308), (5, 5)),
    "a spline that is a point": spline((1, 1), (1, 1), (1, 1), (1, 1)),
    "nothing": lambda drawing, _: drawing,
}


@pytest.mark.parametrize("name", SVGS)
def test_svg(tmp_path: Path, name: str) -> None:
    path = tmp_path / "drawing.svg"
    path.write_text(SVGS[name], encoding="utf-8")
    with pytest.raises(InputError) as refused:
        read_outline(path)
    assert "\n" not in str(refused.value) and len(str(refused.value)) < 600


@pytest.mark.parametrize("name", DXFS)
def test_dxf(tmp_path: Path, name: str) -> None:
    path = tmp_path / "drawing.dxf"
    dxf(path, DXFS[name])
    with pytest.raises(InputError) as refused:
        read_outline(path, length=0.84)
    assert "\n" not in str(refused.value) and len(str(refused.value)) < 600


def test_a_dxf_cut_off_anywhere(tmp_path: Path) -> None:
    """After some cuts ezdxf raises StopIteration, IndexError, AttributeError; some leave the outline whole."""
    whole, cut = tmp_path / "whole.dxf", tmp_path / "cut.dxf"
    dxf(whole, lambda drawing, _: drawing.modelspace().add_lwpolyline([(0, 1), (9, 1), (9, 2), (0, 2)], close=True))
    content = whole.read_bytes()
    for end in range(10, len(content), len(content) // 40):
        cut.write_bytes(content[:end])
        with pytest.raises(InputError):
            read_outline(cut, length=0.84)
