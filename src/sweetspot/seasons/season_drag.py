"""The season's own drag: what its tracked fly balls say of it, month by month, and what is left over of each kind."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import polars as pl

from sweetspot.catalog.aerodynamic_laws import CALCULATOR, aerodynamics, drag_spread
from sweetspot.catalog.ballparks import park
from sweetspot.errors import InputError
from sweetspot.flight.home_runs import USUAL
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, ROBUST_SCALE, Interval
from sweetspot.seasons.ball_maps import is_home_run
from sweetspot.units import DEGREE, MPH

FEWEST = 20
"""Fly balls below which nothing is said."""
CLIP = 3.0
"""Standard deviations beyond which a ball counts as one at that distance: balls off walls and wrong readings."""
SENSITIVE = -20.0
"""m per unit of the logarithm of drag; balls whose carry hangs on drag less than so tell nothing of it."""

SELECTED = 0.5
"""Part of the balls that are home runs, above which a table was made of home runs."""


@dataclass(frozen=True)
class DragOfMonth:
    """The drag by the fly balls of a month.

    ``month``: year and month; "all": everything. ``drag``: drag over that of the law (in that kind of park), 1: as the
    law says. ``error``: its standard error, over games.
    """

    month: str
    drag: float
    error: float
    flies: int
    games: int


def drag_by_month(counted: pl.LazyFrame, *, flown_with: float = 1.0) -> tuple[DragOfMonth, ...]:
    """Return drag over the law's, of all and of each month, from tracked distances.

    ``flown_with``: drag over the law's with which the carries were computed.

    Of each ball the logarithm of drag that would give its distance is (distance - carry) / (d carry / d log drag); the
    mean weighs balls by the square of the latter, and its error comes from the scatter between games.
    """
    names = counted.collect_schema().names()
    if "carry_above" not in names:
        return ()
    table = (
        counted.filter(pl.col("carry_above").is_not_null() & (pl.col("carry_per_drag") < SENSITIVE))
        .select("month", "carry_above", "carry_per_drag", game=pl.coalesce("game", "month", pl.lit("all")))
        .collect()
    )
    if len(table) < FEWEST:
        return ()
    months = [_drag(table, "all", flown_with)]
    for (month,), rows in sorted(table.drop_nulls("month").group_by("month"), key=lambda pair: str(pair[0][0])):
        if len(rows) >= FEWEST:
            months.append(_drag(rows, str(month), flown_with))
    return tuple(months)


SEASONS_DIFFER = drag_spread(aerodynamics(CALCULATOR))
"""Part of the drag by which whole seasons of balls differ, one standard deviation [nathan_calculator]."""
CARRIES = 4.0
"""Standard deviations of that beyond which distances are no carries of such balls: another unit, or where balls were
picked up [our choice]."""


@dataclass(frozen=True)
class OwnDrag:
    """The drag that a season's balls fly with, over that of the law.

    ``drag``, ``error``: the likeliest, with what is known before (`SEASONS_DIFFER`), and its standard error.
    ``measured``: what the distances alone say.
    """

    drag: float
    error: float
    measured: DragOfMonth


def own_drag(counted: pl.LazyFrame, *, flown_with: float = 1.0) -> OwnDrag | None:
    """Return the drag that balls fly with by their distances; None where these are too few, or no carries.

    ``flown_with``: drag over the law's with which the carries were computed.

    Logarithms of drag are normal about 0 before, with `SEASONS_DIFFER`, and the distances tell them with their error.
    """
    months = drag_by_month(counted, flown_with=flown_with)
    if not months:
        return None
    measured = months[0]
    change, error = float(np.log(measured.drag)), measured.error / measured.drag
    if abs(change) > CARRIES * float(np.hypot(SEASONS_DIFFER, error)):
        return None
    trust = SEASONS_DIFFER**2 / (SEASONS_DIFFER**2 + error**2)
    drag = float(np.exp(trust * change))
    return OwnDrag(drag, drag * error * float(np.sqrt(trust)), measured)


def _drag(rows: pl.DataFrame, month: str, flown_with: float) -> DragOfMonth:
    above = rows["carry_above"].cast(pl.Float64).to_numpy()
    slope = rows["carry_per_drag"].cast(pl.Float64).to_numpy()
    middle = np.median(above)
    spread = ROBUST_SCALE * np.median(np.abs(above - middle))
    above = np.clip(above, middle - CLIP * spread, middle + CLIP * spread)
    change = float(np.sum(above * slope) / np.sum(slope**2))
    _, game = np.unique(rows["game"].to_numpy(), return_inverse=True)
    pull = np.bincount(game, (above - change * slope) * slope)
    games = len(pull)
    if games < 2:  # one game, or games not known: balls stand alone
        pull = (above - change * slope) * slope
    error = float(np.sqrt(np.sum(pull**2) * len(pull) / max(len(pull) - 1, 1)) / np.sum(slope**2))
    drag = flown_with * float(np.exp(change))
    return DragOfMonth(month, drag, drag * error, len(rows), games)


def home_runs_with(counted: pl.LazyFrame, *, drag: float, error: float = 0.0) -> Interval | None:
    """Return the number of home runs if all balls flew with so much times the drag of their chances; 90 % by its error.

    A chance is that of a normal scatter of drag, sigma wide in that park, so drag that is f times theirs makes c
    into Phi(Phi^-1(c) - (f - 1) / sigma).

    None for a table without chances, or of hardly anything but home runs, which were selected by their carry.
    """
    from scipy.special import ndtr, ndtri

    gone = is_home_run(pl.col("event")).fill_null(value=False)
    chances = counted.filter(pl.col("home_run_here").is_not_null()).select("park", "home_run_here", gone=gone).collect()
    if not len(chances) or np.mean(chances["gone"].to_numpy()) > SELECTED:
        return None
    scatters = {name: _scatter(name) for name in chances["park"].unique()}
    scatter = chances["park"].replace_strict(scatters, return_dtype=pl.Float64).to_numpy()
    chance = ndtri(chances["home_run_here"].cast(pl.Float64).to_numpy())
    half = REACH * error
    least, middle, most = (float(ndtr(chance - (drag + off - 1) / scatter).sum()) for off in (half, 0.0, -half))
    return Interval(middle, least, most)


def _scatter(name: str | None) -> float:
    """Return the standard deviation of drag in a park; that in the open where it is no park of the catalogue."""
    try:
        return USUAL.drag(None if name is None else park(name))
    except InputError:
        return USUAL.drag(None)


@dataclass(frozen=True)
class LeftOver:
    """Mean tracked distance less carry of some balls, m.

    ``mean``, ``error``: and its standard error. ``middle``: of a bin, SI; None: no bin. ``name``: of a group; None: a
    bin.
    """

    mean: float
    error: float
    balls: int
    middle: float | None = None
    name: str | None = None


EDGES: Mapping[str, Array] = {
    "launch_angle": np.arange(15.0, 46.0, 3.0) * DEGREE,
    "exit_speed": np.arange(80.0, 116.0, 4.0) * MPH,
    "bearing": np.arange(-45.0, 46.0, 9.0) * DEGREE,
    "park": np.array([]),
}
"""What balls are compared by, and the edges of its bins in SI; none where it has names."""


def left_over_by(counted: pl.LazyFrame, kind: str) -> tuple[LeftOver, ...]:
    """Return mean tracked distance less carry in bins or groups of at least `FEWEST` balls; groups by their mean.

    ``kind``: a key of `EDGES`.
    """
    edges = EDGES[kind]
    tracked = counted.filter(pl.col("carry_above").is_not_null() & pl.col(kind).is_not_null())
    balls = tracked.select(value=pl.col(kind), above=pl.col("carry_above").cast(pl.Float64)).collect()
    places: list[tuple[float | None, str | None]]
    if len(edges):
        value = balls["value"].to_numpy()
        number = np.searchsorted(edges.astype(value.dtype), value, side="right") - 1
        places = [(float(middle), None) for middle in (edges[1:] + edges[:-1]) / 2]
    else:
        number = balls["value"].rank("dense").cast(pl.Int64).to_numpy() - 1
        places = [(None, name) for name in balls["value"].unique().sort()]
    inside = (number >= 0) & (number < len(places))
    number, above = number[inside], balls["above"].to_numpy()[inside]
    count = np.bincount(number, minlength=len(places))
    mean = np.bincount(number, above, len(places)) / np.maximum(count, 1)
    squares = np.bincount(number, (above - mean[number]) ** 2, len(places))
    error = np.sqrt(squares / np.maximum(count - 1, 1) / np.maximum(count, 1))
    groups = [
        LeftOver(float(mean[group]), float(error[group]), int(count[group]), *places[group])
        for group in np.flatnonzero(count >= FEWEST)
    ]
    return tuple(groups if len(edges) else sorted(groups, key=lambda group: (group.mean, str(group.name))))
