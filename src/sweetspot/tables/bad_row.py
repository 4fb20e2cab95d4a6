"""A row of a table that is left out."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class BadRow:
    """A row that cannot be used, and why."""

    row: int
    reason: str
