"""Intervals beside the numbers of a document: in sentences, tables, data and columns."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from sweetspot.numerics.interval import Interval
from sweetspot.report import terminal
from sweetspot.report.document import Cell, Column, Document, Paragraph, Table
from sweetspot.report.quantities import SI, US
from sweetspot.report.sentences import Sentence, Slot, say, with_doubt, within
from sweetspot.report.uncertainty.document_intervals import with_intervals
from sweetspot.uncertainty.intervals import Reach


def reach(below: float, above: float) -> Reach:
    return Reach(np.array(below), np.array(above))


DATA: dict[str, Any] = {
    "best": {"exit_speed_m_s": 40.0}, "change_m_s": {"value": 1.0, "low": 0.5, "high": 1.5},
    "scan": {"position_m": [0.5, 0.7], "exit_speed_m_s": [30.0, 40.0]}, "modes": [{"frequency_hz": 170.0}],
}  # fmt: skip
REACHES = {
    "best.exit_speed_m_s": reach(1.0, 1.0), "change_m_s": reach(0.2, 0.2), "modes.0.frequency_hz": reach(5.0, 9.0),
    "scan.exit_speed_m_s": Reach(np.array([1.0, 2.0]), np.array([1.0, 2.0])),
}  # fmt: skip


@pytest.fixture
def told() -> Document:
    rows: list[list[Cell]] = [["a", Slot(40.0, "speed", unit=False, of="best.exit_speed_m_s")]]
    document = Document(
        name="x", title="x", data=DATA, rows=DATA["scan"],
        blocks=[
            Paragraph(say("It leaves at {speed}.", speed=Slot(40.0, "speed", of="best.exit_speed_m_s"))),
            Paragraph(within(Interval(1.0, 0.5, 1.5), "speed_change", of="change_m_s")),
            Paragraph(say("{ring}", ring=Slot(170.0, "frequency", of="modes.0.frequency_hz"))),
            Paragraph(say("{there}", there=Slot(35.0, "speed", of="scan.exit_speed_m_s@0.6"))),
            Table("", [Column("what"), Column("speed", "speed")], rows),
        ],
    )  # fmt: skip
    return with_intervals(document, REACHES)


def test_sentences_and_tables_in_both_systems(told: Document) -> None:
    words = [block.words for block in told.blocks if isinstance(block, Paragraph)]
    assert all(isinstance(one, Sentence) for one in words)
    said = [one.read(SI) for one in words if isinstance(one, Sentence)]
    assert said == ["It leaves at 40.0 ± 1.0 m/s.", "1.00 ± 0.20 m/s", "170 (165 to 179) Hz", "35.0 ± 1.5 m/s"]
    table = told.blocks[-1]
    assert isinstance(table, Table)
    assert table.columns[1].shown(table.rows[0][1], US) == "89.5 ± 2.2"


def test_data_and_columns_have_the_ends(told: Document) -> None:
    assert told.data["best"] == {"exit_speed_m_s": 40.0, "exit_speed_low_m_s": 39.0, "exit_speed_high_m_s": 41.0}
    assert told.data["change_m_s"] == pytest.approx({"value": 1.0, "low": 0.8, "high": 1.2})
    assert told.data["modes"][0]["frequency_high_hz"] == 179.0
    assert told.data["scan"]["exit_speed_low_m_s"] == [29.0, 38.0]
    assert told.rows["exit_speed_high_m_s"] == [31.0, 42.0]
    assert DATA["best"] == {"exit_speed_m_s": 40.0}, "what was given is left as it is"


def test_numbers_the_other_way_round_swap_their_sides() -> None:
    slot = Slot(0.2, "ratio", of="-place_m")
    document = Document("x", "x", [Paragraph(say("{slot}", slot=slot))], {"place_m": 0.5}, {})
    told = with_intervals(document, {"place_m": reach(0.01, 0.1)})
    assert isinstance(told.blocks[0], Paragraph)
    assert str(told.blocks[0].words) == "0.200 (0.100 to 0.210)"


def test_an_interval_replaces_a_standard_deviation() -> None:
    document = Document("x", "x", [Paragraph(with_doubt(2.0, 0.3, "ratio", of="moi"))], {"moi": 2.0}, {})
    told = with_intervals(document, {"moi": reach(0.1, 0.1)})
    assert isinstance(told.blocks[0], Paragraph)
    assert str(told.blocks[0].words) == "2.000 ± 0.100"


def test_narrow_intervals_get_digits_and_none_is_not_shown() -> None:
    assert Slot(0.5, "ratio", reach=(2e-5, 2e-5)).read(US) == "0.50000 ± 0.00002"
    assert Slot(0.5, "ratio", reach=(0.0, 0.0)).read(US) == "0.500"


def test_a_terminal_breaks_long_intervals_and_clips_none() -> None:
    wide = Slot(0.106, "ratio", reach=(0.017, 0.034))
    table = Table("", [Column(f"a heading of words {n}", "ratio") for n in range(9)], [[wide] * 9])
    printed = io.StringIO()
    Console(file=printed, width=110).print(terminal.table(table, terminal.Screen(US)))
    assert "…" not in printed.getvalue()
    assert printed.getvalue().count("0.140)") == 9
