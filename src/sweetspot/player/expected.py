"""What a player can expect from a bat: the goal averaged over the scatter of many swings, for every posterior draw."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.player.contact_tables import RATIOS, ContactTable, farthest_offset
from sweetspot.player.goal import CarryTable, Goal
from sweetspot.player.model import PlayerModel, arm_ratio, speed_ratio
from sweetspot.player.posterior import Posterior
from sweetspot.player.prior import NAMES, fixed
from sweetspot.units import FOOT

DRAWS, SWINGS = 160, 300
"""Posterior draws, and swings of the scatter for each: the same for every bat, so that differences are not noise."""
CARRY_SCATTER = 16.8 * FOOT
"""m; standard deviation of 492 tracked indoor fly balls about the carry computed for their launch [statcast]."""


@dataclass(frozen=True)
class Change:
    """Something else about the player: added to the parameters of every draw, SI; spreads never fall below zero."""

    bat_speed: float = 0.0
    position: float = 0.0
    position_spread: float = 0.0
    offset: float = 0.0
    offset_spread: float = 0.0
    attack_angle: float = 0.0


NO_CHANGE = Change()


@dataclass(frozen=True)
class Expectation:
    """A player's draws and one fixed set of swings, ready to be asked about bats and changes.

    Parameters
    ----------
    model : of the player.
    draws : posterior draws, shape (draws, 10), SI.
    goal : what is averaged.
    pitch_speed : m/s at the plate.
    carries : for goals that fly; None: for exit speed.
    scatter : standard normal numbers, shape (4, draws, swings).
    """

    model: PlayerModel
    draws: Array
    goal: Goal
    pitch_speed: float
    carries: CarryTable | None
    scatter: Array = field(repr=False)

    def of(
        self,
        table: ContactTable,
        change: Change = NO_CHANGE,
        *,
        position: Array | None = None,
        offset: Array | None = None,
    ) -> Array:
        """Return the expected goal for every draw, shape (draws,): m/s, m, or a part of the hits.

        Exit speed is the mean over balls that are hit: those that meet the barrel and are not just grazed. For carry
        and lines every swing counts, and one that is not a hit brings nothing; a ball computed to come down on the
        line is beyond it half of the times.

        Parameters
        ----------
        table : of the bat in the player's hands.
        change : of the player.
        position, offset : means in place of every draw's own, m, shape (draws,).
        """
        from scipy.special import ndtr

        speed, place, above, attack = self._swings(table, change, position, offset)
        own = self.model.bats[0]
        hit = (place >= 0) & (place <= own.from_tip[-1]) & (np.abs(above) <= farthest_offset(own))
        ball_out = self._head_on(table, speed, place)
        kept = _kept(table, above, self.pitch_speed / np.maximum(speed, 1.0))
        if self.carries is None:
            gained = ball_out * kept
        else:
            carry = self.carries.at(ball_out, above, attack)
            gained = carry if self.goal.line is None else ndtr((carry - self.goal.line) / CARRY_SCATTER)
        total: Array = np.sum(np.where(hit, gained, 0.0), axis=1)
        return np.asarray(total / (np.maximum(hit.sum(axis=1), 1) if self.carries is None else hit.shape[1]))

    def bat_speed(self, table: ContactTable) -> Array:
        """Return the player's mean bat speed with a bat for every draw, m/s, where bat speed is measured."""
        ratio = speed_ratio(
            table, self.model.bats[0], law=self.model.law, speed_from_tip=self.model.speed_from_tip,
            exponent=self.draws[:, NAMES.index("exponent")],
        )  # fmt: skip
        return ratio * self.draws[:, NAMES.index("bat_speed")]

    def _swings(
        self, table: ContactTable, change: Change, position: Array | None, offset: Array | None
    ) -> tuple[Array, Array, Array, Array]:
        """Return bat speed, place, offset and attack angle of every swing, shape (draws, swings)."""
        value = {name: self.draws[:, index : index + 1] for index, name in enumerate(NAMES)}
        ratio = (self.bat_speed(table) / self.draws[:, NAMES.index("bat_speed")])[:, None]
        centre = value["position"] if position is None else position[:, None]
        middle = value["offset"] if offset is None else offset[:, None]
        scatter = self.scatter
        speed = ratio * (value["bat_speed"] + change.bat_speed) + value["bat_speed_spread"] * scatter[0]
        along = np.maximum(value["position_spread"] + change.position_spread, 0.0)
        across = np.maximum(value["offset_spread"] + change.offset_spread, 0.0)
        attack = value["attack_angle"] + change.attack_angle + fixed("attack_angle_spread") * scatter[3]
        return (
            speed,
            centre + change.position + along * scatter[1],
            middle + change.offset + across * scatter[2],
            attack,
        )

    def _head_on(self, table: ContactTable, speed: Array, place: Array) -> Array:
        there = speed * arm_ratio(table, place, speed_from_tip=self.model.speed_from_tip)
        closing = self.pitch_speed + there
        at = place / (table.from_tip[1] - table.from_tip[0])  # even, from the tip on
        low = np.clip(at, 0, len(table.from_tip) - 1.000001).astype(np.int64)
        part = np.clip(at - low, 0.0, 1.0)
        still, rise = (
            values[low] + part * (values[low + 1] - values[low])
            for values in (table.efficiency, table.efficiency_slope)
        )
        efficiency = still + self.draws[:, NAMES.index("efficiency_shift"), None] + closing * rise
        return np.asarray(np.maximum(efficiency * closing + there, 0.0))


def expectation(
    posterior: Posterior, *, goal: Goal, pitch_speed: float, carries: CarryTable | None, seed: int
) -> Expectation:
    """Return what questions about bats are asked of.

    Parameters
    ----------
    pitch_speed : m/s at the plate.
    carries : for goals that fly.
    seed : of the scatter.
    """
    draws = posterior.thinned(DRAWS)
    scatter = np.random.default_rng(seed).standard_normal((4, len(draws), SWINGS))
    return Expectation(posterior.model, draws, goal, pitch_speed, carries, scatter)


def _kept(table: ContactTable, offset: Array, ratio: Array) -> Array:
    """Return the part of the head-on exit speed that is left, straight lines between the table's rows and columns."""
    rows = np.clip((ratio - RATIOS[0]) / (RATIOS[1] - RATIOS[0]), 0, len(RATIOS) - 1.000001)
    step = table.offset[1] - table.offset[0]
    columns = np.clip((offset - table.offset[0]) / step, 0, len(table.offset) - 1.000001)
    i, j = rows.astype(np.int64), columns.astype(np.int64)
    down, across = rows - i, columns - j
    left = table.kept[i, j] * (1 - down) + table.kept[i + 1, j] * down
    right = table.kept[i, j + 1] * (1 - down) + table.kept[i + 1, j + 1] * down
    return np.asarray(left * (1 - across) + right * across)
