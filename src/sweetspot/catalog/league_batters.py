"""Where the batters of the major leagues lie, and how the hardest-hit balls at a bat speed were met."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np

from sweetspot.catalog.records import Entry, read_table
from sweetspot.numerics.arrays import Array
from sweetspot.plausibility import parse
from sweetspot.units import MPH, Kind

FILE = "league_batters.toml"
LEAGUE_BAT, LEAGUE_PITCH = 1.23, 0.23
"""The league's greatest exit speed per bat speed and per pitch speed at the plate [statcast]."""
SQUARED_UP = 0.80
"""Of the greatest exit speed, from which the league calls a ball squared up [statcast]."""


@dataclass(frozen=True)
class Quantiles:
    """Values of a quantity that shares ``levels`` of the batters lie below, both increasing."""

    levels: Array
    values: Array

    def level(self, value: float) -> float:
        """Return the share of batters below a value, beyond the outermost levels these.

        >>> Quantiles(np.array([0.1, 0.5, 0.9]), np.array([1.0, 2.0, 3.0])).level(2.5)
        0.7
        """
        return float(np.interp(value, self.values, self.levels))


@dataclass(frozen=True)
class HardestHit:
    """The hardest-hit fifth of the balls in a band of bat speed against the others; SI.

    Parameters
    ----------
    slowest, fastest : ends of the band.
    balls : how many it has.
    exit_speed : from which the fifth begins.
    best_off_path, others_off_path : median size of launch angle less attack angle.
    best_attack_angle, others_attack_angle : means.
    """

    slowest: float
    fastest: float
    balls: int
    exit_speed: float
    best_off_path: float
    others_off_path: float
    best_attack_angle: float
    others_attack_angle: float


@dataclass(frozen=True)
class LeagueBatters:
    """The batters of a league; ``slope``: of the squared-up share per m/s of bat speed, ``spread`` about that line."""

    name: str
    bat_speed: Quantiles
    squared_up: Quantiles
    slope: float
    spread: float

    def squared_up_at(self, bat_speed: float) -> float:
        """Return the usual squared-up share of batters with a bat speed in m/s."""
        middle = len(self.bat_speed.values) // 2
        return float(self.squared_up.values[middle] + self.slope * (bat_speed - self.bat_speed.values[middle]))


@cache
def major_league() -> LeagueBatters:
    """Return the batters of the major leagues.

    >>> round(major_league().squared_up_at(68 * MPH), 2)
    0.72
    """
    table = read_table(FILE)["batters"]
    levels = np.array(table.numbers("levels"))
    speed, squared = _quantities(table, "bat_speed", "speed"), np.array(table.numbers("squared_up"))
    slope = table.number("squared_up_slope") / MPH
    return LeagueBatters(
        table.name, Quantiles(levels, speed), Quantiles(levels, squared), slope, table.number("squared_up_spread")
    )


def hardest_hit(bat_speed: float) -> HardestHit | None:
    """Return the band that a bat speed in m/s lies in, None beyond them all."""
    return next((band for band in _bands() if band.slowest <= bat_speed < band.fastest), None)


@cache
def _bands() -> tuple[HardestHit, ...]:
    table = read_table(FILE)["hardest"]
    ends = pairwise(_quantities(table, "bat_speed", "speed").tolist())
    names: dict[str, Kind] = {
        "exit_speed": "speed",
        "best_off_path": "angle",
        "others_off_path": "angle",
        "best_attack_angle": "angle",
        "others_attack_angle": "angle",
    }
    columns = {name: _quantities(table, name, kind).tolist() for name, kind in names.items()}
    balls = table.numbers("balls")
    return tuple(
        HardestHit(slow, fast, int(balls[row]), **{name: values[row] for name, values in columns.items()})
        for row, (slow, fast) in enumerate(ends)
    )


def _quantities(table: Entry, field: str, kind: Kind) -> Array:
    return np.array([parse(text, kind, f"{FILE} {field}") for text in table.texts(field)])
