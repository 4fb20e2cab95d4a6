"""A bat's outline from a table of stations: caliper or tape at every inch, in any unit, from either end."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from sweetspot.calibration.outline.measured_outline import MeasuredOutline, closed, fewest_stations
from sweetspot.calibration.outline.table_shapes import (
    from_the_knob,
    is_lathe_axis,
    of_lathe,
    upright,
    without_end_faces,
)
from sweetspot.equipment.shell import MOST_STATIONS as MOST_OF_BAT
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.plausibility import insisted, parse, verdict
from sweetspot.tables.cells import require_units, with_unit
from sweetspot.tables.headings import (
    NOTHING_GIVEN,
    GivenColumns,
    TableColumn,
    closest,
    names_one_of,
    read_headings,
    refuse_faults,
)
from sweetspot.tables.text_encoding import FIRST_LINES, table_rows
from sweetspot.tables.vocabulary import UNITS, quantities_of
from sweetspot.units import INCH, format_length

STATIONS = quantities_of("stations")
ACROSS = {"diameter": 1.0, "circumference": 1 / math.pi, "radius": 2.0}
"""The quantities measured across, and the diameter per unit of each."""
PLURALS = {"diameter": "diameters", "circumference": "circumferences", "radius": "radii"}
TRIED = ("inches", "feet", "mm", "cm", "m")
"""Units that are tried where something is no bat."""
COMMENT = "#"
MOST_STATIONS = 20_000
FEWEST_STATIONS = 5
MOST_FAULTS = 5
"""Lines whose fault a message names."""
WIDE, EVEN = 3.05 * INCH, 1e-5
"""m between stations from which on the shape between is reported as unknown (a straight line over 3 in misses 2.6 mm
of the catalogue's bats, a torpedo's barrel), unless both are as thick: a drawn cylinder."""
OFF_LINE, NEIGHBOURS = 3e-3, 1.1 * INCH
"""m that a diameter may be off the line between its neighbours, where these are no farther away: an inch apart, the
catalogue's bats reach 1.8 mm."""
BLUNT = 0.93
"""Of the greatest diameter: turned tips are rounded to less; blunt ones, as of metal bats, cause a needless warning."""
SLENDER = 8.0
"""Length over greatest diameter of bats at least; those of the catalogue have 11 or more."""
THICKER = 1.05
"""Mean of the knob's half over that of the barrel's from which on a bat was measured from its other end."""
BEYOND_KNOB, BEFORE_TIP = 4 * INCH, 2.5 * INCH
"""m from the ends, where knobs and tips turn quicker."""


def read_stations(path: Path, *, length: float | None = None, given: GivenColumns = NOTHING_GIVEN) -> MeasuredOutline:
    """Return the outline that a CSV file of stations describes.

    One column says where, from the knob end unless its heading names the tip: ``in_from_tip``, ``position_mm``. Another
    says how thick: ``diameter``, ``circumference`` or ``radius``. Units stand in the headings or behind the numbers,
    which may be fractions. The table may lie down, places in a line and sizes below. It may be a lathe's: Z from any
    origin, with X, a diameter or else a radius. It may go down to the axis at its ends. What stands above the headings,
    and lines that begin with #, are left out; so are stations whose size is blank. Where no station is at an end, the
    tip is rounded as turned bats usually are, and the knob goes on as thick as it was.

    ``length``: m; needed where the places count from the tip, or where the last station is not the tip.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice="give a CSV file of a heading and a line for each station")

    def is_heading(cells: Sequence[str]) -> bool:
        named = any(cell.strip() in given.told for cell in cells)
        return named or (names_one_of(cells, ("station",)) and names_one_of(cells, tuple(ACROSS)))

    rows = [
        (line, cells)
        for line, cells in table_rows(text, path, is_heading=is_heading)
        if not cells[0].lstrip().startswith(COMMENT)
    ]
    first = next((index for index, (_, cells) in enumerate(rows[:FIRST_LINES]) if is_heading(cells)), None)
    rows = upright(rows, given) if first is None else rows[first:]
    given = of_lathe(rows, given)
    if len(rows) < FEWEST_STATIONS + 1 or len(rows) > MOST_STATIONS:
        raise InputError(
            f"{path} has {len(rows)} line{'s' if len(rows) != 1 else ''}; allowed are a heading and "
            f"{FEWEST_STATIONS} to {MOST_STATIONS} stations"
        )
    where, across = _columns([name.strip() for name in rows[0][1]], rows[1:], given, path)
    along_lathe = is_lathe_axis(where.heading)
    stations, faults = [], []
    for line, row in rows[1:]:
        if not _cell(row, across):
            continue
        try:
            place = _metres(row, where, negative=along_lathe)
            stations.append((place, ACROSS[across.quantity] * _metres(row, across)))
        except InputError as error:
            faults.append(f"line {line}: {error}")
    refuse_faults(faults[:MOST_FAULTS] + ["…"] * (len(faults) > MOST_FAULTS), str(path))
    stations.sort()
    if along_lathe and stations:
        stations = from_the_knob(stations)
    stations = without_end_faces(stations)
    if len(stations) < FEWEST_STATIONS:
        raise InputError(f"{path} has {len(stations)} stations with a size; at least {FEWEST_STATIONS} are needed")
    _check_like_a_bat(stations, where, across, path)
    _check_each_once(stations, where, path)
    _check_end(stations, where, path)
    if where.from_tip:
        if length is None:
            raise InputError(f"{path} counts from the tip; say how long the bat is with --length")
        stations = sorted((length - place, size) for place, size in stations)
    blunt = length is None and stations[-1][1] > BLUNT * max(size for _, size in stations)
    if blunt and stations[0][0] > 0 and not insisted():
        raise InputError(
            f"{path} begins {format_length(stations[0][0])} from the knob and ends at {format_length(stations[-1][0])} "
            "in the full barrel, where no tip is; say how long the bat is with --length"
        )
    outline = closed(stations, length or stations[-1][0], str(path))
    if len(outline.profile) > MOST_OF_BAT:
        outline = replace(outline, profile=fewest_stations(*np.array(outline.profile).T))
    untold = [
        f"The last station, at {format_length(stations[-1][0])}, was taken as the tip; if it is not, give --length."
    ] * blunt
    return replace(outline, notes=(*outline.notes, *untold, *_doubts(stations, outline.profile[-1][0])))


def _columns(
    names: list[str], rows: Sequence[tuple[int, list[str]]], given: GivenColumns, path: Path
) -> tuple[TableColumn, TableColumn]:
    """Return the columns that say where and how thick; all that is wrong with them is refused at once."""
    found = read_headings(names, wanted=STATIONS, given=given, once=True, file_name=str(path))
    sizes = [name for name in ACROSS if found.has(name)]
    if named := [name for name in sizes if found.columns[name].heading in given.told]:
        sizes = named
    faults = [fault for name, fault in found.faults.items() if name == "station" or not named]
    if not found.has("station") and "station" not in found.faults:
        faults.append(
            "no column says where it was measured; call one position_in or in_from_tip, or say --column "
            "position=HEADING:in"
        )
    if not sizes and not set(ACROSS) & found.faults.keys():
        faults.append(
            "no column says how thick the bat is; call one diameter_mm, circumference_in or radius_cm, or say --column "
            "diameter=HEADING:mm"
        )
    if len(sizes) > 1:
        both = " and ".join(found.columns[name].heading for name in sizes)
        faults.append(f"columns {both} all say how thick it is; keep one, or say which with --column")
    if faults:
        faults.append(f"the table has: {closest(names, STATIONS)}")
    require_units(rows, found.only("station", *sizes), str(path), faults=faults)
    return found.columns["station"], found.columns[sizes[0]]


def _check_like_a_bat(
    stations: Sequence[tuple[float, float]], where: TableColumn, across: TableColumn, path: Path
) -> None:
    """Refuse what is no bat by its headings, but by others: a slip of units, of kinds, of columns."""
    reach, thick = stations[-1][0], max(size for _, size in stations)
    thin = min([size for place, size in stations if 0.05 * reach < place < 0.95 * reach], default=thick)  # round ends
    if insisted() or _like_a_bat(reach, thin, thick):
        return
    long, wide = reach / where.factor, across.heading  # nan without a unit
    meant, in_both = [], []
    for unit, size in ((unit, UNITS["length"][unit]) for unit in TRIED):
        if _like_a_bat(long * size, thin, thick):
            meant.append(f"{where.heading} counted in {unit} ({format_length(long * size)} long)")
        if _like_a_bat(reach, *(part / across.factor * size for part in (thin, thick))):
            meant.append(f"{wide} measured in {unit} (up to {format_length(thick / across.factor * size)} thick)")
        if _like_a_bat(long * size, *(part / across.factor * size for part in (thin, thick))):
            in_both.append(f"both columns in {unit} ({format_length(long * size)} long)")
    for quantity, size in ACROSS.items():
        part = size / ACROSS[across.quantity]
        if _like_a_bat(reach, thin * part, thick * part):
            meant.append(f"{wide} taken as {PLURALS[quantity]} (up to {format_length(thick * part)} thick)")
    if across.quantity == "diameter":
        swapped = sorted(place * across.factor / where.factor for place, _ in stations)
        if _like_a_bat(thick * where.factor / across.factor, swapped[len(swapped) // 4], swapped[-1]):
            meant.append(f"the columns {where.heading} and {wide} swapped")
    if meant := meant or in_both:
        raise InputError(
            f"{path} shows something {format_length(reach)} long and {format_length(thin)} to {format_length(thick)} "
            f"thick, as no bat is. It would be one with {', or with '.join(meant)}: mend the headings, or add --force "
            "if it is intended"
        )


def _like_a_bat(reach: float, thin: float, thick: float) -> bool:
    """Return whether a bat has these sizes in m, that of its thinnest part without the ends."""
    named = ("bat_length", reach), ("smallest_diameter", thin), ("greatest_diameter", thick)
    return all(verdict(name, size) == "fine" for name, size in named) and reach > SLENDER * thick


def _check_each_once(stations: Sequence[tuple[float, float]], where: TableColumn, path: Path) -> None:
    for (place, size), (following, other) in pairwise(stations):
        if place == following:
            end = " from the tip" if where.from_tip else ""
            raise InputError(
                f"{path} has two stations {format_length(place)}{end}, of {format_length(size)} and "
                f"{format_length(other)}; give each place once"
            )


def _check_end(stations: Sequence[tuple[float, float]], where: TableColumn, path: Path) -> None:
    """Refuse places that count from the other end than their heading says: a bat's thicker half is its barrel."""
    places, sizes = np.array(stations).T
    even = np.linspace(places[0], places[-1], 200)
    halves = [float(half.mean()) for half in np.split(np.interp(even, places, sizes), 2)]
    knob, barrel = reversed(halves) if where.from_tip else halves
    if insisted() or knob < THICKER * barrel:
        return
    ends = ("tip", "knob") if where.from_tip else ("knob", "tip")
    raise InputError(
        f"{path} has its thicker half where {where.heading} is {'large' if where.from_tip else 'small'}, though it "
        f"counts from the {ends[0]}. Where it counts from the {ends[1]}, call the column so, as in in_from_{ends[1]}; "
        "or add --force if it is intended"
    )


def _doubts(stations: Sequence[tuple[float, float]], length: float) -> Iterator[str]:
    """Yield in words where stations are far apart, and which is so far off its neighbours that it may be a slip."""
    for (here, size), (there, other) in pairwise(stations):
        if there - here > WIDE and abs(other - size) > EVEN:
            yield (
                f"Nothing was measured from {format_length(here)} to {format_length(there)} from the knob: taken as "
                "straight there."
            )
    off = []
    for before, (place, size), after in zip(stations, stations[1:], stations[2:], strict=False):
        part = (place - before[0]) / (after[0] - before[0])
        line = before[1] + part * (after[1] - before[1])
        near = max(place - before[0], after[0] - place) < NEIGHBOURS
        if near and BEYOND_KNOB < place < length - BEFORE_TIP and abs(size - line) > OFF_LINE:
            off.append((abs(size - line), size - line, place, size))
    if off:
        _, miss, place, size = max(off)
        yield (
            f"The diameter at {format_length(place)} from the knob, {1e3 * size:.1f} mm, is {abs(1e3 * miss):.1f} mm "
            f"{'more' if miss > 0 else 'less'} than the line between its neighbours, as no bat's of the catalogue is. "
            "Measure it again."
        )


def _cell(row: Sequence[str], column: TableColumn) -> str:
    return row[column.index].strip() if column.index < len(row) else ""


def _written_length(text: str) -> float:
    """Return a length as people write it, 2 9/16 in, in m; nan where it is none."""
    try:
        return parse(text, "length")
    except InputError:
        return math.nan


def _metres(row: Sequence[str], column: TableColumn, *, negative: bool = False) -> float:
    """Return the length in a cell, m.

    ``negative``: whether it may be below 0, as along a lathe's axis.
    """
    text = _cell(row, column)
    try:
        value = column.factor * float(text)
    except ValueError:
        value = _written_length(with_unit(text, column))
    if not math.isfinite(value) or (value < 0 and not negative):
        raise InputError(f"{column.heading} is {text!r}; allowed is a number from 0 up, as 64.5, 64.5 mm or 2 9/16")
    return value
