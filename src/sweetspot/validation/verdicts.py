"""The verdict on every case, and the verdicts as rows for the command line and as Markdown for the docs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite
from operator import attrgetter
from pathlib import Path
from typing import NamedTuple, get_args

from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, POUND_FORCE, RPM, Kind
from sweetspot.validation.cases import CASES, EVIDENCE, TAGS, Case, Evidence, Result, Row, Subject, sources
from sweetspot.validation.computations.registry import COMPUTATIONS

UNITS = dict.fromkeys(("", "m", "kg", "kg m^2", "m/s", "s", "rad/s", "Hz", "kg/m^3", "mph per mph"), 1.0)
UNITS |= {"%": 0.01, "cm": 0.01, "in": INCH, "ft": FOOT, "yd": 3 * FOOT, "cm^3": 1e-6, "ft/s^2": FOOT, "mph": MPH}
UNITS |= {
    "oz": OUNCE,
    "kg cm^2": 1e-4,
    "oz in^2": OUNCE_INCH_SQUARED,
    "ms": 1e-3,
    "kN": 1e3,
    "lbf": POUND_FORCE,
    "GPa": 1e9,
}
UNITS |= {"per mph": 1 / MPH, "lbf": POUND_FORCE, "1/m": 1.0, "rpm": RPM, "rpm/deg": RPM / DEGREE, "deg": DEGREE}
"""Units of printed values, each in SI."""

_INPUTS: dict[Kind, str] = {
    "speed": "ball_speed bat_speed exit_speed speed other_speed closing_speed wind_speed faster",
    "ratio": "efficiency besr restitution recoil bat_restitution ball_restitution share humidity poisson_ratio",
    "length": "length pivot axis from_tip lateral depth distance measured_at bore_diameter bore_depth plug "
    "balance_point elevation height diameter thinner wall bar_length bar_width bar_thickness inward outward",
    "mass": "mass ball_mass added_mass bar_mass",
    "moi": "moi other_moi",
    "time": "contact_time time",
    "angle": "angle launch_angle deflection other_deflection spray wind_direction",
    "angular speed": "backspin sidespin",
    "temperature": "temperature",
    "pressure": "modulus",
    "frequency": "frequency",
    "density": "density",
}
INPUT_KINDS = {name: kind for kind, names in _INPUTS.items() for name in names.split()}
"""What the inputs of computations are; inputs with other names (bats, mode numbers) are passed on as they stand."""


def results(folder: Path = CASES) -> tuple[Result, ...]:
    """Return every published case computed and judged, source by source."""
    return tuple(judged(row, case) for case in sources(folder) for row in case.rows)


def passed(verdicts: Iterable[Result]) -> bool:
    """Return whether all rows are within tolerance, but for explained misses."""
    return all(result.passed for result in verdicts)


def judged(row: Row, case: Case) -> Result:
    """Compute one row and compare it with what is printed."""
    if row.computation not in COMPUTATIONS:
        raise InputError(f"{case.source}, {row.name}: no computation {row.computation!r}")
    if row.unit not in UNITS:
        raise InputError(f"{case.source}, {row.name}: unit {row.unit!r} is not one of {', '.join(UNITS)}")
    computed = computed_number(row) / UNITS[row.unit]
    return Result(**vars(row), source=case.source, computed=computed)


def computed_number(row: Row) -> float:
    """Return the number that a row asks for, in SI."""
    given = row.inputs
    inputs = {
        name: parse(given[name], INPUT_KINDS[name], name) if name in INPUT_KINDS else given[name] for name in given
    }
    computed = COMPUTATIONS[row.computation](**inputs)
    return float(attrgetter(row.of)(computed) if row.of else computed)


Value = str | float | bool | None
WRITTEN = (
    *("source", "name", "quantity", "printed", "computed", "unit", "tolerance", "reason", "kind", "tag", "ok"),
    *("comment", "evidence", "expected_miss", "ours", "ours_tolerance", "status", "passed", "number_key", "allowed_by"),
)
"""Fields of a result that its flat row has."""


def rows(verdicts: Sequence[Result] | None = None) -> list[dict[str, Value]]:
    """Return every case as a flat dictionary with its verdict; computes them unless given.

    A computed value that is no number becomes None, which JSON can say.
    """
    return [
        {name: getattr(result, name) for name in WRITTEN}
        | {"computed": result.computed if isfinite(result.computed) else None, "tolerance": result.allowed_text}
        for result in (results() if verdicts is None else verdicts)
    ]


def short_rows(verdicts: Sequence[Result] | None = None) -> list[dict[str, str]]:
    """Return the columns that fit a terminal: source, case, printed, computed, allowed, evidence, status."""
    return [
        {
            "source": result.source,
            "case": f"{result.name}: {result.quantity}",
            "printed": f"{result.printed} {result.unit}".strip()
            if result.unit not in result.printed
            else result.printed,
            "computed": number_words(result),
            "allowed": result.allowed_text,
            "evidence": result.evidence,
            "status": result.status,
        }
        for result in (results() if verdicts is None else verdicts)
    ]


PREDICTED: tuple[Evidence, ...] = ("prediction about bats", "other prediction")
"""Evidence that can tell whether the model is right."""


class EvidenceCount(NamedTuple):
    """How many rows, and how many independent published numbers, of one kind of evidence hold, miss, and fail.

    A number holds if each of its rows does, and fails if one of them does.
    """

    evidence: Evidence
    rows: int
    hold: int
    explained_misses: int
    fail: int
    numbers: int
    numbers_hold: int
    numbers_fail: int
    from_source: int
    """Numbers whose allowed range is the source's own error, range or sign in every row, with nothing of ours in it."""


def summary(verdicts: Sequence[Result]) -> list[EvidenceCount]:
    """Return the counts of every kind of evidence."""
    return [_count(evidence, [result for result in verdicts if result.evidence == evidence]) for evidence in EVIDENCE]


def _count(evidence: Evidence, group: Sequence[Result]) -> EvidenceCount:
    numbers: dict[tuple[str, str], list[Result]] = {}
    for result in group:
        numbers.setdefault((result.source, result.number_key), []).append(result)
    return EvidenceCount(
        evidence,
        rows=len(group),
        hold=sum(_holds(result) for result in group),
        explained_misses=sum(result.passed and bool(result.expected_miss) for result in group),
        fail=sum(not result.passed for result in group),
        numbers=len(numbers),
        numbers_hold=sum(all(map(_holds, rows)) for rows in numbers.values()),
        numbers_fail=sum(not passed(rows) for rows in numbers.values()),
        from_source=sum(all(row.allowed_by != "ours" for row in rows) for rows in numbers.values()),
    )


class SubjectCount(NamedTuple):
    """How many independent published numbers of one subject are predicted, and how many hold, miss, and fail."""

    subject: Subject
    numbers: int
    hold: int
    explained_misses: int
    fail: int


def by_subject(verdicts: Sequence[Result], folder: Path = CASES) -> list[SubjectCount]:
    """Return the counts of predicted numbers for every subject; one number holds if each of its rows does."""
    of = {case.source: case.subject for case in sources(folder)}
    counts = []
    for subject in get_args(Subject):
        parts = [
            part
            for part in summary([row for row in verdicts if of[row.source] == subject])
            if part.evidence in PREDICTED
        ]
        numbers, hold, fail = (
            sum(getattr(part, key) for part in parts) for key in ("numbers", "numbers_hold", "numbers_fail")
        )
        counts.append(SubjectCount(subject, numbers, hold, numbers - hold - fail, fail))
    return counts


def _holds(result: Result) -> bool:
    return result.passed and not result.expected_miss


def headline(verdicts: Sequence[Result]) -> str:
    """Return the few sentences that say how well the model predicts bats, and what the other rows are."""
    bats, *rest = summary(verdicts)
    others = ", ".join(f"{part.evidence} {part.numbers} ({part.rows})" for part in rest)
    failed = sum(part.fail for part in (bats, *rest))
    missed = bats.numbers - bats.numbers_hold - bats.numbers_fail
    return (
        f"{bats.numbers} independent published numbers about bats, in {bats.rows} rows: {bats.numbers_hold} hold, "
        f"{missed} miss as explained, {bats.numbers_fail} fail. Counted apart, numbers (rows): {others}. "
        + (f"{failed} rows fail." if failed else "No row fails.")
    )


def number_words(result: Result) -> str:
    """Return the computed value with as many digits as a reader can use."""
    digits = 5 if result.kind == "identity" else 4
    return f"{result.computed:.{digits}g}"


def markdown(case: Case, verdicts: Sequence[Result]) -> str:
    """Return one source as a Markdown section: what was measured, the table, reasons, misses, what was left out."""
    chosen = [result for result in verdicts if result.source == case.source]
    lines = [f"## {case.title}", "", f"Source: `{case.source}`. {case.measured}", ""]
    lines += [f"Axes and signs: {case.axes}", ""]
    lines += ["| | case | printed | computed | allowed | from | kind | read | evidence | verdict |", "|-" * 10 + "|"]
    for number, result in enumerate(chosen, start=1):
        short = short_rows([result])[0]
        cells = [str(number), *(short[key] for key in ("case", "printed", "computed", "allowed"))]
        cells += [result.allowed_by, result.kind, TAGS[result.tag], result.evidence, result.status]
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    lines += ["", "Reasons:", ""]
    lines += [f"- {', '.join(numbers)}: {text}" for text, numbers in _shared_texts(chosen).items()]
    if case.left_out:
        lines += ["", "Left out:", "", *(f"- {text}" for text in case.left_out)]
    return "\n".join(lines) + "\n"


def _shared_texts(verdicts: Sequence[Result]) -> dict[str, list[str]]:
    """Return reason, comment and explanation of the rows, each text once with the numbers of its rows."""
    texts: dict[str, list[str]] = {}
    for number, result in enumerate(verdicts, start=1):
        expected = f"Expected of this model: {result.expected_of_us} {result.unit}".strip() + "."
        explained = f"**Why it misses:** {result.expected_miss} {expected}" if result.expected_miss else ""
        text = " ".join(part.strip() for part in (result.reason, result.comment, explained) if part)
        texts.setdefault(" ".join(text.split()), []).append(str(number))
    return texts
