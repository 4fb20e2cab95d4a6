"""A season's intervals: how often those of exit speeds hold, by what is known of the swing and the pitch."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from figures.style import BLUE, GREY, RED, new_figure

PAGE = Path(__file__).parents[1] / "theory" / "season_evidence.md"
ROW = re.compile(r"^\| ([^|]+) \| ([\d,]+) \| ([\d.]+) \| ([\d.]+) \| [\d.]+ \|$", re.MULTILINE)
"""A row of the page's table, which holds what ``studies.held_out`` prints."""
SHOWN = ("bat speed", "attack angle", "pitch outside", "turned up", "all")
"""Beginnings of the rows that are drawn."""


def coverage_figure() -> Figure:
    """Return the part of tracked exit speeds within their intervals of 50 and 90 %, with standard errors."""
    rows = [row for row in ROW.findall(PAGE.read_text(encoding="utf-8")) if row[0].startswith(SHOWN)]
    counts = np.array([int(count.replace(",", "")) for _, count, _, _ in rows])
    figure, (plot,) = new_figure(6.6, 5.6)
    height = np.arange(len(rows))[::-1]
    for part, column, color in ((50, 2, BLUE), (90, 3, RED)):
        held = np.array([float(row[column]) for row in rows])
        error = 100 * np.sqrt(part / 100 * (1 - part / 100) / counts)
        plot.axvline(part, color=GREY, linewidth=1)
        plot.errorbar(held, height, xerr=error, fmt="o", color=color, capsize=2, markersize=4, label=f"{part} %")
    plot.set_yticks(height, [f"{name} ({count})" for name, count, _, _ in rows], fontsize=8)
    plot.set(xlabel="% of tracked exit speeds within the interval", xlim=(38, 100), ylim=(-0.7, len(rows) - 0.3))
    plot.legend(title="interval", loc=(0.56, 0.7), fontsize=8)
    plot.grid(alpha=0.3, axis="x")
    return figure
