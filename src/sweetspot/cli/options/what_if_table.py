"""Options of a what-if table: one bat, varied in one way or in two at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.reading import spread
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.what_if import BatCell


@Parameter(name="*")
@dataclass(frozen=True)
class TableOptions:
    """One bat, varied in one way or in two at once."""

    rows: Annotated[
        str | None,
        Parameter(help="For one bat: what varies from row to row, as mass=29oz:33oz:5 or cup-depth=0in:1in:5."),
    ] = None
    columns: Annotated[
        str | None,
        Parameter(help="What varies across, as bore-depth=0in:12in:7; without it every answer has a column."),
    ] = None
    cell: Annotated[
        str, Parameter(help="What cells and picture show: exit-speed, bbcor, collision-efficiency, mass, ...")
    ] = "exit-speed"

    def sides(self) -> dict[str, tuple[float, ...]]:
        """Return the values that are varied, down the table and across it."""
        columns = [] if self.columns is None else [_axis(self.columns, "--columns")]
        return _only_once([_axis(self.rows, "--rows"), *columns])

    @property
    def answer(self) -> BatCell:
        """The answer that cells show."""
        from sweetspot.answers.what_if import BAT_CELLS

        found = next((name for name in BAT_CELLS if name == self.cell.replace("-", "_")), None)
        if found is None:
            allowed = ", ".join(name.replace("_", "-") for name in BAT_CELLS)
            raise InputError(f"--cell was given as {self.cell}; allowed is one of {allowed}")
        return found


def _only_once(sides: list[tuple[str, tuple[float, ...]]]) -> dict[str, tuple[float, ...]]:
    if len(sides) > 1 and sides[0][0] == sides[1][0]:
        raise InputError(f"rows and columns both vary {sides[0][0]}; vary two different things")
    return dict(sides)


def _axis(text: str | None, what: str) -> tuple[str, tuple[float, ...]]:
    """Return an axis written as ``mass=29oz:33oz:5``: what is varied, from, to, and how many values."""
    from sweetspot.analysis.what_if import VARIATIONS
    from sweetspot.plausibility import check
    from sweetspot.units.quantities import KIND_OF

    name, _, span = (text or "").partition("=")
    variation = next((quantity for quantity in VARIATIONS if quantity == name.strip().replace("-", "_")), None)
    if variation is None or span.count(":") != 2:
        allowed = ", ".join(quantity.replace("_", "-") for quantity in VARIATIONS)
        raise InputError(
            f"{what} was given as {text!r}; write what varies ({allowed}), then from, to and how many values: "
            "mass=29oz:33oz:5"
        )
    values = spread(span, KIND_OF.get(variation, "ratio"), what)
    for value, given in zip((values[0], values[-1]), span.split(":"), strict=False):
        check(value, name.strip(), given)
    return variation, values
