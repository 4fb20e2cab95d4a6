"""Home runs as probabilities: what was told against what was hit."""

from __future__ import annotations

from matplotlib.figure import Figure

from figures.style import BLUE, GREY, INK, new_figure

BANDS = (
    (831, 0.001, 0.006), (68, 0.049, 0.059), (51, 0.167, 0.098), (51, 0.351, 0.314), (32, 0.631, 0.688),
    (28, 0.826, 0.821), (23, 0.951, 0.826), (80, 0.997, 0.963),
)  # fmt: skip
"""Balls in a band of chances, their mean chance, the part that were home runs: from tools/fit_aerodynamics.py."""


def calibration_figure() -> Figure:
    """Return the part of balls that were home runs against the chance they were given, with standard errors."""
    figure, (plot,) = new_figure(5.0, 4.4)
    plot.plot([0, 1], [0, 1], color=GREY, linewidth=1, label="as told")
    for count, told, hit in BANDS:
        error = (max(told * (1 - told), 1 / count) / count) ** 0.5
        plot.errorbar(told, hit, yerr=error, fmt="o", color=BLUE, ecolor=INK, capsize=2, markersize=3 + count**0.3)
    plot.set(xlabel="chance of a home run, told", ylabel="part that were home runs", xlim=(-0.03, 1.03))
    plot.grid(alpha=0.3)
    return figure
