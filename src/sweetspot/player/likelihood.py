"""How likely a player's swings are under given parameters, compiled.

Bat speed is normal about the player's mean for that bat; position and offset are normal about theirs. What was not
measured in a swing is summed over: position on a grid, offset by Gauss and Hermite's points, or on a grid where the
launch angle was not measured either, bat speed exactly, for exit speed is a straight line in it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import compiled
from sweetspot.numerics.vector_math import exp

GRID_REACH = 4.0
"""Standard deviations of the scatter to either side of its mean that are summed over."""
NEAR_POINTS, FAR_POINTS = 2, 8
"""Offsets summed over when the launch angle was measured, and when not."""
WRONG, WRONG_RANGE = 0.01, 60.0
"""Part of the exit speeds taken as wrong readings, spread evenly over this many m/s, so that one cannot rule."""
LANES = 8
"""Places are summed in whole eights, the last ones with no weight: what is left over would be done one by one."""
TINY = 1e-300
ROOT_TWO_PI = math.sqrt(2 * math.pi)


class Table(NamedTuple):
    """Everything about the swings that does not change with the parameters; nan where not measured.

    Parameters
    ----------
    bat_speed, exit_speed, pitch_speed, attack_angle, position : (n,) SI.
    offset : (n,) m, worked back from launch and attack angle (the usual attack angle where it was not measured).
    offset_noise : (n,) m, standard deviation of that.
    offset_slope : (n,) m per rad of attack angle; 0 where it was measured.
    bat : (n,) which bat, an index into the next three.
    efficiency, efficiency_slope : (bats, places) at the places of the grid.
    arm : (bats, places) bat speed at every place over that where bat speed is measured.
    kept : (n, offsets) part of the exit speed left.
    place_start, place_step, offset_start, offset_step : of the two grids, m.
    farthest : (bats,) m, the largest offset of a hit that is counted.
    constants : measuring error of bat speed and of position, spread of the attack angle, usual attack angle; part of
        the swings that are slow, by how much and with what spread; what the tabled hit is off by.
    near, near_weights : points of Gauss and Hermite, in standard deviations.
    far : m, sizes of offsets for hits without a launch angle.
    """

    bat_speed: Array
    exit_speed: Array
    pitch_speed: Array
    attack_angle: Array
    position: Array
    offset: Array
    offset_noise: Array
    offset_slope: Array
    bat: IntArray
    efficiency: Array
    efficiency_slope: Array
    arm: Array
    kept: Array
    place_start: float
    place_step: float
    offset_start: float
    offset_step: float
    farthest: Array
    constants: Array
    near: Array
    near_weights: Array
    far: Array


@compiled(nogil=True)
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
    """Return what a measured bat speed says: its log density, and mean and variance of the true one; nan: not measured.

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
    one, one_variance = combined(value, noise, mean, spread)
    two, two_variance = combined(value, noise, mean - by, wide)
    middle = (1 - share) * one + share * two
    variance = (1 - share) * one_variance + share * two_variance + share * (1 - share) * (two - one) ** 2
    return whole, middle, variance


@compiled(nogil=True)
def within(mean: float, spread: float, limit: float) -> float:
    """Return the part of a normal distribution that lies between -limit and limit."""
    root = math.sqrt(2.0) * spread
    return max(0.5 * (math.erf((limit - mean) / root) + math.erf((limit + mean) / root)), 1e-6)


@compiled(nogil=True)
def table_value(values: Array, start: float, step: float, place: float) -> float:
    """Return the straight line between neighbours of an even table; beyond its ends their value."""
    at = min(max((place - start) / step, 0.0), len(values) - 1.000001)
    index = int(at)
    return float(values[index] + (at - index) * (values[index + 1] - values[index]))


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


@compiled(nogil=True)
def fill_folded(weight: Array, points: Array, mean: float, spread: float) -> None:
    """Fill the weights of offsets of either sign, which keep the same exit speed, so that they add up to 1."""
    total = 0.0
    for k in range(len(points)):
        above, below = (points[k] - mean) / spread, (points[k] + mean) / spread
        weight[k] = math.exp(-0.5 * above**2) + math.exp(-0.5 * below**2) + TINY
        total += weight[k]
    for k in range(len(points)):
        weight[k] /= total


@compiled(nogil=True, fastmath={"contract", "nsz", "reassoc"})
def _summed(left: Array, right: Array) -> float:
    """Return the sum of products, in whatever order is fastest."""
    total = 0.0
    for j in range(len(left)):
        total += left[j] * right[j]
    return total


@compiled(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
def _density(
    out: float,
    kept: float,
    noise: float,
    speed_variance: float,
    weight: Array,
    ball_out: Array,
    slope: Array,
    part: Array,
    narrow: Array,
) -> float:
    """Return the density of an exit speed summed over places; the last two arrays are room to work in.

    Short loops from 0 that touch few arrays: the compiler turns these into vector instructions. It must not be let to
    reorder sums here: the exponential rounds by adding and taking away a large number.
    """
    count = len(weight)
    for j in range(count):
        narrow[j] = 1 / math.sqrt(noise**2 + (slope[j] * kept) ** 2 * speed_variance)
    for j in range(count):
        part[j] = -0.5 * ((out - ball_out[j] * kept) * narrow[j]) ** 2
    for j in range(count):
        part[j] = exp(part[j])
    for j in range(count):
        narrow[j] *= weight[j]
    return _summed(narrow, part)


@compiled(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
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
def log_likelihoods(parameters: Array, speeds: Array, table: Table, logarithms: Array) -> None:
    """Fill ``logarithms`` with the log-likelihood of every row of parameters.

    Parameters
    ----------
    parameters : (rows, 10) SI, in the order of `NAMES`.
    speeds : (rows, bats) m/s, the player's mean bat speed with every bat.
    logarithms : (rows,).
    """
    places = table.efficiency.shape[1]
    speed_noise, place_noise, attack_spread, usual_attack = table.constants[:4]
    slow, model_noise = (table.constants[4], table.constants[5], table.constants[6]), table.constants[7]
    room = places + LANES
    usual_weight, own_weight = np.zeros(room), np.zeros(room)
    part, narrow, ball_out, slope = np.empty(room), np.empty(room), np.zeros(room), np.zeros(room)
    folded = np.empty(len(table.far))
    counted = np.empty(len(table.farthest))
    for row in range(len(parameters)):
        theta = parameters[row]
        speed_spread, centre, scatter = theta[1], theta[3], theta[4]
        offset_mean, offset_spread, attack, shift = theta[5], theta[6], theta[7], theta[8]
        noise = math.sqrt(theta[9] ** 2 + model_noise**2)
        for bat in range(len(table.farthest)):
            counted[bat] = math.log(within(offset_mean, offset_spread, table.farthest[bat]))
        fill_folded(folded, table.far, offset_mean, offset_spread)
        usual = fill_weights(usual_weight[:places], table.place_start, table.place_step, centre, scatter**2)
        total = 0.0
        for i in range(len(table.bat_speed)):
            bat, pitch, out = table.bat[i], table.pitch_speed[i], table.exit_speed[i]
            mean_speed = speeds[row, bat]
            said, speed, speed_variance = swung(table.bat_speed[i], speed_noise, mean_speed, speed_spread, slow)
            total += said
            if not math.isnan(table.attack_angle[i]):
                total += normal(table.attack_angle[i], attack, attack_spread**2)
            told = table.offset[i] + table.offset_slope[i] * (attack - usual_attack)
            above, above_variance = combined(told, table.offset_noise[i], offset_mean, offset_spread)
            if not math.isnan(told):
                total += normal(told, offset_mean, offset_spread**2 + table.offset_noise[i] ** 2) - counted[bat]
                total += math.log(within(above, math.sqrt(above_variance), table.farthest[bat]))
            weight, first, last = usual_weight, usual[0], usual[1]
            if not math.isnan(table.position[i]):
                total += normal(table.position[i], centre, scatter**2 + place_noise**2)
                place, place_variance = combined(table.position[i], place_noise, centre, scatter)
                weight = own_weight
                first, last = fill_weights(weight[:places], table.place_start, table.place_step, place, place_variance)
            if math.isnan(out):
                continue
            _fill_ball_out(
                speed,
                pitch,
                shift,
                table.efficiency[bat, first:last],
                table.efficiency_slope[bat, first:last],
                table.arm[bat, first:last],
                ball_out[first:last],
                slope[first:last],
            )
            whole = first + -(-(last - first) // LANES) * LANES
            for j in range(last, whole):
                weight[j] = 0.0
            unknown = math.isnan(told)
            points, weights = (table.far, folded) if unknown else (table.near, table.near_weights)
            likelihood = 0.0
            for k in range(len(points)):
                height = points[k] if unknown else above + points[k] * math.sqrt(above_variance)
                kept = table_value(table.kept[i], table.offset_start, table.offset_step, height)
                likelihood += weights[k] * _density(
                    out,
                    kept,
                    noise,
                    speed_variance,
                    weight[first:whole],
                    ball_out[first:whole],
                    slope[first:whole],
                    part[first:whole],
                    narrow[first:whole],
                )
            total += math.log((1 - WRONG) / ROOT_TWO_PI * likelihood + WRONG / WRONG_RANGE)
        logarithms[row] = total
