"""Ball and moving, vibrating bat coupled in time: the readable version.

The bat's undisturbed swing is taken out, so the bat starts at rest and the ball comes with the closing speed.
Between kicks by the contact force, ball and modes drift freely and exactly; each kick lies in the middle of its
step: a symplectic leapfrog of second order. Two corrections follow from its modified energy
H + h^2 (T V''/(6 mu) - V'^2/(24 mu)), mu the mass that ball and bat together show at the contact:

* the kick takes the force F (1 - h^2 F' / (12 mu)), which makes a contact that starts and ends at F = 0 effectively of
  fourth order (Takahashi and Imada's device [takahashi1984]);
* the peak compression, which decides how much the ball gives back, is lowered by h^2 F / (12 mu).

The kink of the force at its peak leaves about third order. Release is the root of the compression between kicks.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sweetspot.collision.contact_law import ContactLaw, Hysteretic
from sweetspot.collision.impact import CONTACT_FORCE, EnergyLedger, Impact, Outcome, bat_energy
from sweetspot.collision.modal_propagator import dashed, dashpot_factors, modal_propagator_of
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.parabola import vertex
from sweetspot.units import check_place

STEP = 4e-6
"""s; exit speeds are then well within 1e-4 of the converged ones (the docs have the curve)."""
TIME_LIMIT = 20e-3
"""s; a ball that touches a bat at 0.1 m/s is free again after about 5 ms."""


def hit(
    modes: Modes,
    *,
    ball: Ball,
    position: float,
    closing_speed: float,
    lateral: float = 0.0,
    step: float = STEP,
    law: ContactLaw | None = None,
) -> Impact:
    """Return one collision of a ball with a bat given by its modes.

    m y'' = -F(u), q_i'' + c_i q_i' + omega_i^2 q_i = s_i(x) F(u), u = y - sum_i s_i(x) q_i.

    Parameters
    ----------
    modes : every motion of the bat, free or gripped.
    ball : mass and, unless ``law`` is given, force law.
    position : m from the knob end.
    closing_speed : m/s; not above zero is no contact, an outcome and not an error.
    lateral : m across the face from the bat's line.
    step : s, > 0; the error falls with its square.
    law : another contact law than the ball's own `Hysteretic` one.

    Raises
    ------
    InputError
        for a step that is not above zero, or a place that is none in metres.
    """
    check_step(step)
    check_place(position, "position")
    if not closing_speed > 0:
        return _no_contact(modes, position, closing_speed)
    done = _integrated(modes, ball, modes.shape_at(position, lateral), closing_speed, step, law or Hysteretic(ball))
    translation, rotation, bending, hoop, face = map(float, bat_energy(modes, done.displacement, done.velocity))
    separated = done.outcome is Outcome.SEPARATED
    return Impact(
        outcome=done.outcome,
        position=position,
        closing_speed=closing_speed,
        collision_efficiency=-done.ball_speed / closing_speed if separated else math.nan,
        contact_time=_contact_time(done.forces, step) if separated else math.nan,
        release_time=done.release,
        peak_force=max(done.forces),
        peak_compression=done.peak,
        energy=EnergyLedger(
            incoming=ball.mass * closing_speed**2 / 2,
            ball=ball.mass * done.ball_speed**2 / 2,
            heat=float(np.trapezoid([*done.forces, 0.0], [*done.compressions, 0.0])),
            translation=translation,
            rotation=rotation,
            bending=bending,
            hoop=hoop,
            damping=done.damping,
            face=face,
        ),
        displacement=done.displacement,
        velocity=done.velocity,
        times=np.concatenate([[0.0], (np.arange(len(done.forces) - 1) + 0.5) * step]),
        force=np.array(done.forces),
        compression=np.array(done.compressions),
        impulse=np.array(done.impulses),
        lateral=lateral,
    )


@dataclass(frozen=True)
class _Contact:
    """How the integration ended, and its history kick by kick."""

    outcome: Outcome
    release: float
    ball_speed: float
    displacement: Array
    velocity: Array
    peak: float
    damping: float
    forces: list[float]
    compressions: list[float]
    impulses: list[float]


def _integrated(modes: Modes, ball: Ball, shape: Array, closing_speed: float, step: float, law: ContactLaw) -> _Contact:
    """Step ball and modes from first touch to release, or to the time limit."""
    drift, half_dash = modal_propagator_of(modes, step), dashpot_factors(modes, step / 2)
    correction = step**2 / 12 * (1 / ball.mass + float(shape @ shape))
    stiffness = modes.angular_frequency**2

    ball_position, ball_speed = closing_speed * step / 2, closing_speed
    displacement, velocity = np.zeros(len(modes)), np.zeros(len(modes))
    peak, damping = 0.0, 0.0
    turned_at: float | None = None
    compressions, forces, impulses = [0.0], [0.0], [0.0]
    outcome, release = Outcome.STILL_IN_CONTACT, math.nan
    for kick in range(round(TIME_LIMIT / step)):
        compression = ball_position - float(shape @ displacement)
        if compression <= 0:
            outcome = Outcome.SEPARATED
            release = (kick - 0.5) * step
            release += step * _crossing(compressions, compression)
            break
        rate = ball_speed - float(shape @ velocity)
        if compression >= peak:
            peak, turned_at = compression, None
        elif turned_at is None:
            peak = max(peak, _vertex(compressions, compression))
            peak -= correction * law.force(peak, 0.0, None)
            turned_at = peak
        force = law.force(compression, rate, turned_at)
        impulse = force * (1 - correction * law.slope(compression, rate, turned_at)) * step
        compressions.append(compression)
        forces.append(force)
        impulses.append(impulse)

        ball_speed -= impulse / ball.mass
        velocity = velocity + shape * impulse
        before = _energy(stiffness, displacement, velocity)
        velocity = dashed(modes, half_dash, velocity)
        ball_position += ball_speed * step
        displacement, velocity = (
            drift[:, 0, 0] * displacement + drift[:, 0, 1] * velocity,
            drift[:, 1, 0] * displacement + drift[:, 1, 1] * velocity,
        )
        velocity = dashed(modes, half_dash, velocity)
        damping += before - _energy(stiffness, displacement, velocity)

    return _Contact(
        outcome, release, ball_speed, displacement, velocity, peak, damping, forces, compressions, impulses
    )  # fmt: skip


def check_step(step: float) -> None:
    """Refuse a time step that is not a number above zero."""
    if not (math.isfinite(step) and step > 0):
        raise InputError(f"step is {step:g} s; allowed is a number above zero, for example 4e-6")


def _energy(stiffness: Array, displacement: Array, velocity: Array) -> float:
    return float(velocity @ velocity + displacement @ (stiffness * displacement)) / 2


def _vertex(compressions: list[float], latest: float) -> float:
    """Return the top of the parabola through the last three compressions, the middle one being the highest."""
    if len(compressions) < 3:
        return compressions[-1]
    first, middle = compressions[-2:]
    return vertex(first, middle, latest)[1]


def _contact_time(forces: list[float], step: float) -> float:
    """Return when the force falls below `CONTACT_FORCE` of its peak for the last time, s."""
    force = np.array([*forces, 0.0])
    last = int(np.flatnonzero(force >= CONTACT_FORCE * force.max())[-1])
    threshold = CONTACT_FORCE * force[: last + 2].max()
    part = (force[last] - threshold) / (force[last] - force[last + 1])
    return float((last - 0.5 + part) * step)


def _crossing(compressions: list[float], latest: float) -> float:
    """Return where the parabola through the last three kicks crosses zero, in steps after the last but one."""
    start = compressions[-1]
    if len(compressions) < 3:
        return start / (start - latest)
    earlier = compressions[-2]
    slope, bend = (latest - earlier) / 2, (earlier - 2 * start + latest) / 2
    return 2 * start / (math.sqrt(slope**2 - 4 * bend * start) - slope)


def _no_contact(modes: Modes, position: float, closing_speed: float) -> Impact:
    nothing, still = np.zeros(0), np.zeros(len(modes))
    ledger = EnergyLedger(*([0.0] * 8))
    nan = math.nan
    return Impact(
        Outcome.NO_CONTACT,
        position,
        closing_speed,
        nan,
        nan,
        nan,
        nan,
        nan,
        ledger,
        still,
        still,
        nothing,
        nothing,
        nothing,
        nothing,
    )
