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
from typing import NamedTuple

import numpy as np

from sweetspot.dynamics.beam import BeamModel, bat_of_beam
from sweetspot.dynamics.wall import WallSection, ring_at_edge, wall_stiffness
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.banded import WIDTH, factorised, lowest_pairs
from sweetspot.numerics.kernel_cache import compiled, inner

UNKNOWNS, STEP = 12, 8
"""Unknowns of an element, and how many of them are not the next one's: its matrix fits into a band."""
SHARED = UNKNOWNS - STEP
SIDE_BY_SIDE = 8
"""Pushes solved for at once."""


class Pushes(NamedTuple):
    """Pushes at points on the wall, each of P pushes with S points.

    Parameters
    ----------
    element : in which each point lies, shape (P, S).
    plane, outward : that element's functions of V and of W there, shape (P, S, 4).
    around, outwards : forces in N by harmonic, shape (H, P, S).
    """

    element: IntArray
    plane: Array
    outward: Array
    around: Array
    outwards: Array


class Solved(NamedTuple):
    """Output arrays of `solved_walls`: of the first D of H harmonics, M modes each.

    Parameters
    ----------
    squares : omega^2 in 1/s^2, lowest first, shape (D, M).
    felt : the modes' shapes under the pushes, 1/sqrt(kg), shape (D, P, M).
    give : m/N, static compliance of the wall under each push, shape (H, P).
    """

    squares: Array
    felt: Array
    give: Array


@compiled(nogil=True, error_model="numpy")
def solved_walls(stiffness: Array, inertia: Array, held: IntArray, pushes: Pushes, solved: Solved) -> bool:
    """Fill in what follows from the matrices of a wall's elements; see `ShellElements` for what they are.

    Returns
    -------
    bool
        False where a matrix is not positive definite or the modes do not converge.
    """
    squares, felt, give = solved
    size = STEP * stiffness.shape[1] + SHARED
    followed, modes = squares.shape
    none = np.zeros((0, size + WIDTH))
    vectors = np.zeros((modes, size + WIDTH))
    for h in range(len(stiffness)):
        diagonal, below = _assembled(size, stiffness[h], held, 1.0)
        if h < followed:
            mass = _assembled(size, inertia[h], held, 0.0)
            if not lowest_pairs(size, (diagonal, below), mass, 0.0, none, squares[h], vectors):
                return False
        elif not factorised(size, diagonal, below):
            return False
        _pushed(size, (diagonal, below), held, pushes, h, vectors if h < followed else none, felt, give)
    return True


@inner(error_model="numpy")
def _assembled(size: int, matrices: Array, held: IntArray, of_held: float) -> tuple[Array, Array]:
    """Return elements' matrices (elements, 12, 12) as one band, with ``of_held`` on the diagonal of what is held."""
    diagonal, below = np.zeros(size + WIDTH), np.zeros((size + WIDTH, WIDTH))
    for e in range(len(matrices)):
        for i in range(UNKNOWNS):
            row = STEP * e + i
            diagonal[row] += matrices[e, i, i]
            for j in range(i):
                below[STEP * e + j, i - j - 1] += matrices[e, i, j]
    for row in held:
        diagonal[row] = of_held
        below[row] = 0.0
        for k in range(min(WIDTH, row)):
            below[row - 1 - k, k] = 0.0
    return diagonal, below


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _pushed(
    size: int,
    factor: tuple[Array, Array],
    held: IntArray,
    pushes: Pushes,
    h: int,
    vectors: Array,
    felt: Array,
    give: Array,
) -> None:
    """Fill in the response and the compliance of harmonic ``h`` for every push: p^T K^-1 p = |L^-1 p|^2.

    L^-1 p goes on from the last element that is pushed to the tip; what is left there is four unknowns' work.
    """
    block = np.zeros((size + WIDTH, SIDE_BY_SIDE))
    sums = np.empty(SIDE_BY_SIDE)
    beyond = _beyond(size, factor, block, sums)
    for start in range(0, len(pushes.element), SIDE_BY_SIDE):
        count = min(SIDE_BY_SIDE, len(pushes.element) - start)
        first, last = size, 0
        for b in range(count):
            for s in range(pushes.element.shape[1]):
                base = STEP * pushes.element[start + b, s]
                around, outwards = pushes.around[h, start + b, s], pushes.outwards[h, start + b, s]
                first, last = min(first, base), max(last, base + STEP)
                plane, outward = pushes.plane[start + b, s], pushes.outward[start + b, s]
                for row, value in ((1, plane[0]), (6, plane[1]), (7, plane[2]), (9, plane[3])):
                    block[base + row, b] += around * value
                for row, value in ((2, outward[0]), (3, outward[1]), (10, outward[2]), (11, outward[3])):
                    block[base + row, b] += outwards * value
        for row in held:
            block[row] = 0.0
        for m in range(len(vectors)):
            sums[:] = 0.0
            for row in range(first, last + SHARED):
                for b in range(SIDE_BY_SIDE):
                    sums[b] += block[row, b] * vectors[m, row]
            for b in range(count):
                felt[h, start + b, m] = sums[b]
        _eliminated(factor, block, first, last, sums)
        left = block[last : last + SHARED]
        for i in range(SHARED):
            for j in range(SHARED):
                for b in range(SIDE_BY_SIDE):
                    sums[b] += beyond[last // STEP, i, j] * left[i, b] * left[j, b]
        for b in range(count):
            give[h, start + b] = sums[b]
        block[first : last + SHARED] = 0.0


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _eliminated(factor: tuple[Array, Array], block: Array, first: int, last: int, sums: Array) -> None:
    """Solve L x = b in so many rows for several b side by side, and fill in each one's |x|^2 there."""
    diagonal, below = factor
    sums[:] = 0.0
    for j in range(first, last):
        for b in range(SIDE_BY_SIDE):
            value = block[j, b] * diagonal[j]
            block[j, b] = value
            sums[b] += value * value
        for k in range(WIDTH):
            part = below[j, k]
            for b in range(SIDE_BY_SIDE):
                block[j + 1 + k, b] -= part * block[j, b]


@inner(fastmath={"contract", "reassoc", "nsz"}, error_model="numpy")
def _beyond(size: int, factor: tuple[Array, Array], block: Array, sums: Array) -> Array:
    """Return the compliance of the wall from every element's begin to the tip, of the four unknowns that begin it.

    Parameters
    ----------
    block, sums : as `_pushed` has them; the block is left as it is found, zero.
    """
    count = size // STEP
    compliance = np.zeros((count + 2, SHARED, SHARED))
    for back in range(count + 1):
        number = count - back
        first = STEP * number
        last = min(first + STEP, size)
        for i in range(SHARED):
            block[first + i, i] = 1.0
        _eliminated(factor, block, first, last, sums)
        for i in range(SHARED):
            for j in range(SHARED):
                total = 0.0
                for row in range(first, last):
                    total += block[row, i] * block[row, j]
                for k in range(SHARED):
                    for m in range(SHARED):
                        total += block[last + k, i] * compliance[number + 1, k, m] * block[last + m, j]
                compliance[number, i, j] = total
        block[first : last + SHARED] = 0.0
    return compliance


EVEN_PART = np.ones((6, 6))
EVEN_PART[np.ix_([0, 1, 3, 4], [2, 5])] = EVEN_PART[np.ix_([2, 5], [0, 1, 3, 4])] = 0
"""Leaves out what couples stretching to shear: it would mix cos and sin of one harmonic. Zero for balanced walls."""
CLOSEST = 1e-4
"""m; ends of walls and rings nearer to each other than this are one."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)
"""Quadrature points of an element's energies: exact for products of its functions on an even wall."""
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
    edges = [start]
    for end in inside:
        if end - edges[-1] > CLOSEST:
            edges.append(end)
    pieces = [np.linspace(a, b, max(1, round((b - a) / size)) + 1)[1:] for a, b in pairwise([*edges, bat.length])]
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
    t, ones = (NODES + 1) / 2, np.ones_like(NODES)
    h, r, n = size[:, None, None], radius[..., None], harmonics[:, None, None, None]
    p, w, scale = plane_functions(t), outward_functions(t, size[:, None]), _slopes_last(size[:, None])
    p1 = np.stack([-ones, 4 - 8 * t, 10 - 60 * t + 60 * t**2, ones], axis=-1) / h
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
    """Return the stiffness and mass that rings add to every element, shape (2, harmonics, elements, 12, 12)."""
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
            matrices = ring_at_edge(ring.material, harmonic=int(n), outer=hollow, hole=ring.hole(hollow))
            for kind, matrix in enumerate(matrices):
                added[kind, row] += _energy(at_edge, matrix * within[..., None, None])
    return added
