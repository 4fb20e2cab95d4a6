"""What tracked distances leave over beside the carries: by launch angle, exit speed, bearing and park, and in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import polars as pl

from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.interval import Interval
from sweetspot.report.sentences import Sentence, Slot, say, within
from sweetspot.season.season_drag import FEWEST, DragOfMonth, home_runs_with, residuals, residuals_in
from sweetspot.units import DEGREE, MPH


@dataclass(frozen=True)
class Kind:
    """By what distances are compared.

    Parameters
    ----------
    label : in a sentence and under an axis.
    scale : of its values; "" where they are names.
    edges : of its bins, SI.
    """

    label: str
    scale: str
    edges: tuple[float, ...]


KINDS: Mapping[str, Kind] = {
    "launch_angle": Kind("launch angle", "angle", tuple(degree * DEGREE for degree in range(15, 46, 3))),
    "exit_speed": Kind("exit speed", "speed", tuple(mph * MPH for mph in range(80, 116, 4))),
    "bearing": Kind("bearing, left to right field", "angle", tuple(degree * DEGREE for degree in range(-45, 46, 9))),
    "park": Kind("park", "", ()),
}


def left_over_by(counted: pl.LazyFrame, kind: str) -> pl.DataFrame:
    """Return mean tracked distance less carry and its standard error, m, with ``balls`` and ``middle`` or ``name``.

    Bins and parks with fewer than `FEWEST` balls are left out.

    Parameters
    ----------
    counted : groups and measures of the balls.
    kind : a key of `KINDS`.
    """
    if kind == "park":
        return residuals_in(counted, "park")
    return residuals(counted, by=kind, edges=KINDS[kind].edges).filter(pl.col("balls") >= FEWEST)


def left_over_words(counted: pl.LazyFrame) -> list[Sentence]:
    """Return a sentence for each kind: where tracked distances are shortest and longest beside the carries."""
    told = []
    for name, kind in KINDS.items():
        table = left_over_by(counted, name).drop_nulls()
        if len(table) < 2:
            continue
        mean, error = table["mean"].to_numpy(), table["error"].to_numpy()
        weight = 1 / np.maximum(error, 1e-6) ** 2
        spread = float(np.sum(weight * (mean - np.average(mean, weights=weight)) ** 2))
        chance = len(mean) - 1
        beyond = "" if spread > chance + 2 * np.sqrt(2 * chance) else ", which chance alone could do"
        low, high = int(np.argmin(mean)), int(np.argmax(mean))
        told.append(say(
            "By {kind}: from {low} at {there} to {high} at {here}" + beyond + ".", kind=kind.label.split(",")[0],
            low=_slot(mean[low], error[low]), there=_where(table, low, kind),
            high=_slot(mean[high], error[high]), here=_where(table, high, kind),
        ))  # fmt: skip
    return told


def _slot(value: float, error: float) -> Slot:
    known, half = float(value), REACH * float(error)
    return Slot(Interval(known, known - half, known + half), "distance", digits=1, sign=True)


def _where(table: pl.DataFrame, row: int, kind: Kind) -> str | Slot:
    return Slot(table["middle"][row], kind.scale, digits=0) if kind.scale else str(table["name"][row])


def own_drag_words(counted: pl.LazyFrame, months: Sequence[DragOfMonth]) -> list[Sentence]:
    """Return what the season's own drag would change of the expected home runs, which fly with the law's."""
    home_runs = home_runs_with(counted, months[0]) if months else None
    if home_runs is None:
        return []
    words = (
        "They fly with the usual drag; the season's own, by its tracked distances, is {drag} of that, and with it "
        "{home_runs} would be expected."
    )
    return [say(words, drag=Slot(months[0].drag, "ratio", 3), home_runs=within(home_runs, "count"))]
