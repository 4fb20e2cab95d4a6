"""Sources of an interval as ranked bars."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure

from sweetspot.reports.pictures.style import INK, SMALL, axes_in_inches, fitted, heading, styled
from sweetspot.reports.quantities import BLUE

WIDTH, NAMES, BAR, AROUND = 8.0, 1.9, 0.34, 0.75
"""Inches of the figure, of the names left of the bars, of the height per bar, and of the rest."""


@styled
def shares_figure(shares: Mapping[str, float], named: str) -> Figure:
    """Return a figure of ranked bars: the part of the variance of an answer that each source causes alone.

    Parameters
    ----------
    shares : by the name of the source, the greatest first.
    named : what people call the answer.
    """
    tall = BAR * max(len(shares), 1)
    figure = Figure(figsize=(WIDTH, AROUND + tall))
    axes = axes_in_inches(figure, left=NAMES, top=AROUND / 2, width=WIDTH - NAMES - 0.1, height=tall)
    values = [100 * share for share in shares.values()]
    names = [fitted(name, width=NAMES, size=SMALL, smallest=SMALL)[0] for name in shares]
    bars = axes.barh(range(len(values)), values, height=0.62, color=BLUE)
    axes.bar_label(bars, labels=[f"{value:.0f} %" for value in values], padding=4, color=INK)
    axes.set_yticks(range(len(values)), names)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.15 * max(values, default=1.0))
    axes.xaxis.set_visible(False)
    for side in ("top", "right", "bottom"):
        axes.spines[side].set_visible(False)
    heading(axes, f"What the interval of the {named} comes from", "parts of its variance")
    return figure
