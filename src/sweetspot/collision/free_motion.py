"""Ball and bat between two kicks of the contact force: the place that is struck, and how both move on freely.

`coupled` kicks them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sweetspot.collision.contact_law import ContactLaw, pressed_in_series
from sweetspot.collision.time_step import give_of_steps, with_quick_modes_as_springs
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.arrays import Array


def modal_propagator_of(modes: Modes, step: float) -> Array:
    """Return the matrices that take (q, q') of each mode over ``step`` seconds, shape (n, 2, 2)."""
    return free_steps(modes.angular_frequency, modes.damping_rate, step)


def free_steps(angular_frequency: Array, damping_rate: Array, step: float | Array) -> Array:
    """Return the matrices that take (q, q') of oscillators over ``step`` seconds, shape (..., 2, 2).

    Solves q'' + 2 g q' + omega^2 q = 0 exactly, below, at and above critical damping; rigid motions drift.

    Parameters
    ----------
    angular_frequency, damping_rate : omega in rad/s and 2 g in 1/s, shape (...).
    """
    parts = _free_parts(angular_frequency, damping_rate, step)
    return np.stack([np.stack(row, axis=-1) for row in parts], axis=-2)


def _free_parts(
    angular_frequency: Array, damping_rate: Array, step: float | Array
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Return the four numbers of those matrices, each of shape (...), row by row."""
    rate = damping_rate / 2
    square = angular_frequency**2 - rate**2
    root = np.sqrt(square if np.all(square >= 0) else square.astype(complex))  # real sines take a third of the time
    turned = root * step
    cosine = np.cos(turned).real
    small = np.abs(turned) < 1e-8
    sine = np.where(small, step, (np.sin(turned) / np.where(small, 1, root)).real)
    decay = np.exp(-rate * step)
    whole, slowed, part = decay * cosine, decay * sine, rate * decay * sine
    return (whole + part, slowed), (-(angular_frequency**2) * slowed, whole - part)


def dashpot_factors(modes: Modes, step: float) -> Array:
    """Return f_k of q' <- q' - f_k d_k (d_k . q'), what each dashpot alone does exactly in ``step`` s, shape (k,).

    exp(-d d^T h) = 1 - d (1 - exp(-|d|^2 h)) / |d|^2 d^T; the rows are orthogonal, so they act independently.
    """
    squares = np.sum(modes.dashpots**2, axis=1)
    return np.asarray(
        np.divide(-np.expm1(-squares * step), squares, out=np.full_like(squares, step), where=squares > 0)
    )


def moved(modes: Modes, displacement: Array, velocity: Array, time: Array | float) -> tuple[Array, Array]:
    """Return modal displacements and velocities of free bats, ``time`` s later or, below zero, earlier.

    Dashpots act for half the time before the free motion and half after it, as between two kicks.

    Parameters
    ----------
    displacement, velocity : sqrt(kg) m and sqrt(kg) m/s, shape (..., n).
    time : s, shape (...).
    """
    half = np.asarray(time, float)[..., None] / 2
    displacement, velocity = moved_freely(
        modes.angular_frequency, modes.damping_rate, displacement, _dashed_for(modes, velocity, half), time
    )
    return displacement, _dashed_for(modes, velocity, half)


def moved_freely(
    angular_frequency: Array, damping_rate: Array, displacement: Array, velocity: Array, time: Array | float
) -> tuple[Array, Array]:
    """Return the same for oscillators by their numbers, of shapes that go with (..., n); no dashpots."""
    span = np.asarray(time, float)[..., None]
    place, speed = _free_parts(angular_frequency, damping_rate, span)
    return place[0] * displacement + place[1] * velocity, speed[0] * displacement + speed[1] * velocity


def _dashed_for(modes: Modes, velocity: Array, span: Array) -> Array:
    """Return the modal velocities after the dashpots alone have acted for ``span`` s, shape (..., 1)."""
    if not len(modes.dashpots):
        return velocity
    squares = np.sum(modes.dashpots**2, axis=1)
    parts = np.where(squares > 0, -np.expm1(-squares * span) / np.where(squares > 0, squares, 1.0), span)
    return np.asarray(velocity - (parts * (velocity @ modes.dashpots.T)) @ modes.dashpots)


SLOW = 2 * math.pi * 50.0
"""rad/s; slower motions go straight on while one asks whether the bat catches up with the ball."""


class Motion(NamedTuple):
    """Ball and bat between two kicks, seen from the undisturbed bat: m and m/s.

    ``bat`` holds the modes' displacements, sqrt(kg) m, and behind them their velocities, sqrt(kg) m/s; ``work`` is what
    kicks have given the bat so far, J.
    """

    ball_position: float
    ball_speed: float
    bat: Array
    work: float = 0.0

    def kicked(self, struck: Struck, impulse: float, mass: float, *, speed: float) -> Motion:
        """Return the motion after an impulse in N s between ball and bat, whose struck place had a speed in m/s."""
        given = impulse * (speed + impulse * struck.lightness / 2)
        bat = self.bat + impulse * struck.kick
        return Motion(self.ball_position, self.ball_speed - impulse / mass, bat, self.work + given)


class Struck(NamedTuple):
    """The place that is hit.

    Parameters
    ----------
    seen : (2, 2 modes); from the bat's motion to this place's displacement, m, and speed, m/s.
    kick : (2 modes,); what an impulse of 1 N s here changes of the bat's motion.
    lightness : 1/kg, sum of the squared shapes.
    compliance : instantaneous compliance, m/N.
    by_steps : the part of the compliance that only steps put there, m/N.
    """

    seen: Array
    kick: Array
    lightness: float
    compliance: float
    by_steps: float = 0.0

    def pressed(
        self, law: ContactLaw, approach: float, turned_at: float | None, force: float = 0.0
    ) -> tuple[float, float, float]:
        """Return compression, elastic force and slope under an approach shared with the surface."""
        return pressed_in_series(law, approach=approach, compliance=self.compliance, turned_at=turned_at, force=force)

    def damping(self, ball: Ball, slope: float) -> float:
        """Return c' in s/m, by the approach that ball and surface share, of a ball whose elastic force has a slope.

        The damper acts on the ball's compression u, and u' = w' / (1 + C dG/du) for the surface's own compliance C.
        """
        return ball.damping / (1 + (self.compliance - self.by_steps) * slope)

    def in_steps(self, modes: Modes, ball: Ball, step: float) -> Struck:
        """Return the place as kicks see it, a step in s apart."""
        omega = modes.angular_frequency
        shape, give = with_quick_modes_as_springs(self.kick[len(modes) :], np.asarray(self.compliance), omega, step)
        by_steps = step**2 / 12 / ball.mass + float(shape**2 @ give_of_steps(omega, step))
        return _place(shape, float(give) + by_steps, by_steps)

    def softened(self, slope: float) -> float:
        """Return dF/dw in N/m, by the approach that ball and surface share, for dF/du by the ball's compression."""
        return slope / (1 + self.compliance * slope)


def struck_place(modes: Modes, position: float, lateral: float, closing_speed: float) -> Struck:
    """Return the place at a position and lateral place in m, as a ball of a closing speed in m/s meets it."""
    shape = modes.shape_at(position, lateral, closing_speed=closing_speed)
    return _place(shape, float(modes.compliance_at(position, lateral, closing_speed=closing_speed)))


def _place(shape: Array, compliance: float, by_steps: float = 0.0) -> Struck:
    still = np.zeros(len(shape))
    seen = np.array([[*shape, *still], [*still, *shape]])
    return Struck(seen, np.concatenate([still, shape]), float(shape @ shape), compliance, by_steps)


class Flow:
    """Ball and bat between kicks: the ball flies straight on, the modes move freely, exactly.

    All that is linear in the bat's motion, so one matrix does it: dampers for half a step on both sides of the drift.
    """

    def __init__(self, modes: Modes, step: float, ball_mass: float) -> None:
        self.modes, self.step, self.ball_mass = modes, step, ball_mass
        drift = modal_propagator_of(modes, step)
        whole = np.block([[np.diag(drift[:, row, column]) for column in (0, 1)] for row in (0, 1)])
        size, dampers = len(modes), modes.dashpots
        half = np.eye(2 * size)
        half[size:, size:] -= (dashpot_factors(modes, step / 2) * dampers.T) @ dampers
        self.matrix = half @ whole @ half if len(dampers) else whole
        self.stiffness = modes.angular_frequency**2

    def drifted(self, motion: Motion) -> Motion:
        """Return the motion one step later."""
        place = motion.ball_position + motion.ball_speed * self.step
        return Motion(place, motion.ball_speed, self.matrix @ motion.bat, motion.work)

    def energy(self, motion: Motion) -> float:
        """Return the energy of the bat's motion, J."""
        displacement, velocity = motion.bat.reshape(2, -1)
        return float(velocity @ velocity + displacement @ (self.stiffness * displacement)) / 2

    def overtaken(self, motion: Motion, struck: Struck, *, kicks: int) -> tuple[list[float], Motion] | None:
        """Return the distances in m at every kick until the bat catches up with a ball, and the motion then.

        None: it never does, or not within ``kicks``. Without its vibrations the struck place moves evenly; the ball is
        gone for good when it is further from there than all vibrations together can reach.
        """
        shape = struck.kick[len(self.modes) :]
        displacement, velocity = motion.bat.reshape(2, -1)
        slow = self.modes.angular_frequency < SLOW
        speed = float(shape[slow] @ velocity[slow]) - motion.ball_speed
        distance = float(shape[slow] @ displacement[slow]) - motion.ball_position
        fast = ~slow
        amplitude = np.hypot(displacement[fast], velocity[fast] / self.modes.angular_frequency[fast])
        reach = float(np.abs(shape[fast]) @ amplitude)
        distances: list[float] = []
        for kick in range(kicks):
            if speed > 0 and distance + kick * self.step * speed > reach:
                return None
            apart = float(struck.seen[0] @ motion.bat) - motion.ball_position
            if apart < 0:
                return distances, motion
            distances.append(apart)
            motion = self.drifted(motion)
        return None
