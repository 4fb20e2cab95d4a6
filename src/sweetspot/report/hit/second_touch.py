"""What is not known of a ball that the bat hits again before it is gone, in words."""

from __future__ import annotations

import numpy as np

from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.arrays import Array
from sweetspot.report.sentences import Sentence, Slot, Span, UnitName, joined
from sweetspot.report.sport_words import in_words

AGAIN = (
    "{where} {implement} catches up with the {ball} and hits it again. How far a {ball} has recovered by then nobody "
    "has measured: it is taken as new{otherwise}."
)
PRESSED_AGAIN = (
    "{where} {implement} catches up with a {ball} that is nearly gone and presses it again. How far a {ball} has "
    "recovered by then nobody has measured"
)


def best_in_doubt(best: Impact, words: Terms) -> list[Sentence]:
    """Return what is not known of a best hit that presses the ball more than once; nothing of any other."""
    if best.presses < 2:
        return []
    return [
        in_words(
            PRESSED_AGAIN + ", and the best place and its speed follow from what is taken for it.", words,
            where="There the",
        )
    ]  # fmt: skip


def touched_again(impact: Impact, words: Terms) -> list[Sentence]:
    """Return the doubt of a hit whose ball is pressed more than once, in one sentence; nothing of any other."""
    if impact.presses < 2 and impact.unrecovered is None:
        return []
    if impact.unrecovered is None:
        return [in_words(PRESSED_AGAIN + ": it springs on as it was.", words, where="The")]
    gain = impact.unrecovered_gain
    otherwise = in_words(
        "; had it not recovered at all, it would leave {gain} {faster}", words, gain=Slot(abs(gain), "speed"),
        faster="slower" if gain < 0 else "faster",
    )  # fmt: skip
    return [in_words(AGAIN, words, where="The", otherwise=otherwise)]


def touched_again_at(
    perhaps: bool, words: Terms, *, modes: Modes, ball: Ball, position: float, closing_speed: float,
    lateral: float = 0.0,
) -> list[Sentence]:  # fmt: skip
    """Return the same for a hit of the compiled solver, which is made once more for it.

    Parameters
    ----------
    perhaps : whether the ball was touched again, or is nearby; else there is nothing to say.
    """
    if not perhaps:
        return []
    again = hit(modes, ball=ball, position=position, lateral=lateral, closing_speed=closing_speed)
    return touched_again(again, words)


def touched_again_between(from_tip: Array, touches: Array, words: Terms) -> list[Sentence]:
    """Return the same for hits along a bat, stretch by stretch.

    Parameters
    ----------
    from_tip : m, of neighbours along the bat, shape (n,).
    touches : how often the ball is touched there, shape (n,).
    """
    places = np.flatnonzero(touches > 1)
    if len(places) == 0:
        return []
    stretches = [from_tip[one] for one in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1)]
    spans = (
        Sentence((Span(float(one.min()), float(one.max()), "place", unit=False),))
        for one in sorted(stretches, key=np.min)
    )
    where = in_words(
        "Hit {places} {unit} from the {tip}, the", words, unit=UnitName("place"), places=joined(spans, " and "),
    )  # fmt: skip
    return [in_words(AGAIN, words, where=where, otherwise="")]
