"""What a player's bat gives wherever the ball is met, and where this player meets it: for pictures."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.player.bat_response import MISSED, BatResponse
from sweetspot.player.model import arm_ratio
from sweetspot.player.off_centre import at_swings
from sweetspot.player.posterior import PlayerPosterior
from sweetspot.player.prior import NAMES
from sweetspot.units import INCH

PLACES = np.arange(0.0, 13.01, 0.25) * INCH
"""m from the tip that are mapped."""
CLOUD = 240
"""Contacts drawn: enough to see a shape, few enough to see each."""


@dataclass(frozen=True)
class ContactMap:
    """Exit speed by where the ball is met, and contacts as the player scatters them; SI.

    Parameters
    ----------
    from_tip, offset : m, the grids.
    exit_speed : m/s at the mean bat speed, shape (places, offsets); nan where the ball is missed.
    cloud : m, contacts from the tip and above the bat's axis, shape (2, contacts).
    """

    from_tip: Array
    offset: Array
    exit_speed: Array
    cloud: Array


def contact_map(posterior: PlayerPosterior, pitch_speed: float) -> ContactMap:
    """Return the map of the player's own bat.

    ``pitch_speed``: m/s at the plate.
    """
    table = posterior.model.bats[0]
    value = dict(zip(NAMES, np.median(posterior.draws, axis=0).tolist(), strict=True))
    retained, deflection = at_swings(table, np.array([pitch_speed / value["bat_speed"]]), np.zeros(1), PLACES)
    head_on = head_on_speeds(posterior, np.array([value["bat_speed"]]), pitch_speed)
    exit_speed = np.where(deflection[0] < MISSED / 2, head_on[0][:, None] * retained[0], np.nan)
    return ContactMap(PLACES, table.offset, exit_speed, _cloud(posterior))


def ceiling(posterior: PlayerPosterior, bat_speed: Array, pitch_speed: float) -> Array:
    """Return the greatest exit speed that the player's own bat allows at bat speeds, m/s, shape (n,)."""
    return np.asarray(head_on_speeds(posterior, bat_speed, pitch_speed).max(axis=1))


def head_on_speeds(posterior: PlayerPosterior, bat_speed: Array, pitch_speed: float) -> Array:
    """Return the exit speed in m/s of balls met in line with the swing at `PLACES`, shape (bat speeds, places).

    v = (q + s c) c + u, c = pitch + u, with u the bat's speed at the place and q as the player's bat has it.
    """
    table: BatResponse = posterior.model.bats[0]
    shift = posterior.learned["efficiency_shift"].interval.value
    arm = arm_ratio(table, PLACES, speed_from_tip=posterior.model.speed_from_tip)
    there = bat_speed[:, None] * arm
    closing = pitch_speed + there
    still, slope = (np.interp(PLACES, table.from_tip, part) for part in (table.efficiency, table.efficiency_slope))
    return np.asarray((still + shift + closing * slope) * closing + there)


def _cloud(posterior: PlayerPosterior) -> Array:
    """Return contacts of many draws, one of each: what is not sure of the mean is in them too."""
    draws = posterior.thinned(CLOUD)
    normal = np.random.default_rng(posterior.seed).standard_normal((2, len(draws)))
    mean = draws[:, [NAMES.index("position"), NAMES.index("offset")]].T
    spread = draws[:, [NAMES.index("position_spread"), NAMES.index("offset_spread")]].T
    return np.asarray(mean + spread * normal)
