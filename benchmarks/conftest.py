"""Collects what the benchmarks measure and prints it as one table at the end."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, astuple
from pathlib import Path

import pytest

from benchmarks.cases import Figure, machine

FIGURES: list[Figure] = []
TABLES: list[list[str]] = []
RESULTS = Path(__file__).parent / "results" / "figures.json"
HEADS = Figure("job", "figure", "goal", "rival", "rival / ours")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Offer to keep the figures."""
    parser.addoption("--save-figures", action="store_true", help=f"also write {RESULTS.name} under benchmarks/results")


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """Leave the plugin's own wide table to ``-v``; ours says the same in words."""
    config.option.benchmark_quiet = config.option.verbose < 1


@pytest.fixture
def record() -> Callable[..., None]:
    """Take a row of the table: record(job, figure, goal=, rival=, ratio=)."""
    return lambda *values, **named: FIGURES.append(Figure(*values, **named))


@pytest.fixture
def record_table() -> Callable[[list[str]], None]:
    """Take lines that are printed as they are, after the table."""
    return TABLES.append


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Print the table, and write it down if asked to."""
    if not FIGURES:
        return
    rows = [astuple(row) for row in (HEADS, *FIGURES)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    terminalreporter.section("sweetspot, measured")
    for row in rows:
        terminalreporter.write_line(
            "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()
        )
    for table in TABLES:
        terminalreporter.write_line("")
        for text in table:
            terminalreporter.write_line(text)
    terminalreporter.write_line("")
    for text in machine():
        terminalreporter.write_line(text)
    if config.getoption("save_figures"):
        RESULTS.parent.mkdir(exist_ok=True)
        content = {"machine": machine(), "figures": [asdict(row) for row in FIGURES], "tables": TABLES}
        RESULTS.write_text(json.dumps(content, indent=1))
        terminalreporter.write_line(f"written: {RESULTS}")
