"""Sweeps: one hit with one or two of its numbers varied, an answer in every cell."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from itertools import product
from typing import Literal, get_args

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import STANDARD_PRESSURE, Air, Wind
from sweetspot.flight.batted_spin import TRACKED, SpinLine, batted_ball_spin, check_usual_spin
from sweetspot.flight.bearing import launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, batted_ball
from sweetspot.numerics.arrays import Array

Variation = Literal[
    "exit_speed", "launch_angle", "spray", "bearing", "backspin", "sidespin", "gyrospin", "height", "temperature",
    "humidity", "pressure", "elevation", "wind_speed", "wind_direction",
]  # fmt: skip
VARIATIONS: tuple[Variation, ...] = get_args(Variation)
"""What may be varied, in the order in which a table puts it down its side rather than across."""
Varied = tuple[Variation, tuple[float, ...]]
"""A varied quantity, and its values in SI."""


@dataclass(frozen=True)
class BattedBall:
    """A hit and the weather it flies in, as plain numbers, so that any of them can be varied.

    Parameters
    ----------
    exit_speed : m/s, >= 0.
    launch_angle, spray : rad, elevation, and direction from centre field, positive to right field.
    bearing : rad, direction of the place where the ball comes down, in the place of ``spray``, which then has to be
        solved for: see `directed`; None: the spray counts.
    backspin, sidespin : rad/s; None: what such hits usually have, see `batted_ball_spin`.
    gyrospin : rad/s.
    height, forward : m above the ground and in front of the plate's tip where the ball leaves the bat.
    bats : side the batter bats from; only the usual spin asks for it.
    temperature, humidity, pressure, elevation : of the `Air`.
    wind_speed, wind_direction, wind_exponent, calm_below : of the `Wind`.
    line : of the usual spin.
    """

    exit_speed: float
    launch_angle: float
    spray: float = 0.0
    bearing: float | None = None
    backspin: float | None = None
    sidespin: float | None = None
    gyrospin: float = 0.0
    height: float = USUAL_CONTACT[2]
    forward: float = USUAL_CONTACT[1]
    bats: Literal["right", "left"] = "right"
    temperature: float = 21.0
    humidity: float = 0.5
    pressure: float = STANDARD_PRESSURE
    elevation: float = 0.0
    wind_speed: float = 0.0
    wind_direction: float = 0.0
    wind_exponent: float = 0.0
    calm_below: float = 0.0
    line: SpinLine = TRACKED

    @property
    def motion(self) -> BallMotion:
        """The ball as it leaves the bat; raises `InputError` for a negative speed, or a spray not yet solved for."""
        if self.bearing is not None:
            raise InputError("only the bearing of this hit is known; `directed` solves for its launch direction")
        if not self.exit_speed >= 0:
            raise InputError(f"exit speed is {self.exit_speed:g} m/s; allowed is zero or more")
        check_usual_spin(self.launch_angle, self.spray, given=self.backspin is not None and self.sidespin is not None)
        usual = batted_ball_spin(self.launch_angle, self.spray, bats=self.bats, line=self.line)
        return batted_ball(
            speed=self.exit_speed,
            launch_angle=self.launch_angle,
            spray=self.spray,
            backspin=float(usual[0]) if self.backspin is None else self.backspin,
            sidespin=float(usual[1]) if self.sidespin is None else self.sidespin,
            gyrospin=self.gyrospin,
            position=(0.0, self.forward, self.height),
        )

    @property
    def air(self) -> Air:
        """The air; raises `InputError` where there is none like it."""
        return Air(
            temperature=self.temperature, humidity=self.humidity, pressure=self.pressure, elevation=self.elevation
        )

    @property
    def wind(self) -> Wind:
        """The wind; raises `InputError` where there is none like it."""
        return Wind(
            speed=self.wind_speed,
            direction=self.wind_direction,
            exponent=self.wind_exponent,
            calm_below=self.calm_below,
        )


def directed(hit: BattedBall, *, ball: Ball, aerodynamics: Aerodynamics) -> BattedBall:
    """Return a hit with the spray that brings it down at its bearing; one without a bearing as it is.

    Raises
    ------
    InputError
        where no launch direction brings it there.
    """
    if hit.bearing is None:
        return hit
    spray, _ = launched_to(
        hit.bearing,
        exit_speed=hit.exit_speed,
        launch_angle=hit.launch_angle,
        bats=hit.bats,
        conditions=FlightConditions(ball=ball, aerodynamics=aerodynamics, air=hit.air, wind=hit.wind),
        spins=hit.line if hit.backspin is hit.sidespin is None else (hit.backspin, hit.sidespin),
        position=(0.0, hit.forward, hit.height),
    )
    if not math.isfinite(spray[0]):
        raise InputError(
            f"no launch direction brings this ball down {math.degrees(hit.bearing):.4g} deg from centre field; give "
            "the spray, the direction in which it leaves the bat, instead of the bearing"
        )
    return replace(hit, spray=float(spray[0]), bearing=None)


@dataclass(frozen=True)
class FlightTable:
    """A hit with one or two of its numbers varied.

    ``hit``: what is not varied. ``rows``, ``columns``: what is varied and its values; without ``columns`` the table has
    one column. ``flights``: every flight, row after row.
    """

    hit: BattedBall
    rows: Varied
    columns: Varied | None
    flights: Flights

    def values(self, answer: Array) -> Array:
        """Return an answer of the flights, shape (rows times columns,), as rows and columns."""
        return np.asarray(answer).reshape(len(self.rows[1]), -1)


def flight_table(
    hit: BattedBall,
    *,
    rows: Varied,
    columns: Varied | None = None,
    ball: Ball,
    aerodynamics: Aerodynamics,
) -> FlightTable:
    """Return a hit with one or two of its numbers varied.

    ``rows``, ``columns``: a field of `BattedBall` and its values in SI, at least one.

    Raises
    ------
    InputError
        for a start below the ground, or numbers that no hit or air can have, in any cell.
    """
    for name, values in (rows, *([columns] if columns else [])):
        if name not in VARIATIONS or not values:
            raise InputError(f"{name} with {len(values)} values cannot be varied; allowed is {', '.join(VARIATIONS)}")
    parts = []
    for cell in cells_of(rows, columns):
        batted = directed(replace(hit, **dict(cell)), ball=ball, aerodynamics=aerodynamics)  # type: ignore[arg-type]
        motion = batted.motion
        if motion.position[2] < 0:
            raise InputError(f"height is {batted.height:g} m, below the ground; allowed is 0 m or more")
        parts.append(
            flights(motion, FlightConditions(ball=ball, aerodynamics=aerodynamics, air=batted.air, wind=batted.wind))
        )
    names = [field.name for field in fields(Flights)]
    return FlightTable(
        hit, rows, columns, Flights(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))
    )


def cells_of(rows: Varied, columns: Varied | None) -> list[tuple[tuple[Variation, float], ...]]:
    """Return the varied inputs of each cell, row after row.

    >>> cells_of(("spray", (0.0, 0.1)), ("height", (1.0,)))
    [(('spray', 0.0), ('height', 1.0)), (('spray', 0.1), ('height', 1.0))]
    """
    sides = [rows] if columns is None else [rows, columns]
    return list(product(*([(name, value) for value in values] for name, values in sides)))
