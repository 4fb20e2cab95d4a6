"""Numbers as JSON has them."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import chain, product
from typing import Any


def as_columns(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    """Return rows as columns, None where a row lacks a key; no columns where there are no rows."""
    return {name: [row.get(name) for row in rows] for name in dict.fromkeys(name for row in rows for name in row)}


def cells_as_columns(table: Mapping[str, Any]) -> dict[str, list[Any]]:
    """Return the cells of a table, row after row, as columns: what is varied, then every answer.

    >>> cells_as_columns({"rows": {"mass_kg": [0.8, 0.9]}, "columns": None, "answers": {"bbcor": [[0.4], [0.5]]}})
    {'mass_kg': [0.8, 0.9], 'bbcor': [0.4, 0.5]}
    """
    sides = list((table["rows"] | (table["columns"] or {})).items())
    cells = list(product(*(values for _, values in sides)))
    columns = {name: list(values) for (name, _), values in zip(sides, zip(*cells, strict=True), strict=True)}
    answers = {name: list(chain.from_iterable(rows)) for name, rows in table["answers"].items()}
    return {**columns, **{name: values for name, values in answers.items() if name not in columns}}
