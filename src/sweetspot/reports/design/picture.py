"""One picture of a design: outlines, what it gains and costs along the bat, and the front with small bats as points."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.answers.design_question import Designed
from sweetspot.catalog.sports import sport
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.measures import MEASURES
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.interval import REACH
from sweetspot.reports.pictures import marks
from sweetspot.reports.pictures.panels import Page, Panel, beside, frame, heading
from sweetspot.reports.pictures.style import GRID, INK, MUTED, SMALL, ZONE, styled
from sweetspot.reports.quantities import BLUE, RED, US, Reader

WIDTH, SIDE, HEADER, OUTLINES, CURVES, FRONT, BETWEEN, FOOTER = 8.0, 0.7, 0.95, 0.75, 2.1, 2.9, 0.62, 0.55
"""Inches of paper: page, margins, title, outlines, curves, front, gaps, foot."""
POINTS, MOST_BATS = 160, 9
BAT_LENGTH, SLIM = 0.17, 0.08
"""Of the front's width, that a small bat is long; and half a width over a length up to which it is a slim one."""


@styled
def design_figure(design: Designed, reading: Reader = US) -> Figure:
    """Return the figure of a design."""
    present = design.bench.space.present
    length = max(present.length, design.bat.length)
    two = len(design.question.wants) > 1
    curves = HEADER + OUTLINES + BETWEEN
    front = curves + CURVES + BETWEEN
    page = Page(WIDTH, front + (FRONT if two else 0.0) + FOOTER, SIDE)
    tool = sport(present.sport).words.implement
    page.title(f"A {tool} for this {'batter' if tool == 'bat' else 'player'}", f"against {present.name}")
    for draw, top, tall in ((_outlines, HEADER, OUTLINES), (_difference, curves, CURVES)):
        axes = page.panel(top, tall)
        marks.set_limits(axes, length)
        draw(axes, design, length, reading)
    if two:
        _front(page.panel(front, FRONT), design, reading)
    return page.figure


def _contour(implement: Implement) -> tuple[np.ndarray, np.ndarray]:
    places = np.linspace(0.0, implement.length, POINTS)
    if isinstance(implement, Bat) and implement.profile is not None:
        places = np.union1d(places, [place for place, _ in implement.profile])
    half = implement.width_at(places) / 2
    return np.concatenate([places, places[::-1], places[:1]]), np.concatenate([half, -half[::-1], half[:1]])


def _outlines(axes: Axes, design: Designed, length: float, _: Reader) -> None:
    for implement, colour, fill in ((design.bench.space.present, MUTED, True), (design.bat, RED, False)):
        along, half = _contour(implement)
        shift = length - implement.length
        if fill:
            axes.fill(along + shift, half, color=GRID, linewidth=0, zorder=0)
        axes.plot(along + shift, half, color=colour, linewidth=1.3)
    axes.set_aspect("equal")
    axes.axis("off")
    heading(axes, "Outlines", "to scale, tips aligned; grey: present, orange: design")


def _difference(axes: Axes, design: Designed, length: float, reading: Reader) -> None:
    """Draw the change of exit speed along the bat with the band of the wood, and where the batter meets the ball."""
    size, gain = reading.units["speed_change"].size, design.gain
    places = length - FROM_TIP
    unit = reading.units["place"]
    counts = np.arange(0, FROM_TIP[-1] / unit.size + 1e-6, marks.TICKS[unit.name][1])
    axes.set_xticks(length - counts * unit.size, [f"{count:.0f}" for count in counts])
    note = f"exit speed, {reading.unit('speed_change')}; band: two of one shape; grey: your contacts"
    label = marks.from_the_tip(design.bench.space.present, reading)
    frame(axes, Panel("Design minus present", note, x=label, ticks=6))
    band = REACH * gain.noise / size
    axes.fill_between(places, -band, band, color=ZONE, linewidth=0, zorder=0)
    axes.axhline(0, color=INK, linewidth=0.9)
    axes.plot(places, gain.curve / size, color=RED, linewidth=1.8)
    weight = design.bench.batter.weight
    low, high = axes.get_ylim()
    foot = low - 0.02 * (high - low)
    contacts = foot + 0.25 * (high - low) * weight / weight.max()
    axes.fill_between(places, foot, contacts, color=GRID, linewidth=0, zorder=1)
    axes.set(xlim=(length - FROM_TIP[-1], length * (1 + marks.MARGIN)), ylim=(foot, high))


def _front(axes: Axes, design: Designed, reading: Reader) -> None:
    """Draw every bat of the front where its two wants are, some of them as small bats."""
    wants, values = design.question.wants[:2], design.front.measured.values
    scales = [MEASURES[want].scale for want in wants]
    x, y = (values[want] / reading.units[scale].size for want, scale in zip(wants, scales, strict=True))
    now = [float(design.now.values[want][0]) for want in wants]
    now_x, now_y = (value / reading.units[scale].size for value, scale in zip(now, scales, strict=True))
    x_name, y_name = (f"{MEASURES[want].label}, {reading.unit(MEASURES[want].scale)}" for want in wants)
    note = "none of these is better in everything; orange: the one described"
    frame(axes, Panel("The front", note, x=x_name, y=y_name))
    axes.plot(x, y, ".", color=MUTED, markersize=3)
    room_x, room_y = (max(0.16 * float(np.ptp(every)), 1e-3 * abs(float(every[0]))) for every in (x, y))
    axes.set_xlim(x.min() - room_x, x.max() + room_x)
    axes.set_ylim(y.min() - room_y, y.max() + 1.5 * room_y)
    if axes.get_xlim()[0] < now_x < axes.get_xlim()[1] and axes.get_ylim()[0] < now_y < axes.get_ylim()[1]:
        axes.plot(now_x, now_y, "s", color=INK, markersize=6)
        beside(axes, "present", (now_x, now_y), (7, -3), color=INK, size=SMALL)
    else:
        beyond = " and ".join(map(reading.shown, now, scales))
        axes.text(0.01, 0.03, f"the present one lies beyond: {beyond}", transform=axes.transAxes, color=INK, size=SMALL)
    some = sorted({*np.linspace(0, len(x) - 1, min(MOST_BATS, len(x))).round().astype(int).tolist(), design.picked})
    across, up = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
    scale = BAT_LENGTH * across / design.bat.length
    wide = float(np.max(_contour(design.bat)[1]))
    thicker = 1.8 if wide < SLIM * design.bat.length else 1.0  # than true: a slim one, to be seen
    upright = scale * (up / across) * (WIDTH - 2 * SIDE) / FRONT * thicker
    drawn: list[tuple[float, float]] = []
    for row in some:
        if row != design.picked and any(
            abs(x[row] - a) < 0.6 * BAT_LENGTH * across and abs(y[row] - b) < max(0.07 * up, 1.6 * upright * wide)
            for a, b in drawn
        ):
            continue  # one bat would hide another
        drawn.append((float(x[row]), float(y[row])))
        along, half = _contour(design.bench.space.made(design.front.numbers[row], "small"))
        colour = RED if row == design.picked else BLUE
        outline = x[row] + scale * (along - along.max() / 2), y[row] + upright * half
        axes.fill(*outline, color=colour, alpha=0.85, linewidth=0)
        beside(axes, str(row + 1), (x[row], y[row] + upright * wide), (0, 3), ha="center", color=colour, size=SMALL)
