"""The loop of the coupled collision, compiled: `LANES` hits advance side by side by the time step of `coupled`.

Every loop over lanes is straight-line arithmetic, which the compiler turns into vector instructions. `solve` is serial
and releases the GIL, so threads, processes or a cluster work outside it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numba.extending import register_jitable

from sweetspot.collision import contact_law
from sweetspot.collision.contact_law import NEWTON_STEPS
from sweetspot.collision.free_motion import SLOW
from sweetspot.collision.impact import CONTACT_FORCE, Outcome
from sweetspot.collision.kernel_arrays import (
    CONTACT_TIME,
    EFFICIENCY,
    GREATEST_COMPRESSION,
    GREATEST_FORCE,
    LATE,
    RELEASE_TIME,
    TOUCHES,
    BallNumbers,
    BatNumbers,
    HitOutput,
    Steps,
)
from sweetspot.collision.time_step import impulse_of_the_turn
from sweetspot.equipment.ball import damped_part, restitution_at
from sweetspot.numerics import interpolants
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import exp, log

LANES = 64
"""Most hits side by side; fewer hits than that take only the lanes they need, in fours."""
NEARLY = 1e-4
"""Part of the compression by which the last step of an iteration changes it at most."""
ROUGH = 0.02
"""Part of the compression: a step from the forecast that is longer than this may leave more than 1e-6 of the force."""
STEEP = 0.1
"""One over the power of a force beyond which such a step must be shorter, in proportion to the power."""
QUIET = -230.0
"""Logarithm of a force that moves nothing, far above the numbers that make processors slow."""

SEPARATED, STILL_IN_CONTACT, NO_CONTACT, _ = map(int, Outcome)

# rows of the lanes' state
CLOSING, BALL_POSITION, BALL_SPEED, SURFACE, APPROACH, BEFORE, EARLIER = range(7)
PEAK, RISING, OFFSET, POWER, IMPULSE, LARGEST, KICKS, EVENT, FORCE, CONTACT = range(7, 17)
GIVE, FORMER, PUSHED, DEEPEST, HARDEST, UNTIL, MISSING = range(17, 24)
RATE, MIDDLE, BY_STEPS, SURFACE_GIVE, LIGHTNESS, DAMPED, TOTAL, FORMER_TOTAL, TURNED_AT, FREE = range(24, 34)
STATE_ROWS = 34


class Lanes(NamedTuple):
    """State of the lanes: scalars by row of ``state``, modal values by mode, and which hit is in which lane."""

    state: Array
    shape: Array
    displacement: Array
    velocity: Array
    hit_of: IntArray


# What happens to one lane is compiled without counting references to arrays (_nrt): that cost a tenth of a hit's time,
# for whoever calls these functions holds the arrays anyway.

# the readable functions, compiled where compiled code calls them
_crossing = register_jitable(interpolants.crossing)
_vertex = register_jitable(interpolants.vertex)
_impulse_of_the_turn = register_jitable(impulse_of_the_turn)
_unloading_power = register_jitable(contact_law.unloading_power)
_top_of = register_jitable(contact_law.top_of)
_damped_impulse = register_jitable(contact_law.damped_impulse)
_forgetting = register_jitable(contact_law.forgetting)
_remembered = register_jitable(contact_law.remembered)
for readable in (restitution_at, damped_part, contact_law.wall_speed):
    register_jitable(readable)


_inlined = inner(forceinline=True, _nrt=False, error_model="numpy", fastmath={"contract", "nsz"})


@compiled(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
def solve(
    lane_count: int, closing_speed: Array, bat: BatNumbers, ball: BallNumbers, steps: Steps, output: HitOutput
) -> None:
    """Fill ``output`` for n hits with these closing speeds in m/s, ``lane_count`` of them side by side.

    Every lane carries one hit; when it ends, the lane takes the next hit, so that no lane waits for another. The parts
    of a step are functions that are compiled into this one; with the kick as one of them it is a tenth slower.

    The elastic force G at approach w solves u + C G(u) = w. The forces of the last two kicks foretell u to about
    (h / T)^2; from there one step of Chebyshev's method along the curve leaves 1e-8 of the force, for one power per
    kick. Where C G is large beside u, under a soft surface, the forecast may be no use: lanes that it leaves further
    than `ROUGH` from the root are solved to the end (`pressed`). What the ball's damper adds is
    `contact_law.damped_impulse`.
    """
    size = bat.shapes.shape[1]
    # rows as long as the most lanes, whose distances the compiler then knows: it need not ask whether they overlap
    lanes = Lanes(
        np.zeros((STATE_ROWS, LANES)),
        np.empty((size, LANES)),
        np.empty((size, LANES)),
        np.empty((size, LANES)),
        np.empty(lane_count, np.int64),
    )
    state, step, mass = lanes.state, steps.step, ball.mass
    following, busy = 0, 0
    for lane in range(lane_count):
        following = _start(lane, following, closing_speed, bat, ball, steps, lanes, output)
        busy += lanes.hit_of[lane] >= 0
    state[APPROACH][:] = state[RATE][:] = 0.0  # before first touch
    ball_position, ball_speed, force, former = state[BALL_POSITION], state[BALL_SPEED], state[FORCE], state[FORMER]
    kicks, contact, pushed, largest = state[KICKS], state[CONTACT], state[PUSHED], state[LARGEST]
    event, impulse, left_out, hardest = state[EVENT], state[IMPULSE], state[MISSING], state[HARDEST]
    closing, middle, by_steps, lightness = state[RATE], state[MIDDLE], state[BY_STEPS], state[LIGHTNESS]
    damped, total, former_total, rising = state[DAMPED], state[TOTAL], state[FORMER_TOTAL], state[RISING]
    per_step = 1.0 / step
    drift, dashpots, half_dash, rate, stray = bat.drift, bat.dashpots, bat.half_dash, np.zeros(LANES), np.zeros(LANES)
    while busy > 0:
        if _look(lane_count, steps.limit, state):
            for lane in range(lane_count):
                if event[lane] > 0.0 and _follow(lane, bat, ball, steps, lanes, output):
                    following = _start(lane, following, closing_speed, bat, ball, steps, lanes, output)
                    kicks[lane] += 1.0
                    busy -= lanes.hit_of[lane] < 0
        _push(lane_count, ball.damping, stray, state)
        for lane in range(lane_count):
            kick, middle[lane] = _damped_impulse(
                pushed[lane] * step, damped[lane], closing[lane], lightness[lane], middle[lane], by_steps[lane], step
            )
            latest = kick * per_step
            largest[lane] = max(largest[lane], latest)
            threshold = CONTACT_FORCE * largest[lane]
            ebbing = (total[lane] >= threshold) & (latest < threshold)
            part = (total[lane] - threshold) / (total[lane] - latest)
            contact[lane] = kicks[lane] + part if ebbing else contact[lane]
            top = _top_of(former_total[lane], total[lane], latest)
            topped = (total[lane] >= former_total[lane]) & (total[lane] > latest) & (rising[lane] > 0.0)
            hardest[lane] = max(hardest[lane], top) if topped else hardest[lane]
            former_total[lane], total[lane] = total[lane], latest
            former[lane] = force[lane]
            force[lane] = pushed[lane]
            impulse[lane] = kick + left_out[lane]
            left_out[lane] = 0.0
            ball_speed[lane] -= impulse[lane] / mass
            ball_position[lane] += ball_speed[lane] * step
        if len(half_dash) > 0:  # the kick alone, then dampers for half a step on both sides of the drift
            for i in range(size):
                for lane in range(lane_count):
                    lanes.velocity[i, lane] += lanes.shape[i, lane] * impulse[lane]
            impulse[:] = 0.0
            _dash(lanes.velocity, dashpots, half_dash, rate)
        _drift(lane_count, drift, lanes)
        if len(half_dash) > 0:
            _dash(lanes.velocity, dashpots, half_dash, rate)
            closing[:] = 0.0
            for i in range(size):
                for lane in range(lane_count):
                    closing[lane] += lanes.shape[i, lane] * lanes.velocity[i, lane]


@_inlined
def _look(lane_count: int, limit: float, state: Array) -> bool:
    """Return whether anything happens in a lane beside the next kick: the ball turns or leaves, or time is up."""
    any_event = 0
    for lane in range(lane_count):
        state[EARLIER, lane] = state[BEFORE, lane]
        state[BEFORE, lane] = state[APPROACH, lane]
        state[APPROACH, lane] = state[BALL_POSITION, lane] - state[SURFACE, lane]
        state[SURFACE, lane] = 0.0
        state[RATE, lane] = state[BALL_SPEED, lane] - state[RATE, lane]
        state[KICKS, lane] += 1.0
        level = 0.0 if state[EARLIER, lane] > 0.0 else -np.inf  # before the third kick there is no parabola
        falling = 3.0 * state[APPROACH, lane] - 4.0 * state[BEFORE, lane] + state[EARLIER, lane] < level
        turned = 1.0 if (state[APPROACH, lane] < state[BEFORE, lane]) | falling else 0.0
        again = 1.0 if state[APPROACH, lane] >= state[PEAK, lane] else 0.0
        over = 1.0 if (state[APPROACH, lane] <= 0.0) | (state[KICKS, lane] > limit) else 0.0
        state[EVENT, lane] = max(turned if state[RISING, lane] > 0.0 else again, over)
        state[PEAK, lane] = max(state[PEAK, lane], state[APPROACH, lane])
    for lane in range(lane_count):
        any_event |= state[EVENT, lane] > 0.0
    return any_event > 0


@_inlined
def _follow(lane: int, bat: BatNumbers, ball: BallNumbers, steps: Steps, lanes: Lanes, output: HitOutput) -> bool:
    """Do what an event asks for; return whether the lane's hit has ended."""
    state, limit = lanes.state, steps.limit
    kicks = state[KICKS, lane]
    if state[APPROACH, lane] <= 0 or kicks > limit:
        if state[UNTIL, lane] == 0.0:
            _finish(lane, ball, steps, lanes, output)
            more = _kicks_within_reach(lane, bat.omega, steps.step, limit, lanes)
            state[UNTIL, lane], state[OFFSET, lane], state[FREE, lane] = min(limit, kicks + more), QUIET, 0.0
        if kicks >= state[UNTIL, lane]:
            return True
        # the bat may catch up: go on without a force; any touch is an event
        state[FREE, lane] += _forgetting(-state[APPROACH, lane], state[DEEPEST, lane])
        state[APPROACH, lane], state[PEAK, lane], state[RISING, lane] = 1.0, 0.0, 0.0
    elif state[UNTIL, lane] > 0.0:
        _touch_again(lane, ball, steps.step, state)
    else:
        _turn(lane, ball, steps.step, state)
    return False


@_inlined
def _push(lane_count: int, damping: float, stray: Array, state: Array) -> None:
    """Solve for the elastic force of every lane, at its approach; ``damping`` is the ball's, s/m."""
    rough = 0
    for lane in range(lane_count):
        guess = max(
            state[APPROACH, lane] - state[GIVE, lane] * (2.0 * state[FORCE, lane] - state[FORMER, lane]),
            0.25 * state[APPROACH, lane],
        )
        pushing = exp(state[OFFSET, lane] + state[POWER, lane] * log(guess))
        missing = state[APPROACH, lane] - guess - state[GIVE, lane] * pushing
        inverse = 1.0 / guess
        steepness = state[POWER, lane] * pushing * inverse
        bend = (0.5 * state[POWER, lane] - 0.5) * steepness * inverse
        softened = 1.0 / (1.0 + state[GIVE, lane] * steepness)
        missing *= softened
        stray[lane] = abs(missing) * inverse * max(1.0, STEEP * state[POWER, lane])
        rough |= not stray[lane] <= ROUGH  # nor is a forecast whose force is beyond all numbers
        missing *= 1.0 - state[GIVE, lane] * bend * missing * softened
        state[PUSHED, lane] = pushing + missing * (steepness + bend * missing)
        state[DAMPED, lane] = damping / (1.0 + state[SURFACE_GIVE, lane] * (steepness + 2.0 * bend * missing))
    if rough:
        for lane in range(lane_count):
            if not stray[lane] <= ROUGH:
                foretold = 2.0 * state[FORCE, lane] - state[FORMER, lane]
                compression, state[PUSHED, lane] = pressed(
                    state[APPROACH, lane], state[GIVE, lane], foretold, state[OFFSET, lane], state[POWER, lane]
                )
                steepness = state[POWER, lane] * state[PUSHED, lane] / compression
                state[DAMPED, lane] = damping / (1.0 + state[SURFACE_GIVE, lane] * steepness)


@_inlined
def _drift(lane_count: int, drift: Array, lanes: Lanes) -> None:
    """Kick every mode of every lane and let it move for a step; add up where the surface is, and how fast it moves."""
    shapes, places, speeds = lanes.shape, lanes.displacement, lanes.velocity
    lanes.state[RATE, :lane_count] = 0.0
    for i in range(len(drift)):
        a, b, c, d = drift[i, 0, 0], drift[i, 0, 1], drift[i, 1, 0], drift[i, 1, 1]
        for lane in range(lane_count):
            place, start = places[i, lane], speeds[i, lane] + shapes[i, lane] * lanes.state[IMPULSE, lane]
            moved = a * place + b * start
            speed = c * place + d * start
            speeds[i, lane] = speed
            places[i, lane] = moved
            lanes.state[SURFACE, lane] += shapes[i, lane] * moved
            lanes.state[RATE, lane] += shapes[i, lane] * speed


@inner(_nrt=False)
def _dash(velocity: Array, dashpots: Array, factors: Array, rate: Array) -> None:
    """Apply the dashpots to the modal velocities of every lane."""
    for k in range(len(factors)):
        rate[:] = 0.0
        for i in range(len(velocity)):
            for lane in range(len(rate)):
                rate[lane] += dashpots[k, i] * velocity[i, lane]
        for i in range(len(velocity)):
            for lane in range(len(rate)):
                velocity[i, lane] -= factors[k] * dashpots[k, i] * rate[lane]


@inner(_nrt=False)
def _start(
    lane: int,
    following: int,
    closing_speed: Array,
    bat: BatNumbers,
    ball: BallNumbers,
    steps: Steps,
    lanes: Lanes,
    output: HitOutput,
) -> int:
    """Put the next hit that makes contact into a lane, or leave the lane idle; return the hit after it."""
    count, size = bat.shapes.shape
    while following < count and not closing_speed[following] > 0:
        output.outcome[following] = NO_CONTACT
        output.results[:, following], output.results[TOUCHES, following] = np.nan, 0.0
        if output.motion.shape[1]:
            output.motion[:, following] = 0.0
        following += 1
    idle = following >= count
    if not idle:
        output.results[TOUCHES, following] = 0.0
    lanes.hit_of[lane] = -1 if idle else following
    speed = 0.0 if idle else closing_speed[following]
    by_steps, lightness = steps.step**2 / 12 / ball.mass, 1 / ball.mass
    for i in range(size):
        lanes.shape[i, lane] = 0.0 if idle else bat.shapes[following, i]
        by_steps += lanes.shape[i, lane] ** 2 * bat.step_give[i]
        lightness += lanes.shape[i, lane] ** 2
        lanes.displacement[i, lane] = 0.0
        lanes.velocity[i, lane] = 0.0
    state = lanes.state
    state[:, lane] = 0.0
    state[CLOSING, lane] = speed
    state[BALL_SPEED, lane] = state[RATE, lane] = speed
    state[BALL_POSITION, lane] = 1.0 if idle else speed * steps.first_kick * steps.step
    surface_give = 0.0 if idle else bat.give[following]
    state[GIVE, lane], state[SURFACE_GIVE, lane] = by_steps + surface_give, surface_give
    state[BY_STEPS, lane], state[LIGHTNESS, lane] = by_steps, lightness
    state[APPROACH, lane] = state[BALL_POSITION, lane]
    _touch(lane, ball, state)
    if idle:  # never turns, ends or pushes
        state[PEAK, lane], state[RISING, lane], state[OFFSET, lane], state[KICKS, lane] = 2.0, 0.0, QUIET, -np.inf
    return following + 1


@inner(_nrt=False)
def _touch(lane: int, ball: BallNumbers, state: Array) -> None:
    """Begin a contact: the ball is where it is, nothing presses yet, and loading comes first."""
    state[PEAK, lane] = state[APPROACH, lane]
    state[BEFORE, lane] = state[EARLIER, lane] = 0.0
    state[RISING, lane] = 1.0
    state[OFFSET, lane], state[POWER, lane] = log(ball.stiffness), ball.exponent
    state[FORCE, lane] = state[FORMER, lane] = state[UNTIL, lane] = 0.0
    state[TOTAL, lane] = state[FORMER_TOTAL, lane] = 0.0
    state[MIDDLE, lane] = state[RATE, lane]


@inner(_nrt=False)
def _touch_again(lane: int, ball: BallNumbers, step: float, state: Array) -> None:
    """Begin another contact, of a ball that remembers what it was pressed in: `coupled._touched_again`."""
    _touch(lane, ball, state)
    deepest = state[TURNED_AT, lane]
    if deepest > 0:
        deepest = _remembered(ball, deepest, state[DEEPEST, lane], state[FREE, lane] * step)
    state[TURNED_AT, lane] = deepest
    if deepest > 0:
        force = ball.stiffness * deepest**ball.exponent
        peak = deepest + state[GIVE, lane] * force
        if state[APPROACH, lane] < peak:
            power = _unloading_power(ball, deepest, force)
            state[PEAK, lane], state[RISING, lane] = peak, 0.0
            state[OFFSET, lane], state[POWER, lane] = log(force) - power * log(deepest), power


@inner(_nrt=False)
def _turn(lane: int, ball: BallNumbers, step: float, state: Array) -> None:
    """Change a lane from loading to unloading, at the top of the parabola through three kicks, or back."""
    if state[RISING, lane] == 0.0:
        state[RISING, lane] = 1.0
        state[OFFSET, lane], state[POWER, lane] = log(ball.stiffness), ball.exponent
        return
    state[RISING, lane] = 0.0
    earlier, before, latest = state[EARLIER, lane], state[BEFORE, lane], state[APPROACH, lane]
    shift, bend = 0.5, 0.0
    if earlier > 0:
        shift, height = _vertex(earlier, before, latest)
        bend = earlier - 2 * before + latest
        state[PEAK, lane] = max(state[PEAK, lane], height)
    give = state[GIVE, lane]
    deepest, force = pressed(state[PEAK, lane], give, state[FORCE, lane], log(ball.stiffness), ball.exponent)
    state[DEEPEST, lane], state[TURNED_AT, lane] = max(state[DEEPEST, lane], deepest), deepest
    state[HARDEST, lane] = max(state[HARDEST, lane], force)
    power, slope = _unloading_power(ball, deepest, force), force / deepest
    state[OFFSET, lane], state[POWER, lane] = log(force) - power * log(deepest), power
    stiffening = power * slope / (1 + give * power * slope) - ball.exponent * slope / (1 + give * ball.exponent * slope)
    state[MISSING, lane] = _impulse_of_the_turn(shift, bend, stiffening, step)


@inner(_nrt=False)
def pressed(approach: float, give: float, force: float, offset: float, power: float) -> tuple[float, float]:
    """Return a ball's compression u in m and its force F in N, u + C F(u) = w, by Halley's method from about a force.

    See `contact_law.pressed_in_series`. F = exp(offset) u^power is convex, so that no step from the right of the root
    passes it; one from the left may, and ends where C F = w at most.
    """
    most = min(approach, exp((log(approach / give) - offset) / power))
    compression = min(max(approach - give * force, 0.25 * approach), most)
    for _ in range(NEWTON_STEPS):
        force = exp(offset + power * log(compression))
        steepness = power * force / compression
        bend = (0.5 * power - 0.5) * steepness / compression
        softened = 1 / (1 + give * steepness)
        change = (approach - compression - give * force) * softened
        change /= 1 + give * bend * change * softened
        change = min(change, most - compression)
        compression += change
        force += change * (steepness + bend * change)
        if abs(change) < NEARLY * compression:  # the next change is about the cube of this one
            break
    return compression, force


@inner(_nrt=False)
def _kicks_within_reach(lane: int, omega: Array, step: float, limit: float, lanes: Lanes) -> float:
    """Return after how many kicks a ball is out of reach of all vibrations together: `_Flow.overtaken` of `coupled`."""
    state = lanes.state
    speed, push, energy = -state[BALL_SPEED, lane], 0.0, 0.0
    for i in range(len(omega)):
        shape, p = lanes.shape[i, lane], lanes.velocity[i, lane]
        if omega[i] < SLOW:
            speed += shape * p
        else:
            push += shape * shape
            energy += p * p + (omega[i] * lanes.displacement[i, lane]) ** 2
    if speed > 0 and speed * speed > push * energy:  # by Cauchy's inequality faster than all vibrations together
        return 0.0
    fastest = 0.0
    for i in range(len(omega)):
        if omega[i] >= SLOW:
            p, from_place = lanes.velocity[i, lane], omega[i] * lanes.displacement[i, lane]
            fastest += abs(lanes.shape[i, lane]) * math.sqrt(p * p + from_place * from_place)
    if speed > fastest or speed <= 0:
        return 0.0 if speed > fastest else limit
    distance, reach = -state[BALL_POSITION, lane], 0.0
    for i in range(len(omega)):
        shape, q, p = lanes.shape[i, lane], lanes.displacement[i, lane], lanes.velocity[i, lane]
        if omega[i] < SLOW:
            distance += shape * q
        else:
            reach += abs(shape) * math.sqrt(q * q + (p / omega[i]) ** 2)
    return float(max(0.0, (reach - distance) / (speed * step)))


@inner(_nrt=False)
def _finish(lane: int, ball: BallNumbers, steps: Steps, lanes: Lanes, output: HitOutput) -> None:
    """Write the results of a lane whose ball has left, or whose time is up."""
    state, results, row = lanes.state, output.results, lanes.hit_of[lane]
    separated = state[APPROACH, lane] <= 0
    output.outcome[row] = SEPARATED if separated else STILL_IN_CONTACT
    results[: RELEASE_TIME + 1, row], results[LATE, row] = np.nan, 0.0
    results[TOUCHES, row] += 1.0
    results[GREATEST_FORCE, row] = max(state[LARGEST, lane], state[HARDEST, lane])
    if state[DEEPEST, lane] == 0:
        peak, give, offset = state[PEAK, lane], state[GIVE, lane], log(ball.stiffness)
        state[DEEPEST, lane], _ = pressed(peak, give, state[FORCE, lane], offset, ball.exponent)
    results[GREATEST_COMPRESSION, row] = state[DEEPEST, lane]
    if separated:
        threshold = CONTACT_FORCE * state[LARGEST, lane]
        if state[TOTAL, lane] >= threshold:
            state[CONTACT, lane] = state[KICKS, lane] + 1 - threshold / state[TOTAL, lane]
        crossing = _crossing(state[EARLIER, lane], state[BEFORE, lane], state[APPROACH, lane])
        results[EFFICIENCY, row] = -state[BALL_SPEED, lane] / state[CLOSING, lane]
        results[CONTACT_TIME, row] = (state[CONTACT, lane] - 2 + steps.first_kick) * steps.step
        results[LATE, row] = (1 - crossing) * steps.step
        results[RELEASE_TIME, row] = (state[KICKS, lane] - 1 + steps.first_kick) * steps.step - results[LATE, row]
    if output.motion.shape[1]:
        for i in range(len(lanes.shape)):
            output.motion[0, row, i] = lanes.displacement[i, lane]
            output.motion[1, row, i] = lanes.velocity[i, lane]
