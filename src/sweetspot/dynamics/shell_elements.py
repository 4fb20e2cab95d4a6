"""A hollow barrel as a thin shell of revolution, one circumferential harmonic at a time, by finite elements.

For harmonic n the wall moves by u = U(x) cos(n theta) along the bat, v = V(x) sin(n theta) around it and
w = W(x) cos(n theta) outwards, theta measured from where the ball hits. Sanders' strains of a cylinder of the local
radius R(x) [sanders1959]:

    e_x = U', e_t = (n V + W) / R, g = V' - n U / R,
    k_x = -W'', k_t = (n^2 W + n V) / R^2, k_xt = (2 n W' + 3/2 V' + n U / (2 R)) / R.

The slope of the taper is left out, as is rotary inertia of the wall. Rings are fixed to the innermost wall.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
import scipy.linalg
from scipy.special import j1
from skfem import Basis, ElementLineHermite, ElementLinePp, MeshLine

from sweetspot.dynamics.beam import BeamModel, line_of_bat
from sweetspot.dynamics.ring_stiffness import ring_at_edge
from sweetspot.dynamics.wall import WallSection, wall_stiffness
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import lowest

EVEN_PART = np.ones((6, 6))
EVEN_PART[np.ix_([0, 1, 3, 4], [2, 5])] = EVEN_PART[np.ix_([2, 5], [0, 1, 3, 4])] = 0
"""Leaves out what couples stretching to shear: it would mix cos and sin of one harmonic. Zero for balanced walls."""
CLOSEST = 1e-4
"""m; ends of walls and rings nearer to each other than this are one."""
PATCH_POINTS = np.polynomial.legendre.leggauss(12)


@dataclass(frozen=True)
class PatchPoints:
    """A patch at some places: what the bases are at its points.

    Parameters
    ----------
    radius : of the patch, m.
    outer : radius of the bat's outside at every place, m, shape (places,).
    lift : from the wall's middle to its outside, over the radius of its middle, shape (places,).
    plane, outward : the functions of U and V, and of W, at `PATCH_POINTS`, shape (places, points, functions).
    """

    radius: float
    outer: Array
    lift: Array
    plane: Array
    outward: Array


@dataclass(frozen=True)
class ShellHarmonic:
    """Stiffness and mass of one harmonic; unknowns are U and V (cubics) and W (Hermite cubics) along the bat.

    Parameters
    ----------
    harmonic : n >= 2.
    plane, outward : the bases of U and V, and of W.
    stiffness, inertia : N/m and kg, of all unknowns.
    free : the unknowns that no support holds.
    """

    line: BeamModel
    harmonic: int
    plane: Any
    outward: Any
    stiffness: Array
    inertia: Array
    free: Any

    def modes(self, count: int) -> tuple[Array, Array]:
        """Return omega^2 (count,) and mass-normalised vectors (unknowns, count) of the lowest modes."""
        part = np.ix_(self.free, self.free)
        squares, vectors = lowest(self.stiffness[part], self.inertia[part], first=0, last=count - 1)
        full = np.zeros((len(self.stiffness), count))
        full[self.free] = vectors
        return squares, full

    def static_compliance(self, push: Array) -> Array:
        """Return how far the wall gives way in m/N under slow pushes (places, unknowns), each at its own place."""
        given = push[:, self.free]
        return np.asarray(np.einsum("pi,ip->p", given, scipy.linalg.cho_solve(self._factor, given.T)))

    @cached_property
    def _factor(self) -> Any:
        return scipy.linalg.cho_factor(self.stiffness[np.ix_(self.free, self.free)])

    def push(self, points: PatchPoints) -> Array:
        """Return the forces on all unknowns of 1 N along the ball's path over a patch, shape (places, unknowns).

        Every part of the patch is pushed along the ball's path: outwards by cos(theta) and around by -sin(theta).
        """
        n, radius, outer = self.harmonic, points.radius, points.outer[:, None]
        nodes, weights = PATCH_POINTS
        span = radius * np.sqrt(1 - nodes**2)
        before, after = (weights * radius * _across(m / outer, span, radius) for m in (n - 1, n + 1))
        outwards, around, lift = (before + after) / 2, (after - before) / 2, points.lift[:, None]
        push = np.zeros((len(points.outer), len(self.stiffness)))
        count = self.plane.N
        push[:, count : 2 * count] = np.einsum("psd,ps->pd", points.plane, around * (1 + lift))
        push[:, 2 * count :] = np.einsum("psd,ps->pd", points.outward, outwards + around * n * lift)
        return push

    def patch_points(self, places: Array, radius: float) -> PatchPoints:
        """Return what a patch of ``radius`` m asks of the bases at places in m; the same for every harmonic."""
        outer = np.asarray(line_of_bat(self.line).diameter_at(places)) / 2
        ends = self.outward.mesh.p[0][[0, -1]]
        points = np.clip(places[:, None] + radius * PATCH_POINTS[0], *ends)
        middle = wall_stiffness(self.line, places).mean_radius
        plane, outward = (
            values(points.ravel()).reshape(*points.shape, -1) for values in (self._plane_values, self._outward_values)
        )
        return PatchPoints(radius, outer, (outer - middle) / middle, plane, outward)

    def _plane_values(self, points: Array) -> Array:
        return np.asarray(self.plane.probes(points[None, :]).toarray())

    def _outward_values(self, points: Array) -> Array:
        """Return Hermite's cubics at points, shape (points, unknowns of W)."""
        edges = self.outward.mesh.p[0]
        element = np.clip(np.searchsorted(edges, points, side="right") - 1, 0, len(edges) - 2)
        size = np.diff(edges)[element]
        t = (points - edges[element]) / size
        matrix, rows = np.zeros((len(points), self.outward.N)), np.arange(len(points))
        value, slope = self.outward.nodal_dofs
        matrix[rows, value[element]] = 1 - 3 * t**2 + 2 * t**3
        matrix[rows, slope[element]] = size * (t - 2 * t**2 + t**3)
        matrix[rows, value[element + 1]] = 3 * t**2 - 2 * t**3
        matrix[rows, slope[element + 1]] = size * (t**3 - t**2)
        return matrix


def _across(wave: Array, span: Array, radius: float) -> Array:
    """Return the integral of a Hertz pressure of 1 N across the bat times cos(q y), N/m.

    3 / (2 pi a^3) int sqrt(c^2 - y^2) cos(q y) dy = 3 c J_1(q c) / (2 a^3 q), with c the half width there.

    Parameters
    ----------
    wave : q in 1/m, shape (places, 1).
    span : c in m, shape (points,).
    """
    phase = wave * span
    ratio = np.where(phase < 1e-6, 0.5, j1(phase) / np.where(phase < 1e-6, 1.0, phase))
    return np.asarray(1.5 / radius**3 * span**2 * ratio)


def shell_harmonic(line: BeamModel, n: int, *, start: float, elements: int, capped: bool) -> ShellHarmonic:
    """Return the barrel from ``start`` (m from the knob end) to the tip, for harmonic ``n``.

    Parameters
    ----------
    elements : at least; where walls and rings begin, bend or end, elements do as well.
    capped : whether a cap holds the tip round (w = v = 0); the taper always does at the other end.
    """
    outward = Basis(_mesh(line, start, elements), ElementLineHermite(), intorder=8)  # a new one: it remembers its mesh
    plane = Basis(outward.mesh, ElementLinePp(3), quadrature=outward.quadrature)
    place = outward.global_coordinates()[0]
    wall = wall_stiffness(line, place)
    strain, motion = _strain(plane, outward, wall.mean_radius, n), _motion(plane, outward)
    law = np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART
    weight = np.pi * wall.mean_radius * outward.dx
    stress = np.einsum("eqab,bjeq->ajeq", law * weight[..., None, None], strain)
    stiffness = np.einsum("aieq,ajeq->eij", strain, stress, optimize=True)
    inertia = np.einsum("aieq,ajeq->eij", motion, motion * (weight * wall.mass_per_area), optimize=True)
    of_rings = _of_rings(line, outward, motion, wall, n)
    stiffness, inertia = stiffness + of_rings[0], inertia + of_rings[1]
    dofs = np.concatenate([plane.element_dofs, plane.element_dofs + plane.N, outward.element_dofs + 2 * plane.N]).T
    free = _free_dofs(plane, outward, capped=capped)
    return ShellHarmonic(line, n, plane, outward, _assembled(stiffness, dofs), _assembled(inertia, dofs), free)


def _mesh(line: BeamModel, start: float, elements: int) -> Any:
    bat = line_of_bat(line)
    shell = bat.shell
    ends = [] if shell is None else [*shell.edges(), *(end for ring in shell.rings for end in ring.ends)]
    size = (bat.length - start) / elements
    inside = sorted(end for end in set(ends) if start + 1e-3 < end < bat.length - 1e-3)
    kept = [start]
    for end in inside:
        if end - kept[-1] > CLOSEST:
            kept.append(end)
    pieces = [np.linspace(a, b, max(1, round((b - a) / size)) + 1)[1:] for a, b in pairwise([*kept, bat.length])]
    return MeshLine(np.concatenate([[start], *pieces]))


def _of_rings(line: BeamModel, outward: Any, motion: Array, wall: WallSection, n: int) -> tuple[Array, Array]:
    """Return what rings add to stiffness and mass of every element."""
    bat = line_of_bat(line)
    functions = motion.shape[1]
    added = np.zeros((2, motion.shape[2], functions, functions))
    if bat.shell is None or not bat.shell.rings:
        return added[0], added[1]
    place = outward.global_coordinates()[0]
    for ring in bat.shell.rings:
        hollow = bat.shell.bore_at(ring.position, float(bat.diameter_at(ring.position)) / 2)
        inwards = (hollow - wall.mean_radius) / wall.mean_radius
        around = motion[1] * (1 + inwards) + n * inwards * motion[2]  # the section's normal stays straight
        at_edge = np.stack([motion[2], around])
        within = (place > ring.ends[0]) & (place < ring.ends[1])
        own = ring_at_edge(ring.material, harmonic=n, outer=hollow, hole=ring.hole(hollow))
        for kind, matrix in enumerate(own):
            pushed = np.einsum("ab,bjeq->ajeq", matrix, at_edge * (within * outward.dx))
            added[kind] += np.einsum("aieq,ajeq->eij", at_edge, pushed, optimize=True)
    return added[0], added[1]


def _strain(plane: Any, outward: Any, radius: Array, n: int) -> Array:
    """Return each basis function's six strains, shape (6, functions, elements, points)."""
    p, p1 = (np.array([part(f[0]) for f in plane.basis]) for part in (_value, _slope))
    w, w1, w2 = (np.array([part(f[0]) for f in outward.basis]) for part in (_value, _slope, _bend))
    zero = np.zeros_like(p)
    of_u = [p1, zero, -n * p / radius, zero, zero, n * p / (2 * radius**2)]
    of_v = [zero, n * p / radius, p1, zero, n * p / radius**2, 1.5 * p1 / radius]
    of_w = [np.zeros_like(w), w / radius, np.zeros_like(w), -w2, n**2 * w / radius**2, 2 * n * w1 / radius]
    return np.array([np.concatenate(fields) for fields in zip(of_u, of_v, of_w, strict=True)])


def _motion(plane: Any, outward: Any) -> Array:
    """Return each basis function's displacements (u, v, w), shape (3, functions, elements, points)."""
    p, w = (np.array([_value(f[0]) for f in basis.basis]) for basis in (plane, outward))
    motion = np.zeros((3, 2 * len(p) + len(w), *p.shape[1:]))
    motion[0, : len(p)], motion[1, len(p) : 2 * len(p)], motion[2, 2 * len(p) :] = p, p, w
    return motion


def _value(field: Any) -> Array:
    return np.asarray(field)


def _slope(field: Any) -> Array:
    return np.asarray(field.grad[0])


def _bend(field: Any) -> Array:
    return np.asarray(field.hess[0][0])


def _assembled(local: Array, dofs: Any) -> Array:
    matrix = np.zeros((dofs.max() + 1, dofs.max() + 1))
    np.add.at(matrix, (dofs[:, :, None], dofs[:, None, :]), local)
    return matrix


def _free_dofs(plane: Any, outward: Any, *, capped: bool) -> Any:
    """Return the degrees of freedom left when v and w are held at the taper and, with a cap, at the tip."""
    nodes = [0, -1] if capped else [0]
    held = [plane.N + plane.nodal_dofs[0][nodes], 2 * plane.N + outward.nodal_dofs[0][nodes]]
    return np.setdiff1d(np.arange(2 * plane.N + outward.N), np.concatenate(held))
