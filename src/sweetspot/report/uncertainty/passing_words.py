"""How sure it is that a bat passes: the probability that what a rule limits lies within its limits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sweetspot.analysis.certification.rules import Check, League, title
from sweetspot.analysis.certification.shot_statistics import Estimate, Measured
from sweetspot.numerics.confidence import REACH
from sweetspot.report.certification.tested_bat import TestedBat
from sweetspot.report.document import Document, Paragraph
from sweetspot.report.sentences import Sentence, joined, say
from sweetspot.report.uncertainty.probability import chance_words
from sweetspot.uncertainty.drawn_tests import RULED
from sweetspot.uncertainty.intervals import DrawnAnswers

MEASURED = {"bbcor": "bbcor", "bpf": "bpf", "batted_ball_speed": "batted_ball_speed"}
"""Quantities of rules that shots estimate, by their fields."""
BY_RECOIL = ("bbcor", "bpf")
"""Those that are worked out with the bat's moment of inertia."""
NODES = 2001
"""Moments of inertia, equally probable, over which a probability is averaged."""


def with_chances(document: Document, tested: TestedBat, answers: DrawnAnswers | None = None) -> Document:
    """Return a bat test that says how probable it is that the bat keeps each rule.

    Parameters
    ----------
    answers : of draws, for a simulated test; None: by the standard error of measured shots, with Student's t.
    """
    checked = list(_chances(tested, answers))
    if not checked:
        return document
    words = joined(
        (_chance_words(league, check, chance) for league, check, chance in checked),
        " ",
    )
    chances = [
        {"league": league.key, "quantity": check.rule.quantity, "passes_probability": chance}
        for league, check, chance in checked
    ]
    return replace(
        document, blocks=[*document.blocks[:1], Paragraph(words), *document.blocks[1:]],
        data={**document.data, "passes": chances},
    )  # fmt: skip


def _chance_words(league: League, check: Check, chance: float) -> Sentence:
    return say(
        "How sure: it keeps the limit on {title} ({league}) with a probability of {chance}.",
        title=title(check.rule), league=league.name, chance=chance_words(chance),
    )  # fmt: skip


def _chances(tested: TestedBat, answers: DrawnAnswers | None) -> Iterator[tuple[League, Check, float]]:
    for league, check in tested.checks:
        rule = check.rule
        if check.margin is None or (rule.least is None and rule.most is None):
            continue
        if answers is not None and RULED.get(rule.quantity) in answers.values:
            yield league, check, answers.chance(RULED[rule.quantity], least=rule.least, most=rule.most)
        elif isinstance(tested.test, Measured) and rule.quantity in MEASURED:
            estimate = getattr(tested.test, MEASURED[rule.quantity])
            if estimate is not None and estimate.standard_error > 0:
                by_moi = tested.test.by_moi / REACH if rule.quantity in BY_RECOIL else 0.0
                yield league, check, _by_shots(estimate, rule.least, rule.most, by_moi=by_moi * estimate.mean)


def _by_shots(estimate: Estimate, least: float | None, most: float | None, *, by_moi: float = 0.0) -> float:
    """Return the probability that what shots estimate lies within limits.

    The mean follows Student's t of its standard error, and what a moment of inertia in doubt adds is normal.

    Parameters
    ----------
    by_moi : one standard deviation that the moment leaves open, in the estimate's unit; 0: it was measured.
    """
    import scipy.special

    nodes = NODES if by_moi else 1
    off = by_moi * scipy.special.ndtri((np.arange(nodes) + 0.5) / nodes)

    def below(limit: float) -> float:
        apart = (limit - estimate.mean - off) / estimate.standard_error
        return float(np.mean(scipy.special.stdtr(max(estimate.count - 1, 1), apart)))

    return (1.0 if most is None else below(most)) - (0.0 if least is None else below(least))
