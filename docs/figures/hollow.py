"""Hoop frequency, BBCOR and energy of an aluminum barrel against wall thickness."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from figures.style import BLUE, GREEN, RED, new_figure
from sweetspot import catalog, standard_conditions
from sweetspot.analysis.trampoline import wall_sweep

BAT = "russell-b6"
FACTORS = tuple(np.linspace(0.55, 2.0, 16))


def wall_figure() -> Figure:
    """Return hoop frequency, BBCOR and the wall's energy against wall thickness at the best place."""
    bat = catalog.bat(BAT)
    points = wall_sweep(bat, standard_conditions(bat), factors=FACTORS)
    thickness = [1e3 * point.thickness for point in points]
    incoming = [point.energy.stored / point.energy.share for point in points]
    figure, plots = new_figure(7.0, 7.5, rows=3)
    curves = (
        ("hoop frequency (kHz)", [point.hoop_frequency / 1e3 for point in points], BLUE),
        ("BBCOR at best", [point.bbcor for point in points], RED),
    )
    for plot, (label, values, color) in zip(plots, curves, strict=False):
        plot.plot(thickness, values, color=color, marker=".")
        plot.set(ylabel=label)
    stored = [100 * point.energy.share for point in points]
    remaining = [100 * point.energy.left / whole for point, whole in zip(points, incoming, strict=True)]
    plots[2].plot(thickness, stored, color=GREEN, marker=".", label="greatest energy in the wall")
    plots[2].plot(thickness, remaining, color=RED, marker=".", label="left in the wall after release")
    plots[2].set(ylabel="energy (% of the ball's)", xlabel="wall thickness (mm)")
    plots[2].legend(frameon=False)
    for plot in plots:
        plot.set(ylim=(0 if plot is not plots[1] else None, None))
        plot.grid(alpha=0.3)
    return figure
