"""The best way to hit as a document: how to swing, how high to send the ball, where a park is easiest to leave."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.answers.optimum import FarthestLaunch, FarthestSwing, OptimumAnswer, SlowestHomeRun
from sweetspot.catalog.sports import sport
from sweetspot.numerics.interval import Number
from sweetspot.reports.document import Block, Cell, Document, Paragraph, Picture, Table, as_columns, drawn, table_head
from sweetspot.reports.flight.document import direction_words
from sweetspot.reports.quantities import reader
from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.reports.uncertainty import how_sure

HELD = (
    "What was searched, place, undercut, attack and launch angle, is a choice: it stays as it is best for all as "
    "described, and has no interval. At a best the carry hardly changes with it."
)


def optimum_document(answer: OptimumAnswer) -> Document:
    """Return the best way to hit as a document; its CSV is that of the first question."""
    bat, blocks = answer.question.bat, list[Block]()
    if answer.swings is not None:
        blocks += [Paragraph(_swing_words(found, length=bat.length)) for found in answer.swings]
        blocks.append(_swings(answer.swings, length=bat.length))
    if answer.launches is not None:
        blocks += [] if answer.swings else [Paragraph(_launch_words(answer.launches))]
        blocks.append(_launches(answer.launches))
    if answer.parks is not None:
        blocks += [Paragraph(_park_words(answer.parks)), _parks(answer.parks)]
    if answer.uncertainty is not None:
        blocks.append(Paragraph(HELD, "note"))
    picture = Picture(
        "best", drawn("sweetspot.reports.pictures.optimum:optimum_figure", answer), label="The best of what was tried."
    )
    blocks.append(picture)
    if answer.uncertainty is not None:
        parks_alone = answer.swings is None and answer.launches is None
        blocks.append(how_sure(answer.uncertainty, "slowest home run" if parks_alone else "first farthest carry"))
    data = answer.to_dict()
    return Document(
        name="optimum",
        title=answer.bat,
        kind="The best way to hit",
        blocks=blocks,
        data=data,
        rows=as_columns(next((rows for rows in data.values() if isinstance(rows, list)), [])),
        reader=reader(None, sport(bat.sport).words),
        drawing=picture,
    )


def _swing_words(best: FarthestSwing, *, length: float) -> Sentence:
    below = float(best.undercut) >= 0
    return say(
        "To hit a {best.pitch}, {speed:speed, 0} at the plate, farthest ({best.carry:distance}): meet it {place:place} "
        "from the tip, {offset:offset} {side} its centre, swinging {way} {attack:angle}.",
        best=best,
        speed=float(best.pitch_speed),
        place=length - best.position,
        offset=best.undercut if below else -best.undercut,
        side="below" if below else "above",
        way="up" if float(best.attack_angle) >= 0 else "down",
        attack=best.attack_angle if float(best.attack_angle) >= 0 else -best.attack_angle,
    )


def _launch_words(launches: Sequence[FarthestLaunch]) -> Sentence:
    """Return the best launch angle of the fastest ball that was asked about."""
    best = max(launches, key=lambda launch: float(launch.exit_speed))
    return say(
        "A ball off the bat at {best.exit_speed:speed, 0} carries farthest, {best.carry:distance}, sent "
        "{best.launch_angle:angle} up.",
        best=best,
    )


def _park_words(parks: Sequence[SlowestHomeRun]) -> Sentence:
    easiest = min(parks, key=lambda park: float(park.exit_speed))
    return say(
        "{lead} {easiest.park}: a ball of {easiest.exit_speed:speed} at {easiest.launch_angle:angle}, {where}, just "
        "clears a fence {easiest.fence_distance:distance} away and {easiest.fence_height:distance} high.",
        lead="Easiest to leave is" if len(parks) > 1 else "Easiest way out of",
        easiest=easiest,
        where=direction_words(easiest.direction),
    )


def _swings(swings: Sequence[FarthestSwing], *, length: float) -> Table:
    columns = table_head(
        "pitch | plate: speed, 0 | attack: angle | undercut: offset | from tip: place | exit: speed | "
        "launch: angle | spin: spin | carry: distance"
    )
    rows: list[list[Cell]] = [
        [
            best.pitch,
            float(best.pitch_speed),
            float(best.attack_angle),
            float(best.undercut),
            length - float(best.position),
            _beside(best.exit_speed, "speed"),
            _beside(best.launch_angle, "angle"),
            _beside(best.backspin, "spin"),
            _beside(best.carry, "distance"),
        ]
        for best in swings
    ]
    return Table("Contact that carries farthest", columns, rows)


def _launches(launches: Sequence[FarthestLaunch]) -> Table:
    columns = table_head("exit speed: speed, 0 | backspin: spin | best launch: angle | carry: distance")
    rows: list[list[Cell]] = [
        [float(best.exit_speed), float(best.backspin), float(best.launch_angle), _beside(best.carry, "distance")]
        for best in launches
    ]
    return Table("Launch angle that carries farthest", columns, rows)


def _parks(parks: Sequence[SlowestHomeRun]) -> Table:
    columns = table_head("park | exit speed: speed | launch: angle | towards | fence: distance | wall: distance")
    rows: list[list[Cell]] = [
        [
            best.park,
            _beside(best.exit_speed, "speed"),
            float(best.launch_angle),
            direction_words(best.direction),
            float(best.fence_distance),
            float(best.fence_height),
        ]
        for best in parks
    ]
    return Table("Slowest home run, each park in its own air", columns, rows)


def _beside(value: Number, scale: str) -> Slot:
    """Return a number of a table, beside which an interval may stand."""
    return Slot(value, scale, unit=False)
