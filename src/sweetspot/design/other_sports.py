"""Rackets and clubs by the same machinery as bats: their own few numbers."""

from __future__ import annotations

from sweetspot.design.variables import ImplementSpace, Variable
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

REACH = 0.05
"""Part by which a racket's weights may change: what lead tape does."""
HEAD_REACH = 0.15
"""Part by which the mass and the moments of a club's head may change."""


def racket_space(racket: Racket) -> ImplementSpace:
    """Return the space of rackets like one: mass and swing weight, which lead tape changes.

    Raises
    ------
    InputError
        when mass or swing weight were not measured.
    """
    if racket.mass is None or racket.moi is None:
        raise InputError(f"{racket.name} has no measured mass and swing weight; give both")
    variables = tuple(
        Variable(name, label, name, (1 - REACH) * now, (1 + REACH) * now, now)
        for name, label, now in (("mass", "mass", racket.mass), ("moi", "swing weight", racket.moi))
    )

    def change(implement: Implement, numbers: Array) -> Implement:
        return implement.replaced(mass=float(numbers[0]), moi=float(numbers[1]))

    return ImplementSpace(racket, variables, change)


def club_space(club: GolfClub) -> ImplementSpace:
    """Return the space of clubs like one: mass of the head, and its moment against twisting up and down."""
    head = club.head
    variables = tuple(
        Variable(name, label, scale, (1 - HEAD_REACH) * now, (1 + HEAD_REACH) * now, now)
        for name, label, scale, now in (
            ("head_mass", "mass of the head", "mass", head.mass), ("head_moi", "moment of the head", "moi", head.moi),
        )
    )  # fmt: skip

    def change(implement: Implement, numbers: Array) -> Implement:
        return implement.replaced(head=head.replaced(mass=float(numbers[0]), moi=float(numbers[1])))

    return ImplementSpace(club, variables, change)
