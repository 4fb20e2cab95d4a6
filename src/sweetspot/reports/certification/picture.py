"""A bat test in one picture: what the rules limit, along the barrel, the limits, and the best place."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.analysis.certification.rules import NOT_SURE, Verdict
from sweetspot.analysis.certification.shot_statistics import ShotStatistics
from sweetspot.analysis.certification.simulated_test import BatTest
from sweetspot.answers.certify import CertifyAnswer
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.marks import from_the_tip
from sweetspot.reports.pictures.panels import Page, Panel, beside, dot, frame, roomy
from sweetspot.reports.pictures.style import INK, MUTED, SHEET, SMALL, halo, styled
from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, RED, SKY, US, Reader

SIDE = 0.62
"""Inches of paper beside the panel."""
ALONE, ON_A_SHEET = (8.0, 1.05, 2.6, 0.95), (SHEET, 0.25, 1.4, 0.68)
"""Inches of paper: page, title, the panel, the foot; on a sheet the page says whose test it is."""
ROOM = 0.12
"""Part of the panel's range left free above and below."""
COLOURS = {Verdict.PASS: GREEN, Verdict.FAIL: ORANGE}
VERBS = {
    Verdict.PASS: ("passes", "pass"),
    Verdict.FAIL: ("fails", "fail"),
    Verdict.NOT_APPLICABLE: ("does not apply", "do not apply"),
}
KINDS = {
    True: "Computed. Band: what the ball's patch and its law leave open. Orange dot: the best place.",
    False: "Measured: each dot is a place, the mean of its shots. Orange dot: the best place.",
}
"""The small print, of a simulated test and of shots."""


@dataclass(frozen=True)
class _Curve:
    """What is drawn: a measure along the barrel, its band, and its best place, SI."""

    measure: str
    position: Array
    value: Array
    low: Array
    high: Array
    best: tuple[float, float]


@styled
def certification_figure(
    answer: CertifyAnswer, reading: Reader = US, *, paper: tuple[float, float, float, float] = ALONE
) -> Figure:
    """Return the figure of a test from the model or from shots."""
    width, header, tall, footer = paper
    page, simulated = Page(width, header + tall + footer, SIDE), answer.test is not None
    if paper == ALONE:
        page.title(answer.bat.name, f"{answer.ball}. {_verdicts(answer)}")
    curve, inch = _curve(answer), reading.units["place"].size
    axes = page.panel(header, tall)
    note = "along the barrel, on a bat at rest; the scale does not begin at 0"
    frame(axes, Panel(curve.measure.upper(), note, x=from_the_tip(answer.implement, reading)))
    from_tip = (answer.implement.length - curve.position) / inch
    if simulated:
        axes.fill_between(from_tip, curve.low, curve.high, color=SKY, alpha=0.35, linewidth=0)
        axes.plot(from_tip, curve.value, color=BLUE)
    else:
        axes.plot(from_tip, curve.value, "o", color=BLUE, markersize=4)
    limits = _limits(answer, curve.measure)
    axes.set_ylim(*roomy([*curve.low, *curve.high, *curve.value, *(limit for _, limit, _ in limits)], ROOM, 2 * ROOM))
    axes.set_xlim(*roomy(from_tip, 0.04, 0.04, least=1 / 0.04)[::-1])
    _draw_limits(axes, limits)
    place, value = (answer.implement.length - curve.best[0]) / inch, curve.best[1]
    dot(axes, place, value, RED, size=6)
    look = {"color": INK, "weight": "bold", "ha": "center", "va": "top", "path_effects": halo()}
    beside(axes, f"{value:.3f}", (place, value), (0, -8), **look)
    page.foot(KINDS[simulated], 0.12 if paper == ALONE else 0.03)
    return page.figure


def certification_sheet(answer: CertifyAnswer, reading: Reader = US) -> Figure:
    """Return the figure for a printed sheet, whose page says whose test it is."""
    return certification_figure(answer, reading, paper=ON_A_SHEET)


def _verdicts(answer: CertifyAnswer) -> str:
    """Return how many rules a bat keeps and breaks."""
    verdicts = "; ".join(
        _counted(count, verdict, doubt)
        for verdict, doubt in product(Verdict, ("", NOT_SURE))
        if (count := sum(check.outcome.words == f"{verdict}{doubt}" for check in answer.checks))
    )
    return f"Rules: {verdicts}." if verdicts else "No rules were held against it."


def _counted(count: int, verdict: Verdict, doubt: str) -> str:
    singular, plural = VERBS.get(verdict, (verdict.value, verdict.value))
    return f"{count} {singular if count == 1 else plural}{doubt}"


def _curve(answer: CertifyAnswer) -> _Curve:
    """Return the curve to draw: the measure that the rules limit, else BBCOR."""
    asked = {check.quantity for check in answer.checks if check.most is not None}
    test = answer.result
    if isinstance(test, ShotStatistics):
        places = np.array([place.position for place in test.places])
        values = np.array([place.bbcor for place in test.places])
        return _Curve("bbcor", places, values, values, values, (test.best_position, test.bbcor.mean))
    measure = "bpf" if "bpf" in asked and "bbcor" not in asked else "bbcor"
    tests = [(test.slow if measure == "bpf" else test.fast)]
    tests += [slow if measure == "bpf" else fast for fast, slow in (*test.other_patches, *test.other_laws)]
    curves = np.array([_values(each, measure) for each in tests])
    best = tests[0].best_position, test.bpf if measure == "bpf" else test.bbcor
    return _Curve(measure, tests[0].position, curves[0], curves.min(axis=0), curves.max(axis=0), best)


def _values(test: BatTest, measure: str) -> Array:
    return test.bbcor / test.ball_restitution if measure == "bpf" else test.bbcor


def _limits(answer: CertifyAnswer, measure: str) -> list[tuple[str, float, str]]:
    """Return the leagues that limit a measure, the limit, and its colour; leagues with one limit share a line."""
    limits: dict[float, tuple[list[str], str]] = {}
    for check in answer.checks:
        if check.quantity == measure and check.most is not None:
            names, _ = limits.setdefault(check.most, ([], COLOURS[check.outcome.verdict] if check.sure else MUTED))
            names.append(check.league)
    return [(", ".join(names), limit, colour) for limit, (names, colour) in limits.items()]


def _draw_limits(axes: Axes, limits: list[tuple[str, float, str]]) -> None:
    """Draw each limit as a line with its league: the lowest named below its line, the others above, side by side."""
    for number, (names, limit, colour) in enumerate(sorted(limits, key=lambda line: line[1])):
        below = number == 0 and len(limits) > 1
        axes.axhline(limit, color=colour, linewidth=1.2, linestyle=(0, (5, 2)))
        look = {"va": "top" if below else "bottom", "ha": "left", "color": colour, "path_effects": halo()}
        place, words = ((0.01, 0.65)[number % 2], limit), f"{names}: at most {limit:.3f}"
        beside(axes, words, place, (0, -4 if below else 3), xycoords=("axes fraction", "data"), size=SMALL, **look)
