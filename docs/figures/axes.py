"""The axis figure: origin, directions and signs that the whole package uses."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle

from figures.style import BLUE, GREEN, GREY, INK, RED, WOOD, draw_bat
from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body

ALPHA = "\N{GREEK SMALL LETTER ALPHA}"
HANDS, HIT = 15.24, 68.0
"""Places in cm of the hands and of the hit that the figure shows."""


def axes_figure() -> Figure:
    """Return the whole bat with its positions, speeds and signs, and the oblique contact beside it."""
    figure = Figure(figsize=(9, 7.2), layout="constrained")
    top, bottom = figure.subplots(2, 1, height_ratios=[1.45, 1])
    _whole_bat(top)
    _oblique(bottom)
    return figure


def _whole_bat(axes: Axes) -> None:
    bat = catalog.bat("r161-ash")
    length = 100 * bat.length
    balance = 100 * rigid_body(beam_model(bat)).balance_point
    draw_bat(axes, bat)
    axes.annotate("", (length + 9, 0), (0, 0), arrowprops={"arrowstyle": "-|>", "color": GREY, "linestyle": "--"})
    axes.text(length + 9.5, 0, "x", va="center", color=GREY, style="italic")
    axes.plot([0], [0], "o", color=INK, markersize=5, zorder=5)
    axes.text(-1.2, 0.2, "knob end\nx = 0", ha="right", va="center")
    axes.text(length + 1, -2.6, "tip", ha="left", va="center")

    for level, place, words in (
        (-6.4, HANDS, "top hand, 6 in"),
        (-9.0, balance, "balance point"),
        (-12.0, HIT, "position of the hit, x"),
        (-15.0, length, "length"),
    ):
        _measure(axes, 0.0, place, level, words)
    _measure(axes, HIT, length, -12.0, "tip distance")

    for place in np.linspace(12, length - 2, 9):
        _arrow(axes, (place, 3.8), (place, 3.8 + place / 12), BLUE, 0.9)
    axes.text(36, 8.6, "bat speed = ω (x \N{MINUS SIGN} pivot), > 0 toward the ball", color=BLUE, ha="center")
    axes.add_patch(Arc((0, 0), 13, 13, theta1=10, theta2=75, color=BLUE, linewidth=1.4))
    _arrow(axes, (2.6, 5.95), (1.4, 6.35), BLUE, 1.4)
    axes.text(-1.5, 7.6, "ω about the pivot\n(default: knob end)", color=BLUE, ha="right", va="center")

    axes.add_patch(Circle((HIT, 17.5), 3.7, facecolor="white", edgecolor=INK))
    _arrow(axes, (HIT - 1.6, 24.5), (HIT - 1.6, 14.8), RED, 1.8)
    axes.text(HIT - 5.0, 20.5, "ball speed, > 0\ntoward the bat", color=RED, ha="right", va="center")
    _arrow(axes, (HIT + 1.6, 14.8), (HIT + 1.6, 24.5), GREEN, 1.8)
    axes.text(HIT + 5.0, 20.5, "exit speed, > 0\naway from the bat", color=GREEN, ha="left", va="center")

    _arrow(axes, (HANDS, -5.6), (HANDS, -1.6), INK, 1.8)
    axes.text(HANDS + 1.5, -4.6, "hand impulse, > 0 in the direction of the swing", ha="left", va="center")
    axes.set(xlim=(-21, length + 14), ylim=(-17.5, 26), aspect="equal")
    axes.axis("off")


def _oblique(axes: Axes) -> None:
    """Draw the contact seen from the side, with the entry angle alpha and the travel along the bat."""
    alpha = np.radians(32)
    axes.fill_between([0, 30], -3, 0, color=WOOD)
    axes.plot([0, 30], [0, 0], color=INK, linewidth=0.9)
    axes.text(0.3, -2.2, "to the knob", va="center")
    axes.text(29.7, -2.2, "to the tip", va="center", ha="right")
    hit = np.array([11.0, 0.0])
    axes.plot([hit[0]] * 2, [0, 11.6], color=GREY, linestyle="--", linewidth=1)
    axes.text(hit[0] + 0.2, 11.6, "the bat's normal", color=GREY, va="top")
    start = hit + 11.2 * np.array([-np.sin(alpha), np.cos(alpha)])
    _arrow(axes, tuple(start), tuple(hit + 0.2), RED, 1.8)
    axes.text(start[0] - 0.4, start[1] - 0.2, "ball, speed v", color=RED, ha="right", va="top")
    axes.add_patch(Arc((11, 0), 11, 11, theta1=90, theta2=90 + 32, color=INK, linewidth=1.2))
    axes.text(9.35, 5.9, f"{ALPHA} > 0", ha="center")
    _arrow(axes, (11.0, 0.35), (15.0, 0.35), BLUE, 1.6)
    axes.text(15.2, 0.75, f"along the bat: v sin {ALPHA}, > 0 toward the tip", color=BLUE, va="center")
    _arrow(axes, (14.0, 7.5), (14.0, 3.3), BLUE, 1.6)
    axes.text(14.3, 5.4, f"across the bat: v cos {ALPHA}, the speed of the normal collision", color=BLUE, va="center")
    _measure(axes, 11.0, 13.0, -0.9, "")
    axes.text(13.2, -0.95, "S, displacement along the bat during contact", va="center")
    axes.set(xlim=(-1, 31), ylim=(-3.2, 12.2), aspect="equal")
    axes.axis("off")


def _arrow(axes: Axes, start: tuple[float, float], end: tuple[float, float], color: str, width: float) -> None:
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": width})


def _measure(axes: Axes, start: float, end: float, level: float, words: str) -> None:
    """Draw a dimension line between two positions with its name below it."""
    arrow = {"arrowstyle": "<->", "color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", (end, level), (start, level), arrowprops=arrow)
    axes.text((start + end) / 2, level + 0.3, words, ha="center", va="bottom", fontsize=9)
