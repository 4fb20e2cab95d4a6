"""A flight from the side and from above, with the fence of a park."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from sweetspot.answers.flight import carry_from_the_hit
from sweetspot.flight.fence import landing
from sweetspot.flight.kernel import Flights
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.flight.trajectory import Flight
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.panels import SPARSE, Panel, beside, frame, heading
from sweetspot.reports.pictures.style import INK, LARGE, MUTED, SMALL, halo, styled
from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, SKY, US, Reader
from sweetspot.reports.sentences import Words, read
from sweetspot.units import FOOT

LEAST = (150 * FOOT, 60 * FOOT)
"""m of a ballpark that are drawn at least, along and up."""
SMALL_FIELD = 260 * FOOT
"""m to the fence in centre field; youth fields are smaller."""
MARKS = 1.0
"""s between the dots on a path."""
LINE = 125
"""Letters of small print in a line."""


@styled
def flight_figure(
    flight: Flight, park: Park | None = None, reading: Reader = US, *, ballpark: bool = True, note: Words = ""
) -> Figure:
    """Return a flight from the side and from above.

    Parameters
    ----------
    note : below the title: the air, and what came of it.
    ballpark : whether it is seen over a field with bases, as baseball's and softball's are, or along its own way.
    """
    figure = Figure(figsize=(8.0, 6.6 if ballpark else 4.4), layout="constrained")
    lines = textwrap.wrap(read(note, reading), LINE)
    above = (0.35 + 0.15 * len(lines)) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - above))  # type: ignore[union-attr, call-arg]
    if not ballpark:
        flight = _from_the_hit(flight)
    side, above = figure.subplots(2, 1, height_ratios=(1, 2.4 if ballpark else 1))
    draw_side(side, flight, park, reading, least=LEAST if ballpark else (0.0, 0.0))
    if ballpark:
        draw_above(above, flight, park, reading)
    else:
        draw_along(above, flight, reading)
    launch = flight.launch
    angle = reading.shown(abs(launch.launch_angle), "angle", digits=0)
    words = f"{reading.shown(launch.speed, 'speed')}, {angle} {'up' if launch.launch_angle >= 0 else 'down'}"
    words += f": {reading.shown(flight.carry, 'distance')} in {reading.shown(flight.hang_time, 'time')}"
    tall = figure.get_figheight()
    figure.text(0.02, 1 - 0.24 / tall, words, weight="bold", size=LARGE)
    figure.text(0.02, 1 - 0.34 / tall, "\n".join(lines), color=MUTED, size=SMALL, va="top", parse_math=False)
    return figure


def _from_the_hit(flight: Flight) -> Flight:
    """Return a flight whose way over the ground begins at 0, where no home plate is to count from."""
    there = flight.launch.position * np.array([1.0, 1.0, 0.0])
    return replace(flight, positions=flight.positions - there, carry=carry_from_the_hit(flight))


def draw_side(
    axes: Axes, flight: Flight, park: Park | None = None, reading: Reader = US, *, least: tuple[float, float] = LEAST
) -> None:
    """Draw height against distance over the ground, to scale, with the fence where the ball passes it.

    Parameters
    ----------
    least : m along and up that are drawn at least.
    """
    unit = reading.units["distance"].size
    text = partial(reading.shown, scale="distance")
    right, out, up = flight.positions.T / unit
    over_ground = np.hypot(right, out)
    axes.plot(over_ground, up, color=RED)
    dots = np.arange(0, flight.times[-1], MARKS)
    axes.plot(np.interp(dots, flight.times, over_ground), np.interp(dots, flight.times, up), "o", color=RED, ms=3)
    top = int(np.argmax(up))
    if top > 0:  # a ball that is hit down is highest where it is hit
        apex = f"{text(flight.apex_height)} after {reading.shown(flight.apex_time, 'time')}"
        look = {"ha": "center", "size": SMALL, "color": MUTED, "path_effects": halo()}
        beside(axes, apex, (over_ground[top], up[top]), (0, 5), **look)
    if park is not None and (arrival := landing(flight.positions, park)).outcome != "foul":
        distance, height = park.distance_at(arrival.direction), park.height_at(arrival.direction)
        place, wall = distance / unit, height / unit
        there = max(wall, float(np.interp(place, over_ground, up, right=0.0)))
        axes.plot([place, place], [0, wall], color=GREEN, linewidth=3, solid_capstyle="butt")
        # the label stands above the path, on the side where that is lower
        aside, side = (-3, "right") if place < over_ground[top] else (3, "left")
        look = {"ha": side, "va": "bottom", "size": SMALL, "color": GREEN, "path_effects": halo()}
        beside(axes, f"{text(distance)},\n{text(height)} high", (place, there), (aside, 4), **look)
    axes.axhline(0, color=INK, linewidth=0.8)
    along, height_label = (f"{what} ({reading.unit('distance')})" for what in ("distance over the ground", "height"))
    frame(axes, Panel("From the side", "to scale; a dot every second", x=along, y=height_label))
    axes.set_aspect("equal")
    far = max(1.14 * float(over_ground.max()), axes.get_xlim()[1])
    axes.set_ylim(0, max(least[1] / unit, 1.15 * float(up.max()), 0.14 * far))
    axes.set_xlim(right=max(least[0] / unit, far))


def draw_above(axes: Axes, flight: Flight, park: Park | None = None, reading: Reader = US) -> None:
    """Draw the path over the field, with the park's fence."""
    small = park is not None and park.distance_at(0.0) < SMALL_FIELD
    draw_field(axes, reading, small=small)
    if park is not None:
        draw_fence(axes, park, reading, colour=GREEN, thick=True)
    unit, foot = reading.units["distance"].size, FOOT / reading.units["distance"].size
    right, out, _ = flight.positions.T / unit
    _draw_way(axes, right, out, flight, reading)
    aside, far = (190.0 * foot, 270.0 * foot) if small else (310.0 * foot, 440.0 * foot)
    reach = max(aside, 1.1 * float(np.abs(right).max()))
    low, high = min(-10.0 * foot, float(out.min()) - 20 * foot), max(far, 1.08 * float(out.max()))
    axes.set(xlim=(-reach, reach), ylim=(low, high))
    heading(axes, "From above", park.name if park is not None else "no park")


def _draw_way(axes: Axes, across: Array, up: Array, flight: Flight, reading: Reader) -> None:
    """Draw a path seen from above, with dots at even times and its carry where it ends."""
    dots = np.arange(0, flight.times[-1], MARKS)
    axes.plot(across, up, color=RED)
    axes.plot(np.interp(dots, flight.times, across), np.interp(dots, flight.times, up), "o", color=RED, ms=3)
    axes.plot(across[-1], up[-1], "x", color=RED, ms=7)
    carry, end = reading.shown(flight.carry, "distance"), (across[-1], up[-1])
    beside(axes, carry, end, (6, 2), color=RED, weight="bold", path_effects=halo())


def draw_along(axes: Axes, flight: Flight, reading: Reader = US) -> None:
    """Draw the path from above along its own way, right of it below, where no ballpark lies around it."""
    unit = reading.units["distance"].size
    right, out, _ = flight.positions.T / unit
    axes.axhline(0, color=INK, linewidth=0.8, linestyle=SPARSE)
    _draw_way(axes, out, right, flight, reading)
    far = 1.14 * float(out.max())
    reach = max(1.3 * float(np.abs(right).max()), 0.07 * far)
    axes.set(xlim=(min(0.0, float(out.min())), far), ylim=(reach, -reach), aspect="equal")
    along, aside = (f"{what} ({reading.unit('distance')})" for what in ("distance", "right"))
    frame(axes, Panel("From above", "to scale; dashed: straight ahead", x=along, y=aside))


MOST_BARS = 30
LEAST_DRAWN = 440 * FOOT
"""m of the field that are drawn at least, straight out."""


@styled
def flights_figure(flown: Flights, reading: Reader) -> Figure:
    """Return the landing points from above, with the requested paths, and the carries."""
    figure = Figure(figsize=(8.0, 4.2), layout="constrained")
    above, far = figure.subplots(1, 2, width_ratios=(1.25, 1))
    _above(above, flown, reading)
    unit = reading.units["distance"]
    carries = flown.carry[flown.landed] / unit.size
    far.hist(carries, bins=min(MOST_BARS, max(5, round(2 * len(carries) ** 0.5))), color=BLUE)
    far.yaxis.get_major_locator().set_params(integer=True)
    frame(far, Panel("How far they carry", x=f"carry ({unit.name})", y="balls", grid="y"))
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
    out = max(LEAST_DRAWN / size, 1.05 * float(spots[:, 1].max()))
    aside = max(0.7 * LEAST_DRAWN / size, 1.05 * float(np.abs(spots[:, 0]).max()))
    axes.set(xlim=(-aside, aside), ylim=(min(-0.02 * out, 1.05 * float(spots[:, 1].min())), out))
    heading(axes, "Where they come down", "from above")


COLOURS = (RED, BLUE, GREEN, ORANGE, PURPLE, SKY)
BASE_PATH = 90 * FOOT
"""m between bases."""
RINGS = {"ft": (300, 350, 400), "m": (90, 105, 120)}
SMALL_RINGS = {"ft": (100, 150, 200, 250), "m": (30, 45, 60, 75)}
"""From home plate, in the unit of the readers; on a field for youth."""
REACH = 440 * FOOT
"""m that is drawn towards centre field."""


@styled
def parks_figure(
    parks: Sequence[Park], named: Sequence[Park] = (), reading: Reader = US, *, size: tuple[float, float] = (7.0, 5.6)
) -> Figure:
    """Return many fences laid over each other, those in ``named`` in colour with their heights as thickness."""
    figure = Figure(figsize=size, layout="constrained")
    axes = figure.subplots()
    draw_field(axes, reading)
    for park in parks:
        draw_fence(axes, park, reading, colour=MUTED, alpha=0.35)
    for park, colour in zip(named, COLOURS, strict=False):
        draw_fence(axes, park, reading, colour=colour, thick=True, label=park.name)
    heading = ", ".join(park.name for park in named) if len(named) == 1 else f"Fences of {len(parks)} parks"
    figure.suptitle(heading, x=0.02, ha="left", weight="bold", size=LARGE, parse_math=False)
    if named:
        others = "the others" if set(named) <= set(parks) else "those of the Major Leagues"
        title = f"line as thick\nas the wall is high;\ngrey: {others}"
        axes.legend(loc="lower left", frameon=False, title=title, alignment="left")
    return figure


def draw_field(axes: Axes, reading: Reader = US, *, small: bool = False) -> None:
    """Draw foul lines, the infield and distance rings in the readers' unit, and fix the axes' shape."""
    unit = reading.units["distance"].size
    line = np.array([0.0, 0.95 * REACH / unit]) * math.sin(FOUL_LINE)
    for side in (-1, 1):
        axes.plot(side * line, line, color=INK, linewidth=0.8)
    half = BASE_PATH * (2 / 3 if small else 1) / unit * math.sin(FOUL_LINE)
    axes.plot([0, half, 0, -half, 0], [0, half, 2 * half, half, 0], color=INK, linewidth=0.8)
    turn = np.linspace(-FOUL_LINE, FOUL_LINE, 91)
    for ring in (SMALL_RINGS if small else RINGS)[reading.unit("distance")]:
        axes.plot(ring * np.sin(turn), ring * np.cos(turn), color=MUTED, linewidth=0.5, linestyle=":")
        end = ring * math.sin(FOUL_LINE)
        words = f"{ring} {reading.unit('distance')}"
        beside(axes, words, (end, end), (4, -1), size=6.5, color=MUTED, va="top", path_effects=halo(2))
    axes.set(aspect="equal", xlim=(-0.7 * REACH / unit, 0.7 * REACH / unit), ylim=(-0.02 * REACH / unit, REACH / unit))
    axes.axis("off")


def draw_fence(
    axes: Axes, park: Park, reading: Reader, *, colour: str, alpha: float = 1.0, thick: bool = False, label: str = ""
) -> None:
    """Draw a fence from above; ``thick``: the line is as thick as the wall is high, 1 pt for 8 ft."""
    place, height = outline(park)
    place = place / reading.units["distance"].size
    if not thick:
        axes.plot(*place.T, color=colour, alpha=alpha, linewidth=0.7, label=label or None)
        return
    for start in range(len(place) - 1):
        width = 0.9 * (height[start] + height[start + 1]) / 2 / (8 * FOOT)
        axes.plot(*place[start : start + 2].T, color=colour, linewidth=max(0.5, width), solid_capstyle="butt")
    axes.plot([], [], color=colour, linewidth=1.8, label=label or None)


def outline(park: Park) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return points of a fence, one per degree, right and out in m, shape (91, 2), and its height there in m."""
    turn = np.linspace(-FOUL_LINE, FOUL_LINE, 91)
    distance, height = fence_at(park, turn)
    return (distance * np.stack([np.sin(turn), np.cos(turn)])).T, height
