"""The picture of a report for a printed sheet: the bat, and as many curves below it as the sheet has room for."""

from __future__ import annotations

import textwrap

from matplotlib.figure import Figure

from sweetspot.answers.report import ReportAnswer
from sweetspot.report.bat import along_picture as along
from sweetspot.report.bat.figure import what_lines_are
from sweetspot.report.bat.outline_picture import RULER, bat_panel, draw_bat_panel, shade_zone
from sweetspot.report.pictures import ruler
from sweetspot.report.pictures.style import MUTED, SHEET, SMALL, axes_in_inches, styled
from sweetspot.report.quantities import Reader

SIDE, BETWEEN, ZOOMED, FOOT = 0.66, 0.3, 0.2, 0.62
"""Inches of paper: beside the axes, between panels, more of it where panels have numbers of their own, at the foot."""
PANELS = ((along.exit_speed, 1.0), (along.sting, 0.52), (along.hand_impulse, 0.52))
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
    zoomed = ruler.is_zoomed(bat)
    between = BETWEEN + (ZOOMED if zoomed else 0.0)
    room = (ROOM_BESIDE_DOUBT if banded else ROOM) - RULER - FOOT
    across = SHEET - 2 * SIDE
    panel = bat_panel(bat, across)
    if panel.height > room - PANELS[0][1] - between:  # a face as wide as the sheet is high
        across *= NARROW
        panel = bat_panel(bat, across)
    room, side = room - panel.height, (SHEET - across) / 2
    shown = [one for number, one in enumerate(PANELS, 1)
             if number == 1 or sum(tall + between for _, tall in PANELS[:number]) <= room]  # fmt: skip
    height = panel.height + RULER + sum(tall + between for _, tall in shown) + FOOT
    figure = Figure(figsize=(SHEET, height))
    axes = axes_in_inches(figure, left=side, top=0.0, width=across, height=panel.height)
    draw_bat_panel(axes, analysis, panel, reading)
    shade_zone(axes, analysis, panel)
    top = panel.height + RULER
    for draw, tall in shown:
        top += between
        axes = axes_in_inches(figure, left=side, top=top, width=across, height=tall)
        draw(axes, report, reading)
        if not zoomed:
            along.draw_guides(axes, analysis)
        top += tall
    ruler.show_from_tip(axes, bat.length, reading)
    axes.set_xlabel(ruler.from_the_tip(bat, reading), labelpad=2)
    meaning = textwrap.fill(what_lines_are(analysis, banded=banded), LINE)
    figure.text(SIDE / SHEET, 0.04 / height, meaning, color=MUTED, size=SMALL, parse_math=False)
    return figure
