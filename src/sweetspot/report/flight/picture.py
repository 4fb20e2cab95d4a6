"""A flight from the side and from above, with the fence of a park."""

from __future__ import annotations

from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.flight.fence import landing
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import Flight
from sweetspot.report.flight.park_picture import draw_fence, draw_field
from sweetspot.report.pictures.style import INK, LARGE, MUTED, SMALL, halo, heading, light_grid, styled
from sweetspot.report.quantities import GREEN, RED, US, Reader
from sweetspot.units import FOOT

SMALL_FIELD = 260 * FOOT
"""m to the fence in centre field; youth fields are smaller."""
MARKS = 1.0
"""s between the dots on a path."""


@styled
def flight_figure(flight: Flight, park: Park | None = None, reading: Reader = US) -> Figure:
    """Return a flight from the side and from above."""
    figure = Figure(figsize=(8.0, 6.6), layout="constrained")
    side, above = figure.subplots(2, 1, height_ratios=(1, 2.4))
    draw_side(side, flight, park, reading)
    draw_above(above, flight, park, reading)
    launch = flight.launch
    words = f"{reading.shown(launch.speed, 'speed')}, {reading.shown(launch.launch_angle, 'angle', digits=0)} up"
    words += f": {reading.shown(flight.carry, 'distance')} in {reading.shown(flight.hang_time, 'time')}"
    figure.suptitle(words, x=0.02, ha="left", weight="bold", size=LARGE)
    return figure


def draw_side(axes: Axes, flight: Flight, park: Park | None = None, reading: Reader = US) -> None:
    """Draw height against distance over the ground, to scale, with the fence where the ball passes it."""
    unit, foot = reading.units["distance"].size, FOOT / reading.units["distance"].size
    shown = partial(reading.shown, scale="distance")
    right, out, up = flight.positions.T / unit
    over_ground = np.hypot(right, out)
    axes.plot(over_ground, up, color=RED)
    dots = np.arange(0, flight.times[-1], MARKS)
    axes.plot(np.interp(dots, flight.times, over_ground), np.interp(dots, flight.times, up), "o", color=RED, ms=3)
    top = int(np.argmax(up))
    if top > 0:  # a ball that is hit down is highest where it is hit
        axes.annotate(
            f"{shown(flight.apex_height)} after {reading.shown(flight.apex_time, 'time')}", (over_ground[top], up[top]),
            xytext=(0, 5), textcoords="offset points", ha="center", size=SMALL, color=MUTED, path_effects=halo(),
        )  # fmt: skip
    if park is not None and (met := landing(flight.positions, park)).outcome != "foul":
        distance, height = park.distance_at(met.direction), park.height_at(met.direction)
        over = bool(over_ground[-1] > distance / unit)  # the ball comes down where the label would stand
        axes.plot(
            [distance / unit, distance / unit], [0, height / unit], color=GREEN, linewidth=3, solid_capstyle="butt"
        )
        axes.annotate(
            f"{shown(distance)},\n{shown(height)} high", (distance / unit, height / unit),
            xytext=(-5 if over else 5, 2), textcoords="offset points", size=SMALL, color=GREEN,
            ha="right" if over else "left", va="bottom" if over else "center", path_effects=halo(),
        )  # fmt: skip
    axes.axhline(0, color=INK, linewidth=0.8)
    heading(axes, "From the side", "to scale; a dot every second")
    axes.set(
        xlabel=f"distance over the ground ({reading.unit('distance')})",
        ylabel=f"height ({reading.unit('distance')})",
        aspect="equal",
    )
    axes.set_ylim(0, max(60.0 * foot, 1.15 * float(up.max())))
    axes.set_xlim(right=max(150.0 * foot, 1.14 * float(over_ground.max()), axes.get_xlim()[1]))
    light_grid(axes)


def draw_above(axes: Axes, flight: Flight, park: Park | None = None, reading: Reader = US) -> None:
    """Draw the path over the field, with the park's fence."""
    small = park is not None and park.distance_at(0.0) < SMALL_FIELD
    draw_field(axes, reading, small=small)
    if park is not None:
        draw_fence(axes, park, colour=GREEN, thick=True, reading=reading)
    unit, foot = reading.units["distance"].size, FOOT / reading.units["distance"].size
    right, out, _ = flight.positions.T / unit
    axes.plot(right, out, color=RED)
    reach = max((190.0 if small else 310.0) * foot, 1.1 * float(np.abs(right).max()))
    axes.set(
        xlim=(-reach, reach),
        ylim=(
            min(-10.0 * foot, float(out.min()) - 20 * foot),
            max((270.0 if small else 440.0) * foot, 1.08 * float(out.max())),
        ),
    )
    dots = np.arange(0, flight.times[-1], MARKS)
    axes.plot(np.interp(dots, flight.times, right), np.interp(dots, flight.times, out), "o", color=RED, ms=3)
    axes.plot(right[-1], out[-1], "x", color=RED, ms=7)
    axes.annotate(
        reading.shown(flight.carry, "distance"), (right[-1], out[-1]), xytext=(6, 2), textcoords="offset points",
        color=RED, weight="bold", path_effects=halo(),
    )  # fmt: skip
    heading(axes, "From above", park.name if park is not None else "no park")
