"""A sport: its balls and implements, how fast things move in it, its limits, its distances and its words.

Data, not physics: every sport is computed by the same code. How sure each number is goes with it.
"""

from __future__ import annotations

from typing import Literal

from sweetspot.equipment.base import NonNegative, Positive, Validated

Certainty = Literal["measured", "specified", "derived", "fitted", "assumed"]
CERTAINTIES: tuple[Certainty, ...] = ("measured", "specified", "derived", "fitted", "assumed")
"""What a value can rest on, from the surest to a soft default; see the catalogue's own words for each."""
ASSUMED_MARK = "(assumed)"
"""Stands behind every number that no source was read for, wherever it is shown."""


class Fact(Validated):
    """A number of a sport and how sure it is.

    Parameters
    ----------
    name : what it is, for people.
    value : SI, in ``unit``; a ratio has the unit "".
    written : as the source writes it, with unit and spread.
    source, where : key of the bibliography and place in it.
    kind : what it rests on.
    """

    name: str
    value: float
    unit: str
    written: str
    source: str
    where: str
    kind: Certainty

    @property
    def marked(self) -> str:
        """As written, with the mark of a value from memory where it is one.

        >>> Fact(name="n", value=1.0, unit="m/s", written="1 m/s", source="recalled", where="", kind="assumed").marked
        '1 m/s (assumed)'
        """
        return f"{self.written} {ASSUMED_MARK}" if self.kind == "assumed" else self.written


class RuleLimit(Fact):
    """A limit of the rules: ``side`` says whether the value is the least or the most that is allowed."""

    side: Literal["least", "most"]


class CourtMark(Validated):
    """A place on court or field that a flight is compared with.

    Parameters
    ----------
    name : net, baseline, boundary.
    distance : how far from where the ball is usually hit, along the middle of the court.
    height : what the ball must clear there; None: a line on the ground.
    side : "beyond": the ball must pass it in the air; "before": it must land before it.
    """

    name: str
    distance: Fact
    height: Fact | None = None
    side: Literal["beyond", "before"]


class DropRule(Validated):
    """A drop test of a rule book.

    Parameters
    ----------
    name : of the test.
    material : catalogue name of what the ball falls on.
    block_thickness, side : m, of that block.
    block_support : how it is held, as in `sweetspot.dynamics.block.Block`.
    drop_height : m.
    printed : what the ball must come back to, as the source writes it.
    source : key of the bibliography.
    """

    name: str
    material: str
    block_thickness: Positive
    side: Positive
    block_support: Literal["clamped", "floor", "free"]
    drop_height: Positive
    printed: str
    source: str


class KnownMiss(Validated):
    """Where what we compute of a sport's implements is known to differ from measurements.

    Parameters
    ----------
    nearest, farthest : m from the tip, between which a hit is concerned.
    text : what was measured, what ours is, and what follows.
    source : key of the bibliography.
    """

    nearest: NonNegative
    farthest: Positive
    text: str
    source: str


class Terms(Validated):
    """Vocabulary of a sport; the defaults are baseball's.

    Parameters
    ----------
    implement : what the ball is hit with.
    tip, butt : its ends.
    efficiency : name of q, the rebound speed from an implement at rest over the speed of approach.
    ball : what is hit.
    incoming : the ball as it arrives.
    exit_speed : the ball's speed as it leaves.
    zone : where hits are good.
    hands : what holds it.
    smash_factor : name of exit speed over the implement's speed there, where people use it; "": they do not.
    strongest : name of the place of the greatest q, where it has one; "".
    deadest : name of the place where the ball hardly comes back, where it has one; "".
    speed_unit, place_unit, distance_unit : what people read speeds, places on the implement and flights in.
    mass_unit : what they weigh in; "": what goes with the unit of places.
    """

    implement: str = "bat"
    tip: str = "tip"
    butt: str = "knob"
    efficiency: str = "collision efficiency q"
    ball: str = "ball"
    incoming: str = "pitch"
    exit_speed: str = "exit speed"
    zone: str = "sweet zone"
    hands: str = "hands"
    smash_factor: str = ""
    strongest: str = ""
    deadest: str = ""
    speed_unit: Literal["mph", "m/s"] = "mph"
    place_unit: Literal["in", "cm"] = "in"
    distance_unit: Literal["ft", "yd", "m"] = "ft"
    mass_unit: Literal["oz", "g", ""] = ""

    @property
    def weighed_in(self) -> Literal["oz", "g"]:
        """The unit of weights and, with it, of moments of inertia."""
        return self.mass_unit or ("oz" if self.place_unit == "in" else "g")


class Stroke(Validated):
    """Usual swing of an implement in a sport.

    Parameters
    ----------
    swing_speed : of the implement towards the ball, where it is measured.
    from_tip : m, how far from the tip that is.
    ball_speed : of the ball towards the implement; 0 for a ball at rest.
    hands : m from the butt end, centre of the hand nearer to the ball.
    pivot : m from the butt end of the axis that the implement turns about; negative: behind it, in the arm.
    """

    swing_speed: Fact
    from_tip: NonNegative
    ball_speed: Fact
    hands: Positive
    pivot: float = 0.0


class Sport(Validated):
    """One sport.

    Parameters
    ----------
    key : catalogue name.
    name : what people call it.
    balls : catalogue names, the usual one first.
    aerodynamics : catalogue name of the coefficients of drag and lift of its balls.
    stroke : the usual one.
    words : what its people call things.
    speeds : other typical speeds and spins.
    limits : of the rules.
    marks : places on court or field.
    drops : drop tests of its rule book.
    facts : other published numbers.
    terms : (its word, what that is here).
    not_covered : what the model leaves out.
    misses : where it is known to be wrong.
    pitches : catalogue names of the pitches that are thrown, the usual one first; empty: none are.
    rules : catalogue name of the league whose rules hold for its bats; "": none are known.
    fields : catalogue names of fields with usual distances.
    swing_law : catalogue name of how bat speed depends on the bat.
    """

    key: str
    name: str
    balls: tuple[str, ...]
    aerodynamics: str
    stroke: Stroke
    words: Terms = Terms()
    speeds: tuple[Fact, ...] = ()
    limits: tuple[RuleLimit, ...] = ()
    marks: tuple[CourtMark, ...] = ()
    drops: tuple[DropRule, ...] = ()
    facts: tuple[Fact, ...] = ()
    terms: tuple[tuple[str, str], ...] = ()
    not_covered: tuple[str, ...] = ()
    misses: tuple[KnownMiss, ...] = ()
    pitches: tuple[str, ...] = ()
    rules: str = ""
    fields: tuple[str, ...] = ()
    swing_law: str = "baseball"

    def numbers(self) -> tuple[Fact, ...]:
        """Return every number of the sport with its certainty; those of its balls and implements are not here."""
        heights = tuple(mark.height for mark in self.marks if mark.height is not None)
        stroke = (self.stroke.swing_speed, self.stroke.ball_speed)
        return (*stroke, *self.speeds, *self.limits, *(mark.distance for mark in self.marks), *heights, *self.facts)


def counted(kinds: list[str]) -> dict[Certainty, int]:
    """Return the number of values by certainty, in the order of `CERTAINTIES`.

    >>> counted(["assumed", "measured", "assumed"])["assumed"]
    2
    """
    return {kind: kinds.count(kind) for kind in CERTAINTIES}
