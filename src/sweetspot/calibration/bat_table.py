"""A table of bats of one model: one row a bat, with what scale, string, tap and moisture meter say of it.

``name, mass_oz, balance_point_in, pendulum_s, bending_1_hz, bending_2_hz, moisture_percent``: every column but the name
may be missing, every cell may be blank, and may have its own error: ``31.20±0.05``; without it the last digit counts.
Headings may be written as people do, ``Weight (oz)``.

Where the moisture is given, what was measured is brought to 12 %; see `moisture`. A bat without one, among others that
have it, is taken to be as wet as these on average, less surely.
"""

from __future__ import annotations

import math
import re
import warnings
from collections import Counter
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.moisture import MOISTURES, at_usual_moisture
from sweetspot.calibration.naming import MOST_BENDING, ModeName
from sweetspot.calibration.swing_weighed import of_swing_weight
from sweetspot.calibration.written import parse_measured
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text, table_rows
from sweetspot.units import CLAMPED, Kind, check_usual

UNITS: dict[str, tuple[Kind, dict[str, str]]] = {
    "mass": ("mass", {"oz": "oz", "g": "g", "kg": "kg", "lb": "lb"}),
    "balance_point": ("length", {"in": "in", "cm": "cm", "mm": "mm", "m": "m"}),
    "pendulum": ("time", {"s": "s"}),
    "moi": ("moi", {"oz_in2": "oz*in^2", "kg_m2": "kg*m^2", "kg_cm2": "kg*cm^2"}),
    "moisture": ("ratio", {"percent": "%"}),
    "hoop": ("frequency", {"hz": "Hz"}),
    **{f"bending_{number}": ("frequency", {"hz": "Hz"}) for number in range(1, MOST_BENDING + 1)},
}
"""Columns that are understood: name without its unit, its kind, and its units as `parse` writes them."""
SYNONYMS = {
    "bat": "name", "racket": "name", "club": "name", "stick": "name", "number": "name", "weight": "mass",
    "balance": "balance_point", "period": "pendulum", "swing_weight": "moi", "inertia": "moi", "tone": "bending_1",
    "frequency": "bending_1", "water": "moisture",
}  # fmt: skip
"""What people call the columns, and ours."""
UNIT_NAMES = {"%": "percent", "ounces": "oz", "grams": "g", "inches": "in", "seconds": "s", "sec": "s"}
"""How people write units in headings, and how we do."""
PER_MINUTE = re.compile(r"(^|_)cpm(_|$)|cycles_(per_)?min")
"""In a heading."""
BLANKS = ("", "-", "--", "\N{EN DASH}", "\N{EM DASH}", "?", "na", "n/a", "nan", "none", "null")
"""Words of a cell in which nothing was measured."""
HINT = "name, mass_oz, balance_point_in, pendulum_s, bending_1_hz, moisture_percent"
SWING_WEIGHT = ("swing_weight", "")
"""Column of a sport's letters with points; it has no unit."""
THOUSANDS = re.compile(r"\d,\d{3}(?!\d)")
MISSPELT = 0.8
"""Likeness of a heading to one of ours from which it counts as a slip of the pen."""
DECIMAL_COMMA = re.compile(r"(\d),(\d)")
MOISTURE_UNKNOWN = 0.015
"""One sigma of the moisture of a bat that was kept with others but not measured (assumed)."""
MOST_BATS = 200


def read_bats(path: Path, *, axis: float = STANDARD_AXIS, sport: str = "baseball") -> dict[str, list[Measurement]]:
    """Return what was measured on each bat of a CSV file, by name.

    Parameters
    ----------
    axis : m from the knob end, of its moments of inertia and pendulums.
    sport : whose swing weight a column of that name without a unit holds, as D2.

    Raises
    ------
    InputError
        when the file cannot be read, has no such columns, two bats of one name, or a cell that is no number.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice=f"give a CSV file with the columns {HINT}")
    rows = [cells for _, cells in table_rows(text, path, is_heading=_is_heading)]
    if not rows or not _is_heading(rows[0]):
        raise InputError(f"{path} has no line of headings with a column name; give for example {HINT}")
    lettered = swing_weight(sport).zero is not None
    heads = [SWING_WEIGHT if lettered and _plain(cell) == "moi" else _column(cell) for cell in rows[0]]
    if twice := [name for name, times in Counter(head[0] for head in heads if head).items() if times > 1]:
        raise InputError(f"{path} has more than one column of {' and of '.join(twice)}; keep one of each")
    if unread := [cell.strip() for cell, head in zip(rows[0], heads, strict=True) if head is None and cell.strip()]:
        warnings.warn(
            f"{path}: not understood and not used: {', '.join(unread)}; columns may be {HINT}",
            UnusualWarning,
            stacklevel=2,
        )
    if len(rows) - 1 > MOST_BATS:
        raise InputError(f"{path} has {len(rows) - 1} bats; allowed are {MOST_BATS}")
    bats: dict[str, dict[str, Measured]] = {}
    for line, cells in enumerate(rows[1:], start=2):
        given = {head: cell.strip() for head, cell in zip(heads, cells, strict=False) if head and not _is_blank(cell)}
        name = given.pop(("name", ""), f"bat {line - 1}")
        if name in bats:
            raise InputError(f"{path}, line {line}: there are two bats of the name {name!r}; give each its own")
        swung = given.pop(SWING_WEIGHT, None)
        bats[name] = _values(given, f"{path}, line {line}")
        if swung is not None:
            what = f"{path}, line {line}, swing weight"
            told = of_swing_weight(swung, sport, mass=bats[name].get("mass"), what=what)
            if bats[name].setdefault(told.kind, told.value) is not told.value:
                raise InputError(f"{what} tells the {told.name}, which was given too; give one of them")
        if not bats[name].keys() - {"moisture"}:
            raise InputError(f"{path}, line {line}: nothing was measured on {name}; its columns may be {HINT}")
    usual = _usual_moisture(bats, path)
    return {name: _measurements(values, usual, axis) for name, values in bats.items()}


def _usual_moisture(bats: Mapping[str, Mapping[str, Measured]], path: Path) -> Measured | None:
    """Return how wet a bat is taken to be whose moisture was not measured; None: nobody's was, and none is brought."""
    known = [values["moisture"].value for values in bats.values() if "moisture" in values]
    if not known:
        return None
    usual = Measured(float(np.mean(known)), math.hypot(float(np.std(known)), MOISTURE_UNKNOWN))
    if dry := [name for name, values in bats.items() if "moisture" not in values]:
        warnings.warn(
            f"{path}: no moisture was given of {', '.join(dry)}; taken is the mean of the others, {usual.value:.1%} ± "
            f"{REACH * usual.error:.1%}",
            UnusualWarning,
            stacklevel=3,
        )
    return usual


def _is_blank(cell: str) -> bool:
    return cell.strip().lower() in BLANKS


def _is_heading(cells: Sequence[str]) -> bool:
    return any(_plain(cell) == "name" for cell in cells)


def _plain(cell: str) -> str:
    """Return a heading as ours are written: words joined by underscores, the unit at the end, our names for things.

    >>> _plain("Weight (oz)"), _plain("Balance point [cm]"), _plain("Swing weight, kg cm²"), _plain("moisture %")
    ('mass_oz', 'balance_point_cm', 'moi_kg_cm2', 'moisture_percent')
    """
    words = re.findall(r"[a-z0-9]+|%", cell.lower().replace("²", "2").replace("^", ""))
    name = "_".join(UNIT_NAMES.get(word, word) for word in words)
    for theirs, ours in SYNONYMS.items():
        if name == theirs or (ours != "name" and name.startswith(f"{theirs}_") and not name.startswith(ours)):
            return ours + name.removeprefix(theirs)
    return name


def _column(cell: str) -> tuple[str, str] | None:
    """Return a heading's quantity and its unit; None for a column that means nothing here."""
    name = _plain(cell)
    if name == "name":
        return ("name", "")
    if PER_MINUTE.search(name):
        raise InputError(f"column {cell.strip()} cannot be used: {CLAMPED}. Leave it out, or give bending_1_hz")
    for quantity, (_, units) in UNITS.items():
        unit = name.removeprefix(f"{quantity}_")
        if name.startswith(quantity) and unit in units:
            return (quantity, units[unit])
        if name == quantity or (name.startswith(f"{quantity}_") and not unit[:1].isdigit()):
            allowed = ", ".join(f"{quantity}_{one}" for one in units)
            raise InputError(f"column {cell.strip()} has no unit that is understood; allowed: {allowed}")
    known = [f"{quantity}_{unit}" for quantity, (_, units) in UNITS.items() for unit in units]
    near = get_close_matches(name, known, n=1, cutoff=MISSPELT)
    if near:
        raise InputError(
            f"column {cell.strip()} is not understood; did you mean {near[0]}? Mend the heading, or rename it"
        )
    return None


def _values(given: dict[tuple[str, str], str], what: str) -> dict[str, Measured]:
    """Return the cells of a row as values with errors, SI, by quantity."""
    values = {
        quantity: parse_measured(_with_unit(cell, unit), UNITS[quantity][0], f"{what}, {quantity}")
        for (quantity, unit), cell in given.items()
    }
    for (quantity, unit), cell in given.items():
        usual = {"pendulum": "period"}.get(quantity, quantity)
        check_usual(values[quantity].value, usual, f"{cell} {unit} ({what})")
    moisture = values.get("moisture")
    if moisture is not None and not MOISTURES[0] <= moisture.value <= MOISTURES[1]:
        low, high = (100 * one for one in MOISTURES)
        raise InputError(
            f"{what}: the moisture is {100 * moisture.value:.3g} %; allowed is {low:g} to {high:g} % of the dry wood"
        )
    return values


def _measurements(values: Mapping[str, Measured], usual: Measured | None, axis: float) -> list[Measurement]:
    """Return what was measured on one bat, at 12 % of moisture where that is known.

    Parameters
    ----------
    usual : moisture of a bat that has none of its own.
    """
    moisture = values.get("moisture", usual)
    measurements = []
    for quantity, value in values.items():
        if quantity in ("mass", "balance_point", "moi"):
            measurements.append(Measurement(quantity, value, axis=axis))  # type: ignore[arg-type]
        elif quantity == "pendulum":
            measurements.append(Measurement("period", value, axis=axis))
        elif quantity != "moisture":
            name = ModeName("hoop", 2) if quantity == "hoop" else ModeName("bending", int(quantity[-1]))
            measurements.append(Measurement("frequency", value, mode=name))
    return measurements if moisture is None else [at_usual_moisture(one, moisture) for one in measurements]


def _with_unit(cell: str, unit: str) -> str:
    if THOUSANDS.search(cell):
        raise InputError(f"{cell!r} was given; write thousands without a comma, or decimals after a point")
    value, sign, error = DECIMAL_COMMA.sub(r"\1.\2", cell).partition("±")
    if unit == "%":  # an error of a ratio has its own sign
        return f"{value.strip()}%" + (f"{sign}{error.strip()}%" if sign else "")
    return f"{value.strip()} {unit}{sign}{error.strip()}"
