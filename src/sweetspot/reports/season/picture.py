"""One picture of a season: exit speed against the ceilings, where bats met the ball, and what distances leave over.

What is left over stands by launch angle, exit speed, bearing and park, and what drag explains it by month.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import polars as pl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from sweetspot.catalog.league_batters import SQUARED_UP
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.panels import Panel, frame
from sweetspot.reports.pictures.style import MUTED, SMALL, styled
from sweetspot.reports.quantities import BLUE, ORANGE, RED, US, Reader
from sweetspot.reports.season.words import SCALES
from sweetspot.seasons.season_drag import DragOfMonth, LeftOver, drag_by_month, left_over_by
from sweetspot.units import INCH, grouped

PLACES, OFFSETS = np.linspace(0, 14, 57) * INCH, np.linspace(-2.4, 2.4, 49) * INCH
LABELS = {"launch_angle": "launch angle", "exit_speed": "exit speed", "bearing": "bearing, left to right field"}
FEW = 400
"""Balls below which each is a dot on the barrel: a map of so few is too pale to see."""
LONGEST = 46
"""Letters of a name beside a row."""
ROW, LEAST, LINE, AXIS = 2.9, 1.9, 0.165, 0.75
"""Inches of paper: a row of panels; the one of parks at least, each of its parks, its heading and axis."""


@styled
def season_figure(counted: pl.LazyFrame, *, title: str = "Season", reading: Reader = US) -> Figure:
    """Return the figure of a season's or a player's balls; panels that would be empty are left out."""
    names = counted.collect_schema().names()
    swung = "squared_up_ratio" in names and counted.select(pl.col("squared_up_ratio").count()).collect().item() > 0
    tables = {name: groups for name in LABELS if (groups := left_over_by(counted, name))}
    parks = left_over_by(counted, "park")
    named = bool(tables) and len(parks) > 1
    rows = [ROW] * (int(swung) + bool(tables)) + ([max(LEAST, AXIS + LINE * len(parks))] if named else [])
    rows = rows or [ROW]
    figure = Figure(figsize=(8.0, 0.6 + sum(rows)), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08)  # type: ignore[union-attr, call-arg]
    if title:
        figure.suptitle(title, weight="bold", x=0.02, ha="left", size=13, parse_math=False)
    grid = figure.add_gridspec(len(rows), 1, height_ratios=rows)
    if swung:
        upper = grid[0].subgridspec(1, 2)
        _ceilings(figure.add_subplot(upper[0]), counted)
        barrel_map(figure.add_subplot(upper[1]), counted, reading)
    if tables:
        middle = grid[int(swung)].subgridspec(1, len(tables))
        _left_over([figure.add_subplot(middle[part]) for part in range(len(tables))], tables, reading)
    if named:
        months = [month for month in drag_by_month(counted) if month.month != "all"]
        lower = grid[-1].subgridspec(1, 5)
        _by_park(figure.add_subplot(lower[:3] if months else lower[:]), parks, reading)
        if months:
            _by_month(figure.add_subplot(lower[3:]), months)
    if not swung and not tables:
        _speeds(figure.add_subplot(grid[0]), counted, reading)
    return figure


def _ceilings(axes: Axes, counted: pl.LazyFrame) -> None:
    table = (
        counted.select("squared_up_ratio", "league_ratio").filter(pl.col("squared_up_ratio").is_not_null()).collect()
    )
    bins = np.linspace(0.4, 1.2, 81 if len(table) > 4000 else 41 if len(table) > FEW else 17).tolist()
    for name, colour, label in (("squared_up_ratio", BLUE, "of this bat"), ("league_ratio", ORANGE, "of the league")):
        values = table[name].drop_nulls().to_numpy()
        if len(values) > len(table) / 10:  # of a few of the balls a curve beside all of them would mislead
            axes.hist(values, bins, histtype="step", color=colour, label=label, density=True)
    axes.axvline(SQUARED_UP, color=MUTED, linewidth=0.7, linestyle=":")
    axes.axvline(1.0, color=MUTED, linewidth=0.7)
    axes.set_ylim(0, 1.25 * axes.get_ylim()[1])
    axes.legend(frameon=False, loc="upper left", fontsize=SMALL)
    axes.set_yticks([])
    label = "exit speed over the ceiling (dotted: squared up from here)"
    frame(axes, Panel("How well the balls were hit", f"{grouped(len(table))} balls", x=label, grid="none"))


def barrel_map(axes: Axes, counted: pl.LazyFrame, reading: Reader = US) -> None:
    """Draw where on the barrel balls were met: one draw from what is known of each, so that doubt shows as width."""
    unit = reading.units["offset"]
    table = counted.select("from_tip_drawn", "offset").drop_nulls().collect()
    places, offsets = table["from_tip_drawn"].to_numpy() / unit.size, table["offset"].to_numpy() / unit.size
    bins = [PLACES / unit.size, OFFSETS / unit.size]
    if len(table) < FEW:
        axes.plot(places, offsets, "o", color=BLUE, markersize=3, markeredgewidth=0, alpha=0.6)
        axes.set(xlim=bins[0][[0, -1]], ylim=bins[1][[0, -1]])
    else:
        axes.hist2d(places, offsets, bins, cmap="Blues", cmin=1)
    axes.axhline(0, color=MUTED, linewidth=0.7)
    x, y = f"from the tip, {unit.name}", f"ball above the axis, {unit.name}"
    frame(axes, Panel("Where on the barrel", "one draw from what is known of each ball", x=x, y=y, grid="none"))


def _left_over(places: list[Axes], tables: Mapping[str, Sequence[LeftOver]], reading: Reader) -> None:
    unit = reading.units["distance"]
    for axes, (name, groups) in zip(places, tables.items(), strict=True):
        size, first = reading.units[SCALES[name]], axes is places[0]
        title, note = ("Tracked distance less carry", "with standard errors") if first else ("", "")
        x, y = f"{LABELS[name]}, {size.name}", unit.name if first else ""
        frame(axes, Panel(title, note if len(places) < 3 else "", x=x, y=y))
        axes.axhline(0, color=MUTED, linewidth=0.7)
        middle, mean, error = np.array([(group.middle, group.mean, group.error) for group in groups]).T
        mean, error = mean / unit.size, error / unit.size
        axes.errorbar(middle / size.size, mean, error, fmt="o", color=RED, markersize=3.5, linewidth=1.0)


def _by_park(axes: Axes, parks: Sequence[LeftOver], reading: Reader) -> None:
    unit = reading.units["distance"]
    mean, error = np.array([(park.mean, park.error) for park in parks]).T / unit.size
    _spread_by(axes, [str(park.name) for park in parks], mean, error, colour=RED)
    axes.axvline(0, color=MUTED, linewidth=0.7)
    frame(axes, Panel("By park", "tracked distance less carry", x=f"{unit.name}, with standard errors"))


def _by_month(axes: Axes, months: list[DragOfMonth]) -> None:
    drag, error = np.array([(month.drag, month.error) for month in months]).T
    _spread_by(axes, [month.month for month in months], drag, error, colour=BLUE)
    axes.axvline(1, color=MUTED, linewidth=0.7)
    frame(axes, Panel("Drag over the law's", "by month", x="ratio, with standard errors"))


def _spread_by(axes: Axes, names: list[str], means: Array, errors: Array, *, colour: str) -> None:
    """Draw a mean with its error a row, the first on top: names can be read there without turning the head."""
    rows = np.arange(len(names))
    axes.errorbar(means, rows, xerr=errors, fmt="o", color=colour, markersize=3.5, linewidth=1.0)
    axes.set_yticks(rows, [name if len(name) <= LONGEST else name[: LONGEST - 1] + "…" for name in names])
    axes.set_ylim(len(names) - 0.4, -0.6)


def _speeds(axes: Axes, counted: pl.LazyFrame, reading: Reader) -> None:
    unit = reading.units["speed"]
    values = counted.select("exit_speed").collect()["exit_speed"].drop_nulls().to_numpy()
    axes.hist(values / unit.size, whole_bins(values / unit.size).tolist(), histtype="step", color=BLUE)
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    frame(
        axes,
        Panel("Exit speeds", f"{grouped(len(values))} balls", x=f"exit speed, {unit.name}", y="balls", grid="none"),
    )


def whole_bins(values: Array) -> Array:
    """Return edges of bins of whole numbers, as wide as Freedman and Diaconis or, of few values, Sturges would.

    >>> whole_bins(np.array([3.2, 4.5, 4.6, 9.9])).tolist()
    [2.0, 4.0, 6.0, 8.0, 10.0]
    """
    width = max(1.0, np.round(np.diff(np.histogram_bin_edges(values, "auto"))[0]))
    first = np.floor(values.min() / width)
    return np.asarray(width * np.arange(first, np.floor(values.max() / width) + 2))
