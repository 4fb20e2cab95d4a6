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
from sweetspot.reports.pictures.style import (
    HUGE,
    INK,
    MUTED,
    NORMAL,
    PAPER,
    SHEET,
    SMALL,
    axes_in_inches,
    fitted,
    halo,
    heading,
    light_grid,
    styled,
)
from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, RED, SKY, US, Reader

SIDE = 0.62
"""Inches of paper beside the panel."""
ALONE, ON_A_SHEET = (8.0, 1.05, 2.6, 0.95), (SHEET, 0.25, 1.4, 0.68)
"""Inches of paper: page, title, the panel, the foot; on a sheet the page says whose test it is."""
ROOM = 0.12
"""Part of the panel's range left free above and below."""
COLOURS = {Verdict.PASS: GREEN, Verdict.FAIL: ORANGE}


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
    width, header, panel, footer = paper
    height = header + panel + footer
    figure = Figure(figsize=(width, height))
    if paper == ALONE:
        _header(figure, answer, width, height)
    curve = _curve(answer)
    name = curve.measure.upper()
    axes = axes_in_inches(figure, left=SIDE, top=header, width=width - 2 * SIDE, height=panel)
    heading(axes, name, "along the barrel, on a bat at rest; the scale does not begin at 0")
    inch = reading.units["place"].size
    from_tip = (answer.implement.length - curve.position) / inch
    if answer.test is not None:
        axes.fill_between(from_tip, curve.low, curve.high, color=SKY, alpha=0.35, linewidth=0)
        axes.plot(from_tip, curve.value, color=BLUE)
    else:
        axes.plot(from_tip, curve.value, "o", color=BLUE, markersize=4)
    limits = _limits(answer, curve.measure)
    values = np.concatenate([curve.low, curve.high, curve.value, [limit for _, limit, _ in limits]])
    low, high = float(values.min()), float(values.max())
    room = ROOM * (high - low)
    axes.set_ylim(low - room, high + 2 * room)
    far, near = float(from_tip.max()), float(from_tip.min())
    pad = 0.04 * (far - near) or 1.0
    axes.set_xlim(far + pad, near - pad)
    _draw_limits(axes, limits)
    place, value = (answer.implement.length - curve.best[0]) / inch, curve.best[1]
    axes.plot(place, value, "o", color=RED, markersize=6, markeredgecolor=PAPER, markeredgewidth=0.8, zorder=5)
    axes.annotate(
        f"{value:.3f}", (place, value), xytext=(0, -8), textcoords="offset points", color=INK, weight="bold",
        ha="center", va="top", path_effects=halo(),
    )  # fmt: skip
    axes.set_xlabel(from_the_tip(answer.implement, reading))
    light_grid(axes)
    kind = (
        "Computed. Band: what the size of the ball's patch leaves open."
        if answer.test is not None else "Measured: each dot is a place, the mean of its shots."
    )  # fmt: skip
    figure.text(
        SIDE / width,
        (0.12 if paper == ALONE else 0.03) / height,
        f"{kind} Orange dot: the best place.",
        color=MUTED,
        size=SMALL,
    )
    return figure


def _header(figure: Figure, answer: CertifyAnswer, width: float, height: float) -> None:
    """Write whose test it is, with which ball, and how many rules it keeps."""
    words, size = fitted(answer.bat.name, width=width - 2 * SIDE, size=HUGE)
    figure.text(SIDE / width, 1 - 0.42 / height, words, size=size, weight="bold", parse_math=False)
    verdicts = "; ".join(
        _counted(count, verdict, doubt)
        for verdict, doubt in product(Verdict, ("", NOT_SURE))
        if (count := sum(check.outcome.words == f"{verdict}{doubt}" for check in answer.checks))
    )
    figure.text(SIDE / width, 1 - 0.68 / height, f"{answer.ball}. {_capital(verdicts)}", color=MUTED, size=NORMAL,
                parse_math=False)  # fmt: skip


def _counted(count: int, verdict: Verdict, doubt: str) -> str:
    verbs = {Verdict.PASS: ("passes", "pass"), Verdict.FAIL: ("fails", "fail"),
            Verdict.NOT_APPLICABLE: ("does not apply", "do not apply")}  # fmt: skip
    singular, plural = verbs.get(verdict, (verdict.value, verdict.value))
    return f"{count} {singular if count == 1 else plural}{doubt}"


def _capital(verdicts: str) -> str:
    return f"Rules: {verdicts}." if verdicts else "No rules were held against it."


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
    tests += [slow if measure == "bpf" else fast for fast, slow in test.other_patches]
    curves = np.array([_values(each, measure) for each in tests])
    best = test.bpf if measure == "bpf" else test.bbcor
    return _Curve(measure, tests[0].position, curves[0], curves.min(axis=0), curves.max(axis=0),
                  (tests[0].best_position, best))  # fmt: skip


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
        under = number == 0 and len(limits) > 1
        axes.axhline(limit, color=colour, linewidth=1.2, linestyle=(0, (5, 2)))
        axes.annotate(
            f"{names}: at most {limit:.3f}", ((0.01, 0.65)[number % 2], limit),
            xycoords=("axes fraction", "data"), xytext=(0, -4 if under else 3), textcoords="offset points",
            color=colour, size=SMALL, ha="left", va="top" if under else "bottom", path_effects=halo(),
        )  # fmt: skip
