"""One picture of several bats, tips aligned: outlines, exit speed along each, differences, sweet zones."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from sweetspot.analysis.comparison import Compared
from sweetspot.answers.compare import CompareAnswer, ComparedBat
from sweetspot.catalog.sports import sport
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Band, interval_of
from sweetspot.reports.pictures import marks
from sweetspot.reports.pictures.marks import from_the_tip
from sweetspot.reports.pictures.panels import Page, Panel, band, dot, frame, heading, roomy, rows_only, write
from sweetspot.reports.pictures.style import GRID, INK, NORMAL, SHEET, SMALL, fitted, styled
from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, SKY, US, Reader
from sweetspot.reports.sentences import within
from sweetspot.reports.sport_words import words_of

WIDTH, SIDE, HEADER, CURVES, DIFFERENCES, ROW, BETWEEN, FOOTER = 8.0, 0.62, 1.05, 2.6, 1.3, 0.27, 0.5, 0.85
"""Inches of paper: page, margins, title, curves, differences, one bat's row of the zones, the gaps, the foot."""
ZOOMED = 0.2
"""Inches of paper more where the curves have a ruler of their own."""
NAME_WIDTH, NAMES_IN_A_ROW, MOST_OUTLINES = 2.3, 3, 3
"""Inches of paper for a bat's name in its row; on a sheet, names side by side, and how many bats have outlines."""
COLOURS = (INK, RED, BLUE, GREEN, ORANGE, PURPLE, SKY)
DASHES: tuple[Any, ...] = ("solid", (0, (5, 1.5)), (0, (1.5, 1.2)))
"""The reference is drawn in ink; from the eighth bat on the colours come again, dashed."""
OUTER = 0.4
"""Part of the length, from the tip, that the axes of speed and difference are made for; curves run on beyond it."""
POINTS = 200


@styled
def compare_figure(answer: CompareAnswer, reading: Reader = US) -> Figure:
    """Return the figure: outlines, exit speed, its difference from the first, and zone and best place of each."""
    compared = answer.comparison.compared
    length = max(each.analysis.bat.length for each in compared)
    scale = marks.metres_per_inch_of_paper(length, WIDTH - 2 * SIDE)
    outlines = _widest(compared) / scale + 0.1
    rows, differences = ROW * (len(compared) + 0.4), DIFFERENCES + BETWEEN if len(compared) > 1 else 0.0
    zoomed = _window(compared, length) > 0
    between = BETWEEN + (ZOOMED if zoomed else 0.0)
    height = HEADER + outlines + BETWEEN + CURVES + differences + between + rows + FOOTER
    page = Page(WIDTH, height, SIDE)
    page.title(*_header(answer, reading))

    def panel(top: float, tall: float, *, whole: bool = False) -> Axes:
        axes = page.panel(top, tall)
        start = 0.0 if whole else _window(compared, length)
        axes.set_xlim(start - marks.MARGIN * (length - start), length + marks.MARGIN * (length - start))
        return axes

    top = HEADER + outlines + BETWEEN
    lowest = panel(top, CURVES)
    _curves(lowest, compared, length, reading)
    _zones(panel(top + CURVES + differences + between, rows, whole=True), answer.bats, length, reading)
    _outlines(panel(HEADER, outlines, whole=True), compared, length, scale * outlines / 2)
    if differences:
        lowest = panel(top + CURVES + BETWEEN, DIFFERENCES)
        _differences(lowest, answer.bats, length, reading)
    if zoomed:
        marks.show_from_tip(lowest, length, reading)
    words = (
        "Boxes: sweet zones. Dots: best places. Change: against the first. Hit straight on. Speeds do not begin at 0."
    )
    if answer.sources:
        words = words.replace("Hit straight on.", "Bands: 90 % intervals of it.")
    page.foot(words)
    return page.figure


@styled
def compare_sheet(answer: CompareAnswer, reading: Reader = US) -> Figure:
    """Return `compare_figure` for a printed sheet, whose tables hold the zones' numbers: curves side by side."""
    compared, side, top = answer.comparison.compared, 0.5, 0.22
    length, across = max(each.analysis.bat.length for each in compared), SHEET - 2 * side
    scale = marks.metres_per_inch_of_paper(length, across)
    outlines = _widest(compared) / scale + 0.1
    drawn = len(compared) <= MOST_OUTLINES
    tall = 1.3 if drawn else 0.9  # the tables of many bats leave little room, and letters are as small as it makes them
    names = 0.2 * math.ceil(len(compared) / NAMES_IN_A_ROW)
    height = top + (outlines + 0.38 if drawn else 0.0) + tall + 0.42 + names
    page = Page(SHEET, height, side)
    if drawn:
        axes = page.panel(top, outlines)
        marks.set_limits(axes, length)
        _outlines(axes, compared, length, scale * outlines / 2)
        top += outlines + 0.38
    note = f"{reading.unit('speed_change')}; above 0: faster"
    panels: list[Callable[[Axes], None]] = [
        lambda axes: _curves(axes, compared, length, reading),
        lambda axes: _differences(axes, answer.bats, length, reading, note),
    ][: len(compared)]
    wide = across / len(panels) - (0.25 if len(panels) > 1 else 0.0)
    start = max(_window(compared, length), (1 - OUTER) * length)
    for number, draw in enumerate(panels):
        axes = page.panel(top, tall, left=side + number * (wide + 0.5), width=wide)
        axes.set_xlim(start - 0.02 * (length - start), length + 0.02 * (length - start))
        draw(axes)
        marks.show_from_tip(axes, length, reading)
        axes.set_xlabel(from_the_tip(compared[0].analysis.bat, reading), labelpad=2)
    lines = [Line2D([], [], color=_look(number)[0], linestyle=_look(number)[1]) for number in range(len(compared))]
    labels = [fitted(each.label, width=2.0, size=SMALL, smallest=SMALL)[0].replace("$", r"\$") for each in compared]
    page.figure.legend(
        lines, labels, loc="lower left", ncols=NAMES_IN_A_ROW, frameon=False, fontsize=SMALL, borderpad=0
    )
    return page.figure


def _window(compared: Sequence[Compared[Implement]], length: float) -> float:
    """Return the start of the panels in m on the common axis: the end of the longest bat, or the start of all faces."""
    starts = ((marks.window(bat)[0], length - bat.length) for bat in (each.analysis.bat for each in compared))
    return min(start + shift if start > 0 else 0.0 for start, shift in starts)


def _header(answer: CompareAnswer, reading: Reader) -> tuple[str, str]:
    """Return the title, and how the bats are swung."""
    reference, law = answer.comparison.reference.analysis, answer.swing_law
    conditions, words = reference.conditions, sport(reference.bat.sport).words
    tool, number = words.implement, len(answer.bats)
    title = f"One {tool}" if number == 1 else f"{number} {tool}s, one player"
    effort = f"all at the same {tool} speed" if law is None else f"same effort by the law of {law.name}"
    speed = partial(reading.shown, scale="speed", digits=0)
    pitch = conditions.pitch.speed
    arriving = f"{speed(pitch)} {words.incoming}" if pitch else f"a {words.incoming} at rest"
    return title, f"{arriving}; {speed(conditions.swing.bat_speed)} of {tool} speed with the first {tool}, {effort}"


def _outlines(axes: Axes, compared: Sequence[Compared[Implement]], length: float, half: float) -> None:
    """Draw every outline to scale, the first one filled."""
    for number, each in reversed(list(enumerate(compared))):
        places, (colour, dash) = _places(each), _look(number)
        across, along = each.analysis.bat.width_at(places) / 2, places + length - each.analysis.bat.length
        ends = np.concatenate([along, along[::-1], along[:1]]), np.concatenate([across, -across[::-1], across[:1]])
        axes.plot(*ends, color=colour, linestyle=dash, linewidth=1.0)
        if number == 0:
            axes.fill(*ends, color=GRID, linewidth=0, zorder=0)
    axes.set_ylim(-half, half)
    axes.axis("off")
    heading(axes, "Outlines", f"to scale, {words_of(compared[0].analysis.bat.sport).tip}s aligned")


def _curves(axes: Axes, compared: Sequence[Compared[Implement]], length: float, reading: Reader) -> None:
    marks.show_from_tip(axes, length, reading, labels=False, grid=True)
    words = words_of(compared[0].analysis.bat.sport)
    name = words.exit_speed[0].upper() + words.exit_speed[1:]
    note = f"how fast the {words.ball} leaves, {reading.unit('speed')}"
    frame(axes, Panel(name, note, grid="y", ticks=6, prune="lower"))
    size = reading.units["speed"].size
    speeds = []
    for number, each in reversed(list(enumerate(compared))):  # the reference last, on top
        scan, (colour, dash) = each.analysis.scan, _look(number)
        places, speed = scan.position + length - each.analysis.bat.length, scan.exit_speed / size
        speed = np.where(places > (1 - OUTER) * length, speed, np.nan)  # no batter aims nearer the hands
        axes.plot(places, speed, color=colour, linestyle=dash, linewidth=1.5)
        dot(axes, _best(each, length), each.exit_speed.value / size, colour)
        speeds.append(speed)
    axes.set_ylim(*roomy(np.concatenate(speeds), 0.05, 0.08))


def _differences(axes: Axes, bats: Sequence[ComparedBat], length: float, reading: Reader, note: str = "") -> None:
    """Draw by how much the ball leaves faster than from the first one, equally far from the tip, with its interval."""
    marks.show_from_tip(axes, length, reading, labels=False, grid=True)
    far = f"equally far from the {words_of(bats[0].compared.analysis.bat.sport).tip}, {reading.unit('speed_change')}"
    frame(axes, Panel("Difference from the first", note or f"{far}; above 0: faster", grid="y", ticks=5, prune="upper"))
    size = reading.units["speed_change"].size
    places = np.linspace((1 - OUTER) * length, length, POINTS)
    axes.axhline(0, color=COLOURS[0], linewidth=1.0)
    ends = [0.0]
    for number, each in enumerate(bats[1:], start=1):
        along, (colour, dash) = each.scan.position + length - each.compared.analysis.bat.length, _look(number)
        change = each.scan.change
        sides = (change.value, change.low, change.high) if isinstance(change, Band) else (change,)
        bands = [np.interp(places, along, side, left=np.nan, right=np.nan) / size for side in sides]
        axes.plot(places, bands[0], color=colour, linestyle=dash, linewidth=1.5)
        if isinstance(change, Band):
            band(axes, places, bands[1], bands[2], colour, alpha=0.15)
        ends += [float(np.nanmin(bands, initial=0.0)), float(np.nanmax(bands, initial=0.0))]
    axes.set_ylim(*roomy(ends, 0.1, 0.1, least=10.0))


def _places(compared: Compared[Implement]) -> Array:
    return np.linspace(0.0, compared.analysis.bat.length, POINTS)


def _widest(compared: Sequence[Compared[Implement]]) -> float:
    return max(float(each.analysis.bat.width_at(_places(each)).max()) for each in compared)


def _zones(axes: Axes, bats: Sequence[ComparedBat], length: float, reading: Reader) -> None:
    """Draw a row per bat: name, sweet zone on the common axis, exit speed, and the change with its interval."""
    marks.show_from_tip(axes, length, reading)
    axes.set_xlabel(from_the_tip(bats[0].compared.analysis.bat, reading), labelpad=2)
    rows_only(axes)
    axes.set_ylim(-len(bats) + 0.3, 0.7)
    heading(axes, "Sweet zones", "fast and quiet; with the exit speed at the best place, and its change")
    edge, centred = axes.get_xlim()[0], {"va": "center_baseline", "color": INK, "parse_math": False}
    for number, each in enumerate(bats):
        colour, dash = _look(number)
        zone, best = each.zone, _best(each.compared, length)
        if zone is not None:
            start = zone[0] + length - each.compared.analysis.bat.length
            box = Rectangle((start, -number - 0.3), zone[1] - zone[0], 0.6, gid="zone")
            box.set(facecolor=colour, alpha=0.22, linewidth=0)
            axes.add_patch(box)
        dot(axes, best, -number, colour)
        axes.plot([edge, edge + 0.025 * length], [-number, -number], color=colour, linestyle=dash, linewidth=2)
        name, size = fitted(each.label, width=NAME_WIDTH, size=NORMAL, smallest=SMALL)
        write(axes, edge + 0.035 * length, -number, name, ha="left", size=size, **centred)
        change = within(interval_of(each.change), "speed_change", sign=True).read(reading)
        words = reading.shown(float(each.exit_speed), "speed") + (f"  {change}" if number else "")
        left = edge + 0.66 * (axes.get_xlim()[1] - edge)
        write(axes, left, -number, words, ha="right", size=SMALL, **centred)


def _look(number: int) -> tuple[str, Any]:
    return COLOURS[number % len(COLOURS)], DASHES[min(number // len(COLOURS), len(DASHES) - 1)]


def _best(compared: Compared[Implement], length: float) -> float:
    """Return the best place in m on the common axis, on which all tips lie at ``length``."""
    return compared.analysis.sweet_spots.max_exit_speed + length - compared.analysis.bat.length
