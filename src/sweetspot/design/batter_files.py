"""Files that tell of a batter: tables of contacts, and answers of fit-player."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from sweetspot.design.contacts import Contacts, contacts_at
from sweetspot.errors import InputError, nearest_names
from sweetspot.motion.swing_law import TWO_SIDED_95
from sweetspot.numerics.text_files import read_text
from sweetspot.units import INCH

MOST_BYTES = 5_000_000
LEARNED = ("position", "position_spread", "offset", "offset_spread", "bat_speed")
ENDS = ("low", "high")
PLACE_HEADS = {"from_tip_in": INCH, "from_tip_m": 1.0, "from_tip_cm": 0.01, "from_tip_mm": 1e-3}


def contacts_of_file(path: Path, *, batter: str | None = None) -> Contacts:
    """Return the contacts of a CSV file: a column ``from_tip_in``, and perhaps ``weight``.

    Lines without a place are left out, as in the table of a season whose balls were not all met by a barrel.

    Parameters
    ----------
    batter : whose lines count, by a column ``batter``; None: all lines, which have to be one batter's.

    Raises
    ------
    InputError
        when the file has no such column, several batters and none was named, no contact in it, or a value that is no
        place on a bat.
    """
    rows = list(
        csv.DictReader(read_text(path, most=MOST_BYTES, advice="a contact table is a few lines of CSV").splitlines())
    )
    heads = {name.strip().lower(): name for name in (rows[0] if rows else {}) if name}
    if not rows:
        raise InputError(f"{path} holds no contact; give a heading from_tip_in and a line for every contact")
    head = next((name for name in heads if name in PLACE_HEADS), None)
    if head is None:
        raise InputError(f"{path} has the columns {', '.join(heads)}; name one of them from_tip_in or from_tip_m")
    lines = [(line, row) for line, row in enumerate(rows, 2) if (row[heads[head]] or "").strip()]
    lines = _of_batter(lines, heads.get("batter"), batter, path)
    place = np.array([_number(row[heads[head]], path, line) for line, row in lines]) * PLACE_HEADS[head]
    share = np.ones(len(lines))
    if "weight" in heads:
        share = np.array([_number(row[heads["weight"]], path, line) for line, row in lines])
    try:
        return contacts_at(place, share)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _of_batter(
    lines: list[tuple[int, dict[str, Any]]], head: str | None, batter: str | None, path: Path
) -> list[tuple[int, dict[str, Any]]]:
    """Return the lines of one batter."""
    if head is None:
        if batter is not None:
            raise InputError(
                f"{path} has no column batter, so that {batter!r} cannot be found in it; leave --batter out"
            )
        return lines
    known = sorted({str(row[head]).strip() for _, row in lines})
    if batter is None and len(known) > 1:
        raise InputError(
            f"{path} holds contacts of {len(known)} batters; name one of them by --batter: {known[0]}, ..."
        )
    if batter is not None and batter not in known:
        raise InputError(f"{path} holds no contact of the batter {batter!r}. {nearest_names(batter, known)}")
    return [(line, row) for line, row in lines if batter is None or str(row[head]).strip() == batter]


def fitted_player(path: Path) -> dict[str, float]:
    """Return what `sweetspot fit-player --format json` says of a player: position, offset and their spreads, speeds.

    With them come ``position_doubt`` in m and ``position_spread_doubt`` (of the logarithm), each one standard
    deviation by the file's 95 % intervals, and ``balls``: how many swings were used; 0 where the file does not say.

    Raises
    ------
    InputError
        when the file is no such answer.
    """
    text = read_text(path, most=MOST_BYTES, advice="give the file that fit-player --out writes, player.json")
    try:
        found: Any = json.loads(text)
        parameters = found["parameters"]
        values = {name: _learned(parameters[name]) for name in LEARNED}
        values["pitch_speed"] = float(found["pitch_speed_m_s"])
        low, high = (_learned(parameters["position"], end) for end in ENDS)
        values["position_doubt"] = (high - low) / (2 * TWO_SIDED_95)
        low, high = (_learned(parameters["position_spread"], end) for end in ENDS)
        values["position_spread_doubt"] = math.log(high / low) / (2 * TWO_SIDED_95)
        values["balls"] = float(found.get("swings", {}).get("used", 0))
    except (ValueError, KeyError, TypeError, AttributeError, ArithmeticError) as error:
        raise InputError(f"{path} is not an answer of sweetspot fit-player --format json: {error}") from None
    return values


def _learned(one: dict[str, Any], start: str = "value") -> float:
    """Return the value of a parameter, or an end of its interval, whatever unit its key ends in."""
    for key, value in one.items():
        if key.startswith(start):
            return float(value)
    if start in ENDS:  # a value that is told without an interval
        return _learned(one)
    raise KeyError("a parameter without a value")


def _number(text: str | None, path: Path, line: int) -> float:
    try:
        value = float((text or "").strip())
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"{path}, line {line}: {text!r} was given; allowed is a number without its unit")
    return value
