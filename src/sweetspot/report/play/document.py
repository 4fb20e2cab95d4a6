"""A play as a document: contact, launch, flight and fence."""

from __future__ import annotations

from typing import Any

from sweetspot.catalog.sports import sport
from sweetspot.numerics.confidence import REACH
from sweetspot.report.bat.assumed_values import soft_note
from sweetspot.report.document import Document, Paragraph, Picture
from sweetspot.report.flight.words import (
    alike_words,
    flight_json,
    flight_words,
    landing_json,
    landing_words,
    launch_words,
    path_columns,
    spread_json,
)
from sweetspot.report.hit.document import by_ball
from sweetspot.report.hit.second_touch import touched_again
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.play.played_pitch import PlayedPitch
from sweetspot.report.quantities import Reader, reader
from sweetspot.report.sentences import Sentence, Slot, joined, say


def play_document(played: PlayedPitch) -> Document:
    """Return a play as a document."""
    words = play_words(played)
    speed = played.pitch.speed
    arriving = (
        say("{speed} pitch", speed=Slot(speed, "speed", digits=0, of="pitch_speed_m_s"))
        if speed > 0
        else say("a ball at rest")
    )
    picture = Picture(
        "play", lambda reading: _drawn(played, words, reading),
        label="The contact of bat and ball, and the ball's path from above and from the side.",
    )  # fmt: skip
    return Document(
        name="play", title=played.bat.name, subtitle=arriving, kind="Play",
        blocks=[Paragraph(words), *soft_note(played.bat, played.ball), picture],
        data=play_json(played), rows=path_columns(played.play.flight),
        reader=reader(None, sport(played.bat.sport).words), drawing=picture,
    )  # fmt: skip


def play_json(played: PlayedPitch) -> dict[str, Any]:
    """Return a play with a unit in every name; what a miss does not have is None."""
    struck, ball, impact = played.play.strike, played.play.strike.launched, played.play.strike.impact
    again = {} if impact is None or impact.unrecovered is None else {"unrecovered_gain_m_s": impact.unrecovered_gain}
    alike = spread_json(played.spread)
    alike |= {} if played.error is None else {"exit_speed_half_by_ball_m_s": REACH * played.error}
    alike |= {} if played.chance is None else {"home_run_chance": played.chance}
    return again | cleaned(
        {
            "bat": played.bat.name,
            "outcome": struck.outcome.name.lower(),
            "position_m": played.position,
            "offset_m": played.offset,
            "pitch_speed_m_s": played.pitch.speed,
            "bat_speed_m_s": struck.bat_speed,
            "closing_speed_m_s": impact and impact.closing_speed,
            "collision_efficiency": impact and impact.collision_efficiency,
            "contact_time_s": impact and impact.contact_time,
            "peak_force_n": impact and impact.peak_force,
            "exit_speed_m_s": ball and ball.speed,
            "launch_angle_rad": ball and ball.launch_angle,
            "spray_rad": ball and ball.spray,
            "backspin_rad_s": ball and ball.backspin,
            "sidespin_rad_s": ball and ball.sidespin,
            "gyrospin_rad_s": ball and ball.gyrospin,
            "travel_along_m": struck.travel_along,
            "travel_around_m": struck.travel_around,
            "gripped": struck.gripped,
            "flight": played.play.flight and flight_json(played.play.flight),
            "fence": landing_json(played.landing, played.park) if played.landing and played.park else None,
        }
        | alike
    )


def play_words(played: PlayedPitch) -> Sentence:
    """Return what happened as a few sentences."""
    struck, ball = played.play.strike, played.play.strike.launched
    met = say(
        "{place} from the tip, {offset} {side} the ball's centre",
        place=Slot(played.bat.length - played.position, "place", of="-position_m"),
        offset=Slot(abs(played.offset), "offset", of="offset_m" if played.offset >= 0 else "-offset_m"),
        side="below" if played.offset >= 0 else "above",
    )  # fmt: skip
    if ball is None or played.play.flight is None:
        return say("The bat came {met}: {outcome}.", met=met, outcome=struck.outcome.sentence)
    sentences = [
        say(
            "The bat meets the ball {met}, at {speed}.",
            met=met,
            speed=Slot(struck.bat_speed, "speed", of="bat_speed_m_s"),
        ),
        say("The ball leaves {launch}.", launch=launch_words(ball)),
        *by_ball(None if played.error is None else REACH * played.error, sport(played.bat.sport).words),
        *([] if struck.impact is None else touched_again(struck.impact, sport(played.bat.sport).words)),
        "" if struck.gripped else "It slides on the bat all through the contact: friction cannot turn it further.",
        flight_words(played.play.flight),
    ]
    if played.spread:
        sentences.append(alike_words(played.spread, spin_known=True))
    if played.landing is not None and played.park is not None:
        sentences.append(landing_words(played.landing, played.park, chance=played.chance))
    if played.chance is not None:
        sentences.append(say("Of a hundred like it {chance} are home runs.", chance=round(100 * played.chance)))
    return joined(sentences)


def _drawn(played: PlayedPitch, words: Sentence, reading: Reader) -> Any:
    from sweetspot.report.play.picture import play_figure

    return play_figure(played, words, reading)
