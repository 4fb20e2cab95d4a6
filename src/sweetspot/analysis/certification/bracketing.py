"""Reasons against a pass by measured shots: a maximum that is not bracketed, an impossible hit.

A limit holds for the greatest value along the bat, so a pass takes lower places on both sides of the best one; a fail
takes one place beyond the limit.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from sweetspot.tables.bad_row import BadRow
from sweetspot.units import INCH, format_length

BRACKET = 1.05 * INCH
"""m within which a place on either side of the best must have given less [our choice]."""
DEADEST = 0.02
"""Least q of a baseball at a bat's best place; less is a gate that did not see the ball come back [our choice]."""
LEAST_OF_BALL = 0.8
"""Of the ball's own restitution on a wall, which no bat's best place falls below: a wood bat has 1.03 [our choice]."""
MOST_UNUSED = 1 / 3
"""Part of a file's rows that may be left out of a pass [our choice]."""


@dataclass(frozen=True)
class Place:
    """Hits at one place: m from the knob end, how many, mean normalised BBCOR."""

    position: float
    count: int
    bbcor: float


def rows_doubt(used: int, unused: Sequence[BadRow]) -> str:
    """Return the reason why a file is no test of a bat: too many of its rows are no shots; "": it is a test."""
    if len(unused) <= MOST_UNUSED * (used + len(unused)):
        return ""
    (commonest, _), *_ = Counter(row.reason for row in unused).most_common(1)
    return (
        f"only {used} of {used + len(unused)} rows could be used, and a pass takes two thirds of them: mend the "
        f"file first (most often: {commonest})"
    )


def pass_doubt(
    places: Sequence[Place], best: Place, *, efficiency: float, ball_restitution: float, softball: bool, length: float
) -> str:
    """Return why a value within a limit is no pass yet, and what to shoot next; "": it is one.

    ``efficiency``: q there. ``softball``: whether q may be as small as a heavy ball makes it. ``length``: of the bat,
    m.
    """
    tip = length - best.position
    if best.bbcor < LEAST_OF_BALL * ball_restitution or (efficiency < DEADEST and not softball):
        return (
            f"the best place, {format_length(tip)} from the tip, gave q {efficiency:.4f} and a ball-bat restitution of "
            f"{best.bbcor:.3f}, where a wall gives {ball_restitution:.3f}: no bat is so dead where it hits best. "
            "Either its best place was not hit, or the gate that times the rebound, its unit or the end that places "
            "are counted from is wrong; shoot at 5, 6 and 7 in from the tip"
        )
    missing = [text for side in (1, -1) if (text := _not_lower(places, best, side, length))]
    if not missing:
        return ""
    return (
        f"the greatest value, {format_length(tip)} from the tip, may be greater beside it: {' and '.join(missing)}; "
        "shoot six balls there, until the best place lies between two that give less"
    )


def _not_lower(places: Sequence[Place], best: Place, side: int, length: float) -> str:
    """Return the fault on the side of the tip (1) or of the hands (-1); "" where a nearby place gave less."""
    where = "nearer to the tip" if side > 0 else "nearer to the hands"
    near = [place for place in places if 0 < side * (place.position - best.position) <= BRACKET]
    if not near:
        return f"{format_length(length - best.position - side * INCH)} from the tip, {where}, was not hit"
    if any(place.bbcor < best.bbcor for place in near):
        return ""
    nearest = min(near, key=lambda place: abs(place.position - best.position))
    return f"{format_length(length - nearest.position)} from the tip, {where}, gave no less"
