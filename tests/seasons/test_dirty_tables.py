"""Random dirty tables: the ledger adds up to the row, every warning counts and names its rows, missing is never zero.

What each row must count as is known where it is made up, without anything of the reader.
"""

from __future__ import annotations

import csv
import gzip
import io
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import polars as pl
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot.seasons.rows import ABSENT, REASONS, USED, rows_of
from sweetspot.seasons.survey import survey_tables
from sweetspot.units import MPH

NAMES = ("game_date", "game_pk", "at_bat_number", "pitch_number", "batter", "description", "events", "des",
         "launch_speed", "launch_angle", "bat_speed", "release_speed", "plate_x", "hc_x", "hc_y", "shirt")  # fmt: skip
KINDS = {
    USED: ("hit_into_play", "field_out"),
    "untracked": ("hit_into_play", "single"),
    "impossible": ("hit_into_play", "double"),
    "bunt": ("hit_into_play", "sac_bunt"),
    "foul": ("foul", ""),
    "no contact": ("ball", ""),
}
"""Reasons, with what a row's description and event say."""
NO_CONTACT = ("ball", "called_strike", "swinging_strike", "foul_tip")
NEVER = ("999.0", "0", "-9999", "130.5")
"""Exit speeds in mph that cannot be."""
NAMED = {"untracked": "untracked", "bunt": "bunts", "foul": "fouls", "impossible": "impossible",
         "duplicate": "duplicates"}  # fmt: skip
"""Warnings that go with a reason."""
LINES = ("blank", "separators", "headings", "total")
WORDS = ("Somebody flies out.", 'Somebody "flies"\nout, é.', "né")


@dataclass
class Dirty:
    """A table in the making: cells of every line, and what each must count as; lines that are no rows have no pitch."""

    lines: list[tuple[str, dict[str, str], int | None]] = field(default_factory=list)


@st.composite
def pitches(draw: st.DrawFn, number: int) -> tuple[str, dict[str, str], int]:
    """Return a row, what it counts as, and which pitch it is."""
    kind = draw(st.sampled_from(sorted(KINDS)))
    description, event = KINDS[kind]
    if kind == "no contact":
        description = draw(st.sampled_from(NO_CONTACT))
    speed = f"{draw(st.integers(300, 1200)) / 10}"
    if kind in ("untracked", "no contact"):
        speed = draw(st.sampled_from(ABSENT))
    elif kind == "impossible":
        speed = draw(st.sampled_from(NEVER))
    bat = draw(st.sampled_from(("71.5", "68", "", "NA", "fast", "0")))
    return kind, {
        "game_date": "2024-04-02", "game_pk": "7", "at_bat_number": str(number // 5 + 1),
        "pitch_number": str(number % 5 + 1), "batter": f"{600_000 + number % 3}", "description": description,
        "events": event, "des": draw(st.sampled_from(WORDS)), "launch_speed": speed, "launch_angle": "12",
        "bat_speed": bat, "release_speed": f"{80 + number * 0.1:.1f}", "plate_x": f"{number * 0.01:.2f}",
        "hc_x": f"{100 + number}.5", "hc_y": "90.25", "shirt": draw(st.sampled_from(("07", "", "12", "x"))),
    }, number  # fmt: skip


@st.composite
def dirty_tables(draw: st.DrawFn) -> list[Dirty]:
    """Return one or two tables, the second of which may have pitches of the first."""
    tables, number = [], 0
    made: list[tuple[str, dict[str, str], int]] = []
    for _ in range(draw(st.integers(1, 2))):
        table = Dirty()
        for what in draw(
            st.lists(st.sampled_from(("pitch", "pitch", "pitch", "again", *LINES)), min_size=1, max_size=20)
        ):
            if what == "pitch" or not made:
                made.append(draw(pitches(number)))
                table.lines.append(made[-1])
                number += 1
            elif what == "again":
                table.lines.append(draw(st.sampled_from(made)))
            else:
                table.lines.append((what, {}, None))
        if not any(pitch is not None for *_, pitch in table.lines):
            made.append(draw(pitches(number)))
            table.lines.append(made[-1])
            number += 1
        tables.append(table)
    return tables


@dataclass(frozen=True)
class Form:
    """How a table is written down."""

    names: tuple[str, ...]
    separator: str
    comma: bool
    encoding: str
    ends: str
    quoting: Any
    packed: bool


@st.composite
def forms(draw: st.DrawFn) -> Form:
    """Return a way to write a table, with its columns in any order; some have no numbers of pitches."""
    names = NAMES if draw(st.booleans()) else tuple(name for name in NAMES if name != "at_bat_number")
    separator = draw(st.sampled_from(",;\t|"))
    return Form(
        tuple(draw(st.permutations(names))), separator, separator == ";" and draw(st.booleans()),
        draw(st.sampled_from(("utf-8", "utf-8-sig", "utf-16", "cp1252"))), draw(st.sampled_from(("\n", "\r\n"))),
        draw(st.sampled_from((csv.QUOTE_MINIMAL, csv.QUOTE_ALL))), draw(st.booleans()),
    )  # fmt: skip


def text_of(table: Dirty, form: Form) -> str:
    """Return a table as text."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, delimiter=form.separator, lineterminator=form.ends, quoting=form.quoting)
    writer.writerow(form.names)
    for what, cells, pitch in table.lines:
        if pitch is not None:
            row = [cells[name] for name in form.names]
            writer.writerow([cell.replace(".", ",") if form.comma and is_number(cell) else cell for cell in row])
        elif what == "blank":
            buffer.write(form.ends)
        elif what == "separators":
            buffer.write(form.separator * (len(form.names) - 1) + form.ends)
        elif what == "headings":
            writer.writerow(form.names)
        else:
            total = "game_date" if form.names[0] == "launch_speed" else form.names[0]
            writer.writerow([{total: "Total", "launch_speed": "1234"}.get(name, "") for name in form.names])
    return buffer.getvalue()


def is_number(cell: str) -> bool:
    return cell.replace(".", "", 1).removeprefix("-").isdigit()


def write(table: Dirty, form: Form, path: Path) -> Path:
    """Write a table, and return where it is."""
    data = text_of(table, form).encode(form.encoding)
    path = path.with_suffix(".csv.gz" if form.packed else ".csv")
    path.write_bytes(gzip.compress(data) if form.packed else data)
    return path


def reasons_of(tables: list[Dirty]) -> list[list[str]]:
    """Return what every line must count as: a pitch that stood there before, in whatever table, is a duplicate."""
    seen: set[int] = set()
    told = []
    for table in tables:
        mine = []
        for what, _, pitch in table.lines:
            if pitch is None:
                mine.append("beside" if what in ("headings", "total") else "nothing")
            else:
                mine.append("duplicate" if pitch in seen else what)
                seen.add(pitch)
        told.append(mine)
    return told


@settings(max_examples=40, deadline=None)
@given(tables=dirty_tables(), form=forms())
def test_every_line_of_a_dirty_table_is_accounted_for(tables: list[Dirty], form: Form) -> None:
    with tempfile.TemporaryDirectory() as folder:
        paths = [write(table, form, Path(folder) / f"table{number}") for number, table in enumerate(tables)]
        found = survey_tables(paths, staging=Path(folder) / "staging")
        assert not found.faults
        for number, (table, reasons) in enumerate(zip(tables, reasons_of(tables), strict=True)):
            read, counted = found.tables[number], Counter(reasons)
            assert found.counts[number] == dict.fromkeys(REASONS, 0) | counted
            assert read.lines == len(table.lines) == sum(found.counts[number].values())
            warned = {one.name: one for one in found.warnings if one.table == number}
            for reason, name in NAMED.items():
                there = [line + 2 for line, what in enumerate(reasons) if what == reason]
                assert (warned[name].rows if name in warned else []) == there[:20]
                assert (warned[name].count if name in warned else 0) == len(there)
            slips = [line + 2 for line, (_, cells, _) in enumerate(table.lines) if cells.get("bat_speed") == "fast"]
            assert (warned["unreadable"].rows if "unreadable" in warned else []) == slips[:20]
            frame = read.part(0, read.rows)
            rows = rows_of(frame, read.headings)
            speeds = [float(cells["launch_speed"]) * MPH for what, cells, _ in table.lines if what == USED]
            assert rows.filter(pl.col("reason") == USED)["exit_speed"].to_list() == pytest.approx(speeds)
            bats = [cells["bat_speed"] for *_, cells, pitch in table.lines if pitch is not None]
            known = [float(bat) * MPH if bat in ("71.5", "68") else None for bat in bats]
            told = rows["bat_speed"].to_list() if "bat_speed" in rows.columns else [None] * len(bats)
            assert [bat is None for bat in told] == [bat is None for bat in known]  # missing, never zero
            shirts = [cells["shirt"] or None for *_, cells, pitch in table.lines if pitch is not None]
            assert [None if shirt is None else str(shirt) for shirt in frame["shirt"]] == shirts  # passed through
