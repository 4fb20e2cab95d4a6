"""The same time stepper in plain NumPy, vectorised over hits: arrays of shape (hits,) and (hits, modes)."""

from __future__ import annotations

from functools import partial

import numpy as np

from benchmarks.cases import Array
from sweetspot.collision.contact_law import unloading_power
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.collision.time_step import first_kick_after_touch, give_of_steps, impulse_of_the_turn
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball


def efficiencies(modes: Modes, *, ball: Ball, position: Array, closing: Array, step: float) -> Array:
    """Return the collision efficiency q of every hit."""
    mass, stiffness, exponent = ball.mass, ball.stiffness, ball.exponent
    springs_back = np.vectorize(partial(unloading_power, ball), otypes=[float])
    (a, b), (c, d) = modal_propagator_of(modes, step).transpose(1, 2, 0)
    result = np.full(len(closing), np.nan)
    row, shape, speed = np.arange(len(closing)), modes.shape_at(position), closing.copy()
    place, q, p = speed * step * first_kick_after_touch(exponent), np.zeros_like(shape), np.zeros_like(shape)
    give = step**2 / 12 / mass + shape**2 @ give_of_steps(modes.angular_frequency, step)
    lightness = 1 / mass + (shape**2).sum(axis=1)
    peak, before, earlier = (np.zeros_like(speed) for _ in range(3))
    middle_rate = closing.copy()
    factor, power, rising = np.full_like(speed, stiffness), np.full_like(speed, exponent), np.ones(len(speed), bool)
    while len(row):
        squeeze = place - (shape * q).sum(axis=1)
        if (squeeze <= 0).any():  # take out what has left
            left = squeeze <= 0
            result[row[left]] = -speed[left] / closing[row[left]]
            every = (
                *(row, shape, speed, place, q, p, give, lightness, middle_rate),
                *(peak, before, earlier, factor, power, rising, squeeze),
            )
            (row, shape, speed, place, q, p, give, lightness, middle_rate, *rest) = (array[~left] for array in every)
            peak, before, earlier, factor, power, rising, squeeze = rest
        falling = (squeeze < before) | ((earlier > 0) & (3 * squeeze - 4 * before + earlier < 0))
        turned, again = rising & falling, ~rising & (squeeze >= peak)
        peak, missing = np.maximum(peak, squeeze), np.zeros_like(squeeze)
        if turned.any():
            first, middle, last = earlier[turned], before[turned], squeeze[turned]
            bend = first - 2 * middle + last
            peak[turned] = np.maximum(peak[turned], middle - (last - first) ** 2 / (8 * bend))
            top = _pressed(peak[turned], give[turned], stiffness, exponent)
            power[turned] = springs_back(top, stiffness * top**exponent)
            factor[turned] = stiffness * top ** (exponent - power[turned])
            slope = stiffness * top ** (exponent - 1)
            after, until = power[turned] * slope, exponent * slope
            stiffening = after / (1 + give[turned] * after) - until / (1 + give[turned] * until)
            missing[turned] = impulse_of_the_turn((first - last) / (2 * bend), bend, stiffening, step)
        factor[again], power[again] = stiffness, exponent
        rising = (rising & ~turned) | again
        push = factor * _pressed(squeeze, give, factor, power) ** power * step
        rate = speed - (shape * p).sum(axis=1)
        damped = push * (1 + ball.damping * rate) / (1 + push * ball.damping * lightness / 2)
        former, middle_rate = middle_rate, rate - damped * lightness / 2
        damped *= 1 + ball.damping**2 * give * push * (middle_rate - former) / step**2
        impulse = np.maximum(damped, 0) + missing
        speed = speed - impulse / mass
        place = place + speed * step
        p = p + shape * impulse[:, None]
        q, p = a * q + b * p, c * q + d * p
        earlier, before = before, squeeze
    return result


def _pressed(approach: Array, give: Array, factor: Array | float, power: Array | float) -> Array:
    """Return the compression u of u + C factor u^power = approach, by Newton's method."""
    compression = approach.copy()
    for _ in range(3):
        force = factor * compression**power
        compression += (approach - compression - give * force) / (1 + give * power * force / compression)
    return compression
