"""Labels on the drawing of a bat: a ladder of sweet spots above it, the zone, balance and hands below it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.markers import TICKDOWN

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.panels import dot, double_arrow, write
from sweetspot.reports.pictures.style import GRID, INK, MUTED, NORMAL, SMALL, ZONE_INK
from sweetspot.reports.quantities import Reader
from sweetspot.reports.sentences import Slot
from sweetspot.reports.sport_words import words_of
from sweetspot.reports.sweet_spots import SPOTS

ROW, GAP, NUMBER = 0.175, 0.14, 0.42
"""Inches of paper: from label to label, from the bat to the lowest one, and for the number in a label."""


@dataclass(frozen=True)
class Mark:
    """One sweet spot on the drawing: its field's name and its place in m from the knob end."""

    field: str
    place: float


def ladder(analysis: Analysis[Implement]) -> tuple[list[Mark], list[Mark]]:
    """Return the marks on the handle's and on the barrel's half, each from the lowest label up.

    A label's line runs level from the label to above its place and then straight down; in this order no line
    crosses another, however close the places are.
    """
    spots = analysis.sweet_spots
    marks = sorted((Mark(field, getattr(spots, field)) for field in SPOTS), key=lambda mark: mark.place)
    middle = analysis.bat.length / 2
    left = [mark for mark in reversed(marks) if mark.place < middle]
    return left, [mark for mark in marks if mark.place >= middle]


def draw_marks(axes: Axes, analysis: Analysis[Implement], reading: Reader, scale: float, *, top: float) -> None:
    """Draw a dot on the bat for every sweet spot, and lead each to its label.

    Parameters
    ----------
    scale : m of bat per inch of paper.
    top : upper end of the axis in m.
    """
    left, right = ladder(analysis)
    marks = [*left, *right]
    column = min((mark.place for mark in right), default=analysis.bat.length) - GAP * scale
    for number, mark in enumerate(marks):
        level = top - (len(marks) - number - 0.5 + 1) * ROW * scale
        radius = float(analysis.bat.width_at(mark.place)) / 2
        beside = 0.0 if analysis.bat.outline is not None else radius * (0.72 - 1.44 * number / (len(marks) - 1))
        colour = SPOTS[mark.field].colour
        ahead = mark in right
        start = column if ahead else mark.place + GAP * scale
        line = axes.plot([start, mark.place, mark.place], [level, level, beside], color=colour, linewidth=1.1)
        line[0].set(zorder=3 + number / 100, solid_joinstyle="round")
        dot(axes, mark.place, beside, colour, size=5.2, zorder=4)
        distance = reading.number(analysis.bat.length - mark.place, "place")
        name = SPOTS[mark.field].labelled(words_of(analysis.bat.sport))
        _label(axes, distance, name, (start, level), scale, ahead=ahead, best=mark.field == "max_exit_speed")
    if right:
        corner = column - 0.06 * scale, top - 0.5 * ROW * scale
        words = from_the_tip(analysis.bat, reading)
        axes.text(*corner, words, ha="right", va="center_baseline", color=MUTED, size=SMALL)


def _label(
    axes: Axes, distance: str, name: str, at: tuple[float, float], scale: float, *, ahead: bool, best: bool
) -> None:
    (place, level), way = at, -1 if ahead else 1
    look = {"va": "center_baseline", "color": INK, "size": NORMAL, "zorder": 5, "ha": "right" if ahead else "left"}
    write(axes, place + way * 0.06 * scale, level, distance, weight="bold", **look)
    write(axes, place + way * (0.06 + NUMBER) * scale, level, name, weight="bold" if best else "normal", **look)


def draw_notes(axes: Axes, analysis: Analysis[Implement], reading: Reader, scale: float, *, bottom: float) -> None:
    """Draw what is below the bat: zone and its width, balance point, hands, and what was drilled.

    Parameters
    ----------
    scale : m of bat per inch of paper.
    bottom : lower end of the axis in m.
    """
    bat, body = analysis.bat, analysis.body
    upper, lower = bottom + 0.42 * scale, bottom + 0.16 * scale
    _zone(axes, analysis, reading, upper, lower)
    below = -float(bat.width_at(body.balance_point)) / 2 - 0.08 * scale
    axes.plot(body.balance_point, below, "^", color=INK, markersize=6, zorder=4, clip_on=False)
    balance = f"balance {reading.shown(body.balance_point, 'place')} from the {words_of(bat.sport).butt}"
    quiet = {"va": "center_baseline", "color": MUTED, "size": SMALL}
    label = write(axes, body.balance_point - 0.12 * scale, upper, balance, ha="right", **quiet)
    hands = analysis.conditions.hands.places
    for place in hands:
        reach = float(bat.width_at(place)) / 2 + 0.05 * scale
        axes.plot([place, place], [-reach, reach], color=MUTED, linewidth=1.2, linestyle=(0, (1.5, 1.5)), zorder=3)
    held = write(axes, sum(hands) / 2, upper, words_of(bat.sport).hands, ha="center", **quiet)
    if label.get_window_extent().padded(6).overlaps(held.get_window_extent()):  # a balance point near the hands
        if bat.outline is None:
            label.set(x=body.balance_point + 0.12 * scale, ha="left")
        else:  # where the face lies ahead, and nothing below
            held.set(y=lower)
    note = _inside_note(analysis, reading)
    if note:
        write(axes, body.balance_point - 0.12 * scale, lower, note, ha="right", **quiet)


def _zone(axes: Axes, analysis: Analysis[Implement], reading: Reader, upper: float, lower: float) -> None:
    zone, length, words = analysis.sweet_spots.zone, analysis.bat.length, words_of(analysis.bat.sport)
    look = {"va": "center_baseline", "size": NORMAL, "zorder": 5}
    if zone is None:
        write(axes, 0.8 * length, lower, f"no {words.zone}", color=MUTED, ha="center", **look)
        return
    double_arrow(axes, *zone, upper, ZONE_INK)
    middle, width = (zone[0] + zone[1]) / 2, reading.shown(zone[1] - zone[0], "place")
    place, side = (middle, "center") if middle <= 0.93 * length else (length, "right")
    write(axes, place, lower, f"{words.zone} {width}", color=ZONE_INK, weight="bold", ha=side, **look)


def _inside_note(analysis: Analysis[Implement], reading: Reader) -> str:
    """Say what the section shows."""
    bat = analysis.bat
    if not isinstance(bat, Bat):
        return ""

    def size(value: float) -> str:
        return Slot(value, "length").read(reading)

    notes = []
    for bore in bat.bores:
        fill = f"filled with {bore.fill.name}" if bore.fill else "empty"
        notes.append(f"hole {size(bore.diameter)} wide, {size(bore.depth)} deep, {fill}")
    if bat.cup is not None:
        notes.append(f"cup {size(bat.cup.diameter)} wide, {size(bat.cup.depth)} deep")
    if bat.shell is not None:
        walls = [wall for _, wall in bat.shell.wall]
        least = reading.number(min(walls), "compression")
        notes.append(f"{bat.material.name}, wall {least} to {reading.shown(max(walls), 'compression')}")
    return "; ".join(notes)


MARGIN = 0.02
"""Empty part of the bat's length at either end of the axis."""
CENTIMETRE_STEP = 10
TICKS = {"in": ("inches", 3), "cm": ("centimetres", 10)}
"""By the unit of places: its name in full, and how many of them lie between ticks."""


def set_limits(axes: Axes, length: float) -> None:
    """Let an axis span a bat of ``length`` m with a little air at both ends."""
    axes.set_xlim(-MARGIN * length, (1 + MARGIN) * length)


SMALL_FACE = 0.3
"""Part of the length below which the panels show the face alone, and what lies near it."""
AROUND_FACE = 0.15
"""How much of the shaft such panels show, as a part of the face."""
STEPS, MOST_TICKS = (1, 2, 5, 10, 20, 50), 16
"""Places between ticks where a part of the length is shown, and how many ticks there may be."""


def window(implement: Implement) -> tuple[float, float]:
    """Return the part of an implement in m that panels show: all of it, or the face where that is small."""
    face = implement.outline
    if face is None or face.end - face.start > SMALL_FACE * implement.length:
        return 0.0, implement.length
    return max(0.0, face.start - AROUND_FACE * (face.end - face.start)), implement.length


def is_zoomed(implement: Implement) -> bool:
    """Return whether panels show the face alone."""
    return window(implement)[0] > 0


def set_window(axes: Axes, implement: Implement) -> None:
    """Let an axis span what panels show of an implement, with a little air at both ends."""
    low, high = window(implement)
    axes.set_xlim(low - MARGIN * (high - low), high + MARGIN * (high - low))


def metres_per_inch_of_paper(length: float, width: float) -> float:
    """Return the drawing's scale: metres of bat per inch of paper on an axis ``width`` inches wide."""
    return (1 + 2 * MARGIN) * length / width


def show_from_tip(axes: Axes, length: float, reading: Reader, *, labels: bool = True, grid: bool = False) -> None:
    """Put ticks every few inches or centimetres from the tip, as people count.

    Marks and grid are one artist each: of matplotlib's own ticks every one takes five.

    Parameters
    ----------
    labels : whether numbers stand below, and a mark for every unit.
    grid : whether a faint line goes up from every tick.
    """
    unit = reading.units["place"]
    limits = axes.get_xlim()
    extent = limits[1] - limits[0]
    step = TICKS[unit.name][1]
    if extent <= length / 2:
        step = next(each for each in STEPS if extent / (each * unit.size) < MOST_TICKS)
    counts = np.arange(0, length / unit.size + 1e-6, step)
    places = length - counts * unit.size
    seen = (places >= limits[0]) & (places <= limits[1])
    places, counts = places[seen], counts[seen]
    if grid:
        axes.vlines(places, 0, 1, transform=axes.get_xaxis_transform(), colors=GRID, linewidth=0.6, zorder=0.5)
    if labels:
        axes.set_xticks(places, [f"{value:.0f}" for value in counts])
        every = length - np.arange(0, length / unit.size + 1e-6) * unit.size
        every = every[(every >= limits[0]) & (every <= limits[1])]
        _marks(axes, every, size=1.8, width=0.5)
    else:
        axes.set_xticks([])
        _marks(axes, places, size=3.0, width=0.7)
    axes.set_xlim(limits)


def _marks(axes: Axes, places: Array, *, size: float, width: float) -> None:
    """Draw short lines below the axis."""
    line = Line2D(places, np.zeros_like(places), linestyle="", transform=axes.get_xaxis_transform())
    line.set(marker=TICKDOWN, markersize=size, markeredgewidth=width, color=MUTED, clip_on=False)
    axes.add_artist(line)


def from_the_tip(implement: Implement, reading: Reader) -> str:
    """Return the label of the axis along an implement: "inches from the tip"."""
    return f"{TICKS[reading.unit('place')][0]} from the {words_of(implement.sport).tip}"


def show_centimetres(axes: Axes, length: float, *, offset: float, butt: str = "knob end") -> Axes:
    """Add a second ruler, in cm from the knob, ``offset`` points below the axis; return it."""
    places = np.arange(0, length + 1e-9, CENTIMETRE_STEP / 100)
    ruler = axes.twiny()
    ruler.set_xlim(axes.get_xlim())
    ruler.xaxis.set_ticks_position("bottom")
    ruler.xaxis.set_label_position("bottom")
    ruler.spines[["left", "right", "top"]].set_visible(False)
    ruler.spines["bottom"].set_visible(True)
    ruler.spines["bottom"].set_position(("outward", offset))
    ruler.set_xticks(places, [f"{100 * place:.0f}" for place in places])
    ruler.set_xlabel(f"cm from the {butt}", labelpad=2)
    return ruler
