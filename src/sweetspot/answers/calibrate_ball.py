"""One ball as it is, from a drop, shots at a wall, a scale and a press: its file, with the error of each value."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.analysis.drop_test import ROOM_AIR, terminal_speed
from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.posterior import CONTRADICTION
from sweetspot.catalog.balls import ball, slope_doubt
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.numerics.interval import REACH
from sweetspot.units.dimensions import FORCE, MASS, RATIO, SLOPE_PER_SPEED, SPEED

ANY_LEVEL = 0.2
"""Standard deviation of the restitution of a ball of which nothing was measured yet [our choice]."""


@dataclass(frozen=True)
class Bounce:
    """What a ball returned of a speed, m/s, with which it met a rigid wall or floor."""

    speed: float
    restitution: Measured


@dataclass(frozen=True)
class CalibrateBallQuestion:
    """A ball that is nearly one of the catalogue, and what was measured on it.

    Parameters
    ----------
    like : its name in the catalogue, or its file.
    bounces : off walls and floors that are rigid beside it.
    mass, compression : kg, and N that bring two plates a quarter inch nearer; None: not measured.
    humidity, temperature : of the ball when it bounced, 0 to 1 and degC; None: those at which its law holds.
    name : what people call it.
    """

    like: str
    bounces: Sequence[Bounce] = ()
    mass: Measured | None = None
    compression: Measured | None = None
    humidity: float | None = None
    temperature: float | None = None
    name: str = "my ball"


@dataclass(frozen=True)
class FittedBounce:
    """A bounce beside what the fitted law returns there, and by how many of its own errors it lies off."""

    speed: Annotated[float, SPEED]
    measured: Annotated[Measured, RATIO]
    fitted: Annotated[float, RATIO]
    off_by_sigma: float


@dataclass(frozen=True, kw_only=True)
class CalibrateBallAnswer(Answer):
    """A ball fitted to what was measured on it.

    Parameters
    ----------
    reference_speed : at which restitution and its slope are independent of each other.
    restitution : there, at the humidity and temperature at which the law of the ball that it is like holds.
    restitution_before : the same of that ball, before anything was measured.
    slope, slope_before : loss of restitution with speed, s/m.
    contradictory : whether the measurements lie farther from the law than their errors and its slope allow.
    """

    question: Annotated[CalibrateBallQuestion, INTERNAL]
    like: Annotated[Ball, INTERNAL]
    reference_speed: Annotated[float, SPEED]
    restitution: Annotated[Measured, RATIO]
    restitution_before: Annotated[Measured, RATIO]
    slope: Annotated[Measured, SLOPE_PER_SPEED]
    slope_before: Annotated[Measured, SLOPE_PER_SPEED]
    mass: Annotated[Measured | None, MASS]
    compression: Annotated[Measured | None, FORCE]
    bounces: tuple[FittedBounce, ...]
    contradictory: bool

    def to_toml(self) -> str:
        """Return the ball as a file, like the one that it started from, with half of the 90 % interval behind ±."""
        import tomli_w

        values: dict[str, object] = {"like": self.question.like, "name": self.question.name}
        if self.bounces:
            values |= {
                "cor_reference": _with_half(self.restitution, "", 5),
                "cor_reference_speed": f"{self.reference_speed:.8g} m/s",
                "cor_anchor_speed": f"{self.reference_speed:.8g} m/s",
                "cor_slope": _with_half(self.slope, " s/m", 6),
                "cor_scatter": 0.0,
            }
        if self.mass is not None:
            values["mass"] = _with_half(self.mass, " kg", 6)
        if self.compression is not None:
            values["compression"] = _with_half(self.compression, " N", 5)
        return tomli_w.dumps(values)


def _with_half(value: Measured, unit: str, digits: int) -> str:
    return f"{value.value:.{digits}g}{unit} ± {value.half_width:.2g}{unit}"


def drop_bounce(like: Ball, *, height: float, rebound: Measured) -> Bounce:
    """Return the bounce of a ball dropped on a hard floor, from the heights of its lowest point, m, in a room's air.

    v^2 = v_t^2 (1 - exp(-2 g H / v_t^2)) on the way down, and v'^2 = v_t^2 (exp(2 g h / v_t^2) - 1) on the way up; see
    `sweetspot.analysis.drop_test`.

    >>> tennis = ball("tennis")
    >>> bounce = drop_bounce(tennis, height=2.54, rebound=Measured(1.41, 0.01))
    >>> round(bounce.speed, 2), round(bounce.restitution.value, 3)
    (6.9, 0.772)
    """
    if not 0 < rebound.value < height:
        raise InputError(
            f"a ball dropped from {height:.4g} m was said to come back to {rebound.value:.4g} m; allowed is more "
            "than 0 and less than it fell"
        )
    square = terminal_speed(like, air_density=ROOM_AIR) ** 2
    down, up = (2 * STANDARD_GRAVITY * each / square for each in (height, rebound.value))
    speed, back = math.sqrt(-math.expm1(-down) * square), math.sqrt(math.expm1(up) * square)
    steep = STANDARD_GRAVITY * math.exp(up) / back  # of the rebound's speed with its height
    return Bounce(speed, Measured(back / speed, steep * rebound.error / speed))


def calibrate_ball_answer(question: CalibrateBallQuestion) -> CalibrateBallAnswer:
    """Return a ball fitted to its measurements.

    How much it returns is taken as not known at all before, for it may be old, wet or another make's; how that falls
    with speed is taken from the ball that it is like, within what is not known of that. Bounces are linear in both.
    What remains of the two is written at the speed where they are independent.

    Raises
    ------
    InputError
        without a measurement, for a bounce that no ball has, or a compression where none of the parent's is known.
    """
    like = ball(question.like)
    if not question.bounces and question.mass is None and question.compression is None:
        raise InputError("nothing was measured; give a drop, a restitution, the weight or the compression of the ball")
    for bounce in question.bounces:
        if not 0 < bounce.restitution.value < 1:
            raise InputError(f"a restitution was given as {bounce.restitution.value:.4g}; allowed is 0 to 1")
    prior, covariance = _prior(like, ANY_LEVEL)
    places = np.array([bounce.speed for bounce in question.bounces])
    moved = like.conditioned(humidity=question.humidity, temperature=question.temperature)
    warmer = moved.restitution.reference - like.restitution.reference
    values = np.array([bounce.restitution.value - warmer for bounce in question.bounces])
    errors = np.array([bounce.restitution.error for bounce in question.bounces])
    rows = np.column_stack([np.ones_like(places), like.restitution.reference_speed - places])
    together = rows @ covariance @ rows.T + np.diag(errors**2)
    gain = np.linalg.solve(together, rows @ covariance).T if len(places) else np.zeros((2, 0))
    off = values - rows @ prior
    after, spread = prior + gain @ off, covariance - gain @ rows @ covariance
    speed = like.restitution.reference_speed
    if spread[1, 1] > 0:  # where level and slope are independent; both lines are told there
        speed = max(speed + float(spread[0, 1] / spread[1, 1]), 0.1)
    level = 0.0 if like.spread is None else math.hypot(like.spread.scatter, like.spread.restitution) / REACH
    squares = float(off @ np.linalg.solve(together, off)) if len(places) else 0.0
    return CalibrateBallAnswer(
        question=question,
        like=like,
        reference_speed=speed,
        restitution=_at(speed, like, after, spread),
        restitution_before=_at(speed, like, *_prior(like, level)),
        slope=Measured(float(max(after[1], 0.0)), math.sqrt(max(spread[1, 1], 0.0))),
        slope_before=Measured(float(prior[1]), math.sqrt(covariance[1, 1])),
        mass=question.mass,
        compression=question.compression,
        bounces=tuple(
            FittedBounce(
                speed=bounce.speed,
                measured=bounce.restitution,
                fitted=float(row @ after) + warmer,
                off_by_sigma=float((value - row @ after) / bounce.restitution.error),
            )
            for bounce, row, value in zip(question.bounces, rows, values, strict=True)
        ),
        contradictory=squares > len(places) + CONTRADICTION * math.sqrt(2 * max(len(places), 1)),
    )


def _prior(like: Ball, level: float) -> tuple[Array, Array]:
    """Return level and slope of a ball's law at its reference speed, and their covariance; ``level``: its error."""
    law = like.restitution
    slope, anchor = slope_doubt(like)
    arm = anchor - law.reference_speed
    covariance = np.array([[level**2 + (slope * arm) ** 2, slope**2 * arm], [slope**2 * arm, slope**2]])
    return np.array([law.reference, law.slope]), covariance


def _at(speed: float, like: Ball, law: Array, covariance: Array) -> Measured:
    row = np.array([1.0, like.restitution.reference_speed - speed])
    return Measured(float(row @ law), math.sqrt(max(float(row @ covariance @ row), 0.0)))
