"""Shots measured in a laboratory, from a CSV file: one row per shot, the unit in every column's name.

``ball_in_mph, ball_out_mph, position_in_from_tip`` and, if measured, ``bat_speed_mph, ball_cor,
ball_stiffness_lbf_in, ball_mass_oz``, or the same in words, ``Position from the tip (in)``. In a column ``position``
every cell says it itself, 6in-from-tip. Faulty rows are listed with the reason; the others are used.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from sweetspot.errors import InputError, maybe_meant_heading
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text, table_rows
from sweetspot.units import FOOT, INCH, MPH, OUNCE, POUND_FORCE, parse_position, shown

SPEEDS = {"mph": MPH, "m_s": 1.0, "km_h": 1 / 3.6, "ft_s": FOOT}
UNITS: dict[str, dict[str, float]] = {
    "ball_in": SPEEDS,
    "ball_out": SPEEDS,
    "bat_speed": SPEEDS,
    "position": {
        f"{unit}_from_{end}": factor
        for unit, factor in {"in": INCH, "m": 1.0, "cm": 0.01, "mm": 0.001}.items()
        for end in ("tip", "knob")
    }
    | {"": 1.0},
    "ball_cor": {"": 1.0},
    "ball_stiffness": {"n_m": 1.0, "lbf_in": POUND_FORCE / INCH, "lb_in": POUND_FORCE / INCH},
    "ball_mass": {"oz": OUNCE, "kg": 1.0, "g": 0.001},
}
"""Columns that are understood: name without its unit, and the units with their size in SI."""
KNOWN_UNITS = frozenset(unit for units in UNITS.values() for unit in units if unit)
NEEDED = ("ball_in", "ball_out", "position")
FASTEST = 90.0
"""m/s (201 mph); a faster ball or bat is a number in another unit."""
CLAMP = STANDARD_AXIS
CORS = (0.3, 0.7)
"""Restitution on a rigid wall that a ball of any bat sport can have (assumed: those in use lie between 0.4 and 0.6)."""
STIFFNESSES = (1e5, 2e7)
"""Dynamic stiffness in N/m that one can have (assumed; those of balls in use lie within 1 to 5 MN/m)."""
COLUMNS_HINT = "ball_in_mph, ball_out_mph and position_in_from_tip (or _m_s, _m_from_knob, ...)"


@dataclass(frozen=True)
class Shot:
    """One measured shot in SI.

    Parameters
    ----------
    row : line of the file.
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
class BadRow:
    """A row that cannot be used, and why."""

    row: int
    reason: str


@dataclass(frozen=True)
class Shots:
    """A file of shots: those that can be used, those that cannot, and columns that mean nothing here."""

    shots: tuple[Shot, ...]
    bad_rows: tuple[BadRow, ...]
    ignored_columns: tuple[str, ...]


@dataclass(frozen=True)
class _Column:
    """A column's place, quantity and unit; ``plain``: its cells are numbers, in that unit."""

    index: int
    heading: str
    quantity: str
    factor: float
    from_tip: bool
    plain: bool


def read_shots(path: Path, *, length: float) -> Shots:
    """Return the shots of a CSV file.

    Parameters
    ----------
    length : of the bat in m, for positions from the tip and to refuse those off the bat.

    Raises
    ------
    InputError
        when the file cannot be read, a needed column is missing or stands there twice, or no row can be used.
    """
    rows = _rows(path)
    try:
        _, headings = next(rows)
    except StopIteration:
        raise InputError(f"{path} is empty; it needs a line of column names: {COLUMNS_HINT}") from None
    columns, ignored = _columns(headings, path)
    good, bad = [], []
    for line, cells in rows:
        try:
            good.append(_shot(line, cells, columns, width=len(headings), length=length))
        except ValueError as fault:
            bad.append(BadRow(line, str(fault)))
    if not good:
        reasons = "; ".join(f"row {row.row}: {row.reason}" for row in bad[:3])
        raise InputError(f"{path} has no shot that can be used{': ' + reasons if bad else '; it has no rows'}")
    return Shots(tuple(good), tuple(bad), ignored)


def _rows(path: Path) -> Iterator[tuple[int, list[str]]]:
    """Yield (line, cells) of every line that is not blank."""
    if path.is_dir():
        raise InputError(f"{path} is not a file; give a CSV file with the columns {COLUMNS_HINT}")
    text = read_text(path, most=MOST_TABLE_BYTES, advice=f"give a CSV file with the columns {COLUMNS_HINT}")
    yield from table_rows(text, path, is_heading=_is_heading)


def _is_heading(cells: Sequence[str]) -> bool:
    names = [_name(cell) for cell in cells]
    return all(any(name.startswith(needed) for name in names) for needed in NEEDED)


def _columns(headings: list[str], path: Path) -> tuple[dict[str, _Column], tuple[str, ...]]:
    """Return the columns that are understood by quantity, and the names of those that are not."""
    columns: dict[str, _Column] = {}
    ignored = []
    for index, heading in enumerate(headings):
        column = _column(index, _name(heading))
        if column is None:
            ignored.append(heading.strip())
            continue
        if column.quantity in columns:
            raise InputError(
                f"{path}: columns {columns[column.quantity].heading} and {column.heading} both give {column.quantity}; "
                "keep one of them, in one unit"
            )
        columns[column.quantity] = column
    missing = [quantity for quantity in NEEDED if quantity not in columns]
    if missing:
        examples = ", ".join(f"{quantity}_{next(iter(UNITS[quantity]))}" for quantity in missing)
        raise InputError(
            f"{path}: no column for {' and '.join(missing)}; give for example {examples}. "
            f"The file has: {', '.join(maybe_meant_heading(one.strip(), UNITS, KNOWN_UNITS) for one in headings)}"
        )
    return columns, tuple(ignored)


def _name(heading: str) -> str:
    """Return a heading as our names are written, the unit of a position before the end it counts from.

    >>> _name(" Position from the tip (in)"), _name("position_from_knob_cm"), _name("Ball in [mph]")
    ('position_in_from_tip', 'position_cm_from_knob', 'ball_in_mph')
    """
    name = re.sub(r"[^a-z0-9]+", "_", heading.lower()).strip("_").replace("_the_", "_")
    return re.sub(r"_(from_(?:tip|knob))_([a-z]+)$", r"_\2_\1", name)


def _column(index: int, name: str) -> _Column | None:
    """Return what a column means, None for a name that is not ours; a known name with no known unit is refused."""
    quantity = next((known for known in UNITS if name == known or name.startswith(f"{known}_")), None)
    if quantity is None:
        return None
    unit = name.removeprefix(quantity).removeprefix("_")
    if unit not in UNITS[quantity]:
        allowed = ", ".join(f"{quantity}_{unit}".rstrip("_") for unit in UNITS[quantity])
        raise InputError(f"column {name} has {'an unknown' if unit else 'no'} unit; allowed: {allowed}")
    plain = quantity != "position" or unit != ""
    return _Column(index, name, quantity, UNITS[quantity][unit], unit.endswith("_from_tip"), plain)


def _shot(line: int, cells: list[str], columns: dict[str, _Column], *, width: int, length: float) -> Shot:
    """Return one row as a shot; raises ValueError with the reason when it cannot be used."""
    if len(cells) != width:
        raise ValueError(f"{len(cells)} cells under {width} column names")
    value = {quantity: _number(cells[column.index], column) for quantity, column in columns.items() if column.plain}
    where = columns["position"]
    position = value["position"] if where.plain else _written_place(cells[where.index], length)
    position = length - position if where.from_tip else position
    shot = Shot(
        row=line,
        ball_speed=value["ball_in"],
        rebound_speed=value["ball_out"],
        bat_speed=value.get("bat_speed", 0.0),
        position=position,
        ball_cor=value.get("ball_cor"),
        ball_stiffness=value.get("ball_stiffness"),
        ball_mass=value.get("ball_mass"),
    )
    if fault := _fault(shot, length):
        raise ValueError(fault)
    return shot


def _written_place(cell: str, length: float) -> float:
    """Return a place that is written with its unit and end, m from the knob end; raises ValueError with the reason."""
    try:
        return parse_position(cell, length=length, what="position")
    except InputError as fault:
        raise ValueError(str(fault)) from None


def _number(cell: str, column: _Column) -> float:
    text = cell.strip()
    if not text:
        raise ValueError(f"{column.heading} is blank")
    try:
        number = float(text)
    except ValueError:
        raise ValueError(
            f"{column.heading} is {text!r}, not a plain number; the unit stands in the column's name"
        ) from None
    if not math.isfinite(number):
        raise ValueError(f"{column.heading} is {text}; allowed is a finite number")
    return number * column.factor


def _fault(shot: Shot, length: float) -> str:
    """Return why a shot cannot be true, or an empty text."""
    fastest = max(shot.ball_speed, shot.rebound_speed, shot.bat_speed)
    faults = (
        (fastest > FASTEST, f"a speed of {fastest:.4g} m/s ({fastest / MPH:.4g} mph); is the column in another unit?"),
        (shot.ball_speed <= 0, "ball_in is not above zero"),
        (shot.bat_speed < 0, "bat_speed is negative: the bat would run from the ball"),
        (shot.rebound_speed < 0, "negative rebound: the ball did not come back"),
        (
            shot.collision_efficiency >= 1 if shot.closing_speed > 0 else False,
            "the ball leaves faster than it came, off a bat at rest or seen from the bat",
        ),
        (
            not 0 <= shot.position <= length,
            f"position is {shown(shot.position)} from the knob end, off the bat of {shown(length)}",
        ),
        (
            shot.position <= CLAMP,
            "position is at the clamp, 6 in from the knob end, or behind it; is it counted from the other end?",
        ),
        (
            shot.ball_cor is not None and not CORS[0] <= shot.ball_cor <= CORS[1],
            f"ball_cor is not that of a ball on a rigid wall, {CORS[0]:g} to {CORS[1]:g}",
        ),
        (
            shot.ball_stiffness is not None and not STIFFNESSES[0] <= shot.ball_stiffness <= STIFFNESSES[1],
            f"ball_stiffness is not that of a ball, {STIFFNESSES[0]:g} to {STIFFNESSES[1]:g} N/m; is the column in "
            "another unit?",
        ),
        (
            shot.ball_mass is not None and not 0.02 < shot.ball_mass < 0.5,
            "ball_mass is not that of a ball, 0.02 to 0.5 kg; is the column in another unit?",
        ),
    )
    return next((text for wrong, text in faults if wrong), "")
