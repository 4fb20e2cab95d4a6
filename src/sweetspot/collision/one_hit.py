"""One hit with its whole history, as `coupled.hit` has it, whose contact is followed by compiled code.

That takes a twentieth of the time where compiled code is loaded anyway; loading it takes longer than one hit.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.collision.contact_law import (
    NEARLY,
    NEWTON_STEPS,
    ContactLaw,
    damped_impulse,
    top_of,
    unloading_power,
)
from sweetspot.collision.coupled import STEP, Course, collisions_of, hit
from sweetspot.collision.free_motion import Flow, Motion, Struck
from sweetspot.collision.impact import Impact
from sweetspot.collision.kernel import numbers_of
from sweetspot.collision.kernel_arrays import BallNumbers
from sweetspot.collision.time_step import contact_step, impulse_of_the_turn
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import vertex
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.plausibility import check_place

# numbers that change from kick to kick; the compression from which the ball springs back is nan while it is pressed on
BALL_POSITION, BALL_SPEED, WORK, PEAK, TURNED_AT, GREATEST, HARDEST, MISSING, BEFORE, EARLIER, APPROACH = range(11)
# rows of the history, kick by kick
APPROACHES, COMPRESSIONS, FORCES, IMPULSES = range(4)

_damped_impulse, _top_of = inner(damped_impulse), inner(top_of)
# the other readable functions that the loop calls (vertex, impulse_of_the_turn, unloading_power) are compiled in
# `compiled`, which `kernel` brings


def quick_hit(modes: Modes, *, ball: Ball, position: float, closing_speed: float) -> Impact:
    """Return one collision of a ball with a bat, by the ball's own law and on the bat's line; see `coupled.hit`.

    Parameters
    ----------
    position : m from the knob end.
    closing_speed : m/s.
    """
    if not closing_speed > 0:
        return hit(modes, ball=ball, position=position, closing_speed=closing_speed)
    check_place(position, "position")
    step = contact_step(modes, ball, longest=STEP)
    return collisions_of(modes, ball, (position, 0.0, closing_speed), step, _kicks)


def _kicks(
    course: Course, motion: Motion, struck: Struck, flow: Flow, law: ContactLaw, limit: int
) -> tuple[float, Motion]:
    """Follow one contact; see `coupled.Kicks`."""
    before = len(course.forces)
    history = np.zeros((4, limit + 1))
    history[FORCES, :before] = course.forces
    state = np.zeros(11)
    state[BALL_POSITION], state[BALL_SPEED], state[WORK] = motion.ball_position, motion.ball_speed, motion.work
    state[PEAK], state[GREATEST], state[HARDEST] = course.peak, course.greatest, course.hardest
    state[TURNED_AT] = math.nan if course.turned_at is None else course.turned_at
    bat = motion.bat.copy()
    shape = struck.kick[len(flow.modes) :].copy()
    place = (struck.lightness, struck.compliance, struck.by_steps)
    count = _followed(bat, flow.matrix, shape, place, numbers_of(law.ball), flow.step, state, history, before)
    for row, values in (
        (APPROACHES, course.approaches),
        (COMPRESSIONS, course.compressions),
        (FORCES, course.forces),
        (IMPULSES, course.impulses),
    ):
        values.extend(history[row, before:count].tolist())
    course.peak, course.greatest, course.hardest = (float(state[row]) for row in (PEAK, GREATEST, HARDEST))
    course.turned_at = None if math.isnan(state[TURNED_AT]) else float(state[TURNED_AT])
    course.missing = float(state[MISSING])
    place_of_ball, speed_of_ball, work = (float(state[row]) for row in (BALL_POSITION, BALL_SPEED, WORK))
    return float(state[APPROACH]), Motion(place_of_ball, speed_of_ball, bat, work)


@compiled(nogil=True, error_model="numpy")
def _followed(
    bat: Array,
    matrix: Array,
    shape: Array,
    place: tuple[float, float, float],
    ball: BallNumbers,
    step: float,
    state: Array,
    history: Array,
    kick: int,
) -> int:
    """Kick and drift until ball and bat are apart, or the history is full; return the number of kicks then.

    As `coupled._kicks`: what changes is in ``bat``, ``state`` and ``history``.
    """
    modes = len(shape)
    lightness, compliance, by_steps = place
    together = lightness + 1 / ball.mass
    drifted = np.empty(2 * modes)
    first, middle = kick, 0.0
    while kick < history.shape[1]:
        surface, speed = 0.0, 0.0
        for i in range(modes):
            surface += shape[i] * bat[i]
            speed += shape[i] * bat[modes + i]
        approach = state[BALL_POSITION] - surface
        state[APPROACH] = approach
        if approach <= 0:
            break
        before, earlier, third = state[BEFORE], state[EARLIER], kick - first > 1
        falling = approach < before or (third and 3 * approach - 4 * before + earlier < 0)
        if math.isnan(state[TURNED_AT]) and falling:
            shift, height, bend = 0.5, before, 0.0
            if third:
                shift, height = vertex(earlier, before, approach)
                bend = earlier - 2 * before + approach
            peak = max(state[PEAK], approach, height)
            turned_at, force, loading = _pressed(ball, peak, compliance, math.nan, 0.0)
            unloading = unloading_power(ball, turned_at, force) * force / turned_at
            stiffening = unloading / (1 + compliance * unloading) - loading / (1 + compliance * loading)
            state[PEAK], state[TURNED_AT] = peak, turned_at
            state[MISSING] = impulse_of_the_turn(shift, bend, stiffening, step)
            state[GREATEST], state[HARDEST] = max(state[GREATEST], turned_at), max(state[HARDEST], force)
        elif approach >= state[PEAK]:
            state[PEAK], state[TURNED_AT] = approach, math.nan
        expected = 2 * history[FORCES, kick - 1] - history[FORCES, kick - 2] if kick > 1 else 0.0
        compression, elastic, slope = _pressed(ball, approach, compliance, state[TURNED_AT], expected)
        softened, rate = ball.damping / (1 + (compliance - by_steps) * slope), state[BALL_SPEED] - speed
        former = rate if kick == first else middle
        impulse, middle = _damped_impulse(elastic * step, softened, rate, together, former, by_steps, step)
        force = impulse / step
        if math.isnan(state[TURNED_AT]) and kick > 1:
            earlier_force, former_force = history[FORCES, kick - 2], history[FORCES, kick - 1]
            if earlier_force <= former_force > force:
                state[HARDEST] = max(state[HARDEST], _top_of(earlier_force, former_force, force))
        impulse += state[MISSING]
        state[MISSING], state[EARLIER], state[BEFORE] = 0.0, before, approach
        history[APPROACHES, kick], history[COMPRESSIONS, kick] = approach, compression
        history[FORCES, kick], history[IMPULSES, kick] = force, impulse
        kick += 1
        state[WORK] += impulse * (speed + impulse * lightness / 2)
        state[BALL_SPEED] -= impulse / ball.mass
        state[BALL_POSITION] += state[BALL_SPEED] * step
        for i in range(modes):
            bat[modes + i] += impulse * shape[i]
        for row in range(2 * modes):
            total = 0.0
            for column in range(2 * modes):
                total += matrix[row, column] * bat[column]
            drifted[row] = total
        bat[:] = drifted
    return kick


@compiled(error_model="numpy")
def _pressed(
    ball: BallNumbers, approach: float, compliance: float, turned_at: float, force: float
) -> tuple[float, float, float]:
    """Return compression, elastic force and its slope; see `contact_law.pressed_in_series` and `ContactLaw`."""
    largest, reference, power, most = ball.stiffness, 1.0, ball.exponent, approach
    if not math.isnan(turned_at):
        largest, reference = ball.stiffness * turned_at**ball.exponent, turned_at
        power, most = unloading_power(ball, turned_at, largest), min(approach, turned_at)
    compression = min(max(approach - compliance * force, approach / 4), most)
    for _ in range(NEWTON_STEPS if compliance > 0 else 0):
        force = largest * (compression / reference) ** power
        slope = power * force / compression
        change = (approach - compression - compliance * force) / (1 + compliance * slope)
        compression = min(max(compression + change, compression / 4), most)
        if abs(change) < NEARLY * compression:
            break
    force = largest * (compression / reference) ** power
    return compression, force, power * force / compression
