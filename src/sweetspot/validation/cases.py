"""The case files: one folder per source, ``case.toml`` and, where rows repeat, a ``.csv`` table beside it.

A row with ``table`` stands for one row per line of that table; ``{column}`` in its texts is replaced by the cell.
Where a number belongs, such a text becomes one.
"""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Literal, get_args

from sweetspot.errors import InputError

CASES = Path(__file__).parent / "cases"


Kind = Literal["identity", "quantitative", "band", "trend"]
Tag = Literal["P", "S", "D"]
Evidence = Literal["prediction about bats", "other prediction", "identity", "same law", "calibrated"]

KINDS: tuple[Kind, ...] = get_args(Kind)
TAGS: dict[Tag, str] = {
    "P": "read in the primary source",
    "S": "quoted by a secondary source",
    "D": "derived here by plain arithmetic from such numbers",
}
"""How a printed number was read. Numbers recalled from memory are never cases."""
EVIDENCE: dict[Evidence, str] = {
    "prediction about bats": "a number or statement about real bats, or hits with them, that went into nothing of ours",
    "other prediction": "the same about flights, pitches and other sports",
    "identity": "arithmetic: follows from the source's own numbers by a definition or an exact formula",
    "same law": "the source and we integrate or solve the same law: shows that the code is right, not that the law is",
    "calibrated": "went into our data: shows that it comes out again",
}
"""What a row is worth. Only the first two can tell whether the model is right."""
ErrorFrom = Literal["printed", "rounding", "scatter", "reading", "range", "sign", "ours"]
ERROR_FROM: dict[ErrorFrom, str] = {
    "printed": "the source gives it with its value (of a standard deviation or error: 1.64 of it)",
    "rounding": "half a unit of the last printed digit",
    "scatter": "from the source's own repeated values (of a standard deviation: 1.64 of it)",
    "reading": "what its figure can be read to",
    "range": "the ends of the range that it prints",
    "sign": "it gives a sign or an order",
    "ours": "our own judgment, or a sum with more than the source's error; the reason says what is in it",
}
"""Where the error of a printed value comes from. All but the last can be written down before ours is computed."""
Subject = Literal[
    "wood bats and baseballs", "hollow bats and softball", "cricket", "tennis", "table tennis", "badminton", "golf",
    "field hockey", "pickleball", "squash",
]  # fmt: skip
"""What a source is about."""


@dataclass(frozen=True)
class Row:
    """One value of a source, and how to compute ours.

    Parameters
    ----------
    name, quantity : which case, and what is compared.
    printed : the value as the source prints it, text.
    computation : name in the registry of computations.
    reason : why just that tolerance.
    kind : identity (exact arithmetic), quantitative, band, or trend (a sign or an order).
    tag, evidence : how the printed value was read, see `TAGS`, and what the row is worth, see `EVIDENCE`.
    unit : of printed and computed; empty for ratios.
    value : expected, in ``unit``; None for a band.
    low, high : ends of a band in ``unit``; a band has both, so that no absurd value can lie in it.
    error, error_from : half width of the source's own 90 % error in ``unit``, and where it comes from (`ERROR_FROM`).
        It is what is allowed; write it down before you compute ours.
    tolerance, tolerance_percent : allowed difference from ``value``, or beyond the ends of the band, where the source's
        error is not all of it; one of these and ``error``.
    number : key of the independent published number within its source. Rows with one key count once; without a key,
        rows of one source with the same printed text and unit do.
    inputs : arguments of the computation, texts with units.
    of : number of a computed thing, as a dotted path of attributes; empty: the computation returns the number.
    expected_miss : why ours differs, where the physics says so; empty otherwise.
    ours, ours_tolerance : of such a miss: what this version of the model is expected to say, in ``unit``; anything else
        fails, a hit too.
    """

    name: str
    quantity: str
    printed: str
    computation: str
    reason: str
    kind: Kind
    tag: Tag
    evidence: Evidence
    unit: str = ""
    value: float | None = None
    low: float | None = None
    high: float | None = None
    tolerance: float = 0.0
    tolerance_percent: float = 0.0
    error: float = 0.0
    error_from: ErrorFrom | Literal[""] = ""
    number: str = ""
    inputs: Mapping[str, Any] = field(default_factory=dict)
    of: str = ""
    comment: str = ""
    expected_miss: str = ""
    ours: float | None = None
    ours_tolerance: float = 0.0

    @property
    def allowed(self) -> tuple[float, float]:
        """The ends between which a computed value passes, in ``unit``."""
        low = self.value if self.low is None else self.low
        high = self.value if self.high is None else self.high
        assert low is not None
        assert high is not None
        slack = self.error or self.tolerance or self.tolerance_percent / 100 * abs(self.value or 0.0)
        return low - slack, high + slack

    @property
    def allowed_text(self) -> str:
        """The allowed range in words: ``± 0.5 %`` or ``4 to 6, ± 0.5``."""
        slack = self.error or self.tolerance
        text = f"± {self.tolerance_percent:g} %" if self.tolerance_percent else f"± {slack:g}"
        if self.value is not None:
            return text
        band = f"{self.low:g} to {self.high:g}"
        return f"{band}, {text}" if slack else band

    @property
    def allowed_by(self) -> ErrorFrom:
        """Where the allowed range comes from: as given, else read from what the row allows."""
        if self.error_from:
            return self.error_from
        if self.kind == "trend":
            return "sign"
        return "ours" if self.value is not None or self.tolerance or self.tolerance_percent else "range"

    @property
    def number_key(self) -> str:
        """What tells this published number from the others of its source."""
        return self.number or f"{self.printed} {self.unit}"


@dataclass(frozen=True)
class Result(Row):
    """A row with its verdict: the key of its source in the bibliography, and what we computed, in ``unit``."""

    source: str = ""
    computed: float = math.nan

    @property
    def ok(self) -> bool:
        """Whether ours lies within the tolerance."""
        low, high = self.allowed
        return bool(low <= self.computed <= high)

    @property
    def passed(self) -> bool:
        """Whether the row lets a run pass: within its tolerance, or just the miss that is explained."""
        if self.ours is None:
            return self.ok
        return abs(self.computed - self.ours) <= self.ours_tolerance

    @property
    def status(self) -> str:
        """The verdict in words."""
        if self.ours is None:
            return "ok" if self.ok else "MISS"
        return "MISS (explained)" if self.passed else f"MISS (explained was {self.expected_of_us})"

    @property
    def expected_of_us(self) -> str:
        """The value and band that an explained miss must keep, as text; empty for other rows."""
        return "" if self.ours is None else f"{self.ours:g} ± {self.ours_tolerance:g}"


@dataclass(frozen=True)
class Case:
    """Everything taken from one source.

    ``source``: key of the bibliography. ``subject``: what it is about. ``axes``: how its positions, signs and units map
    to ours. ``left_out``: what the source also gives and is not compared, each with the reason.
    """

    source: str
    subject: Subject
    title: str
    measured: str
    axes: str
    left_out: tuple[str, ...]
    rows: tuple[Row, ...]


def sources(folder: Path = CASES) -> tuple[Case, ...]:
    """Return every case, in the order of the source keys."""
    return tuple(load_case(path) for path in sorted(folder.glob("*/case.toml")))


def load_case(path: Path) -> Case:
    """Return the case of one ``case.toml``; the folder's name must be its source key."""
    with path.open("rb") as file:
        table = tomllib.load(file)
    if table.get("source") != path.parent.name:
        raise InputError(f"{path} names the source {table.get('source')!r}; it must be its folder's name")
    subject: Any = table.get("subject")
    if subject not in get_args(Subject):
        raise InputError(f"{path} is about {subject!r}; allowed are {', '.join(get_args(Subject))}")
    rows = tuple(_row(entry, path) for row in table.get("row", ()) for entry in _repeated(row, path.parent))
    left_out = tuple(table["left_out"])
    return Case(table["source"], subject, table["title"], table["measured"], table["axes"], left_out, rows)


def _repeated(row: Mapping[str, object], folder: Path) -> Iterator[Mapping[str, object]]:
    """Yield the row once, or once per line of its table."""
    if "table" not in row:
        yield row
        return
    with (folder / str(row["table"])).open(encoding="utf-8", newline="") as file:
        for line in csv.DictReader(file):
            filled = {key: _filled(value, line) for key, value in row.items() if key != "table"}
            yield {key: float(str(value)) if key in NUMBERS else value for key, value in filled.items()}


NUMBERS = ("value", "low", "high", "error", "tolerance", "tolerance_percent", "ours", "ours_tolerance")


def _filled(value: object, cells: Mapping[str, str]) -> object:
    if isinstance(value, dict):
        return {key: _filled(inner, cells) for key, inner in value.items()}
    return value.format_map(cells) if isinstance(value, str) else value


REQUIRED = [part.name for part in fields(Row) if part.default is MISSING and part.default_factory is MISSING]


def _row(entry: Mapping[str, object], path: Path) -> Row:
    where = f"{path}, row {entry.get('name')!r}"
    if missing := [key for key in REQUIRED if not entry.get(key)]:
        raise InputError(f"{where} lacks {', '.join(missing)}")
    if unknown := entry.keys() - {part.name for part in fields(Row)}:
        raise InputError(f"{where} has unknown keys {', '.join(sorted(unknown))}")
    row = Row(**entry)  # type: ignore[arg-type]
    if row.kind not in KINDS or row.tag not in TAGS:
        raise InputError(
            f"{where} has kind {row.kind!r} and tag {row.tag!r}; allowed are {', '.join(KINDS)} and "
            f"{', '.join(TAGS)} (a value recalled from memory is no case)"
        )
    if row.evidence not in EVIDENCE:
        raise InputError(f"{where} has evidence {row.evidence!r}; allowed are {', '.join(EVIDENCE)}")
    if row.low is None and row.high is None:
        row = replace(row, value=_number(row, where))
    elif row.value is not None:
        raise InputError(f"{where} has both a value and a band; give one of them")
    elif row.low is None or row.high is None:
        raise InputError(f"{where} has a band that is open at one end: every absurd value would pass; give both ends")
    if sum(map(bool, (row.tolerance, row.tolerance_percent, row.error))) > 1:
        raise InputError(f"{where} has two tolerances; give one of error, tolerance and tolerance_percent")
    if row.error_from and row.error_from not in ERROR_FROM:
        raise InputError(f"{where} has error_from {row.error_from!r}; allowed are {', '.join(ERROR_FROM)}")
    if row.error and not row.error_from:
        raise InputError(f"{where} has an error without error_from, where it comes from: {', '.join(ERROR_FROM)}")
    _check_miss(row, where)
    return row


def _check_miss(row: Row, where: str) -> None:
    """Refuse an explained miss that does not say what is expected of us, or one that is none."""
    if not row.expected_miss:
        if row.ours is not None:
            raise InputError(f"{where} has ours = {row.ours:g} without expected_miss, the reason of the miss")
        return
    if row.ours is None or not row.ours_tolerance > 0:
        raise InputError(f"{where} explains a miss; give ours and ours_tolerance, what this model is expected to say")
    low, high = row.allowed
    if row.ours + row.ours_tolerance >= low and row.ours - row.ours_tolerance <= high:
        raise InputError(f"{where}: ours ± ours_tolerance reaches what is allowed, so it explains no miss")


def _number(row: Row, where: str) -> float:
    """Return the expected value: as given, or else the printed text read as a number."""
    if row.value is not None:
        return float(row.value)
    try:
        return float(row.printed.replace(",", ""))
    except ValueError:
        raise InputError(f"{where} prints {row.printed!r}, which is no number; give value, low or high") from None
