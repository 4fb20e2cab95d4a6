"""Tables and folders of bats of one model: a row or file a bat, with what scale, string, tap and moisture meter say.

``name, mass_oz, balance_point_in, pendulum_s, bending_1_hz, bending_2_hz, moisture_percent``: every column but the name
may be missing, every cell may be blank, and may have its own error: ``31.20±0.05``; without it the last digit counts,
and no less than the usual instrument's error (`FLOORS`). A row with a cell that cannot be read is left out.
Headings may be written as people do, ``Weight (oz)``.

Where the moisture is given, what was measured is brought to 12 %; see `at_usual_moisture`. A bat without one, among
others that have it, is taken to be as wet as these on average, less surely.
"""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import cast

import numpy as np

from sweetspot.calibration.measured import FLOORS, Measured, parse_measured
from sweetspot.calibration.measurements import MeasuredKind, Measurement, of_swing_weight
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.catalog.files.bat import read_toml
from sweetspot.catalog.files.tables import CalibrationTable
from sweetspot.catalog.implements import load_implement
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import REACH
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.plausibility import check, insisted
from sweetspot.plausibility.implements import SAME_MODEL
from sweetspot.tables.cells import EMPTY, require_units, with_unit
from sweetspot.tables.headings import (
    NOTHING_GIVEN,
    GivenColumns,
    Headings,
    TableColumn,
    maybe_heading,
    names_one_of,
    read_headings,
    refuse_faults,
)
from sweetspot.tables.text_encoding import table_rows
from sweetspot.tables.vocabulary import quantities_of, simplified
from sweetspot.units import CLAMPED, Kind

USUAL_MOISTURE = 0.12
"""At which tables give wood's properties [usda_wood_handbook]."""
MOISTURES = (0.02, 0.3)
"""Allowed: from wood just out of a kiln to the saturation of its fibres (both recalled); bats lie well within."""
STIFFER = 1.5
"""Logarithm of E lost per unit of moisture (assumed)."""
POWERS: Mapping[MeasuredKind, tuple[float, float]] = {"mass": (1.0, 0.0), "moi": (1.0, 0.0), "frequency": (-0.5, 0.5)}
"""p and r by kind of measurement."""


def at_usual_moisture(measurement: Measurement, moisture: Measured) -> Measurement:
    """Return a measurement corrected to 12 % of moisture, with the error of the moisture added.

    Wood that dries gets lighter and stiffer: m ~ 1 + u, and E falls by about 1.5 % for each per cent of moisture
    (assumed, between those of ash and maple in [usda_wood_handbook]). What goes as m^p E^r is moved by
    p d ln m + r d ln E: weight and moment of inertia with p = 1, frequencies with f ~ sqrt(E / m). A balance point and
    a period hardly change. The moisture is the mass of water over that of the dry wood.
    """
    of_mass, of_modulus = POWERS.get(measurement.kind, (0.0, 0.0))
    heavier = math.log((1 + moisture.value) / (1 + USUAL_MOISTURE))
    limper = STIFFER * (moisture.value - USUAL_MOISTURE)
    factor = math.exp(of_modulus * limper - of_mass * heavier)
    value, slope = measurement.value, abs(of_mass - of_modulus * STIFFER)  # d ln m / du = 1 / (1 + u), nearly 1
    moved = Measured(value.value * factor, value.error * factor).widened(slope * moisture.error * value.value)
    return replace(measurement, value=moved, as_read=value.value)


BATS = quantities_of("bats")
"""Columns that are understood."""
PER_MINUTE = re.compile(r"(^|_)cpm(_|$)|cycles_(per_)?min")
"""In a heading."""
BLANKS = (*EMPTY, "\N{EN DASH}", "\N{EM DASH}", "?")
"""Words of a cell in which nothing was measured."""
HINT = "name, mass_oz, balance_point_in, pendulum_s or twenty_swings_s, bending_1_hz, moisture_percent"
THOUSANDS = re.compile(r"\d,\d{3}(?!\d)")
MOISTURE_UNKNOWN = 0.015
"""One sigma of the moisture of a bat that was kept with others but not measured (assumed)."""
FEWEST_BATS = 2
"""That must be left, where others are left out for a cell that cannot be read."""
TIMED = 20
"""Full swings of a pendulum that people time: a stopwatch is then wrong by 2 ms a swing."""
MOST_BATS = 200
MOST_FAULTS = 8
"""Faults of a table that a message lists."""


def read_bats(
    path: Path,
    *,
    axis: float = STANDARD_AXIS,
    sport: str = "baseball",
    given: GivenColumns = NOTHING_GIVEN,
    fewest: int = FEWEST_BATS,
) -> dict[str, list[Measurement]]:
    """Return the measurements of each bat of a CSV file, by name.

    ``axis``: m from the knob end, of its moments of inertia and pendulums. ``sport``: whose swing weight a column of
    that name without a unit holds, as D2. ``fewest``: bats that must be left where others cannot be read.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice=f"give a CSV file with the columns {HINT}")

    def is_heading(cells: Sequence[str]) -> bool:
        return names_one_of(cells, ("piece",)) or any(cell.strip() in given.told for cell in cells)

    rows = list(table_rows(text, path, is_heading=is_heading))
    if not rows or not is_heading(rows[0][1]):
        raise InputError(f"{path} has no line of headings with a column name; give for example {HINT}")
    headings, lettered = _headings([cell.strip() for cell in rows[0][1]], rows[1:], sport, given, path)
    if len(rows) - 1 > MOST_BATS:
        raise InputError(f"{path} has {len(rows) - 1} bats; allowed are {MOST_BATS}")
    bats: dict[str, dict[str, Measured]] = {}
    faults: list[str] = []
    unread: dict[str, list[str]] = {}
    for line, (_, cells) in enumerate(rows[1:], start=2):
        texts = {
            name: cells[column.index].strip()
            for name, column in headings.columns.items()
            if column.index < len(cells) and cells[column.index].strip().lower() not in BLANKS
        }
        name = texts.pop("piece", f"bat {line - 1}")
        if name in bats:
            faults.append(f"line {line}: there are two bats of the name {name!r}; give each its own")
            continue
        swung = texts.pop("moi", None) if lettered else None
        bats[name] = {}
        if {"pendulum", "twenty_swings"} <= texts.keys():
            faults.append(f"line {line}: both one swing and twenty swings were timed; keep one of them")
        for quantity, cell in texts.items():
            try:
                bats[name][_stored(quantity)] = _value(cell, headings.columns[quantity], f"line {line}")
            except InputError as error:
                unread.setdefault(name, []).append(str(error))
        if swung is not None:
            what = f"line {line}, swing weight"
            try:
                measurement = of_swing_weight(swung, sport, mass=bats[name].get("mass"), what=what)
            except InputError as error:
                unread.setdefault(name, []).append(str(error))
                continue
            if bats[name].setdefault(measurement.kind, measurement.value) is not measurement.value:
                faults.append(f"{what} tells the {measurement.name}, which was given too; give one of them")
        if not (swung or texts.keys() - {"moisture"}):
            unread.setdefault(name, []).append(f"line {line}: nothing was measured; columns may be {HINT}")
    if bats.keys() - unread.keys() and len(bats) - len(unread) >= fewest and not faults:
        bats = _without(bats, unread, path)
    else:
        faults += [fault for several in unread.values() for fault in several]
    refuse_faults(faults[:MOST_FAULTS] + ["…"] * (len(faults) > MOST_FAULTS), str(path))
    usual = _usual_moisture(bats, path)
    return {name: _measurements(values, usual, axis) for name, values in bats.items()}


def read_bat(path: Path, model: Implement, *, name: str | None, axis: float) -> list[Measurement]:
    """Return the measurements of one bat of a CSV file, which comes near a model.

    ``name``: of its row; None: the table has one that is filled. ``axis``: as for `read_bats`.
    """
    bats = read_bats(path, axis=axis, sport=model.sport, fewest=1)
    if name is None and len(bats) > 1:
        raise InputError(f"{path} has {len(bats)} rows; say which: {', '.join(bats)}")
    chosen = next(iter(bats)) if name is None else name
    if chosen not in bats:
        raise InputError(f"{path} has no row {chosen!r} with measurements; it has {', '.join(bats)}")
    check_same_model({chosen: bats[chosen]}, model, axis=axis)
    return bats[chosen]


def _stored(quantity: str) -> str:
    """Return the quantity that a column tells: that of twenty swings the time of one."""
    return "pendulum" if quantity == "twenty_swings" else quantity


def _without(
    bats: dict[str, dict[str, Measured]], unread: Mapping[str, Sequence[str]], path: Path
) -> dict[str, dict[str, Measured]]:
    """Return bats without those that have a cell that cannot be read, with a warning for each."""
    for name, faults in unread.items():
        warnings.warn(f"{path}: {name} is left out: {'; '.join(faults)}", UnusualWarning, stacklevel=3)
    return {name: values for name, values in bats.items() if name not in unread}


def _headings(
    names: list[str], rows: list[tuple[int, list[str]]], sport: str, given: GivenColumns, path: Path
) -> tuple[Headings, bool]:
    """Return the meaning of the columns, and whether swing weights are a letter and a number of their sport.

    A heading that looks misspelled is refused, others cause a warning.
    """
    found = read_headings(names, wanted=BATS, given=given, once=True, file_name=str(path))
    unread = [name for name in found.passed if name and name not in found.spare]
    slips = [hint for name in unread if "did you mean" in (hint := maybe_heading(name, BATS))]
    per_minute = [
        f"column {name} cannot be used: {CLAMPED}. Leave it out, or give bending_1_hz"
        for name in names
        if PER_MINUTE.search(simplified(name))
    ]
    misspelled = [f"columns are not understood: {', '.join(slips)}; mend the heading, or rename it"] if slips else []
    lettered = swing_weight(sport).zero is not None and found.has("moi") and found.columns["moi"].has_no_unit
    measured = found.only(*(name for name in found.columns if not (lettered and name == "moi")))
    require_units(rows, measured, str(path), faults=(*found.faults.values(), *per_minute, *misspelled))
    if unread:
        warnings.warn(
            f"{path}: not understood and not used: {', '.join(unread)}; columns may be {HINT}",
            UnusualWarning,
            stacklevel=3,
        )
    return found, lettered


def _usual_moisture(bats: Mapping[str, Mapping[str, Measured]], path: Path) -> Measured | None:
    """Return the moisture assumed of a bat without a measured one; None if no bat has one: nothing is corrected."""
    measured = [values["moisture"].value for values in bats.values() if "moisture" in values]
    if not measured:
        return None
    usual = Measured(float(np.mean(measured)), math.hypot(float(np.std(measured)), MOISTURE_UNKNOWN))
    if dry := [name for name, values in bats.items() if "moisture" not in values]:
        warnings.warn(
            f"{path}: no moisture was given of {', '.join(dry)}; taken is the mean of the others, {usual.value:.1%} ± "
            f"{REACH * usual.error:.1%}",
            UnusualWarning,
            stacklevel=3,
        )
    return usual


def _value(cell: str, column: TableColumn, what: str) -> Measured:
    """Return a cell as a value with its error, SI."""
    name = column.quantity
    if THOUSANDS.search(cell):
        raise InputError(
            f"{what}, {name}: {cell!r} was given; write thousands without a comma, or decimals after a point"
        )
    if not any(letter.isdigit() for letter in cell):
        raise InputError(f"{what}, {name}: {cell!r} is no number; leave the cell blank where nothing was measured")
    written = with_unit(cell, column)
    of_one = TIMED if name == "twenty_swings" else 1
    floor = FLOORS["tone"] if column.kind == "frequency" else FLOORS.get(_stored(name), 0.0)
    value = parse_measured(written, cast("Kind", column.kind), f"{what}, {name}", floor=of_one * floor)
    value = Measured(value.value / of_one, value.error / of_one)
    check(value.value, {"pendulum": "period"}.get(_stored(name), name), f"{written} ({what})")
    if name == "moisture" and not MOISTURES[0] <= value.value <= MOISTURES[1]:
        low, high = (100 * share for share in MOISTURES)
        raise InputError(
            f"{what}: the moisture is {100 * value.value:.3g} %; allowed is {low:g} to {high:g} % of the dry wood"
        )
    return value


def _measurements(values: Mapping[str, Measured], usual: Measured | None, axis: float) -> list[Measurement]:
    """Return the measurements of one bat, at 12 % of moisture where its moisture is known."""
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
    return (
        measurements if moisture is None else [at_usual_moisture(measurement, moisture) for measurement in measurements]
    )


TABLES, BAT_FILE = (".csv", ".tsv", ".txt"), ".toml"
SAME_LENGTH = 0.005
"""Part by which bats of one model may differ in length (our choice): a sixth of an inch."""


def read_folder(
    folder: Path, model: Implement, *, axis: float, given: GivenColumns = NOTHING_GIVEN
) -> dict[str, list[Measurement]]:
    """Return the measurements of each bat of a folder, by name; the bat of a bat file is called like the file.

    ``axis``: m from the knob end, of the tables' moments of inertia and pendulums.
    """
    files = sorted(path for path in folder.iterdir() if path.suffix.lower() in (*TABLES, BAT_FILE))
    if not files:
        raise InputError(
            f"{folder} holds no CSV file and no bat file; put one with the bats' measurements there, or the files that "
            "`sweetspot calibrate --out` wrote"
        )
    bats: dict[str, list[Measurement]] = {}
    faults = []
    for path in files:
        try:
            if path.suffix.lower() == BAT_FILE:
                found = {path.stem: measured_of(path, model)}
            else:
                found = read_bats(path, axis=axis, sport=model.sport, given=given)
        except InputError as error:
            faults.append(str(error))
            continue
        if twice := bats.keys() & found.keys():
            raise InputError(f"{path}: there are two bats of the name {min(twice)!r}; give each its own")
        bats |= found
    if faults:
        raise InputError("; ".join(faults))
    return bats


def measured_of(path: Path, model: Implement) -> list[Measurement]:
    """Return the measurements of the bat in a file written by `sweetspot calibrate`, without its shots."""
    implement = load_implement(str(path))
    if implement.sport != model.sport or abs(implement.length / model.length - 1) > SAME_LENGTH:
        raise InputError(
            f"{path} is of {implement.sport}, {implement.length:.3f} m long, and {model.name} of {model.sport}, "
            f"{model.length:.3f} m; a ranking is of bats of one model"
        )
    table = read_toml(path).get("calibration")
    values = () if table is None else CalibrationTable.model_validate(table).value
    if not values:
        raise InputError(f"{path} does not hold what was measured; write it by `sweetspot calibrate --out`")
    return [
        Measurement(
            value.quantity,
            Measured(value.measured, value.error),
            axis=value.axis,
            mode=None if value.family is None else ModeName(value.family, value.harmonic),
        )
        for value in values
    ]


def expected_values(model: Implement, *, axis: float) -> dict[str, float]:
    """Return the values that a table's columns would hold of a model as described, SI, of those that it can tell.

    ``axis``: m from the butt end, of pendulum and moment of inertia.
    """
    beam = beam_model(model)
    body, modes = rigid_body(beam), bending_modes(beam)
    values = {"mass": body.mass, "balance_point": body.balance_point, "moi": body.moi(axis)}
    if body.balance_point > axis:
        period = pendulum_period(body.moi(axis), mass=body.mass, balance_point=body.balance_point, pivot=axis)
        values |= {"pendulum": period, "twenty_swings": TIMED * period}
    bending = (float(modes.frequency[index]) for index in modes.of_family("bending"))
    return values | {f"bending_{number}": frequency for number, frequency in enumerate(bending, start=1)}


def check_same_model(
    bats: Mapping[str, Sequence[Measurement]], model: Implement, *, axis: float = STANDARD_AXIS
) -> None:
    """Refuse measurements that no bat of a model comes near: in another unit, or in another column."""
    modelled = expected_values(model, axis=axis)
    for name, measured in bats.items():
        for measurement in measured:
            mode = measurement.mode
            column = {"period": "pendulum"}.get(measurement.kind, measurement.kind)
            expected = modelled.get(column if mode is None else f"{mode.family}_{mode.harmonic}")
            if expected is None or insisted():
                continue
            factor = measurement.value.value / expected
            if not 1 / SAME_MODEL[measurement.kind] < factor < SAME_MODEL[measurement.kind]:
                what = str(mode) if mode is not None else measurement.kind.replace("_", " ")
                raise InputError(
                    f"{name}: the {what} is {factor:.3g} times that of {model.name}; bats of one model come within a "
                    f"factor of {SAME_MODEL[measurement.kind]:g}. Check the unit and the column, or add --force if it "
                    "is intended"
                )
