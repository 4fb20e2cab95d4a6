"""The bat drawn to scale, in section where it is hollow or drilled, with every sweet spot marked on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Patch, Polygon, Rectangle

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.face_maps import FaceMap, face_map
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.face import FaceOutline
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures import marks
from sweetspot.reports.pictures.marks import draw_marks, draw_notes, from_the_tip
from sweetspot.reports.pictures.panels import Page, dot, heading, rows_only
from sweetspot.reports.pictures.style import INK, MUTED, ZONE, ZONE_EDGE, styled
from sweetspot.reports.quantities import RED, Reader
from sweetspot.reports.sport_words import reader_of, words_of

WIDTH, SIDE = 8.5, 0.8
"""Inches of paper: the figure, and the room left and right of the axes."""
ABOVE, BELOW, RULER, FOOT, GUIDE_START = 1.4, 0.62, 0.3, 1.05, 0.2
"""Inches of paper above and below the bat for its labels, for the ruler,
for two rulers at the foot, and from how far above the bat the sweet zone is shaded."""
POINTS = 240

BODY = {
    "wood": ("#dcb67f", "#7d5733"),
    "metal": ("#b9c1c9", "#545d66"),
    "laminate": ("#747b83", "#2f353b"),
    "filler": ("#e4dccb", "#8a7f68"),
}
"""Fill and outline of a body, by its material's family."""
FILL, HOLLOW = "#c98f55", "#f4efe6"
STRING, RUBBER = "#9aa1a8", "#a63a32"
SHADES = ((-1.0, -0.62, "#000000", 0.16), (-0.62, -0.3, "#000000", 0.06), (0.25, 0.62, "#fffffe", 0.20))
"""Bands of the radius (from, to, colour, strength) that make a round body look round; its white is not the paper's."""
GRAIN = (-0.8, -0.55, -0.33, -0.12, 0.1, 0.36, 0.58, 0.82)


@dataclass(frozen=True)
class BatPanel:
    """How much paper the drawing of one bat takes, in inches: above its axis line, below it, and its scale in m/in."""

    above: float
    below: float
    scale: float

    @property
    def height(self) -> float:
        """Inches of paper from top to bottom, without the marks."""
        return self.above + self.below


@styled
def bat_figure(analysis: Analysis[Implement], reading: Reader | None = None) -> Figure:
    """Return the bat alone, to scale, with its sweet spots, the sweet zone, balance point and hands."""
    panel, reading = bat_panel(analysis.bat), reading or reader_of(analysis.bat.sport)
    page = Page(WIDTH, panel.height + FOOT, SIDE)
    axes = page.panel(0.1, panel.height)
    draw_bat_panel(axes, analysis, panel, reading)
    shade_zone(axes, analysis, panel)
    axes.set_xlabel(from_the_tip(analysis.bat, reading), labelpad=2)
    marks.show_centimetres(axes, analysis.bat.length, offset=30, butt=analysis.bat.grip_end)
    return page.figure


def bat_panel(bat: Implement, across: float = WIDTH - 2 * SIDE) -> BatPanel:
    """Return the paper that a bat's drawing needs where its axis is ``across`` inches long."""
    scale = marks.metres_per_inch_of_paper(bat.length, across)
    half = float(bat.width_at(_places(bat)).max()) / 2 / scale
    return BatPanel(half + ABOVE, half + BELOW, scale)


@styled
def draw_bat_panel(axes: Axes, analysis: Analysis[Implement], panel: BatPanel, reading: Reader) -> None:
    """Draw bat, marks and notes on axes whose paper size is the panel's, one scale in both directions."""
    bat = analysis.bat
    marks.set_limits(axes, bat.length)
    axes.set_ylim(-panel.below * panel.scale, panel.above * panel.scale)
    rows_only(axes)
    marks.show_from_tip(axes, bat.length, reading)
    draw_bat(axes, bat)
    draw_marks(axes, analysis, reading, panel.scale, top=panel.above * panel.scale)
    draw_notes(axes, analysis, reading, panel.scale, bottom=-panel.below * panel.scale)


def shade_zone(axes: Axes, analysis: Analysis[Implement], panel: BatPanel) -> None:
    """Shade the sweet zone from the axis up to a little above the bat."""
    zone = analysis.sweet_spots.zone
    if zone is not None:
        top = (panel.below + panel.above - ABOVE + GUIDE_START) / panel.height
        axes.axvspan(*zone, ymax=top, facecolor=ZONE, edgecolor=ZONE_EDGE, linewidth=0.6, zorder=0)


@styled
def draw_bat(axes: Axes, bat: Implement) -> None:
    """Draw the bat itself around y = 0, both directions in m."""
    places = _places(bat)
    radius = bat.width_at(places) / 2
    fill, edge = BODY[bat.look]
    _band(axes, places, -radius, radius, facecolor=fill, edgecolor="none", zorder=2)
    if bat.look == "wood":
        waves = [part + 0.035 * np.sin(9 * places / bat.length + 7 * part) for part in GRAIN]
        lines = [np.column_stack([places, wave * radius]) for wave in waves]
        axes.add_artist(LineCollection(lines, color=edge, alpha=0.22, linewidth=0.5, zorder=2.1))
    for low, high, colour, strength in SHADES:
        _band(axes, places, low * radius, high * radius, facecolor=colour, alpha=strength, edgecolor="none", zorder=2.2)
    if isinstance(bat, Bat):
        _draw_inside(axes, bat, places, radius)
    elif isinstance(bat, Racket):
        _draw_strings(axes, bat)
    elif isinstance(bat, TableTennisRacket):
        _band(axes, *_oval(bat.outline), facecolor=RUBBER, edgecolor="none", zorder=2.4)
    _band(axes, places, -radius, radius, facecolor="none", edgecolor=edge, linewidth=1.1, zorder=2.8)
    for weight in bat.point_masses if isinstance(bat, Bat) else ():
        reach = float(bat.width_at(weight.position)) / 2
        axes.plot([weight.position] * 2, [-reach, reach], color=edge, linewidth=2.4, alpha=0.7, zorder=2.7)


def _draw_inside(axes: Axes, bat: Bat, places: Array, radius: Array) -> None:
    """Draw what a cut along the axis would show: the hollow of a shell, holes with their fills, the cup."""
    _, edge = BODY[bat.look]
    look = {"edgecolor": edge, "linewidth": 0.6, "zorder": 2.4}
    if bat.shell is not None:
        inner = radius - bat.wall_at(places)
        _band(axes, places, -inner, inner, facecolor=HOLLOW, **look)
    for bore in sorted(bat.bores, key=lambda bore: -bore.diameter):
        ends = np.array([bat.length - bore.depth, bat.length - bore.plug])
        reach = np.full(2, bore.diameter / 2)
        _band(axes, ends, -reach, reach, facecolor=FILL if bore.fill else HOLLOW, **look)
        if bore.plug:
            mouth = np.array([bat.length - bore.plug, bat.length])
            for side in (-1, 1):
                axes.plot(mouth, side * reach, color=edge, linewidth=0.6, linestyle=(0, (4, 2)), zorder=2.4)
    if bat.cup is not None:
        into = np.linspace(0, 1, 25)
        reach = bat.cup.diameter / 2 * np.sqrt(into)
        depth = bat.length - bat.cup.depth * (1 - into)
        _band(axes, depth, -reach, reach, facecolor=HOLLOW, **look)


def _draw_strings(axes: Axes, racket: Racket) -> None:
    """Draw the string bed: mains along, crosses across, each as long as the oval is there."""
    head = racket.head
    _band(axes, *_oval(head), facecolor=HOLLOW, edgecolor=BODY[racket.look][1], linewidth=0.6, zorder=2.4)
    half, reach = (head.end - head.start) / 2, head.width / 2
    lines = []
    for part in 2 * (np.arange(racket.bed.mains) + 0.5) / racket.bed.mains - 1:
        chord = half * np.sqrt(1 - part**2)
        lines.append([(head.middle - chord, part * reach), (head.middle + chord, part * reach)])
    for part in 2 * (np.arange(racket.bed.crosses) + 0.5) / racket.bed.crosses - 1:
        chord = reach * np.sqrt(1 - part**2)
        lines.append([(head.middle + part * half, -chord), (head.middle + part * half, chord)])
    axes.add_artist(LineCollection(lines, color=STRING, linewidth=0.5, zorder=2.5))


def _oval(outline: FaceOutline) -> tuple[Array, Array, Array]:
    """Return places along an oval face and its lower and upper edge there, m."""
    angles = np.linspace(0, np.pi, POINTS // 2)
    places = outline.middle - (outline.end - outline.start) / 2 * np.cos(angles)
    reach = outline.width / 2 * np.sin(angles)
    return places, -reach, reach


def _places(bat: Implement) -> Array:
    """Return positions that catch every corner of the outline."""
    return np.union1d(np.linspace(0, bat.length, POINTS), bat.breakpoints())


def _band(axes: Axes, places: Array, low: Array, high: Array, **look: Any) -> None:
    """Draw the area between two curves as one closed shape."""
    outline = np.concatenate([np.column_stack([places, high]), np.column_stack([places, low])[::-1]])
    axes.add_artist(Polygon(outline, closed=True, joinstyle="round", **look))


FACE_WIDTH, FACE_SIDE, GAP, TOP, FACE_FOOT, BAR = 8.5, 0.75, 0.55, 0.45, 1.05, 0.13
"""Inches of paper: the figure, its sides, between maps, above and below them, and the height of a colour scale."""
TALLEST = 4.0
RISE = LinearSegmentedColormap.from_list("rise", ["#f2f4f7", "#f6d7a7", "#e69f00", "#d55e00", "#7a2e00"])
FALL = LinearSegmentedColormap.from_list("fall", ["#f2f4f7", "#dfc3d6", "#cc79a7", "#6d2c54"])
CENTIMETRE = 0.01


COLUMNS, ROWS = 120, 90
"""Places of the maps of a face: enough for the eye."""


def analysis_face_figure(analysis: Analysis[Implement], reading: Reader | None = None) -> Figure:
    """Return the maps of the face of an analysed implement."""
    hits = face_map(analysis.reduced, analysis.conditions, columns=COLUMNS, rows=ROWS)
    return face_figure(hits, analysis.bat, reading)


@styled
def face_figure(face_hits: FaceMap, bat: Implement, reading: Reader | None = None) -> Figure:
    """Return three maps side by side, handle to the left: exit speed, efficiency q, vibration at the hands."""
    reading, outline = reading or reader_of(bat.sport), face_hits.outline
    speed = reading.units["speed"]
    across = (FACE_WIDTH - 2 * FACE_SIDE - 2 * GAP) / 3
    height = min(TALLEST, across * outline.width / (outline.end - outline.start))
    page = Page(FACE_WIDTH, TOP + height + FACE_FOOT, FACE_SIDE)
    maps = (
        ("Exit speed", speed.name, face_hits.exit_speed / speed.size, RISE),
        ("Efficiency q", "", face_hits.collision_efficiency, RISE),
        ("Sting", "m/s", face_hits.sting, FALL),
    )
    for number, (title, unit, values, colours) in enumerate(maps):
        left = FACE_SIDE + number * (across + GAP)
        axes = page.panel(TOP, height, left=left, width=across)
        _map(axes, face_hits, values, colours, reading, bat)
        heading(axes, title, unit)
        if number == 0:
            axes.set_ylabel("cm across")
            position, lateral = face_hits.best()
            dot(axes, position, lateral, RED)
        _scale(page.panel(TOP + height + 0.55, BAR, left=left, width=across), values, colours)
    return page.figure


def _map(
    axes: Axes, face_hits: FaceMap, values: Array, colours: LinearSegmentedColormap, reading: Reader, bat: Implement
) -> None:
    outline, place, length = face_hits.outline, reading.units["place"], bat.length
    half, long = outline.width / 2, outline.end - outline.start
    shape = _shape(outline)
    extent = (outline.start, outline.end, -half, half)
    image = axes.imshow(values, colours, extent=extent, origin="lower", aspect="equal", interpolation="nearest")
    axes.add_patch(shape)
    image.set_clip_path(shape)
    axes.spines[:].set_visible(False)
    reach = 0.02 * long
    axes.set_xlim(outline.start - reach, outline.end + reach)
    axes.set_ylim(-half - reach, half + reach)
    step = _step(long) / CENTIMETRE * place.size
    counts = np.arange(np.ceil((length - outline.end) / step), (length - outline.start) / step + 1e-9)
    axes.set_xticks(length - counts * step, [f"{count * step / place.size:.3g}" for count in counts])
    axes.set_xlabel(f"{place.name} from the {words_of(bat.sport).tip}", labelpad=1)
    sideways = _step(max(outline.width, long / 2))
    places = np.arange(-np.floor(half / sideways), np.floor(half / sideways) + 1) * sideways
    axes.set_yticks(places, [f"{abs(place) / CENTIMETRE:.3g}" for place in places])


def _step(length: float) -> float:
    """Return the distance in m between ticks along ``length`` m."""
    return next((step for step in (0.01, 0.02, 0.05, 0.1) if length / step <= 7), 0.2)


def _shape(outline: FaceOutline) -> Patch:
    """Return the face's edge."""
    length, corner = outline.end - outline.start, (outline.start, -outline.width / 2)
    oval = Ellipse((outline.middle, 0.0), length, outline.width)
    shape: Patch = oval if outline.shape == "oval" else Rectangle(corner, length, outline.width)
    shape.set(facecolor="none", edgecolor=INK, linewidth=0.9, zorder=3)
    return shape


def _scale(axes: Axes, values: Array, colours: LinearSegmentedColormap) -> None:
    """Draw what the colours stand for."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    axes.imshow(np.linspace(0, 1, 128)[None, :], cmap=colours, extent=(low, high, 0, 1), aspect="auto")
    axes.set_yticks([])
    axes.set_xticks(np.linspace(low, high, 3), [f"{value:.3g}" for value in np.linspace(low, high, 3)])
    axes.tick_params(colors=MUTED)
    axes.spines[:].set_visible(False)
