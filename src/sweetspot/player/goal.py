"""The goals of a player as functions of a hit (exit speed, carry, passing a line), and their mean over swings."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

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
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.player.bat_response import BARREL
from sweetspot.player.model import PlayerModel
from sweetspot.player.prior import fixed
from sweetspot.units import FOOT

SPEED, CARRY, LINE = 0, 1, 2
"""What is gained: exit speed, carry, or whether a line is passed."""
INSIDE = 1.000001
"""The last place of a grid that has a neighbour is so many steps before its end."""
LEAST_KEPT = 0.1
"""Of the exit speed at the barrel: less is retained by grazing hits alone."""
SLOWEST = 1.0
"""m/s of the bat, below which pitch over bat speed is not followed."""


class BatInHand(NamedTuple):
    """A bat's tables as the kernel reads them: `BatResponse`, and where the player's own counts a hit.

    Parameters
    ----------
    arm, measured_arm : m from the axis of the swing to the tip, and to where bat speed is measured.
    reach, farthest : m; place from the tip and size of the offset up to which a swing is a hit.
    place_step : m between places.
    offset_start, offset_step : m.
    ratio_start, ratio_step : of pitch speed over bat speed.
    kept_step : m between the places of the next.
    barrel : which of these places the carries are made for.
    """

    arm: float
    measured_arm: float
    reach: float
    farthest: float
    place_step: float
    efficiency: Array
    efficiency_slope: Array
    offset_start: float
    offset_step: float
    ratio_start: float
    ratio_step: float
    kept_step: float
    retained: Array
    barrel: int


class CarryGrid(NamedTuple):
    """Carry on even grids of head-on exit speed, offset and attack angle.

    ``start``, ``step``: (3,) of the grids. ``carry``: m, shape of the three grids.
    """

    start: Array
    step: Array
    carry: Array


class WantedOfHit(NamedTuple):
    """What is gained by a hit.

    ``kind``: `SPEED`, `CARRY` or `LINE`. ``line``, ``scatter``: m, where the line is and the standard deviation of
    carries about those tabled. ``grid``: of carries, for all but exit speed.
    """

    kind: int
    line: float
    scatter: float
    grid: CarryGrid


class Scattered(NamedTuple):
    """How the swings of every draw scatter: means, shape (draws,), and spreads; SI.

    ``speed``, ``position``, ``offset``, ``attack``: means; speed with the bat in hand. ``speed_spread``,
    ``position_spread``, ``offset_spread``: standard deviations, shape (draws,). ``shift``: of the collision efficiency,
    shape (draws,). ``normal``: standard normal numbers, shape (4, draws, swings).
    """

    speed: Array
    position: Array
    offset: Array
    attack: Array
    speed_spread: Array
    position_spread: Array
    offset_spread: Array
    attack_spread: float
    shift: Array
    normal: Array


@inner(inline="always", error_model="numpy")
def _bracket(at: float, count: int) -> tuple[int, float]:
    """Return the lower neighbour on a grid of so many places, and how far on the way to the next one it is."""
    inside = min(max(at, 0.0), count - INSIDE)
    low = int(inside)
    return low, inside - low


@inner(inline="always", error_model="numpy")
def _retained(table: Array, i: int, down: float, j: int, side: float) -> float:
    """Return the straight line between four neighbours of a table of ratios and offsets."""
    left = table[i, j] * (1 - down) + table[i + 1, j] * down
    right = table[i, j + 1] * (1 - down) + table[i + 1, j + 1] * down
    return float(left * (1 - side) + right * side)


@inner(error_model="numpy")
def _carry(grid: CarryGrid, exit_speed: float, offset: float, attack: float) -> float:
    """Return the carry of a hit, straight lines between the grids; beyond a grid its end counts."""
    start, step, carry = grid.start, grid.step, grid.carry
    i, a = _bracket((exit_speed - start[0]) / step[0], carry.shape[0])
    j, b = _bracket((offset - start[1]) / step[1], carry.shape[1])
    k, c = _bracket((attack - start[2]) / step[2], carry.shape[2])
    total = 0.0
    for across in range(2):
        for up in range(2):
            weight = (b if across else 1 - b) * (c if up else 1 - c)
            slow, fast = carry[i, j + across, k + up], carry[i + 1, j + across, k + up]
            total += weight * (slow + a * (fast - slow))
    return float(total)


@compiled(nogil=True, error_model="numpy")
def fill_carries(grid: CarryGrid, exit_speed: Array, offset: Array, attack_angle: Array, carry: Array) -> None:
    """Fill the carry in m of hits, all of one shape (n,)."""
    for hit in range(len(carry)):
        carry[hit] = _carry(grid, exit_speed[hit], offset[hit], attack_angle[hit])


@compiled(nogil=True, error_model="numpy")
def fill_gains(bat: BatInHand, wanted: WantedOfHit, swings: Scattered, pitch: float, gains: Array) -> None:
    """Fill the expected goal of every draw, shape (draws,).

    Exit speed is the mean over hits; of carries and lines every swing counts, and one that is no hit brings nothing.

    ``pitch``: m/s at the plate.
    """
    draws, count = swings.normal.shape[1:]
    per_arm, per_place = 1 / bat.measured_arm, 1 / bat.place_step
    per_ratio, per_offset = 1 / bat.ratio_step, 1 / bat.offset_step
    for row in range(draws):
        total, hits = 0.0, 0
        for swing in range(count):
            place = swings.position[row] + swings.position_spread[row] * swings.normal[1, row, swing]
            above = swings.offset[row] + swings.offset_spread[row] * swings.normal[2, row, swing]
            if not (0 <= place <= bat.reach and abs(above) <= bat.farthest):
                continue
            hits += 1
            speed = swings.speed[row] + swings.speed_spread[row] * swings.normal[0, row, swing]
            there = speed * (bat.arm - place) * per_arm
            closing = pitch + there
            low, part = _bracket(place * per_place, len(bat.efficiency))
            still = bat.efficiency[low] + part * (bat.efficiency[low + 1] - bat.efficiency[low])
            rise = bat.efficiency_slope[low] + part * (bat.efficiency_slope[low + 1] - bat.efficiency_slope[low])
            head_on = max((still + swings.shift[row] + closing * rise) * closing + there, 0.0)
            ratio = pitch / max(speed, SLOWEST)
            i, down = _bracket((ratio - bat.ratio_start) * per_ratio, bat.retained.shape[1])
            j, side = _bracket((above - bat.offset_start) * per_offset, bat.retained.shape[2])
            k, along = _bracket(place / bat.kept_step, bat.retained.shape[0])
            near = _retained(bat.retained[k], i, down, j, side)
            far = _retained(bat.retained[k + 1], i, down, j, side)
            here = (1 - along) * near + along * far
            if wanted.kind == SPEED:
                total += head_on * here
                continue
            attack = swings.attack[row] + swings.attack_spread * swings.normal[3, row, swing]
            # the carries are those of hits at the barrel, that keep another part
            usual = _retained(bat.retained[bat.barrel], i, down, j, side)
            carry = _carry(wanted.grid, head_on * here / max(usual, LEAST_KEPT), above, attack)
            if wanted.kind == CARRY:
                total += carry
            else:
                total += 0.5 * math.erfc((wanted.line - carry) / (math.sqrt(2.0) * wanted.scatter))
        gains[row] = total / max(hits, 1) if wanted.kind == SPEED else total / count


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

    ``name``: "exit-speed", "carry" or "line". ``line``: m over the ground from the plate, for "line" only.
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

    ``exit_speed``, ``offset``, ``attack_angle``: the even grids, m/s, m and rad. ``carry``: m, shape of the three grids
    together.
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
            BARREL, reference.from_tip, reference.efficiency + (pitch_speed + BAT_SPEED) * reference.efficiency_slope
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
