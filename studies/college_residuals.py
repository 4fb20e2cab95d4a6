"""What is left over of the college's flights, by everything measured: ``python -m studies.college_residuals FILE``.

Distance at the measured hang time, with the usual spin and with the measured one, and the launch direction solved from
the bearing, each less what was measured, is put against every other column as a straight line, one column at a time.
A game is a cluster. Of so many columns one in twenty is two standard errors off by chance.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import NDArray

from studies.air_law import Balls, college_balls, college_rows, in_use, residuals, solved_direction
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, FOOT, RPM

COLUMNS = {
    "launch angle": "Angle", "exit speed": "ExitSpeed", "spin rate": "HitSpinRate", "inning": "Inning",
    "contact ahead": "ContactPositionX", "contact height": "ContactPositionY", "contact side": "ContactPositionZ",
    "pitch speed": "RelSpeed", "pitch spin": "SpinRate", "pitch height": "PlateLocHeight", "pitch side": "PlateLocSide",
    "distance": "Distance",
}  # fmt: skip
FEW, SURE = 30, 2.5
"""Balls below which nothing is said, and standard errors from which a column is marked."""


def columns_of(table: pl.DataFrame, balls: Balls, beyond: Mapping[str, Array]) -> dict[str, Array]:
    """Return the columns by name, shape (balls,); ``beyond``: the line's spins less those measured."""
    found = {name: _numbers(table, heading) for name, heading in COLUMNS.items()}
    parts = [text.split(":") for text in table["Time"].cast(pl.String).fill_null("").to_list()]
    found["time of day, h"] = np.array(
        [int(part[0]) + int(part[1]) / 60 if len(part) > 1 else np.nan for part in parts]
    )
    return found | {
        "sine of the direction": np.sin(balls.direction),
        "pull": -balls.side * balls.direction / DEGREE,
        "right-handed": balls.side,
        "tracked part": _numbers(table, "LastTrackedDistance") / _numbers(table, "Distance"),
        "landing less sure": (table["HitLandingConfidence"] == "Medium").to_numpy().astype(float),
        "backspin beyond the line": -beyond["backspin"] / RPM,
        "sidespin beyond the line": -beyond["sidespin"] / RPM,
    }


def _numbers(table: pl.DataFrame, heading: str) -> Array:
    return table[heading].cast(pl.Float64).fill_null(np.nan).to_numpy()


def slope(values: Array, column: Array, games: NDArray[np.str_]) -> tuple[float, float] | None:
    """Return slope and its standard error, games as clusters, per standard deviation of the column; None of few.

    >>> column = np.arange(40.0)
    >>> found = slope(3 * column, column, np.repeat(["a", "b", "c", "d"], 10))
    >>> round(found[0] / float(np.std(column)), 3), round(found[1], 6)
    (3.0, 0.0)
    """
    there = np.isfinite(values) & np.isfinite(column)
    if there.sum() < FEW or np.std(column[there]) == 0:
        return None
    across = (column[there] - column[there].mean()) / column[there].std()
    apart = values[there] - values[there].mean()
    found = float(across @ apart / (across @ across))
    pulls = across * (apart - found * across)
    by_game = [pulls[games[there] == game].sum() for game in set(games[there])]
    return found, float(np.sqrt(np.sum(np.square(by_game))) / (across @ across))


def main(arguments: Sequence[str] | None = None) -> None:
    """Print means, standard deviations and slopes."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("file", type=Path, help="the college's table of hits")
    given = options.parse_args(arguments)
    table = college_rows(given.file)
    balls, law = college_balls(table), in_use()
    measured, usual = residuals(balls, law)
    columns = columns_of(table, balls, usual)
    left_over = {
        "distance, usual spin, ft": usual["along"][:, -1] / FOOT,
        "distance, measured spin, ft": measured["along"][:, -1] / FOOT,
        "launch direction, deg": solved_direction(balls, law) / DEGREE,
    }
    for name, values in left_over.items():
        there = np.isfinite(values)
        print(f"{name}: {there.sum()} balls, mean {values[there].mean():+.2f}, SD {values[there].std():.2f}")
        for heading, column in columns.items():
            if (found := slope(values, column, balls.game)) is not None:
                mark = "  *" if abs(found[0]) > SURE * found[1] else ""
                print(f"  {heading:25}{found[0]:+.2f} +- {found[1]:.2f} a standard deviation{mark}")


if __name__ == "__main__":
    main()
