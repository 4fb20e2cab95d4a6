"""The ball's force against compression, on a rigid wall, as the collision itself computes it."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from figures.style import BLUE, GREEN, RED, new_figure
from sweetspot import catalog
from sweetspot.collision.contact_law import Hysteretic, equivalent_wall_speed
from sweetspot.units import MPH


def force_figure() -> Figure:
    """Return loading and unloading at three speeds on a rigid wall."""
    ball = catalog.ball()
    law = Hysteretic(ball)
    figure, (plot,) = new_figure(7.0, 4.0)
    for speed, color in ((60 * MPH, BLUE), (95 * MPH, GREEN), (150 * MPH, RED)):
        peak = (speed / equivalent_wall_speed(ball, 1.0)) ** (2 / (ball.exponent + 1))
        path = np.linspace(1e-6, peak, 200)
        up = [law.force_and_slope(u, 1.0, None)[0] / 1e3 for u in path]
        down = [law.force_and_slope(u, -1.0, peak)[0] / 1e3 for u in path[:-1]]
        restitution = ball.restitution.at(speed)
        plot.plot(1e3 * path, up, color=color, label=f"{speed / MPH:.0f} mph: gives back e² = {restitution**2:.2f}")
        plot.plot(1e3 * path[:-1], down, color=color, linestyle="--")
    plot.set(xlabel="compression (mm)", ylabel="force (kN)", xlim=(0, None), ylim=(0, None))
    plot.legend(frameon=False, title="speed on a rigid wall (dashed: coming back)")
    plot.grid(alpha=0.3)
    return figure
