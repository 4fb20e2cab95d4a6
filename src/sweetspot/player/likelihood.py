"""How likely a player's swings are under given parameters, compiled.

Bat speed is normal about the player's mean for that bat; position and offset are normal about theirs. What was not
measured in a swing is summed over: position on a grid, offset at the points that its launch angle leaves
(`off_centre`), bat speed exactly, for exit speed is a straight line in it. Hits are those that leave within a range of
launch angles; how likely that is under the parameters is divided by.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import exp
from sweetspot.player.contact_rate import ROOT_TWO_PI, TINY, LikelihoodTable, fill_hits, fill_untold, fill_weights
from sweetspot.player.off_centre import POINTS, UNTOLD_EVERY

WRONG, WRONG_RANGE = 0.01, 60.0
"""Part of the exit speeds taken as wrong readings, spread evenly over this many m/s, so that one cannot rule."""
COUNTED = 0.9
"""What a hit counts, beside bat speed, attack angle and position that were measured themselves: less than one, for hits
of other simulators and of the field scatter in more than the model's noise. Set on 200 made-up players and shown on
others (docs/theory/player.md)."""
LANES = 8
"""Places are summed in blocks of eight, the last padded with zero weights: a remainder would be summed one by one."""


@inner
def normal(value: float, mean: float, variance: float) -> float:
    """Return the logarithm of the normal density, without its constant."""
    return -0.5 * ((value - mean) ** 2 / variance + math.log(variance))


@compiled(nogil=True)
def combined(value: float, noise: float, mean: float, spread: float) -> tuple[float, float]:
    """Return mean and variance of a quantity that is normal and was measured with noise; nan: not measured."""
    if math.isnan(value):
        return mean, spread**2
    gain = spread**2 / (spread**2 + noise**2)
    return mean + gain * (value - mean), gain * noise**2


@compiled(nogil=True)
def swung(
    value: float, noise: float, mean: float, spread: float, slow: tuple[float, float, float]
) -> tuple[float, float, float]:
    """Return a measured bat speed's log density, and mean and variance of the true one; nan: not measured.

    Bat speeds are normal but for a part that are slow, ``slow``: protective and checked swings.
    """
    if math.isnan(value):
        return 0.0, mean, spread**2
    part, by, wide = slow
    usual = math.log(1 - part) + normal(value, mean, spread**2 + noise**2)
    other = math.log(part) + normal(value, mean - by, wide**2 + noise**2)
    top = max(usual, other)
    whole = top + math.log(math.exp(usual - top) + math.exp(other - top))
    share = math.exp(other - whole)
    full, full_variance = combined(value, noise, mean, spread)
    slower, slower_variance = combined(value, noise, mean - by, wide)
    middle = (1 - share) * full + share * slower
    variance = (1 - share) * full_variance + share * slower_variance + share * (1 - share) * (slower - full) ** 2
    return whole, middle, variance


@inner(fastmath={"contract", "nsz", "reassoc"})
def _summed(left: Array, right: Array) -> float:
    """Return the sum of products, in whatever order is fastest."""
    total = 0.0
    for j in range(len(left)):
        total += left[j] * right[j]
    return total


@inner(fastmath={"contract", "nsz"}, error_model="numpy")
def _fill_heights(
    offset: Array, share: Array, mean: float, spread: float, weight: Array, part: Array, height: Array
) -> None:
    """Fill the logarithms of how likely one point's offsets are, place by place, and their weights.

    ``mean``, ``spread``: m, of the offset.
    """
    for j in range(len(weight)):
        height[j] = -0.5 * ((offset[j] - mean) / spread) ** 2
        part[j] = weight[j] * share[j]


@inner(fastmath={"contract", "nsz"}, error_model="numpy")
def _density(out: float, retained: Array, ball_out: Array, narrow: Array, height: Array, part: Array) -> float:
    """Return the density of an exit speed summed over places; the last two arrays are used up.

    Short loops from 0 that touch few arrays: the compiler turns these into vector instructions. It must not be let to
    reorder sums here: the exponential rounds by adding and taking away a large number.
    """
    count = len(part)
    for j in range(count):
        height[j] -= 0.5 * ((out - ball_out[j] * retained[j]) * narrow[j]) ** 2
    for j in range(count):
        height[j] = exp(height[j])
    for j in range(count):
        part[j] *= narrow[j]
    return _summed(part, height)


@inner(fastmath={"contract", "nsz"}, error_model="numpy")
def _fill_narrow(noise: float, speed_variance: float, retained: Array, slope: Array, narrow: Array) -> None:
    """Fill one over the standard deviation of exit speed at every place."""
    for j in range(len(narrow)):
        narrow[j] = 1 / math.sqrt(noise**2 + (slope[j] * retained[j]) ** 2 * speed_variance)


class Room(NamedTuple):
    """The places that one swing is summed over: their weights, exit speeds head-on, and room for terms."""

    weight: Array
    ball_out: Array
    slope: Array
    part: Array
    narrow: Array
    height: Array


@inner(fastmath={"contract", "nsz"}, error_model="numpy")
def _density_untold(
    table: LikelihoodTable, i: int, share: Array, here: slice, noise: float, speed_variance: float, room: Room
) -> float:
    """Return the density of a swing's exit speed summed over places and offsets, of which no launch angle tells.

    ``share``: (offsets, places), which add to one when each counts as its place's weight.
    """
    retained, variance = (table.untold_kept[table.untold[i], :, here], table.untold_variance[table.untold[i], :, here])
    total = 0.0
    for k in range(len(share)):
        for j in range(len(room.weight)):
            room.height[j] = 0.0
            room.part[j] = room.weight[j] * share[k, j]
        for j in range(len(room.weight)):
            of_speed = (room.slope[j] * retained[k, j]) ** 2 * speed_variance
            spread = of_speed + room.ball_out[j] ** 2 * variance[k, j]
            room.narrow[j] = 1 / math.sqrt(noise**2 + spread)
        total += _density(table.exit_speed[i], retained[k], room.ball_out, room.narrow, room.height, room.part)
    return total


@inner(fastmath={"contract", "nsz"}, error_model="numpy")
def _densities(
    table: LikelihoodTable, i: int, here: slice, nearest: int, theta: Array, noise: float, speed_variance: float,
    room: Room,
) -> tuple[float, float]:  # fmt: skip
    """Return the density of a swing's launch angle at one place, and of its exit speed with that over all places.

    ``nearest``: the one place, from the first of those summed over: this counts where the exit speed is a wrong reading
    or none.
    """
    out, apart = table.exit_speed[i], math.isnan(table.bat_speed[i])
    angle, both = 0.0, 0.0
    for k in range(POINTS):
        share = table.points.share[i, k, here]
        _fill_heights(table.points.offset[i, k, here], share, theta[5], theta[6], room.weight, room.part, room.height)
        angle += share[nearest] * math.exp(room.height[nearest])
        if math.isnan(out):
            continue
        # a launch angle's points lie close together: what is retained at the middle one scatters them all
        if apart or k == 0:
            middle = k if apart else POINTS // 2
            _fill_narrow(noise, speed_variance, table.points.retained[i, middle, here], room.slope, room.narrow)
        both += _density(out, table.points.retained[i, k, here], room.ball_out, room.narrow, room.height, room.part)
    return angle, both


@inner(fastmath={"contract", "nsz"}, error_model="numpy")
def _fill_ball_out(
    speed: float,
    pitch: float,
    shift: float,
    efficiency: Array,
    efficiency_slope: Array,
    arm: Array,
    ball_out: Array,
    slope: Array,
) -> None:
    """Fill the exit speed of a ball met head-on at every place, and its change with bat speed, to first order."""
    for j in range(len(arm)):
        there = speed * arm[j]
        closing = pitch + there
        now = efficiency[j] + shift + efficiency_slope[j] * closing
        ball_out[j] = now * closing + there
        slope[j] = (1 + now + efficiency_slope[j] * closing) * arm[j]


@compiled(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
def log_likelihoods(parameters: Array, speeds: Array, table: LikelihoodTable, logarithms: Array) -> None:
    """Fill ``logarithms`` with the log-likelihood of every row of parameters; hits count `COUNTED`.

    ``parameters``: (rows, 10) SI, in the order of `NAMES`. ``speeds``: (rows, bats) m/s, the player's mean bat speed
    with every bat.
    """
    places = table.efficiency.shape[1]
    speed_noise, place_noise, attack_spread, usual_attack = table.constants[:4]
    slow, model_noise = (table.constants[4], table.constants[5], table.constants[6]), table.constants[7]
    room = places + LANES
    usual_weight, own_weight = np.zeros(room), np.zeros(room)
    part, narrow, ball_out, slope = np.empty(room), np.empty(room), np.zeros(room), np.zeros(room)
    height, counted = np.empty(room), np.empty(len(table.arm))
    hit_weight, hits = np.empty(table.selected.shape[2]), np.empty(table.selected.shape[3])
    untold = np.zeros((len(table.arm), -(-len(hits) // UNTOLD_EVERY), room))
    for row in range(len(parameters)):
        theta = parameters[row]
        speed_spread, centre, scatter = theta[1], theta[3], theta[4]
        offset_spread, attack, shift = theta[6], theta[7], theta[8]
        noise = math.sqrt(theta[9] ** 2 + model_noise**2)
        usual_weight[:places] = 0.0
        usual = fill_weights(usual_weight[:places], table.place_start, table.place_step, centre, scatter**2)
        for bat in range(len(counted)):
            counted[bat] = math.log(fill_hits(hits, hit_weight, table, bat, theta, attack - usual_attack))
            if len(table.untold_kept):
                fill_untold(untold[bat, :, :places], usual_weight[:places], table, bat, theta, attack - usual_attack)
        total = 0.0
        for i in range(len(table.bat_speed)):
            bat, pitch, out = table.bat[i], table.pitch_speed[i], table.exit_speed[i]
            mean_speed = speeds[row, bat]
            log_density, speed, speed_variance = swung(table.bat_speed[i], speed_noise, mean_speed, speed_spread, slow)
            total += log_density
            if not math.isnan(table.attack_angle[i]):
                total += normal(table.attack_angle[i], attack, attack_spread**2)
            weight, first, last = usual_weight, usual[0], usual[1]
            if not math.isnan(table.position[i]):
                total += normal(table.position[i], centre, scatter**2 + place_noise**2)
                place, place_variance = combined(table.position[i], place_noise, centre, scatter)
                weight = own_weight
                first, last = fill_weights(weight[:places], table.place_start, table.place_step, place, place_variance)
            if not table.hit[i]:
                continue
            whole = first + -(-(last - first) // LANES) * LANES
            for j in range(last, whole):
                weight[j] = 0.0
            here = slice(first, whole)
            _fill_ball_out(
                *(speed, pitch, shift, table.efficiency[bat, first:last], table.efficiency_slope[bat, first:last]),
                *(table.arm[bat, first:last], ball_out[first:last], slope[first:last]),
            )
            room = Room(weight[here], ball_out[here], slope[here], part[here], narrow[here], height[here])
            if table.untold[i] >= 0:
                if not math.isnan(out):
                    both = _density_untold(table, i, untold[bat, :, here], here, noise, speed_variance, room)
                    total += COUNTED * math.log((1 - WRONG) / ROOT_TWO_PI * both + WRONG / WRONG_RANGE)
                continue
            nearest = min(max(round((centre - table.place_start) / table.place_step), first), last - 1)
            angle, both = _densities(table, i, here, nearest - first, theta, noise, speed_variance, room)
            found = angle if math.isnan(out) else (1 - WRONG) / ROOT_TWO_PI * both + WRONG / WRONG_RANGE * angle
            total += COUNTED * (math.log(max(found, TINY) / (ROOT_TWO_PI * offset_spread)) - counted[bat])
        logarithms[row] = total
