"""What a player's swings are ready for a likelihood as, and how many of the balls met count as hits; compiled.

Hits are those that leave within a range of launch angles. What part does so is in a table by place, offset and mean
attack angle; here it is weighted with where a player meets the ball.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import compiled
from sweetspot.player.off_centre import UNTOLD_EVERY, OffsetPoints

GRID_REACH = 4.5
"""Standard deviations of the scatter to either side of its mean that are summed over: there a place weighs less than a
wrong reading does, so that the likelihood has no step where a place is no longer summed over."""
TINY = 1e-300
ROOT_TWO_PI = math.sqrt(2 * math.pi)


class LikelihoodTable(NamedTuple):
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


@compiled(nogil=True)
def _rows_at(table: LikelihoodTable, bat: int, steeper: float) -> tuple[Array, Array, float]:
    """Return the parts of hits at the two tabled mean attack angles about one, and how far it lies between them."""
    rows = table.selected[bat]
    at = min(max((steeper - table.attack_start) / table.attack_step, 0.0), len(rows) - 1.000001)
    index = int(at)
    return rows[index], rows[index + 1], at - index


@compiled(nogil=True)
def fill_hits(hits: Array, weight: Array, table: LikelihoodTable, bat: int, parameters: Array, steeper: float) -> float:
    """Fill the share of hits among the balls met at every tabled offset; return the probability of a hit.

    ``weight``: (places,) of `LikelihoodTable.selected`, room to work in. ``parameters``: (10,) SI. ``steeper``: mean
    attack angle beyond the usual one, rad.
    """
    less, more, up = _rows_at(table, bat, steeper)
    first, last = fill_weights(weight, table.place_start, table.selected_step, parameters[3], parameters[4] ** 2)
    hits[:] = 0.0
    for j in range(first, last):
        for k in range(len(hits)):
            hits[k] += weight[j] * (less[j, k] + up * (more[j, k] - less[j, k]))
    start, step, total = table.offset_start[bat], table.offset_step[bat], 0.0
    for k in range(len(hits)):
        total += hits[k] * math.exp(-0.5 * ((start + k * step - parameters[5]) / parameters[6]) ** 2)
    return float(max(total * step / (parameters[6] * ROOT_TWO_PI), 1e-6))


@compiled(nogil=True)
def fill_untold(
    share: Array, weight: Array, table: LikelihoodTable, bat: int, parameters: Array, steeper: float
) -> None:
    """Fill how often hits are met at every `UNTOLD_EVERY` th tabled offset over how often places are: they add to one.

    Towards tip and handle more balls leave too steeply for a hit, so a hit without a launch angle tells of its place.
    They are normalised as they stand: were they the density itself, a law of offsets that is narrower than the steps
    between them would make any swings as likely as one likes.

    ``parameters``: (10,) SI. ``steeper``: mean attack angle beyond the usual one, rad.
    """
    less, more, up = _rows_at(table, bat, steeper)
    total, spread = 0.0, parameters[6]
    for k in range(len(share)):
        offset = table.offset_start[bat] + k * UNTOLD_EVERY * table.offset_step[bat]
        often = math.exp(-0.5 * ((offset - parameters[5]) / spread) ** 2)
        for j in range(len(weight)):
            place = min(j * table.place_step / table.selected_step, less.shape[0] - 1.000001)
            low = int(place)
            part, column = place - low, k * UNTOLD_EVERY
            near = less[low, column] + up * (more[low, column] - less[low, column])
            far = less[low + 1, column] + up * (more[low + 1, column] - less[low + 1, column])
            share[k, j] = often * (near + part * (far - near))
            total += weight[j] * share[k, j]
    for k in range(len(share)):
        for j in range(len(weight)):
            share[k, j] /= max(total, TINY)


@compiled(nogil=True)
def fill_weights(weight: Array, start: float, step: float, mean: float, variance: float) -> tuple[int, int]:
    """Fill a grid with normal weights that add up to 1; return the first place that counts and the one after."""
    reach = GRID_REACH * math.sqrt(variance) + step
    first = max(0, math.ceil((mean - reach - start) / step))
    last = min(len(weight), math.floor((mean + reach - start) / step) + 1)
    total = 0.0
    for j in range(first, last):
        weight[j] = math.exp(-0.5 * (start + j * step - mean) ** 2 / variance)
        total += weight[j]
    if not total > 0:
        return 0, 0
    for j in range(first, last):
        weight[j] /= total
    return first, last
