"""The ball's force against compression: loading, unloading, and what is lost between them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from sweetspot.equipment.ball import Ball, RestitutionLine, damped_part, restitution_at

LEAST_DAMPING = 1e-7
"""s/m; below it a damper takes less than 1e-5 of what is lost, and its formulas lose their digits."""
NEWTON_STEPS = 60
FORGOTTEN = 1e-3
"""Part of a compression below which a ball is as new: the force there is below 1e-4 of that where it turned."""
NEAR = 0.01
"""Part of the greatest compression: closer than this to the bat, a ball forgets at less than half its rate [our choice;
0.2 mm for a baseball at game speed]."""
FREELY = 0.999
"""Largest c e v on the way back: beyond 1 no elastic force could drive a ball so quickly against its damper."""
NEARLY = 3e-8
"""Relative change after which Newton's method is left: what then remains is about its square."""


def loading_force(ball: Ball, compression: float) -> float:
    """Return F = k u^n in N for a first-time compression u >= 0 in m."""
    return float(ball.stiffness * compression**ball.exponent)


def stored_energy(ball: Ball, peak: float) -> float:
    """Return the energy in J that loading to ``peak`` (m) has put into the ball: k U^(n+1) / (n+1)."""
    return float(ball.stiffness * peak ** (ball.exponent + 1) / (ball.exponent + 1))


class LossyBall(Protocol):
    """Properties of a ball that unloading needs; the compiled collision has it in a record of its own."""

    @property
    def mass(self) -> float: ...
    @property
    def stiffness(self) -> float: ...
    @property
    def exponent(self) -> float: ...
    @property
    def damping(self) -> float: ...
    @property
    def restitution(self) -> RestitutionLine: ...


def unloading_exponent(ball: Ball, peak: float) -> float:
    """Return p of the unloading curve from a peak compression in m; see `unloading_power`."""
    return unloading_power(ball, peak, loading_force(ball, peak))


def wall_speed(ball: LossyBall, energy: float) -> float:
    """Return the speed v in m/s at which a rigid wall makes the ball store an energy in J: m A(c v) / c^2 = E.

    A is `damped_part`; without a damper v = sqrt(2 E / m). By Newton's method in d = c v from sqrt(2 X) + 2 X / 3,
    X = c^2 E / m. Plain arithmetic, which the kernel compiles.
    """
    if ball.damping < LEAST_DAMPING:
        return math.sqrt(2 * energy / ball.mass)
    goal = ball.damping**2 * energy / ball.mass
    number = math.sqrt(2 * goal) + 2 * goal / 3
    for _ in range(NEWTON_STEPS):
        change = (damped_part(number) - goal) * (1 + number) / number
        number -= change
        if abs(change) <= 1e-12 * number:
            break
    return number / ball.damping


def unloading_power(ball: LossyBall, peak: float, force: float) -> float:
    """Return p of the unloading curve F = F_peak (u/U)^p (1 + c u') that gives back what the restitution law says.

    At the turn the ball holds E = F_peak U / (n + 1). On a rigid wall that is so for a ball that came with v
    (`wall_speed`) and leaves with e(v) v, for which the way back needs m A(-c e v) / c^2 = F_peak U / (p + 1); so
    p + 1 = (n + 1) A(c v) / A(-c e v), without a damper (n + 1) / e^2. Every ball thus returns exactly its restitution
    law from a rigid wall, at every speed.

    Plain arithmetic, which the kernel compiles.

    Parameters
    ----------
    peak, force : U in m and F_peak in N, where the ball begins to spring back.
    """
    speed = wall_speed(ball, force * peak / (ball.exponent + 1))
    restitution = restitution_at(ball.restitution, speed)
    if ball.damping < LEAST_DAMPING:
        return (ball.exponent + 1) / restitution**2 - 1
    number = ball.damping * speed
    back = min(restitution * number, FREELY)
    return (ball.exponent + 1) * damped_part(number) / damped_part(-back) - 1


def pressed_in_series(
    law: ContactLaw,
    *,
    approach: float,
    compliance: float,
    turned_at: float | None,
    force: float = 0.0,
) -> tuple[float, float, float]:
    """Return the compression of a ball by an approach w shared with the surface, u + C G(u) = w, by Newton's method.

    The surface under the ball deflects by C G without delay: a massless spring in series with the ball, without loss.
    The ball's damper is taken across both; where the surface feels the damper's force too, q is 6e-4 higher at most.

    F is convex in u, so from the right of the root no step passes it; a step from the left may end far beyond it, where
    the way back of a ball that gives nearly nothing back (F as u^800) is beyond all numbers. No ball on its way back is
    pressed further than where it turned: no step leads beyond that.

    Parameters
    ----------
    approach : w in m, > 0.
    compliance : C in m/N, >= 0.
    force : about the one expected, N, from which Newton's method starts.

    Returns
    -------
    tuple
        the ball's compression u in m, its elastic force G in N and dG/du in N/m.
    """
    most = approach if turned_at is None else min(approach, turned_at)
    compression = min(max(approach - compliance * force, approach / 4), most)
    for _ in range(NEWTON_STEPS if compliance else 0):
        force, slope = law.force_and_slope(compression, turned_at)
        change = (approach - compression - compliance * force) / (1 + compliance * slope)
        compression = min(max(compression + change, compression / 4), most)
        if abs(change) < NEARLY * compression:
            break
    return compression, *law.force_and_slope(compression, turned_at)


def damped_impulse(
    push: float, damping: float, rate: float, lightness: float, former: float, by_steps: float, step: float
) -> tuple[float, float]:
    """Return the impulse in N s of a kick by the ball's elastic force G and its damper, and the rate amid the kick.

    With w' the rate of approach amid the kick, that before it less half of what the kick takes, J = h G (1 + c' w'),
    solved for J so that the damper never gives energy: J = h G (1 + c' w'_before) / (1 + h G c' / (2 M)). Never a pull.

    Kicks see the approach less g F and its rate less g F', g the give of steps (`give_of_steps`). G takes only g G into
    account; what c' (G g F' - g F G') leaves of that is c'^2 G^2 g w'', w'' by the rates amid this kick and the last.

    Plain arithmetic, which the kernel compiles.

    Parameters
    ----------
    push : h G in N s.
    damping : c' in s/m; see `Struck.damping`.
    rate, former : w' before this kick and amid the last one, m/s.
    lightness : 1/M in 1/kg, of ball and struck place together.
    by_steps, step : g in m/N and h in s.
    """
    impulse = push * (1 + damping * rate) / (1 + push * damping * lightness / 2)
    middle = rate - impulse * lightness / 2
    impulse *= 1 + damping * damping * by_steps * push * (middle - former) / (step * step)
    return max(0.0, impulse), middle


def top_of(before: float, middle: float, after: float) -> float:
    """Return the top of a parabola through three forces in N, the second of them the greatest.

    >>> round(top_of(0.96, 1.0, 1.0), 3)
    1.005
    """
    return middle + 0.125 * (after - before) ** 2 / (2 * middle - before - after)


def forgetting(distance: float, greatest: float) -> float:
    """Return the rate at which a ball forgets so far from the bat, in parts of its usual rate: g / (g + U / 100).

    Nothing while they touch, so that a ball which is free for an instant is that which stays in touch.

    Parameters
    ----------
    distance : g in m between ball and bat, >= 0.
    greatest : U in m, the greatest compression so far.
    """
    return distance / (distance + NEAR * greatest)


def remembered(ball: LossyBall, turned_at: float, greatest: float, free: float) -> float:
    """Return the compression in m that a ball remembers, which was free for a time: U exp(-t / T), or 0.

    T = sqrt(m / (k U^(n-1))) is the time of its mass on the stiffness at its greatest compression U: a quarter of a
    millisecond for a baseball at game speed, a third of the contact [our choice; nothing of it was measured].

    Plain arithmetic, which the kernel compiles.

    Parameters
    ----------
    turned_at : m, where the ball began to spring back, or what it remembered when it was last touched.
    greatest : U in m.
    free : t in s, each moment by its `forgetting`.
    """
    left = math.exp(-free * math.sqrt(ball.stiffness * greatest ** (ball.exponent - 1) / ball.mass))
    return turned_at * left if turned_at * left > FORGOTTEN * greatest else 0.0


@dataclass(frozen=True)
class ContactLaw:
    """The elastic part G of a ball's force: up along k u^n, down along the power that returns what the ball gives back.

    Pressed again before it is whole, the ball goes up along the way down from the compression U that it remembers, then
    on along k u^n. While it stays in touch it remembers all of U; free, it forgets (`remembered`).

    Parameters
    ----------
    recovers : whether a free ball forgets; if not, it is pressed again as it came down however long it was free.
    """

    ball: Ball
    recovers: bool = True

    @cached_property
    def _turns(self) -> dict[float, tuple[float, float]]:
        return {}

    def force_and_slope(self, compression: float, turned_at: float | None) -> tuple[float, float]:
        """Return G in N and dG/du in N/m at a compression u in m.

        Parameters
        ----------
        turned_at : the compression from which the ball springs back, None while it is pressed further than ever before.
        """
        if turned_at is None:
            force, power = loading_force(self.ball, compression), self.ball.exponent
        else:
            greatest, power = self._turn(turned_at)
            force = float(greatest * (compression / turned_at) ** power)
        return force, power * force / compression

    def remembered(self, turned_at: float, greatest: float, free: float) -> float:
        """Return the compression in m that the ball remembers when it is touched again; see the function."""
        return remembered(self.ball, turned_at, greatest, free) if self.recovers else turned_at

    def _turn(self, turned_at: float) -> tuple[float, float]:
        """Return the force where the ball began to spring back, N, and the power of its way down."""
        if turned_at not in self._turns:
            force = loading_force(self.ball, turned_at)
            self._turns[turned_at] = force, unloading_power(self.ball, turned_at, force)
        return self._turns[turned_at]
