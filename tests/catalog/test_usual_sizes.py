"""Slips of units in files are noticed part by part; what is meant can be insisted on."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.implements import implement_tables
from sweetspot.errors import InputError
from sweetspot.units import insisting

TOOL = Path(__file__).resolve().parents[2] / "tools" / "unit_slips.py"
EVERY = 17
"""Which share of all slips is tried here; the tool tries all of them."""


def test_no_slip_that_matters_is_taken_in_silence() -> None:
    tool: dict[str, Any] = runpy.run_path(str(TOOL))
    tables = implement_tables()
    slips = list(tool["slips"](tables))
    assert len(slips) > 700
    true = {name: tool["answers"](catalog.implement(name)) for name in tables}
    outcomes = {str(slip): tool["outcome"](slip.table(tables), true[slip.name]) for slip in slips[::EVERY]}
    assert {slip for slip, became in outcomes.items() if became == "silent"} == set()
    assert {"refused", "warned", "harmless"} >= set(outcomes.values())


@pytest.mark.parametrize(
    ("name", "path", "text", "said"),
    [
        ("tennis-racket", ("head", "width"), "2.5 cm", "head.width was given as 2.5 cm; usual is 12 to 35 cm"),
        ("golf-driver", ("head", "mass"), "2 kg", "head.mass was given as 2 kg; usual is 0.1 to 0.5 kg"),
        ("r161-ash", ("turned", "value", "handle"), "1.01 cm", "turned.handle was given as 1.01 cm; usual is 1.52 to"),
        ("two-piece", ("shell", "value", "joint"), "15.5 cm", "joint was given as 0.18 of the length"),
        ("table-tennis-racket", ("blade_width",), "150 cm", "blade_width was given as 150 cm"),
    ],
)
def test_the_message_says_what_is_usual(name: str, path: tuple[str, ...], text: str, said: str) -> None:
    tables = {name: dict(implement_tables()[name])}
    table = _with(tables[name], path, text)
    with pytest.raises(InputError, match="Check the unit and the decimal point, or add --force"):
        implement_from_table(table, "mine.toml")
    with pytest.raises(InputError, match=said):
        implement_from_table(table, "mine.toml")


def test_who_insists_is_believed() -> None:
    table = _with(implement_tables()["golf-driver"], ("head", "mass"), "600 g")
    with insisting():
        assert implement_from_table(table, "mine.toml").length > 1


def _with(table: dict[str, Any], path: tuple[str, ...], text: str) -> dict[str, Any]:
    head, *rest = path
    return {**table, head: _with(table[head], tuple(rest), text) if rest else text}
