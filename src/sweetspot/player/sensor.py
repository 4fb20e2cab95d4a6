"""Errors of a bat sensor as prior knowledge: what all its bat speeds are off by together, and what single ones are.

A bat speed read as v (1 + b) with a bias b common to all swings leaves the ball's speed as it is, so ball and bat seem
livelier or deader than they are: with q the collision efficiency and p the pitch speed, by

    dq = -(1 + q) b v / (p + v)

The fit therefore takes bat speed as the sensor reads it, and gives the efficiency a prior that much wider.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from sweetspot.catalog.records import canonical, read_table
from sweetspot.player.prior import ANYBODY, NAMES, Population, priors

FILE = "sensors.toml"
USUAL_EFFICIENCY = 0.2
"""Collision efficiency of a barrel, near enough for a prior's width."""


@dataclass(frozen=True)
class Sensor:
    """A bat sensor's errors.

    ``speed_bias``: standard deviation of the part that all bat speeds are off by. ``speed_noise``: m/s, of single ones.
    ``angle_noise``: rad, of single attack angles.
    """

    name: str
    speed_bias: float
    speed_noise: float
    angle_noise: float

    def population(self, *, bat_speed: float, pitch_speed: float) -> Population:
        """Return the usual players as this sensor shows them, of speeds in m/s."""
        open_by = (1 + USUAL_EFFICIENCY) * self.speed_bias * bat_speed / (pitch_speed + bat_speed)
        spread = ANYBODY.spread.copy()
        spread[NAMES.index("efficiency_shift")] = float(np.hypot(1.0, open_by / priors()["efficiency_shift"].width))
        return replace(ANYBODY, spread=spread)


@cache
def sensor_of(system: str) -> Sensor | None:
    """Return the errors of the sensor whose file it is, None of a system whose errors are not known.

    >>> sensor_of("Blast").speed_bias, sensor_of("Statcast")
    (0.06, None)
    """
    table = read_table(FILE).get(canonical(system))
    if table is None:
        return None
    return Sensor(
        table.name,
        table.number("speed_bias"),
        table.quantity("speed_noise", "speed"),
        table.quantity("angle_noise", "angle"),
    )
