"""Files of a blind test: questions without answers, the predictions that were made for them, and what was measured.

A laboratory writes down what it will measure, or has measured and withheld: an ``id``, what kind of number it is, and
what it is of. Whoever predicts writes numbers with intervals beside the same ``id``. The third file has what was
measured; only the score reads both. Predictions carry the program's version and the digest of the questions' file.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

from sweetspot.catalog.files.bat import read_toml
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, harmless, read_text
from sweetspot.tables.cells import EMPTY
from sweetspot.tables.text_encoding import table_rows

MOST_FAULTS = 12
"""Faults of a file that its message lists."""
MOST_QUESTIONS = 2000
Made = TypeVar("Made")
Cells: TypeAlias = Mapping[str, str]
"""The cells of a row that are not empty, by heading."""


@dataclass(frozen=True)
class SealedQuestion:
    """One question of a blind test: ``given`` is what stands in its other cells, as text by column."""

    id: str
    kind: str
    given: Cells


@dataclass(frozen=True)
class Prediction:
    """One predicted number in ``unit``, with the ends of its 50 and 90 % intervals; None where none is known.

    ``version``, ``questions_sha256``: of the program, and of the file that was asked.
    """

    id: str
    kind: str
    unit: str
    value: float
    low_50: float | None
    high_50: float | None
    low_90: float | None
    high_90: float | None
    version: str
    questions_sha256: str


@dataclass(frozen=True)
class SealedMeasurement:
    """What was measured for a question, in the unit of the question, with its standard error; 0: not known."""

    id: str
    value: float
    error: float


def read_questions(path: Path) -> list[SealedQuestion]:
    """Return the questions of a file: CSV with a line for each, or TOML with a table ``[[question]]`` for each.

    Raises
    ------
    InputError
        that names every question without ``id`` or ``kind``, and every ``id`` that is there twice.
    """

    def question(cells: Cells) -> SealedQuestion:
        if not cells.get("kind"):
            raise ValueError("has no kind")
        given = {name: cell for name, cell in cells.items() if name not in ("id", "kind")}
        return SealedQuestion(cells["id"], cells["kind"], given)

    rows = _toml_rows(path) if path.suffix.lower() == ".toml" else _csv_rows(path, ("id", "kind"))
    return _read(path, rows, question)


def read_predictions(path: Path) -> list[Prediction]:
    """Return predictions as `predictions_csv` writes them, of this program or another.

    Raises
    ------
    InputError
        that names every line whose numbers are none or whose intervals do not hold their number.
    """

    def prediction(cells: Cells) -> Prediction:
        ends = {name: _number(cells, name, absent=None) for name in ("low_50", "high_50", "low_90", "high_90")}
        value = _number(cells, "value")
        for level in ("50", "90"):
            low, high = ends[f"low_{level}"], ends[f"high_{level}"]
            if (low is None) != (high is None):
                raise ValueError(f"has one end of its {level} % interval")
            if low is not None and high is not None and not low <= value <= high:
                raise ValueError(f"has value {value:g} outside its {level} % interval, {low:g} to {high:g}")
        return Prediction(
            id=cells["id"],
            kind=cells.get("kind", ""),
            unit=cells.get("unit", ""),
            value=value,
            **ends,
            version=cells.get("version", ""),
            questions_sha256=cells.get("questions_sha256", ""),
        )

    return _read(path, _csv_rows(path, ("id", "value")), prediction)


def read_measured(path: Path) -> list[SealedMeasurement]:
    """Return the measurements of a CSV file with ``id``, ``value`` and, where it is known, its standard ``error``.

    Raises
    ------
    InputError
        that names every line without a number.
    """

    def measured(cells: Cells) -> SealedMeasurement:
        error = _number(cells, "error", absent=0.0)
        if error < 0:
            raise ValueError(f"has error {error:g}; allowed is 0 or more")
        return SealedMeasurement(cells["id"], _number(cells, "value"), error)

    return _read(path, _csv_rows(path, ("id", "value")), measured)


def predictions_csv(predictions: Sequence[Prediction]) -> bytes:
    """Return predictions as CSV text, in full digits, so that a score of them is of what was predicted."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    names = [part.name for part in fields(Prediction)]
    writer.writerow(names)
    writer.writerows([harmless(getattr(prediction, name)) for name in names] for prediction in predictions)
    return text.getvalue().encode()


def _read(path: Path, rows: Iterator[tuple[str, Cells]], make: Callable[[Cells], Made]) -> list[Made]:
    """Return every row as it is made; refuse the faults of all rows in one message."""
    found, faults, seen = [], [], set()
    for where, cells in rows:
        name = cells.get("id", "")
        if not name:
            faults.append(f"{where} has no id")
            continue
        if name in seen:
            faults.append(f"{where}: the id {name[:60]!r} is there twice")
        seen.add(name)
        try:
            found.append(make(cells))
        except ValueError as error:
            faults.append(f"{where} ({name[:60]}) {error}")
    refuse_all(path, faults)
    if not found:
        raise InputError(f"{path} has no rows under its headings")
    if len(found) > MOST_QUESTIONS:
        raise InputError(f"{path} has {len(found)} rows; allowed are {MOST_QUESTIONS}")
    return found


def refuse_all(path: Path | str, faults: Sequence[str]) -> None:
    """Refuse a file for everything that is wrong with it, in one message."""
    if faults:
        more = f"; and {len(faults) - MOST_FAULTS} more" if len(faults) > MOST_FAULTS else ""
        raise InputError(f"{path}: {'; '.join(faults[:MOST_FAULTS])}{more}")


def _csv_rows(path: Path, needed: tuple[str, ...]) -> Iterator[tuple[str, Cells]]:
    """Yield where a row is, and its cells that are not empty by heading."""
    text = read_text(path, most=MOST_TABLE_BYTES, advice=f"give a CSV file with the columns {', '.join(needed)}, ...")

    def is_heading(cells: Sequence[str]) -> bool:
        return "id" in [_heading(cell) for cell in cells]

    rows = list(table_rows(text, path, is_heading=is_heading))
    if not rows or not is_heading(rows[0][1]):
        raise InputError(f"{path} has no line of headings with an id; give the columns {', '.join(needed)}, ...")
    headings = [_heading(cell) for cell in rows[0][1]]
    missing = [name for name in needed if name not in headings]
    twice = sorted({name for name in headings if name and headings.count(name) > 1})
    refuse_all(
        path, [f"it has no column {name}" for name in missing] + [f"the column {name} is there twice" for name in twice]
    )
    for line, cells in rows[1:]:
        if len(cells) > len(headings):
            yield f"line {line}", {"id": "", "kind": ""}
            continue
        named = {name: cell.strip() for name, cell in zip(headings, cells, strict=False) if name}
        yield f"line {line}", {name: cell for name, cell in named.items() if cell.lower() not in EMPTY}


def _heading(cell: str) -> str:
    return cell.strip().lower().replace(" ", "_").replace("-", "_")


def _toml_rows(path: Path) -> Iterator[tuple[str, Cells]]:
    table = read_toml(path)
    listed = table.get("question")
    if not isinstance(listed, list) or set(table) != {"question"}:
        raise InputError(f"{path} must have tables [[question]] and nothing else")
    for number, cells in enumerate(listed, start=1):
        yield f"question {number}", {name: str(cell).strip() for name, cell in dict(cells).items()}


def _number(cells: Cells, name: str, absent: Any = math.nan) -> Any:
    """Return the number of a cell; what is ``absent`` where it is empty, which nan refuses."""
    text = cells.get(name, "")
    if not text and not (isinstance(absent, float) and math.isnan(absent)):
        return absent
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"has {name} {text[:40]!r}, which is no number" if text else f"has no {name}")
    return number
