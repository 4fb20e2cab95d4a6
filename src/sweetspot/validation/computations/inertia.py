"""Mass, balance and moments of inertia: of bodies given by printed numbers, and of the catalogue's bats."""

from __future__ import annotations

from dataclasses import replace

from sweetspot import catalog
from sweetspot.collision.closed_form import collision_efficiency, exit_speed
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass
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


COMPUTATIONS = (
    listed_moi_cm,
    listed_moi_knob,
    listed_percussion_from_tip,
    listed_effective_mass,
    listed_efficiency,
    rigid_best_speed,
    rigid_best_from_tip,
    catalogue_mass,
    catalogue_balance_point,
    catalogue_moi,
    catalogue_volume,
    catalogue_modulus,
    thin_moi_cm,
    thin_percussion,
)
