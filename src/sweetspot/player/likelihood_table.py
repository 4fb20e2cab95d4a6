"""Everything about a player's swings that stays the same while parameters change."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.player.off_centre import OffsetPoints


class Table(NamedTuple):
    """Everything about the swings that does not change with the parameters; nan where not measured.

    Parameters
    ----------
    bat_speed, exit_speed, pitch_speed, attack_angle, position : (n,) SI.
    hit : (n,) whether more than the bat speed of the swing counts.
    bat : (n,) which bat, an index into the next three.
    efficiency, efficiency_slope : (bats, places) at the places of the grid.
    arm : (bats, places) bat speed at every place over that where bat speed is measured.
    points : what the launch angles say of the offsets, at these places.
    untold : (n,) which row of the next, for hits without a launch or attack angle; -1 for others.
    untold_kept : (rows, every `UNTOLD_EVERY` th offset, places) part of the head-on exit speed that is left there.
    untold_variance : of that, same shape.
    place_start, place_step : of the places, m.
    selected : (bats, attacks, places, offsets) part of the balls met so that count as hits.
    selected_step : m between these places.
    attack_start, attack_step : of these mean attack angles, less the usual one, rad.
    offset_start, offset_step : (bats,) of these offsets, m.
    constants : measuring error of bat speed and of position, spread of the attack angle, usual attack angle; part of
        the swings that are slow, by how much and with what spread; what the tabled hit is off by.
    """

    bat_speed: Array
    exit_speed: Array
    pitch_speed: Array
    attack_angle: Array
    position: Array
    hit: NDArray[np.bool_]
    bat: IntArray
    efficiency: Array
    efficiency_slope: Array
    arm: Array
    points: OffsetPoints
    untold: IntArray
    untold_kept: Array
    untold_variance: Array
    place_start: float
    place_step: float
    selected: Array
    selected_step: float
    attack_start: float
    attack_step: float
    offset_start: Array
    offset_step: Array
    constants: Array
