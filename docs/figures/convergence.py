"""Convergence of the answers with finer meshes, shorter time steps and more modes."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from figures.style import BLUE, GREEN, GREY, INK, RED, new_figure
from sweetspot import beam_model, bending_modes, catalog, hits
from sweetspot.collision import coupled, kernel
from sweetspot.collision.coupled import hit
from sweetspot.dynamics.batch.mesh import ELEMENTS, MODES
from sweetspot.dynamics.modes import Modes
from sweetspot.units import INCH

Array = NDArray[np.float64]

BAT, SMOOTH = "r161-ash", "textbook"
ROUNDING = 1e-8
"""Relative error below which rounding, not the mesh, is seen."""
PITCH = 40.0
CLOSING = 71.0
"""m/s of the pitch and of closing, about the standard hit's on the barrel."""
MICRO = 1e-6


def mesh_convergence() -> Figure:
    """Return the error of four frequencies against the number of elements, with the default marked.

    A turned outline's error falls in stairs: its steepest pieces decide, and they are split last. The smooth outline
    shows the order, twice the degree of the elements' rotation.
    """
    figure, (plot,) = new_figure(7.0, 4.6)
    for name, asked, style in (
        (BAT, (1, 16, 20, 24, 32, 48, 64, 80), "o-"),
        (SMOOTH, (5, 6, 8, 12, 16, 24, 32), ".--"),
    ):
        beam = beam_model(catalog.bat(name))
        converged = bending_modes(beam, elements=128).frequency[2:]
        meshes = [bending_modes(beam, elements=elements) for elements in asked]
        counts = np.array([len(modes.shapes.ends) - 1 for modes in meshes])
        for mode, color in ((1, BLUE), (3, GREEN), (5, GREY), (12, RED)):
            errors = np.array([abs(modes.frequency[mode + 1] / converged[mode - 1] - 1) for modes in meshes])
            resolved = errors > ROUNDING
            label = f"mode {mode}" if name == BAT else None
            plot.loglog(counts[resolved], errors[resolved], style, color=color, linewidth=1, markersize=4, label=label)
        if name == BAT:
            _mark(plot, counts[1], f"default: at least {ELEMENTS}, here {counts[1]}")
    _guide(plot, np.array([8.0, 32.0]), 2e-4, -6, "order 6")
    plot.set(xlabel="elements", ylabel="relative error of the frequency", ylim=(1e-8, 0.1))
    ticks = [5, 10, 20, 40, 80]
    plot.set_xticks(ticks, [str(tick) for tick in ticks])
    plot.set_xticks([], minor=True)
    plot.legend(frameon=False, loc="upper right", title=f"{BAT}; dashed: {SMOOTH}")
    plot.grid(alpha=0.3)
    return figure


def step_convergence() -> Figure:
    """Return the errors of exit speed and ledger against the time step, with both default steps marked."""
    modes, ball = bending_modes(beam_model(catalog.bat(BAT))), catalog.ball()
    places = np.linspace(0.60, 0.82, 200)
    steps = np.array([0.5, 1, 2, 4, 6, 8, 10, 14, 20, 28]) * MICRO
    converged = _exit_speeds(modes, places, 0.05 * MICRO)
    worst, typical = [], []
    for step in steps:
        errors = np.abs(_exit_speeds(modes, places, step) / converged - 1)
        worst.append(errors.max())
        typical.append(np.sqrt(np.mean(errors**2)))
    ledger_steps = steps[1:]
    gaps = [
        np.sqrt(np.mean([
            hit(modes, ball=ball, position=place, closing_speed=CLOSING, step=step).energy.imbalance ** 2
            for place in (0.60, 0.66, 0.72, 0.78, 0.82)
        ]))
        for step in ledger_steps
    ]  # fmt: skip
    figure, (plot,) = new_figure(7.0, 4.6)
    plot.loglog(steps / MICRO, worst, "o-", color=RED, markersize=3, label="exit speed, worst of 200 places")
    plot.loglog(steps / MICRO, typical, "o-", color=BLUE, markersize=3, label="exit speed, root mean square")
    plot.loglog(ledger_steps / MICRO, gaps, "o-", color=GREEN, markersize=3, label="energy ledger's gap")
    _guide(plot, np.array([1.0, 4.0]), 3e-6, 2, "order 2")
    _guide(plot, np.array([1.0, 4.0]), 1e-9, 3, "order 3")
    for step, name in ((coupled.STEP, "readable"), (kernel.STEP, "kernel")):
        _mark(plot, step / MICRO, f"{name}, {step / MICRO:g} µs")
    plot.set(xlabel="time step (µs)", ylabel="relative error")
    ticks = [0.5, 1, 2, 5, 10, 20]
    plot.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    plot.legend(frameon=False)
    plot.grid(alpha=0.3)
    return figure


def mode_count_convergence() -> Figure:
    """Return the exit speed with 0 to 30 bending modes at several places, against the one with 30."""
    bat = catalog.bat(BAT)
    most = 30
    modes = bending_modes(beam_model(bat), count=most, elements=40)
    from_tip = np.array([2.0, 4.0, 6.0, 8.0, 10.0])
    places = bat.length - from_tip * INCH
    counts = np.array([0, 1, 2, 3, 4, 6, 8, 10, 12, 16, 20, 25, 30])
    speeds = np.array(
        [_exit_speeds(modes.selected(list(range(2 + int(count)))), places, 2 * MICRO) for count in counts]
    )
    figure, (whole, close) = new_figure(7.0, 6.0, 2, sharex=True)
    for column, inches in enumerate(from_tip):
        whole.plot(counts, speeds[:, column], "o-", markersize=3, label=f"{inches:g} in from the tip")
        close.plot(counts, 100 * (speeds[:, column] / speeds[-1, column] - 1), "o-", markersize=3)
    for plot in (whole, close):
        plot.axvline(MODES, color=INK, linewidth=0.8, linestyle=":")
        plot.grid(alpha=0.3)
    whole.set(ylabel="exit speed (m/s)")
    whole.legend(frameon=False, ncols=2)
    close.set(xlabel="bending modes", ylabel=f"against {most} modes (%)", ylim=(-1.5, 1.5))
    close.annotate(f"default: {MODES}", (MODES, 1.2), xytext=(4, 0), textcoords="offset points")
    return figure


def _exit_speeds(modes: Modes, places: Array, step: float) -> Array:
    impacts = hits(modes, ball=catalog.ball(), position=places, closing_speed=CLOSING, step=step)
    q = impacts.collision_efficiency
    return q * PITCH + (1 + q) * (CLOSING - PITCH)


def _guide(plot: Axes, ends: Array, start: float, power: float, text: str) -> None:
    """Draw the slope of an order of convergence."""
    plot.loglog(ends, start * (ends / ends[0]) ** power, color=INK, linewidth=0.8, linestyle=":")
    plot.annotate(text, (ends[0], start), ha="right", va="center", xytext=(-4, 0), textcoords="offset points")


def _mark(plot: Axes, place: float, text: str) -> None:
    """Mark a default on the x axis."""
    plot.axvline(place, color=INK, linewidth=0.8, linestyle=":")
    plot.annotate(text, (place, 0.02), xycoords=("data", "axes fraction"), xytext=(4, 0), textcoords="offset points")
