"""What the columns of a swing file mean, and the swing that a cell tells of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import date, datetime

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

MEASURED = ("bat_speed", "exit_speed", "plate_speed", "release_speed", "launch_angle", "attack_angle", "position")
WHO = ("batter_name", "batter", "person", "player_name")
"""Quantities that name the batter, the first that is there counts; of one system's own the first of these."""
OUTCOME = ("description", "outcome")
SWINGS = (*MEASURED, "bat", *WHO, "date", *OUTCOME)
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
