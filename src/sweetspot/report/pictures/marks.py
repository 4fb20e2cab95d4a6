"""Labels on the drawing of a bat: a ladder of sweet spots above it, the zone, balance and hands below it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.report.pictures.ruler import from_the_tip
from sweetspot.report.pictures.style import INK, MUTED, NORMAL, PAPER, SMALL, ZONE_INK
from sweetspot.report.quantities import Reader
from sweetspot.report.sentences import Slot
from sweetspot.report.sport_words import words_of
from sweetspot.report.sweet_spots import SPOTS

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
        dot = 0.0 if analysis.bat.outline is not None else radius * (0.72 - 1.44 * number / (len(marks) - 1))
        colour = SPOTS[mark.field].colour
        ahead = mark in right
        start = column if ahead else mark.place + GAP * scale
        axes.plot(
            [start, mark.place, mark.place], [level, level, dot], color=colour, linewidth=1.1, zorder=3 + number / 100,
            solid_joinstyle="round",
        )  # fmt: skip
        axes.plot(
            mark.place, dot, "o", color=colour, markersize=5.2, markeredgecolor=PAPER, markeredgewidth=0.8, zorder=4
        )
        distance = reading.number(analysis.bat.length - mark.place, "place")
        name = SPOTS[mark.field].labelled(words_of(analysis.bat))
        _label(axes, distance, name, (start, level), scale, ahead=ahead, best=mark.field == "max_exit_speed")
    if right:
        axes.text(
            column - 0.06 * scale, top - 0.5 * ROW * scale, from_the_tip(analysis.bat, reading), ha="right",
            va="center_baseline", color=MUTED, size=SMALL,
        )  # fmt: skip


def _label(
    axes: Axes, distance: str, name: str, at: tuple[float, float], scale: float, *, ahead: bool, best: bool
) -> None:
    place, level = at
    step = 0.06 * scale
    look: dict[str, Any] = {"va": "center_baseline", "color": INK, "size": NORMAL, "zorder": 5}
    weight = "bold" if best else "normal"
    if ahead:
        axes.text(place - step, level, distance, ha="right", weight="bold", **look)
        axes.text(place - step - NUMBER * scale, level, name, ha="right", weight=weight, **look)
    else:
        axes.text(place + step, level, distance, ha="left", weight="bold", **look)
        axes.text(place + step + NUMBER * scale, level, name, ha="left", weight=weight, **look)


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
    balance = f"balance {reading.shown(body.balance_point, 'place')} from the {words_of(bat).butt}"
    quiet: dict[str, Any] = {"va": "center_baseline", "color": MUTED, "size": SMALL}
    told = axes.text(body.balance_point - 0.12 * scale, upper, balance, ha="right", **quiet)
    hands = analysis.conditions.hands.places
    for place in hands:
        reach = float(bat.width_at(place)) / 2 + 0.05 * scale
        axes.plot([place, place], [-reach, reach], color=MUTED, linewidth=1.2, linestyle=(0, (1.5, 1.5)), zorder=3)
    held = axes.text(sum(hands) / 2, upper, words_of(bat).hands, ha="center", **quiet)
    if told.get_window_extent().padded(6).overlaps(held.get_window_extent()):  # a balance point near the hands
        if bat.outline is None:
            told.set(x=body.balance_point + 0.12 * scale, ha="left")
        else:  # where the face lies ahead, and nothing below
            held.set(y=lower)
    note = _inside_note(analysis, reading)
    if note:
        axes.text(body.balance_point - 0.12 * scale, lower, note, ha="right", **quiet)


def _zone(axes: Axes, analysis: Analysis[Implement], reading: Reader, upper: float, lower: float) -> None:
    zone, length, words = analysis.sweet_spots.zone, analysis.bat.length, words_of(analysis.bat)
    look: dict[str, Any] = {"ha": "center", "va": "center_baseline", "size": NORMAL, "zorder": 5}
    if zone is None:
        axes.text(0.8 * length, lower, f"no {words.zone}", color=MUTED, **look)
        return
    axes.annotate(
        "", (zone[0], upper), (zone[1], upper),
        arrowprops={"arrowstyle": "<->", "color": ZONE_INK, "linewidth": 1.0, "shrinkA": 0, "shrinkB": 0,
                    "mutation_scale": 8},
    )  # fmt: skip
    width = reading.shown(zone[1] - zone[0], "place")
    middle, edge = (zone[0] + zone[1]) / 2, 0.93 * length
    if middle > edge:
        look["ha"] = "right"
    axes.text(
        middle if middle <= edge else length, lower, f"{words.zone} {width}", color=ZONE_INK, weight="bold", **look,
    )  # fmt: skip


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
