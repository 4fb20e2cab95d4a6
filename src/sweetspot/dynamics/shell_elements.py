"""A hollow barrel as a thin shell of revolution, one circumferential harmonic at a time, by finite elements.

For harmonic n the wall moves by u = U(x) cos(n theta) along the bat, v = V(x) sin(n theta) around it and
w = W(x) cos(n theta) outwards, theta measured from where the ball hits. Sanders' strains of a cylinder of the local
radius R(x) [sanders1959]:

    e_x = U', e_t = (n V + W) / R, g = V' - n U / R,
    k_x = -W'', k_t = (n^2 W + n V) / R^2, k_xt = (2 n W' + 3/2 V' + n U / (2 R)) / R.

The slope of the taper is left out, as is rotary inertia of the wall. Rings are fixed to the innermost wall.

Along an element U and V are cubics, W is one of Hermite's. Its unknowns, in order: U, V, W and W' at its first end, two
bubbles of U and two of V, then U, V, W and W' at its other end, which are the next element's first.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sweetspot.dynamics.beam import BeamModel, bat_of_beam
from sweetspot.dynamics.ring_stiffness import ring_at_edge
from sweetspot.dynamics.shell_kernel import STEP, UNKNOWNS
from sweetspot.dynamics.wall import WallSection, wall_stiffness
from sweetspot.numerics.arrays import Array, IntArray

EVEN_PART = np.ones((6, 6))
EVEN_PART[np.ix_([0, 1, 3, 4], [2, 5])] = EVEN_PART[np.ix_([2, 5], [0, 1, 3, 4])] = 0
"""Leaves out what couples stretching to shear: it would mix cos and sin of one harmonic. Zero for balanced walls."""
CLOSEST = 1e-4
"""m; ends of walls and rings nearer to each other than this are one."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)
"""Where along an element its energies are taken: exact for products of its functions on an even wall."""
OF_U, OF_V, OF_W = [0, 4, 5, 8], [1, 6, 7, 9], [2, 3, 10, 11]
"""Places of U, V and W among an element's unknowns."""


@dataclass(frozen=True)
class ShellElements:
    """Stiffness and mass of the elements of a barrel, by harmonic.

    Parameters
    ----------
    edges : m, where elements begin and end, shape (elements + 1,).
    harmonics : n >= 2, shape (harmonics,).
    stiffness, inertia : N/m and kg, shape (harmonics, elements, 12, 12); see this module for the unknowns' order.
    held : the unknowns that supports hold.
    """

    beam: BeamModel
    edges: Array
    harmonics: Array
    stiffness: Array
    inertia: Array
    held: IntArray


def barrel_elements(
    beam: BeamModel, harmonics: tuple[int, ...], *, start: float, elements: int, capped: bool
) -> ShellElements:
    """Return the barrel from ``start`` (m from the knob end) to the tip.

    Parameters
    ----------
    harmonics : each >= 2.
    elements : at least; where walls and rings begin, bend or end, elements do as well.
    capped : whether a cap holds the tip round (w = v = 0); the taper always does at the other end.
    """
    edges = _edges(beam, start, elements)
    size = np.diff(edges)
    place = edges[:-1, None] + size[:, None] * (NODES + 1) / 2
    wall = wall_stiffness(beam, place)
    dx = size[:, None] / 2 * WEIGHTS
    weight = np.pi * wall.mean_radius * dx
    law = np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART
    numbers = np.array(harmonics, dtype=float)
    motion = _motion(size)
    stiffness = _energy(_strain(size, wall.mean_radius, numbers), law * weight[..., None, None])
    inertia = _energy(motion, np.eye(3) * (weight * wall.mass_per_area)[..., None, None])
    of_rings = _of_rings(beam, place, dx, motion, wall, numbers)
    held = [1, 2] if not capped else [1, 2, STEP * len(size) + 1, STEP * len(size) + 2]
    return ShellElements(
        beam, edges, numbers, stiffness + of_rings[0], inertia + of_rings[1], np.array(held, dtype=np.int64)
    )


def _edges(beam: BeamModel, start: float, elements: int) -> Array:
    bat = bat_of_beam(beam)
    shell = bat.shell
    ends = [] if shell is None else [*shell.edges(), *(end for ring in shell.rings for end in ring.ends)]
    size = (bat.length - start) / elements
    inside = sorted(end for end in set(ends) if start + 1e-3 < end < bat.length - 1e-3)
    kept = [start]
    for end in inside:
        if end - kept[-1] > CLOSEST:
            kept.append(end)
    pieces = [np.linspace(a, b, max(1, round((b - a) / size)) + 1)[1:] for a, b in pairwise([*kept, bat.length])]
    return np.concatenate([[start], *pieces])


def _energy(fields: Array, law: Array) -> Array:
    """Return twice the energy of every pair of functions, shape (..., elements, 12, 12).

    Parameters
    ----------
    fields : of every function, shape (..., elements, points, fields, 12).
    law : shape (elements, points, fields, fields).
    """
    by_point = fields.reshape(*fields.shape[:-3], -1, UNKNOWNS)
    stress = (law @ fields).reshape(by_point.shape)
    return np.asarray(by_point.swapaxes(-1, -2) @ stress)


def plane_functions(t: Array) -> Array:
    """Return the four functions of U or V at t = 0 to 1 of an element, shape (..., 4)."""
    bubble = t * (1 - t)
    return np.stack([1 - t, 4 * bubble, 10 * bubble * (1 - 2 * t), t], axis=-1)


def outward_functions(t: Array, size: Array) -> Array:
    """Return Hermite's four functions of W at t = 0 to 1 of elements of a size in m, shape (..., 4)."""
    square, cube = t * t, t * t * t  # numpy's t**3 takes many times as long
    cubics = [1 - 3 * square + 2 * cube, t - 2 * square + cube, 3 * square - 2 * cube, cube - square]
    return np.stack(cubics, axis=-1) * _slopes_last(size)


def _slopes_last(size: Array) -> Array:
    """Return by what Hermite's functions on 0 to 1 are scaled for an element of a size in m, shape (..., 4)."""
    return np.stack([np.ones_like(size), size, np.ones_like(size), size], axis=-1)


def _strain(size: Array, radius: Array, harmonics: Array) -> Array:
    """Return each function's six strains, shape (harmonics, elements, points, 6, 12)."""
    t, one = (NODES + 1) / 2, np.ones_like(NODES)
    h, r, n = size[:, None, None], radius[..., None], harmonics[:, None, None, None]
    p, w, scale = plane_functions(t), outward_functions(t, size[:, None]), _slopes_last(size[:, None])
    p1 = np.stack([-one, 4 - 8 * t, 10 - 60 * t + 60 * t**2, one], axis=-1) / h
    w1 = np.stack([6 * t**2 - 6 * t, 1 - 4 * t + 3 * t**2, 6 * t - 6 * t**2, 3 * t**2 - 2 * t], axis=-1) * scale / h
    w2 = np.stack([12 * t - 6, 6 * t - 4, 6 - 12 * t, 6 * t - 2], axis=-1) * scale / h**2
    strain = np.zeros((len(harmonics), *radius.shape, 6, UNKNOWNS))
    for unknowns, parts in (
        (OF_U, {0: p1, 2: -n * p / r, 5: n * p / (2 * r**2)}),
        (OF_V, {1: n * p / r, 2: p1, 4: n * p / r**2, 5: 1.5 * p1 / r}),
        (OF_W, {1: w / r, 3: -w2, 4: n**2 * w / r**2, 5: 2 * n * w1 / r}),
    ):
        for row, part in parts.items():
            strain[..., row, unknowns] = part
    return strain


def _motion(size: Array) -> Array:
    """Return each function's displacements (u, v, w), shape (elements, points, 3, 12)."""
    t = (NODES + 1) / 2
    motion = np.zeros((len(size), len(t), 3, UNKNOWNS))
    motion[..., 0, OF_U] = motion[..., 1, OF_V] = plane_functions(t)
    motion[..., 2, OF_W] = outward_functions(t, size[:, None])
    return motion


def _of_rings(beam: BeamModel, place: Array, dx: Array, motion: Array, wall: WallSection, harmonics: Array) -> Array:
    """Return what rings add to stiffness and mass of every element, shape (2, harmonics, elements, 12, 12)."""
    shell = bat_of_beam(beam).shell
    added = np.zeros((2, len(harmonics), len(place), UNKNOWNS, UNKNOWNS))
    if shell is None:
        return added
    for ring in shell.rings:
        hollow = shell.bore_at(ring.position, float(bat_of_beam(beam).diameter_at(ring.position)) / 2)
        inwards = ((hollow - wall.mean_radius) / wall.mean_radius)[..., None]
        within = ((place > ring.ends[0]) & (place < ring.ends[1])) * dx
        for row, n in enumerate(harmonics):
            outwards = motion[..., 2, :]
            around = motion[..., 1, :] * (1 + inwards) + n * inwards * outwards  # the section's normal stays straight
            at_edge = np.stack([outwards, around], axis=-2)
            own = ring_at_edge(ring.material, harmonic=int(n), outer=hollow, hole=ring.hole(hollow))
            for kind, matrix in enumerate(own):
                added[kind, row] += _energy(at_edge, matrix * within[..., None, None])
    return added
