"""Who the bat is for: where and how high the ball is met, how fast the swing is, and how it depends on the bat."""

from __future__ import annotations

import csv
import json
import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from sweetspot.errors import InputError, nearest_names
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.text_files import read_text
from sweetspot.units import INCH, shown

FROM_TIP = np.arange(0.25, 13.0, 0.5) * INCH
"""m from the tip where every bat is hit."""
OFFSETS = np.linspace(-2.0, 2.0, 41)
"""Standard deviations of the offset that are summed over."""
FARTHEST = 16 * INCH
MOST_BYTES = 5_000_000
RARE = 0.02
"""Part of the contacts on either side that is left out: the farthest of a scatter would be met once in a career."""
USUAL_PLACES = 8
LEARNED = ("position", "position_spread", "offset", "offset_spread", "bat_speed")
USUAL = {"position": 0.1651, "position_spread": 0.04572, "offset": 0.00508, "offset_spread": 0.02794}
"""m: the middles of what is known of players before any swing (`player_priors.toml`)."""
PLACE_HEADS = {"from_tip_in": INCH, "from_tip_m": 1.0, "from_tip_cm": 0.01, "from_tip_mm": 1e-3}


@dataclass(frozen=True)
class Batter:
    """A batter with the present bat.

    Parameters
    ----------
    weight : part of the contacts at every place of `FROM_TIP`, shape (places,), summing to 1.
    offset, offset_spread : mean and standard deviation of the ball's centre above the bat's axis, m.
    bat_speed : m/s with the present bat, ``speed_from_tip`` m from its tip.
    pitch_speed : m/s at the plate; 0: a tee.
    law : of bat speed against moment of inertia; None: every bat is swung alike.
    doubt : standard deviation in m of where the mean contact lies.
    speed_from_tip : m.
    """

    weight: Array
    offset: float
    offset_spread: float
    bat_speed: float
    pitch_speed: float
    law: SwingLaw | None
    doubt: float
    speed_from_tip: float = 6 * INCH

    @property
    def mean_contact(self) -> float:
        """Mean place of contact, m from the tip."""
        return float(self.weight @ FROM_TIP)

    def moved(self, distance: float) -> Batter:
        """Return the same batter who meets every ball ``distance`` m nearer the hands; what leaves the bat is lost."""
        weight = np.interp(FROM_TIP - distance, FROM_TIP, self.weight, left=0.0, right=0.0)
        return replace(self, weight=weight / weight.sum())


def usual_places(batter: Batter) -> IntArray:
    """Return which of `FROM_TIP` lie evenly among all but the rarest of a batter's contacts, shape (places,)."""
    before = np.cumsum(batter.weight) - batter.weight
    inside = np.flatnonzero((before + batter.weight > RARE) & (before < 1 - RARE))
    return np.asarray(inside[np.unique(np.linspace(0, len(inside) - 1, USUAL_PLACES).round().astype(int))])


def normal_contact(mean: float, spread: float) -> Array:
    """Return the parts of contacts at `FROM_TIP` of a batter who meets the ball at ``mean`` m, give or take ``spread``.

    Raises
    ------
    InputError
        when mean or spread are none that a batter has.
    """
    if not 0 < mean < FARTHEST:
        raise InputError(
            f"contact is {shown(mean)} from the tip; allowed is more than 0 and less than {shown(FARTHEST)}"
        )
    if not 0.1 * INCH <= spread <= 6 * INCH:
        raise InputError(f"the contacts spread by {shown(spread)}; allowed is {shown(0.1 * INCH)} to {shown(6 * INCH)}")
    weight = np.exp(-(((FROM_TIP - mean) / spread) ** 2) / 2)
    if weight.sum() < 1e-9:
        raise InputError(f"contact {shown(mean)} from the tip lies beyond what is computed; allowed is up to 13 in")
    return np.asarray(weight / weight.sum())


def contacts_of_file(path: Path, *, batter: str | None = None) -> Array:
    """Return the parts of contacts at `FROM_TIP` of a CSV file: a column ``from_tip_in``, and perhaps ``weight``.

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


def contacts_at(place: Array, share: Array | None = None) -> Array:
    """Return the parts of contacts at `FROM_TIP` of single ones.

    Parameters
    ----------
    place : m from the tip, shape (n,).
    share : how much each counts, shape (n,); None: all alike.

    Raises
    ------
    InputError
        when none lies on a bat, or one counts less than nothing.
    """
    share = np.ones(len(place)) if share is None else share
    usable = (place >= 0) & (place <= FROM_TIP[-1] + 0.25 * INCH)
    if not np.any(share[usable] > 0) or np.any(share < 0):
        raise InputError("no contact on the outer 13 in of a bat was given; check its unit and its weights")
    edges = np.concatenate([FROM_TIP - 0.25 * INCH, [FROM_TIP[-1] + 0.25 * INCH]])
    counts, _ = np.histogram(place[usable], bins=edges, weights=share[usable])
    spread = np.convolve(counts, [0.25, 0.5, 0.25], mode="same")  # a table knows places to half an inch
    return np.asarray(spread / spread.sum())


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
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"{path} is not an answer of sweetspot fit-player --format json: {error}") from None
    return values


def _learned(one: dict[str, Any]) -> float:
    """Return the value of a parameter, whatever unit its key ends in."""
    for key, value in one.items():
        if key.startswith(("value", "mean", "median")):
            return float(value["value"] if isinstance(value, dict) else value)
    raise KeyError("a parameter without a value")


def _number(text: str | None, path: Path, line: int) -> float:
    try:
        value = float((text or "").strip())
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"{path}, line {line}: {text!r} was given; allowed is a number without its unit")
    return value
