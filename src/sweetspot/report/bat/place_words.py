"""Why a hit at one place is what it is: how fast the bat moves there, how it gives way, and what it keeps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.position_scan import Scan
from sweetspot.dynamics.rigid import RigidBody, effective_mass
from sweetspot.equipment.sport import Terms
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.report.sentences import Sentence, Slot, joined
from sweetspot.report.sport_words import in_words, weight

NEAR = 0.006
"""m from the best place within which a hit counts as the best one."""
LITTLE = 0.05
"""m/s below which a part of the difference is not worth a word."""


@dataclass(frozen=True)
class SpeedDifference:
    """What a place's exit speed owes to what, against the best place, m/s; the parts sum to ``whole``.

    Parameters
    ----------
    motion : the place moves faster or slower: (1 + q_r) of the change, q_r of a rigid bat at the best place.
    giving : a rigid bat there is lighter or heavier to the ball.
    keeping : the real bat bends, and its wall rings, more or less than at the best place.
    """

    position: float
    motion: float
    giving: float
    keeping: float

    @property
    def whole(self) -> float:
        """The difference, m/s: below zero where the ball leaves slower than at the best place."""
        return self.motion + self.giving + self.keeping


def speed_difference(scan: Scan, position: float, *, best: float, exit_speed: float | None = None) -> SpeedDifference:
    """Return what the exit speed at a place (m from the knob end) owes to what, against the best place.

    Parameters
    ----------
    exit_speed : m/s of a hit at that very place, where one was made; None: between the neighbours in the scan, which
        is wrong next to where a ball begins to be touched twice, since exit speeds jump there.
    """

    def at(values: Array, place: float) -> float:
        return float(np.interp(place, scan.position, values))

    rigid = at(scan.rigid_exit_speed, position) - at(scan.rigid_exit_speed, best)
    real = (at(scan.exit_speed, position) if exit_speed is None else exit_speed) - at(scan.exit_speed, best)
    motion = (1 + at(scan.rigid_efficiency, best)) * (at(scan.bat_speed, position) - at(scan.bat_speed, best))
    return SpeedDifference(position, motion, rigid - motion, real - rigid)


def why_here(
    difference: SpeedDifference, *, body: RigidBody, conditions: Conditions, best: float, words: Terms,
    in_the_middle: bool = True,
) -> Sentence:  # fmt: skip
    """Return why a ball met in the middle leaves a place as it does, with what each reason costs.

    Parameters
    ----------
    in_the_middle : whether the ball that is asked about is met so; else the best place is said to be that of others.
    """
    place = difference.position
    here, there = float(effective_mass(body, place)), float(effective_mass(body, best))
    if abs(place - best) < NEAR:
        this = "This is" if in_the_middle else "For a {ball} met in the middle this is"
        return in_words(
            this + " the best place along the {implement}: further out it moves faster but gives way more and bends "
            "more, further in it moves slower. The {ball} meets {mass} of {whole}.", words,
            mass=weight(here), whole=weight(body.mass),
        )  # fmt: skip
    swing = conditions.swing
    faster = swing.speed_at(place) - swing.speed_at(best)
    parts = [
        in_words(
            f"Against the best place the {{implement}} moves {{change}} {'faster' if faster > 0 else 'slower'} here "
            "({cost})", words, change=Slot(abs(faster), "speed"), cost=Slot(difference.motion, "speed", sign=True),
        ),
        in_words(
            "the {ball} meets {here} instead of {there} of it ({cost})", words,
            here=weight(here), there=weight(there), cost=Slot(difference.giving, "speed", sign=True),
        ),
    ]  # fmt: skip
    if abs(difference.keeping) > LITTLE:
        parts.append(
            in_words(
                f"it keeps {'more' if difference.keeping < 0 else 'less'} as vibration ({{cost}})", words,
                cost=Slot(difference.keeping, "speed", sign=True),
            )
        )  # fmt: skip
    total = in_words("together {whole}.", words, whole=Slot(difference.whole, "speed", sign=True))
    return joined([joined([*parts[:-1], "and"], ", ") + " " + parts[-1] + ":", total])


def why_off_axis(offset: float, cost: float, *, words: Terms) -> Sentence:
    """Return what it costs that the ball's centre lies off the implement's axis by so much; m and m/s."""
    met = f"Met {{offset}} {'above' if offset > 0 else 'below'} the middle, the {{ball}} "
    if abs(cost) <= LITTLE:
        return in_words(met + "leaves as fast as from the middle.", words, offset=Slot(abs(offset), "length"))
    return in_words(
        met + f"gets {'less' if cost < 0 else 'more'} of the swing ({{cost}}).",
        words, offset=Slot(abs(offset), "length"), cost=Slot(cost, "speed", sign=True),
    )  # fmt: skip


def why_backwards(offset: float, *, words: Terms) -> Sentence:
    """Return why a ball that is met so far off the implement's axis, m, leaves behind the batter."""
    met = f"Met {{offset}} {'above' if offset > 0 else 'below'} the middle, the {{ball}} "
    return in_words(
        met + "glances off the {implement} and goes on backwards.", words, offset=Slot(abs(offset), "length")
    )
