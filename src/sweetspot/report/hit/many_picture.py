"""Many hits in one picture: efficiency, contact time and force, hit by hit."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impacts
from sweetspot.report.pictures.style import heading, light_grid, styled
from sweetspot.report.quantities import BLUE, GREEN, QUANTITIES, RED, Reader

PANELS = (("collision_efficiency", GREEN), ("contact_time", BLUE), ("peak_force", RED))
FEW = 60
"""Hits up to which each has a dot."""


@styled
def impacts_figure(hits: Impacts | Strikes, reading: Reader) -> Figure:
    """Return collision efficiency, contact time and peak force of every hit, by its number."""
    figure = Figure(figsize=(8.0, 5.2), layout="constrained")
    number = np.arange(1, hits.outcome.size + 1)
    panels = figure.subplots(len(PANELS), 1, sharex=True)
    for axes, (name, colour) in zip(panels, PANELS, strict=True):
        unit = reading.units[QUANTITIES[name].scale]
        values = getattr(hits, name).ravel() / unit.size
        axes.plot(number, values, color=colour, marker="o" if len(number) <= FEW else "", markersize=3.5)
        axes.yaxis.set_major_locator(MaxNLocator(nbins=4))
        light_grid(axes)
        heading(axes, QUANTITIES[name].label.capitalize(), unit.name)
    panels[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
    panels[-1].set_xlabel("number of the hit, as they were asked for")
    return figure
