"""Numbers as JSON has them."""

from __future__ import annotations

from typing import Any


def as_columns(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    """Return rows as columns, None where a row lacks a key; no columns where there are no rows."""
    return {name: [row.get(name) for row in rows] for name in dict.fromkeys(name for row in rows for name in row)}
