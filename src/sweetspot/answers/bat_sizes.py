"""Bats of a file of swings by the weight and length in their rows: like a bat that is known, but for these."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from sweetspot.catalog.scaled_implements import Measures, scaled_to
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.tables.cells import BadRow
from sweetspot.units import INCH, OUNCE

SAME_WEIGHT, SAME_LENGTH = 0.05 * OUNCE, 0.05 * INCH
"""kg, m; a bat this near the one it is like is that bat. Our choice: half of the last digit that people write."""


@dataclass(frozen=True)
class SizedBats:
    """Swings whose bats are named by weight and length too.

    ``swings``: that can be used, their bats renamed. ``bats``: the bats by these names. ``bad_rows``: with a weight or
    length that no bat like the one named has. ``notes``: which bats were made, in words.
    """

    swings: tuple[PlayerSwing, ...]
    bats: Mapping[str, Bat]
    bad_rows: tuple[BadRow, ...]
    notes: tuple[str, ...]


def sized_bats(swings: Sequence[PlayerSwing], *, pattern_of: Callable[[str], Bat]) -> SizedBats:
    """Return the swings with a bat for each weight and length of their rows.

    ``pattern_of``: the bat that one of a name in the file is like, "" of no name.
    """
    sizes = {(swing.bat, swing.bat_mass, swing.bat_length) for swing in swings}
    made: dict[tuple[str, float | None, float | None], Bat] = {}
    refused: dict[tuple[str, float | None, float | None], str] = {}
    for key in sorted((key for key in sizes if key[1:] != (None, None)), key=str):
        pattern = pattern_of(key[0])
        try:
            made[key] = _sized(pattern, mass=key[1], length=key[2])
        except InputError as error:
            refused[key] = " ".join(str(error).split())
    bats = {bat.name: bat for bat in made.values()}
    good, bad = [], []
    for swing in swings:
        key = (swing.bat, swing.bat_mass, swing.bat_length)
        if key in refused:
            bad.append(BadRow(swing.row, refused[key]))
        else:
            good.append(replace(swing, bat=made[key].name) if key in made else swing)
    like = sorted({pattern_of(key[0]).name for key in made})
    notes = (
        (
            f"Bats of the file are made by their weight and length, like {', '.join(like)}: {', '.join(sorted(bats))}. "
            "Their balance was not given; a bat balanced otherwise is swung otherwise.",
        )
        if bats
        else ()
    )
    return SizedBats(tuple(good), bats, tuple(bad), notes)


def _sized(pattern: Bat, *, mass: float | None, length: float | None) -> Bat:
    """Return a bat like a pattern at a weight (kg) and length (m); the pattern itself where it has them."""
    body = rigid_body(beam_model(pattern))
    same_length = length is None or abs(length - pattern.length) < SAME_LENGTH
    if same_length and (mass is None or abs(mass - body.mass) < SAME_WEIGHT):
        return pattern
    bat, _ = scaled_to(pattern, Measures(length=None if same_length else length, mass=mass))
    if not isinstance(bat, Bat):
        raise InputError(f"{pattern.name} is no bat")
    weighed = rigid_body(beam_model(bat)).mass
    return bat.replaced(name=f"{pattern.name}, {bat.length / INCH:.4g} in, {weighed / OUNCE:.4g} oz")
