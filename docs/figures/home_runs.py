"""Home runs as probabilities: predicted against observed."""

from __future__ import annotations

from matplotlib.figure import Figure

from figures.style import BLUE, GREY, INK, new_figure

BANDS = (
    (844, 0.001, 0.007), (65, 0.054, 0.031), (53, 0.157, 0.113), (48, 0.375, 0.354), (23, 0.630, 0.739),
    (30, 0.809, 0.833), (22, 0.947, 1.000), (79, 0.997, 0.962),
)  # fmt: skip
"""Balls in a band of chances, their mean chance, the part that were home runs: by tests/flight/test_flight_data.py."""


def calibration_figure() -> Figure:
    """Return the fraction of balls that were home runs against the predicted probability, with standard errors."""
    figure, (plot,) = new_figure(5.0, 4.4)
    plot.plot([0, 1], [0, 1], color=GREY, linewidth=1, label="perfect calibration")
    for count, chance, hit in BANDS:
        error = (max(chance * (1 - chance), 1 / count) / count) ** 0.5
        plot.errorbar(chance, hit, yerr=error, fmt="o", color=BLUE, ecolor=INK, capsize=2, markersize=3 + count**0.3)
    plot.set(xlabel="predicted probability of a home run", ylabel="observed fraction of home runs", xlim=(-0.03, 1.03))
    plot.grid(alpha=0.3)
    return figure
