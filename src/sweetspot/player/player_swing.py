"""One swing of a player, whether it, and the swings together, can be true, and the columns that swings come in."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import date, datetime
from pathlib import Path
from statistics import median

from sweetspot.errors import InputError
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.plausibility import check, insisted, objection
from sweetspot.tables.cells import BadRow
from sweetspot.tables.headings import (
    NOTHING_GIVEN,
    GivenColumns,
    Headings,
    closest,
    maybe_heading,
    names_one_of,
    no_unit,
    read_headings,
    refuse_faults,
)
from sweetspot.units import INCH, MPH, format_length

MEASURED = ("bat_speed", "exit_speed", "plate_speed", "release_speed", "launch_angle", "attack_angle", "position")
WHO = ("batter_name", "batter", "person", "player_name")
"""Quantities that name the batter, the first that is there counts; of one system's own the first of these."""
OUTCOME = ("description", "outcome")
SWINGS = (*MEASURED, "bat_mass", "bat_length", "bat", *WHO, "date", *OUTCOME)
"""Quantities of a file of swings."""
TEXTS = ("bat", "batter", "date", "outcome")
NEEDED = ("bat_speed", "exit_speed")
"""At least one of these."""
DATE_FORMATS = ("%Y-%m-%d", "%m/%d/%Y", "%m/%d/%y", "%Y/%m/%d", "%b %d, %Y", "%B %d, %Y", "%d.%m.%Y")


def is_heading_line(cells: Sequence[str], named: frozenset[str] = frozenset()) -> bool:
    """Return whether a line holds column names: one of them names bat speed or exit speed, or a person named it."""
    return names_one_of(cells, NEEDED) or any(cell.strip() in named for cell in cells)


def columns_of(headings: Sequence[str], *, given: GivenColumns = NOTHING_GIVEN, file_name: str) -> Headings:
    """Return the meaning of the columns of a file; ``batter`` is who swung, ``outcome`` the result of the swing."""
    names = [heading.strip() for heading in headings]
    found = read_headings(names, wanted=SWINGS, given=given, once=True, file_name=file_name)
    faults = list(found.faults.values())
    if not any(name in found.columns or name in found.faults for name in NEEDED):
        faults.append(
            "no column for bat speed or exit speed; give for example bat_speed_mph and exit_speed_mph, or say --column "
            f"exit_speed=HEADING:mph. The file has: {closest(names, SWINGS)}"
        )
    if faults:
        vague = no_unit([column for column in found.columns.values() if column.has_no_unit])
        refuse_faults(filter(None, (*faults, vague)), file_name)
    columns = {name: column for name, column in found.columns.items() if name not in (*WHO, *OUTCOME)}
    for quantity, names_of in (("batter", _who(found)), ("outcome", OUTCOME)):
        if column := next((found.columns[name] for name in names_of if name in found.columns), None):
            columns[quantity] = replace(column, quantity=quantity)
    return replace(found, columns=columns, passed=tuple(name for name in found.passed if name not in found.spare))


def maybe_a_column(heading: str) -> str:
    """Return the heading of a column that means nothing here, with the name that may have been meant."""
    return maybe_heading(heading, SWINGS)


def day_of(cells: Sequence[str], columns: Headings) -> date | None:
    """Return the date of a row, None where there is none that can be read."""
    column = columns.columns.get("date")
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


def _who(found: Headings) -> tuple[str, ...]:
    """Return the quantities that may name the batter; a player's name in Statcast's files may be the pitcher's."""
    return ("batter",) if found.system == "Statcast" else WHO


TOO_FAST = "is more than any bat gives"
"""Words of such a fault."""
SPEEDS = ("bat_speed", "exit_speed", "pitch_speed")
LIVELIEST = 0.45
"""Collision efficiency beyond any bat's; a faster ball is a wrong reading. Our choice."""
FULL_SWING = 0.6
"""Part of the median bat speed below which a swing is a bunt or was checked. Our choice."""
FEWEST = 5
"""Swings below which nothing is reported of a player. Our choice."""
LEVEL = math.radians(1.6)
"""rad; five balls or more that all leave flatter than this were written in radians: 1.6 is straight up. Our choice."""
SWAPPED = 1.1
"""Median bat speed over median exit speed from which the two columns must have been swapped. Our choice: a ball leaves
slower than the bat came only when it is met badly."""


@dataclass(frozen=True)
class PlayerSwing:
    """One swing of a player in SI; None: not measured.

    Parameters
    ----------
    row : line of the file.
    bat_speed : m/s at the place where the player's bat speed is measured.
    exit_speed : m/s of the ball; None also for a miss.
    pitch_speed : m/s of the ball at the plate; 0 on a tee.
    launch_angle, attack_angle : rad above the horizontal, of the ball and of the bat's path.
    position : m from the tip.
    bat : name of the bat as the file gives it; "": the player's own.
    foul : whether the ball went foul; only the bat speed of such a swing counts.
    bat_mass, bat_length : kg and m of the bat, as the file gives them.
    """

    row: int
    bat_speed: float | None
    exit_speed: float | None
    pitch_speed: float | None
    launch_angle: float | None
    attack_angle: float | None
    position: float | None
    bat: str
    foul: bool = False
    bat_mass: float | None = None
    bat_length: float | None = None


def fault_of(swing: PlayerSwing, length: float, sport: str = "baseball") -> str:
    """Return why a swing cannot be true of a bat of this length (m) in a sport, or an empty text."""
    bat, ball, pitch = swing.bat_speed, swing.exit_speed, swing.pitch_speed
    for name in (*SPEEDS, "launch_angle", "attack_angle"):
        value = getattr(swing, name)
        if value is not None:
            given = _mph(value) if name in SPEEDS else f"{math.degrees(value):.1f} deg"
            quantity = "tracked_launch_angle" if name == "launch_angle" else name
            if wrong := objection(quantity, value, name.replace("_", " "), given, sport, column=True):
                return wrong
    if swing.position is not None and not 0.0 <= swing.position <= length:
        return f"position is off the bat of {format_length(length)}"
    if bat is None or ball is None or pitch is None:
        return ""
    fastest = LIVELIEST * pitch + (1 + LIVELIEST) * bat
    if ball > fastest:
        against = f"against {_mph(pitch)}" if pitch else "off a tee"
        return f"exit speed {_mph(ball)} {TOO_FAST} at {_mph(bat)} {against} ({_mph(fastest)})"
    if swing.position is not None and not insisted():
        there = bat * (length - swing.position) / (length - SPEED_FROM_TIP)  # near enough
        if ball > max(LIVELIEST * pitch + (1 + LIVELIEST) * there, 0.0) and swing.position > SPEED_FROM_TIP:
            return (
                f"a ball met {swing.position / INCH:.1f} in from the tip cannot leave at {_mph(ball)}; does the "
                "position count from the other end?"
            )
    return ""


def _mph(speed: float) -> str:
    return f"{speed / MPH:.1f} mph"


def full_swings(swings: list[PlayerSwing]) -> tuple[list[PlayerSwing], list[BadRow]]:
    """Return full swings, and those much slower than the median with the reason."""
    speeds = [swing.bat_speed for swing in swings if swing.bat_speed is not None]
    if len(speeds) < 3:
        return swings, []
    middle = median(speeds)

    good, bad = [], []
    for swing in swings:
        if swing.bat_speed is None or swing.bat_speed >= FULL_SWING * middle:
            good.append(swing)
        else:
            speeds_words = f"bat speed is {_mph(swing.bat_speed)} where the median is {_mph(middle)}"
            bad.append(BadRow(swing.row, f"{speeds_words}: a bunt or a checked swing"))
    return good, bad


def check_speeds(swings: Sequence[PlayerSwing], path: Path) -> None:
    """Refuse speeds in another unit than the heading says, and bat and ball in each other's columns."""
    middle: dict[str, float] = {}
    for quantity in NEEDED:
        values = [value for swing in swings if (value := getattr(swing, quantity)) is not None]
        if len(values) >= FEWEST:
            middle[quantity] = median(values)
            name = f"median_{quantity}"
            check(middle[quantity], name.replace("_", " "), f"{middle[quantity] / MPH:.1f} mph by {path}")
    angles = [abs(swing.launch_angle) for swing in swings if swing.launch_angle is not None]
    if len(angles) >= FEWEST and 0 < max(angles) < LEVEL and not insisted():
        raise InputError(
            f"{path}: no ball left at more than {math.degrees(max(angles)):.2f} degrees up or down; are the launch "
            "angles in radians? Write _rad behind the heading, or add --force if it is intended"
        )
    if len(swings) >= FEWEST and len({replace(swing, row=0) for swing in swings}) == 1 and not insisted():
        raise InputError(
            f"{path}: all {len(swings)} swings are the same to the last digit; is one row copied? Give each swing "
            "as it was measured, or add --force if it is intended"
        )
    if len(middle) == len(NEEDED) and not insisted() and middle["bat_speed"] > SWAPPED * middle["exit_speed"]:
        bat, ball = (f"{middle[quantity] / MPH:.1f} mph" for quantity in NEEDED)
        raise InputError(
            f"{path}: the bat is faster ({bat} in the median) than the ball leaves ({ball}); are the columns of bat "
            "speed and exit speed swapped? Mend the headings, or add --force if it is intended"
        )


def check_enough(swings: Sequence[PlayerSwing], path: Path, bad_rows: Sequence[BadRow] = ()) -> None:
    """Refuse so few swings that the answers would be those for anybody, and say why others do not count."""
    if len(swings) < FEWEST and not insisted():
        noun = "swing" if len(swings) == 1 else "swings"
        left = f" ({len(bad_rows)} left out; row {bad_rows[0].row}: {bad_rows[0].reason})" if bad_rows else ""
        raise InputError(
            f"{path} has {len(swings)} {noun} that can be used{left}; {FEWEST} are the fewest that tell anything of a "
            "player. Swing more, or add --force for what is usual for players"
        )
