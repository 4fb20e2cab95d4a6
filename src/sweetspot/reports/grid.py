"""One answer over one or two things that are varied, and its table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sweetspot.numerics.arrays import Array
from sweetspot.reports.document import (
    Cell,
    Column,
    Table,
)
from sweetspot.reports.quantities import QUANTITIES, SCALES, Reader
from sweetspot.reports.sentences import Sentence, Slot, UnitName, joined, say

EXACT = {"ratio": 2, "pressure": 2, "angle": 1, "speed": 1, "mass": 1, "length": 2}
"""Digits of what is varied, by scale."""
DIGITS = {"hang_time": 2, "landing_angle": 0, "landing_speed": 0}
"""Digits of answers, where others than usual."""

Side = tuple[str, Sequence[float] | Array]
"""What is varied, a name of `QUANTITIES`, and its values in SI."""


@dataclass(frozen=True)
class Grid:
    """One answer in every cell.

    Parameters
    ----------
    answer : a name of `QUANTITIES`.
    down, across : what is varied; ``across`` may be None.
    values : SI, shape (down, across); nan where there is no answer.
    """

    answer: str
    down: Side
    across: Side | None
    values: Array

    @property
    def title(self) -> Sentence:
        """What is shown, and what is varied."""
        title = say("{answer}: {down} down", answer=_named(self.answer), down=_named(self.down[0]))
        return title if self.across is None else title + say(", {across} across", across=_named(self.across[0]))

    def table(self) -> Table:
        """Return the numbers."""
        heads = [Column("", right=True)]
        if self.across is None:
            heads.append(Column("", right=True))
        else:
            name, values = self.across
            heads += [Column(Sentence((varied(name, value),)), right=True) for value in values]
        rows: list[list[Cell]] = [
            [varied(self.down[0], first), *(self.cell(float(value)) for value in row)]
            for first, row in zip(self.down[1], self.values, strict=True)
        ]
        return Table(self.title, heads, rows)

    def cell(self, value: float) -> Slot:
        """Return one answer, without its unit."""
        return Slot(value, QUANTITIES[self.answer].scale, DIGITS.get(self.answer)).bare

    def number(self, value: float, reading: Reader) -> str:
        """Return one answer as a reader sees it, without its unit."""
        return self.cell(value).read(reading)


def varied(name: str, value: float) -> Slot:
    """Return one value of what is varied, without its unit."""
    scale = QUANTITIES[name].scale
    return Slot(value, scale, EXACT.get(scale, 0)).bare


def _named(name: str) -> Sentence:
    scale = QUANTITIES[name].scale
    unit = say("({unit})", unit=UnitName(scale)) if SCALES[scale].us.name else ""
    return joined([name.replace("_", " "), unit])
