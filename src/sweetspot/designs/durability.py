"""How far a batter's hits stay from breaking handles and denting walls, of many bats at once.

The same strains as `sweetspot.analysis.strain` has of one hit. The handle's is that of the free ringing after the ball
has left, where it is greatest or as good as that; a wall's comes from its hoop modes under a half sine of force.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sweetspot.analysis.strain import (
    AFTER,
    HANDLE_PART,
    PUBLISHED_FAILURE_STRAIN,
    grain_factor,
    linear_limit,
    wall_curving,
)
from sweetspot.collision.impact import Impacts
from sweetspot.designs.batter import Batter, usual_places
from sweetspot.dynamics.batch.beams import BeamRow, Beams
from sweetspot.dynamics.batch.reduction import ReducedBats
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array, IntArray

POINTS = 31
"""Places along the handle half where its bending is looked at."""
TIMES = 200
"""Moments of the ringing that are looked at, 40 microseconds apart."""
NOTHING = 1e-9
"""Strain below which there is none."""
PUSHES = 48
"""Moments of a push that are looked at, to half as long again."""


@dataclass(frozen=True)
class StrainLimits:
    """What a batter's usual contacts are held against.

    ``position``: m from the knob end, along the handle half, shape (points,). ``borne``: strain that the material there
    bears, shape (points,). ``wall_borne``: the same of a hollow barrel's wall; None: nothing there can be dented.
    """

    usual: IntArray
    position: Array
    borne: Array
    wall_borne: float | None


def strain_at_failure(material: Material, *, across: bool = False) -> float | None:
    """Return the strain at which a material breaks or yields; None if not known.

    Wood bends beyond its linear limit: maple bats break at 0.0208 to 0.0234 [umass2022, appendix A], and the smaller is
    taken for every wood (assumed). Others bear their strength over their modulus.
    """
    return PUBLISHED_FAILURE_STRAIN[0] if material.family == "wood" else linear_limit(material, across=across)


def strain_limits_of(bat: Bat, batter: Batter) -> StrainLimits:
    """Return the strain limits for bats like this one."""
    position = np.linspace(0.0, HANDLE_PART * bat.length, POINTS + 1)[1:]
    materials = [bat.material_at(place) for place in position.tolist()]
    unknown = [material.name for material in (bat.material, *materials) if strain_at_failure(material) is None]
    if unknown:
        raise InputError(
            f"how much {unknown[-1]} bears is not known, so that nothing can be said of the durability of {bat.name}; "
            "leave durability out"
        )
    grain = grain_factor(bat.grain_slope) if bat.material.family == "wood" else 1.0
    borne = grain * np.array([strain_at_failure(material) for material in materials], float)
    return StrainLimits(
        usual_places(batter),
        position,
        borne,
        None if bat.shell is None else strain_at_failure(bat.material, across=True),
    )


@dataclass(frozen=True)
class BatterHits:
    """Hits of many bats at all of `FROM_TIP`.

    ``impacts``: with every bat's motion at release. ``position``, ``closing_speed``: m from the knob end and m/s, shape
    (bats, places). ``ball_mass``: kg.
    """

    impacts: Impacts
    position: Array
    closing_speed: Array
    ball_mass: float

    @property
    def push(self) -> Array:
        """N s that every hit gave, shape (bats, places)."""
        return np.asarray(self.ball_mass * (1 + self.impacts.collision_efficiency) * self.closing_speed)


class Handles(NamedTuple):
    """Many bats as ``beams``, and their diameters ``widths`` at `Breaking.position`, m, shape (bats, points)."""

    beams: Beams
    widths: Array


def strain_margins(breaking: StrainLimits, handles: Handles, bats: ReducedBats, hits: BatterHits) -> Array:
    """Return the least of strain borne over greatest strain, handles and walls, shape (bats,)."""
    beams, widths = handles
    some = breaking.usual
    motion = hits.impacts.displacement[:, some], hits.impacts.velocity[:, some]
    handle = (breaking.borne / _handle_strain(breaking, beams, bats, motion, widths)).min(axis=1)
    if breaking.wall_borne is None:
        return np.asarray(handle)
    assert isinstance(beams, BeamRow)  # whoever has walls was made one by one
    walls = np.zeros(len(bats))
    for row, (beam, wall) in enumerate(zip(beams.beams, bats.walls, strict=True)):
        if wall is not None and isinstance(beam.bat, Bat):
            place = hits.position[row, some]
            shapes = wall.shape_at(place, closing_speed=hits.closing_speed[row, some])
            bent = _wall_bending(wall, shapes, hits.impacts.peak_force[row, some], hits.push[row, some])
            walls[row] = np.nanmax(wall_curving(beam.bat, place) * bent)
    return np.asarray(np.minimum(handle, breaking.wall_borne / np.maximum(walls, NOTHING)))


def _handle_strain(
    breaking: StrainLimits, beams: Beams, bats: ReducedBats, motion: tuple[Array, Array], widths: Array
) -> Array:
    """Return the greatest strain of the outer fibre along the handles while they ring freely, shape (bats, points)."""
    omega = bats.bending.omega
    count, modes = omega.shape
    place = np.tile(breaking.position, (count, 1))
    at = beams.section_at(place.ravel(), np.repeat(np.arange(count), len(breaking.position)))
    sliding = (at.mass / at.shear_stiffness).reshape(place.shape)[..., None] * omega[:, None] ** 2
    bent = bats.bending.curvatures_at(place) + sliding * bats.bending.shapes_at(place)[..., 2:]
    bent = np.abs(widths / 2)[..., None] * bent
    bending = slice(2, 2 + modes)
    fading, times = bats.damping_rate[:, bending] / 2, np.linspace(0.0, AFTER, TIMES + 1)
    turning = np.sqrt(omega**2 - fading**2)
    phase, fade = turning[..., None] * times, np.exp(-fading[..., None] * times)
    first, second = (np.nan_to_num(part[..., bending]) for part in motion)
    second = (second + fading[:, None] * first) / turning[:, None]
    strain = np.empty(place.shape)
    for row in range(count):
        path = np.concatenate([fade[row] * np.cos(phase[row]), fade[row] * np.sin(phase[row])])  # (2 modes, times)
        both = np.concatenate([bent[row], bent[row]], axis=1)  # (points, 2 modes)
        start = np.concatenate([first[row], second[row]], axis=1)  # (places, 2 modes)
        strain[row] = (
            np.abs((start[:, None] * both).reshape(-1, 2 * modes) @ path)
            .max(axis=1)
            .reshape(len(start), -1)
            .max(axis=0)
        )
    return np.maximum(strain, NOTHING)


def _wall_bending(wall: Modes, shapes: Array, force: Array, push: Array) -> Array:
    """Return the greatest |sum (n^2 - 1) W_n| in m of hoop modes under pushes of a half sine, shape (places,).

    ``shapes``: of all modes where they are pushed, shape (places, modes). ``force``, ``push``: greatest force in N and
    impulse in N s, shape (places,).
    """
    hoop = wall.of_family("hoop")
    shape, omega = shapes[:, hoop, None], wall.angular_frequency[None, hoop, None]
    lasting = (np.pi * push / (2 * force))[:, None, None]  # s, of a half sine of that force and impulse
    drive, times = np.pi / lasting, lasting * np.linspace(0.0, 1.5, PUSHES + 1)
    pushed = np.minimum(times, lasting)
    scale = shape * force[:, None, None] / (omega**2 - drive**2)  # q'' + omega^2 q = s F sin(drive t), from rest
    place = scale * (np.sin(drive * pushed) - drive / omega * np.sin(omega * pushed))
    speed = scale * drive * (np.cos(drive * pushed) - np.cos(omega * pushed))
    later = times - pushed
    path = place * np.cos(omega * later) + speed / omega * np.sin(omega * later)
    order = np.array([wall.harmonics[index] for index in hoop])[:, None]
    return np.asarray(np.abs(((order**2 - 1) * shape * path).sum(axis=1)).max(axis=1))
