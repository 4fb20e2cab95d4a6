"""Exact relations: the arithmetic of bat tests, of two springs, of rods and pendulums."""

from __future__ import annotations

import math

from sweetspot.calibration.bar import Bar
from sweetspot.calibration.measured import Measured
from sweetspot.collision.closed_form import collision_efficiency, exit_speed
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass, pendulum_period
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.paper.formulas import energy_returned, mean_force, rod
from sweetspot.validation.computations import shared


def efficiency_from_speeds(*, ball_speed: float, bat_speed: float, exit_speed: float) -> float:
    """Return q for which the ball leaves with ``exit_speed``."""
    return (exit_speed - _exit(0.0, ball_speed, bat_speed)) / (
        _exit(1.0, ball_speed, bat_speed) - _exit(0.0, ball_speed, bat_speed)
    )


def besr_from_speeds(*, ball_speed: float, bat_speed: float, exit_speed: float) -> float:
    """Return BESR = q + 1/2."""
    return efficiency_from_speeds(ball_speed=ball_speed, bat_speed=bat_speed, exit_speed=exit_speed) + 0.5


def exit_speed_from_besr(*, besr: float, ball_speed: float, bat_speed: float) -> float:
    """Return the exit speed of a bat with that BESR."""
    return _exit(besr - 0.5, ball_speed, bat_speed)


def exit_speed_from_efficiency(*, efficiency: float, ball_speed: float, bat_speed: float) -> float:
    """Return v_f = q v_ball + (1 + q) v_bat."""
    return _exit(efficiency, ball_speed, bat_speed)


def break_even_bat_speed(*, efficiency: float, ball_speed: float, exit_speed: float) -> float:
    """Return the bat speed that a bat of this q needs for that exit speed."""
    at_rest = _exit(efficiency, ball_speed, 0.0)
    return (exit_speed - at_rest) / (_exit(efficiency, ball_speed, 1.0) - at_rest)


def efficiency_from_restitution(*, restitution: float, recoil: float) -> float:
    """Return q = (e - r) / (1 + r)."""
    return collision_efficiency(restitution, recoil=recoil)


def returned_energy(*, bat_restitution: float, ball_restitution: float, share: float) -> float:
    """Return W = k_bat^2 z + k_ball^2 (1 - z)."""
    return energy_returned(bat_restitution=bat_restitution, ball_restitution=ball_restitution, share=share)


def average_force(*, ball_mass: float, ball_speed: float, exit_speed: float, contact_time: float) -> float:
    """Return F = m (v2 - v1) / t of a ball that is turned round."""
    return mean_force(ball_mass, speed_change=ball_speed + exit_speed, contact_time=contact_time)


def rod_percussion_ratio(*, length: float, mass: float) -> float:
    """Return the centre of percussion of a thin rod held at its end, over its length."""
    return centre_of_percussion(rod(length, mass), pivot=0.0) / length


def recoil_mismatch_at_percussion(*, mass: float, balance_point: float, moi: float, pivot: float) -> float:
    """Return effective mass about the pivot over that of the free bat, less one, at the centre of percussion.

    ``moi`` is about the balance point.
    """
    body = RigidBody(mass, balance_point, moi, 0.0)
    place = centre_of_percussion(body, pivot=pivot)
    return effective_mass(body, place, pivot=pivot) / effective_mass(body, place) - 1


def pendulum_percussion_ratio(*, bat: str, pivot: float) -> float:
    """Return g T^2 / (4 pi^2) of the bat swinging from ``pivot`` over its centre of percussion from there."""
    body = shared.body(bat)
    period = pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    return STANDARD_GRAVITY * period**2 / (4 * math.pi**2) / (centre_of_percussion(body, pivot=pivot) - pivot)


def _exit(efficiency: float, ball_speed: float, bat_speed: float) -> float:
    return exit_speed(efficiency, ball_speed=ball_speed, bat_speed=bat_speed)


def modulus_of_bar(
    *, bar_length: float, bar_width: float, bar_thickness: float, bar_mass: float, frequency: float
) -> float:
    """Return Young's modulus of a uniform bar of metal from its first bending tone."""
    bar = Bar(*(Measured(size, 0.0) for size in (bar_length, bar_width, bar_thickness, bar_mass)))
    of_unit_speed = bar.tones_at(1.0, math.exp(bar.usual_ratio.value))[0]  # sqrt(E / rho) = 1 m/s
    return bar.density * (frequency / of_unit_speed) ** 2


COMPUTATIONS = (
    efficiency_from_speeds,
    besr_from_speeds,
    exit_speed_from_besr,
    exit_speed_from_efficiency,
    break_even_bat_speed,
    efficiency_from_restitution,
    returned_energy,
    average_force,
    rod_percussion_ratio,
    recoil_mismatch_at_percussion,
    pendulum_percussion_ratio,
    modulus_of_bar,
)
