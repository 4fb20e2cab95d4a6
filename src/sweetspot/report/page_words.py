"""Sentences that the page says over its pictures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sweetspot.equipment.sport import Terms
from sweetspot.report.hit.ledger import ENERGY_NAMES
from sweetspot.report.sentences import Sentence, Slot, joined, say
from sweetspot.report.sport_words import in_words

LEAST_SHARE = 0.004
"""Part of the energy below which it would be told as 0 %."""
FEW = 1e-4
"""Part of a tap's energy below which a motion's part is told as less than that."""


def hits_fastest(name: str, from_tip: float, exit_speed: float, *, words: Terms) -> Sentence:
    """Return where an implement hits fastest, m from its tip, and how fast, m/s."""
    return in_words(
        "{name} hits fastest {place} from the {tip}: {speed}.",
        words,
        name=name,
        place=Slot(from_tip, "place"),
        speed=Slot(exit_speed, "speed"),
    )


def leaves_here(
    from_tip: float, exit_speed: float | None, *, ends: str, words: Terms, aside: float = 0.0, backwards: bool = False
) -> Sentence:
    """Return how fast a ball leaves a place, m from the tip and aside; ``ends`` says what happens where it does not."""
    off = say(" and {aside} off the line", aside=Slot(abs(aside), "place")) if aside else ""
    return in_words(
        "Here, {place} from the {tip}{off}: {speed}" + (", fouled back." if backwards else "."),
        words,
        place=Slot(from_tip, "place"),
        off=off,
        speed=ends if exit_speed is None else Slot(exit_speed, "speed"),
    )


def energy_words(shares: Mapping[str, float], words: Terms) -> list[Sentence]:
    """Return in a sentence where the energy of a hit goes, by part of `ENERGY_NAMES`; none where nothing is known."""
    parts = [
        in_words(ENERGY_NAMES[name][0] + " {share}", words, share=Slot(share, "share"))
        for name, share in shares.items()
        if share > LEAST_SHARE
    ]
    return [say("Of the energy of the meeting: {parts}.", parts=joined(parts, ", "))] if parts else []


def wave_words(name: str, *, contact_time: float, arrival: float | None, given: float | None) -> list[Sentence]:
    """Return how long the push lasts, and whether what the hands do could still reach the ball.

    Parameters
    ----------
    arrival : s, of the wave at the top hand; None: none arrives.
    given : part of the push that the ball has had by then.
    """
    push = say(
        "{name}: the push is over {time} after first touch.", name=name, time=Slot(contact_time, "contact", digits=2)
    )
    if arrival is None or given is None:
        return [push, say("No wave to speak of reaches the top hand in this film.")]
    wave = say(
        "The wave reaches the top hand {time} after first touch, when the ball has had {share} of its push.",
        time=Slot(arrival, "contact", digits=2),
        share=Slot(given, "share"),
    )
    late = "too late." if 2 * arrival > contact_time else "while ball and bat still push each other."
    back = say(
        "What the hands do about it could be back at the ball after {time}, " + late,
        time=Slot(2 * arrival, "contact", digits=2),
    )
    return [push, wave, back]


def motion_words(
    name: str,
    family: str,
    *,
    frequency: float,
    waves: tuple[int, int | None],
    nodes: Sequence[float],
    tap: tuple[float, float | None],
) -> list[Sentence]:
    """Return what a motion of a bat is, where it stands still, and what a tap gives it.

    Parameters
    ----------
    waves : of a hoop mode, around the barrel, and half waves along it.
    nodes : m from the tip.
    tap : m from the tip, and the part of the vibration's energy that it gives; None: it is no vibration.
    """
    (around, along), (place, share) = waves, tap
    head = name if family == "rigid" else say("{name}, {tone}", name=name, tone=Slot(frequency, "frequency"))
    halves = f"{along} half {'wave' if along == 1 else 'waves'}"
    kinds = {
        "rigid": "{head}: the bat moves without bending.",
        "hoop": f"{{head}}: the barrel goes out of round with {around} waves around it and {halves} along it.",
        "hand": "{head}: hands and bat against each other, on the hands' flesh.",
    }
    words = [say(kinds.get(family, "{head}."), head=head)]
    if nodes:
        *others, last = [say("{place}", place=Slot(node, "length")) for node in nodes]
        places = joined([joined(others, ", "), last], " and ")
        words.append(say("It stands still {places} from the tip.", places=places))
    else:
        words.append(say("It stands still nowhere along the bat."))
    if share is not None:
        digits = 2 if share < 0.01 else 1
        part = say("less than {few}", few=Slot(FEW, "share", digits=2)) if 0 < share < FEW else ""
        words.append(
            say(
                "The tap {place} from the tip gives it {share} of the vibration's energy.",
                place=Slot(place, "length"),
                share=part or Slot(share, "share", digits=digits),
            )
        )
    return words
