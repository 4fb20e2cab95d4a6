"""What an implement is made of, in words with quantities."""

from __future__ import annotations

from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.report.sentences import Slot, Words, say


def made_of_words(tool: Implement) -> Words:
    """Return what an implement is made of, with the tension of its strings or the weight of its head."""
    if isinstance(tool, Racket):
        return say("{frame}, strings at {tension}", frame=tool.made_of, tension=Slot(tool.bed.tension, "tension"))
    if isinstance(tool, GolfClub):
        return say("{material}, head of {mass}", material=tool.made_of, mass=Slot(tool.head.mass, "mass"))
    return tool.made_of
