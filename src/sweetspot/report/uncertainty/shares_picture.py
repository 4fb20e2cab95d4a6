"""What an interval comes from, as ranked bars."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure

from sweetspot.report.pictures.style import INK, heading, styled
from sweetspot.report.quantities import BLUE

BAR, AROUND = 0.34, 0.75
"""Inches of the figure's height per bar, and of the rest."""


@styled
def shares_figure(shares: Mapping[str, float], named: str) -> Figure:
    """Return a figure of ranked bars: the part of the variance of an answer that each source causes alone.

    Parameters
    ----------
    shares : by the name of the source, the greatest first.
    named : what people call the answer.
    """
    figure = Figure(figsize=(8.0, AROUND + BAR * max(len(shares), 1)), layout="constrained")
    axes = figure.subplots()
    values = [100 * share for share in shares.values()]
    bars = axes.barh(list(shares), values, height=0.62, color=BLUE)
    axes.bar_label(bars, labels=[f"{value:.0f} %" for value in values], padding=4, color=INK)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.15 * max(values, default=1.0))
    axes.xaxis.set_visible(False)
    for side in ("top", "right", "bottom"):
        axes.spines[side].set_visible(False)
    heading(axes, f"What the interval of the {named} comes from", "parts of its variance")
    return figure
