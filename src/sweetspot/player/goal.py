"""The goals of a player as functions of a hit: exit speed, carry, or whether it passes a line."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes, steep_enough
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import NO_SPEED
from sweetspot.player.bat_response import BARREL
from sweetspot.player.gain_kernel import CarryGrid, fill_carries
from sweetspot.player.model import PlayerModel
from sweetspot.player.prior import fixed
from sweetspot.units import FOOT

GoalName = Literal["exit-speed", "carry", "line"]
HEIGHT, FORWARD = 0.9, 0.5
"""m above the ground and in front of the plate's tip where the ball is met."""
SPEEDS = np.linspace(0.0, 62.0, 17)
"""m/s of head-on exit speed."""
BAT_SPEED = 31.0
"""m/s at the barrel, of the hits that are flown."""
OFFSET_COUNT = 53
ATTACKS = np.radians(np.linspace(-20.0, 40.0, 13))
SHORTEST_LINE, LONGEST_LINE = 10.0, 200.0
NO_GAIN: dict[GoalName, float] = {"exit-speed": NO_SPEED, "carry": 0.05 * FOOT, "line": 0.005}
"""Of every goal, the change reported as none: half of the last digit shown of mph, ft and per cent."""


@dataclass(frozen=True)
class Goal:
    """What is wanted: fast hits, far hits, or hits beyond a line.

    Parameters
    ----------
    name : "exit-speed", "carry" or "line".
    line : m over the ground from the plate, for "line" only.
    """

    name: GoalName = "exit-speed"
    line: float | None = None

    def __post_init__(self) -> None:
        if self.name not in ("exit-speed", "carry", "line"):
            raise InputError(f"goal {self.name!r} is not known; allowed is exit-speed, carry or line")
        if (self.name == "line") != (self.line is not None):
            raise InputError(
                "a line goes with the goal line and with no other; give both, for example --goal line --line 300ft"
            )
        if self.line is not None and not SHORTEST_LINE <= self.line <= LONGEST_LINE:
            raise InputError(
                f"the line is {self.line:.4g} m ({self.line / FOOT:.4g} ft) away; allowed is "
                f"{SHORTEST_LINE / FOOT:.0f} to {LONGEST_LINE / FOOT:.0f} ft"
            )

    @property
    def nothing(self) -> float:
        """The greatest change that counts as none: m/s, m, or a part of all hits."""
        return NO_GAIN[self.name]


@dataclass(frozen=True)
class CarryTable:
    """Carry of a hit by head-on exit speed, offset and attack angle.

    Parameters
    ----------
    exit_speed, offset, attack_angle : the even grids, m/s, m and rad.
    carry : m, shape of the three grids together.
    """

    exit_speed: Array
    offset: Array
    attack_angle: Array
    carry: Array

    def at(self, exit_speed: Array, offset: Array, attack_angle: Array) -> Array:
        """Return the carry in m of hits, all shaped (n,), straight lines between the grids; beyond one its end."""
        carry = np.empty(len(exit_speed))
        fill_carries(self.grid, exit_speed, offset, attack_angle, carry)
        return carry

    @property
    def grid(self) -> CarryGrid:
        """The table as compiled code reads it."""
        grids = (self.exit_speed, self.offset, self.attack_angle)
        # whole rows, as that of exit speeds: for columns of an array `fill_gains` would be compiled anew
        first, second = (np.array([grid[at] for grid in grids]) for at in (0, 1))
        return CarryGrid(first, second - first, self.carry)


def carry_table(model: PlayerModel, *, pitch_speed: float, aerodynamics: Aerodynamics, air: Air) -> CarryTable:
    """Return the carry of hits off the player's own bat, to where they first touch the ground.

    The oblique collision gives direction and spin for every offset and attack angle; all speeds of a hit are then
    scaled together to every head-on exit speed, and flown.

    ``pitch_speed``: m/s at the plate.
    """
    reference = model.bats[0]
    bat = reduced_bat(reference.bat, ball=model.ball)
    offset = np.linspace(reference.offset[0], reference.offset[-1], OFFSET_COUNT)
    attack, above = (grid.ravel() for grid in np.meshgrid(ATTACKS, offset, indexing="ij"))
    descent = fixed("pitch_descent")
    pitch = pitch_speed * np.array([0.0, -math.cos(descent), -math.sin(descent)])
    struck = strikes(
        bat,
        ball=model.ball,
        swings=Swings(BAT_SPEED, path_axes(attack, 0.0, tilt=steep_enough(fixed("swing_tilt"), attack), left=False)),
        pitches=BallMotions(velocity=pitch, spin=np.zeros(3)),
        contact=Contact(reference.bat.length - BARREL, above),
    )
    efficiency = float(
        np.interp(
            BARREL,
            reference.from_tip,
            reference.efficiency + (pitch_speed + BAT_SPEED) * reference.efficiency_slope,
        )
    )
    head_on = efficiency * (pitch_speed + BAT_SPEED) + BAT_SPEED
    scale = np.repeat(SPEEDS / head_on, len(above))[:, None]
    flown = flights(
        BallMotions(
            velocity=np.tile(struck.velocity, (len(SPEEDS), 1)) * scale,
            spin=np.tile(struck.spin, (len(SPEEDS), 1)) * scale,
            position=np.array([0.0, FORWARD, HEIGHT]),
        ),
        FlightConditions(ball=model.ball, aerodynamics=aerodynamics, air=air),
    )
    forward = flown.landing_position[:, 1] > 0  # a ball that goes behind the plate is foul and carries nothing
    carry = np.where(flown.landed & forward, flown.carry, 0.0).reshape(len(SPEEDS), len(ATTACKS), OFFSET_COUNT)
    return CarryTable(SPEEDS, offset, ATTACKS, np.ascontiguousarray(carry.transpose(0, 2, 1)))
