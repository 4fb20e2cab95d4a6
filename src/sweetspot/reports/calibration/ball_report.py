"""A ball that was dropped, shot, weighed or pressed, as a document: what that tells of it, and what contradicts it."""

from __future__ import annotations

from sweetspot.answers.calibrate_ball import CalibrateBallAnswer
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.sports import sport
from sweetspot.reports.document import Block, Cell, Column, Document, Paragraph, Table, as_columns
from sweetspot.reports.sentences import PLUS_MINUS, Sentence, Slot, joined, measured_words, say
from sweetspot.reports.sport_words import reader_of
from sweetspot.units import MPH


def calibrate_ball_document(answer: CalibrateBallAnswer) -> Document:
    """Return a calibrated ball as a document."""
    name, data = answer.question.name, answer.to_dict()
    return Document(
        name="calibrate-ball",
        title=f"{name}, like {answer.question.like}",
        kind="Calibration of a ball",
        blocks=[Paragraph(_verdict(answer)), *_values(answer), *_bounces(answer), Paragraph(PLUS_MINUS, "note")],
        data=data,
        rows=as_columns(data["bounces"]),
        reader=reader_of(answer.like.sport),
    )


def _verdict(answer: CalibrateBallAnswer) -> Sentence:
    if answer.contradictory:
        return say(
            "The bounces contradict each other: they lie farther from one law than their errors allow. Check heights, "
            "speeds and the floor, which must be rigid."
        )
    if not answer.bounces:
        return say("No bounce was measured: its restitution stays that of {like}.", like=answer.question.like)
    change = answer.restitution.value - answer.restitution_before.value
    half = answer.restitution.half_width
    half = answer.restitution.half_width
    sentences = [
        say(
            "{verdict} the mean {like}: it returns {now} of a speed of {speed:speed, 0}, {change:ratio, sign}.",
            verdict="Livelier than" if change > half else "Deader than" if change < -half else "As lively as",
            now=measured_words(answer.restitution, "ratio"),
            speed=answer.reference_speed,
            change=change,
            like=answer.question.like,
        )
    ]
    fastest, game = max(bounce.speed for bounce in answer.bounces), sport(answer.like.sport).stroke.swing_speed.value
    if fastest < game:
        sentences.append(
            say(
                "It was measured up to {fastest:speed, 0} only; what it returns at a game's speeds rests on the slope "
                "of that ball.",
                fastest=fastest,
            )
        )
    return joined(sentences)


def _values(answer: CalibrateBallAnswer) -> list[Block]:
    rows: list[list[Cell]] = []
    if answer.bounces:
        law = say("restitution on a rigid wall at {speed:speed, 0}", speed=answer.reference_speed)
        rows.append([law, *(measured_words(each, "ratio") for each in (answer.restitution_before, answer.restitution))])
        slopes = (answer.slope_before, answer.slope)
        rows.append(["restitution lost for 10 mph more", *(measured_words(_for_ten(each), "ratio") for each in slopes)])
    if answer.mass is not None:
        rows.append(["mass", "", measured_words(answer.mass, "mass")])
    if answer.compression is not None:
        rows.append(["load for a quarter inch between two plates", "", measured_words(answer.compression, "weight")])
    return [Table("The ball", [Column(""), Column("before", right=True), Column("now", right=True)], rows)]


def _for_ten(slope: Measured) -> Measured:
    return Measured(10 * MPH * slope.value, 10 * MPH * slope.error)


def _bounces(answer: CalibrateBallAnswer) -> list[Block]:
    if not answer.bounces:
        return []
    columns = [Column("bounce at", right=True), Column("restitution", right=True), Column("fitted", right=True)]
    columns.append(Column("off by sigma", right=True))
    rows: list[list[Cell]] = [
        [
            Slot(bounce.speed, "speed"),
            measured_words(bounce.measured, "ratio"),
            Slot(bounce.fitted, "ratio"),
            f"{bounce.off_by_sigma:+.1f}",
        ]
        for bounce in answer.bounces
    ]
    return [Table("The measurements", columns, rows, name="bounces")]
