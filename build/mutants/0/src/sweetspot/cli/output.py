"""Printing: data on stdout, progress on stderr."""

from __future__ import annotations

import csv
import json
import sys
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

PATIENCE = 3.0
"""s before a run says why it takes a while."""


def print_json(value: Any) -> None:
    """Print one JSON object on stdout."""
    json.dump(value, sys.stdout, indent=2, allow_nan=False)
    sys.stdout.write("\n")


def print_csv(columns: Mapping[str, Sequence[Any]]) -> None:
    """Print columns of equal length as CSV on stdout; None becomes an empty field."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*columns.values(), strict=True))


def print_rows_csv(rows: Sequence[Mapping[str, Any]]) -> None:
    """Print equal rows as CSV on stdout."""
    print_csv({name: [row[name] for row in rows] for name in rows[0]})


def print_table(renderable: Any) -> None:
    """Print a rich table on stdout, as wide as the terminal, or 110 columns where there is none."""
    from rich.console import Console

    console = Console(soft_wrap=False)
    if not console.is_terminal:
        console = Console(width=110)
    console.print(renderable)


@contextmanager
def patience() -> Iterator[None]:
    """Say on stderr that the first run compiles, when the work inside takes longer than `PATIENCE`."""

    def say() -> None:
        print("sweetspot: working; the first run compiles the collision kernel and keeps it", file=sys.stderr)

    timer = threading.Timer(PATIENCE, say)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
