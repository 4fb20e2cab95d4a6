"""Options of every command that reads a table: what its columns mean."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.tables.headings import GivenColumns


@Parameter(name="*")
@dataclass(frozen=True)
class ColumnOptions:
    """What the columns of a table mean."""

    column: Annotated[
        list[str] | None,
        Parameter(help="What a heading means, where it is not understood: exit_speed=EV:mph; may be repeated."),
    ] = None
    file_units: Annotated[
        Literal["us", "metric"] | None,
        Parameter(help="Units of columns that name none: us (mph, inches, feet) or metric (m/s, cm, m)."),
    ] = None

    def given(self) -> GivenColumns:
        """Return the columns as described by the options."""
        from sweetspot.tables.headings import GivenColumns

        headings = {}
        for text in self.column or []:
            quantity, equals, heading = text.partition("=")
            if not equals or not heading:
                raise InputError(
                    f"--column was given as {text!r}; give quantity=heading, for example exit_speed=EV:mph"
                )
            headings[quantity.strip()] = heading.strip()
        return GivenColumns(headings, self.file_units)


DEFAULT_COLUMNS = ColumnOptions()
