"""The ball's force against compression: loading, unloading, and what is lost between them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from sweetspot.equipment.ball import Ball, RestitutionLine, restitution_at

NEWTON_STEPS = 60
NEARLY = 3e-8
"""Relative change after which Newton's method is left: what then remains is about its square."""


class ContactLaw(Protocol):
    """Force law of a ball as a function of its compression, all that collisions need of it.

    ``compression`` is the present one in m, ``rate`` its speed in m/s, negative when the ball springs back, and
    ``turned_at`` the compression from which it springs back, None while it is pressed further than ever before.
    They return the force in N and its derivative by compression in N/m.
    """

    def force_and_slope(self, compression: float, rate: float, turned_at: float | None) -> tuple[float, float]: ...


def loading_force(ball: Ball, compression: float) -> float:
    """Return F = k u^n in N for a first-time compression u >= 0 in m."""
    return float(ball.stiffness * compression**ball.exponent)


def stored_energy(ball: Ball, peak: float) -> float:
    """Return the energy in J that loading to ``peak`` (m) has put into the ball: k U^(n+1) / (n+1)."""
    return float(ball.stiffness * peak ** (ball.exponent + 1) / (ball.exponent + 1))


def equivalent_wall_speed(ball: Ball, peak: float) -> float:
    """Return the speed in m/s at which the ball would store the same energy on a rigid wall: sqrt(2 E / m)."""
    return math.sqrt(2 * stored_energy(ball, peak) / ball.mass)


class LossyBall(Protocol):
    """Properties of a ball that unloading needs; the compiled collision has it in a record of its own."""

    @property
    def mass(self) -> float: ...
    @property
    def exponent(self) -> float: ...
    @property
    def restitution(self) -> RestitutionLine: ...


def unloading_exponent(ball: Ball, peak: float) -> float:
    """Return p of the unloading curve from a peak compression in m; see `unloading_power`."""
    return unloading_power(ball, peak, loading_force(ball, peak))


def unloading_power(ball: LossyBall, peak: float, force: float) -> float:
    """Return p of the unloading curve F = F_peak (u/U)^p that gives back the part e^2 of the stored energy.

    E_back / E_in = (n + 1) / (p + 1) = e(v)^2, with e taken at the wall speed that stores the same energy,
    F_peak U / (n + 1). So a ball on a rigid wall returns exactly its restitution law at every speed.

    Plain arithmetic, which the kernel compiles.

    Parameters
    ----------
    peak, force : U in m and F_peak in N, where the ball begins to spring back.
    """
    wall_speed = math.sqrt(2 * force * peak / (ball.exponent + 1) / ball.mass)
    restitution = restitution_at(ball.restitution, wall_speed)
    return (ball.exponent + 1) / restitution**2 - 1


def pressed_in_series(
    law: ContactLaw,
    *,
    approach: float,
    compliance: float,
    rate: float,
    turned_at: float | None,
    force: float = 0.0,
) -> tuple[float, float, float]:
    """Return the compression of a ball by an approach w shared with the surface, u + C F(u) = w, by Newton's method.

    The surface under the ball deflects by C F without delay: a massless spring in series with the ball, without loss.

    Parameters
    ----------
    approach : w in m, > 0.
    compliance : C in m/N, >= 0.
    rate : of the approach, m/s.
    force : about the one expected, N, from which Newton's method starts.

    Returns
    -------
    tuple
        the ball's compression u in m, its force F in N and dF/du in N/m.
    """
    compression = max(approach - compliance * force, approach / 4)
    for _ in range(NEWTON_STEPS if compliance else 0):
        force, slope = law.force_and_slope(compression, rate, turned_at)
        change = (approach - compression - compliance * force) / (1 + compliance * slope)
        compression = max(compression + change, compression / 4)
        if abs(change) < NEARLY * compression:
            break
    return compression, *law.force_and_slope(compression, rate, turned_at)


@dataclass(frozen=True)
class Hysteretic:
    """The default law: up along k u^n, down along a steeper power that returns e^2 of the energy.

    Pressed again before it is free, the ball goes up along the way it came down, then on along k u^n.

    Parameters
    ----------
    recovers : whether a ball that was free for however short is as new when it is hit again; if not, it goes up along
        the way it came down then too. Which of the two is nearer within milliseconds has not been measured.
    """

    ball: Ball
    recovers: bool = True

    @cached_property
    def _turns(self) -> dict[float, tuple[float, float]]:
        return {}

    def force_and_slope(self, compression: float, rate: float, turned_at: float | None) -> tuple[float, float]:  # noqa: ARG002 - the law ignores rate
        """Return force and slope; see `ContactLaw`."""
        if turned_at is None:
            force, power = loading_force(self.ball, compression), self.ball.exponent
        else:
            greatest, power = self._turn(turned_at)
            force = float(greatest * (compression / turned_at) ** power)
        return force, power * force / compression

    def _turn(self, turned_at: float) -> tuple[float, float]:
        """Return the force where the ball began to spring back, N, and the power of its way down."""
        if turned_at not in self._turns:
            force = loading_force(self.ball, turned_at)
            self._turns[turned_at] = force, unloading_power(self.ball, turned_at, force)
        return self._turns[turned_at]


@dataclass(frozen=True)
class HuntCrossley:
    """Spring and damper F = k u^n (1 + lambda u'), lambda chosen once for the speed of approach.

    Exact on a rigid wall: with d = lambda v, d - ln(1 + d) = -e d - ln(1 - e d) gives d from e(v). On a bat that
    recoils it still uses the approach speed, where `Hysteretic` uses the energy. On a bat that bends the two differ
    by much more: the docs of the ball say by how much, and what speaks for which.
    """

    ball: Ball
    damping: float

    @classmethod
    def for_speed(cls, ball: Ball, speed: float) -> HuntCrossley:
        """Return the law whose ball leaves a rigid wall with e(speed) times ``speed`` (m/s, > 0)."""
        restitution = ball.restitution.at(speed)
        return cls(ball, 0.0 if restitution >= 1 else _wall_damping(restitution) / speed)

    def force_and_slope(self, compression: float, rate: float, turned_at: float | None) -> tuple[float, float]:  # noqa: ARG002 - no memory of the peak
        """Return force, never a pull, and slope at constant rate; see `ContactLaw`."""
        force = max(0.0, loading_force(self.ball, compression) * (1 + self.damping * rate))
        return force, self.ball.exponent * force / compression


def _wall_damping(restitution: float) -> float:
    """Return d > 0 with d - ln(1 + d) = -e d - ln(1 - e d) for 0 < e < 1: see `HuntCrossley`.

    By Newton's method for s = ln(1 - e d) < 0: the imbalance rises with s up to the root, ever less steeply.
    """
    log_rest = -(1 + restitution) / restitution  # the imbalance is below zero there, whatever e
    for _ in range(NEWTON_STEPS):
        damping = -math.expm1(log_rest) / restitution
        imbalance = (1 + restitution) * damping - math.log1p(damping) + log_rest
        steepness = 1 - math.exp(log_rest) / restitution * (restitution + damping / (1 + damping))
        change = imbalance / steepness
        log_rest -= change
        if abs(change) < NEARLY * abs(log_rest):
            break
    return -math.expm1(log_rest) / restitution
