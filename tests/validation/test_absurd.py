"""The published cases can fail: no row passes an absurd value, whatever it is compared with."""

from __future__ import annotations

import math
import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from sweetspot import validation
from sweetspot.errors import InputError
from sweetspot.validation import verdicts
from sweetspot.validation.cases import CASES

ABSURD = (1e6, -1e6, math.nan, math.inf)
EXPLAINED = [(case.source, row) for case in validation.sources() for row in case.rows if row.expected_miss]


@pytest.mark.parametrize("value", ABSURD)
def test_validate_fails_whichever_computation_is_replaced(monkeypatch: pytest.MonkeyPatch, value: float) -> None:
    """Every computed number is replaced, in SI; each row must fail."""
    cases = validation.sources()
    monkeypatch.setattr(verdicts, "computed_number", lambda _: value * 1e6)
    survivors = [
        f"{case.source}, {row.name}: {row.computation}"
        for case in cases
        for row in case.rows
        if verdicts.judged(row, case).passed
    ]
    assert survivors == []
    found = [verdicts.judged(row, case) for case in cases for row in case.rows]
    assert sum(part.fail for part in validation.summary(found)) == len(found)
    assert not validation.passed(found)
    assert f"{len(found)} rows fail" in validation.headline(found)


@pytest.mark.parametrize(("source", "row"), EXPLAINED, ids=lambda part: part if isinstance(part, str) else part.name)
def test_an_explained_miss_fails_when_it_is_another_miss_or_none(source: str, row: validation.Row) -> None:
    (case,) = [case for case in validation.sources() if case.source == source]
    assert row.ours is not None
    unit = verdicts.UNITS[row.unit]
    passed = [judged_as(row, (row.ours + off * row.ours_tolerance) * unit, case).passed for off in (-3, 0, 3)]
    assert passed == [False, True, False]
    low, high = row.allowed
    assert "explained was" in judged_as(row, (low + high) / 2 * unit, case).status


def judged_as(row: validation.Row, computed: float, case: validation.Case) -> validation.Result:
    """Return the row judged as if the package had computed ``computed``."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(verdicts, "computed_number", lambda _: computed)
        return verdicts.judged(row, case)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("low = 1.0\n", "", "open at one end"),
        ('evidence = "prediction about bats"', 'evidence = "proof"', "allowed are prediction about bats"),
        ("error = 0.5\n", "error = 0.5\nours = 3.0\n", "without expected_miss"),
        ('error_from = "rounding"\n', "", "an error without error_from"),
        ('"rounding"', '"taste"', "allowed are printed, rounding"),
        ("error = 0.5\n", "tolerance = 0.5\nerror = 0.5\n", "two tolerances"),
        ("error = 0.5\n", 'error = 0.5\nexpected_miss = "why"\n', "give ours and ours_tolerance"),
        (
            "error = 0.5\n",
            'error = 0.5\nexpected_miss = "why"\nours = 2.6\nours_tolerance = 0.1\n',
            "explains no miss",
        ),
    ],
)
def test_a_row_that_could_not_fail_is_refused(tmp_path: Path, old: str, new: str, message: str) -> None:
    shutil.copytree(CASES / "nathan_corknote", tmp_path / "nathan_corknote")
    case = tmp_path / "nathan_corknote" / "case.toml"
    text = case.read_text(encoding="utf-8")
    case.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InputError, match=re.escape(message)):
        validation.sources(tmp_path)


def test_what_was_fitted_is_not_called_a_prediction() -> None:
    """The outlines of r161-ash and russell-b1 were searched for these (see their catalogue files)."""
    evidence = {
        (case.source, row.name, row.quantity): row.evidence
        for case in validation.sources()
        for row in case.rows
        if row.inputs.get("bat") in ("r161-ash", "russell-b1") and row.computation in ("frequency", "node_from_tip")
    }
    first = "frequency of mode 1"
    node = "barrel node of mode 1, from the tip"
    assert evidence["russell_batvibes", "r161-ash", first] == "calibrated"
    assert evidence["russell_batvibes", "r161-ash", node] == "calibrated"
    assert evidence["russell_batvibes", "russell-b1", first] == "calibrated"
    assert evidence["cross1998", "r161-ash", node] == "calibrated"


def test_the_headline_counts_predictions_about_bats_first() -> None:
    found = [verdicts.judged(row, case) for case in validation.sources() for row in case.rows if row.kind == "identity"]
    parts = {part.evidence: part for part in validation.summary(found)}
    assert parts["prediction about bats"].rows == 0
    assert validation.headline(found).startswith("0 independent published numbers about bats")
    assert sum(part.rows for part in parts.values()) == len(found)


def test_rows_that_repeat_one_published_number_count_once() -> None:
    case = next(case for case in validation.sources() if case.source == "nathan_corknote")
    row = replace(case.rows[0], evidence="prediction about bats")
    assert row.value is None and row.low is not None
    good, bad = row.low * verdicts.UNITS[row.unit], -1.0

    def counted(*found: validation.Result) -> verdicts.EvidenceCount:
        return validation.summary(found)[0]

    holds = judged_as(row, good, case)
    assert counted(holds, replace(holds, name="another bat"))[5:8] == (1, 1, 0)
    assert counted(holds, judged_as(row, bad, case))[5:8] == (1, 0, 1), "one row of a number fails, so it fails"
    assert counted(holds, replace(holds, number="another"))[5:8] == (2, 2, 0)
    assert counted(holds).from_source == 1
    ours = replace(holds, error=0.0, error_from="", tolerance=0.5)
    assert counted(ours).from_source == counted(holds, ours).from_source == 0
