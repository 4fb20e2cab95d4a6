"""One picture of a tap test: the recording with its taps, the spectrum with its modes, and the decay of each."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Annotation, Text
from matplotlib.transforms import Bbox

from sweetspot.calibration.mode_naming import NamedTone
from sweetspot.calibration.sinusoids import Fit
from sweetspot.calibration.tap_analysis import TapTest, spectrum, waveform
from sweetspot.reports.pictures.panels import SPARSE, Page, Panel, beside, frame
from sweetspot.reports.pictures.style import INK, MUTED, PAPER, SMALL, styled
from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, US, Reader
from sweetspot.units import grouped

WIDTH, HEIGHT, SIDE, HEADER = 8.0, 7.6, 0.75, 0.95
"""Inches of paper."""
COLOURS = (RED, BLUE, GREEN, PURPLE)
"""Of the tones whose decay is drawn, the lowest."""
NEAR = 0.01
"""Of the highest tone: a label stands above all of the spectrum this near to its peak."""
TOP = 30
"""dB: upper end of the spectrum, which leaves room for labels above those in their way."""


@styled
def tap_figure(test: TapTest, title: str, reading: Reader = US) -> Figure:  # noqa: ARG001 - it has one set of units
    """Return the figure of a tap test; spectrum and decay are those of the first good tap."""
    page, across = Page(WIDTH, HEIGHT, SIDE), WIDTH - 1.5 * SIDE
    page.title(title, down=0.45)
    _waveform(page.panel(HEADER, 1.2, width=across), test)
    fit = next(tap.fit for tap in test.taps if tap.good and tap.fit is not None)
    _spectrum(page.panel(HEADER + 1.9, 2.2, width=across), test, fit)
    _decay(page.panel(HEADER + 4.9, 1.3, width=across), test, fit)
    return page.figure


def _waveform(axes: Axes, test: TapTest) -> None:
    """Draw the recording with the first good tap, and where its taps begin."""
    name = next(tap.recording for tap in test.taps if tap.good)
    recording = next(recording for recording in test.recordings if recording.name == name)
    note = "green: taps that were used; orange: not used"
    frame(axes, Panel("The recording", note, x="s", y="of full scale", grid="none"))
    axes.fill_between(*waveform(recording), color=MUTED, linewidth=0.3)
    for tap in test.taps:
        if tap.recording == name:
            axes.axvline(tap.start, color=GREEN if tap.good else ORANGE, linewidth=1.2)
    axes.set_xlim(0, recording.duration)


def _spectrum(axes: Axes, test: TapTest, fit: Fit) -> None:
    expected = [mode for family in test.expected if np.isfinite(family.spread) for mode in family.frequency]
    note = "dashed: the modelled modes; words: the tones found" if expected else "the tones found"
    frame(axes, Panel("What rings", note, x="Hz", y="dB"))
    frequency, level = spectrum(fit)
    axes.plot(frequency, level, color=INK, linewidth=0.7)
    for mode in expected:
        axes.axvline(mode, color=MUTED, linewidth=0.7, linestyle=(0, (3, 3)), zorder=0)
    highest = max(named.tone.frequency.value for named in test.tones)
    axes.set(xlim=(0, 1.15 * highest), ylim=(-75, TOP))
    taken: list[Bbox] = []
    for named, colour in sorted(_coloured(test), key=lambda pair: (pair[0].name is None, -pair[0].tone.level)):
        tone = named.tone.frequency.value
        words = f"{named.name}\n{grouped(tone, 1)} Hz" if named.name else f"{grouped(tone)} Hz"
        peak = float(level[np.abs(frequency - tone) < NEAR * highest].max())
        taken += _labelled(axes, words, (tone, peak), colour, taken)


def _labelled(axes: Axes, words: str, peak: tuple[float, float], colour: str, taken: list[Bbox]) -> list[Bbox]:
    """Write a label above its peak, higher where another is in the way, and return its box; none: no place is left."""
    room = axes.get_window_extent()
    look = {"ha": "center", "va": "bottom", "size": SMALL - 1, "color": colour, "parse_math": False}
    box = {"facecolor": PAPER, "edgecolor": "none", "pad": 0.6}
    leader = {"arrowstyle": "-", "color": colour, "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0}
    label = beside(axes, words, peak, (0, 4), bbox=box, arrowprops=leader, **look)
    dots = axes.figure.dpi / 72
    right, up = max(0.0, room.x0 + 2 - _words_box(label).x0) / dots, 4.0
    label.set(position=(right, up))
    while any(_words_box(label).padded(1).overlaps(other) for other in taken) and _words_box(label).y1 < room.y1:
        up += 2.0
        label.set(position=(right, up))
    place = _words_box(label)
    if place.y1 < room.y1 and not any(place.padded(1).overlaps(other) for other in taken):
        return [place]
    label.remove()
    return []


def _words_box(label: Annotation) -> Bbox:
    """Return the box of a label's words, without the line that leads to them."""
    label.get_window_extent()  # which also puts the words in their place
    return Text.get_window_extent(label)


def _decay(axes: Axes, test: TapTest, fit: Fit) -> None:
    """Draw the amplitude of the tones that have colours as they decay: heard (line) and fitted (dashes)."""
    note = "amplitude of the coloured tones, heard (line) and fitted (dashes)"
    frame(axes, Panel("How long it rings", note, x="s after the tap", y="of full scale"))
    time = np.arange(len(fit.samples)) / fit.rate
    for named, colour in [entry for entry in _coloured(test) if entry[1] in COLOURS]:
        tone, ratio = named.tone.frequency.value, named.tone.damping_ratio.value
        mine = min(fit.sinusoids, key=lambda sinusoid, tone=tone: abs(sinusoid.frequency.value - tone))  # type: ignore[misc]
        width = max(int(0.008 * fit.rate), int(4 * fit.rate / tone))
        turning = fit.samples * np.exp(-2j * np.pi * tone * time)
        heard = 2 * np.abs(np.convolve(turning, np.hanning(width + 2) / np.hanning(width + 2).sum(), "same"))
        label = str(named.name or f"{grouped(tone)} Hz")
        axes.semilogy(time[width:-width], heard[width:-width], color=colour, linewidth=0.9, label=label)
        fitted = mine.amplitude * np.exp(-2 * np.pi * tone * ratio * time)
        axes.semilogy(time, fitted, color=colour, linewidth=0.9, linestyle=SPARSE)
    top = max(sinusoid.amplitude for sinusoid in fit.sinusoids)
    axes.set(xlim=(0, time[-1]), ylim=(1e-3 * top, 40 * top))  # room for the legend above the curves
    axes.legend(loc="upper right", fontsize=SMALL - 1, frameon=False, ncols=3)


def _coloured(test: TapTest) -> list[tuple[NamedTone, str]]:
    """Return every tone with a colour: those whose decay is drawn have their own, the lowest with a name.

    Where none has a name, those are the lowest that are surely the body's.
    """
    named = [named for named in test.tones if named.name] or [named for named in test.tones if named.tone.distinct]
    colours = dict(zip(map(id, named), COLOURS, strict=False))
    return [(named, colours.get(id(named), INK if named.name else MUTED)) for named in test.tones]
