"""The seven meanings of "sweet spot" on one bat, the cost of a miss, and the bat's first modes."""

from __future__ import annotations

import numpy as np
from cases import analysed, from_tip
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figures.style import BLUE, GREEN, GREY, INK, RED, draw_bat, new_figure
from sweetspot.analysis.bat_analysis import Analysis, hit_at
from sweetspot.units import INCH, MPH

MEANINGS = (
    ("node_1", "node of mode 1", BLUE),
    ("node_2", "node of mode 2", BLUE),
    ("center_of_percussion", "center of percussion", GREEN),
    ("max_collision_efficiency", "greatest efficiency q", RED),
    ("max_exit_speed", "greatest exit speed", RED),
    ("min_sting", "least sting", GREEN),
)


def sweet_spots_figure() -> Figure:
    """Return the barrel with every meaning marked, and exit speed and sting along it."""
    analysis = analysed()
    figure, (bat, speed, sting) = new_figure(8.5, 7.4, rows=3, height_ratios=[1.5, 1.3, 1], sharex=True)
    _marked_barrel(bat, analysis)
    along = analysis.scan
    places = from_tip(analysis, along.position)
    speed.plot(places, along.exit_speed / MPH, color=RED, label="this bat")
    speed.plot(places, along.rigid_exit_speed / MPH, color=GREY, linestyle="--", label="if it could not bend")
    speed.set_ylabel("exit speed (mph)")
    speed.set_ylim(45, 108)
    speed.legend(loc="lower left", frameon=False)
    sting.plot(places, along.sting, color=GREEN)
    sting.set_ylabel("sting at the hands (m/s)")
    sting.set_ylim(0, None)
    sting.set_xlabel("distance from the tip (in)")
    sting.set_xlim(14, 0)
    for axes in (speed, sting):
        _zone(axes, analysis)
        axes.grid(alpha=0.3)
    return figure


def _zone(axes: Axes, analysis: Analysis) -> None:
    zone = analysis.sweet_spots.zone
    if zone is not None:
        axes.axvspan(from_tip(analysis, zone[0]), from_tip(analysis, zone[1]), color="#f2d24b", alpha=0.35, linewidth=0)


def _marked_barrel(axes: Axes, analysis: Analysis) -> None:
    """Draw the barrel with one labeled line per meaning, sorted so that labels do not cross."""
    bat, spots = analysis.bat, analysis.sweet_spots
    places = np.linspace(bat.length - 14 * INCH, bat.length, 200)
    half = bat.diameter_at(places) / 2 / INCH
    x = from_tip(analysis, places)
    axes.fill_between(x, -half, half, color="#e8cfa6")
    axes.plot(x, half, color=INK, linewidth=0.8)
    axes.plot(x, -half, color=INK, linewidth=0.8)
    _zone(axes, analysis)
    marks = [(from_tip(analysis, getattr(spots, key)), words, color) for key, words, color in MEANINGS]
    marks.sort(reverse=True)
    for index, (place, words, color) in enumerate(marks):
        left = index < len(marks) / 2
        height = 1.75 + 0.62 * (index if left else len(marks) - 1 - index)
        axes.plot([place, place], [-1.3, height], color=color, linewidth=1.2)
        side, shift = ("right", 0.08) if left else ("left", -0.08)
        axes.text(place + shift, height, f"{words}, {place:.1f} in", ha=side, va="center", color=color, fontsize=9)
    if spots.zone is not None:
        start, end = (from_tip(analysis, place) for place in spots.zone)
        words = f"sweet zone, {start:.1f} to {end:.1f} in"
        axes.text((start + end) / 2, -1.75, words, ha="center", va="center", fontsize=9)
    axes.set_ylim(-2.2, 3.6)
    axes.axis("off")


def modes_figure() -> Figure:
    """Return the first three bending shapes of the flagship bat with their nodes."""
    analysis = analysed()
    figure, axes = new_figure(8.5, 5.2, rows=3, sharex=True)
    places = np.linspace(0, analysis.bat.length, 400)
    for harmonic, plot in enumerate(axes, start=1):
        index = analysis.modes.of_family("bending")[harmonic - 1]
        shape = analysis.modes.shape_at(places)[:, index]
        draw_bat(plot, analysis.bat, scale=1 / INCH, stretch=0.35)
        plot.plot(places / INCH, shape / np.abs(shape).max(), color=BLUE)
        nodes = analysis.modes.nodes(index)
        plot.plot(nodes / INCH, np.zeros_like(nodes), "o", color=RED, markersize=5)
        plot.set_title(f"bending mode {harmonic}: {analysis.modes.frequency[index]:.0f} Hz", loc="left", fontsize=10)
        plot.set_yticks([])
        plot.set_ylim(-1.15, 1.15)
    axes[-1].set_xlabel("position from the knob end (in)")
    return figure


def ledger_figure() -> Figure:
    """Return where the ball's energy goes for hits along the barrel."""
    analysis = analysed()
    distances = np.linspace(13, 0.25, 35)
    ledgers = [
        hit_at(analysis.bat.length - inches * INCH, modes=analysis.modes, conditions=analysis.conditions).energy
        for inches in distances
    ]
    parts = {
        "heat in the ball": [hit.heat for hit in ledgers],
        "ball leaving": [hit.ball for hit in ledgers],
        "bat, translation": [hit.translation for hit in ledgers],
        "bat, rotation": [hit.rotation for hit in ledgers],
        "bat, vibration": [hit.bending for hit in ledgers],
        "damped in the bat": [hit.damping for hit in ledgers],
    }
    incoming = np.array([hit.incoming for hit in ledgers])
    figure, (plot,) = new_figure(8.5, 4.0)
    shares = [100 * np.array(values) / incoming for values in parts.values()]
    colors = ["#c9b8a8", RED, BLUE, "#7fb0d8", GREEN, "#9fcbb0"]
    plot.stackplot(distances, *shares, labels=list(parts), colors=colors)
    plot.set(xlim=(13, 0.25), ylim=(0, 100), xlabel="distance from the tip (in)", ylabel="share of the energy (%)")
    plot.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False, reverse=True)
    return figure
