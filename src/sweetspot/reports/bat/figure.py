"""The main picture of a report: the bat, and below it the effect of a hit at each place."""

from __future__ import annotations

import textwrap
from typing import Any

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.answers.report import ReportAnswer
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.reports.bat import along_picture as along
from sweetspot.reports.bat.outline_picture import (
    ABOVE,
    GUIDE_START,
    RULER,
    SIDE,
    WIDTH,
    bat_panel,
    draw_bat_panel,
    shade_zone,
)
from sweetspot.reports.bat.tables import moment
from sweetspot.reports.pictures import marks
from sweetspot.reports.pictures.marks import from_the_tip
from sweetspot.reports.pictures.style import (
    HUGE,
    MUTED,
    NORMAL,
    SHEET,
    SMALL,
    ZONE,
    ZONE_EDGE,
    axes_in_inches,
    fitted,
    styled,
)
from sweetspot.reports.quantities import RED, Reader
from sweetspot.reports.sentences import Slot, read
from sweetspot.reports.sport_words import arriving, made_of_words, reader_of, words_of

HEADER, FOOTER, BETWEEN = 1.0, 1.15, 0.34
"""Inches of paper for the title, the rulers at the foot, and between panels."""
ZOOMED = 0.2
"""Inches more between panels that have numbers of their own on their axes."""
SPEED_ROOM, SWING_ROOM = 1.5, 2.4
"""Inches of paper for the speed beside the title, and for the swing below it."""
PANELS = (
    (along.exit_speed, 1.65),
    (along.efficiency, 1.1),
    (along.hand_impulse, 1.1),
    (along.sting, 1.0),
    (along.mode_shapes, 1.45),
)
"""Every panel below the bat and its height in inches of paper."""


@styled
def report_figure(report: ReportAnswer, reading: Reader | None = None) -> Figure:
    """Return the tall figure: title, bat to scale, then exit speed, q, jolt, sting and modes on the same axis."""
    analysis = report.analysis
    bat, panel, reading = analysis.bat, bat_panel(analysis.bat), reading or reader_of(analysis.bat.sport)
    across = WIDTH - 2 * SIDE
    height = (
        HEADER
        + panel.height
        + RULER
        + sum(BETWEEN + tall for _, tall in PANELS)
        + (ZOOMED * len(PANELS) if marks.is_zoomed(bat) else 0.0)
        + FOOTER
    )
    figure = Figure(figsize=(WIDTH, height))
    _header(figure, report, reading, height)
    top = HEADER
    axes = axes_in_inches(figure, left=SIDE, top=top, width=across, height=panel.height)
    draw_bat_panel(axes, analysis, panel, reading)
    top += panel.height + RULER
    zoomed = marks.is_zoomed(bat)
    between = BETWEEN + (ZOOMED if zoomed else 0.0)
    for draw, tall in PANELS:
        top += between
        axes = axes_in_inches(figure, left=SIDE, top=top, width=across, height=tall)
        draw(axes, report, reading)
        top += tall
    marks.show_from_tip(axes, bat.length, reading)
    axes.set_xlabel(from_the_tip(analysis.bat, reading), labelpad=2)
    marks.show_centimetres(axes, bat.length, offset=30, butt=bat.grip_end)
    foot_of_bat = HEADER + panel.height + RULER
    if not zoomed:
        _guides(figure, analysis, height, bat_top=HEADER + ABOVE - GUIDE_START, top=foot_of_bat, bottom=top)
    _footer(figure, analysis, height, banded=report.uncertainty is not None)
    return figure


def _header(figure: Figure, report: ReportAnswer, reading: Reader, height: float) -> None:
    """Write the bat's name, its sizes and the answer."""
    bat, conditions = report.analysis.bat, report.analysis.conditions
    left, right = SIDE / WIDTH, 1 - SIDE / WIDTH
    words = words_of(bat.sport)
    speed = Slot(report.best_hit.exit_speed, "speed", digits=0).read(reading)
    figure.text(right, 1 - 0.45 / height, speed, size=HUGE, weight="bold", color=RED, ha="right")
    name, size = fitted(bat.name, width=WIDTH - 2 * SIDE - SPEED_ROOM, size=HUGE)
    figure.text(left, 1 - 0.45 / height, name, size=size, weight="bold", parse_math=False)
    quiet: dict[str, Any] = {"color": MUTED, "size": NORMAL, "parse_math": False}
    mass = Slot(report.bat.mass, "mass").read(reading)
    sizes = f"{reading.shown(bat.length, 'length')}  ·  {mass}  ·  {read(made_of_words(bat), reading)}"
    sizes, size = fitted(sizes, width=WIDTH - 2 * SIDE - SWING_ROOM, size=NORMAL, smallest=SMALL, bold=False)
    figure.text(left, 1 - 0.68 / height, sizes, **{**quiet, "size": size})
    figure.text(left, 1 - 0.86 / height, _swing_weight(report, reading), **quiet)
    swing = conditions.swing
    swung = f"{arriving(words, conditions.pitch.speed).read(reading)}, {words.implement} at "
    swung += reading.shown(swing.bat_speed, "speed")
    figure.text(right, 1 - 0.68 / height, swung, ha="right", **quiet)
    at = f"{reading.shown(bat.length - swing.measured_at, 'place')} from the {words.tip}"
    figure.text(right, 1 - 0.86 / height, at, ha="right", **quiet)


def _swing_weight(report: ReportAnswer, reading: Reader) -> str:
    """Return the swing weight as the sport defines it."""
    bat = report.analysis.bat
    if isinstance(bat, Bat):
        moi = moment(report.bat.moi_6in, float(report.bat.moi_6in_doubt)).read(reading)
        return (
            f"moment of inertia {moi} about {reading.shown(STANDARD_AXIS, 'place')} from the {words_of(bat.sport).butt}"
        )
    convention = swing_weight(bat.sport)
    return f"{convention.name} {convention.text_of(report.analysis.body)}".replace("^2", "²")


def _guides(
    figure: Figure, analysis: Analysis[Implement], height: float, *, bat_top: float, top: float, bottom: float
) -> None:
    """Run the sweet zone from the bat and the best place from below it down the paper, in inches from its top."""
    bat, spots = analysis.bat, analysis.sweet_spots
    start, span = -marks.MARGIN * bat.length, (1 + 2 * marks.MARGIN) * bat.length

    def across(place: float) -> float:
        return (SIDE + (WIDTH - 2 * SIDE) * (place - start) / span) / WIDTH

    low, high = 1 - bottom / height, 1 - bat_top / height
    if spots.zone is not None:
        left, right = across(spots.zone[0]), across(spots.zone[1])
        figure.add_artist(
            Rectangle((left, low), right - left, high - low, facecolor=ZONE, edgecolor=ZONE_EDGE, linewidth=0.6,
                      zorder=-2, transform=figure.transFigure, gid="zone")
        )  # fmt: skip
    best = across(spots.max_exit_speed)
    figure.add_artist(
        Line2D([best, best], [low, 1 - top / height], color=RED, linewidth=0.7, alpha=0.55, zorder=-1, gid="best")
    )


def _footer(figure: Figure, analysis: Analysis[Implement], height: float, *, banded: bool) -> None:
    """Write the conditions and the legend of the lines."""
    words = words_of(analysis.bat.sport)
    text = f"{what_lines_are(analysis, banded=banded)}\nFree {words.implement}, {analysis.conditions.ball.name}, hit "
    figure.text(SIDE / WIDTH, 0.08 / height, text + "straight on.", color=MUTED, size=SMALL, parse_math=False)


def what_lines_are(analysis: Analysis[Implement], *, banded: bool) -> str:
    """Return the legend of the shading, bands and lines of a report's picture."""
    words = words_of(analysis.bat.sport)
    shaded = "" if analysis.sweet_spots.zone is None else f"Shaded: {words.zone}.  "
    bands = "Bands: 90 % intervals.  " if banded else ""
    near = "  Panels: the face alone." if marks.is_zoomed(analysis.bat) else ""
    strung = isinstance(analysis.bat, Racket) and analysis.bat.strings is not None
    rigid = f"the same {words.implement} if it were rigid" + (", strings too" if strung else "")
    frame = f"  Steps at the ends: the {words.ball} is on the frame." if strung else ""
    return f"{shaded}{bands}Orange line: best place.  Dashed: {rigid}.{near}{frame}"


SHEET_SIDE, SHEET_BETWEEN, SHEET_ZOOMED, SHEET_FOOT = 0.66, 0.3, 0.2, 0.62
"""Inches of paper: beside the axes, between panels, more of it where panels have numbers of their own, at the foot."""
SHEET_PANELS = ((along.exit_speed, 1.0), (along.sting, 0.52), (along.hand_impulse, 0.52))
"""The panels, the most asked for first, and their height in inches of paper."""
ROOM, ROOM_BESIDE_DOUBT = 6.4, 5.3
"""Inches of paper that the words leave, and that they leave where the sheet also says how sure it is."""
NARROW = 0.75
"""Of the sheet's width, where a face would else be too high for it."""
LINE = 112
"""Letters of small print in a line."""


@styled
def sheet_figure(report: ReportAnswer, reading: Reader) -> Figure:
    """Return bat and curves in letters that can be read on paper; the page around them says whose they are."""
    analysis, banded = report.analysis, report.uncertainty is not None
    bat = analysis.bat
    zoomed = marks.is_zoomed(bat)
    between = SHEET_BETWEEN + (SHEET_ZOOMED if zoomed else 0.0)
    room = (ROOM_BESIDE_DOUBT if banded else ROOM) - RULER - SHEET_FOOT
    across = SHEET - 2 * SHEET_SIDE
    panel = bat_panel(bat, across)
    if panel.height > room - SHEET_PANELS[0][1] - between:  # a face as wide as the sheet is high
        across *= NARROW
        panel = bat_panel(bat, across)
    room, side = room - panel.height, (SHEET - across) / 2
    panels = [each for number, each in enumerate(SHEET_PANELS, 1)
             if number == 1 or sum(tall + between for _, tall in SHEET_PANELS[:number]) <= room]  # fmt: skip
    height = panel.height + RULER + sum(tall + between for _, tall in panels) + SHEET_FOOT
    figure = Figure(figsize=(SHEET, height))
    axes = axes_in_inches(figure, left=side, top=0.0, width=across, height=panel.height)
    draw_bat_panel(axes, analysis, panel, reading)
    shade_zone(axes, analysis, panel)
    top = panel.height + RULER
    for draw, tall in panels:
        top += between
        axes = axes_in_inches(figure, left=side, top=top, width=across, height=tall)
        draw(axes, report, reading)
        if not zoomed:
            along.draw_guides(axes, analysis)
        top += tall
    marks.show_from_tip(axes, bat.length, reading)
    axes.set_xlabel(marks.from_the_tip(bat, reading), labelpad=2)
    meaning = textwrap.fill(what_lines_are(analysis, banded=banded), LINE)
    figure.text(SHEET_SIDE / SHEET, 0.04 / height, meaning, color=MUTED, size=SMALL, parse_math=False)
    return figure
