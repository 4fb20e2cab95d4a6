"""One picture of a season: exit speed against the ceilings, where bats met the ball, and what distances leave over.

What is left over stands by launch angle, exit speed, bearing and park, and what drag explains it by month.
"""

from __future__ import annotations

import numpy as np
import polars as pl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.report.pictures.style import MUTED, SMALL, heading, light_grid, styled
from sweetspot.report.quantities import BLUE, ORANGE, RED, US, Reader
from sweetspot.report.season.left_over import KINDS, left_over_by
from sweetspot.season.season_drag import drag_by_month
from sweetspot.units import INCH

BINS = np.linspace(0.4, 1.2, 81)
PLACES, OFFSETS = np.linspace(0, 14, 57) * INCH, np.linspace(-2.4, 2.4, 49) * INCH
BINNED = tuple(name for name, kind in KINDS.items() if kind.scale)


@styled
def season_figure(counted: pl.LazyFrame, *, title: str = "Season", reading: Reader = US) -> Figure:
    """Return the figure of a season's or a player's balls.

    Parameters
    ----------
    counted : groups and measures of the balls.
    """
    names = counted.collect_schema().names()
    swung = "squared_up_ratio" in names and counted.select(pl.col("squared_up_ratio").count()).collect().item() > 0
    tracked = counted.select(pl.col("carry_above").count()).collect().item() > 0
    parks = left_over_by(counted, "park") if tracked else None
    named = parks is not None and len(parks) > 1
    rows = int(swung) + int(tracked) + int(named) or 1
    figure = Figure(figsize=(8.0, 0.6 + 2.9 * rows), layout="constrained")
    figure.suptitle(title, weight="bold", x=0.02, ha="left", size=13)
    grid = figure.add_gridspec(rows, 6)
    row = 0
    if swung:
        _ceilings(figure.add_subplot(grid[0, :3]), counted)
        barrel_map(figure.add_subplot(grid[0, 3:]), counted, reading)
        row = 1
    if tracked:
        _left_over([figure.add_subplot(grid[row, 2 * part : 2 * part + 2]) for part in range(3)], counted, reading)
    if parks is not None and named:
        _by_park(figure.add_subplot(grid[row + 1, :4]), parks, reading)
        _by_month(figure.add_subplot(grid[row + 1, 4:]), counted)
    if not swung and not tracked:
        _speeds(figure.add_subplot(grid[0, :]), counted, reading)
    return figure


def _ceilings(axes: Axes, counted: pl.LazyFrame) -> None:
    table = counted.select("squared_up_ratio", "league_ratio").collect()
    for name, colour, label in (("squared_up_ratio", BLUE, "this bat's ceiling"), ("league_ratio", ORANGE, "league's")):
        values = table[name].drop_nulls().to_numpy()
        if len(values):
            axes.hist(values, BINS.tolist(), histtype="step", color=colour, label=f"over {label}", density=True)
    axes.axvline(0.8, color=MUTED, linewidth=0.7, linestyle=":")
    axes.axvline(1.0, color=MUTED, linewidth=0.7)
    axes.legend(frameon=False, loc="upper left", fontsize=SMALL)
    axes.set(xlabel="exit speed over the ceiling", yticks=[])
    heading(axes, "How well the balls were hit")


def barrel_map(axes: Axes, counted: pl.LazyFrame, reading: Reader = US) -> None:
    """Draw where on the barrel balls were met: one draw from what is known of each, so that doubt shows as width.

    Parameters
    ----------
    counted : groups and measures of the balls.
    """
    unit = reading.units["offset"]
    table = counted.select("from_tip_drawn", "offset").drop_nulls().collect()
    axes.hist2d(
        table["from_tip_drawn"].to_numpy() / unit.size, table["offset"].to_numpy() / unit.size,
        [PLACES / unit.size, OFFSETS / unit.size], cmap="Blues", cmin=1,
    )  # fmt: skip
    axes.axhline(0, color=MUTED, linewidth=0.7)
    axes.set(xlabel=f"from the tip, {unit.name}", ylabel=f"ball above the axis, {unit.name}")
    heading(axes, "Where on the barrel", "one draw from what is known of each ball")


def _left_over(places: list[Axes], counted: pl.LazyFrame, reading: Reader) -> None:
    unit = reading.units["distance"]
    for axes, name in zip(places, BINNED, strict=True):
        kind, table = KINDS[name], left_over_by(counted, name)
        size = reading.units[kind.scale]
        light_grid(axes)
        axes.axhline(0, color=MUTED, linewidth=0.7)
        axes.errorbar(
            table["middle"].to_numpy() / size.size, table["mean"].to_numpy() / unit.size,
            table["error"].fill_null(0).to_numpy() / unit.size, fmt="o", color=RED, markersize=3.5, linewidth=1.0,
        )  # fmt: skip
        axes.set(xlabel=f"{kind.label}, {size.name}")
    places[0].set(ylabel=f"{unit.name}")
    heading(places[0], "Tracked distance less carry")


def _by_park(axes: Axes, parks: pl.DataFrame, reading: Reader) -> None:
    unit = reading.units["distance"]
    light_grid(axes)
    axes.axhline(0, color=MUTED, linewidth=0.7)
    axes.errorbar(
        np.arange(len(parks)), parks["mean"].to_numpy() / unit.size, parks["error"].to_numpy() / unit.size, fmt="o",
        color=RED, markersize=3.5, linewidth=1.0,
    )  # fmt: skip
    axes.set_xticks(np.arange(len(parks)), parks["name"].to_list(), rotation=60, ha="right", fontsize=SMALL - 1)
    axes.set(ylabel=f"{unit.name}")
    heading(axes, "By park", "tracked distance less carry, with standard errors")


def _by_month(axes: Axes, counted: pl.LazyFrame) -> None:
    months = [one for one in drag_by_month(counted) if one.month != "all"]
    light_grid(axes)
    axes.axhline(1, color=MUTED, linewidth=0.7)
    axes.errorbar(
        np.arange(len(months)), [one.drag for one in months], [one.error for one in months], fmt="o", color=BLUE,
        markersize=3.5, linewidth=1.0,
    )  # fmt: skip
    axes.set_xticks(np.arange(len(months)), [one.month for one in months], rotation=60, ha="right", fontsize=SMALL - 1)
    heading(axes, "Drag over the law's", "by month")


def _speeds(axes: Axes, counted: pl.LazyFrame, reading: Reader) -> None:
    unit = reading.units["speed"]
    values = counted.select("exit_speed").collect()["exit_speed"].drop_nulls().to_numpy()
    axes.hist(values / unit.size, 60, histtype="step", color=BLUE)
    axes.set(xlabel=f"exit speed, {unit.name}", yticks=[])
    heading(axes, "Exit speeds")
