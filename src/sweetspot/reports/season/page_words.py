"""What the page says over a season's pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.seasons.ball_maps import NEAR, BallMap
from sweetspot.units import grouped

NAMED = 3
"""Files that are named; of more only their number is given."""


def counted_balls(balls: float) -> str:
    """Return a number of balls with its noun.

    >>> counted_balls(1), counted_balls(12000)
    ('1 ball', '12,000 balls')
    """
    return f"{grouped(balls)} {'ball' if balls == 1 else 'balls'}"


def balls_words(
    whose: str | None,
    bat: str,
    *,
    balls: float,
    exit_speed: float | None,
    squared_up: float | None,
    from_best: float | None,
) -> Sentence:
    """Return how well some balls were hit, against the bat that all hitters are taken to swing."""
    of = "" if whose is None else f" of {whose}"
    if exit_speed is None:
        return say("No ball in play{of} is left by this choice.", of=of)
    speed = Slot(exit_speed, "speed")
    words = say("{balls} in play{of}: {speed} of exit speed", balls=counted_balls(balls), of=of, speed=speed)
    if squared_up is not None and from_best is not None:
        words += say(
            ", {share} squared up against {bat}, met {place} from its best place on average",
            share=Slot(squared_up, "share"),
            bat=bat,
            place=Slot(from_best, "offset"),
        )
    return words + "."


def barrel_words(barrel: BallMap) -> tuple[Sentence, Sentence]:
    """Return the explanation of the map of the barrel, and where most balls were met."""
    note = (
        "The barrel from the side, the tip at the right; each ball at one draw from what is known of it, so that doubt "
        "shows as width."
    )
    row, column = np.unravel_index(barrel.counts.argmax(), barrel.counts.shape)
    label = say(
        "Where on the barrel {balls} were met, most {place} from the tip and {offset} above the axis.",
        balls=counted_balls(barrel.counts.sum()),
        place=Slot(barrel.across[column], "place"),
        offset=Slot(barrel.along[row], "offset"),
    )
    outside = f" Outside of it: {barrel.outside}." if barrel.outside else ""
    return say("{note}", note=note + outside), label


def field_words(field: BallMap) -> tuple[Sentence, Sentence]:
    """Return the explanation of the map of the field, and what it shows."""
    note = say(
        "Where balls come down in still air, in boxes of {box}. Not drawn: {balls} that came down within {near} of "
        "home{beyond}.",
        box=Slot(field.across[1] - field.across[0], "distance"),
        balls=counted_balls(field.near),
        near=Slot(NEAR, "distance"),
        beyond=f", and {counted_balls(field.outside)} beyond the picture" if field.outside else "",
    )
    return note, say("The field from above with where balls come down.")


def read_words(rows: int, files: Sequence[str]) -> str:
    """Return how much of which files was read."""
    named = ", ".join(files[:NAMED]) + (f" and {len(files) - NAMED} more" if len(files) > NAMED else "")
    return f"{grouped(rows)} rows of {named}."
