"""Effects of a hit at every place along the bat, on the same horizontal axis as the bat's drawing."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.answers.report import ReportAnswer
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Band, Curve
from sweetspot.reports.pictures import marks
from sweetspot.reports.pictures.modes import draw_mode
from sweetspot.reports.pictures.panels import DASHED, Panel, band, beside, dot, frame, heading, rows_only, second_scale
from sweetspot.reports.pictures.style import INK, MUTED, SMALL, ZONE, ZONE_EDGE, halo, styled
from sweetspot.reports.quantities import GREEN, ORANGE, PURPLE, RED, SCALES, Reader, Unit
from sweetspot.reports.sentences import Slot
from sweetspot.reports.sport_words import words_of

MODES_SHOWN = 3
KM_H = Unit("km/h", 1 / 3.6, 1)
TRIED = (0.3, 0.55, 0.7, 0.85, 0.97, 0.15, 0.05)
"""Parts of the horizontal axis where a label may stand when its first place is taken."""


@styled
def exit_speed(axes: Axes, report: ReportAnswer, reading: Reader) -> None:
    """Draw the exit speed along the bat: the reader's unit on the left, another on the right, the rigid bat dashed."""
    analysis = report.analysis
    scan, words, unit = analysis.scan, words_of(analysis.bat.sport), reading.units["speed"]
    speed, rigid = scan.exit_speed / unit.size, scan.rigid_exit_speed / unit.size
    note = f"how fast the {words.ball} leaves, for this {words.incoming} and swing"
    _prepare(axes, analysis, reading, words.exit_speed, note, y=unit.name)
    axes.plot(scan.position, rigid, color=MUTED, linewidth=1.2, linestyle=DASHED)
    axes.plot(scan.position, speed, color=RED)
    high = _band(axes, report, report.scan.exit_speed, RED, size=unit.size)
    top = float(np.nanmax(np.concatenate([speed, rigid, high])))
    axes.set_ylim(min(0.0, float(np.nanmin(speed))), 1.22 * top)
    other = KM_H if unit == SCALES["speed"].si else SCALES["speed"].si
    second_scale(axes, unit.size / other.size, other.name)
    spots = analysis.sweet_spots
    best = float(np.interp(spots.max_exit_speed, scan.position, speed))
    dot(axes, spots.max_exit_speed, best, RED, size=5.5)
    label = Slot(report.best_hit.exit_speed, "speed", 1).read(reading)
    place = Slot(analysis.bat.length - report.sweet_spots.max_exit_speed, "place").read(reading)
    start = spots.max_exit_speed - 0.08 * float(np.ptp(axes.get_xlim())), 1.1 * top
    leader = {"arrowstyle": "-", "color": RED, "linewidth": 0.8, "shrinkA": 1, "shrinkB": 3, "relpos": (1, 0.4)}
    label, spot = f"{label}, {place} from the {words.tip}", (spots.max_exit_speed, best)
    axes.annotate(label, spot, start, ha="right", va="center", weight="bold", color=INK, arrowprops=leader)
    rigid_at = 0.97 if marks.is_zoomed(analysis.bat) else 0.42
    curves = {"rigid": (scan.position, rigid), "real": (scan.position, speed)}
    _curve_label(axes, "rigid", curves, f"if the {words.implement} were rigid", at=rigid_at, colour=MUTED, above=True)
    _curve_label(axes, "real", curves, f"this {words.implement}", at=0.42, colour=RED, above=False)


@styled
def efficiency(axes: Axes, report: ReportAnswer, reading: Reader) -> None:
    """Draw the collision efficiency q along the bat, the rigid bat dashed."""
    analysis = report.analysis
    scan, words = analysis.scan, words_of(analysis.bat.sport)
    note = f"what part of its speed a {words.ball} gets back from a {words.implement} at rest"
    _prepare(axes, analysis, reading, words.efficiency, note)
    axes.plot(scan.position, scan.rigid_efficiency, color=MUTED, linewidth=1.2, linestyle=DASHED)
    axes.plot(scan.position, scan.collision_efficiency, color=ORANGE)
    axes.axhline(0, color=MUTED, linewidth=0.7)
    high = _band(axes, report, report.scan.collision_efficiency, ORANGE)
    both = np.concatenate([scan.collision_efficiency, scan.rigid_efficiency, high])
    _limits(axes, both, room=0.14)
    place = analysis.sweet_spots.max_collision_efficiency
    best = float(np.interp(place, scan.position, scan.collision_efficiency))
    dot(axes, place, best, ORANGE, size=5.5)
    most = Slot(report.greatest_efficiency, "ratio").read(reading)
    beside(axes, most, (place, best), (2, -10), ha="right", va="top", weight="bold", path_effects=halo())


@styled
def hand_impulse(axes: Axes, report: ReportAnswer, reading: Reader) -> None:
    """Draw the impulse at the top hand, with its sign: zero at the centre of percussion."""
    analysis = report.analysis
    scan, words = analysis.scan, words_of(analysis.bat.sport)
    title = "Jolt at the top hand" if words.hands == "hands" else "Jolt at the hand"
    note = f"passed on by the {words.implement}'s turning; + handle driven back, \N{MINUS SIGN} pulled forward"
    _prepare(axes, analysis, reading, title, note, y="N s")
    axes.axhline(0, color=MUTED, linewidth=0.7)
    axes.fill_between(scan.position, 0, scan.hand_impulse, color=GREEN, alpha=0.16, linewidth=0)
    axes.plot(scan.position, scan.hand_impulse, color=GREEN)
    _band(axes, report, report.scan.hand_impulse, GREEN)
    _limits(axes, scan.hand_impulse, room=0.3)
    dot(axes, analysis.sweet_spots.center_of_percussion, 0.0, GREEN, size=5.5)


@styled
def sting(axes: Axes, report: ReportAnswer, reading: Reader) -> None:
    """Draw the vibration that the hands feel after a hit."""
    analysis, scan = report.analysis, report.analysis.scan
    note = f"vibration at the {words_of(analysis.bat.sport).hands} right after the hit, as it is felt"
    _prepare(axes, analysis, reading, "sting", note, y="m/s")
    axes.fill_between(scan.position, 0, scan.sting, color=PURPLE, alpha=0.18, linewidth=0)
    axes.plot(scan.position, scan.sting, color=PURPLE)
    high = _band(axes, report, report.scan.sting, PURPLE)
    axes.set_ylim(0, 1.14 * float(np.nanmax(np.concatenate([scan.sting, high]))))
    place = analysis.sweet_spots.min_sting
    dot(axes, place, float(np.interp(place, scan.position, scan.sting)), PURPLE, size=5.5)


@styled
def mode_shapes(axes: Axes, report: ReportAnswer, reading: Reader) -> None:
    """Draw how the bat bends in its first modes, each on its own line, nodes as dots."""
    analysis = report.analysis
    bat, modes = analysis.bat, analysis.modes
    tones = [mode.frequency for mode in report.modes if mode.family == "bending"]
    marks.set_limits(axes, bat.length)
    hands = analysis.conditions.hands
    held = "held" if any((hands.mass, hands.stiffness, hands.damping)) else "free"
    tool = words_of(bat.sport).implement
    marks.show_from_tip(axes, bat.length, reading, labels=False)
    heading(axes, "Bending modes", f"how the {held} {tool} rings; a hit at a node does not ring that mode")
    rows_only(axes)
    places = np.linspace(0, bat.length, 200)
    bending = modes.of_family("bending")[:MODES_SHOWN]
    for row, index in enumerate(bending):
        rings = Slot(tones[row], "frequency").read(reading).replace(" ± ", "\n± ").replace(" (", "\n(")
        draw_mode(axes, modes, index, row, places, rings)
    axes.set_ylim(-len(bending) + 0.45, 0.55)


def _band(axes: Axes, report: ReportAnswer, curve: Curve, colour: str, *, size: float = 1.0) -> Array:
    """Draw the interval around a curve of the scan as a band, and return its upper end; empty where there is none."""
    if not isinstance(curve, Band):
        return np.zeros(0)
    band(axes, report.scan.position, curve.low / size, curve.high / size, colour)
    return np.asarray(curve.high / size)


def _prepare(axes: Axes, analysis: Analysis[Implement], reading: Reader, title: str, note: str, y: str = "") -> None:
    marks.set_window(axes, analysis.bat)
    marks.show_from_tip(axes, analysis.bat.length, reading, labels=marks.is_zoomed(analysis.bat), grid=True)
    if marks.is_zoomed(analysis.bat):
        draw_guides(axes, analysis)
    frame(axes, Panel(title[0].upper() + title[1:], note, y=y, grid="y", ticks=4))


def draw_guides(axes: Axes, analysis: Analysis[Implement]) -> None:
    """Shade the sweet zone and mark the best place in a panel whose axis is not that of the drawing above."""
    spots = analysis.sweet_spots
    if spots.zone is not None:
        axes.axvspan(*spots.zone, facecolor=ZONE, edgecolor=ZONE_EDGE, linewidth=0.6, zorder=0)
    axes.axvline(spots.max_exit_speed, color=RED, linewidth=0.7, alpha=0.55, zorder=1)


def _limits(axes: Axes, values: Array, *, room: float) -> None:
    """Let the vertical axis hold all values and zero, and a little room."""
    low, high = min(0.0, float(np.nanmin(values))), max(0.0, float(np.nanmax(values)))
    axes.set_ylim(low - room * (high - low) * (low < 0), high + room * (high - low))


def _curve_label(
    axes: Axes, name: str, curves: Mapping[str, tuple[Array, Array]], words: str, *, at: float, colour: str, above: bool
) -> None:
    """Write beside a curve what it is, where nothing else stands.

    Parameters
    ----------
    name : of the curve in ``curves``, which hold places and values.
    at : part of the horizontal axis where it is tried first.
    above : on which side of the curve it is tried first.
    """
    places, values = curves[name]
    taken = [Text.get_window_extent(text).padded(1) for text in axes.texts]
    fine = np.linspace(places[0], places[-1], 8 * len(places))  # where a curve is steep its own points lie far apart
    lines = [axes.transData.transform(np.column_stack([fine, np.interp(fine, *curve)])) for curve in curves.values()]
    least, clearest = np.inf, None
    for part in (at, *TRIED):
        for over in (above, not above):
            place = axes.get_xlim()[0] + part * (axes.get_xlim()[1] - axes.get_xlim()[0])
            place = float(np.clip(place, places[0], places[-1]))
            aside, side, upright = ((-4, 3), "right", "bottom") if over else ((4, -3), "left", "top")
            at_curve = (place, float(np.interp(place, places, values)))
            text = beside(axes, words, at_curve, aside, ha=side, va=upright, size=SMALL)
            box = Text.get_window_extent(text).padded(3)
            outside = not (axes.bbox.x0 <= box.x0 and box.x1 <= axes.bbox.x1 and axes.bbox.y0 <= box.y0)
            faults = 100 * sum(box.overlaps(other) for other in taken) + 50 * outside
            faults += sum(int(np.sum(np.all((line > box.min) & (line < box.max), axis=1))) for line in lines)
            worse = text if faults >= least else clearest
            least, clearest = (least, clearest) if faults >= least else (faults, text)
            if worse is not None:
                worse.remove()
        if least == 0:
            break
    if clearest is not None:
        clearest.set(color=colour, path_effects=halo())
