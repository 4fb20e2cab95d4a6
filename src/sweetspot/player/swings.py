"""A player's swings from a CSV or Parquet file, a row each; faulty rows are listed with the reason, the others used."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path

from sweetspot.errors import InputError, nearest_names
from sweetspot.flight.pitch.home_plate import PLATE_OVER_RELEASE
from sweetspot.plausibility import insisted
from sweetspot.player.player_swing import (
    NEEDED,
    TEXTS,
    TOO_FAST,
    PlayerSwing,
    check_speeds,
    columns_of,
    day_of,
    fault_of,
    full_swings,
    maybe_a_column,
)
from sweetspot.player.swing_table import Lines, SwingTable, one_name, open_swings
from sweetspot.tables.cells import EMPTY, BadRow, cell_in_si, place_in_si, require_units
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, Headings, TableColumn
from sweetspot.units import format_length, format_speed

FEW = 20
"""SwingFile below which the intervals are said to be wide."""
MOST_SWINGS = 400
"""SwingFile that a fit takes: twice as many narrow the intervals by a quarter and take twice as long."""
FOUL, BUNT = "foul", "bunt"
"""Words of an outcome, such as Statcast's description, that tell such a swing."""
FEWEST_TOO_FAST, PART_TOO_FAST = 3, 0.1
"""Rows, and part of all rows, from which balls too fast for the pitch speed say that it is wrong. Our choice."""
ZERO = re.compile(r"[-+]?(?:0+\.?0*|\.0+)(?:\s*[^\d\s.].*)?")


@dataclass(frozen=True)
class SwingFile:
    """A file of swings: those that can be used, those that cannot, and what to know about the file.

    ``bad_rows``: rows that cannot be true, with the reason. ``without_swing``: how many rows have neither a bat speed
    nor an exit speed. ``system``: whose file it is; "plain" where the names belong to no system. ``ignored_columns``:
    headings that mean nothing here. ``notes``: what is missing, constant or few, in words. ``first_day``, ``last_day``:
    of the dated rows; None where no date could be read.
    """

    swings: tuple[PlayerSwing, ...]
    bad_rows: tuple[BadRow, ...]
    without_swing: int
    system: str
    ignored_columns: tuple[str, ...]
    notes: tuple[str, ...]
    first_day: date | None
    last_day: date | None


def read_swings(
    path: Path,
    *,
    length: float,
    given: GivenColumns = NOTHING_GIVEN,
    pitch_speed: float | None = None,
    batter: str | None = None,
    sport: str = "baseball",
) -> SwingFile:
    """Return the swings of a file, plain or of a measuring system: CSV, also packed with gzip, or Parquet.

    ``length``: of the player's bat in m, for positions from the knob. ``pitch_speed``: m/s at the plate, for rows
    without one; 0: a tee.
    """
    table = open_swings(path, given)
    if not table.headings:
        raise InputError(f"{path} is empty; it needs a line of column names, for example bat_speed_mph, exit_speed_mph")
    understood = columns_of(table.headings, given=given, file_name=str(path))
    rows = _of_batter(table, understood, batter, path)
    columns, width = table.narrowed(understood), table.width(understood)
    columns, unmeasured = _measured(rows, columns)
    require_units(rows, columns, str(path))
    read = [
        _read(line, cells, columns, width=width, length=length, pitch_speed=pitch_speed, sport=sport)
        for line, cells in rows
    ]
    good = [swing for swing in read if isinstance(swing, PlayerSwing)]
    bad = [swing for swing in read if isinstance(swing, BadRow)]
    good, partial = full_swings(good)
    good, unknown = _with_pitch(good, path)
    _check_pitch(bad, len(read), pitch_speed, path)
    bad = sorted([*bad, *partial, *unknown], key=lambda row: row.row)
    if not good:
        reasons = "; ".join(f"row {line.row}: {line.reason}" for line in bad[:3])
        why = f": {reasons}" if bad else "; no row has a bat speed or an exit speed"
        raise InputError(f"{path} has no swing that can be used{why}")
    check_speeds(good, path)
    days = sorted(day for _, cells in rows if (day := day_of(cells, columns)) is not None)
    return SwingFile(
        swings=tuple(good),
        bad_rows=tuple(bad),
        without_swing=sum(swing is None for swing in read),
        system=columns.system,
        ignored_columns=columns.passed,
        notes=(*unmeasured, *_notes(good, columns, pitch_speed), *_summaries(table)),
        first_day=days[0] if days else None,
        last_day=days[-1] if days else None,
    )


def batters(path: Path, *, given: GivenColumns = NOTHING_GIVEN) -> tuple[str, ...]:
    """Return the names of a file's batters, in the order of the alphabet."""
    table = open_swings(path, given)
    columns = columns_of(table.headings, given=given, file_name=str(path)) if table.headings else None
    if columns is None or "batter" not in columns.columns:
        raise InputError(f"{path} has no column that names the batter; add one called player, or leave --batter out")
    names = table.batters(columns)
    if not names:
        raise InputError(f"{path} names no batter in its column {columns.columns['batter'].heading}")
    return tuple(names)


def evenly(swings: Sequence[PlayerSwing], most: int) -> tuple[tuple[PlayerSwing, ...], tuple[str, ...]]:
    """Return at most so many swings, taken evenly from first to last, and a note where some were left out.

    >>> evenly((), 400)
    ((), ())
    """
    count = len(swings)
    if count <= most:
        return tuple(swings), ()
    taken = tuple(swings[index * count // most] for index in range(most))
    return taken, (f"{count} swings are usable; {most} of them, taken evenly, are enough and are used.",)


def _of_batter(table: SwingTable, columns: Headings, batter: str | None, path: Path) -> Lines:
    """Return the rows of one batter; a file of several without a name is refused."""
    if "batter" not in columns.columns:
        if batter is not None:
            raise InputError(f"--batter {batter} was given, and {path} has no column that names the batter")
        return _some(table.rows(columns), path)
    if batter is not None and (rows := table.rows(columns, batter)):
        return rows
    names = table.batters(columns)
    if batter is not None and one_name(batter) not in map(one_name, names):
        raise InputError(f"batter {batter!r} is not in {path}. {nearest_names(batter, names)}")
    if len(names) > 1:
        shown_names = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
        raise InputError(
            f"{path} has swings of {len(names)} batters ({shown_names}); choose one with --batter NAME, "
            "or --batter all for a team sheet"
        )
    return _some(table.rows(columns), path)


def _some(rows: Lines, path: Path) -> Lines:
    if not rows:
        raise InputError(f"{path} has column names and no row; give one row per swing")
    return rows


def _read(
    line: int, cells: list[str], columns: Headings, *, width: int, length: float, pitch_speed: float | None, sport: str
) -> PlayerSwing | BadRow | None:
    """Return a row as a swing, as a bad row with its reason, or None where it holds no swing at all."""
    if len(cells) != width:
        return BadRow(line, f"{len(cells)} cells under {width} column names")
    sized = columns.columns.get("bat_length")
    try:
        length = (None if sized is None else _number(cells[sized.index], sized, length)) or length
        value = {
            name: _number(cells[column.index], column, length)
            for name, column in columns.columns.items()
            if name not in TEXTS
        }
    except ValueError as fault:
        return BadRow(line, str(fault))
    if value.get("bat_speed") is None and value.get("exit_speed") is None:
        return None
    pitch, release = value.get("plate_speed"), value.get("release_speed")
    if pitch is None and release is not None:
        pitch = PLATE_OVER_RELEASE * release
    pitch = pitch_speed if pitch is None else pitch
    named, outcomes = columns.columns.get("bat"), columns.columns.get("outcome")
    outcome = cells[outcomes.index].strip().lower() if outcomes else ""
    if BUNT in outcome:
        return BadRow(line, f"{outcome.replace('_', ' ')}: not a full swing")
    if FOUL in outcome:  # a glancing hit: its speed says nothing of where fair balls are met
        value |= {"exit_speed": None, "launch_angle": None}
        if value.get("bat_speed") is None:
            return None
    swing = PlayerSwing(
        row=line,
        bat_speed=value.get("bat_speed"),
        exit_speed=value.get("exit_speed"),
        pitch_speed=pitch,
        launch_angle=value.get("launch_angle"),
        attack_angle=value.get("attack_angle"),
        position=value.get("position"),
        bat=cells[named.index].strip() if named else "",
        foul=FOUL in outcome,
        bat_mass=value.get("bat_mass"),
        bat_length=value.get("bat_length"),
    )
    wrong = fault_of(swing, length, sport)
    return BadRow(line, wrong) if wrong else swing


def _measured(rows: Lines, columns: Headings) -> tuple[Headings, tuple[str, ...]]:
    """Return the columns without speeds that are 0 in every row, as devices write what they did not measure; notes."""
    unmeasured = [
        column
        for name in NEEDED
        if (column := columns.columns.get(name)) is not None
        and (cells := [cells[column.index].strip() for _, cells in rows if column.index < len(cells)])
        and {cell for cell in cells if cell.lower() not in EMPTY}
        and all(cell.lower() in EMPTY or ZERO.fullmatch(cell) for cell in cells)
    ]
    gone = {column.quantity for column in unmeasured}
    remaining = {name: column for name, column in columns.columns.items() if name not in gone}
    notes = tuple(f"Column {column.heading} is 0 in every row: taken as not measured." for column in unmeasured)
    return replace(columns, columns=remaining), notes


def _summaries(table: SwingTable) -> tuple[str, ...]:
    """Return a note on the rows at the end of a table that sum it up."""
    lines = ", ".join(str(line) for line, _ in table.summaries)
    return (f"Row {lines} sums the others up and is no swing.",) if lines else ()


def _check_pitch(bad: Sequence[BadRow], count: int, pitch_speed: float | None, path: Path) -> None:
    """Refuse a pitch that so many balls outrun that it was another: those left out would be the hardest hit."""
    fast = [row for row in bad if TOO_FAST in row.reason]
    if pitch_speed is None or insisted() or len(fast) < max(FEWEST_TOO_FAST, PART_TOO_FAST * count):
        return
    was = "was it a tee" if pitch_speed == 0 else f"was it {format_speed(pitch_speed)}"
    raise InputError(
        f"{path}: {len(fast)} of {count} rows cannot be with the pitch speed that was given, and they are the hardest "
        f"hit; the first is row {fast[0].row}: {fast[0].reason}. Say with --pitch-speed how fast pitches came: {was}? "
        "Add --force to leave those rows out"
    )


def _number(cell: str, column: TableColumn, length: float) -> float | None:
    text = cell.strip()
    if text.lower() in EMPTY:
        return None
    number = length - place_in_si(text, column, length) if column.kind == "place" else cell_in_si(text, column)
    if not math.isfinite(number):
        raise ValueError(f"{column.heading} is {text}; allowed is a finite number")
    return number


def _with_pitch(swings: list[PlayerSwing], path: Path) -> tuple[list[PlayerSwing], list[BadRow]]:
    """Return the swings that have a pitch speed or no exit speed, for that says nothing without the other."""
    if swings and all(swing.pitch_speed is None for swing in swings):
        if any(swing.exit_speed is not None for swing in swings):
            raise InputError(
                f"{path} has no pitch speeds, and exit speed depends on them; say --pitch-speed 82mph (at the plate) "
                "or --pitch-speed tee, or add a column pitch_speed_mph"
            )
        return swings, []
    good, bad = [], []
    for swing in swings:
        if swing.pitch_speed is None and swing.exit_speed is not None:
            bad.append(BadRow(swing.row, "no pitch speed; give one for such rows with --pitch-speed"))
        else:
            good.append(swing)
    return good, bad


def _notes(swings: list[PlayerSwing], columns: Headings, pitch_speed: float | None) -> tuple[str, ...]:
    """Return the notes on the data that a reader should know before trusting the results."""
    notes = []
    count = len(swings)
    if columns.passed and columns.system == "plain":
        notes.append(f"Columns not understood, and not used: {', '.join(map(maybe_a_column, columns.passed))}.")
    fouls = sum(swing.foul for swing in swings)
    if fouls:
        notes.append(f"{fouls} of {count} swings are fouls; of these only the bat speed is used.")
    if count < FEW:
        noun = "swing is" if count == 1 else "swings are"
        notes.append(
            f"Only {count} {noun} usable. The answers lean on what is usual for players; the intervals are wide."
        )
    for quantity, words in WORDS.items():
        values = [value for swing in swings if (value := getattr(swing, quantity)) is not None]
        if not values:
            there = columns.has(quantity) or (
                quantity == "pitch_speed" and (columns.has("plate_speed") or columns.has("release_speed"))
            )
            notes.append(f"{words[0]} is {'empty' if there else 'missing'}: {words[1]}.")
        elif len(values) >= 3 and max(values) == min(values) and (quantity, pitch_speed) != ("pitch_speed", values[0]):
            notes.append(f"{words[0]} is {_formatted(quantity, values[0])} in every row: {words[2]}.")
        elif len(values) < count and quantity in ("bat_speed", "exit_speed"):
            notes.append(f"{words[0]} is there for {len(values)} of {count} swings.")
    lone = sum(swing.launch_angle is not None and swing.attack_angle is None for swing in swings)
    if lone:
        notes.append(
            f"{lone} of {count} swings have a launch angle and no attack angle; where over or under the ball those "
            "were hit is inferred from exit speed alone, since steep swings and low hits launch alike."
        )
    if columns.has("release_speed") and not columns.has("plate_speed"):
        notes.append(f"Pitch speed at the plate is taken as {PLATE_OVER_RELEASE:.3f} of the speed at release.")
    return tuple(notes)


def _formatted(quantity: str, value: float) -> str:
    if quantity == "position":
        return f"{format_length(value)} from the tip"
    return f"{math.degrees(value):.1f} degrees" if quantity.endswith("angle") else format_speed(value)


WORDS = {
    "bat_speed": (
        "Bat speed",
        "it is worked back from exit speed, which also depends on where the ball was met",
        "it looks typed in, not measured, and says nothing about the spread",
    ),
    "exit_speed": (
        "Exit speed",
        "nothing is learned about where and how well the ball was met",
        "it looks typed in, not measured, and the scatter learned from it means little",
    ),
    "pitch_speed": (
        "Pitch speed",
        "only bat speed can be learned",
        "good for a machine or a tee; check that it is intended",
    ),
    "launch_angle": (
        "Launch angle",
        "the scatter over and under the ball is inferred from exit speed alone, which hardly shows it",
        "it looks typed in, not measured",
    ),
    "attack_angle": (
        "Attack angle",
        "the usual one is assumed, so that the mean miss over or under the ball stays uncertain",
        "it looks typed in, not measured",
    ),
    "position": (
        "Contact position along the bat",
        "it is worked back from exit speed, which cannot tell tip from handle side",
        "it looks typed in, not measured",
    ),
}
"""Of every quantity: its name, what it means when missing, what when constant."""
