"""The best hit seen closely: force in time, force against compression, and where the energy went."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impact, Impacts
from sweetspot.equipment.sport import Terms
from sweetspot.reports.hit.ledger import ENERGY_NAMES
from sweetspot.reports.pictures.style import (
    INK,
    LARGE,
    MUTED,
    NORMAL,
    axes_in_inches,
    fitted,
    halo,
    heading,
    light_grid,
    styled,
)
from sweetspot.reports.quantities import BLUE, GREEN, QUANTITIES, RED, Reader
from sweetspot.units import INCH, POUND_FORCE

BASEBALL = Terms()
WIDTH, HEIGHT, TITLE = 8.5, 4.75, 0.4
"""Inches of paper; what a title takes."""


@styled
def hit_figure(impact: Impact, words: Terms = BASEBALL, title: str = "") -> Figure:
    """Return force against time, force against compression, and the energy ledger of one hit.

    Parameters
    ----------
    title : over it where it stands alone; "": none.
    """
    above = TITLE if title else 0.0
    figure = Figure(figsize=(WIDTH, HEIGHT + above))
    if title:
        text, size = fitted(title, width=WIDTH - 1.0, size=LARGE)
        figure.text(0.3 / WIDTH, 1 - 0.28 / (HEIGHT + above), text, weight="bold", size=size, parse_math=False)
    force_in_time(axes_in_inches(figure, left=0.8, top=0.35 + above, width=3.55, height=1.85), impact)
    force_loop(axes_in_inches(figure, left=5.35, top=0.35 + above, width=2.35, height=1.85), impact)
    energy_ledger(axes_in_inches(figure, left=2.3, top=2.95 + above, width=5.4, height=1.65), impact, words)
    return figure


@styled
def force_in_time(axes: Axes, impact: Impact) -> None:
    """Draw the force between ball and bat in time: kN on the left, lbf on the right."""
    time, force = 1e3 * impact.times, impact.force / 1e3
    heading(axes, "Force in time")
    light_grid(axes)
    axes.fill_between(time, 0, force, color=RED, alpha=0.12, linewidth=0)
    axes.plot(time, force, color=RED)
    axes.set_xlim(0, 1.03 * float(time[-1]))
    axes.set_ylim(0, 1.22 * float(force.max()))
    axes.yaxis.set_major_locator(MaxNLocator(nbins=5))
    axes.set_xlabel("ms after touch", labelpad=2)
    axes.set_ylabel("kN")
    second = axes.secondary_yaxis("right", functions=(_to_pounds, _from_pounds))
    second.spines["right"].set_visible(True)
    second.set_ylabel("1000 lbf")
    top = int(force.argmax())
    axes.plot(time[top], force[top], "o", color=RED, markersize=5)
    axes.annotate(
        f"peak {impact.peak_force / 1e3:.3g} kN", (time[top], force[top]), xytext=(0, 6), textcoords="offset points",
        ha="center", weight="bold",
    )  # fmt: skip
    level = 0.3 * float(force.max())
    contact = 1e3 * impact.contact_time
    axes.annotate(
        "", (0, level), (contact, level),
        arrowprops={"arrowstyle": "<->", "color": MUTED, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0,
                    "mutation_scale": 8},
    )  # fmt: skip
    axes.plot([contact, contact], [0, level], color=MUTED, linewidth=0.7, linestyle=(0, (2, 2)))
    axes.text(contact / 2, level * 1.06, f"contact {contact:.2f} ms", ha="center", va="bottom", size=NORMAL,
              path_effects=halo())  # fmt: skip


@styled
def force_loop(axes: Axes, impact: Impact) -> None:
    """Draw the force against the ball's compression: the area inside the loop is what the ball turns to heat."""
    squeeze, force = 1e3 * impact.compression, impact.force / 1e3
    heading(axes, "Force and compression")
    light_grid(axes)
    axes.fill(np.append(squeeze, 0.0), np.append(force, 0.0), color=MUTED, alpha=0.15, linewidth=0)
    axes.plot(np.append(squeeze, 0.0), np.append(force, 0.0), color=INK, linewidth=1.5)
    axes.set_xlim(0, 1.08 * float(squeeze.max()))
    axes.set_ylim(0, 1.22 * float(force.max()))
    axes.yaxis.set_major_locator(MaxNLocator(nbins=5))
    axes.set_xlabel("mm of compression of the ball", labelpad=2)
    axes.set_ylabel("kN")
    peak = impact.peak_compression
    axes.annotate(
        f"{1e3 * peak:.2g} mm ({peak / INCH:.2f} in)", (float(squeeze.max()), float(force.max())), xytext=(3, 6),
        textcoords="offset points", ha="right", weight="bold",
    )  # fmt: skip
    axes.text(0.04, 0.76, f"shaded:\n{_joules(impact.energy.heat)} to heat", va="top", size=NORMAL,
              transform=axes.transAxes)  # fmt: skip


@styled
def energy_ledger(axes: Axes, impact: Impact, words: Terms) -> None:
    """Draw where the incoming energy went as a waterfall, with J and per cent on every step."""
    energy = impact.energy
    parts = [(name, getattr(energy, name)) for name in ENERGY_NAMES if getattr(energy, name) > 0]
    heading(axes, "Where the energy goes", f"{_joules(energy.incoming)} come in")
    reached, digits = 0.0, 1 if energy.incoming > 20 else 3
    for row, (name, joules) in enumerate(parts):
        called, colour = ENERGY_NAMES[name]
        called = called.format(**words.model_dump())
        axes.barh(-row, joules, left=reached, height=0.62, color=colour)
        if row:
            axes.plot([reached, reached], [-row - 0.31, -row + 1.31], color=MUTED, linewidth=0.6)
        reached += joules
        axes.text(-0.015 * energy.incoming, -row, called, ha="right", va="center_baseline", clip_on=False)
        label = f"{joules:.{digits}f} J   {100 * joules / energy.incoming:.1f} %"
        fits = reached < 0.76 * energy.incoming
        place = reached + 0.012 * energy.incoming if fits else reached - joules - 0.012 * energy.incoming
        axes.text(
            place, -row, label, ha="left" if fits else "right", va="center_baseline", weight="bold",
            path_effects=halo(),
        )  # fmt: skip
    axes.set_xlim(0, energy.incoming * 1.005)
    axes.set_ylim(-len(parts) + 0.5, 0.6)
    axes.spines["bottom"].set_visible(False)
    axes.set_xticks([])
    axes.set_yticks([])


def _to_pounds(force: ArrayLike) -> ArrayLike:
    return np.asarray(force) / POUND_FORCE


def _from_pounds(force: ArrayLike) -> ArrayLike:
    return np.asarray(force) * POUND_FORCE


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
        axes.yaxis.set_major_locator(MaxNLocator(nbins=4))
        light_grid(axes)
        heading(axes, QUANTITIES[name].label.capitalize(), unit.name)
    panels[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
    panels[-1].set_xlabel("number of the hit, as they were asked for")
    return figure
