"""Sentences with slots: words that are written once, and numbers that each reader sees in his own units."""

from __future__ import annotations

import math
import re
import string
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from sweetspot.calibration.measured import Measured
from sweetspot.numerics.interval import REACH, Interval, Number, interval_of
from sweetspot.reports.quantities import NOTHING, US, Reader
from sweetspot.units import grouped

PLUS_MINUS = "Plus or minus, and give or take: 90 % intervals."
"""What ± means wherever a number has one: `Doubtful` is given half of such an interval, `Slot` all of it."""
MOST_DIGITS = 6
"""Of an interval that is narrower than the digits of its number."""
SHARP = 1e-6
"""An interval narrower than this part of its number is none."""
LOPSIDED = 0.25
"""An interval whose sides differ by more than this part of its width is given by its ends."""


@dataclass(frozen=True)
class Slot:
    """A number in a sentence.

    Parameters
    ----------
    value : SI; with its interval where it has one.
    scale : how it is shown, a name of `SCALES`.
    digits : None: as many as is usual.
    sign : whether a plus is written.
    unit : whether its unit is written.
    round : whether zeros behind the point are left out: "3 mph", but "1.3 m/s".
    """

    value: Number
    scale: str
    digits: int | None = None
    sign: bool = False
    unit: bool = True
    round: bool = False

    def read(self, reader: Reader) -> str:
        """Return the number as a reader sees it, its interval beside it."""
        value = float(self.value)
        number = reader.number(value, self.scale, digits=self.digits, sign=self.sign)
        if number == NOTHING:
            return number
        unit = reader.behind(self.scale) if self.unit else ""
        sides = self._sides
        if sides is not None and all(map(math.isfinite, sides)) and sum(sides) > SHARP * abs(value):
            return self._give_or_take(value, sides, reader) + unit
        return (number.rstrip("0").rstrip(".") if self.round and "." in number else number) + unit

    @property
    def _sides(self) -> tuple[float, float] | None:
        """How far the interval goes below and above the value; None where there is none."""
        if isinstance(self.value, Interval):
            return (self.value.value - self.value.low, self.value.high - self.value.value)
        return None

    def _give_or_take(self, value: float, sides: tuple[float, float], reader: Reader) -> str:
        """Return number and interval, "103.9 ± 2.1" where it is as wide either way, else with its ends."""
        below, above = sides
        unit = reader.units[self.scale]
        places = unit.digits if self.digits is None else self.digits
        half = (below + above) / 2 / unit.size
        while half and places < MOST_DIGITS and round(half, places) == 0:
            places += 1
        number = reader.number(value, self.scale, digits=places, sign=self.sign)
        if abs(above - below) <= LOPSIDED * (above + below):
            return f"{number} ± {grouped(half, places)}"
        ends = (value - below, value + above)
        low, high = (reader.number(end, self.scale, digits=places, sign=self.sign) for end in ends)
        return f"{number} ({low} to {high})"

    @property
    def bare(self) -> Slot:
        """The number without its unit."""
        return replace(self, unit=False)


@dataclass(frozen=True)
class UnitName:
    """The name of a scale's unit in a sentence."""

    scale: str

    def read(self, reader: Reader) -> str:
        """Return the name as a reader has it."""
        return reader.unit(self.scale)


@dataclass(frozen=True)
class Span:
    """Two numbers, from the lower to the higher; one where a reader sees no difference.

    >>> Span(3.3, 3.4, "distance").read(US), Span(2.0, 3.4, "distance").read(US)
    ('11 ft', '7 to 11 ft')
    """

    low: float
    high: float
    scale: str
    digits: int | None = None
    unit: bool = True

    def read(self, reader: Reader) -> str:
        """Return both as a reader sees them."""
        low, high = (reader.number(end, self.scale, digits=self.digits) for end in (self.low, self.high))
        return (high if low == high else f"{low} to {high}") + (reader.behind(self.scale) if self.unit else "")


@dataclass(frozen=True)
class Doubtful:
    """A number and its doubt, SI: two digits of that, and no more of the number."""

    value: float
    doubt: float
    scale: str
    sign: bool = False

    def read(self, reader: Reader) -> str:
        """Return both as a reader sees them."""
        unit = reader.units[self.scale]
        places = 1 - math.floor(math.log10(self.doubt / unit.size))
        value, doubt = (round(number / unit.size, places) for number in (self.value, self.doubt))
        digits = max(places, 0)
        number = grouped(value, digits, sign=self.sign)
        return f"{number} ± {grouped(doubt, digits)}{reader.behind(self.scale)}"


@dataclass(frozen=True)
class Bounds:
    """The ends of a number's interval in brackets, without units; nothing where a reader sees one number three times.

    >>> Bounds(Slot(0.36, "speed"), 0.34, 0.36).read(US), Bounds(Slot(0.36, "speed"), 0.0, 0.36).read(US)
    ('', ' (0.0 to 0.8)')
    """

    value: Slot
    low: float
    high: float

    def read(self, reader: Reader) -> str:
        """Return the brackets as a reader sees them."""
        value, low, high = (
            replace(self.value.bare, value=end).read(reader) for end in (float(self.value.value), self.low, self.high)
        )
        return "" if value == low == high else f" ({low} to {high})"


Part = str | Slot | Span | UnitName | Doubtful | Bounds


@dataclass(frozen=True)
class Sentence:
    """Words with slots; `read` makes a text of them for a reader.

    >>> place = say("{near} to {far} from the tip", near=Slot(0.1016, "place").bare, far=Slot(0.1778, "place"))
    >>> place.read(US)
    '4.0 to 7.0 in from the tip'
    """

    parts: tuple[Part, ...]

    def read(self, reader: Reader) -> str:
        """Return the sentence as a reader sees it."""
        return "".join(part if isinstance(part, str) else part.read(reader) for part in self.parts)

    def __add__(self, other: Sentence | str) -> Sentence:
        """Return this sentence followed by another."""
        return Sentence((*self.parts, *((other,) if isinstance(other, str) else other.parts)))

    def __str__(self) -> str:
        """Return the sentence as an American reads it."""
        return self.read(US)


Words = str | Sentence
"""What a document takes for a text."""


FIELDS = string.Formatter()
WHOLE = re.compile(r"-?\d+")


def say(template: str, **slots: object) -> Sentence:
    """Return a template's words with its slots filled.

    Parameters
    ----------
    template : words with names in braces; behind a colon how a number is shown, "scale, digits, sign, bare, round,
        ends": a name of `SCALES`, and any of the fields of `Slot`, without a unit, or with the ends of its interval.
    slots : by name: a number in SI, a `Slot`, the name of a unit, a sentence, a word; a record's fields have dots.

    >>> say("hits {place:place, 0} from the {tip}", place=0.1524, tip="toe").read(US)
    'hits 6 in from the toe'
    """
    parts: list[Part] = []
    for words, name, shown_as, _ in FIELDS.parse(template):
        if words:
            parts.append(words)
        if name is not None:
            parts += _filled(FIELDS.get_field(name, (), slots)[0], shown_as or "")
    return Sentence(tuple(parts))


def _filled(slot: Any, shown_as: str) -> Sequence[Part]:
    """Return the text of a slot."""
    if isinstance(slot, Sentence):
        return slot.parts
    if isinstance(slot, (Slot, Span, UnitName, Doubtful, Bounds)):
        return (slot,)
    if not shown_as:
        return (str(slot),)
    scale, *options = shown_as.split(", ")
    digits = next((int(option) for option in options if WHOLE.fullmatch(option)), None)
    number = Slot(slot, scale, digits, "sign" in options, "bare" not in options, "round" in options)
    if "ends" not in options:
        return (number,)
    ends = interval_of(slot)
    return replace(number, value=ends.value), Bounds(replace(number, value=ends.value), ends.low, ends.high)


@dataclass(frozen=True)
class Line:
    """A row of a table of sentences: words, the fact with which they are said, and the one with which they are not."""

    words: str
    when: str = ""
    unless: str = ""


def tell(lines: Iterable[Line], **facts: object) -> Sentence:
    """Return the words of the lines whose facts hold, one after the other, with the facts in their slots.

    >>> lines = (Line("it leaves "), Line("{change:speed_change} slower", "loss"), Line("as before", unless="loss"))
    >>> tell(lines, loss=True, change=0.44704).read(US), tell(lines, loss=False).read(US)
    ('it leaves 1.0 mph slower', 'it leaves as before')
    """
    holding = (line for line in lines if _holds(line, facts))
    return Sentence(tuple(part for line in holding for part in say(line.words, **facts).parts))


def _holds(line: Line, facts: Mapping[str, object]) -> bool:
    return bool(not line.when or facts[line.when]) and not (line.unless and facts[line.unless])


def joined(sentences: Iterable[Words | Slot], between: str = " ") -> Sentence:
    """Return sentences one after the other; empty ones are left out."""
    parts: list[Part] = []
    for sentence in sentences:
        added = sentence.parts if isinstance(sentence, Sentence) else (sentence,)
        if any(added):
            parts += [between, *added] if parts else added
    return Sentence(tuple(parts))


def listed(texts: Sequence[str]) -> str:
    """Return texts one after the other, "and" before the last of them.

    >>> listed(["weigh it"]), listed(["mass", "shape", "wood"])
    ('weigh it', 'mass, shape and wood')
    """
    *first, last = texts
    return " and ".join([*filter(None, [", ".join(first)]), last])


def read(words: Words, reader: Reader) -> str:
    """Return words as a reader sees them."""
    return words if isinstance(words, str) else words.read(reader)


def within(
    interval: Interval, scale: str, *, digits: int | None = None, sign: bool = False, unit: bool = True
) -> Sentence:
    """Return a value with its interval, "+1.2 mph (+0.4 to +2.0)"; without one where the interval has no width."""
    value = Slot(interval.value, scale, digits, sign, unit)
    return Sentence((value, Bounds(value, interval.low, interval.high)))


def with_doubt(value: float, doubt: float, scale: str) -> Sentence:
    """Return a value with half of its 90 % interval, with no more digits than are known; alone where there is none.

    Parameters
    ----------
    doubt : standard deviation of the value.

    >>> with_doubt(1.88354e-1, 1.13e-2, "moi").read(US)
    '10,300 ± 1000 oz in²'
    """
    half = REACH * doubt
    return Sentence((Doubtful(value, half, scale) if half > 0 else Slot(value, scale),))


def measured_words(value: Measured, scale: str, *, sign: bool = False) -> Sentence:
    """Return a value with half the width of its interval, both to the second digit of that.

    >>> from sweetspot.reports.quantities import US
    >>> measured_words(Measured(171.8042, 0.2), "frequency").read(US)
    '171.80 ± 0.33 Hz'
    """
    half = value.half_width
    return Sentence((Doubtful(value.value, half, scale, sign) if half > 0 else Slot(value.value, scale, sign=sign),))
