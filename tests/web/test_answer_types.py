"""The page's JavaScript knows the shape of every answer: `answers.d.ts` is what the views' types say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from sweetspot.answers.records import GAPS, GRID, Speed
from sweetspot.numerics.arrays import Array
from sweetspot.units.dimensions import LENGTH, SPEED
from tools import answer_types


@dataclass(frozen=True)
class Sample:
    """One of each.

    More is told here.
    """

    speed: Speed
    place: Annotated[float | None, LENGTH]
    kind: Literal["wood", "metal"]
    pairs: tuple[tuple[float, int], ...]
    map: Annotated[Array, SPEED, GRID, GAPS]
    again: Sample | None = None


def test_a_record_becomes_an_interface() -> None:
    found = answer_types.Interfaces()
    assert found.written(dict[Literal["us", "si"], Sample] | None) == 'Record<"us" | "si", Sample> | null'
    assert found.texts["Sample"].splitlines() == [
        "/** One of each. */",
        "export interface Sample {",
        "  speed_m_s: number; speed_low_m_s?: number; speed_high_m_s?: number;",
        "  place_m: number | null;",
        '  kind: "wood" | "metal";',
        "  pairs: [number, number][];",
        "  map_m_s: (number | null)[][];",
        "  again?: Sample;",
        "}",
    ]


def test_the_pages_types_are_those_of_the_views() -> None:
    assert answer_types.FILE.read_text(encoding="utf-8") == answer_types.text(), "python tools/answer_types.py"
