"""A pitch let go by hand and flown to the plate through the air."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from pydantic import model_validator

from sweetspot.equipment.ball import Ball
from sweetspot.equipment.base import Fraction, NonNegative, Positive, Validated
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import CALM, Air, Wind
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.pitch.home_plate import MIDDLE, PLATE, RUBBER
from sweetspot.flight.pitch.spin import pitch_spin
from sweetspot.flight.pitch.tracked import approach_angles
from sweetspot.flight.trajectory import Flight, FlightOutcome, fly
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing_path import Side
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.plausibility import check_possible
from sweetspot.units import FOOT, MPH

STEP = 0.01
"""s; the plate is a root on the flight's steps, so they are shorter than a batted ball's."""
ROUNDS, CLOSE = 12, 1e-6
"""Most corrections of the aim, and m by which it may miss."""
HIGHER = 0.1
"""rad, by which a throw that falls short is raised before its aim is corrected."""
LARGEST_CORRECTION = 0.5
"""rad; a greater one means that no higher throw helps."""


class Delivery(Validated):
    """A pitch as it leaves the hand.

    Parameters
    ----------
    name : what people call it.
    speed : m/s, > 0, at most 70.
    launch_angle : rad above the level.
    turn : rad, from the line to the plate, positive to the right as the catcher sees it.
    spin_rate : rad/s, of the whole spin.
    spin_axis : rad, as Statcast gives it; see `pitch_spin`.
    efficiency : active part of the spin, 0 to 1.
    throws : "right" or "left", the pitcher's hand.
    side, height : m, right of the middle as the catcher sees it, and above the ground.
    extension : m, how far in front of the rubber the ball is let go.
    distance : m from the rubber to the plate's tip; 60.5 ft in the major leagues.
    """

    name: str = "pitch"
    speed: Positive
    launch_angle: float = 0.0
    turn: float = 0.0
    spin_rate: NonNegative = 0.0
    spin_axis: float = math.pi
    efficiency: Fraction = 1.0
    throws: Side = "right"
    side: float = 0.0
    height: Positive = 5.9 * FOOT
    extension: float = 6.2 * FOOT
    distance: Positive = RUBBER

    @model_validator(mode="after")
    def _is_a_pitch(self) -> Delivery:
        check_possible(self.speed, "speed", "pitch_speed")
        way = self.distance - PLATE
        if not 0 <= self.extension < way:
            raise ValueError(
                f"extension is {self.extension:.4g} m; allowed is 0 to less than {way:.4g} m, the way to the plate"
            )
        if max(abs(self.launch_angle), abs(self.turn)) >= math.pi / 2:
            raise ValueError("launch angle and turn must be less than 90 deg; the ball goes towards the plate")
        return self

    @property
    def motion(self) -> BallMotion:
        """The ball as it leaves the hand, in the frame of the field."""
        level, up = math.cos(self.launch_angle), math.sin(self.launch_angle)
        ahead = np.array([level * math.sin(self.turn), -level * math.cos(self.turn), up])
        return BallMotion(
            position=np.array([self.side, self.distance - self.extension, self.height]),
            velocity=self.speed * ahead,
            spin=pitch_spin(
                self.spin_rate, axis=self.spin_axis, direction=ahead, efficiency=self.efficiency, throws=self.throws
            ),
        )


@dataclass(frozen=True)
class PitchFlight:
    """A pitch on its way.

    Parameters
    ----------
    delivery : as it left the hand.
    plate : the ball over the front edge of the plate.
    time : s from hand to plate.
    flight : the whole path, as if there were no catcher.
    """

    delivery: Delivery
    plate: BallMotion
    time: float
    flight: Flight

    @property
    def speed_ratio(self) -> float:
        """Speed at the plate over speed at release."""
        return self.plate.speed / self.delivery.speed

    @property
    def vertical_approach_angle(self) -> float:
        """Direction at the plate in rad above the level; negative: down."""
        return float(approach_angles(self.plate.velocity)[0])


def thrown(delivery: Delivery, *, ball: Ball, aerodynamics: Aerodynamics, air: Air, wind: Wind = CALM) -> PitchFlight:
    """Return the pitch flown to the front edge of the plate with drag, lift and tiring spin.

    Raises
    ------
    InputError
        for a pitch too slow, or aimed so, that it comes down or turns back before the plate.
    """
    flight = fly(delivery.motion, FlightConditions(ball=ball, aerodynamics=aerodynamics, air=air, wind=wind), step=STEP)
    beyond = flight.positions[:, 1] <= PLATE
    if not beyond.any():
        raise InputError(_too_slow(delivery, flight))
    after = int(beyond.argmax())
    low, high = float(flight.times[after - 1]), float(flight.times[after])
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if flight.at(middle).position[1] > PLATE else (low, middle)
    return PitchFlight(delivery, flight.at(high), high, flight)


def _too_slow(delivery: Delivery, flight: Flight) -> str:
    ends = "comes down" if flight.outcome is FlightOutcome.LANDED else "is still in the air"
    return (
        f"a pitch of {delivery.speed:.4g} m/s ({delivery.speed / MPH:.4g} mph) let go at "
        f"{math.degrees(delivery.launch_angle):.4g} deg {ends} {flight.landing.position[1]:.3g} m in front of home "
        "plate and does not reach it; throw faster or higher"
    )


def aimed(
    delivery: Delivery,
    *,
    ball: Ball,
    aerodynamics: Aerodynamics,
    air: Air,
    wind: Wind = CALM,
    target: tuple[float, float] = MIDDLE,
) -> PitchFlight:
    """Return the pitch let go so that it passes the front edge of the plate at ``target`` (m right and up).

    Launch angle and turn of the delivery are found, the flatter of the two ways; the others stay.

    Raises
    ------
    InputError
        for a pitch too slow to be thrown there at any angle.
    """
    way = delivery.distance - delivery.extension - PLATE
    start = _lob(delivery.speed, way=way, rise=target[1] - delivery.height)
    aim = delivery.replaced(launch_angle=start, turn=math.atan2(target[0] - delivery.side, way))
    before = (start, 0.0)
    lift = way  # m of height at the plate per rad of launch angle; learnt on the way
    for _ in range(ROUNDS):
        try:
            pitch = thrown(aim, ball=ball, aerodynamics=aerodynamics, air=air, wind=wind)
        except InputError:  # air stops it short of where it would come without
            if aim.launch_angle != start or start + HIGHER >= math.pi / 4:
                raise
            start += HIGHER
            aim, before = aim.replaced(launch_angle=start), (start, 0.0)
            continue
        beside, below = target[0] - pitch.plate.position[0], target[1] - pitch.plate.position[2]
        if max(abs(beside), abs(below)) <= CLOSE:
            return pitch
        if aim.launch_angle != start:
            lift = (pitch.plate.position[2] - before[1]) / (aim.launch_angle - before[0])
        before = (aim.launch_angle, pitch.plate.position[2])
        if not (lift > 0 and abs(below / lift) < LARGEST_CORRECTION):
            break
        aim = aim.replaced(turn=aim.turn + math.atan2(beside, way), launch_angle=aim.launch_angle + below / lift)
    raise InputError(
        f"a pitch of {delivery.speed:.4g} m/s ({delivery.speed / MPH:.4g} mph) cannot be aimed at a place "
        f"{target[1]:.3g} m above the plate; throw faster"
    )


def _lob(speed: float, *, way: float, rise: float) -> float:
    """Return the flatter launch angle in rad of a throw without air; 45 deg where there is none."""
    pull = STANDARD_GRAVITY * way / speed**2
    square = 1 - pull * (pull + 2 * rise / way)
    return math.atan((1 - math.sqrt(square)) / pull) if square > 0 else math.pi / 4
