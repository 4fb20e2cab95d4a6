"""Maps of hits all over a face: exit speed, efficiency and sting, place for place, seen from the ball."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Patch, Rectangle

from sweetspot.analysis.face_maps import FaceMap
from sweetspot.equipment.face import FaceOutline
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.report.pictures.style import INK, MUTED, PAPER, axes_in_inches, heading, styled
from sweetspot.report.quantities import RED, Reader
from sweetspot.report.sport_words import reader_of, words_of

WIDTH, SIDE, GAP, TOP, FOOT, BAR = 8.5, 0.75, 0.55, 0.45, 1.05, 0.13
"""Inches of paper: the figure, its sides, between maps, above and below them, and the height of a colour scale."""
TALLEST = 4.0
RISE = LinearSegmentedColormap.from_list("rise", ["#f2f4f7", "#f6d7a7", "#e69f00", "#d55e00", "#7a2e00"])
FALL = LinearSegmentedColormap.from_list("fall", ["#f2f4f7", "#dfc3d6", "#cc79a7", "#6d2c54"])
CENTIMETRE = 0.01


@styled
def face_figure(face_hits: FaceMap, bat: Implement, reading: Reader | None = None) -> Figure:
    """Return three maps side by side, handle to the left: exit speed, efficiency q, vibration at the hands."""
    reading, outline = reading or reader_of(bat), face_hits.outline
    speed = reading.units["speed"]
    across = (WIDTH - 2 * SIDE - 2 * GAP) / 3
    height = min(TALLEST, across * outline.width / (outline.end - outline.start))
    figure = Figure(figsize=(WIDTH, TOP + height + FOOT))
    maps = (
        ("Exit speed", speed.name, face_hits.exit_speed / speed.size, RISE),
        ("Efficiency q", "", face_hits.collision_efficiency, RISE),
        ("Sting", "m/s", face_hits.sting, FALL),
    )
    for number, (title, unit, values, colours) in enumerate(maps):
        left = SIDE + number * (across + GAP)
        axes = axes_in_inches(figure, left=left, top=TOP, width=across, height=height)
        _map(axes, face_hits, values, colours, reading, bat)
        heading(axes, title, unit)
        if number == 0:
            axes.set_ylabel("cm across")
            position, lateral = face_hits.best()
            axes.plot(position, lateral, "o", color=RED, markersize=5, markeredgecolor=PAPER, markeredgewidth=0.8)
        bar = axes_in_inches(figure, left=left, top=TOP + height + 0.55, width=across, height=BAR)
        _scale(bar, values, colours)
    return figure


def _map(
    axes: Axes, face_hits: FaceMap, values: Array, colours: LinearSegmentedColormap, reading: Reader, bat: Implement
) -> None:
    outline, place, length = face_hits.outline, reading.units["place"], bat.length
    half, long = outline.width / 2, outline.end - outline.start
    shape = _shape(outline)
    image = axes.imshow(
        values, cmap=colours, extent=(outline.start, outline.end, -half, half), origin="lower", aspect="equal",
        interpolation="nearest",
    )  # fmt: skip
    axes.add_patch(shape)
    image.set_clip_path(shape)
    for side in axes.spines.values():
        side.set_visible(False)
    reach = 0.02 * long
    axes.set_xlim(outline.start - reach, outline.end + reach)
    axes.set_ylim(-half - reach, half + reach)
    step = _step(long) / CENTIMETRE * place.size
    counts = np.arange(np.ceil((length - outline.end) / step), (length - outline.start) / step + 1e-9)
    axes.set_xticks(length - counts * step, [f"{count * step / place.size:.3g}" for count in counts])
    axes.set_xlabel(f"{place.name} from the {words_of(bat).tip}", labelpad=1)
    sideways = _step(max(outline.width, long / 2))
    places = np.arange(-np.floor(half / sideways), np.floor(half / sideways) + 1) * sideways
    axes.set_yticks(places, [f"{abs(place) / CENTIMETRE:.3g}" for place in places])


def _step(length: float) -> float:
    """Return the distance in m between ticks along ``length`` m."""
    return next((step for step in (0.01, 0.02, 0.05, 0.1) if length / step <= 7), 0.2)


def _shape(outline: FaceOutline) -> Patch:
    """Return the face's edge."""
    look: dict[str, Any] = {"facecolor": "none", "edgecolor": INK, "linewidth": 0.9, "zorder": 3}
    length = outline.end - outline.start
    if outline.shape == "oval":
        return Ellipse((outline.middle, 0.0), length, outline.width, **look)
    return Rectangle((outline.start, -outline.width / 2), length, outline.width, **look)


def _scale(axes: Axes, values: Array, colours: LinearSegmentedColormap) -> None:
    """Draw what the colours stand for."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    axes.imshow(np.linspace(0, 1, 128)[None, :], cmap=colours, extent=(low, high, 0, 1), aspect="auto")
    axes.set_yticks([])
    axes.set_xticks(np.linspace(low, high, 3), [f"{value:.3g}" for value in np.linspace(low, high, 3)])
    axes.tick_params(colors=MUTED)
    for side in axes.spines.values():
        side.set_visible(False)
