"""What tracked distances leave over beside the carries, and what the season's own drag would change, in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from sweetspot.answers.season import SeasonMeans
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.reports.sentences import Sentence, Slot, say, within
from sweetspot.seasons.season_drag import DragOfMonth, LeftOver

SCALES: Mapping[str, str] = {"launch_angle": "angle", "exit_speed": "speed", "bearing": "angle", "park": ""}
"""By what balls are compared, and the scale of its values; "" where they are names."""


def left_over_words(left_over: Mapping[str, Sequence[LeftOver]]) -> list[Sentence]:
    """Return a sentence for each comparison: where tracked distances are shortest and longest beside the carries."""
    sentences = []
    for kind, groups in left_over.items():
        if len(groups) < 2:
            continue
        mean = np.array([group.mean for group in groups])
        weight = 1 / np.maximum([group.error for group in groups], 1e-6) ** 2
        spread = float(np.sum(weight * (mean - np.average(mean, weights=weight)) ** 2))
        chance = len(mean) - 1
        beyond = "" if spread > chance + 2 * np.sqrt(2 * chance) else ", which chance alone could do"
        low, high = groups[int(np.argmin(mean))], groups[int(np.argmax(mean))]
        words = "By {kind}: from {low} at {there} to {high} at {here}" + beyond + "."
        named = {"there": _where(low, kind), "here": _where(high, kind)}
        sentences.append(say(words, kind=kind.replace("_", " "), low=_slot(low), high=_slot(high), **named))
    return sentences


def _slot(group: LeftOver) -> Slot:
    half = REACH * group.error
    return Slot(Interval(group.mean, group.mean - half, group.mean + half), "distance", digits=1, sign=True)


def _where(group: LeftOver, kind: str) -> str | Slot:
    return str(group.name) if group.middle is None else Slot(group.middle, SCALES[kind], digits=0)


def own_drag_words(league: SeasonMeans, months: Sequence[DragOfMonth]) -> list[Sentence]:
    """Return the effect of the season's own drag on the expected home runs, which fly with the law's."""
    if league.home_runs_with_own_drag is None:
        return []
    words = (
        "They fly with the usual drag; the season's own, by its tracked distances, is {drag} of that, and with it "
        "{home_runs} would be expected."
    )
    drag = Slot(months[0].drag, "ratio", 3)
    return [say(words, drag=drag, home_runs=within(league.home_runs_with_own_drag, "count"))]
