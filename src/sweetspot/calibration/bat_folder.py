"""A folder of bats of one model: tables with a row a bat, and files of bats that were calibrated one by one."""

from __future__ import annotations

from pathlib import Path

from sweetspot.calibration.bat_table import read_bats
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.naming import ModeName
from sweetspot.catalog.files.bat import read_toml
from sweetspot.catalog.files.calibration import CalibrationTable
from sweetspot.catalog.implements import load_implement
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns

TABLES, BAT_FILE = (".csv", ".tsv", ".txt"), ".toml"
SAME_LENGTH = 0.005
"""Part by which bats of one model may differ in length (our choice): a sixth of an inch."""


def read_folder(
    folder: Path, model: Implement, *, axis: float, given: GivenColumns = NOTHING_GIVEN
) -> dict[str, list[Measurement]]:
    """Return what was measured on each bat of a folder, by name; a bat file's bat is called like the file.

    Parameters
    ----------
    model : that all are like.
    axis : m from the knob end, of the tables' moments of inertia and pendulums.
    given : what a person says of the tables' columns.

    Raises
    ------
    InputError
        when there is none, two have one name, or files cannot be read: each is named.
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
    """Return what was measured on the bat of a file that `sweetspot calibrate` wrote; shots are not among it.

    Parameters
    ----------
    model : that it must be as long as.

    Raises
    ------
    InputError
        where it wrote none, or not what was measured, or the bat is another one.
    """
    own = load_implement(str(path))
    if own.sport != model.sport or abs(own.length / model.length - 1) > SAME_LENGTH:
        raise InputError(
            f"{path} is of {own.sport}, {own.length:.3f} m long, and {model.name} of {model.sport}, {model.length:.3f} "
            "m; a ranking is of bats of one model"
        )
    table = read_toml(path).get("calibration")
    values = () if table is None else CalibrationTable.model_validate(table).value
    if not values:
        raise InputError(f"{path} does not hold what was measured; write it by `sweetspot calibrate --out`")
    return [
        Measurement(
            one.quantity, Measured(one.measured, one.error), axis=one.axis,
            mode=None if one.family is None else ModeName(one.family, one.harmonic),
        )
        for one in values
    ]  # fmt: skip
