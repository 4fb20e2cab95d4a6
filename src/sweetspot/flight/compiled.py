"""The compiled heart of `kernel`: `LANES` flights advance side by side, by the same steps as in `trajectory`.

All numbers of the lanes lie in one flat array, row after row, so that the compiler sees that no two rows overlap and
turns the loop over lanes into vector instructions. What happens seldom (apex, landing, the edge of the wind, a point
of a path) is done lane by lane.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numba.extending import register_jitable

from sweetspot.flight import aerodynamics
from sweetspot.flight.aerodynamics import SLOWEST, SMALLEST_SPIN_FACTOR
from sweetspot.flight.trajectory import MOST_STEPS, SLOW, TIME_LIMIT, FlightOutcome
from sweetspot.numerics import interpolants
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import exp, log

State = tuple[float, float, float, float, float, float, float]
"""Position, velocity and the part of the spin that is left."""
Spin = tuple[float, float, float, float]
"""Spin vector and its size."""
Pair = tuple[float, float]
Flown = tuple[Spin, float, Pair]
"""Spin at the start, the drag's strength (per Cd and square of the speed, 1/m), and the wind where it blows."""

LANES = 16
"""Flights side by side."""
# rows of the input: position, velocity, spin, then these
START_Z, START_VZ, START_SPIN, DENSITY, START_WIND = 2, 5, 6, 9, 10
INPUT_ROWS = 12
# rows of the results: position, velocity, the part of the spin that is left, then these
SPIN_LEFT, HANG, APEX_HEIGHT, APEX_TIME = 6, 7, 8, 9
RESULT_ROWS = 10


class FlightOutput(NamedTuple):
    """Output arrays: outcome (n,), results (10, n), paths (n, k, 3)."""

    outcome: IntArray
    results: Array
    paths: Array


LANDED, STILL_FLYING = int(FlightOutcome.LANDED), int(FlightOutcome.STILL_FLYING)
UNDERGROUND, UNUSABLE = int(FlightOutcome.UNDERGROUND), int(FlightOutcome.UNUSABLE)

# first places of the rows of the lanes' numbers: the state now and a step ago, then what belongs to the flight
NOW, BEFORE = 0, 7 * LANES
X, Y, Z, VX, VY, VZ, LEFT = (LANES * row for row in range(7))
SPIN_X, SPIN_Y, SPIN_Z, SPIN, STRENGTH, WIND_X, WIND_Y, OPEN, TAKEN, TIME, EVENT, NEXT, STEPS, TOP, TOP_TIME = (
    LANES * row for row in range(14, 29)
)
FLIGHT, FILLED = 29 * LANES, 30 * LANES
"""Number of a lane's flight, -1 where it is idle, and how many points of its path are filled."""
ROWS = 31

# the readable functions, compiled where compiled code calls them
_on_cubic = register_jitable(interpolants.on_cubic)
_turn_on_cubic = register_jitable(interpolants.turn_on_cubic)
_first_crossing = register_jitable(interpolants.first_crossing)
register_jitable(interpolants.root_on_cubic)
_inlined = inner(forceinline=True, error_model="numpy", fastmath={"contract", "nsz"})
_drag_with_spin = _inlined(aerodynamics.drag_with_spin)
_lift_by_power = _inlined(aerodynamics.lift_by_power)


class FlightLaw(NamedTuple):
    """Constants that all flights of a batch share.

    Parameters
    ----------
    radius : of the ball, m.
    drag, drag_per_spin, drag_per_active_spin, drag_per_spin_factor, lift_scale, lift_offset, lift_slope : as in
        `Aerodynamics`, the drag without its part with Reynolds's number.
    viscous : braking by that part, 1/s.
    decay : part of the spin lost per m of way through the air.
    reference : height in m at which the wind is measured.
    """

    radius: float
    drag: float
    drag_per_spin: float
    drag_per_active_spin: float
    drag_per_spin_factor: float
    viscous: float
    lift_scale: float
    lift_offset: float
    lift_slope: float
    decay: float
    reference: float


class FlightMethod(NamedTuple):
    """Everything that all flights of a batch share.

    Parameters
    ----------
    law : constants of the forces.
    per_density : drag acceleration per density, Cd and square of the speed, m^2/kg.
    power, profile : exponents of the lift law and of the wind, None for 1 and for a wind alike at every height.
    edge : m, the height where the wind begins.
    step : s.
    """

    law: FlightLaw
    per_density: float
    power: float | None
    profile: float | None
    edge: float
    step: float


@_inlined
def state_of(lanes: Array, place: int) -> State:
    """Return the state at a lane, or, from `BEFORE` on, the one a step ago."""
    x, y, z, left = lanes[X + place], lanes[Y + place], lanes[Z + place], lanes[LEFT + place]
    return x, y, z, lanes[VX + place], lanes[VY + place], lanes[VZ + place], left


@_inlined
def put_state(lanes: Array, place: int, state: State) -> None:
    """Write a state where `state_of` reads it."""
    lanes[X + place], lanes[Y + place], lanes[Z + place] = state[0], state[1], state[2]
    lanes[VX + place], lanes[VY + place], lanes[VZ + place] = state[3], state[4], state[5]
    lanes[LEFT + place] = state[6]


@_inlined
def flown_in(lanes: Array, lane: int, blowing: float) -> Flown:
    """Return the constants of a lane's flight; ``blowing`` is 1 in the wind and 0 where nothing blows."""
    spin = lanes[SPIN_X + lane], lanes[SPIN_Y + lane], lanes[SPIN_Z + lane], lanes[SPIN + lane]
    return spin, lanes[STRENGTH + lane], (blowing * lanes[WIND_X + lane], blowing * lanes[WIND_Y + lane])


@_inlined
def put_start(lanes: Array, lane: int, start: Array, flight: int, strength: float) -> None:
    """Put a flight at its start into a lane; ``strength`` is the drag's, per Cd and square of the speed, 1/m."""
    for row in range(6):
        lanes[row * LANES + lane] = start[row, flight]
    lanes[LEFT + lane] = 1.0
    x, y, z = start[START_SPIN, flight], start[START_SPIN + 1, flight], start[START_SPIN + 2, flight]
    lanes[SPIN_X + lane], lanes[SPIN_Y + lane], lanes[SPIN_Z + lane] = x, y, z
    lanes[SPIN + lane] = math.sqrt(x * x + y * y + z * z)
    lanes[STRENGTH + lane] = strength
    lanes[WIND_X + lane], lanes[WIND_Y + lane] = start[START_WIND, flight], start[START_WIND + 1, flight]


@_inlined
def _rates(
    height: float, velocity: tuple[float, float, float], left: float, flown: Flown, law: FlightLaw,
    power: float | None, profile: float | None,
) -> tuple[float, float, float, float, float]:  # fmt: skip
    """Return (acceleration right, out, up; change of the spin left; how fast the air changes the velocity)."""
    (right, out, up), (spin, strength, wind) = velocity, flown
    blowing = 1.0
    if profile is not None:
        blowing = exp(profile * log(max(height, 1e-300) / law.reference))
    right -= blowing * wind[0]
    out -= blowing * wind[1]
    square = max(right * right + out * out + up * up, SLOWEST**2)
    speed = math.sqrt(square)
    across_right = left * (spin[1] * up - spin[2] * out)
    across_out = left * (spin[2] * right - spin[0] * up)
    across_up = left * (spin[0] * out - spin[1] * right)
    across = math.sqrt(across_right * across_right + across_out * across_out + across_up * across_up)
    factor = law.radius * across / square
    raised, steepness = factor, 1.0
    if power is not None:
        floored = max(factor, SMALLEST_SPIN_FACTOR)
        raised = exp(power * log(floored))
        steepness = raised / floored
    lift = strength * law.radius * _lift_by_power(law, raised, steepness)
    coefficient = _drag_with_spin(law, factor, left * spin[3], across / speed)
    braking = strength * speed * coefficient + law.viscous * (strength > 0)
    return (
        lift * across_right - braking * right,
        lift * across_out - braking * out,
        lift * across_up - braking * up - STANDARD_GRAVITY,
        -law.decay * speed * left,
        braking + lift * across / speed + math.sqrt(STANDARD_GRAVITY * braking / speed),
    )


@_inlined
def stepped(
    state: State, step: float, flown: Flown, law: FlightLaw, power: float | None, profile: float | None
) -> State:
    """Return a state one step later, by Runge's and Kutta's classical method."""
    x, y, z, vx, vy, vz, left = state
    half, sixth = step / 2, step / 6
    ax, ay, az, worn, _ = _rates(z, (vx, vy, vz), left, flown, law, power, profile)
    bx, by, bz = vx + half * ax, vy + half * ay, vz + half * az
    cx, cy, cz, worn_2, _ = _rates(z + half * vz, (bx, by, bz), left + half * worn, flown, law, power, profile)
    dx, dy, dz = vx + half * cx, vy + half * cy, vz + half * cz
    ex, ey, ez, worn_3, _ = _rates(z + half * bz, (dx, dy, dz), left + half * worn_2, flown, law, power, profile)
    fx, fy, fz = vx + step * ex, vy + step * ey, vz + step * ez
    gx, gy, gz, worn_4, _ = _rates(z + step * dz, (fx, fy, fz), left + step * worn_3, flown, law, power, profile)
    return (
        x + sixth * (vx + 2 * (bx + dx) + fx),
        y + sixth * (vy + 2 * (by + dy) + fy),
        z + sixth * (vz + 2 * (bz + dz) + fz),
        vx + sixth * (ax + 2 * (cx + ex) + gx),
        vy + sixth * (ay + 2 * (cy + ey) + gy),
        vz + sixth * (az + 2 * (cz + ez) + gz),
        left + sixth * (worn + 2 * (worn_2 + worn_3) + worn_4),
    )


@inner(error_model="numpy", fastmath={"contract", "nsz"})
def _advance(
    lanes: Array, step: float, edge: float, law: FlightLaw, power: float | None, profile: float | None
) -> float:
    """Move every lane by one step; return above zero where something happened in a lane's step."""
    for lane in range(LANES):
        state, flown = state_of(lanes, lane), flown_in(lanes, lane, lanes[OPEN + lane])
        _, _, z, vx, vy, vz, left = state
        response = _rates(z, (vx, vy, vz), left, flown, law, power, profile)[4]
        length = step / max(1.0, SLOW * response)
        put_state(lanes, BEFORE + lane, state)
        put_state(lanes, lane, stepped(state, length, flown, law, power, profile))
        lanes[TAKEN + lane] = length
    events = 0.0
    for lane in range(LANES):
        lanes[TIME + lane] += lanes[TAKEN + lane]
        lanes[STEPS + lane] += 1.0
        turned = 1.0 if lanes[VZ + lane] * lanes[BEFORE + VZ + lane] < 0.0 else 0.0
        down = 1.0 if lanes[Z + lane] <= 0.0 else 0.0
        crossed = 1.0 if (lanes[Z + lane] - edge) * (lanes[BEFORE + Z + lane] - edge) < 0.0 else 0.0
        late = 1.0 if lanes[TIME + lane] >= min(TIME_LIMIT, lanes[NEXT + lane]) else 0.0
        long = 1.0 if lanes[STEPS + lane] >= MOST_STEPS else 0.0
        event = turned + down + crossed + late + long
        lanes[EVENT + lane] = event
        events += event
    return events


@compiled(nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
def solve(start: Array, method: FlightMethod, output: FlightOutput) -> None:
    """Fill outcome and results of n flights; or their paths, once the results hold their hang times.

    Every lane carries one flight; when it has landed, the lane takes the next one, so that no lane waits for another.

    ``start``: (12, n), see the rows of the input above. ``output``: with k points of each path, evenly in time; k = 0
    to solve.
    """
    lanes = np.zeros(ROWS * LANES)
    following, busy = 0, 0
    law, _, power, profile, edge, step = method
    for lane in range(LANES):
        following = _start(lane, following, start, method, lanes, output)
        busy += lanes[FLIGHT + lane] >= 0
    while busy > 0:
        if _advance(lanes, step, edge, law, power, profile) == 0.0:
            continue
        for lane in range(LANES):
            if lanes[EVENT + lane] == 0.0 or lanes[FLIGHT + lane] < 0:
                continue
            if _event(lane, method, lanes, output):
                following = _start(lane, following, start, method, lanes, output)
                busy -= lanes[FLIGHT + lane] < 0


@inner(forceinline=True)
def _start(lane: int, following: int, start: Array, method: FlightMethod, lanes: Array, output: FlightOutput) -> int:
    """Put the next flight that leaves the ground into a lane, or leave the lane idle; return the flight after it."""
    edge = method.edge
    count, drawing = start.shape[1], output.paths.shape[1] > 0
    while following < count and not _leaves(following, start, drawing, output):
        following += 1
    for row in range(ROWS):
        lanes[row * LANES + lane] = 0.0
    lanes[FLIGHT + lane] = following if following < count else -1.0
    if following >= count:
        lanes[Z + lane] = lanes[BEFORE + Z + lane] = 1.0
        return following
    put_start(lanes, lane, start, following, method.per_density * start[DENSITY, following])
    height = start[START_Z, following]
    lanes[OPEN + lane] = 0.0 if height < edge or (height == edge and start[START_VZ, following] < 0) else 1.0
    lanes[TOP + lane] = height
    lanes[NEXT + lane] = 0.0 if drawing else np.inf
    return following + 1


@inner(forceinline=True)
def _leaves(i: int, start: Array, drawing: bool, output: FlightOutput) -> bool:
    """Return whether a flight takes place; write down how it ends where it does not, or at once."""
    outcome, results, paths = output
    if drawing:
        if outcome[i] != LANDED or results[HANG, i] == 0:
            for point in range(paths.shape[1]):
                for axis in range(3):
                    paths[i, point, axis] = start[axis, i] if outcome[i] == LANDED else np.nan
            return False
        return True
    sound = start[DENSITY, i] >= 0
    for value in range(INPUT_ROWS):
        sound = sound and math.isfinite(start[value, i])
    for row in range(RESULT_ROWS):
        results[row, i] = np.nan
    if not sound:
        outcome[i] = UNUSABLE
    elif start[START_Z, i] < 0:
        outcome[i] = UNDERGROUND
    elif start[START_Z, i] == 0 and start[START_VZ, i] <= 0:
        outcome[i] = LANDED
        for row in range(RESULT_ROWS):
            results[row, i] = start[row, i] if row < SPIN_LEFT else 0.0
        results[SPIN_LEFT, i] = 1.0
    else:
        return True
    return False


@inner(forceinline=True, error_model="numpy")
def _event(lane: int, method: FlightMethod, lanes: Array, output: FlightOutput) -> bool:
    """Do what a lane's step calls for; return whether its flight is over."""
    edge = method.edge
    outcome, results, paths = output
    i, length = int(lanes[FLIGHT + lane]), lanes[TAKEN + lane]
    height, climb, end = lanes[BEFORE + Z + lane], lanes[BEFORE + VZ + lane], lanes[Z + lane]
    rise, fall = length * climb, length * lanes[VZ + lane]
    part = _first_crossing(height - edge, end - edge, rise, fall) if edge > 0 else -1.0
    if part >= 0:
        length = _shorten(lane, part, edge, lanes, method)
        end, rise, fall = edge, length * climb, length * lanes[VZ + lane]
        lanes[OPEN + lane] = 1.0 if fall > 0 else 0.0
    if rise > 0 > fall:
        turn = _turn_on_cubic(height, end, rise, fall)
        top = _on_cubic(turn, height, end, rise, fall)
        if top > lanes[TOP + lane]:
            lanes[TOP + lane], lanes[TOP_TIME + lane] = top, lanes[TIME + lane] - (1 - turn) * length
    part = _first_crossing(height, end, rise, fall)
    landed = part >= 0
    if landed:
        _shorten(lane, part, 0.0, lanes, method)
    if paths.shape[1]:
        _draw(lane, landed, lanes, results[HANG, i], paths[i])
        return landed
    if not landed and lanes[TIME + lane] < TIME_LIMIT and lanes[STEPS + lane] < MOST_STEPS:
        return False
    if landed:
        outcome[i] = LANDED
        for row in range(7):
            results[row, i] = lanes[row * LANES + lane]
        results[HANG, i] = lanes[TIME + lane]
        results[APEX_HEIGHT, i], results[APEX_TIME, i] = lanes[TOP + lane], lanes[TOP_TIME + lane]
    else:
        outcome[i] = STILL_FLYING
    return True


@inner(error_model="numpy")
def _shorten(lane: int, part: float, height: float, lanes: Array, method: FlightMethod) -> float:
    """Take only a part of a lane's last step, which ends at a known height; return how long it is."""
    law, _, power, profile, _, _ = method
    length = part * lanes[TAKEN + lane]
    state, flown = state_of(lanes, BEFORE + lane), flown_in(lanes, lane, lanes[OPEN + lane])
    put_state(lanes, lane, stepped(state, length, flown, law, power, profile))
    lanes[Z + lane] = height
    lanes[TIME + lane] += length - lanes[TAKEN + lane]
    lanes[TAKEN + lane] = length
    return float(length)


@inner
def _draw(lane: int, landed: bool, lanes: Array, hang_time: float, path: Array) -> None:
    """Fill the points of a path that lie in a lane's last step."""
    length, now = lanes[TAKEN + lane], lanes[TIME + lane]
    last, point = len(path) - 1, int(lanes[FILLED + lane])
    while point <= last and (point * hang_time / last <= now or landed):
        part = min(1.0, 1.0 - (now - point * hang_time / last) / length)
        for axis in range(3):
            place = axis * LANES + lane
            path[point, axis] = _on_cubic(
                part,
                lanes[BEFORE + place],
                lanes[place],
                length * lanes[BEFORE + VX + place],
                length * lanes[VX + place],
            )
        point += 1
    lanes[FILLED + lane] = point
    lanes[NEXT + lane] = point * hang_time / last if point <= last else np.inf
