"""What the columns of a table of batted balls mean, whoever wrote it: Statcast, Trackman, a club, or anybody's units.

The names are data, `catalog/table_headings.toml`. A system's own names are in that system's units; any other
measurement carries its unit in the heading (``exit_speed_mph``, ``Exit Velocity [km/h]``).
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from sweetspot.catalog.records import read_table
from sweetspot.errors import InputError, maybe_meant_heading, nearest_names
from sweetspot.units import DEGREE, FOOT, INCH, MPH, RPM

FILE = "table_headings.toml"
SYSTEMS = {
    "statcast": ("Statcast", {"launch_speed"}),
    "club": ("club feed", {"bataxialoffset"}),
    "trackman": ("Trackman", {"exitspeed", "angle"}),
    "hittrax": ("HitTrax", {"velo", "la"}),
    "rapsodo": ("Rapsodo", {"exitvelocity", "launchangle"}),
}
"""Systems whose names mean their own units, with the headings that give them away; the first that fits counts."""
BOARDS = {
    "avg_hit_speed", "exit_velocity_avg", "swings_competitive", "batted_ball_events", "avg_bat_speed",
    "avg_best_speed", "barrels_per_bbe_percent",
}  # fmt: skip
"""Headings of the league's leaderboards, which have a row for each player."""
ALSO = {"club": ("trackman",)}
"""Whose names a system's tables use beside their own."""
SPEEDS = {
    "mph": MPH, "mi_h": MPH, "m_s": 1.0, "mps": 1.0, "ms": 1.0, "km_h": 1 / 3.6, "kmh": 1 / 3.6, "kph": 1 / 3.6,
    "ft_s": FOOT, "fps": FOOT,
}  # fmt: skip
LENGTHS = {"in": INCH, "inch": INCH, "inches": INCH, "ft": FOOT, "feet": FOOT, "m": 1.0, "cm": 0.01, "mm": 0.001,
           "yd": 3 * FOOT}  # fmt: skip
UNITS: Mapping[str, Mapping[str, float]] = {
    "speed": SPEEDS,
    "angle": {"deg": DEGREE, "degree": DEGREE, "degrees": DEGREE, "°": DEGREE, "rad": 1.0, "radians": 1.0},
    "length": LENGTHS,
    "distance": LENGTHS,
    "time": {"s": 1.0, "sec": 1.0, "seconds": 1.0},
    "spin": {"rpm": RPM, "rad_s": 1.0},
    "acceleration": {"ft_s2": FOOT, "m_s2": 1.0},
    "temperature": {"degf": 5 / 9, "degc": 1.0, "f": 5 / 9, "c": 1.0, "°f": 5 / 9, "°c": 1.0},
    "pressure": {"hpa": 100.0, "mbar": 100.0, "inhg": 3386.389, "in_hg": 3386.389, "mmhg": 133.3224, "kpa": 1000.0},
    "ratio": {"%": 0.01, "pct": 0.01, "percent": 0.01, "ratio": 1.0},
    "count": {},
    "text": {},
}
"""Endings of a heading that are units of a kind, and their size in SI."""
DAY_FIRST = "day first"
"""What stands for the unit of a table's dates where they begin with the day."""
FAHRENHEIT_ZERO = -160 / 9
"""degC at 0 degF."""
COPY = re.compile(r"_duplicated_\d+$")


@dataclass(frozen=True)
class TableColumn:
    """One column that is understood.

    Parameters
    ----------
    quantity : what it gives, an entry of the list of names.
    heading : as the table writes it.
    kind : of the quantity.
    unit : as told by heading or system; "" where there is none.
    factor, zero : value in SI = zero + factor x what the table holds.
    """

    quantity: str
    heading: str
    kind: str
    unit: str
    factor: float
    zero: float = 0.0


@dataclass(frozen=True)
class Headings:
    """All columns of a table.

    Parameters
    ----------
    system : whose table it is; "plain" where the names are nobody's own.
    columns : those that are understood, by quantity.
    passed : headings that mean nothing here and pass through untouched.
    notes : what to know, one sentence each.
    """

    system: str
    columns: Mapping[str, TableColumn]
    passed: tuple[str, ...]
    notes: tuple[str, ...]

    def has(self, *quantities: str) -> bool:
        """Return whether the table has all of some quantities."""
        return all(name in self.columns for name in quantities)

    def only(self, *quantities: str) -> Headings:
        """Return the columns of some quantities, those that the table has."""
        return replace(self, columns={name: self.columns[name] for name in quantities if name in self.columns})


@cache
def quantities() -> dict[str, dict[str, Any]]:
    """Return the list of quantities with all their names."""
    return read_table(FILE)


def simplified(heading: str) -> str:
    """Return a heading in lower case, words and unit joined by single underscores.

    >>> simplified("Exit Velocity [km/h]"), simplified("ExitSpeed"), simplified("ax (ft/s²)")
    ('exit_velocity_km_h', 'exitspeed', 'ax_ft_s2')
    """
    plain = heading.replace("\ufeff", "").replace("²", "2").strip().strip('"').lower()
    return re.sub(r"[^0-9a-z%°]+", "_", plain).strip("_")


def headings_of(names: Sequence[str], *, given: Mapping[str, str] | None = None, file_name: str = "table") -> Headings:
    """Return what the columns of a table mean.

    Parameters
    ----------
    names : headings as the table writes them.
    given : heading by quantity, where a person has said what a column is; it goes before everything else.
    file_name : for messages.

    Raises
    ------
    InputError
        when there is no exit speed, a measurement has no unit or an unknown one, or ``given`` names no column.

    >>> mapped = headings_of(["launch_speed", "launch_angle", "hc_x", "umpire"])
    >>> mapped.system, mapped.columns["exit_speed"].unit, mapped.passed
    ('Statcast', 'mph', ('umpire',))
    """
    short = {name: simplified(name) for name in names}
    key = next((key for key, (_, marks) in SYSTEMS.items() if marks <= set(short.values())), "")
    said = _given(given or {}, names, file_name)
    columns, notes, doubts = _understood(names, said, key, file_name)
    if any(name.startswith("\ufeff") for name in names):
        notes.append("the first heading begins with a byte order mark, which is left out")
    _require_exit_speed(names, columns, said, file_name)
    if doubts:
        raise doubts[0]
    taken = {column.heading for column in columns.values()}
    passed = tuple(name for name in names if name not in taken)
    for name in passed:
        quantity = _without_unit(short[name])
        if quantity is not None and quantity not in columns:
            unit = next(iter(UNITS[quantities()[quantity]["kind"]]))
            notes.append(f"{name} has no unit and is left alone; {short[name]}_{unit}, say, would be read")
    return Headings(SYSTEMS[key][0] if key else "plain", columns, passed, tuple(notes))


def _understood(
    names: Sequence[str], said: Mapping[str, TableColumn], key: str, file_name: str
) -> tuple[dict[str, TableColumn], list[str], list[InputError]]:
    """Return columns by quantity, what to know of them, and what is wrong with headings of less weight.

    Parameters
    ----------
    said : columns that a person has named, by heading.
    key : of `SYSTEMS`.
    """
    columns: dict[str, TableColumn] = {}
    notes: list[str] = []
    doubts: list[InputError] = []
    for name in names:
        short = simplified(name)
        try:
            column = said.get(name) or _column(name, short, key, file_name)
        except InputError as error:
            if any(short.startswith(alias) for alias in quantities()["exit_speed"]["plain"]):
                raise
            doubts.append(error)  # of less weight than that there is no exit speed
            continue
        if column is None or COPY.search(name):
            continue
        if column.quantity not in columns or name in said:
            columns[column.quantity] = column
        elif column.kind != "text":
            notes.append(f"{name} gives {column.quantity} too; {columns[column.quantity].heading} is used")
    return columns, notes, doubts


def _require_exit_speed(
    names: Sequence[str], columns: Mapping[str, TableColumn], said: Mapping[str, TableColumn], file_name: str
) -> None:
    """Refuse a table of players, of swings alone, or of anything else than balls."""
    told = any(column.quantity == "exit_speed" for column in said.values())
    if not told and (board := [name for name in names if simplified(name) in BOARDS]):
        raise InputError(
            f"{file_name}: column {board[0]} is a leaderboard's, with a row for each player; give a row for each ball, "
            "as the search for pitches exports them"
        )
    if "exit_speed" not in columns and "bat_speed" in columns:
        raise InputError(
            f"{file_name}: swings alone ({columns['bat_speed'].heading}) and no column for exit speed; add what was "
            "measured of the balls, for example as exit_speed_mph and launch_angle_deg"
        )
    if "exit_speed" not in columns:
        raise InputError(
            f"{file_name}: no column for exit speed; launch_speed (Statcast), ExitSpeed (Trackman) or exit_speed_mph "
            f"would do. {_closest(list(names))}"
        )


def names_balls(names: Sequence[str]) -> bool:
    """Return whether some words are headings of balls or swings, not what stands above them or beside.

    >>> names_balls(["HitID", "ExitVelocity"]), names_balls(["Player Name:", "Exit Velocity, Some"])
    (True, False)
    """
    for name in map(simplified, names):
        for quantity in ESSENTIAL:
            for source in quantities()[quantity].values():
                aliases = source.get("names", ()) if isinstance(source, dict) else source
                for known in () if isinstance(source, str) else aliases:
                    rest = name.removeprefix(known).strip("_")
                    if name == known or (name.startswith(f"{known}_") and rest in KNOWN_UNITS):
                        return True
    return False


def _closest(names: list[str]) -> str:
    known = [alias for entry in quantities().values() for alias in entry.get("plain", ())]
    maybe = [maybe_meant_heading(name, known, KNOWN_UNITS) for name in names]
    maybe.sort(key=lambda name: "did you mean" not in name)
    shown = ", ".join(maybe[:12]) + (", …" if len(names) > 12 else "")
    return f"The table has: {shown}" if names else nearest_names("exit_speed", ["launch_speed"])


def _given(given: Mapping[str, str], names: Sequence[str], file_name: str) -> dict[str, TableColumn]:
    """Return the columns that a person has named, by heading; a unit may stand behind: ``EV:km/h``."""
    columns = {}
    for quantity, text in given.items():
        if quantity not in quantities():
            raise InputError(f"{quantity} is no quantity of a table. {nearest_names(quantity, list(quantities()))}")
        heading, _, unit = text.rpartition(":") if text not in names else (text, "", "")
        if heading not in names:
            raise InputError(f"{file_name}: no column {heading or text!r} to give {quantity}. {_closest(list(names))}")
        kind = quantities()[quantity]["kind"]
        if not unit and kind not in ("text", "count"):
            known = _column(heading, simplified(heading), "", file_name)
            unit = known.unit if known and known.kind == kind else _default_unit(quantity)
        columns[heading] = _made(quantity, heading, kind, simplified(unit), file_name)
    return columns


def _default_unit(quantity: str) -> str:
    entry = quantities()[quantity]
    return next((entry[key]["unit"] for key in SYSTEMS if key in entry and "unit" in entry[key]), "")


def _column(heading: str, name: str, system: str, file_name: str) -> TableColumn | None:
    for source in (system, *ALSO.get(system, ())):
        for quantity, entry in quantities().items():
            own = entry.get(source, {})
            if name in own.get("names", ()):
                return _made(quantity, heading, entry["kind"], simplified(own.get("unit", "")), file_name)
    for quantity, entry in quantities().items():
        for alias in sorted(entry.get("plain", ()), key=len, reverse=True):
            unit = name.removeprefix(alias).strip("_") if name.startswith(f"{alias}_") else ""
            if name != alias and (not unit or unit not in KNOWN_UNITS):
                continue
            if name == alias and entry["kind"] == "time":
                unit = "s"  # nobody gives it in anything else
            elif name == alias and quantity not in ESSENTIAL and entry["kind"] not in ("text", "count"):
                return None  # an extra measurement without a unit is left alone
            return _made(quantity, heading, entry["kind"], unit, file_name)
    return None


def _without_unit(name: str) -> str | None:
    """Return the measurement that anybody's name would be, were there a unit behind it."""
    return next((quantity for quantity, entry in quantities().items()
                 if name in entry.get("plain", ()) and entry["kind"] not in ("text", "count")), None)  # fmt: skip


def _made(quantity: str, heading: str, kind: str, unit: str, file_name: str) -> TableColumn:
    units = UNITS[kind]
    if kind in ("text", "count"):
        return TableColumn(quantity, heading, kind, "", 1.0)
    if unit not in units:
        example = f"{simplified(heading)}_{next(iter(units))}" if not unit else ", ".join(units)
        raise InputError(
            f"{file_name}: column {heading} has {'no unit' if not unit else f'the unit {unit}, which is no {kind}'}; "
            f"{'write it into the heading, for example' if not unit else 'allowed:'} {example}"
        )
    zero = FAHRENHEIT_ZERO if kind == "temperature" and units[unit] != 1 else 0.0
    return TableColumn(quantity, heading, kind, unit, units[unit], zero)


KNOWN_UNITS = frozenset(unit for units in UNITS.values() for unit in units)
ESSENTIAL = ("exit_speed", "launch_angle", "bat_speed")
"""Without a unit these are refused; nobody must guess whether 98 is a speed in mph or in km/h."""
