"""The ball's force against compression, on a rigid wall, as the collision itself computes it."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from figures.style import BLUE, GREEN, RED, new_figure
from sweetspot import catalog
from sweetspot.collision.contact_law import unloading_exponent
from sweetspot.equipment.ball import Ball, damped_part, peak_compression
from sweetspot.units import MPH


def _on_a_wall(ball: Ball, turn: float, speed: float, power: float) -> tuple[np.ndarray, np.ndarray]:
    """Return compression, mm, and force, kN, between the turn (m) and the speed (m/s) that a ball comes or leaves with.

    At the rate v what is stored is (A(c speed) - A(c v)) m / c^2, in proportion to u^(power+1); see `damped_part`.
    """
    ends = ball.damping * speed
    rates = ends * (1 - np.linspace(0.0, 1.0, 200) ** (power + 1))
    stored = np.array([1 - damped_part(float(rate)) / damped_part(ends) for rate in rates])
    part = np.maximum(stored, 0.0) ** (1 / (power + 1))
    force = ball.stiffness * turn**ball.exponent * part**power * (1 + rates)
    return 1e3 * turn * part, force / 1e3


def force_figure() -> Figure:
    """Return loading and unloading at three speeds on a rigid wall."""
    ball = catalog.ball()
    figure, (plot,) = new_figure(7.0, 4.0)
    for speed, color in ((60 * MPH, BLUE), (95 * MPH, GREEN), (150 * MPH, RED)):
        restitution = ball.restitution.at(speed)
        turn = peak_compression(ball, speed)
        up = _on_a_wall(ball, turn, speed, ball.exponent)
        down = _on_a_wall(ball, turn, -restitution * speed, unloading_exponent(ball, turn))
        plot.plot(*up, color=color, label=f"{speed / MPH:.0f} mph: gives back e² = {restitution**2:.2f}")
        plot.plot(*down, color=color, linestyle="--")
    plot.set(xlabel="compression (mm)", ylabel="force (kN)", xlim=(0, None), ylim=(0, None))
    plot.legend(frameon=False, title="speed on a rigid wall (dashed: coming back)")
    plot.grid(alpha=0.3)
    return figure
