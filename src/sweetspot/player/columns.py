"""What the columns of a swing file mean: names of measuring systems and plain ones, and their units.

A plain name carries its unit (``bat_speed_mph``, ``Exit Velocity [km/h]``). Names that belong to one system are in
the units of that system. Any other needs to be told whether the file is in US or metric units.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date, datetime
from typing import Literal

from sweetspot.errors import InputError, maybe_meant_heading
from sweetspot.units import FOOT, INCH, MPH

Units = Literal["us", "metric"]

SPEEDS = {
    "mph": MPH,
    "mi_h": MPH,
    "m_s": 1.0,
    "mps": 1.0,
    "km_h": 1 / 3.6,
    "kmh": 1 / 3.6,
    "kph": 1 / 3.6,
    "ft_s": FOOT,
    "fps": FOOT,
}
ANGLES = dict.fromkeys(("deg", "degree", "degrees", "°"), math.pi / 180) | dict.fromkeys(
    ("rad", "radian", "radians"), 1.0
)
LENGTHS = {"in": INCH, "inch": INCH, "inches": INCH, "m": 1.0, "cm": 0.01, "mm": 0.001}
PLACES = {
    f"{unit}_from_{end}": factor
    for unit, factor in LENGTHS.items()
    for end in ("knob", "tip", "the_tip", "the_knob")
}  # fmt: skip
UNITS: dict[str, dict[str, float]] = {
    "bat_speed": SPEEDS,
    "exit_speed": SPEEDS,
    "pitch_speed": SPEEDS,
    "release_speed": SPEEDS,
    "launch_angle": ANGLES,
    "attack_angle": ANGLES,
    "position": PLACES,
    "bat": {},
    "batter": {},
    "date": {},
    "outcome": {},
}
"""Quantities that are understood, and the units of each with their size in SI."""
TEXTS = ("bat", "batter", "date", "outcome")
NEEDED = ("bat_speed", "exit_speed")
"""At least one of these."""

DATE_FORMATS = ("%Y-%m-%d", "%m/%d/%Y", "%m/%d/%y", "%Y/%m/%d", "%b %d, %Y", "%B %d, %Y", "%d.%m.%Y")

ALIASES: dict[str, tuple[str, ...]] = {
    "bat_speed": ("bat_speed", "batspeed", "swing_speed", "barrel_speed", "bat_head_speed", "bat_velocity"),
    "exit_speed": ("exit_speed", "exit_velocity", "exitvelocity", "exitvelo", "exit_velo", "ev", "exitspeed",
                   "batted_ball_speed", "hit_speed"),
    "pitch_speed": ("pitch_speed", "pitch_velocity", "plate_speed", "pitchspeed"),
    "release_speed": ("release_speed", "release_velocity", "relspeed"),
    "launch_angle": ("launch_angle", "launchangle", "vertical_angle", "vertical_launch_angle"),
    "attack_angle": ("attack_angle", "attackangle"),
    "position": ("position", "impact_position", "contact_position", "impact_location", "contact", "contact_point",
                 "impact", "impact_point"),
    "bat": ("bat", "equipment", "bat_name", "bat_used", "bat_model"),
    "batter": ("batter", "batter_id", "batter_name", "player", "player_name", "player_id", "hitter", "hitter_name",
               "user", "user_name", "athlete", "athlete_name", "name"),
    "date": ("date", "game_date", "swing_date", "time_stamp", "timestamp", "datetime", "date_time"),
    "outcome": ("outcome", "pitch_result", "pitch_outcome"),
}  # fmt: skip
"""Plain names that need a unit."""

US_UNITS = {"bat_speed": "mph", "exit_speed": "mph", "pitch_speed": "mph", "release_speed": "mph",
            "launch_angle": "deg", "attack_angle": "deg", "position": "in_from_tip"}  # fmt: skip
METRIC_UNITS = US_UNITS | {quantity: "m_s" for quantity, unit in US_UNITS.items() if unit == "mph"} | {
    "position": "cm_from_tip"
}  # fmt: skip


@dataclass(frozen=True)
class System:
    """A measuring system whose files say by their names which units they are in.

    Parameters
    ----------
    name : of the system.
    marks : names that only its files have together.
    names : its own names by quantity; their units are US units.
    """

    name: str
    marks: frozenset[str]
    names: dict[str, str]


SYSTEMS = (
    System(
        "Statcast",
        frozenset({"launch_speed", "launch_angle"}),
        {"bat_speed": "bat_speed", "launch_speed": "exit_speed", "release_speed": "release_speed",
         "launch_angle": "launch_angle", "attack_angle": "attack_angle", "batter": "batter", "game_date": "date",
         "description": "outcome"},
    ),
    System(
        "HitTrax",
        frozenset({"velo", "la"}),
        {"velo": "exit_speed", "la": "launch_angle", "pitch": "pitch_speed", "bv": "bat_speed", "bat": "bat",
         "batter": "batter", "user": "batter", "date": "date", "time_stamp": "date"},
    ),
    System(
        "Trackman",
        frozenset({"exitspeed", "angle"}),
        {"exitspeed": "exit_speed", "angle": "launch_angle", "relspeed": "release_speed", "zonespeed": "pitch_speed",
         "batspeed": "bat_speed", "verticalattackangle": "attack_angle", "attackangle": "attack_angle",
         "batter": "batter", "date": "date", "pitchcall": "outcome"},
    ),
    System(
        "Rapsodo",
        frozenset({"exitvelocity", "launchangle"}),
        {"exitvelocity": "exit_speed", "launchangle": "launch_angle", "date": "date"},
    ),
    System(
        "Blast",
        frozenset({"plane_score", "on_plane_efficiency"}),
        {"bat_speed": "bat_speed", "attack_angle": "attack_angle", "exit_velocity": "exit_speed",
         "launch_angle": "launch_angle", "equipment": "bat", "date": "date"},
    ),
)  # fmt: skip
"""Known systems; a file of none of them is plain."""


@dataclass(frozen=True)
class Column:
    """A column of a file.

    Parameters
    ----------
    index, heading : its place in the file and its name there.
    quantity : what it gives.
    factor : size of its unit in SI.
    from_tip : whether places count from the tip.
    no_unit : what to say of a cell without a unit; "": the heading has one.
    """

    index: int
    heading: str
    quantity: str
    factor: float
    from_tip: bool
    no_unit: str = ""

    def in_si(self, cell: str) -> float:
        """Return a cell's number in SI, by the unit in the cell where it has one; raises ``ValueError`` for no number.

        >>> round(Column(0, "Bat Speed", "bat_speed", MPH, False).in_si("66.1 km/h"), 2)
        18.36
        """
        try:
            number = float(cell)
        except ValueError:
            match = NUMBER_AND_UNIT.fullmatch(cell)
            unit = simplified(match[2]) if match else ""
            size_of = LENGTHS if self.quantity == "position" and not self.no_unit else UNITS[self.quantity]
            if match is None or unit not in size_of:
                raise ValueError(f"{self.heading} is {cell!r}, not a number") from None
            return float(match[1]) * size_of[unit]
        if self.no_unit:
            raise InputError(self.no_unit)
        return number * self.factor


@dataclass(frozen=True)
class Columns:
    """The columns of a file: those that are understood by quantity, the others by heading, and the system's name."""

    understood: dict[str, Column]
    ignored: tuple[str, ...]
    system: str


NUMBER_AND_UNIT = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+))\s*([^\d\s.,+-].*)")


def simplified(heading: str) -> str:
    """Return a heading in lower case with words and unit joined by single underscores.

    >>> simplified("Bat Speed (mph)"), simplified("Exit Velocity [km/h]")
    ('bat_speed_mph', 'exit_velocity_km_h')
    """
    return re.sub(r"[^0-9a-z%°]+", "_", heading.strip().lower()).strip("_")


def is_heading_line(cells: Sequence[str]) -> bool:
    """Return whether a line holds column names: one of them names bat speed or exit speed."""
    names = [simplified(cell) for cell in cells]
    known = {quantity for name in names if (quantity := _quantity(name)) is not None}
    known |= {
        system.names[name] for system in SYSTEMS if system.marks & set(names) for name in names if name in system.names
    }
    return bool(known & set(NEEDED))


def columns_of(headings: Sequence[str], *, units: Units | None, file_name: str) -> Columns:
    """Return what the columns of a file mean.

    Parameters
    ----------
    units : of columns whose heading names none; None: their cells must, unless the file is of a known system.

    Raises
    ------
    InputError
        when two columns give the same quantity, a unit is not known, or neither speed is there.
    """
    names = [simplified(heading) for heading in headings]
    system = next((known for known in SYSTEMS if _belongs(names, known)), None)
    columns: dict[str, Column] = {}
    ignored = []
    for index, (heading, name) in enumerate(zip(headings, names, strict=True)):
        column = _column(index, heading.strip(), name, system, units, file_name)
        if column is None:
            ignored.append(heading.strip())
        elif column.quantity in columns and column.quantity not in TEXTS:
            raise InputError(
                f"{file_name}: columns {columns[column.quantity].heading} and {column.heading} both give "
                f"{column.quantity}; keep one of them"
            )
        else:
            columns.setdefault(column.quantity, column)
    if not any(needed in columns for needed in NEEDED):
        raise InputError(
            f"{file_name}: no column for bat speed or exit speed; give for example bat_speed_mph and exit_speed_mph. "
            f"The file has: {', '.join(maybe_a_column(heading.strip()) for heading in headings)}"
        )
    return Columns(columns, tuple(ignored), system.name if system else "plain")


def maybe_a_column(heading: str) -> str:
    """Return the heading of a column that means nothing here, with the name that may have been meant."""
    return maybe_meant_heading(heading, [alias for aliases in ALIASES.values() for alias in aliases], KNOWN_UNITS)


def day_of(cells: Sequence[str], columns: Columns) -> date | None:
    """Return the date of a row, None where there is none that can be read."""
    column = columns.understood.get("date")
    if column is None or column.index >= len(cells):
        return None
    text = cells[column.index].strip()
    for part in (text, text.split(" ")[0].split("T")[0]):
        for form in DATE_FORMATS:
            try:
                return datetime.strptime(part, form).date()
            except ValueError:
                continue
    return None


def _belongs(names: Sequence[str], system: System) -> bool:
    """Return whether a file is one of a system's: its marks are there, a unit after them or not."""
    return all(any(name == mark or name.startswith(f"{mark}_") for name in names) for mark in system.marks)


def _column(
    index: int, heading: str, name: str, system: System | None, units: Units | None, file_name: str
) -> Column | None:
    if system is not None and name in system.names:
        quantity = system.names[name]
        unit = US_UNITS.get(quantity, "")
        if units == "metric" and system.name != "Statcast":
            unit = METRIC_UNITS.get(quantity, "")
        return Column(index, heading, quantity, UNITS[quantity].get(unit, 1.0), unit.endswith("tip"))
    named = _quantity(name)
    if named is None:
        return None
    alias = next(known for known in sorted(ALIASES[named], key=len, reverse=True) if _starts(name, known))
    unit = name.removeprefix(alias).strip("_")
    if named in TEXTS:
        if (
            system is not None and named in system.names.values()
        ):  # another's name: Statcast's player_name is a pitcher's
            return None
        return Column(index, heading, named, 1.0, False) if not unit else None
    if not unit:
        if units is None:
            example = f"{alias}_{next(iter(UNITS[named]))}"
            no_unit = (
                f"{file_name}: column {heading} has no unit; write it into the heading, for example {example}, or say "
                "--file-units us (mph, degrees, inches from the tip) or metric (m/s, degrees, cm from the tip)"
            )
            return Column(index, heading, named, math.nan, True, no_unit)
        unit = (US_UNITS if units == "us" else METRIC_UNITS)[named]
    if unit not in UNITS[named]:
        allowed = ", ".join(f"{alias}_{known}" for known in UNITS[named])
        raise InputError(f"{file_name}: column {heading} has an unknown unit; allowed: {allowed}")
    return Column(index, heading, named, UNITS[named][unit], unit.endswith("tip"))


def _quantity(name: str) -> str | None:
    """Return the quantity that a simplified heading names, alone or followed by a unit that quantities have."""
    for quantity, aliases in ALIASES.items():
        for alias in aliases:
            if name == alias:
                return quantity
            unit = name.removeprefix(alias).strip("_")
            if name.startswith(f"{alias}_") and (unit in UNITS[quantity] or unit in KNOWN_UNITS):
                return quantity
    return None


def _starts(name: str, alias: str) -> bool:
    return name == alias or name.startswith(f"{alias}_")


KNOWN_UNITS = frozenset(SPEEDS) | frozenset(ANGLES) | frozenset(LENGTHS) | {"knots", "kn", "ft", "%", "mils"}
"""Words after a name that are meant as its unit, whether they fit or not; other words make another name."""
