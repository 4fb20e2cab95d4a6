"""Files that tell of a batter: tables of contacts, and answers of fit-player."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np

from sweetspot.designs.batter import ContactPlaces, contacts_at
from sweetspot.errors import InputError, nearest_names
from sweetspot.numerics.text_files import read_text
from sweetspot.plausibility import parse
from sweetspot.tables.text_encoding import table_rows
from sweetspot.units import INCH, format_length

MOST_BYTES = 5_000_000
LEARNED = ("position", "position_spread", "offset", "offset_spread", "bat_speed")
ENDS = ("low", "high")
UNNAMED_LEVEL = 0.95
"""Level of the intervals of files that do not name it, as fit-player of 0.1 wrote them."""
PLACE_HEADS = {
    "from_tip_in": INCH,
    "from_tip_m": 1.0,
    "from_tip_cm": 0.01,
    "from_tip_mm": 1e-3,
    "from_tip_ft": 12 * INCH,
    "from_tip": None,
}
"""Headings of a column of places with the size of their unit in m; None: every value brings its own."""
ADVICE = "give the file that fit-player --out writes, player.json"
LONGEST = 1.1
"""m: no bat is longer."""


def contacts_of_file(path: Path, *, batter: str | None = None) -> ContactPlaces:
    """Return the contacts of a CSV file: a column ``from_tip_in``, and perhaps ``weight``.

    The column may also be called ``from tip (cm)`` and the like; without a unit in its heading every value needs one.
    Lines without a place are left out, as in the table of a season whose balls were not all met by a barrel.

    ``batter``: whose lines count, by a column ``batter``; None: all lines, which have to be one batter's.
    """
    text = read_text(path, most=MOST_BYTES, advice="a contact table is a few lines of CSV")
    rows = list(table_rows(text, path, is_heading=lambda cells: any(_head(cell) in PLACE_HEADS for cell in cells)))
    if len(rows) < 2:
        raise InputError(f"{path} holds no contact; give a heading from_tip_in and a line for every contact")
    heads = [_head(cell) for cell in rows[0][1]]
    column = next((number for number, head in enumerate(heads) if head in PLACE_HEADS), None)
    if column is None:
        raise InputError(f"{path} has the columns {', '.join(heads)}; name one of them from_tip_in or from_tip_m")
    for line, cells in rows[1:]:
        if len(cells) > len(heads) and any(cell.strip() for cell in cells[len(heads) :]):
            raise InputError(
                f"{path}, line {line} has {len(cells)} values for {len(heads)} columns; write decimals with a point, "
                "or separate the columns by semicolons"
            )
    padded = [(line, cells + [""] * (len(heads) - len(cells))) for line, cells in rows[1:]]
    lines = [(line, cells) for line, cells in padded if cells[column].strip()]
    lines = _of_batter(lines, heads.index("batter") if "batter" in heads else None, batter, path)
    place = np.array([_place(cells[column], heads[column], path, line) for line, cells in lines])
    share = np.ones(len(lines))
    if "weight" in heads:
        share = np.array([_weight(cells[heads.index("weight")], path, line) for line, cells in lines])
    try:
        return contacts_at(place, share)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _head(cell: str) -> str:
    """Return a heading in small letters and underscores: "From tip (in)" is from_tip_in."""
    return "_".join(part for part in re.split(r"[^a-z0-9]+", cell.lower()) if part)


def _place(text: str, head: str, path: Path, line: int) -> float:
    """Return a place, m from the tip."""
    size = PLACE_HEADS[head]
    if size is not None:
        place = _number(text, path, line) * size
    else:
        try:
            place = parse(text, "length", "from_tip")
        except InputError as error:
            raise InputError(f"{path}, line {line}: {error}") from None
    if not 0 <= place <= LONGEST:
        raise InputError(
            f"{path}, line {line}: {text.strip()} was given, {format_length(place)} from the tip; allowed is a place "
            f"on a bat, 0 to {format_length(LONGEST)}: check the unit"
        )
    return place


def _weight(text: str, path: Path, line: int) -> float:
    value = _number(text, path, line)
    if value < 0:
        raise InputError(f"{path}, line {line}: the weight {text.strip()} was given; allowed is 0 or more")
    return value


def _of_batter(
    lines: list[tuple[int, list[str]]], column: int | None, batter: str | None, path: Path
) -> list[tuple[int, list[str]]]:
    """Return the lines of one batter."""
    if column is None:
        if batter is not None:
            raise InputError(
                f"{path} has no column batter, so that {batter!r} cannot be found in it; leave --batter out"
            )
        return lines
    names = sorted({cells[column].strip() for _, cells in lines})
    if batter is None and len(names) > 1:
        raise InputError(
            f"{path} holds contacts of {len(names)} batters; name one of them by --batter: {names[0]}, ..."
        )
    if batter is not None and batter not in names:
        raise InputError(f"{path} holds no contact of the batter {batter!r}. {nearest_names(batter, names)}")
    return [(line, cells) for line, cells in lines if batter is None or cells[column].strip() == batter]


def fitted_player(path: Path) -> dict[str, float]:
    """Return a player's parameters from `sweetspot fit-player --format json`: position, offset, their spreads, speeds.

    With them come ``position_doubt`` in m and ``position_spread_doubt`` (of the logarithm), each one standard
    deviation by the file's intervals, whose level it names, and ``balls``: how many swings were used; 0 where the file
    does not say.
    """
    text = read_text(path, most=MOST_BYTES, advice=ADVICE)
    try:
        table: Any = json.loads(text)
    except ValueError as error:
        raise InputError(f"{path} is no JSON ({error}); {ADVICE}") from None
    try:
        parameters = table["parameters"]
        values = {name: _learned(parameters[name]) for name in LEARNED}
        values["pitch_speed"] = float(table["pitch_speed_m_s"])
        reach = NormalDist().inv_cdf((1 + float(table.get("interval_level", UNNAMED_LEVEL))) / 2)
        low, high = (_learned(parameters["position"], end) for end in ENDS)
        values["position_doubt"] = (high - low) / (2 * reach)
        low, high = (_learned(parameters["position_spread"], end) for end in ENDS)
        values["position_spread_doubt"] = math.log(high / low) / (2 * reach)
        values["balls"] = float(table.get("swings", {}).get("used", 0))
    except (ValueError, KeyError, TypeError, AttributeError, ArithmeticError) as error:
        lacks = (
            f"has no {error.args[0]}"
            if isinstance(error, KeyError)
            else "has something else where its numbers should be"
        )
        raise InputError(f"{path} is not what fit-player writes: it {lacks}; {ADVICE}") from None
    return values


def _learned(numbers: dict[str, Any], start: str = "value") -> float:
    """Return the value of a parameter, or an end of its interval, whatever unit its key ends in."""
    for key, value in numbers.items():
        if key.startswith(start):
            return float(value)
    if start in ENDS:  # a value reported without an interval
        return _learned(numbers)
    raise KeyError("a parameter without a value")


def _number(text: str, path: Path, line: int) -> float:
    try:
        value = float(text.strip())
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"{path}, line {line}: {text!r} was given; allowed is a number without its unit")
    return value
