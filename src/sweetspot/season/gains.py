"""What all balls of a season together would gain with each bat that their swings were tried with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import polars as pl

from sweetspot.season.counted import WITH
from sweetspot.season.output_columns import ENDINGS, columns_of_other
from sweetspot.season.season_table import Season
from sweetspot.units.dimensions import SPEED


@dataclass(frozen=True)
class OtherBatGain:
    """What the balls of a season would gain with another bat.

    Parameters
    ----------
    bat : its name.
    balls : hit with any other bat than this, and solved.
    gain, low, high : mean change of their exit speeds, m/s; 90 % by the swing law, which errs alike for all balls.
    """

    bat: str
    balls: int
    gain: Annotated[float, SPEED]
    low: Annotated[float, SPEED]
    high: Annotated[float, SPEED]


def bat_gains(season: Season) -> list[OtherBatGain]:
    """Return the gains with all bats that were tried; those are left out that no ball could be tried with."""
    contact, system = season.setting.contact, season.setting.system
    gains = []
    for other in () if contact is None else contact.others:
        gain = pl.col(f"{WITH}{other.name}").cast(pl.Float64)
        balls, mean = _mean(season.counted_parts(), gain)
        if not balls:
            continue
        _, low, high = (pl.col(column.heading(system)).cast(pl.Float64) for column in columns_of_other(other.name))
        _, width = _mean(season.balls_parts(), (high - low).filter(high > low))
        reach = width * ENDINGS["speed"][system][1] / 2
        gains.append(OtherBatGain(other.name, balls, mean, mean - reach, mean + reach))
    return gains


def _mean(parts: Sequence[pl.LazyFrame], value: pl.Expr) -> tuple[int, float]:
    """Return how often there is a value, and its mean, 0 of none; added up part by part, always in the same order."""
    count, total = 0, 0.0
    for part in parts:
        values = part.select(value.drop_nulls()).collect().to_series().to_numpy()
        count, total = count + len(values), total + float(values.sum())
    return count, total / max(count, 1)
