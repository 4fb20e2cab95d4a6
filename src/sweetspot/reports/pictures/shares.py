"""Sources of an interval as ranked bars."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure

from sweetspot.reports.pictures.panels import Page, heading
from sweetspot.reports.pictures.style import INK, SMALL, fitted, styled
from sweetspot.reports.quantities import BLUE, US, Reader

WIDTH, NAMES, BAR, AROUND = 8.0, 1.9, 0.34, 0.75
"""Inches of the figure, of the names left of the bars, of the height per bar, and of the rest."""


@styled
def shares_figure(shares: Mapping[str, float], named: str, reading: Reader = US) -> Figure:  # noqa: ARG001 - parts
    """Return a figure of ranked bars: the part of the variance of an answer that each source causes alone."""
    tall = BAR * max(len(shares), 1)
    page = Page(WIDTH, AROUND + tall, 0.0)
    axes = page.panel(AROUND / 2, tall, left=NAMES, width=WIDTH - NAMES - 0.1)
    values = [100 * share for share in shares.values()]
    names = [fitted(name, width=NAMES, size=SMALL, smallest=SMALL)[0] for name in shares]
    bars = axes.barh(range(len(values)), values, height=0.62, color=BLUE)
    axes.bar_label(bars, labels=[f"{value:.0f} %" for value in values], padding=4, color=INK)
    axes.set_yticks(range(len(values)), names)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.15 * max(values, default=1.0))
    axes.xaxis.set_visible(False)
    axes.spines[["top", "right", "bottom"]].set_visible(False)
    heading(axes, f"What the interval of the {named} comes from", "parts of its variance")
    return page.figure
