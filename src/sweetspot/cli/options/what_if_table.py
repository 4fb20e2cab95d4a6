"""Options of a what-if table: one bat, varied in one way or in two at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.ranges import spread
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.two_way import Axis, Variation
    from sweetspot.cli.options.swing import SwingOptions
    from sweetspot.equipment.bat import Bat
    from sweetspot.motion.swing_law import SwingLaw
    from sweetspot.reports.document import Document
    from sweetspot.units import Kind

KINDS: dict[Variation, Kind] = {
    "mass": "mass", "bore_diameter": "length", "bore_depth": "length", "cup_depth": "length", "wall_factor": "ratio",
    "bat_speed": "speed", "pitch_speed": "speed",
}  # fmt: skip


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

    def document(self, bat: Bat, law: SwingLaw | None, swing: SwingOptions) -> Document:
        """Return the table of a bat."""
        from sweetspot import catalog
        from sweetspot.analysis.two_way import TableCell, what_if_table
        from sweetspot.cli.options.swing import conditions_for
        from sweetspot.cli.output import patience, progress
        from sweetspot.reports.comparison.two_way import two_way_document

        answer = self.cell.replace("-", "_")
        if answer not in TableCell.__dataclass_fields__:
            allowed = ", ".join(name.replace("_", "-") for name in TableCell.__dataclass_fields__)
            raise InputError(f"--cell was given as {self.cell}; allowed is one of {allowed}")
        columns = None if self.columns is None else _axis(self.columns, "--columns")
        with patience(), progress("cells") as report:
            table = what_if_table(
                bat, rows=_axis(self.rows, "--rows"), columns=columns,
                conditions=conditions_for(bat, swing), law=law, fill=catalog.material("cork"), progress=report,
            )  # fmt: skip
        return two_way_document(table, answer, bat.name)


def _axis(text: str | None, what: str) -> Axis:
    """Return an axis written as ``mass=29oz:33oz:5``: what is varied, from, to, and how many values."""
    from sweetspot.analysis.two_way import VARIATIONS, Axis
    from sweetspot.plausibility import check

    name, _, span = (text or "").partition("=")
    variation = next((quantity for quantity in VARIATIONS if quantity == name.strip().replace("-", "_")), None)
    if variation is None or span.count(":") != 2:
        allowed = ", ".join(quantity.replace("_", "-") for quantity in VARIATIONS)
        raise InputError(
            f"{what} was given as {text!r}; write what varies ({allowed}), then from, to and how many values: "
            "mass=29oz:33oz:5"
        )
    values = spread(span, KINDS[variation], what)
    for value, given in zip((values[0], values[-1]), span.split(":"), strict=False):
        check(value, name.strip(), given)
    return Axis(variation, values)
