"""A blind test as documents: our predictions, and how predictions did."""

from __future__ import annotations

from dataclasses import fields

from sweetspot.answers.records import to_dict
from sweetspot.answers.sealed import KindScore, ScoreAnswer, SealedAnswer
from sweetspot.reports.document import Cell, Document, Paragraph, Table, as_columns, table_head
from sweetspot.reports.quantities import SI
from sweetspot.validation.sealed_files import Prediction, predictions_csv

DIGEST_SHOWN = 12
"""Digits of a digest that a line shows."""


def sealed_document(answer: SealedAnswer) -> Document:
    """Return predictions as a document; its files have them as CSV in full digits."""
    cells: list[list[Cell]] = [
        [
            prediction.id,
            prediction.kind,
            f"{prediction.value:.5g} {prediction.unit}".strip(),
            _span(prediction.low_50, prediction.high_50),
            _span(prediction.low_90, prediction.high_90),
        ]
        for prediction in answer.predictions
    ]
    rows = [
        {part.name: getattr(prediction, part.name) for part in fields(Prediction)} for prediction in answer.predictions
    ]
    without = sum(prediction.low_90 is None for prediction in answer.predictions)
    return Document(
        name="sealed",
        title="Predictions of a blind test",
        kind="Blind test",
        blocks=[
            Table("", table_head("id | kind | predicted | 50 % | 90 %"), cells, name="predictions"),
            Paragraph(
                f"{len(rows)} predictions by sweetspot {answer.version} for the questions with the SHA-256 "
                f"{answer.questions_sha256[:DIGEST_SHOWN]}..."
                + (f"; {without} of them without an interval, as nothing about them is drawn." if without else ".")
            ),
        ],
        data=answer.to_dict(),
        rows=as_columns(rows),
        reader=SI,
        attachments={"predictions.csv": lambda _: predictions_csv(answer.predictions)},
    )


def _span(low: float | None, high: float | None) -> str:
    return "-" if low is None or high is None else f"{low:.4g} to {high:.4g}"


def score_document(answer: ScoreAnswer) -> Document:
    """Return a score as a document."""
    scores = answer.scores
    cells: list[list[Cell]] = [
        [
            score.kind,
            str(score.count),
            _covered(score.in_50, score.of_50),
            _covered(score.in_90, score.of_90),
            f"{score.bias:+.4g} {score.unit}".strip(),
            f"{score.rms:.4g} {score.unit}".strip(),
            f"{score.worst:+.4g} {score.unit}".strip() + f" ({score.worst_id})",
        ]
        for score in scores
    ]
    inside, of = sum(score.in_90 for score in scores), sum(score.of_90 for score in scores)
    half, of_half = sum(score.in_50 for score in scores), sum(score.of_50 for score in scores)
    words = [
        f"{sum(score.count for score in scores)} of {len(answer.predictions)} predictions were measured.",
        f"Of the 90 % intervals {inside} of {of} hold what was measured, of the 50 % intervals {half} of {of_half}."
        if of
        else "None of them has an interval.",
        f"They are by version {answer.version}." if answer.version else "",
    ]
    return Document(
        name="score",
        title="Score of a blind test",
        kind="Blind test",
        blocks=[
            Table("", table_head("kind | measured | in 50 % | in 90 % | bias | rms | worst"), cells, name="score"),
            Paragraph(" ".join(filter(None, words)) + " Bias, rms and worst are of predicted less measured."),
        ],
        data=answer.to_dict(),
        rows=as_columns([to_dict(score) for score in scores])
        if scores
        else {part.name: [] for part in fields(KindScore)},
        reader=SI,
    )


def _covered(inside: int, of: int) -> str:
    return f"{inside} of {of}" if of else "-"
