"""The best hit seen closely: force in time, force against compression, and where the energy went."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impact, Impacts
from sweetspot.equipment.sport import Terms
from sweetspot.reports.pictures.panels import Page, Panel, beside, double_arrow, frame, heading, second_scale, write
from sweetspot.reports.pictures.style import INK, LARGE, MUTED, NORMAL, halo, styled
from sweetspot.reports.quantities import BLUE, ENERGY_NAMES, GREEN, QUANTITIES, RED, US, Reader
from sweetspot.reports.sentences import Words, read
from sweetspot.units import INCH, POUND_FORCE

BASEBALL = Terms()
WIDTH, HEIGHT, TITLE = 8.5, 4.75, 0.4
"""Inches of paper; what a title takes."""


@styled
def hit_figure(impact: Impact, words: Terms = BASEBALL, title: Words = "", reading: Reader = US) -> Figure:
    """Return force against time, force against compression, and the energy ledger of one hit."""
    above = TITLE if title else 0.0
    page = Page(WIDTH, HEIGHT + above, 0.3)
    if title:
        page.title(read(title, reading), down=0.28, beside=0.4, size=LARGE)
    force_in_time(page.panel(0.35 + above, 1.85, left=0.8, width=3.55), impact)
    force_loop(page.panel(0.35 + above, 1.85, left=5.35, width=2.35), impact)
    energy_ledger(page.panel(2.95 + above, 1.65, left=2.3, width=5.4), impact, words)
    return page.figure


@styled
def force_in_time(axes: Axes, impact: Impact) -> None:
    """Draw the force between ball and bat in time: kN on the left, lbf on the right."""
    time, force = 1e3 * impact.times, impact.force / 1e3
    frame(axes, Panel("Force in time", x="ms after touch", y="kN", ticks=5, labelpad=2))
    axes.fill_between(time, 0, force, color=RED, alpha=0.12, linewidth=0)
    axes.plot(time, force, color=RED)
    axes.set(xlim=(0, 1.03 * float(time[-1])), ylim=(0, 1.22 * float(force.max())))
    second_scale(axes, 1 / POUND_FORCE, "1000 lbf")
    top = int(force.argmax())
    axes.plot(time[top], force[top], "o", color=RED, markersize=5)
    peak = f"peak {impact.peak_force / 1e3:.3g} kN"
    beside(axes, peak, (time[top], force[top]), (0, 6), ha="center", weight="bold")
    level, contact = 0.3 * float(force.max()), 1e3 * impact.contact_time
    double_arrow(axes, 0, contact, level, MUTED, width=0.9)
    axes.plot([contact, contact], [0, level], color=MUTED, linewidth=0.7, linestyle=(0, (2, 2)))
    look = {"ha": "center", "va": "bottom", "size": NORMAL, "path_effects": halo()}
    write(axes, contact / 2, level * 1.06, f"contact {contact:.2f} ms", **look)


@styled
def force_loop(axes: Axes, impact: Impact) -> None:
    """Draw the force against the ball's compression: the area inside the loop is what the ball turns to heat."""
    squeeze, force = 1e3 * impact.compression, impact.force / 1e3
    frame(axes, Panel("Force and compression", x="mm of compression of the ball", y="kN", ticks=5, labelpad=2))
    axes.fill(np.append(squeeze, 0.0), np.append(force, 0.0), color=MUTED, alpha=0.15, linewidth=0)
    axes.plot(np.append(squeeze, 0.0), np.append(force, 0.0), color=INK, linewidth=1.5)
    axes.set(xlim=(0, 1.08 * float(squeeze.max())), ylim=(0, 1.22 * float(force.max())))
    peak, corner = impact.peak_compression, (float(squeeze.max()), float(force.max()))
    beside(axes, f"{1e3 * peak:.2g} mm ({peak / INCH:.2f} in)", corner, (3, 6), ha="right", weight="bold")
    heat = f"shaded:\n{_joules(impact.energy.heat)} to heat"
    axes.text(0.04, 0.76, heat, va="top", size=NORMAL, transform=axes.transAxes)


@styled
def energy_ledger(axes: Axes, impact: Impact, words: Terms) -> None:
    """Draw where the incoming energy went as a waterfall, with J and per cent on every step."""
    energy = impact.energy
    parts = [(name, getattr(energy, name)) for name in ENERGY_NAMES if getattr(energy, name) > 0]
    heading(axes, "Where the energy goes", f"{_joules(energy.incoming)} come in")
    reached, digits, gap = 0.0, 1 if energy.incoming > 20 else 3, 0.012 * energy.incoming
    for row, (name, joules) in enumerate(parts):
        called, colour = ENERGY_NAMES[name]
        axes.barh(-row, joules, left=reached, height=0.62, color=colour)
        if row:
            axes.plot([reached, reached], [-row - 0.31, -row + 1.31], color=MUTED, linewidth=0.6)
        reached += joules
        called = called.format(**words.model_dump())
        axes.text(-0.015 * energy.incoming, -row, called, ha="right", va="center_baseline", clip_on=False)
        fits = reached < 0.76 * energy.incoming
        place, side = (reached + gap, "left") if fits else (reached - joules - gap, "right")
        label = f"{joules:.{digits}f} J   {100 * joules / energy.incoming:.1f} %"
        axes.text(place, -row, label, ha=side, va="center_baseline", weight="bold", path_effects=halo())
    axes.set(xlim=(0, energy.incoming * 1.005), ylim=(-len(parts) + 0.5, 0.6), xticks=[], yticks=[])
    axes.spines["bottom"].set_visible(False)


def _joules(energy: float) -> str:
    return f"{energy:.0f} J" if energy >= 10 else f"{energy:.2g} J"


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
        frame(axes, Panel(QUANTITIES[name].label.capitalize(), unit.name, ticks=4))
    panels[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
    panels[-1].set_xlabel("number of the hit, as they were asked for")
    return figure
