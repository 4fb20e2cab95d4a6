"""Strains that a hit leaves as by-products: bending of the handle, and of the wall of a hollow barrel.

They are compared with the strain at which the material's strength is reached if it stays linear. Above it the model has
left its ground. Nothing more is claimed: no crack, no life, no dent depth.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.collision.modal_response import free_motion, replayed
from sweetspot.dynamics.beam import BeamModel, bat_of_beam, section
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.numerics.arrays import Array

AFTER = 8e-3
"""s that are followed after release: about one swing of a bat's slowest bending mode (100 to 200 Hz)."""
STEP_AFTER = 20e-6
POINTS = 121
STEPS_OF_SPEED = 2
"""Hits from which a breaking speed is found: to 0.1 %, as strain goes nearly as a power of the speed."""
HANDLE_PART = 0.5
"""Part of the length, from the knob, that counts as handle; nearer the ball a beam's strain means little."""
PUBLISHED_FAILURE_STRAIN = (0.0208, 0.0234)
"""Strain to failure of maple in a published finite-element study of four professional bats [umass2022, appendix A]."""

GRAIN_POWER, ACROSS_GRAIN = 1.75, 0.07
"""Exponent of Hankinson's formula for bending, and strength across the grain over that along it: the middles of 1.5 to
2 and of 0.04 to 0.10 [usda_wood_handbook] (both recalled)."""


def grain_factor(slope: float) -> float:
    """Return the share of the bending strength left by a slope of the grain (rad), by Hankinson's formula.

    N / P = R / (sin^n s + R cos^n s), R = Q / P. The handbook's own table of slopes, 1 in 25, 20, 15, 10 and 5, has 96,
    93, 89, 81 and 55 %; the formula 95, 93, 89, 81 and 56 %.

    >>> import math
    >>> [round(grain_factor(math.atan(1 / run)), 2) for run in (25, 20, 15, 10, 5)]
    [0.95, 0.93, 0.89, 0.8, 0.56]
    """
    across: float = abs(math.sin(slope)) ** GRAIN_POWER
    along: float = abs(math.cos(slope)) ** GRAIN_POWER
    return ACROSS_GRAIN / (across + ACROSS_GRAIN * along)


def failure_strains(bat: Bat) -> tuple[float, float]:
    """Return the strains between which the handle of a wooden bat breaks: the published ones, less by its grain."""
    left = grain_factor(bat.grain_slope)
    low, high = PUBLISHED_FAILURE_STRAIN
    return low * left, high * left


@dataclass(frozen=True)
class Damage:
    """Greatest strains of one hit, as numbers without a unit (0.01 is 1 %).

    Parameters
    ----------
    position : m from the knob end, shape (n,).
    strain : greatest bending strain of the outer fibre there, during the hit or just after it, shape (n,).
    handle_strain, handle_position : the greatest in the handle half of the bat, and where (m from the knob end).
    strain_limit : strength over modulus of the handle's material; None when its strength is not known.
    wall_strain : greatest bending strain of a hollow barrel's wall where it was hit; None without hoop modes.
    wall_limit : the same limit for the barrel's material.
    warnings : one sentence for each limit that is passed; for wood the published strain to failure.
    """

    position: Array
    strain: Array
    handle_strain: float
    handle_position: float
    strain_limit: float | None
    wall_strain: float | None
    wall_limit: float | None
    warnings: tuple[str, ...]


def damage(impact: Impact, *, beam: BeamModel, modes: Modes) -> Damage:
    """Return the strains that a hit causes.

    strain(x) = max over t of D(x)/2 |sum_i q_i(t) c_i(x)|: the strain at the surface of a bent beam, with the
    curvature c_i = s_i'' + omega_i^2 mu s_i / (kappa G A) of each mode. The second part takes out the sliding of
    sections that is shear and not bending (exact where the section does not change).

    Notes
    -----
    The strain of the swing itself is left out. With twice as many modes the handle's strain changes by under 1 %.
    """
    bat = bat_of_beam(beam)
    motion = modal_history(impact, modes)
    places = np.linspace(0.0, bat.length, POINTS)[1:-1]
    bending = [index for index, family in enumerate(modes.families) if family != "hoop"]
    bent = motion[:, bending] @ _curvature(beam, modes, places)[:, bending].T
    strain = bat.diameter_at(places) / 2 * np.abs(bent).max(axis=0, initial=0.0)
    handle = places <= HANDLE_PART * bat.length
    worst = int(np.argmax(np.where(handle, strain, -1.0)))
    material = bat.material_at(float(places[worst]))
    limit, wall_limit = linear_limit(material), None
    wall = None
    if "hoop" in modes.families and bat.shell is not None:
        curving = wall_curving(bat, np.array([impact.position]))
        wall = wall_strain(impact, curving=float(curving[0]), modes=modes, motion=motion)
        wall_limit = linear_limit(bat.material, across=True)
    return Damage(
        position=places,
        strain=strain,
        handle_strain=float(strain[worst]),
        handle_position=float(places[worst]),
        strain_limit=limit,
        wall_strain=wall,
        wall_limit=wall_limit,
        warnings=tuple(_warnings(float(strain[worst]), limit, bat, material, wall, wall_limit)),
    )


def breaking_speed(
    impact: Impact, strains: Damage, *, beam: BeamModel, modes: Modes, ball: Ball
) -> tuple[float, float] | None:
    """Return the closing speeds in m/s between which a hit like this one breaks the handle of a wooden bat.

    At the lower one the greatest strain reaches the least at which the wood breaks, at the higher one the most; see
    `failure_strains`. None where it is not of wood, or nothing bends it.
    """
    bat = bat_of_beam(beam)
    first = strains.handle_strain
    if bat.shell is not None or bat.material.family != "wood" or first <= 0:
        return None

    def reached(strain: float) -> float:
        before, bent, speed = impact.closing_speed, first, impact.closing_speed * strain / first
        for _ in range(STEPS_OF_SPEED):  # strain goes nearly as a power of the speed
            again = hit(modes, ball=ball, position=impact.position, closing_speed=speed)
            now = damage(again, beam=beam, modes=modes).handle_strain
            power = math.log(now / bent) / math.log(speed / before) if abs(speed / before - 1) > 1e-6 else 1.0
            before, bent, speed = speed, now, speed * (strain / now) ** (1 / power)
        return speed

    low, high = failure_strains(bat)
    return reached(low), reached(high)


def modal_history(impact: Impact, modes: Modes) -> Array:
    """Return the displacement of every mode during a hit and for 8 ms after it, sqrt(kg) m, shape (times, n).

    The recorded kicks drive the modes once more; then they ring on freely.
    """
    during = replayed(impact, modes)
    last, speed = during.displacement[-1], during.velocity[-1]
    after = free_motion(modes, displacement=last, velocity=speed, step=STEP_AFTER, count=round(AFTER / STEP_AFTER))
    return np.concatenate([during.displacement, after.displacement])


def wall_strain(impact: Impact, *, curving: float, modes: Modes, motion: Array) -> float:
    """Return the greatest bending strain around a hollow barrel's wall where it was hit.

    A ring bent by w = sum W_n cos(n theta) without stretching: strain = h / (2 R^2) |sum (n^2 - 1) W_n| under the
    ball, h the wall's thickness and R the radius of its middle. Walls that slide on each other bend each by itself.

    ``curving`` is that of the wall there (`wall_curving`), ``motion`` from `modal_history`.

    Notes
    -----
    W_n is the mean over the ball's patch, so this is a low estimate of the strain in the middle of a dent.
    """
    hoop = modes.of_family("hoop")
    harmonics = np.array([modes.harmonics[index] for index in hoop])
    bent = (harmonics**2 - 1) * modes.shape_at(impact.position, closing_speed=impact.closing_speed)[hoop]
    return float(curving * np.abs(motion[:, hoop] @ bent).max(initial=0.0))


def wall_curving(bat: Bat, position: Array) -> Array:
    """Return h / (2 R^2) in 1/m of a hollow barrel's outer wall: strain per bending (n^2 - 1) W_n, see `wall_strain`.

    ``position``: m from the knob end, shape (n,).
    """
    assert bat.shell is not None
    thickness = np.asarray(bat.wall_at(position), float)
    if bat.shell.bonded and bat.shell.inner_wall is not None:
        thickness = thickness + bat.shell.inner_wall.thickness_at(position)
    radius = np.asarray(bat.diameter_at(position)) / 2 - thickness / 2
    return np.asarray(thickness / (2 * radius**2))


def linear_limit(material: Material, *, across: bool = False) -> float | None:
    """Return strength over modulus, the strain at which a linear material reaches its strength; None if not known.

    Wood bends beyond it before it breaks: slow tests of maple give 0.009 here, `PUBLISHED_FAILURE_STRAIN` is 0.02.

    >>> from sweetspot.equipment.material import Material
    >>> metal = Material(name="m", density=2820, longitudinal_modulus=70e9, poisson_ratio=0.33, strength=350e6)
    >>> linear_limit(metal)
    0.005
    """
    if material.strength is None:
        return None
    modulus = material.across if across else material.longitudinal_modulus
    return material.strength / modulus


def _curvature(beam: BeamModel, modes: Modes, places: Array) -> Array:
    """Return each mode's rotation of a section per length, shape (places, n)."""
    at = section(beam, places)
    sliding = (at.mass / at.shear_stiffness)[:, None] * modes.angular_frequency**2 * modes.shape_at(places)
    return np.asarray(modes.shapes(places, 2) + sliding)


def _warnings(
    strain: float, limit: float | None, bat: Bat, material: Material, wall: float | None, wall_limit: float | None
) -> list[str]:
    warnings = []
    low, high = failure_strains(bat)
    grain = f", with grain that slopes by {math.degrees(bat.grain_slope):.1f} degrees" if bat.grain_slope else ""
    if material.family == "wood" and limit is not None and strain > low:
        warnings.append(
            f"The handle bends to {100 * strain:.2f} %: bats of maple break at {100 * low:.1f} to {100 * high:.1f} % "
            f"[umass2022]{grain}."
        )
    elif material.family != "wood" and limit is not None and strain > limit:
        warnings.append(
            f"The handle bends to {100 * strain:.2f} %, beyond the {100 * limit:.2f} % at which {material.name} "
            "reaches its strength; the model is linear and says no more."
        )
    if wall is not None and wall_limit is not None and wall > wall_limit:
        warnings.append(
            f"The barrel's wall bends to a strain of {100 * wall:.2f} %, beyond the {100 * wall_limit:.2f} % at which "
            "its material reaches its strength: a dent is possible; the model is linear and says no more."
        )
    return warnings
