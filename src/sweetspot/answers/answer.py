"""The methods of every answer, and the sources of the intervals of its numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from sweetspot.answers.records import Columns, PlainTable, Record, to_dict, with_intervals
from sweetspot.errors import missing_extras_named
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import LEVEL
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.uncertainty.intervals import reach_of_draws, variance_shares
from sweetspot.uncertainty.sources import Sources
from sweetspot.units.dimensions import System

if TYPE_CHECKING:
    import polars

Progress = Callable[[str], AbstractContextManager[Callable[..., None] | None]]
"""Begins a piece of work with a name; what it yields is called with (done, all)."""


@dataclass(frozen=True)
class Uncertainty:
    """The intervals of an answer, and the sources of that of its main number.

    Parameters
    ----------
    interval_level : probability that the true value lies inside an interval.
    draws : number of sampled answers from which the intervals come.
    of : the number whose variance is decomposed.
    shares : part of that variance that each source causes, the greatest first.
    sources : what the distribution of each source rests on.
    """

    interval_level: float
    draws: int
    of: str
    shares: Mapping[str, float]
    sources: Mapping[str, str]


@dataclass(frozen=True)
class DrawnAnswer:
    """Sampled answers.

    Parameters
    ----------
    normal : standard normal numbers behind every draw, shape (draws, n).
    columns : by the fields of the answer; the first draw is everything as described.
    """

    normal: Array
    columns: Columns


def uncertainty_of(drawn: DrawnAnswer, *, of: str, names: tuple[str, ...], sources: Mapping[str, str]) -> Uncertainty:
    """Return the variance of one number, such as "flight.carry", by its sources.

    ``names``: the source of each standard normal number. ``sources``: what each rests on.
    """
    column: Any = drawn.columns
    for step in of.split("."):
        column = column[int(step) if step.isdigit() else step]
    shares = variance_shares(drawn.normal[1:], names, column[1:])
    return Uncertainty(LEVEL, len(drawn.normal) - 1, of, shares, dict(sources))


def with_draws(plain: Record, drawn: DrawnAnswer, sources: Sources, *, of: str) -> Record:
    """Return an answer whose numbers have the intervals of their draws, and one number's variance by its sources."""
    found = uncertainty_of(drawn, of=of, names=sources.names, sources=sources.described)
    described: Record = replace(plain, uncertainty=found)  # type: ignore[type-var]
    return with_intervals(described, drawn.columns, reach_of_draws)


SHORT = 6
"""Numbers and texts of an answer that stand in its `repr`."""


class Answer(ShownInNotebooks):
    """An answer: a record that prints as on the command line, and that becomes a dictionary or a frame."""

    def __init_subclass__(cls) -> None:
        """Give every kind of answer a short `repr`: the decorator of a dataclass writes none where one stands."""
        super().__init_subclass__()
        if "__repr__" not in cls.__dict__:
            cls.__repr__ = Answer.__repr__  # type: ignore[method-assign]

    def __repr__(self) -> str:
        single = [f"{key}={value!r}" for key, (value,) in _cells(self.to_dict())]
        rest = ["..."] if len(single) > SHORT else []
        return f"{type(self).__name__}({', '.join([*single[:SHORT], *rest])})"

    def __str__(self) -> str:
        return ShownInNotebooks.renderer().text_of(self)

    def to_dict(self, units: System = "si") -> PlainTable:
        """Return all numbers, lists and texts with the unit in every key: "si" or "us"."""
        return to_dict(self, units)

    def to_frame(self, units: System = "si") -> polars.DataFrame:
        """Return the numbers and texts as a frame of one row, with those of parts as ``best_hit.exit_speed_m_s``.

        Lists and curves are left out; `to_dict` has them.
        """
        with missing_extras_named():
            import polars

        return polars.DataFrame(dict(_cells(self.to_dict(units))))


def _cells(table: Mapping[str, Any], of: str = "") -> Iterator[tuple[str, list[Any]]]:
    """Yield the columns of one row."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _cells(value, f"{of}{key}.")
        elif not isinstance(value, list):
            yield f"{of}{key}", [value]


def frame_of(rows: Sequence[object], units: System) -> polars.DataFrame:
    """Return records as a frame of a row each."""
    with missing_extras_named():
        import polars

    return polars.DataFrame([to_dict(row, units) for row in rows], infer_schema_length=None)
