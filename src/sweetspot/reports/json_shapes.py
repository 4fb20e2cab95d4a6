"""Numbers as JSON has them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


def as_columns(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    """Return rows as columns, None where a row lacks a key; no columns where there are no rows."""
    return {name: [row.get(name) for row in rows] for name in dict.fromkeys(name for row in rows for name in row)}


def cleaned(table: dict[str, Any]) -> dict[str, Any]:
    """Return a table with arrays as lists and every number that is not finite as None, as JSON has neither."""
    return {key: _clean(item) for key, item in table.items()}


def _clean(value: Any) -> Any:
    if isinstance(value, dict):
        return cleaned(value)
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiu" and np.isfinite(value).all():
        return value.tolist()
    if isinstance(value, np.ndarray | list | tuple):
        return [_clean(item) for item in value]
    if isinstance(value, np.floating | float):
        return float(value) if math.isfinite(value) else None
    return value
