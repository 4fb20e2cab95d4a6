"""Ball and moving, vibrating bat coupled in time: the readable version.

The bat's undisturbed swing is taken out, so the bat starts at rest and the ball comes with the closing speed.
Between kicks by the contact force, ball and modes drift freely and exactly; each kick lies in the middle of its
step: a symplectic leapfrog of second order. Four corrections leave an error of about third order:

* The leapfrog follows a neighbour of the energy, H + h^2 (T V''/(6 mu) - V'^2/(24 mu)), mu the mass that ball and bat
  together show at the contact. Seen at the kicks, a push F that changes slowly moves the two apart by h^2 F / (12 mu)
  more than it should: steps make the contact look softer by that compliance, and it is counted as the surface's
  (to first order Takahashi and Imada's device [takahashi1984]; for quick modes see `give_of_steps`). So the peak,
  which decides how much the ball gives back, is right too.
* The ball springs back from the moment when the approach is greatest, not from the first kick that finds it smaller:
  a kick belongs to the way back as soon as the parabola through the last three kicks has its top before it.
* Where the ball turns, the force's second derivative jumps; what kicks then leave out is added to the next one
  (`impulse_of_the_turn`).
* The first kick comes after touch by the part of a step that makes the sum of kicks of a force u^n its integral
  (`first_kick_after_touch`).

Release is the root of the approach between kicks.

The instantaneous compliance under the ball (`Modes.compliance_at`) is a massless spring between ball and modes: the
approach w of ball and modes is shared between the ball's compression u and the surface, u + C F(u) = w. The potential
is then one of w alone, and all of the above holds with F(w).

After the ball has left, a vibrating or turning bat may catch up with it: the hit goes on until that cannot happen any
more. A ball that is hit again presses along its loading curve, as a new one, unless its law says otherwise.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from sweetspot.collision.contact_law import ContactLaw, damped_impulse, forgetting, loading_force, top_of
from sweetspot.collision.free_motion import Flow, Motion, Struck, moved, struck_place
from sweetspot.collision.impact import CONTACT_FORCE, EnergyLedger, Impact, Outcome, bat_energy
from sweetspot.collision.time_step import (
    contact_step,
    first_kick_after_touch,
    impulse_of_the_turn,
)
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import crossing, vertex
from sweetspot.plausibility import check_place

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
    step: float | None = None,
) -> Impact:
    """Return one collision of a ball with a bat given by its modes.

    m y'' = -F, q_i'' + c_i q_i' + omega_i^2 q_i = s_i(x) F, F = G(u) (1 + c u'), u + C(x) G(u) = y - sum_i s_i(x) q_i.

    Parameters
    ----------
    modes : every motion of the bat, free or gripped.
    position : m from the knob end.
    closing_speed : m/s, ball plus bat; at zero and below they do not meet, which is an outcome and no error.
    lateral : m across the face from the bat's line.
    step : s, > 0; the error falls with its cube. None: `STEP`, or less where a light face needs it (`contact_step`).

    Returns
    -------
    Impact
        efficiency, times, force and energy ledger; where the ball is touched twice, also the same hit by a ball that
        has not recovered in between (`unrecovered`).

    Raises
    ------
    InputError
        for a step that is not above zero, or a place that cannot be metres on a bat.

    >>> from sweetspot import all_modes, beam_model, catalog
    >>> from sweetspot.collision.coupled import hit
    >>> modes = all_modes(beam_model(catalog.bat("r161-ash")), catalog.ball())
    >>> impact = hit(modes, ball=catalog.ball(), position=0.7, closing_speed=70.0)
    >>> round(impact.collision_efficiency, 2), round(1e3 * impact.contact_time, 1)  # q, and ms of contact
    (0.2, 0.7)
    """
    step = contact_step(modes, ball, longest=STEP) if step is None else step
    check_step(step)
    check_place(position, "position")
    if not closing_speed > 0:
        return _no_contact(modes, position, closing_speed)
    place = (position, lateral, closing_speed)
    return collisions_of(modes, ball, place, step, _kicks)


def collisions_of(modes: Modes, ball: Ball, place: tuple[float, float, float], step: float, kicks: Kicks) -> Impact:
    """Return the collision by the ball's own law; where it is touched twice, with that of one that has not recovered.

    Parameters
    ----------
    place : position and lateral place, m, and closing speed, m/s, > 0.
    """
    impact = _collision(modes, ball, place, step, ContactLaw(ball), kicks)
    if impact.touches < 2:
        return impact
    return replace(impact, unrecovered=_collision(modes, ball, place, step, ContactLaw(ball, recovers=False), kicks))


def _collision(
    modes: Modes, ball: Ball, place: tuple[float, float, float], step: float, law: ContactLaw, kicks: Kicks
) -> Impact:
    """Return the collision at a place; see `collisions_of`."""
    position, lateral, closing_speed = place
    struck = struck_place(modes, position, lateral, closing_speed)
    first_kick = first_kick_after_touch(ball.exponent)
    ending = _integrated(modes, ball, struck, closing_speed, step, law, kicks)
    translation, rotation, bending, hoop, face = map(float, bat_energy(modes, ending.displacement, ending.velocity))
    separated = ending.outcome is Outcome.SEPARATED
    displacement, velocity = moved(modes, ending.displacement, ending.velocity, -ending.late)
    return Impact(
        outcome=ending.outcome,
        position=position,
        closing_speed=closing_speed,
        collision_efficiency=-ending.ball_speed / closing_speed if separated else math.nan,
        contact_time=_contact_time(ending.forces, first_kick) * step if separated else math.nan,
        release_time=ending.release,
        peak_force=ending.hardest,
        peak_compression=ending.peak,
        energy=EnergyLedger(
            incoming=ball.mass * closing_speed**2 / 2,
            ball=ball.mass * ending.ball_speed**2 / 2,
            heat=float(np.trapezoid([*ending.forces, 0.0], [*ending.path, 0.0])),
            translation=translation,
            rotation=rotation,
            bending=bending,
            hoop=hoop,
            damping=ending.damping,
            face=face,
        ),
        displacement=displacement,
        velocity=velocity,
        times=np.concatenate([[0.0], (np.arange(len(ending.forces) - 1) + first_kick) * step]),
        force=np.array(ending.forces),
        compression=np.array(ending.compressions),
        impulse=np.array(ending.impulses),
        approach=np.array(ending.path),
        lateral=lateral,
    )


@dataclass(frozen=True)
class _Contact:
    """End of the integration, ``late`` s after release, and its history kick by kick."""

    outcome: Outcome
    release: float
    late: float
    ball_speed: float
    displacement: Array
    velocity: Array
    peak: float
    hardest: float
    damping: float
    forces: list[float]
    path: list[float]
    compressions: list[float]
    impulses: list[float]


@dataclass
class Course:
    """State of a collision in progress.

    Parameters
    ----------
    approaches : at the kicks of this contact, m, with 0 at touch before them.
    compressions, forces, impulses : at all kicks, m, N and N s, with 0 at first touch before them.
    peak : the greatest approach of this contact, m.
    turned_at : the compression in m from which the ball springs back; None while it is pressed on.
    greatest, hardest : the greatest compression, m, and force, N, where the ball turned.
    missing : N s that the kicks have left out, for the next one.
    rate : of the approach amid the last kick of this contact, m/s; None before the first.
    """

    approaches: list[float] = field(default_factory=lambda: [0.0])
    compressions: list[float] = field(default_factory=lambda: [0.0])
    forces: list[float] = field(default_factory=lambda: [0.0])
    impulses: list[float] = field(default_factory=lambda: [0.0])
    peak: float = 0.0
    turned_at: float | None = None
    greatest: float = 0.0
    hardest: float = 0.0
    missing: float = 0.0
    rate: float | None = None


Kicks = Callable[["Course", "Motion", "Struck", "Flow", ContactLaw, int], tuple[float, "Motion"]]
"""kicks(course, motion, struck, flow, law, limit): see `_kicks`."""


def _integrated(
    modes: Modes, ball: Ball, struck: Struck, closing_speed: float, step: float, law: ContactLaw, kicks: Kicks
) -> _Contact:
    """Step ball and modes from first touch until the ball is gone for good, or to the time limit."""
    first_kick, limit = first_kick_after_touch(ball.exponent), round(TIME_LIMIT / step)
    struck = struck.in_steps(modes, ball, step)
    flow, course = Flow(modes, step, ball.mass), Course()
    motion = Motion(closing_speed * step * first_kick, closing_speed, np.zeros(2 * len(modes)))
    outcome, release, late, path = Outcome.STILL_IN_CONTACT, math.nan, 0.0, [0.0]
    while len(course.forces) <= limit:
        approach, motion = kicks(course, motion, struck, flow, law, limit)
        path.extend(course.approaches[1:])
        if approach > 0:
            break
        outcome, approaches = Outcome.SEPARATED, course.approaches
        before = approaches[-2] if len(approaches) > 1 else 0.0
        late = (1 - crossing(before, approaches[-1], approach)) * step
        release = (len(course.forces) - 1 + first_kick) * step - late
        again = flow.overtaken(motion, struck, kicks=limit - len(course.forces))
        if again is None:
            break
        distances, motion = again
        _touched_again(course, struck, law, distances, step)
        outcome, late = Outcome.STILL_IN_CONTACT, 0.0
        for history in (course.compressions, course.forces, course.impulses, path):
            history.extend([0.0] * len(distances))
        course.approaches, course.rate = [0.0], None
    displacement, velocity = motion.bat.reshape(2, -1)
    return _Contact(
        outcome=outcome,
        release=release,
        late=late,
        ball_speed=motion.ball_speed,
        displacement=displacement,
        velocity=velocity,
        peak=course.greatest or max(course.compressions),
        hardest=max(course.hardest, *course.forces),
        damping=motion.work - flow.energy(motion),
        forces=course.forces,
        path=path,
        compressions=course.compressions,
        impulses=course.impulses,
    )


def _touched_again(course: Course, struck: Struck, law: ContactLaw, distances: list[float], step: float) -> None:
    """Let the ball forget what it was pressed in, at these distances in m from the bat at every step."""
    left = 0.0
    if course.turned_at is not None:
        free = step * sum(forgetting(distance, course.greatest) for distance in distances)
        left = law.remembered(course.turned_at, course.greatest, free)
    course.turned_at = left or None
    course.peak = left + struck.compliance * loading_force(law.ball, left)


def _kicks(
    course: Course, motion: Motion, struck: Struck, flow: Flow, law: ContactLaw, limit: int
) -> tuple[float, Motion]:
    """Follow one contact: kick by kick until ball and bat are apart, or to so many kicks.

    Returns
    -------
    tuple
        the last approach in m, not above zero where they are apart, and the motion then.
    """
    step, approach = flow.step, math.inf
    approaches, forces = course.approaches, course.forces
    while len(forces) <= limit:
        place, speed = (struck.seen @ motion.bat).tolist()
        approach = motion.ball_position - place
        if approach <= 0:
            break
        rate = motion.ball_speed - speed
        if course.turned_at is None and _past_the_top(approaches, approach):
            shift, height, bend = _top(approaches, approach)
            course.peak = max(course.peak, approach, height)
            course.turned_at, force, before = struck.pressed(law, course.peak, None)
            after = law.force_and_slope(course.turned_at, course.turned_at)[1]
            stiffening = struck.softened(after) - struck.softened(before)
            course.missing = impulse_of_the_turn(shift, bend, stiffening, step)
            course.greatest, course.hardest = max(course.greatest, course.turned_at), max(course.hardest, force)
        elif approach >= course.peak:
            course.peak, course.turned_at = approach, None
        expected = 2 * forces[-1] - forces[-2] if len(forces) > 1 else 0.0
        compression, elastic, slope = struck.pressed(law, approach, course.turned_at, expected)
        damping, lightness = struck.damping(law.ball, slope), struck.lightness + 1 / flow.ball_mass
        former = rate if course.rate is None else course.rate
        impulse, course.rate = damped_impulse(elastic * step, damping, rate, lightness, former, struck.by_steps, step)
        force = impulse / step
        if course.turned_at is None and len(forces) > 1 and forces[-2] <= forces[-1] > force:
            course.hardest = max(course.hardest, top_of(forces[-2], forces[-1], force))
        impulse, course.missing = impulse + course.missing, 0.0
        approaches.append(approach)
        course.compressions.append(compression)
        forces.append(force)
        course.impulses.append(impulse)
        motion = flow.drifted(motion.kicked(struck, impulse, flow.ball_mass, speed=speed))
    return approach, motion


def check_step(step: float) -> None:
    """Refuse a time step that is not a number above zero."""
    if not (math.isfinite(step) and step > 0):
        raise InputError(f"step is {step:g} s; allowed is a number above zero, for example 4e-6")


def _past_the_top(approaches: list[float], latest: float) -> bool:
    """Return whether the parabola through the last three kicks goes down at the latest one."""
    return latest < approaches[-1] or (len(approaches) > 2 and 3 * latest - 4 * approaches[-1] + approaches[-2] < 0)


def _top(approaches: list[float], latest: float) -> tuple[float, float, float]:
    """Return the top of the parabola through the last three kicks: its place in steps after the last but one, height.

    Last comes the second difference.
    """
    if len(approaches) < 3:
        return 0.5, approaches[-1], 0.0
    first, middle = approaches[-2:]
    return *vertex(first, middle, latest), first - 2 * middle + latest


def _contact_time(forces: list[float], first_kick: float) -> float:
    """Return when the force falls below `CONTACT_FORCE` of its peak for the last time, in steps after touch."""
    force = np.array([*forces, 0.0])
    last = int(np.flatnonzero(force >= CONTACT_FORCE * force.max())[-1])
    threshold = CONTACT_FORCE * force[: last + 2].max()
    part = (force[last] - threshold) / (force[last] - force[last + 1])
    return float(last - 1 + first_kick + part)


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
        times=nothing,
        force=nothing,
        compression=nothing,
        impulse=nothing,
        approach=nothing,
    )
