"""Bats beside a player's own: a single bat is livelier or deader than its description, and swings with it show it.

The fit has one liveliness for all bats of a file. Beside the player's own another bat's collision efficiency is off by
delta, normal with the standard deviation sqrt(2) times `bat_description`. Where both were swung, the difference of mean
exit speeds m, measured with the standard deviation s, tells delta: of a draw in which the model expects g and a
difference in efficiency is worth V = pitch speed + bat speed,

    delta | m  ~  normal(K (m - g) / V, (1 - K) sigma^2),    K = V^2 sigma^2 / (V^2 sigma^2 + s^2)
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Mapping, Sequence

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.player.bat_pairs import MeasuredBat, difference
from sweetspot.player.bat_response import BatResponse
from sweetspot.player.expected_gain import Expectation
from sweetspot.player.goal import Goal
from sweetspot.player.prior import fixed


def beyond_own(swung: Sequence[MeasuredBat], players_bat: Bat) -> Mapping[str, Interval]:
    """Return the mean exit speed of every bat of a file beyond that with the player's own, where both were measured."""
    mine = next((bat.exit_speed for bat in swung if bat.bat == players_bat), None)
    beyond = {bat.bat.name: difference(bat.exit_speed, mine) for bat in swung if bat.bat != players_bat}
    return {name: more for name, more in beyond.items() if more is not None}


def livelier(asked: Expectation, table: BatResponse, *, measured: Interval | None, name: str) -> Array:
    """Return by how much a bat's efficiency differs from its description beside the player's own, shape (draws,).

    ``measured``: m/s, its mean exit speed beyond that with the player's own; None: not measured. ``name``: of the bat;
    the same name has the same random numbers.
    """
    spread = math.sqrt(2) * fixed("bat_description")
    normal = np.random.default_rng(zlib.crc32(name.encode())).standard_normal(len(asked.draws))
    if measured is None:
        return spread * normal
    closing = asked.pitch_speed + asked.bat_speed(table)
    fast = Expectation(asked.model, asked.draws, Goal(), asked.pitch_speed, None, asked.scatter)
    expected = fast.of(table) - fast.of(asked.model.bats[0])
    noise = (measured.high - measured.low) / (2 * REACH)
    learned = (closing * spread) ** 2 / ((closing * spread) ** 2 + noise**2)
    return learned * (measured.value - expected) / closing + np.sqrt(1 - learned) * spread * normal
