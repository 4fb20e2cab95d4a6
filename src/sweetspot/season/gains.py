"""What all balls of a season together would gain with each bat that their swings were tried with."""

from __future__ import annotations

from dataclasses import dataclass

import polars as pl

from sweetspot.season.counted import WITH
from sweetspot.season.output_columns import ENDINGS, columns_of_other
from sweetspot.season.season_table import Season


@dataclass(frozen=True)
class Gain:
    """What the balls of a season would gain with another bat.

    Parameters
    ----------
    bat : its name.
    balls : hit with any other bat than this, and solved.
    mean, low, high : of their exit speeds, m/s; 90 % interval by the swing law, which errs alike for all balls.
    """

    bat: str
    balls: int
    mean: float
    low: float
    high: float


def gains_of(season: Season) -> list[Gain]:
    """Return the gains with all bats that were tried; those are left out that no ball could be tried with."""
    contact, system = season.setting.contact, season.setting.system
    gains = []
    for other in () if contact is None else contact.others:
        name, size = f"{WITH}{other.name}", ENDINGS["speed"][system][1]
        known = season.counted().select(balls=pl.col(name).count(), mean=pl.col(name).cast(pl.Float64).mean())
        balls, mean = known.collect(engine="streaming").row(0)
        if not balls:
            continue
        _, low, high = (pl.col(column.heading(system)).cast(pl.Float64) for column in columns_of_other(other.name))
        width = (high - low).filter(high > low).mean()
        reach = (season.balls().select(width).collect(engine="streaming").item() or 0.0) * size / 2
        gains.append(Gain(other.name, int(balls), mean, mean - reach, mean + reach))
    return gains
