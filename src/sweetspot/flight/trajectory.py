"""One flight, step by step: the readable version.

Position, velocity and the part of the spin that is left advance by the classical Runge-Kutta method of fourth order.
Apex and landing are roots on the cubic through both ends of a step, which is as accurate. Where the wind's profile has
a jump, a step ends on it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import SLOWEST, acceleration, drag_and_lift
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.numerics.interpolants import first_crossing, on_cubic, turn_on_cubic
from sweetspot.numerics.notebook_display import ShownInNotebooks

STEP = 0.05
"""s, the longest step; carries of baseballs are then well within 0.001 ft of the converged ones."""
SLOW = 1.0
"""s; where the air changes the velocity in a shorter time than this, the steps are shorter in proportion."""
TIME_LIMIT = 100.0
"""s; a ball shot straight up at 1100 mph without air would still be flying."""
MOST_STEPS = 100_000
"""Of one flight; only absurd numbers need so many."""


class FlightOutcome(IntEnum):
    """Outcome of a flight; a batch carries one per row."""

    LANDED = 0
    STILL_FLYING = 1
    UNDERGROUND = 2
    UNUSABLE = 3

    @property
    def sentence(self) -> str:
        """The outcome in words."""
        return {
            FlightOutcome.LANDED: "the ball has landed",
            FlightOutcome.STILL_FLYING: f"the ball was still in the air after {TIME_LIMIT:g} s",
            FlightOutcome.UNDERGROUND: "the flight would start below the ground",
            FlightOutcome.UNUSABLE: "position, velocity, spin or wind are not finite, or the air has no density",
        }[self]


@dataclass(frozen=True)
class Flight(ShownInNotebooks):
    """One flight.

    Parameters
    ----------
    outcome : how it ended; where the ball did not land, carry and hang time are nan.
    carry : m over the ground from the tip of home plate to where the ball lands.
    hang_time : s in the air.
    apex_height, apex_time : m above the ground and s, the highest point.
    launch, landing : the ball at both ends; where it did not land, ``landing`` is the last moment known.
    times, positions, velocities : the path from launch to landing, shape (n,), (n, 3) and (n, 3), s, m, m/s.
    spin_left : part of the spin that is left on the path, shape (n,).
    """

    outcome: FlightOutcome
    carry: float
    hang_time: float
    apex_height: float
    apex_time: float
    launch: BallMotion
    landing: BallMotion
    times: Array
    positions: Array
    velocities: Array
    spin_left: Array

    def __repr__(self) -> str:
        """Return the outcome of the flight."""
        return f"<Flight {self.outcome.name.lower()}: carry {self.carry:.4g} m in {self.hang_time:.3g} s>"

    @property
    def bearing(self) -> float:
        """Direction in which the ball comes down, rad from centre field, positive to right field."""
        return math.atan2(self.landing.position[0], self.landing.position[1])

    @property
    def landing_angle(self) -> float:
        """Descent angle of the ball, rad below horizontal."""
        return -self.landing.launch_angle

    def at(self, time: float) -> BallMotion:
        """Return the ball at a time in s after launch; raises `InputError` for one outside the flight."""
        if not self.times[0] <= time <= self.times[-1]:
            raise InputError(f"time is {time:g} s; the ball is in the air from 0 to {self.times[-1]:.3f} s")
        if len(self.times) == 1:
            return self.launch
        after = max(1, int(np.searchsorted(self.times, time)))
        before = after - 1
        length = float(self.times[after] - self.times[before])
        part = (time - float(self.times[before])) / length
        slopes = length * self.velocities
        position = np.array(
            [
                on_cubic(part, self.positions[before, k], self.positions[after, k], slopes[before, k], slopes[after, k])
                for k in range(3)
            ]
        )
        velocity = (1 - part) * self.velocities[before] + part * self.velocities[after]
        left = (1 - part) * self.spin_left[before] + part * self.spin_left[after]
        return BallMotion(position=position, velocity=velocity, spin=left * self.launch.spin)


def fly(
    motion: BallMotion,
    conditions: FlightConditions,
    *,
    step: float = STEP,
) -> Flight:
    """Return the flight of a ball to the ground.

    x'' = a(x' - wind(z), spin(t)), see `forces.acceleration`; the spin keeps its axis and tires along its way through
    the air. The ground is z = 0, for the ball's centre, as in the sheet [nathan_calculator].

    Parameters
    ----------
    motion : the ball as it leaves the bat, in the frame of the field.
    conditions : ball, drag law, and one air and one wind.
    step : s, > 0; the error falls with its fourth power.

    Raises
    ------
    InputError
        for a start below the ground.

    >>> from sweetspot.equipment.ball import Ball, RestitutionLaw
    >>> from sweetspot.flight.aerodynamics import Aerodynamics
    >>> from sweetspot.flight.air import VACUUM
    >>> from sweetspot.motion.ball_motion import batted_ball
    >>> law = RestitutionLaw(reference=0.5, reference_speed=30)
    >>> ball = Ball(name="any", mass=0.145, radius=0.0369, restitution=law, stiffness=1e7, exponent=1.5)
    >>> start = batted_ball(speed=30.0, launch_angle=math.pi / 6)
    >>> flight = fly(start, FlightConditions(ball=ball, aerodynamics=Aerodynamics(drag=0.35), air=VACUUM))
    >>> abs(flight.hang_time - 30.0 / 9.80665) < 1e-12  # exact: 2 v sin(30 deg) / g
    True
    """
    check_step(step)
    if motion.position[2] < 0:
        raise InputError(f"the ball starts {-motion.position[2]:.4g} m below the ground; give a height of 0 m or more")
    solver = _Solver(motion, conditions)
    outcome = FlightOutcome.STILL_FLYING
    while solver.times[-1] < TIME_LIMIT and len(solver.times) < MOST_STEPS:
        if solver.advanced(step):
            outcome = FlightOutcome.LANDED
            break
    states, landed = np.array(solver.states), outcome is FlightOutcome.LANDED
    last, time = states[-1], solver.times[-1]
    return Flight(
        outcome=outcome,
        carry=math.hypot(*last[:2]) if landed else math.nan,
        hang_time=time if landed else math.nan,
        apex_height=solver.apex[0],
        apex_time=solver.apex[1],
        launch=motion,
        landing=BallMotion(position=last[:3], velocity=last[3:6], spin=last[6] * motion.spin),
        times=np.array(solver.times),
        positions=states[:, :3],
        velocities=states[:, 3:6],
        spin_left=states[:, 6],
    )


def check_step(step: float) -> None:
    """Refuse a time step that is not a number above zero, or longer than a second."""
    if not (math.isfinite(step) and 0 < step <= 1):
        raise InputError(f"step is {step:g} s; allowed is above zero to 1 s, for example {STEP:g}")


class _Solver:
    """A flight on its way: every state so far (position, velocity, part of the spin left) and the highest point."""

    def __init__(self, motion: BallMotion, conditions: FlightConditions) -> None:
        self.ball, self.aerodynamics = conditions.ball, conditions.aerodynamics
        self.density, self.wind = conditions.one_air.density, conditions.one_wind
        self.spin = motion.spin
        self.times = [0.0]
        self.states = [np.concatenate([motion.position, motion.velocity, [1.0]])]
        self.apex = (float(motion.position[2]), 0.0)

    def through_air(self, state: Array, sheltered: bool) -> Array:
        """Return the velocity of the ball against the wind."""
        strength = 0.0 if sheltered else self.wind.open_strength(state[2])
        return np.asarray(state[3:6] - strength * self.wind.velocity)

    def rates(self, state: Array, sheltered: bool) -> Array:
        """Return the time derivative of a state."""
        velocity = self.through_air(state, sheltered)
        push = acceleration(
            velocity, spin=state[6] * self.spin, ball=self.ball, aerodynamics=self.aerodynamics, density=self.density
        )
        worn = -self.aerodynamics.spin_decay_rate * math.sqrt(float(velocity @ velocity)) * state[6]
        return np.concatenate([state[3:6], push, [worn]])

    def response_rate(self, state: Array, sheltered: bool) -> float:
        """Return the rate at which the air changes the velocity, 1/s.

        That is what it pushes with, over the speed through it; and how fast a ball let go at rest would come near its
        terminal speed V, g / V, for light balls that are slow only now.
        """
        velocity = self.through_air(state, sheltered)
        if float(velocity @ velocity) < SLOWEST**2:
            velocity = np.array([0.0, 0.0, SLOWEST])
        drag, lift = drag_and_lift(
            velocity, spin=state[6] * self.spin, ball=self.ball, aerodynamics=self.aerodynamics, density=self.density
        )
        square = float(velocity @ velocity)
        braking = math.sqrt(float(drag @ drag))
        return (braking + math.sqrt(float(lift @ lift))) / math.sqrt(square) + math.sqrt(
            STANDARD_GRAVITY * braking / square
        )

    def stepped(self, state: Array, step: float, sheltered: bool) -> Array:
        """Return the state one step later, by the classical method of Runge and Kutta."""
        first = self.rates(state, sheltered)
        second = self.rates(state + step / 2 * first, sheltered)
        third = self.rates(state + step / 2 * second, sheltered)
        fourth = self.rates(state + step * third, sheltered)
        return state + step / 6 * (first + 2 * second + 2 * third + fourth)

    def advanced(self, step: float) -> bool:
        """Take one step, or the part of it up to the ground or the edge of the wind; return whether the ball landed."""
        state, edge = self.states[-1], self.wind.calm_below
        height, climb = float(state[2]), float(state[5])
        if height <= 0 and climb <= 0:
            return True
        sheltered = height < edge or (height == edge and climb < 0)
        step /= max(1.0, SLOW * self.response_rate(state, sheltered))
        after = self.stepped(state, step, sheltered)
        part = first_crossing(*_heights(state, after, step, edge)) if edge > 0 else -1.0
        if part >= 0:
            step *= part
            after = self.stepped(state, step, sheltered)
            after[2] = edge
        cubic = _heights(state, after, step, 0.0)
        if climb > 0 > after[5]:
            turn = turn_on_cubic(*cubic)
            self.apex = max(self.apex, (on_cubic(turn, *cubic), self.times[-1] + turn * step))
        part = first_crossing(*cubic)
        if part >= 0:
            step *= part
            after = self.stepped(state, step, sheltered)
            after[2] = 0.0
        self.times.append(self.times[-1] + step)
        self.states.append(after)
        return part >= 0


def _heights(before: Array, after: Array, step: float, ground: float) -> tuple[float, float, float, float]:
    """Return the inputs to the cubic of the height above ground: heights and climbs per step, before and after."""
    return float(before[2]) - ground, float(after[2]) - ground, step * float(before[5]), step * float(after[5])
