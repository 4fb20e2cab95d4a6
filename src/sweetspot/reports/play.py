"""A play as a document: contact, launch, flight and fence."""

from __future__ import annotations

from sweetspot.analysis.full_play import Play, Plays
from sweetspot.answers.flight import FlightEnd, flight_of
from sweetspot.answers.play import PlayAnswer
from sweetspot.catalog.sports import sport
from sweetspot.collision.hit_in_space import Strike
from sweetspot.flight.home_runs import is_likely
from sweetspot.numerics.interval import Interval, Number
from sweetspot.reports.bat.provenance import soft_note
from sweetspot.reports.document import Document, Paragraph, Picture, drawn
from sweetspot.reports.flight.document import alike_words, fence_words, flight_document, flight_words, launch_words
from sweetspot.reports.hit.document import by_ball, impact_document, touched_again
from sweetspot.reports.many import flights_document
from sweetspot.reports.quantities import reader
from sweetspot.reports.sentences import Sentence, joined, say
from sweetspot.reports.uncertainty import how_sure


def play_document(answer: PlayAnswer) -> Document:
    """Return a play as a document."""
    words, bat, data = play_words(answer), answer.question.reduced.bat, answer.to_dict()
    pitch = say("{speed:speed, 0} pitch", speed=answer.pitch_speed)
    picture = Picture(
        "play",
        drawn("sweetspot.reports.pictures.play:play_figure", answer, words),
        label="The contact of bat and ball, and the ball's path from above and from the side.",
    )
    return Document(
        name="play",
        title=answer.bat,
        subtitle=pitch if float(answer.pitch_speed) > 0 else "a ball at rest",
        kind="Play",
        blocks=[
            Paragraph(words),
            *soft_note(bat.sport, answer.question.conditions.ball),
            picture,
            *([] if answer.uncertainty is None else [how_sure(answer.uncertainty, "carry")]),
        ],
        data=data,
        rows=NO_PATH if answer.flight is None else data["flight"]["path"],
        reader=reader(None, sport(bat.sport).words),
        drawing=picture,
    )


NO_PATH: dict[str, list[float]] = {"time_s": [], "right_m": [], "out_m": [], "up_m": []}
"""Of a ball that was missed."""


def play_words(answer: PlayAnswer) -> Sentence:
    """Return the course of a play in a few sentences."""
    bat, struck, launch = answer.question.reduced.bat, answer.play.strike, answer.launch
    words, below = sport(bat.sport).words, float(answer.offset) >= 0
    contact = say(
        "{place:place} from the tip, {offset:offset} {side} the ball's centre",
        place=bat.length - answer.position,
        offset=answer.offset if below else -answer.offset,
        side="below" if below else "above",
    )
    if launch is None or answer.flight is None:
        return say("The bat came {met}: {outcome}.", met=contact, outcome=struck.outcome.sentence)
    chance = answer.home_run_chance
    sentences = [
        *([] if answer.fence is None else [outcome_words(answer.fence, chance)]),
        *([] if chance is None else [home_runs_words(chance)]),
        say("The ball leaves {launch}.", launch=launch_words(launch)),
        *by_ball(answer.exit_speed_half_by_ball, answer.exit_speed_half_by_kind, words),
        flight_words(answer.flight),
    ]
    if answer.carry_half is not None:
        sentences.append(alike_words(answer.carry_half, spin_known=True))
    if answer.fence is not None and answer.fence.clearance is not None:
        sentences.append(fence_words(answer.fence, chance=None if chance is None else float(chance)))
    return joined([
        *sentences,
        say("The bat met the ball {met}, at {speed:speed}.", met=contact, speed=answer.bat_speed),
        *([] if struck.impact is None else touched_again(struck.impact, words)),
        "" if answer.gripped else "It slid on the bat all through the contact: friction cannot turn it further.",
    ])  # fmt: skip


def outcome_words(end: FlightEnd, chance: Number | None) -> Sentence:
    """Return first of all how a play ends in its park."""
    if end.outcome == "foul":
        return say("Foul at {park}.", park=end.park)
    likely = end.outcome == "home run" if chance is None else is_likely(float(chance))
    return say("{ending} at {park}.", ending="Home run" if likely else "It stays in the field of play", park=end.park)


def home_runs_words(chance: Number) -> Sentence:
    """Return how many balls that are hit alike are home runs."""
    count = round(100 * float(chance))
    ends = (chance.low, chance.high) if isinstance(chance, Interval) else (chance, chance)
    low, high = (round(100 * float(end)) for end in ends)
    if low == high:
        return say("Of a hundred hit like it {count} are home runs.", count=count)
    return say(
        "Of a hundred hit like it {count} are home runs: {low} if balls are on average as dead as they may be, "
        "{high} if as lively.",
        count=count,
        low=low,
        high=high,
    )


def bare_play_document(play: Play | Plays) -> Document:
    """Return the flights of plays as a document; of one that missed, how it ended."""
    if isinstance(play, Plays):
        return flights_document(play.flights)
    return strike_document(play.strike) if play.flight is None else flight_document(flight_of(play.flight))


def strike_document(strike: Strike) -> Document:
    """Return the collision of a hit in space as a document; of one that missed, how it ended."""
    if strike.impact is not None:
        return impact_document(strike.impact)
    data = {"outcome": strike.outcome.name.lower(), "bat_speed_m_s": strike.bat_speed}
    return Document(
        name="hit", title="", kind="Hit", blocks=[Paragraph(f"{strike.outcome.sentence.capitalize()}.")], data=data,
        rows={name: [value] for name, value in data.items()},
    )  # fmt: skip
