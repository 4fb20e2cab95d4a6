"""The columns that are put beside a table's own: name, unit and meaning, in one list."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, FOOT, INCH, MPH

System = Literal["us", "si"]
ENDINGS: Mapping[str, Mapping[System, tuple[str, float]]] = {
    "speed": {"us": ("_mph", MPH), "si": ("_m_s", 1.0)},
    "angle": {"us": ("_deg", DEGREE), "si": ("_rad", 1.0)},
    "length": {"us": ("_in", INCH), "si": ("_m", 1.0)},
    "distance": {"us": ("_ft", FOOT), "si": ("_m", 1.0)},
    "time": {"us": ("_s", 1.0), "si": ("_s", 1.0)},
    "ratio": {"us": ("", 1.0), "si": ("", 1.0)},
    "count": {"us": ("", 1.0), "si": ("", 1.0)},
    "text": {"us": ("", 1.0), "si": ("", 1.0)},
    "yes": {"us": ("", 1.0), "si": ("", 1.0)},
}
"""Ending of a column's name and size of its unit, by kind and system."""


@dataclass(frozen=True)
class OutputColumn:
    """A column that is put beside a table's own.

    Parameters
    ----------
    name : without its unit.
    kind : a key of `ENDINGS`.
    meaning : in one sentence.
    part : of the answers it belongs to: "flight", "contact" or "bats".
    """

    name: str
    kind: str
    meaning: str
    part: str

    def heading(self, system: System) -> str:
        """Return the name with its unit.

        >>> OutputColumn("carry", "distance", "how far", "flight").heading("us")
        'carry_ft'
        """
        return self.name + ENDINGS[self.kind][system][0]


def _part(part: str, rows: str) -> tuple[OutputColumn, ...]:
    columns = []
    for line in rows.strip().splitlines():
        name, kind, meaning = (cell.strip() for cell in line.split("|"))
        columns.append(OutputColumn(name, kind, meaning, part))
    return tuple(columns)


FLIGHT = _part("flight", """
flight_outcome     | text     | flown; direction unknown: flown to centre field, no chances; no launch angle: no flight
launch_direction   | angle    | in which it set out, from centre field, positive to right field; solved from its bearing
carry              | distance | to the ground, of the mean ball launched so in that park; what fly says
carry_spread       | distance | standard deviation of single flights about it
hang_time          | time     | to the ground
apex               | distance | highest point
landing_angle      | angle    | how steeply it comes down
carry_above        | distance | tracked distance less carry; fly balls and line drives only, caught ones to a glove
home_run_here      | ratio    | chance of a home run in the park it was hit in
home_runs_in_30    | count    | expected number of home runs over the thirty parks of that season
home_run_parks     | count    | in how many of the thirty parks a home run is likelier than not
home_run_kind      | text     | by those parks: no doubter all thirty; mostly gone 8 to 29; doubter fewer
""")  # fmt: skip

CONTACT = _part("contact", """
bat                | text     | the bat it was taken to be hit with
contact_outcome    | text     | ok, or why nothing can be told; grazed: no place of the barrel sends a ball off so
pitch_at_plate     | speed    | of the pitch over the front edge of the plate
ceiling            | speed    | greatest exit speed of this bat for this swing and pitch
squared_up_ratio   | ratio    | exit speed over that
squared_up         | yes      | whether that is at least 0.80
above_ceiling      | ratio    | chance that the ball truly was above the ceiling, measuring errors considered
above_improbable   | ratio    | chance that a perfect hit would be measured so far above the ceiling
league_ceiling     | speed    | greatest exit speed by the league's formula, which knows no bat
league_ratio       | ratio    | exit speed over that
league_squared_up  | yes      | whether that is at least 0.80
blast              | yes      | the league's: percent of its ceiling and mph of bat speed make 164 or more
kept_vertically    | ratio    | part of the ceiling that hitting over or under the ball leaves at the best place
offset             | length   | of the ball's centre above the bat's axis; positive: the bat came under it
offset_spread      | length   | standard deviation of that
from_tip           | length   | place along the bat, median; the next four are ends of its 50 and 90 % intervals
from_tip_low50     | length   | see from_tip
from_tip_high50    | length   | see from_tip
from_tip_low90     | length   | see from_tip
from_tip_high90    | length   | see from_tip
best_from_tip      | length   | where this bat hits best in this swing
from_best          | length   | distance from there, median; the next four are ends of its 50 and 90 % intervals
from_best_low50    | length   | see from_best
from_best_high50   | length   | see from_best
from_best_low90    | length   | see from_best
from_best_high90   | length   | see from_best
tip_side           | ratio    | chance that it was hit on the tip's side of the best place; 0.5: cannot be told
exit_speed_usual   | speed    | mean exit speed of such swings at such pitches, whatever place was met
exit_speed_rank    | ratio    | part of such balls that are hit less hard
""")  # fmt: skip
SIDES = ("", "_low", "_high")


def columns_of_other(name: str) -> tuple[OutputColumn, ...]:
    """Return the columns of a bat that every swing is tried with: what it would have given, and its 90 % interval."""
    stem = f"exit_speed_with_{name.replace('-', '_')}"
    said = f"exit speed of the same swing with {name}, met at the same place"
    return tuple(OutputColumn(stem + side, "speed", said, "bats") for side in SIDES)


class Words(NamedTuple):
    """A column of few words: which of them stands in each row.

    Parameters
    ----------
    words : None for nothing.
    number : index into the words, shape (n,).
    """

    words: tuple[str | None, ...]
    number: NDArray[np.int64]


def as_series(column: OutputColumn, values: Array | Words, system: System) -> pl.Series:
    """Return values in SI as a column in a system's unit; what is not finite is missing.

    Parameters
    ----------
    column : of the list.
    values : in SI; 1 and 0 for yes and no; words where the column's kind is text.
    """
    heading = column.heading(system)
    if isinstance(values, Words):
        return pl.Series(heading, values.words, dtype=pl.String).gather(values.number)
    if column.kind == "yes":
        return pl.Series(heading, values, nan_to_null=True).cast(pl.Boolean)
    scaled = np.asarray(values, float) / ENDINGS[column.kind][system][1]
    return pl.Series(heading, scaled.astype(np.float32), nan_to_null=True)
