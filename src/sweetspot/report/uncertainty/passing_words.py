"""How sure it is that a bat passes: the probability that what a rule limits lies within its limits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sweetspot.analysis.certification.rules import Check, League, title
from sweetspot.analysis.certification.shot_statistics import Estimate, Measured
from sweetspot.calibration.draws.drawn_tests import RULED
from sweetspot.calibration.draws.intervals import DrawnAnswers
from sweetspot.report.certification.tested_bat import TestedBat
from sweetspot.report.document import Document, Paragraph
from sweetspot.report.sentences import Sentence, joined, say
from sweetspot.report.uncertainty.probability import chance_words

MEASURED = {"bbcor": "bbcor", "bpf": "bpf", "batted_ball_speed": "batted_ball_speed"}
"""Quantities of rules that shots estimate, by their fields."""


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
                yield league, check, _by_shots(estimate, rule.least, rule.most)


def _by_shots(estimate: Estimate, least: float | None, most: float | None) -> float:
    """Return the probability that the mean lies within limits: Student's t of the mean over its standard error."""
    import scipy.special

    def below(limit: float) -> float:
        return float(scipy.special.stdtr(max(estimate.count - 1, 1), (limit - estimate.mean) / estimate.standard_error))

    return (1.0 if most is None else below(most)) - (0.0 if least is None else below(least))
