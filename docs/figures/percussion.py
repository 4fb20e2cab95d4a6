"""The paper's equation 9: the force of the hands, for the paper's rod and for a real bat."""

from __future__ import annotations

import numpy as np
from cases import analysed
from matplotlib.figure import Figure

from figures.style import GREY, INK, RED, new_figure
from sweetspot.dynamics.rigid import centre_of_percussion
from sweetspot.papers import formulas as paper
from sweetspot.units import INCH


def hand_force_figure() -> Figure:
    """Return hand force over blow along the paper's rod and along the flagship bat, both held at the same place."""
    analysis = analysed()
    hands, length = analysis.conditions.hands.position, analysis.bat.length
    rod = paper.rod(length, analysis.body.mass)
    places = np.linspace(hands, length, 200)
    figure, (plot,) = new_figure(7.5, 3.8)
    for body, words, color in ((rod, "the paper's uniform rod", GREY), (analysis.body, "R161, white ash", RED)):
        ratio = [paper.hand_force_ratio(body, place, hands=hands) for place in places]
        place = centre_of_percussion(body, pivot=hands)
        label = f"{words}: zero at {(length - place) / INCH:.1f} in from the tip"
        plot.plot(places / INCH, ratio, color=color, label=label)
        plot.plot([place / INCH], [0], "o", color=color)
    plot.axhline(0, color=INK, linewidth=0.8)
    plot.set(xlabel="place of the blow, from the knob end (in)", ylabel="hand force / force of the blow")
    plot.legend(frameon=False)
    plot.grid(alpha=0.3)
    return figure
