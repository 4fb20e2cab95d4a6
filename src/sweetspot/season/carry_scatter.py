"""How surely a carry is known: drag and spin that single balls scatter in, and the errors of what was measured.

What a carry does when exit speed, launch angle or backspin are a little more is tabled once, at the setting's air, with
the flight kernel; what it does with more drag is known ball by ball. All four are independent.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.batted_spin import USUAL_ANGLES, batted_ball_spin
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import BallMotions, spin_axes
from sweetspot.numerics.arrays import Array
from sweetspot.season.swings import Errors
from sweetspot.units import DEGREE, FOOT, MPH, RPM

START = (0.0, 2 * FOOT, 3 * FOOT)
"""m, where balls leave the bat."""
SPEEDS: Array = np.arange(30.0, 131.0, 10.0) * MPH
ANGLES: Array = np.arange(-30.0, 76.0, 2.5) * DEGREE
"""Nodes of the table; beyond them the nearest counts."""
SPIN_SCATTER = 500 * RPM
"""rad/s that backspin scatters by about the usual line: assumed, see docs/theory/season.md. Measured spins are not
public; collisions of made-up swings say 860 rpm, with attack angles that scatter by 7 degrees."""
HOME_RUN = (103.8 * MPH, 28.1 * DEGREE)
"""Mean exit speed and launch angle of home runs [savant_2019homeruns]: the ball for which the scatter of drag was told,
with everything else in it."""
MORE_DRAG = 0.1
"""Part of drag that the second flight has more, to learn what drag does to carry."""


@dataclass(frozen=True)
class CarryErrors:
    """What carries scatter by beside drag, m, at nodes of exit speed and launch angle.

    Parameters
    ----------
    variances : m², of measuring errors and spin together, shape (speeds, angles).
    home_run : the same of the average home run over what drag does to it, squared: it is in what home runs scatter by.
    """

    variances: Array
    home_run: float

    def spread(self, exit_speed: Array, launch_angle: Array, *, per_drag: Array, scatter: Array) -> Array:
        """Return the standard deviation of carries, m: what home runs scatter by, and more where a launch says less.

        ``scatter`` has everything in it that makes home runs scatter. So only that part of the variance of measuring
        errors and spin is added which is more than a home run's, and nothing is taken away.

        Parameters
        ----------
        exit_speed, launch_angle : as measured, m/s and rad, shape (n,).
        per_drag : m by which the carry grows with the logarithm of drag, shape (n,).
        scatter : of home runs, all told as drag, shape (n,); see `flight.home_runs.Scatter`.
        """
        from scipy.interpolate import RegularGridInterpolator

        table = RegularGridInterpolator((SPEEDS, ANGLES), self.variances)
        places = np.stack([
            np.clip(np.nan_to_num(exit_speed), SPEEDS[0], SPEEDS[-1]),
            np.clip(np.nan_to_num(launch_angle), ANGLES[0], ANGLES[-1]),
        ], axis=1)  # fmt: skip
        more = np.maximum(table(places) - np.square(per_drag) * self.home_run, 0.0)
        return np.asarray(np.sqrt(np.square(per_drag * scatter) + more))


def carry_errors(
    ball: Ball, aerodynamics: Aerodynamics, air: Air, *, errors: Errors, spin_scatter: float = SPIN_SCATTER
) -> CarryErrors:
    """Return what carries scatter by in some air.

    Parameters
    ----------
    errors : of the measurements.
    spin_scatter : standard deviation of backspin about the usual line, rad/s.
    """

    def carried(speed: Array, angle: Array, spin: float = 0.0, law: Aerodynamics = aerodynamics) -> Array:
        motions = usual_launch(speed, angle, np.zeros(len(speed)), left=np.zeros(len(speed), bool), more_spin=spin)
        return flights(motions, FlightConditions(ball=ball, aerodynamics=law, air=air)).carry

    def variances(speed: Array, angle: Array) -> Array:
        steps = (
            carried(speed + errors.exit_speed, angle) - carried(speed - errors.exit_speed, angle),
            carried(speed, angle + errors.launch_angle) - carried(speed, angle - errors.launch_angle),
            carried(speed, angle, spin_scatter) - carried(speed, angle, -spin_scatter),
        )
        return np.asarray(sum(np.square(step / 2) for step in steps))

    speeds, angles = np.meshgrid(SPEEDS, ANGLES, indexing="ij")
    found = variances(speeds.ravel(), angles.ravel()).reshape(speeds.shape)
    fast, far = (np.array([value]) for value in HOME_RUN)
    per_drag = (carried(fast, far, law=braked(aerodynamics)) - carried(fast, far)) / np.log1p(MORE_DRAG)
    return CarryErrors(np.nan_to_num(found), float((variances(fast, far) / np.square(per_drag))[0]))


def usual_launch(
    speed: Array, angle: Array, spray: Array, *, left: NDArray[np.bool_], more_spin: float | Array = 0.0
) -> BallMotions:
    """Return balls with their usual spin; beyond the angles it is known for, the spin of the nearest.

    Parameters
    ----------
    speed, angle, spray : m/s and rad, shape (n,).
    left : whether each was hit from the left side.
    more_spin : backspin beyond the usual, rad/s.
    """
    axes = spin_axes(angle, spray)
    usual = np.clip(angle, USUAL_ANGLES[0] * DEGREE, USUAL_ANGLES[1] * DEGREE)
    back, side = batted_ball_spin(usual, spray, bats=np.where(left, "left", "right"))
    spin = (back + more_spin)[:, None] * axes[0] + side[:, None] * axes[1]
    return BallMotions(velocity=speed[:, None] * axes[2], spin=spin, position=START)


def braked(law: Aerodynamics) -> Aerodynamics:
    """Return a law with a little more drag."""
    names = [name for name in Aerodynamics.model_fields if name.startswith("drag")]
    return law.replaced(**{name: getattr(law, name) * (1 + MORE_DRAG) for name in names})
