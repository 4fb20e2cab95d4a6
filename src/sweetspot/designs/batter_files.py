"""Files that tell of a batter: tables of contacts, and answers of fit-player."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np

from sweetspot.designs.batter import ContactPlaces, contacts_at
from sweetspot.errors import InputError, nearest_names
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_law import GREATEST_EXPONENT, SwingLaw
from sweetspot.numerics.text_files import read_text
from sweetspot.plausibility import parse
from sweetspot.tables.cells import with_unit
from sweetspot.tables.headings import TableColumn, names_one_of, read_headings
from sweetspot.tables.text_encoding import is_number, table_rows
from sweetspot.units import format_length

MOST_BYTES = 5_000_000
LEARNED = ("position", "position_spread", "offset", "offset_spread", "bat_speed", "exponent")
ENDS = ("low", "high")
UNNAMED_LEVEL = 0.95
"""Level of the intervals of files that do not name it, as fit-player of 0.1 wrote them."""
CONTACTS = ("from_tip", "contact_weight", "batter")
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
    rows = list(table_rows(text, path, is_heading=lambda cells: names_one_of(cells, ("from_tip",))))
    if len(rows) < 2:
        raise InputError(f"{path} holds no contact; give a heading from_tip_in and a line for every contact")
    names = [name.strip() for name in rows[0][1]]
    columns = read_headings(names, wanted=CONTACTS, file_name=str(path)).columns
    place_column, weight_column = columns.get("from_tip"), columns.get("contact_weight")
    if place_column is None or not place_column.from_tip:
        raise InputError(f"{path} has the columns {', '.join(names)}; name one of them from_tip_in or from_tip_m")
    for line, cells in rows[1:]:
        if any(cell.strip() for cell in cells[len(names) :]):
            raise InputError(
                f"{path}, line {line} has {len(cells)} values for {len(names)} columns; write decimals with a point, "
                "or separate the columns by semicolons"
            )
    padded = [(line, cells + [""] * (len(names) - len(cells))) for line, cells in rows[1:]]
    lines = [(line, cells) for line, cells in padded if cells[place_column.index].strip()]
    lines = _of_batter(lines, columns["batter"].index if "batter" in columns else None, batter, path)
    try:
        place = np.array([_place(cells[place_column.index], place_column, line) for line, cells in lines])
        share = np.ones(len(lines))
        if weight_column is not None:
            share = np.array([_weight(cells[weight_column.index], line) for line, cells in lines])
        return contacts_at(place, share)
    except InputError as error:
        raise InputError(f"{path}, {error}") from None


def _place(text: str, column: TableColumn, line: int) -> float:
    """Return a place, m from the tip."""
    try:
        place = parse(text if column.has_no_unit else with_unit(text, column), "length", "from_tip")
    except InputError as error:
        raise InputError(f"line {line}: {error}") from None
    if not 0 <= place <= LONGEST:
        raise InputError(
            f"line {line}: {text.strip()} was given, {format_length(place)} from the tip; allowed is a place on a bat, "
            f"0 to {format_length(LONGEST)}: check the unit"
        )
    return place


def _weight(text: str, line: int) -> float:
    value = float(text) if is_number(text) and text.strip() else math.nan
    if not 0 <= value < math.inf:
        raise InputError(f"line {line}: the weight {text.strip()} was given; allowed is a number from 0 up")
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

    With them come the exponent of bat speed against moment of inertia; ``position_doubt`` in m, ``exponent_doubt``, and
    ``position_spread_doubt`` (of the logarithm), each one standard deviation by the file's intervals, whose level it
    names; ``bat_speed_from_tip``, where bat speed is measured; and ``balls``: how many swings were used; 0 where the
    file does not say.
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
        low, high = (_learned(parameters["exponent"], end) for end in ENDS)
        values["exponent_doubt"] = (high - low) / (2 * reach)
        values["bat_speed_from_tip"] = float(table.get("bat_speed_from_tip_m", SPEED_FROM_TIP))
        values["balls"] = float(table.get("swings", {}).get("used", 0))
    except (ValueError, KeyError, TypeError, AttributeError, ArithmeticError) as error:
        lacks = (
            f"has no {error.args[0]}"
            if isinstance(error, KeyError)
            else "has something else where its numbers should be"
        )
        raise InputError(f"{path} is not what fit-player writes: it {lacks}; {ADVICE}") from None
    return values


def law_of_player(law: SwingLaw, player: Mapping[str, float]) -> SwingLaw:
    """Return a swing law with the exponent that a player's swings leave likely, of `fitted_player`."""
    exponent = min(max(round(player["exponent"], 3), 0.0), GREATEST_EXPONENT)  # no more digits are known
    return replace(law, exponent=exponent, exponent_spread=player["exponent_doubt"])


def _learned(numbers: Mapping[str, float | str], start: str = "value") -> float:
    """Return the value of a parameter, or an end of its interval, whatever unit its key ends in."""
    for key, value in numbers.items():
        if key.startswith(start):
            return float(value)
    if start in ENDS:  # a value reported without an interval
        return _learned(numbers)
    raise KeyError("a parameter without a value")
