"""Vocabulary and readers of an implement's sport: data of the catalogue, for any sport."""

from __future__ import annotations

from sweetspot.catalog.sports import sport
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import Number
from sweetspot.reports.quantities import Reader, reader
from sweetspot.reports.sentences import Sentence, Slot, Words, say

LIGHT = 0.02
"""kg below which a mass is shown to a tenth of a gram."""


def words_of(name: str) -> Terms:
    """Return the vocabulary of a sport."""
    return sport(name).words


def reader_of(name: str) -> Reader:
    """Return the default reader of a sport: its people."""
    return reader(None, words_of(name))


def in_words(template: str, words: Terms, **slots: object) -> Sentence:
    """Return a template's words, its slots filled with a sport's words too.

    >>> in_words("from the {tip} of the {implement}", Terms(tip="toe")).read(reader(None, Terms()))
    'from the toe of the bat'
    """
    return say(template, **(words.model_dump() | slots))


def arriving(words: Terms, speed: float) -> Sentence:
    """Return the incoming ball: "a pitch at 90 mph", "a ball at rest"."""
    if not speed > 0:
        return in_words("a {incoming} at rest", words)
    return in_words("a {incoming} at {speed}", words, speed=Slot(speed, "speed", round=True))


def weight(mass: Number) -> Slot:
    """Return a mass (kg), with a digit more where it is that of a small ball."""
    return Slot(mass, "mass", 1 if float(mass) < LIGHT else None)


def made_of_words(tool: Implement) -> Words:
    """Return the materials of an implement, with the tension of its strings or the weight of its head."""
    if isinstance(tool, Racket):
        return say("{frame}, strings at {tension}", frame=tool.made_of, tension=Slot(tool.bed.tension, "tension"))
    if isinstance(tool, GolfClub):
        return say("{material}, head of {mass}", material=tool.made_of, mass=Slot(tool.head.mass, "mass"))
    return tool.made_of
