"""A bat's outline from a table of stations: caliper or tape at every inch, in any unit, from either end."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from sweetspot.calibration.outline.measured_outline import Outline, closed
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.plausibility import insisted, parse, verdict
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, heading_and_unit
from sweetspot.tables.text_encoding import FIRST_LINES, table_rows
from sweetspot.tables.unit_words import FILE_UNITS
from sweetspot.units import FOOT, INCH, NUMBER, format_length

UNITS = {
    **dict.fromkeys(("in", "inch", "inches", '"', "\u2033"), "in"), **dict.fromkeys(("ft", "foot", "feet"), "ft"),
    **{word: unit for unit, prefix in (("mm", "milli"), ("cm", "centi"), ("m", ""))
       for word in (unit, *(f"{prefix}{metre}" for metre in ("meter", "meters", "metre", "metres")))},
}  # fmt: skip
"""Words of a heading, and the unit that they are."""
METRES = {"in": INCH, "ft": FOOT, "mm": 1e-3, "cm": 1e-2, "m": 1.0}
"""m of a unit."""
SPELT = {"in": "inches", "ft": "feet"}
"""Units whose sign may be taken for a word."""
KINDS = {"diameters": 1.0, "circumferences": 1 / math.pi, "radii": 2.0}
"""What is measured across, and the diameter per unit of it."""
SIZES = {
    **dict.fromkeys(("diameter", "dia", "diam", "od", "d", "ø", "\u2300", "width", "thickness"), KINDS["diameters"]),
    **dict.fromkeys(("circumference", "circ", "girth", "perimeter"), KINDS["circumferences"]),
    **dict.fromkeys(("radius", "r"), KINDS["radii"]),
}
"""Words for it."""
PLACES = {"position", "station", "place", "x", "from", "tip", "knob", "distance", "location", "length"}
FROM_END = {"knob": False, "handle": False, "grip": False, "butt": False, "tip": True, "barrel": True, "cap": True}
"""Words of the end from which places count, and whether it is the tip."""
OTHER = {"wall", "inner", "inside", "id", "error", "sigma", "sd", "std", "uncertainty", "tolerance"}
"""Words of a column that is not the outline, whatever else its heading says."""
WORD = re.compile('[^\\W\\d_]+|["\u2033\u2300]')
COMMENT = "#"
MOST_STATIONS = 2000
FEWEST_STATIONS = 5
WIDE, EVEN = 3.05 * INCH, 1e-5
"""m between stations from which on what lies between is told as unknown (a straight line over 3 in misses up to 2.6 mm
of the catalogue's bats, a torpedo's barrel), unless both are as thick: a cylinder that somebody drew."""
OFF_LINE, NEIGHBOURS = 3e-3, 1.1 * INCH
"""m that a diameter may be off the line between its neighbours, where these are no farther away: an inch apart, the
catalogue's bats reach 1.8 mm."""
BLUNT = 0.93
"""Of the greatest diameter: turned tips are rounded to less; blunt ones, as of metal bats, are told of needlessly."""
SLENDER = 8.0
"""Length over greatest diameter of bats at least; those of the catalogue have 11 or more."""
THICKER = 1.05
"""Mean of the knob's half over that of the barrel's from which on a bat was measured from its other end."""
BEYOND_KNOB, BEFORE_TIP = 4 * INCH, 2.5 * INCH
"""m from the ends, where knobs and tips turn quicker."""


@dataclass(frozen=True)
class _Column:
    """Where and how thick: which column says it.

    Parameters
    ----------
    heading : as it is written.
    unit : of numbers that have none themselves; None: they must have one.
    size : diameter per what is measured.
    from_tip : whether places count from the tip.
    """

    index: int
    heading: str
    unit: str | None
    size: float = 1.0
    from_tip: bool = False


def read_stations(path: Path, *, length: float | None = None, given: GivenColumns = NOTHING_GIVEN) -> Outline:
    """Return the outline that a CSV file of stations describes.

    One column says where: its heading has ``tip`` where it counts from the tip (``in_from_tip``, ``position_mm``).
    Another says how thick: ``diameter``, ``circumference`` or ``radius``. Units stand in the headings or behind the
    numbers, which may be fractions. What stands above the headings, and lines that begin with #, are left out; so are
    stations whose size is blank. Where no station is at an end, the tip is rounded as turned bats usually are, and the
    knob goes on as thick as it was.

    Parameters
    ----------
    length : m; needed where the places count from the tip, or where the last station is not the tip.
    given : what a person says of the columns position (position_from_tip), diameter, circumference or radius.

    Raises
    ------
    InputError
        when the file has no such columns, a value that is no number, or stations off the bat.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice="give a CSV file of a heading and a line for each station")

    def is_heading(cells: Sequence[str]) -> bool:
        return all(_all_columns(cells, given))

    rows = [
        (line, cells)
        for line, cells in table_rows(text, path, is_heading=is_heading)
        if not cells[0].lstrip().startswith(COMMENT)
    ]
    first = next((index for index, (_, cells) in enumerate(rows[:FIRST_LINES]) if is_heading(cells)), 0)
    rows = rows[first:]
    if len(rows) < FEWEST_STATIONS + 1 or len(rows) > MOST_STATIONS:
        raise InputError(
            f"{path} has {len(rows)} line{'s' if len(rows) != 1 else ''}; allowed are a heading and "
            f"{FEWEST_STATIONS} to {MOST_STATIONS} stations"
        )
    where, across = _columns(rows[0][1], given, path)
    stations = sorted(
        (_number(row, where, line, path), _number(row, across, line, path))
        for line, row in rows[1:]
        if _cell(row, across)
    )
    if len(stations) < FEWEST_STATIONS:
        raise InputError(f"{path} has {len(stations)} stations with a size; at least {FEWEST_STATIONS} are needed")
    _check_like_a_bat(stations, where, across, path)
    _check_each_once(stations, where, path)
    _check_end(stations, where, path)
    if where.from_tip:
        if length is None:
            raise InputError(f"{path} counts from the tip; say how long the bat is with --length")
        stations = sorted((length - place, size) for place, size in stations)
    outline = closed(stations, length or stations[-1][0], str(path))
    blunt = length is None and stations[-1][1] > BLUNT * max(size for _, size in stations)
    untold = [
        f"The last station, at {format_length(stations[-1][0])}, was taken as the tip; if it is not, give --length."
    ] * blunt
    return replace(outline, notes=(*outline.notes, *untold, *_doubts(stations, outline.profile[-1][0])))


def _check_like_a_bat(stations: Sequence[tuple[float, float]], where: _Column, across: _Column, path: Path) -> None:
    """Refuse what is no bat by its headings, but by others: a slip of units, of kinds, of columns."""
    reach, thick = stations[-1][0], max(size for _, size in stations)
    thin = min([size for place, size in stations if 0.05 * reach < place < 0.95 * reach], default=thick)  # round ends
    if insisted() or _like_a_bat(reach, thin, thick):
        return
    places, widths = METRES.get(where.unit or ""), METRES.get(across.unit or "")
    meant, in_both = [], []
    for sign, size in METRES.items():
        unit = SPELT.get(sign, sign)
        if places and _like_a_bat(reach / places * size, thin, thick):
            meant.append(f"{where.heading} counted in {unit} ({format_length(reach / places * size)} long)")
        if widths and _like_a_bat(reach, thin / widths * size, thick / widths * size):
            meant.append(f"{across.heading} measured in {unit} (up to {format_length(thick / widths * size)} thick)")
        if places and widths and _like_a_bat(*(x * size for x in (reach / places, thin / widths, thick / widths))):
            in_both.append(f"both columns in {unit} ({format_length(reach / places * size)} long)")
    for kind, size in KINDS.items():
        if _like_a_bat(reach, thin / across.size * size, thick / across.size * size):
            meant.append(f"{across.heading} taken as {kind} (up to {format_length(thick / across.size * size)} thick)")
    if places and widths and across.size == 1:
        swapped = sorted(place * widths / places for place, _ in stations)
        if _like_a_bat(thick * places / widths, swapped[len(swapped) // 4], swapped[-1]):
            meant.append(f"the columns {where.heading} and {across.heading} swapped")
    meant = meant or in_both
    if meant:
        raise InputError(
            f"{path} shows something {format_length(reach)} long and {format_length(thin)} to {format_length(thick)} "
            f"thick, as no bat is. It would be one with {', or with '.join(meant)}: mend the headings, or add --force "
            "if it is meant"
        )


def _like_a_bat(reach: float, thin: float, thick: float) -> bool:
    """Return whether a bat has these sizes in m, that of its thinnest part without the ends."""
    named = ("bat_length", reach), ("smallest_diameter", thin), ("greatest_diameter", thick)
    return all(verdict(name, size) == "fine" for name, size in named) and reach > SLENDER * thick


def _check_each_once(stations: Sequence[tuple[float, float]], where: _Column, path: Path) -> None:
    for (place, size), (following, other) in pairwise(stations):
        if place == following:
            end = " from the tip" if where.from_tip else ""
            raise InputError(
                f"{path} has two stations {format_length(place)}{end}, of {format_length(size)} and "
                f"{format_length(other)}; give each place once"
            )


def _check_end(stations: Sequence[tuple[float, float]], where: _Column, path: Path) -> None:
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
        "or add --force if it is meant"
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


def _words(heading: str) -> list[str]:
    return WORD.findall(heading.lower())


def _all_columns(heading: Sequence[str], given: GivenColumns) -> tuple[list[_Column], list[_Column]]:
    """Return the columns that say where, and those that say how thick; where a person named some, only those."""
    names = [text.strip() for text in heading]
    said = _said(given, names)
    usual = None if given.units is None else FILE_UNITS[given.units]["length"]
    where: list[_Column] = []
    across: list[_Column] = []
    for index, text in enumerate(names):
        words = _words(said.get(text, text))
        units = [UNITS[word] for word in words if word in UNITS]
        unit = next((one for one in units if one != "in"), units[0] if units else usual)  # "diameter in mm"
        size = next((SIZES[word] for word in words if word in SIZES), None)
        if OTHER & set(words):
            continue
        if size is not None:
            across.append(_Column(index, text, unit, size))
        elif PLACES & set(words) or (words and set(words) <= set(UNITS)):
            end = next((FROM_END[word] for word in words if word in FROM_END), False)
            where.append(_Column(index, text, unit, from_tip=end))
    return _named(where, said), _named(across, said)


def _said(given: GivenColumns, names: Sequence[str]) -> dict[str, str]:
    """Return what the headings that a person named would be called by us, each with its unit."""
    parts = ((quantity, *heading_and_unit(text, names)) for quantity, text in given.headings.items())
    return {name: f"{quantity} {unit}" for quantity, name, unit in parts}


def _named(columns: list[_Column], said: Mapping[str, str]) -> list[_Column]:
    return [one for one in columns if one.heading in said] or columns


def _columns(heading: Sequence[str], given: GivenColumns, path: Path) -> tuple[_Column, _Column]:
    """Return the columns that say where and how thick."""
    names = [text.strip() for text in heading]
    if lost := [name for name in _said(given, names) if name not in names]:
        raise InputError(f"{path} has no column {' and no column '.join(lost)}; its columns are {', '.join(names)}")
    if wrong := [name for name in given.headings if not {*SIZES, *PLACES} & set(_words(name))]:
        raise InputError(
            f"{wrong[0]} is no column of an outline; allowed are position, position_from_tip, diameter, circumference "
            "and radius"
        )
    where, across = _all_columns(heading, given)
    if not where or not across:
        raise InputError(
            f"{path} begins with {', '.join(heading)!r}; name one column like in_from_tip or position_mm and one like "
            "diameter_mm, circumference_in or radius_cm, with commas, semicolons or tabs between columns; or say "
            "--column position=HEADING:in and --column diameter=HEADING:mm"
        )
    if len(across) > 1:
        raise InputError(
            f"{path} has {len(across)} columns of sizes, {', '.join(one.heading for one in across)}; keep one, of "
            "readings that were repeated their mean"
        )
    return where[0], across[0]


def _cell(row: Sequence[str], column: _Column) -> str:
    return row[column.index].strip() if column.index < len(row) else ""


def _number(row: Sequence[str], column: _Column, line: int, path: Path) -> float:
    """Return what a cell says in m; a number without a unit has its column's."""
    text = _cell(row, column)
    what = f"{path}, line {line}"
    bare = NUMBER.match(text.replace(",", ".")) is not None or _is_one_sign(text)
    if bare and column.unit is None:
        raise InputError(
            f"{what}: {text!r} has no unit; write it in the heading, as in diameter_mm, or say "
            "--file-units us (inches) or metric (cm)"
        )
    try:
        value = float(text) * METRES[column.unit or ""]
    except (KeyError, ValueError):
        value = _spelled(f"{text} {column.unit}" if bare else text)
    if not math.isfinite(value) or value < 0:
        raise InputError(f"{what}: {text!r} was given; allowed is a number from 0 up, as 64.5, 64.5 mm or 2 9/16")
    return value * column.size


def _spelled(text: str) -> float:
    """Return a length with its unit in m; nan where it is none."""
    try:
        return parse(text, "length")
    except InputError:
        return math.nan


def _is_one_sign(text: str) -> bool:
    """Return whether a text is a number that ends in a sign such as one half's."""
    return re.fullmatch("\\d*\\s*[¼-¾⅐-⅞]", text) is not None
