"""Shots measured in a laboratory, from a CSV file: one row per shot.

``ball_in_mph, ball_out_mph, position_in_from_tip`` and, if measured, ``bat_speed_mph, ball_cor,
ball_stiffness_lbf_in, ball_mass_oz``, or the same in words, ``Position from the tip (in)``. In a column ``position``
every cell says it itself, 6in-from-tip. Faulty rows are listed with the reason; the others are used.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.plausibility import objection
from sweetspot.tables.cells import BadRow, cell_in_si, place_in_si, require_units
from sweetspot.tables.headings import (
    NOTHING_GIVEN,
    GivenColumns,
    TableColumn,
    names_one_of,
    no_column,
    read_headings,
)
from sweetspot.tables.text_encoding import table_rows
from sweetspot.units import MPH, format_length

SHOTS = ("ball_in", "ball_out", "bat_speed", "position", "ball_cor", "ball_stiffness", "ball_mass")
"""Columns that are understood."""
NEEDED = ("ball_in", "ball_out", "position")
CLAMP = STANDARD_AXIS
COR_SPEED = 60 * MPH
"""m/s at which a ball's own restitution is measured [astm_f1887]."""
COLUMNS_HINT = "ball_in_mph, ball_out_mph and position_in_from_tip (or _m_s, _m_from_knob, ...)"


@dataclass(frozen=True)
class Shot:
    """One measured shot in SI.

    Parameters
    ----------
    ball_speed, rebound_speed : m/s towards the bat and away from it.
    bat_speed : m/s of the bat at the point of impact; 0: at rest.
    position : m from the knob end.
    ball_cor : restitution of this ball on a rigid wall; None: not measured.
    ball_stiffness : N/m, dynamic; None: not measured.
    ball_mass : kg; None: not measured.
    """

    row: int
    ball_speed: float
    rebound_speed: float
    bat_speed: float
    position: float
    ball_cor: float | None
    ball_stiffness: float | None
    ball_mass: float | None

    @property
    def closing_speed(self) -> float:
        """Ball plus bat speed, m/s."""
        return self.ball_speed + self.bat_speed

    @property
    def collision_efficiency(self) -> float:
        """Collision efficiency q = (v_out - v_bat) / (v_in + v_bat); for a bat at rest v_out / v_in."""
        return (self.rebound_speed - self.bat_speed) / self.closing_speed


@dataclass(frozen=True)
class Shots:
    """A file of shots: usable shots, unusable ones, and unknown columns."""

    shots: tuple[Shot, ...]
    bad_rows: tuple[BadRow, ...]
    ignored_columns: tuple[str, ...]


def by_place(shots: Iterable[Shot], *, within: float) -> list[list[Shot]]:
    """Return shots in order of position, those within some m of a place's first shot together."""
    groups: list[list[Shot]] = []
    for shot in sorted(shots, key=lambda shot: (shot.position, shot.row)):
        if groups and shot.position - groups[-1][0].position <= within * (1 + 1e-9):
            groups[-1].append(shot)
        else:
            groups.append([shot])
    return groups


def read_shots(path: Path, *, length: float, given: GivenColumns = NOTHING_GIVEN) -> Shots:
    """Return the shots of a CSV file."""
    rows = _rows(path, given)
    if not rows:
        raise InputError(f"{path} is empty; it needs a line of column names: {COLUMNS_HINT}")
    names, rows = rows[0][1], rows[1:]
    headings = read_headings(
        [name.strip() for name in names], wanted=SHOTS, given=given, once=True, file_name=str(path)
    )
    missing = [quantity for quantity in NEEDED if not headings.has(quantity) and quantity not in headings.faults]
    require_units(rows, headings, str(path), faults=(*headings.faults.values(), no_column(missing, names, SHOTS)))
    good, bad = [], []
    for line, cells in rows:
        try:
            good.append(_shot(line, cells, headings.columns, width=len(names), length=length))
        except ValueError as fault:
            bad.append(BadRow(line, str(fault)))
    if not good:
        reasons = "; ".join(f"row {row.row}: {row.reason}" for row in bad[:3])
        raise InputError(f"{path} has no shot that can be used{': ' + reasons if bad else '; it has no rows'}")
    return Shots(tuple(good), tuple(bad), headings.passed)


def _rows(path: Path, given: GivenColumns) -> list[tuple[int, list[str]]]:
    """Return (line, cells) of every line that is not blank."""
    if path.is_dir():
        raise InputError(f"{path} is not a file; give a CSV file with the columns {COLUMNS_HINT}")
    text = read_text(path, most=MOST_TABLE_BYTES, advice=f"give a CSV file with the columns {COLUMNS_HINT}")

    def is_heading(cells: Sequence[str]) -> bool:
        has_header = any(cell.strip() in given.told for cell in cells)
        return has_header or all(names_one_of(cells, (needed,)) for needed in NEEDED)

    return list(table_rows(text, path, is_heading=is_heading))


def _shot(line: int, cells: list[str], columns: Mapping[str, TableColumn], *, width: int, length: float) -> Shot:
    """Return one row as a shot; raises ValueError with the reason when it cannot be used."""
    if len(cells) != width:
        raise ValueError(f"{len(cells)} cells under {width} column names")
    value = {quantity: _number(cells[column.index], column, length) for quantity, column in columns.items()}
    shot = Shot(
        row=line,
        ball_speed=value["ball_in"],
        rebound_speed=value["ball_out"],
        bat_speed=value.get("bat_speed", 0.0),
        position=value["position"],
        ball_cor=value.get("ball_cor"),
        ball_stiffness=value.get("ball_stiffness"),
        ball_mass=value.get("ball_mass"),
    )
    if fault := _fault(shot, length):
        raise ValueError(fault)
    return shot


def _number(cell: str, column: TableColumn, length: float) -> float:
    text = cell.strip()
    if not text:
        raise ValueError(f"{column.heading} is blank")
    number = place_in_si(text, column, length) if column.kind == "place" else cell_in_si(text, column)
    if not math.isfinite(number):
        raise ValueError(f"{column.heading} is {text}; allowed is a finite number")
    return number


def _fault(shot: Shot, length: float) -> str:
    """Return why a shot cannot be true, or an empty text."""
    judged = (
        ("closing_speed", shot.ball_speed, "ball_in", 1.0, "m/s"),
        ("rebound_speed", max(shot.rebound_speed, 0.0), "ball_out", 1.0, "m/s"),
        ("bat_speed", shot.bat_speed or None, "bat_speed", 1.0, "m/s"),
        ("measured_ball_cor", shot.ball_cor, "ball_cor", 1.0, ""),
        ("measured_ball_stiffness", shot.ball_stiffness, "ball_stiffness", 1e-6, "MN/m"),
        ("measured_ball_mass", shot.ball_mass, "ball_mass", 1.0, "kg"),
    )
    faults = (
        (shot.ball_speed <= 0, "ball_in is not above zero"),
        (shot.bat_speed < 0, "bat_speed is negative: the bat would run from the ball"),
        (shot.rebound_speed < 0, "negative rebound: the ball did not come back"),
        (
            shot.collision_efficiency >= 1 if shot.closing_speed > 0 else False,
            "the ball leaves faster than it came, off a bat at rest or seen from the bat",
        ),
        (
            not 0 <= shot.position <= length,
            f"position is {format_length(shot.position)} from the knob end, off the bat of {format_length(length)}",
        ),
        (
            shot.position <= CLAMP,
            "position is at the clamp, 6 in from the knob end, or behind it; is it counted from the other end?",
        ),
    )
    wrong = [text for fault, text in faults if fault]
    for quantity, value, what, size, unit in judged:
        if value is not None:
            wrong.append(objection(quantity, value, what, f"{size * value:.4g} {unit}".strip(), column=True))
    return next(filter(None, wrong), "")
