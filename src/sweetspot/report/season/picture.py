"""One picture of a season: exit speed against the ceilings, where bats met the ball, and what distances leave over."""

from __future__ import annotations

import numpy as np
import polars as pl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.report.pictures.style import MUTED, SMALL, heading, light_grid, styled
from sweetspot.report.quantities import BLUE, ORANGE, RED, US, Reader
from sweetspot.season.season_drag import residuals
from sweetspot.units import DEGREE, INCH, MPH

BINS = np.linspace(0.4, 1.2, 81)
PLACES, OFFSETS = np.linspace(0, 14, 57) * INCH, np.linspace(-2.4, 2.4, 49) * INCH
LEFT_OVER = (
    ("launch_angle", np.arange(15, 46, 3) * DEGREE, "launch angle °", DEGREE),
    ("exit_speed", np.arange(80, 116, 4) * MPH, "exit speed", None),
    ("bearing", np.arange(-45, 46, 9) * DEGREE, "bearing °, left to right field", DEGREE),
)


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
    rows = int(swung) + int(tracked) or 1
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
    unit, speed = reading.units["distance"], reading.units["speed"]
    for axes, (name, edges, label, size) in zip(places, LEFT_OVER, strict=True):
        table = residuals(counted, by=name, edges=edges.tolist())
        light_grid(axes)
        axes.axhline(0, color=MUTED, linewidth=0.7)
        axes.errorbar(
            table["middle"].to_numpy() / (size or speed.size), table["mean"].to_numpy() / unit.size,
            table["error"].fill_null(0).to_numpy() / unit.size, fmt="o", color=RED, markersize=3.5, linewidth=1.0,
        )  # fmt: skip
        axes.set(xlabel=label if size else f"{label}, {speed.name}")
    places[0].set(ylabel=f"{unit.name}")
    heading(places[0], "Tracked distance less carry")


def _speeds(axes: Axes, counted: pl.LazyFrame, reading: Reader) -> None:
    unit = reading.units["speed"]
    values = counted.select("exit_speed").collect()["exit_speed"].drop_nulls().to_numpy()
    axes.hist(values / unit.size, 60, histtype="step", color=BLUE)
    axes.set(xlabel=f"exit speed, {unit.name}", yticks=[])
    heading(axes, "Exit speeds")
