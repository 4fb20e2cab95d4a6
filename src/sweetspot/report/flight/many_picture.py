"""Many flights in one picture: where they come down, and how far."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.flight.kernel import Flights
from sweetspot.report.flight.park_picture import draw_field
from sweetspot.report.pictures.style import MUTED, heading, light_grid, styled
from sweetspot.report.quantities import BLUE, RED, Reader
from sweetspot.units import FOOT

MOST_BARS = 30
LEAST = 440 * FOOT
"""m of the field that are drawn at least, straight out."""


@styled
def flights_figure(flown: Flights, reading: Reader) -> Figure:
    """Return where the balls come down, from above, with their paths where they were asked for, and their carries."""
    figure = Figure(figsize=(8.0, 4.2), layout="constrained")
    above, far = figure.subplots(1, 2, width_ratios=(1.25, 1))
    _above(above, flown, reading)
    unit = reading.units["distance"]
    carries = flown.carry[flown.landed] / unit.size
    far.hist(carries, bins=min(MOST_BARS, max(5, round(2 * len(carries) ** 0.5))), color=BLUE)
    far.set(xlabel=f"carry ({unit.name})", ylabel="balls")
    far.yaxis.get_major_locator().set_params(integer=True)
    light_grid(far, vertical=False)
    heading(far, "How far they carry")
    return figure


def _above(axes: Axes, flown: Flights, reading: Reader) -> None:
    """Draw every ball that came down over the field."""
    draw_field(axes, reading)
    size = reading.units["distance"].size
    spots = flown.landing_position[flown.landed, :2] / size
    thin = float(np.clip(12 / max(len(spots), 1), 0.08, 0.6))
    for path in flown.positions[flown.landed, :, :2] / size:
        axes.plot(*path.T, color=MUTED, linewidth=0.7, alpha=thin)
    axes.plot(*spots.T, "o", color=RED, markersize=3, markeredgewidth=0, alpha=max(thin, 0.3))
    out = max(LEAST / size, 1.05 * float(spots[:, 1].max()))
    aside = max(0.7 * LEAST / size, 1.05 * float(np.abs(spots[:, 0]).max()))
    axes.set(xlim=(-aside, aside), ylim=(min(-0.02 * out, 1.05 * float(spots[:, 1].min())), out))
    heading(axes, "Where they come down", "from above")
