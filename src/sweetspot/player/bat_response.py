"""What a bat does with a ball in the terms of a player's swings, worked out of its `ContactTable` once.

Two tables: collision efficiency along the bat at two closing speeds; and, for a ball met above or below the bat's
axis, the part of the exit speed that is left and how far the launch angle leaves the bat's path. The second is made all
along the bat: where the bat gives little back, less is left of the part along the line of centres and all of the part
across it, so the ball is turned further and loses less than near the best place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sweetspot.collision.contact_table import ContactTable, tabled_bat
from sweetspot.collision.hit_in_space import Contact
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes, steep_enough
from sweetspot.numerics.arrays import Array
from sweetspot.player.prior import fixed, priors
from sweetspot.units import INCH

REACH, PLACES = 16 * INCH, 65
"""m from the tip that are tabled, every quarter of an inch: beyond them a bat is hit by accident."""
SLOW, FAST = 40.0, 75.0
"""m/s; closing speeds between which collision efficiency is a straight line, and beyond which it goes on."""
BARREL = 6.0 * INCH
"""m from the tip of the row of the off-centre table that is looked at where one place must do."""
EVERY = 4
"""Of the places, those where the off-centre table is made: every inch."""
RATIOS = np.array([0.0, 0.5, 1.0, 1.5, 2.0])
"""Pitch speed over bat speed; 0: a tee."""
BAT_SPEEDS = np.array([31.0, 31.0, 34.0, 24.5, 18.4])
"""m/s, 6 in from the tip, that go with these: a usual swing at slow pitches, and usual pitches met by slow swings."""
STEEPER = np.radians([-20.0, -10.0, 0.0, 10.0, 20.0])
"""How much steeper than usual the swings of the table are."""
FARTHEST, OFFSETS = 0.97, 61
"""Largest offset as a part of both radii together, and how many offsets from one side to the other."""
MISSED = math.pi
"""rad, the deflection tabled where the ball is missed or goes back: none that a hit can have."""
MIDDLE = 2
"""Which of the swings is the usual one."""
SLOWEST, MOST_KEPT = 3.0, 3.0
"""m/s head-on, and part retained, beyond which a place gives nothing back and is hit by accident only."""
MEASURED = 6 * INCH
"""m from the tip where bat speed is measured, near enough for a ratio of speeds."""
SPREADS = ("swing_tilt", "pitch_descent", "pitch_backspin")
"""What differs from swing to swing and is not measured, though it turns the ball."""

BATS = 256
"""Bats that a process keeps: a league's batters swing the same few bats."""


@dataclass(frozen=True, eq=False)
class BatResponse:
    """One bat's answers; the same object for the same bat, so it is compared and retained by what it is.

    Parameters
    ----------
    moi : kg m^2 about the swing law's axis.
    from_tip : m, increasing, evenly spaced.
    efficiency, efficiency_slope : q at no closing speed, as the straight line would have it, and its change per m/s;
        shape of ``from_tip``.
    offset : m of the ball's centre above the bat's axis, increasing, evenly spaced.
    retained : part of the exit speed in line with the swing that is left, shape (steeper, places / 4, ratios, offsets).
    deflection : rad, launch angle minus attack angle, same shape; `MISSED` where there is no hit.
    unsteady : rad, by how much the deflection scatters since tilt, descent and spin differ from swing to swing, shape
        (ratios, offsets).
    """

    bat: Bat
    moi: float
    from_tip: Array
    efficiency: Array
    efficiency_slope: Array
    offset: Array
    retained: Array
    deflection: Array
    unsteady: Array

    @property
    def places(self) -> Array:
        """Where the off-centre table is made, m from the tip."""
        return self.from_tip[::EVERY]

    @property
    def barrel(self) -> int:
        """Which of these places is `BARREL`."""
        return int(np.argmin(np.abs(self.places - BARREL)))

    @property
    def usual(self) -> tuple[Array, Array]:
        """Part retained and deflection of the usual attack angle at `BARREL`, each of shape (ratios, offsets)."""
        return self.retained[MIDDLE, self.barrel], self.deflection[MIDDLE, self.barrel]


@lru_cache(maxsize=BATS)
def response_of(bat: Bat, *, ball: Ball, axis: float, like: BatResponse | None = None) -> BatResponse:
    """Return the tables of a bat.

    ``axis``: where the swing law takes the moment of inertia, m from the bottom of the grip. ``like``: another bat's,
    whose off-centre hits are taken over, for they hang on the barrel's width alone; None: worked out.
    """
    table = tabled_bat(bat, ball=ball)
    body = table.model.body
    if ball.mass >= body.mass:
        raise InputError(
            f"{bat.name} weighs {body.mass:.4g} kg and the ball {ball.mass:.4g} kg; allowed is a ball lighter "
            "than the bat"
        )
    from_tip = np.linspace(0.0, REACH, PLACES)
    slow, fast = (_efficiency(table, from_tip, speed) for speed in (SLOW, FAST))
    slope = (fast - slow) / (FAST - SLOW)
    still = slow - slope * SLOW
    if like is None:
        off_centre = _off_centre(table, from_tip[::EVERY], (still[::EVERY], slope[::EVERY]))
    else:
        off_centre = like.offset, like.retained, like.deflection, like.unsteady
    return BatResponse(bat, body.moi(bat.choke + axis), from_tip, still, slope, *off_centre)


def _efficiency(table: ContactTable, from_tip: Array, speed: float) -> Array:
    efficiency = table.efficiency(np.minimum(from_tip, 0.6 * table.bat.length), speed)
    found = np.isfinite(efficiency)
    if found.sum() < PLACES // 2:
        raise InputError(f"{table.bat.name} does not send the ball back on most of its barrel; check its wall")
    return np.interp(from_tip, from_tip[found], efficiency[found])


def _off_centre(table: ContactTable, places: Array, q: tuple[Array, Array]) -> tuple[Array, Array, Array, Array]:
    """Return offsets, part retained, deflection, and what the deflection scatters by; shapes of `BatResponse`.

    What is retained is a part of what q, at no closing speed and its change with that, gives a ball met in line with
    the swing: so hits are those of the collision, whatever their angle.

    ``q``: at the places, at no closing speed and its change per m/s.
    """
    bat = table.bat
    reach = table.ball.radius + float(bat.diameter_at(bat.length - BARREL)) / 2
    offset = np.linspace(-FARTHEST * reach, FARTHEST * reach, OFFSETS)
    grid: list[Array] = list(
        np.meshgrid(priors()["attack_angle"].centre + STEEPER, places, RATIOS, offset, indexing="ij")
    )
    speed, launch = _turned(table, grid)
    there = BAT_SPEEDS * _arm(bat, places)[:, None]
    closing = RATIOS * BAT_SPEEDS + there
    head_on = (q[0][:, None] + q[1][:, None] * closing) * closing + there
    retained = np.clip(speed / np.maximum(head_on, SLOWEST)[..., None], 0.0, MOST_KEPT)
    middle = [part[MIDDLE : MIDDLE + 1, np.argmin(np.abs(places - BARREL))][:, None] for part in grid]
    changes = []
    for name in SPREADS:
        spread = fixed(f"{name}_spread")
        ends = [_turned(table, middle, {name: fixed(name) + sign * spread})[1] for sign in (-1, 1)]
        changes.append(np.where(np.abs(np.array(ends)).max(axis=0) < MISSED, ends[1] - ends[0], 0.0)[0, 0] / 2)
    deflection = np.where(launch < MISSED, launch - grid[0], MISSED)
    return offset, retained, deflection, np.sqrt(np.sum(np.square(changes), axis=0))


def _turned(table: ContactTable, grid: list[Array], other: dict[str, float] | None = None) -> tuple[Array, Array]:
    """Return exit speed and launch angle, `MISSED` without a hit, for attack angles, places, ratios and offsets.

    The swing has the usual tilt, the pitch the usual descent and backspin but for what ``other`` says; off a tee
    there is neither.
    """
    attack, place, ratio, above = (part.ravel() for part in grid)
    usual = {name: fixed(name) for name in SPREADS} | (other or {})
    bat_speed = np.interp(ratio, RATIOS, BAT_SPEEDS)
    lifting = np.array([-usual["pitch_backspin"], 0.0, 0.0])  # of a ball that comes in along -y
    axes = path_axes(attack, 0.0, tilt=steep_enough(usual["swing_tilt"], attack), left=False)
    ahead = np.array([0.0, -math.cos(usual["pitch_descent"]), -math.sin(usual["pitch_descent"])])
    out = table.launches(
        swings=Swings(bat_speed * _arm(table.bat, place), axes),
        pitches=BallMotions(velocity=(ratio * bat_speed)[:, None] * ahead, spin=(ratio > 0)[:, None] * lifting),
        contact=Contact(table.bat.length - place, above),
    ).velocity
    launch = np.where(out[:, 1] > 0, np.arctan2(out[:, 2], np.hypot(out[:, 0], out[:, 1])), MISSED)
    shape = grid[0].shape
    return np.nan_to_num(np.linalg.norm(out, axis=-1)).reshape(shape), launch.reshape(shape)


def _arm(bat: Bat, place: Array) -> Array:
    """Return bat speed at places, m from the tip, over that where it is measured."""
    arm = bat.length - bat.choke
    return np.asarray((arm - place) / (arm - MEASURED))


@lru_cache(maxsize=BATS)
def farthest_offset(table: BatResponse) -> float:
    """Return the largest offset in m of a hit that is counted: up to it, every inch turns the ball further.

    Beyond it the ball is only grazed.
    """
    ends = []
    for row in table.usual[1]:
        hit = np.where(row < MISSED, row, 0.0)
        ends += [table.offset[int(np.argmax(hit))], -table.offset[int(np.argmin(hit))]]
    return float(min(ends))
