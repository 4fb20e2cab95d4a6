"""The main picture of a report: the bat, and below it the effect of a hit at each place."""

from __future__ import annotations

import textwrap

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.answers.report import ReportAnswer
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
from sweetspot.reports.pictures.panels import Page
from sweetspot.reports.pictures.style import HUGE, MUTED, NORMAL, SHEET, SMALL, ZONE, ZONE_EDGE, fitted, styled
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
    zoomed, foot_of_bat = marks.is_zoomed(bat), HEADER + panel.height + RULER
    between = BETWEEN + (ZOOMED if zoomed else 0.0)
    page = Page(WIDTH, foot_of_bat + sum(between + tall for _, tall in PANELS) + FOOTER, SIDE)
    _header(page, report, reading)
    axes, top = page.panel(HEADER, panel.height), foot_of_bat
    draw_bat_panel(axes, analysis, panel, reading)
    for draw, tall in PANELS:
        axes = page.panel(top + between, tall)
        draw(axes, report, reading)
        top += between + tall
    marks.show_from_tip(axes, bat.length, reading)
    axes.set_xlabel(from_the_tip(analysis.bat, reading), labelpad=2)
    marks.show_centimetres(axes, bat.length, offset=30, butt=bat.grip_end)
    if not zoomed:
        _guides(page, analysis, bat_top=HEADER + ABOVE - GUIDE_START, top=foot_of_bat, bottom=top)
    words = words_of(bat.sport)
    lines = what_lines_are(analysis, banded=report.uncertainty is not None)
    page.foot(f"{lines}\nFree {words.implement}, {analysis.conditions.ball.name}, hit straight on.", 0.08)
    return page.figure


def _header(page: Page, report: ReportAnswer, reading: Reader) -> None:
    """Write the bat's name, its sizes and the answer."""
    bat, conditions = report.analysis.bat, report.analysis.conditions
    words, swing = words_of(bat.sport), conditions.swing
    speed = Slot(report.best_hit.exit_speed, "speed", digits=0).read(reading)
    page.write(speed, 0.45, right=True, size=HUGE, weight="bold", color=RED)
    page.title(bat.name, down=0.45, beside=SPEED_ROOM)
    mass = Slot(report.bat.mass, "mass").read(reading)
    sizes = f"{reading.shown(bat.length, 'length')}  ·  {mass}  ·  {read(made_of_words(bat), reading)}"
    sizes, size = fitted(sizes, width=page.across - SWING_ROOM, size=NORMAL, smallest=SMALL, bold=False)
    page.write(sizes, 0.68, color=MUTED, size=size)
    page.write(_swing_weight(report, reading), 0.86, color=MUTED, size=NORMAL)
    swung = f"{arriving(words, conditions.pitch.speed).read(reading)}, {words.implement} at "
    page.write(swung + reading.shown(swing.bat_speed, "speed"), 0.68, right=True, color=MUTED, size=NORMAL)
    measured_at = f"{reading.shown(bat.length - swing.measured_at, 'place')} from the {words.tip}"
    page.write(measured_at, 0.86, right=True, color=MUTED, size=NORMAL)


def _swing_weight(report: ReportAnswer, reading: Reader) -> str:
    """Return the swing weight as the sport defines it."""
    bat = report.analysis.bat
    if report.swing_weight is None:
        moi = moment(report.bat.moi_6in, float(report.bat.moi_6in_doubt)).read(reading)
        axis = reading.shown(STANDARD_AXIS, "place")
        return f"moment of inertia {moi} about {axis} from the {words_of(bat.sport).butt}"
    return f"{report.swing_weight.name} {report.swing_weight.text}".replace("^2", "²")


def _guides(page: Page, analysis: Analysis[Implement], *, bat_top: float, top: float, bottom: float) -> None:
    """Run the sweet zone from the bat and the best place from below it down the paper, in inches from its top."""
    bat, spots = analysis.bat, analysis.sweet_spots
    start, span = -marks.MARGIN * bat.length, (1 + 2 * marks.MARGIN) * bat.length

    def across(place: float) -> float:
        return (page.side + page.across * (place - start) / span) / page.width

    low, high = 1 - bottom / page.height, 1 - bat_top / page.height
    if spots.zone is not None:
        left, right = across(spots.zone[0]), across(spots.zone[1])
        zone = Rectangle((left, low), right - left, high - low, transform=page.figure.transFigure, gid="zone")
        zone.set(facecolor=ZONE, edgecolor=ZONE_EDGE, linewidth=0.6, zorder=-2)
        page.figure.add_artist(zone)
    best, foot = across(spots.max_exit_speed), 1 - top / page.height
    line = Line2D([best, best], [low, foot], color=RED, linewidth=0.7, alpha=0.55, zorder=-1, gid="best")
    page.figure.add_artist(line)


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
    deep = [sum(tall + between for _, tall in SHEET_PANELS[: number + 1]) for number in range(len(SHEET_PANELS))]
    panels = SHEET_PANELS[: max(1, sum(needed <= room for needed in deep))]
    height = panel.height + RULER + sum(tall + between for _, tall in panels) + SHEET_FOOT
    page = Page(SHEET, height, SHEET_SIDE)
    axes = page.panel(0.0, panel.height, left=side, width=across)
    draw_bat_panel(axes, analysis, panel, reading)
    shade_zone(axes, analysis, panel)
    top = panel.height + RULER
    for draw, tall in panels:
        top += between
        axes = page.panel(top, tall, left=side, width=across)
        draw(axes, report, reading)
        if not zoomed:
            along.draw_guides(axes, analysis)
        top += tall
    marks.show_from_tip(axes, bat.length, reading)
    axes.set_xlabel(marks.from_the_tip(bat, reading), labelpad=2)
    page.foot(textwrap.fill(what_lines_are(analysis, banded=banded), LINE), 0.04)
    return page.figure
