"""Intervals beside numbers in sentences and tables."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from sweetspot.numerics.interval import Interval
from sweetspot.reports import terminal
from sweetspot.reports.document import Column, Table
from sweetspot.reports.quantities import SI, US
from sweetspot.reports.sentences import Slot


@pytest.mark.parametrize(
    ("slot", "expected"),
    [
        (Slot(Interval(40.0, 39.0, 41.0), "speed"), "40.0 ± 1.0 m/s"),
        (Slot(Interval(170.0, 165.0, 179.0), "frequency"), "170 (165 to 179) Hz"),
        (Slot(1.0 - Interval(0.8, 0.7, 0.81), "ratio"), "0.200 (0.190 to 0.300)"),
        (Slot(Interval(0.5, 0.49998, 0.50002), "ratio"), "0.50000 ± 0.00002"),
        (Slot(Interval(0.5, 0.5, 0.5), "ratio"), "0.500"),
    ],
)
def test_an_interval_stands_beside_its_number(slot: Slot, expected: str) -> None:
    """Narrow intervals get digits, lopsided ones their ends, and none is not shown."""
    assert slot.read(SI) == expected


def test_a_table_has_the_reader_s_units() -> None:
    speed = Slot(Interval(40.0, 39.0, 41.0), "speed", unit=False)
    assert Column("speed", "speed").shown(speed, US) == "89.5 ± 2.2"


def test_a_terminal_breaks_long_intervals_and_clips_none() -> None:
    wide = Slot(Interval(0.106, 0.089, 0.140), "ratio")
    table = Table("", [Column(f"a heading of words {n}", "ratio") for n in range(9)], [[wide] * 9])
    printed = io.StringIO()
    Console(file=printed, width=110).print(terminal.table(table, terminal.Screen(US)))
    assert "…" not in printed.getvalue()
    assert printed.getvalue().count("0.140)") == 9
