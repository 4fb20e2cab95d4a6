"""Bats beside a player's own: a single bat is livelier or deader than its description, and swings with it show it.

The fit has one liveliness for all bats of a file. Bat i's collision efficiency is off by s_i, normal with the standard
deviation sigma, `bat_description`; beside the player's own, bat 0, by s_i - s_0, so that the own bat is as much one of
several as the others are. Mean exit speeds m_i of bats that were swung tell: of a draw in which the model expects g_i
beyond the own bat, and a difference in efficiency is worth V_i = pitch speed + bat speed,

    y_i = (m_i - m_0 - g_i) / V_i = s_i - s_0 + e_i,    cov(e_i, e_j) = (n_0^2 + n_i^2 [i = j]) / (V_i V_j)

with n_i the standard error of m_i. Draws s of the prior and e of the errors become draws of the posterior by

    s + K (y - H s - e),    K = sigma^2 H' (sigma^2 H H' + cov(e))^-1,    (H s)_i = s_i - s_0
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.player.bat_pairs import MeasuredBat
from sweetspot.player.bat_response import BatResponse, response_of
from sweetspot.player.expected_gain import Expectation
from sweetspot.player.goal import Goal
from sweetspot.player.prior import fixed

REPEATS = 10
"""Draws of how lively bats are for each draw of the player, where one of several is chosen: chances are then within one
or two points."""


@dataclass(frozen=True)
class Liveliness:
    """By how much bats' efficiencies differ from their descriptions, arrays of one shape (draws,).

    ``players_bat``: of the player's own. ``beside``: of bats that were measured, by name, beyond the own one's.
    """

    players_bat: Array
    beside: Mapping[str, Array]

    def of(self, name: str) -> Array:
        """Return by how much a bat's efficiency differs from its description beside the player's own."""
        measured = self.beside.get(name)
        return single_bat(name, len(self.players_bat)) - self.players_bat if measured is None else measured


def single_bat(name: str, count: int) -> Array:
    """Return draws of how much a bat's efficiency is off; the same name has the same random numbers."""
    return fixed("bat_description") * even_normals(count, seed=zlib.crc32(name.encode()))


def even_normals(count: int, *, seed: int) -> Array:
    """Return standard normal numbers in random order, one of each of as many equally likely stretches [mckay1979].

    Means over them scatter less than over independent ones, and so does the chance of a bat.

    >>> even_normals(4, seed=3).round(2).tolist()
    [1.15, 0.32, -0.32, -1.15]
    """
    from scipy.special import ndtri

    return np.random.default_rng(seed).permutation(np.asarray(ndtri((np.arange(count) + 0.5) / count)))


def gains_of_several(
    asked: Expectation, tables: Sequence[BatResponse], swung: Sequence[MeasuredBat] = ()
) -> Mapping[str, Array]:
    """Return the goal expected with each of several bats by name, each draw of the player `REPEATS` times.

    A goal is taken as a straight line in the efficiency; so there are draws enough to tell chances of bats that are
    nearly as good as each other.

    ``tables``: the player's own bat first. ``swung``: bats with their means; none of anybody.
    """
    lively, step = liveliness(asked, swung, repeats=REPEATS), fixed("bat_description")
    gained = {}
    for place, table in enumerate(tables):
        now = asked.of(table)
        gained[table.bat.name] = np.repeat(now, REPEATS)
        if place:
            slope = (asked.of(table, livelier=np.full(len(now), step)) - now) / step
            gained[table.bat.name] += np.repeat(slope, REPEATS) * lively.of(table.bat.name)
    return gained


def liveliness(asked: Expectation, swung: Sequence[MeasuredBat] = (), *, repeats: int = 1) -> Liveliness:
    """Return how lively the player's bats are, as far as their mean exit speeds tell.

    ``swung``: with their means; none of anybody. ``repeats``: draws of it for each of the player's.
    """
    model, count = asked.model, len(asked.draws) * repeats
    reference = model.bats[0]
    players_bat = single_bat(reference.bat.name, count)
    mine = next((bat.exit_speed for bat in swung if bat.bat == reference.bat), None)
    others = [bat for bat in swung if bat.bat != reference.bat and bat.exit_speed is not None]
    if mine is None or not others:
        return Liveliness(players_bat, {})
    fast = Expectation(model, asked.draws, Goal(), asked.pitch_speed, None, asked.scatter)
    now = fast.of(reference)
    beyond, closing = np.empty((count, len(others))), np.empty((count, len(others)))
    noise = np.array([_error(mine), *(_error(bat.exit_speed) for bat in others if bat.exit_speed is not None)])
    for place, bat in enumerate(others):
        table = response_of(bat.bat, ball=model.ball, axis=model.law.axis, like=reference)
        closing[:, place] = np.repeat(asked.pitch_speed + asked.bat_speed(table), repeats)
        measured = (bat.exit_speed or mine).value - mine.value
        beyond[:, place] = (measured - np.repeat(fast.of(table) - now, repeats)) / closing[:, place]
    single = np.stack([single_bat(bat.bat.name, count) for bat in others], axis=1)
    errors = noise * np.stack([even_normals(count, seed=place) for place in range(len(noise))], axis=1)
    off = beyond - (single - players_bat[:, None]) - (errors[:, 1:] - errors[:, :1]) / closing
    variance = fixed("bat_description") ** 2
    of_errors = (noise[0] ** 2 + np.diag(noise[1:] ** 2)) / (closing[:, :, None] * closing[:, None, :])
    # H H' is 1 + [i = j], for all differences share the own bat
    gain = variance * np.linalg.solve(variance * (1 + np.eye(len(others))) + of_errors, off[:, :, None])[:, :, 0]
    learned = players_bat - gain.sum(axis=1)
    single = single + gain
    return Liveliness(learned, {bat.bat.name: single[:, place] - learned for place, bat in enumerate(others)})


def _error(mean: Interval) -> float:
    """Return the standard error of a mean with its interval."""
    return (mean.high - mean.low) / (2 * REACH)
