"""Rigid bodies and exact relations: inertia of printed and catalogue bats, arithmetic of bat tests, rods, springs."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

from sweetspot import catalog
from sweetspot.calibration.bar import Bar
from sweetspot.calibration.measured import Measured
from sweetspot.collision.closed_form import collision_efficiency, exit_speed
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.papers.formulas import mean_force, rod
from sweetspot.validation.computations import shared


def listed_body(*, mass: float, balance_point: float, moi: float, axis: float) -> RigidBody:
    """Return the rigid body of a line in an inertia table; ``moi`` is about ``axis``."""
    point = RigidBody(mass, balance_point, 0.0, 0.0)
    return replace(point, moi_cm=moi - point.moi(axis))


def listed_moi_knob(**line: float) -> float:
    """Return the moment of inertia about the knob end."""
    return listed_body(**line).moi(0.0)


def listed_percussion_from_tip(*, length: float, axis: float, **line: float) -> float:
    """Return the distance from the tip of the center of percussion about ``axis``."""
    return length - centre_of_percussion(listed_body(axis=axis, **line), pivot=axis)


def listed_effective_mass(*, length: float, from_tip: float, **line: float) -> float:
    """Return the effective mass ``from_tip`` from the tip of the free bat."""
    return effective_mass(listed_body(**line), length - from_tip)


def listed_efficiency(*, length: float, from_tip: float, ball_mass: float, restitution: float, **line: float) -> float:
    """Return q of the free rigid bat there."""
    mass = listed_effective_mass(length=length, from_tip=from_tip, **line)
    return collision_efficiency(restitution, recoil=ball_mass / mass)


class RigidBest(NamedTuple):
    """The place of the greatest exit speed, and that speed."""

    from_tip: float
    speed: float


def rigid_best(
    *,
    length: float,
    ball_mass: float,
    restitution: float,
    ball_speed: float,
    bat_speed: float,
    measured_at: float,
    **line: float,
) -> RigidBest:
    """Return the best hit of a rigid bat that turns about its knob end, with the same restitution everywhere."""
    from scipy.optimize import minimize_scalar

    body = listed_body(**line)

    def speed(place: float) -> float:
        efficiency = collision_efficiency(restitution, recoil=ball_mass / effective_mass(body, place))
        return exit_speed(efficiency, ball_speed=ball_speed, bat_speed=bat_speed * place / measured_at)

    best = minimize_scalar(lambda place: -speed(place), bounds=(body.balance_point, length), method="bounded")
    return RigidBest(length - float(best.x), speed(float(best.x)))


def catalogue_moi(*, bat: str, axis: float) -> float:
    """Return the moment of inertia of a catalogue bat about an axis across it."""
    return shared.body(bat).moi(axis)


def catalogue_volume(*, bat: str) -> float:
    """Return the volume of a solid bat of one material."""
    return shared.body(bat).mass / (catalog.bat(bat).material.density * shared.beam(bat).density_factor)


def catalogue_modulus(*, bat: str) -> float:
    """Return Young's modulus along the grain."""
    return catalog.bat(bat).material.longitudinal_modulus


def thin_body(*, bat: str) -> RigidBody:
    """Return a bat with its mass moved onto its axis: I_cm - I_roll / 2."""
    body = shared.body(bat)
    return replace(body, moi_cm=body.moi_cm - body.roll_moi / 2)


def thin_percussion(*, bat: str, pivot: float) -> float:
    """Return the center of percussion of that body from the knob end."""
    return centre_of_percussion(thin_body(bat=bat), pivot=pivot)


def _exit(efficiency: float, ball_speed: float, bat_speed: float) -> float:
    return exit_speed(efficiency, ball_speed=ball_speed, bat_speed=bat_speed)


def efficiency_from_speeds(*, ball_speed: float, bat_speed: float, exit_speed: float) -> float:
    """Return the q that gives ``exit_speed``."""
    stopped = _exit(0.0, ball_speed, bat_speed)
    return (exit_speed - stopped) / (_exit(1.0, ball_speed, bat_speed) - stopped)


def besr_from_speeds(**speeds: float) -> float:
    """Return BESR = q + 1/2."""
    return efficiency_from_speeds(**speeds) + 0.5


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


def average_force(*, ball_mass: float, ball_speed: float, exit_speed: float, contact_time: float) -> float:
    """Return F = m (v2 - v1) / t of a ball whose direction is reversed."""
    return mean_force(ball_mass, speed_change=ball_speed + exit_speed, contact_time=contact_time)


def rod_percussion_ratio(*, length: float, mass: float) -> float:
    """Return the center of percussion of a thin rod held at its end, over its length."""
    return centre_of_percussion(rod(length, mass), pivot=0.0) / length


def recoil_mismatch_at_percussion(*, mass: float, balance_point: float, moi: float, pivot: float) -> float:
    """Return effective mass about the pivot over that of the free bat, less one, at the center of percussion.

    ``moi`` is about the balance point.
    """
    body = RigidBody(mass, balance_point, moi, 0.0)
    place = centre_of_percussion(body, pivot=pivot)
    return effective_mass(body, place, pivot=pivot) / effective_mass(body, place) - 1


def pendulum_percussion_ratio(*, bat: str, pivot: float) -> float:
    """Return g T^2 / (4 pi^2) of the bat swinging from ``pivot`` over its center of percussion from there."""
    body = shared.body(bat)
    period = pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    return STANDARD_GRAVITY * period**2 / (4 * math.pi**2) / (centre_of_percussion(body, pivot=pivot) - pivot)


def modulus_of_bar(*, frequency: float, **sizes: float) -> float:
    """Return Young's modulus of a uniform metal bar of ``bar_length``, ... from its first bending frequency."""
    bar = Bar(*(Measured(sizes[f"bar_{name}"], 0.0) for name in ("length", "width", "thickness", "mass")))
    of_unit_speed = bar.tones_at(1.0, math.exp(bar.usual_ratio.value))[0]  # sqrt(E / rho) = 1 m/s
    return bar.density * (frequency / of_unit_speed) ** 2
