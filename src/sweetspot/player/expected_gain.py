"""What a player can expect from a bat: the goal averaged over the scatter of many swings, for every posterior draw."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.player.bat_response import MIDDLE, RATIOS, BatResponse, farthest_offset
from sweetspot.player.goal import (
    CARRY,
    LINE,
    SPEED,
    BatInHand,
    CarryGrid,
    CarryTable,
    Goal,
    Scattered,
    WantedOfHit,
    fill_gains,
)
from sweetspot.player.model import PlayerModel, speed_ratio
from sweetspot.player.posterior import PlayerPosterior
from sweetspot.player.prior import NAMES, Population, fixed, natural, prior_draws
from sweetspot.units import FOOT

DRAWS, SWINGS = 160, 300
"""Draws of the posterior, and swings for each: the same for every bat, so that differences are not noise."""
USUAL_DRAWS = 400
"""Players drawn from those of whom nothing is known."""
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

    ``draws``: posterior draws, shape (draws, 10), SI. ``pitch_speed``: m/s at the plate. ``carries``: for goals that
    fly; None: for exit speed. ``scatter``: standard normal numbers, shape (4, draws, swings).
    """

    model: PlayerModel
    draws: Array
    goal: Goal
    pitch_speed: float
    carries: CarryTable | None
    scatter: Array = field(repr=False)

    def of(
        self,
        table: BatResponse,
        change: Change = NO_CHANGE,
        *,
        position: Array | None = None,
        offset: Array | None = None,
        livelier: Array | None = None,
    ) -> Array:
        """Return the expected goal for every draw, shape (draws,): m/s, m, or a part of the hits.

        Exit speed is the mean over balls that are hit: those that meet the barrel and are not just grazed. For carry
        and lines every swing counts, and one that is not a hit brings nothing; a ball computed to come down on the
        line is beyond it half of the times.

        ``table``: of the bat in the player's hands. ``position``, ``offset``: means in place of every draw's own, m,
        shape (draws,). ``livelier``: added to the collision efficiency, shape (draws,).
        """
        gains = np.empty(len(self.draws))
        fill_gains(
            self._in_hand(table),
            self._wanted(),
            self._scattered(table, change, position, offset, livelier),
            self.pitch_speed,
            gains,
        )
        return gains

    def bat_speed(self, table: BatResponse) -> Array:
        """Return the player's mean bat speed with a bat for every draw, m/s, where bat speed is measured."""
        ratio = speed_ratio(
            table,
            self.model.bats[0],
            law=self.model.law,
            speed_from_tip=self.model.speed_from_tip,
            exponent=self.draws[:, NAMES.index("exponent")],
        )
        return ratio * self.draws[:, NAMES.index("bat_speed")]

    def of_anybody(self, population: Population) -> Expectation:
        """Return the same question asked about players of a population in place of this one."""
        draws = natural(prior_draws(USUAL_DRAWS, seed=0, population=population))
        scatter = np.random.default_rng(0).standard_normal((4, len(draws), SWINGS))
        return replace(self, draws=draws, scatter=scatter)

    def _scattered(
        self,
        table: BatResponse,
        change: Change,
        position: Array | None,
        offset: Array | None,
        livelier: Array | None,
    ) -> Scattered:
        """Return the scatter of the swings of every draw."""
        value = {name: self.draws[:, index] for index, name in enumerate(NAMES)}
        ratio = self.bat_speed(table) / value["bat_speed"]
        return Scattered(
            speed=ratio * (value["bat_speed"] + change.bat_speed),
            position=(value["position"] if position is None else position) + change.position,
            offset=(value["offset"] if offset is None else offset) + change.offset,
            attack=value["attack_angle"] + change.attack_angle,
            speed_spread=value["bat_speed_spread"] + 0.0,
            position_spread=np.maximum(value["position_spread"] + change.position_spread, 0.0),
            offset_spread=np.maximum(value["offset_spread"] + change.offset_spread, 0.0),
            attack_spread=fixed("attack_angle_spread"),
            shift=value["efficiency_shift"] + (0.0 if livelier is None else livelier),
            normal=self.scatter,
        )

    def _in_hand(self, table: BatResponse) -> BatInHand:
        """Return a bat's tables; what counts as a hit is the own bat's, so that the same swings count for all."""
        reference, arm = self.model.bats[0], table.bat.length - table.bat.choke
        return BatInHand(
            arm=arm,
            measured_arm=arm - self.model.speed_from_tip,
            reach=float(reference.from_tip[-1]),
            farthest=farthest_offset(reference),
            place_step=float(table.from_tip[1] - table.from_tip[0]),
            efficiency=table.efficiency,
            efficiency_slope=table.efficiency_slope,
            offset_start=float(table.offset[0]),
            offset_step=float(table.offset[1] - table.offset[0]),
            ratio_start=float(RATIOS[0]),
            ratio_step=float(RATIOS[1] - RATIOS[0]),
            kept_step=float(table.places[1] - table.places[0]),
            retained=table.retained[MIDDLE],
            barrel=table.barrel,
        )

    def _wanted(self) -> WantedOfHit:
        """Return the goal as a function of a hit."""
        carries, line = self.carries, self.goal.line
        if carries is None:
            return WantedOfHit(SPEED, 0.0, 1.0, CarryGrid(np.zeros(3), np.ones(3), np.zeros((2, 2, 2))))
        return WantedOfHit(CARRY if line is None else LINE, line or 0.0, CARRY_SCATTER, carries.grid)


def expectation(
    posterior: PlayerPosterior, *, goal: Goal, pitch_speed: float, carries: CarryTable | None, seed: int
) -> Expectation:
    """Return the expectation over draws and swings, of which questions about bats are asked.

    ``pitch_speed``: m/s at the plate.
    """
    draws = posterior.thinned(DRAWS)
    scatter = np.random.default_rng(seed).standard_normal((4, len(draws), SWINGS))
    return Expectation(posterior.model, draws, goal, pitch_speed, carries, scatter)
