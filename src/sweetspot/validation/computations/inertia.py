"""Mass, balance and moments of inertia: of bodies given by printed numbers, and of the catalogue's bats."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.trampoline import WallPoint, wall_sweep
from sweetspot.calibration.bar import Bar
from sweetspot.calibration.measured import Measured
from sweetspot.collision.closed_form import collision_efficiency, exit_speed
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass, pendulum_period
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import Shell
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.paper.formulas import energy_returned, mean_force, rod
from sweetspot.validation.computations import shared


def listed_body(*, mass: float, balance_point: float, moi: float, axis: float) -> RigidBody:
    """Return the rigid body of a line in an inertia table; ``moi`` is about ``axis``."""
    point = RigidBody(mass, balance_point, 0.0, 0.0)
    return replace(point, moi_cm=moi - point.moi(axis))


def listed_moi_cm(*, mass: float, balance_point: float, moi: float, axis: float) -> float:
    """Return the moment of inertia about the balance point."""
    return listed_body(mass=mass, balance_point=balance_point, moi=moi, axis=axis).moi_cm


def listed_moi_knob(*, mass: float, balance_point: float, moi: float, axis: float) -> float:
    """Return the moment of inertia about the knob end."""
    return listed_body(mass=mass, balance_point=balance_point, moi=moi, axis=axis).moi(0.0)


def listed_percussion_from_tip(*, length: float, mass: float, balance_point: float, moi: float, axis: float) -> float:
    """Return how far from the tip the centre of percussion about ``axis`` lies."""
    body = listed_body(mass=mass, balance_point=balance_point, moi=moi, axis=axis)
    return length - centre_of_percussion(body, pivot=axis)


def listed_effective_mass(
    *, length: float, mass: float, balance_point: float, moi: float, axis: float, from_tip: float
) -> float:
    """Return the mass that a ball meets ``from_tip`` from the tip of the free bat."""
    body = listed_body(mass=mass, balance_point=balance_point, moi=moi, axis=axis)
    return effective_mass(body, length - from_tip)


def listed_efficiency(*, length: float, from_tip: float, ball_mass: float, restitution: float, **line: float) -> float:
    """Return q of the free rigid bat of a ``line`` (see `listed_body`) there."""
    return collision_efficiency(restitution, recoil=ball_mass / effective_mass(listed_body(**line), length - from_tip))


def rigid_best_speed(**table: float) -> float:
    """Return the greatest exit speed that one restitution everywhere and a rigid bat give."""
    return _rigid_best(**table)[1]


def rigid_best_from_tip(**table: float) -> float:
    """Return how far from the tip that greatest exit speed is."""
    return _rigid_best(**table)[0]


def _rigid_best(
    *, length: float, ball_mass: float, restitution: float, ball_speed: float, bat_speed: float, measured_at: float,
    **line: float,
) -> tuple[float, float]:  # fmt: skip
    """Return place from the tip and exit speed; the bat of a ``line`` turns about its knob end."""
    from scipy.optimize import minimize_scalar

    body = listed_body(**line)

    def speed(place: float) -> float:
        efficiency = collision_efficiency(restitution, recoil=ball_mass / effective_mass(body, place))
        return exit_speed(efficiency, ball_speed=ball_speed, bat_speed=bat_speed * place / measured_at)

    best = minimize_scalar(lambda place: -speed(place), bounds=(body.balance_point, length), method="bounded")
    return length - float(best.x), speed(float(best.x))


def catalogue_mass(*, bat: str) -> float:
    """Return the mass of a catalogue bat after reduction to a beam."""
    return shared.body(bat).mass


def catalogue_balance_point(*, bat: str) -> float:
    """Return its balance point from the knob end."""
    return shared.body(bat).balance_point


def catalogue_moi(*, bat: str, axis: float) -> float:
    """Return its moment of inertia about an axis across the bat."""
    return shared.body(bat).moi(axis)


def catalogue_volume(*, bat: str) -> float:
    """Return the volume of a solid bat of one material."""
    return shared.body(bat).mass / (catalog.bat(bat).material.density * shared.beam(bat).density_factor)


def catalogue_modulus(*, bat: str) -> float:
    """Return Young's modulus along the grain."""
    return catalog.bat(bat).material.longitudinal_modulus


def thin_moi_cm(*, bat: str) -> float:
    """Return the moment of inertia about the balance point of the bat's mass moved onto its axis.

    A section's inertia about its own diameter is half of that about the bat's axis: I_cm - I_roll / 2.
    """
    return _thin(bat).moi_cm


def thin_percussion(*, bat: str, pivot: float) -> float:
    """Return the centre of percussion from the knob end of the bat's mass moved onto its axis."""
    return centre_of_percussion(_thin(bat), pivot=pivot)


def _thin(bat: str) -> RigidBody:
    body = shared.body(bat)
    return replace(body, moi_cm=body.moi_cm - body.roll_moi / 2)


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


TUBE_LENGTH = 0.84
WALLS = (1.6, 1.3, 1.0, 0.85)
"""Factors on a bat's own wall, from stiff to lively."""


def tube_hoop_frequency(*, diameter: float, wall: float, modulus: float, density: float, poisson_ratio: float) -> float:
    """Return the lowest hoop frequency of a long open tube."""
    metal = Material(
        name="tube", family="metal", density=density, longitudinal_modulus=modulus, poisson_ratio=poisson_ratio
    )
    ends = (0.0, TUBE_LENGTH)
    tube = Bat(
        name="tube",
        length=TUBE_LENGTH,
        material=metal,
        profile=tuple((end, diameter) for end in ends),
        shell=Shell(wall=tuple((end, wall) for end in ends)),
    )
    return hoop_frequency(beam_model(tube))


def metal_place(*, metal: str, wood: str) -> float:
    """Return how much further from the tip the metal bat hits best."""
    places = [shared.length(bat) - shared.standard(bat).sweet_spots.max_exit_speed for bat in (metal, wood)]
    return places[0] - places[1]


def hoop_place(*, bat: str) -> float:
    """Return how much nearer the tip than the place of the greatest exit speed the lowest hoop mode swings most."""
    analysis = shared.standard(bat)
    lowest = analysis.modes.of_family("hoop")[0]
    places = analysis.scan.position
    swing = np.abs(analysis.modes.shape_at(places)[:, lowest])
    return float(places[int(np.argmax(swing))] - analysis.sweet_spots.max_exit_speed)


def gain_inside(*, metal: str, wood: str, inward: float) -> float:
    """Return how much more a metal bat gains over wood ``inward`` m nearer the hands than at the wood's best place.

    Places count from the tip; both bats are swung at the same speed.
    """
    best = shared.length(wood) - shared.standard(wood).sweet_spots.max_exit_speed
    there, at_best = (_exit_at(metal, place) - _exit_at(wood, place) for place in (best + inward, best))
    return there - at_best


def _exit_at(bat: str, from_tip: float) -> float:
    scan = shared.standard(bat).scan
    return float(np.interp(shared.length(bat) - from_tip, scan.position, scan.exit_speed))


def bbcor_slope_with_hoop(*, bat: str) -> float:
    """Return the least rise of BBCOR per 100 Hz of lower hoop frequency when the wall is thinned step by step."""
    points = _walls(bat)
    slopes = [
        100 * (thin.bbcor - thick.bbcor) / (thick.hoop_frequency - thin.hoop_frequency)
        for thick, thin in pairwise(points)
    ]
    return min(slopes)


def restitution_of_share(*, bat: str, share: float) -> float:
    """Return the restitution of the wall that stores ``share`` of the ball's energy."""
    points = _walls(bat)
    return float(np.interp(share, [p.energy.share for p in points], [p.energy.restitution for p in points]))


@cache
def _walls(bat: str) -> list[WallPoint]:
    return wall_sweep(catalog.bat(bat), shared.standard(bat).conditions, factors=WALLS)
