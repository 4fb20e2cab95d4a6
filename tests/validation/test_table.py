"""The cases as rows and as Markdown."""

from __future__ import annotations

import json
import math
from dataclasses import replace

from sweetspot import validation
from sweetspot.validation.cases import Result

PLAIN = Result(
    name="a bat",
    quantity="its weight | mass",
    printed="31",
    computation="body",
    unit="oz",
    value=31.0,
    tolerance=0.5,
    reason="Printed in whole ounces.",
    kind="quantitative",
    tag="S",
    evidence="prediction about bats",
    source="paper2014",
    computed=31.0123456,
)


def test_rows_are_flat_json() -> None:
    (row,) = validation.rows([PLAIN])
    assert json.loads(json.dumps(row, allow_nan=False))["status"] == "ok"
    assert row["computed"] == 31.0123456


def test_a_number_that_could_not_be_computed_is_none_in_json_and_a_miss() -> None:
    (row,) = validation.rows([replace(PLAIN, computed=math.nan)])
    assert row["computed"] is None
    assert row["status"] == "MISS"


def test_short_rows_carry_units_and_verdict() -> None:
    (row,) = validation.short_rows([PLAIN])
    assert row == {
        "source": "paper2014",
        "case": "a bat: its weight | mass",
        "printed": "31 oz",
        "computed": "31.01",
        "allowed": "± 0.5",
        "evidence": "prediction about bats",
        "status": "ok",
    }


def test_markdown_shows_misses_reasons_and_what_was_left_out() -> None:
    (case,) = [case for case in validation.sources() if case.source == "paper2014"]
    miss = replace(PLAIN, value=33.0, expected_miss="The scale was wet.", ours=31.0, ours_tolerance=0.1)
    text = validation.markdown(case, [PLAIN, miss, replace(PLAIN, source="nathan2000")])
    assert text.count("| a bat: its weight \\| mass |") == 2
    assert "| MISS (explained) |" in text
    assert (
        "- 2: Printed in whole ounces. **Why it misses:** The scale was wet. Expected of this model: 31 ± 0.1 oz."
        in text
    )
    assert "Left out:" in text
    assert "nathan2000" not in text


def test_markdown_of_every_source_has_a_line_per_row() -> None:
    found = validation.results()
    for case in validation.sources():
        lines = validation.markdown(case, found).splitlines()
        assert sum(line.startswith("| ") for line in lines) == len(case.rows) + 1, case.source
