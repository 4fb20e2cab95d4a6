"""Bending modes of a bat hung freely: a Timoshenko beam of varying section by finite elements.

Strain energy: EI (psi')^2 / 2 + kappa G A (w' - psi)^2 / 2; kinetic energy: mu w_t^2 / 2 + rho I psi_t^2 / 2,
with deflection w and section rotation psi. Deflection is quartic and rotation cubic on each element, so thin
parts do not lock. The bat's breakpoints and point masses are element ends.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from skfem import Basis, ElementLinePp, MeshLine

from sweetspot.dynamics.beam import BeamModel, moments, section
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.dynamics.residual_flexibility import left_out
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import lowest
from sweetspot.numerics.gauss_legendre import quadrature
from sweetspot.numerics.piecewise import Piecewise

ELEMENTS = 16
"""Elements at least; every bat of the catalogue then has twelve modes converged to 4e-4 and the first five to 1e-4."""
MODES = 12
CLOSEST = 1e-6
"""m; ends nearer to each other than this are one: an element between them would only hold rounding."""
DEGREE = 4
SHIFT = 0.1
"""Part of an even beam's first eigenvalue by which the problem is shifted; the answers do not depend on it."""
EVEN_BEAM = 500.0
"""omega^2 M L^2 (L / EI) of an even free beam: (beta L)^4 = 500.6 (4.7300^4), rounded."""


def bending_modes(line: BeamModel, *, count: int = MODES, elements: int = ELEMENTS) -> Modes:
    """Return the two rigid motions and the lowest ``count`` bending modes of a freely hung bat.

    Parameters
    ----------
    line : the bat reduced to a beam.
    count : number of bending modes, >= 1.
    elements : number of finite elements at least; more are used where the bat has more breakpoints.

    Returns
    -------
    Modes
        translation, rotation, then bending modes 1 to ``count``; mass-normalised shapes, positive at the tip.

    Notes
    -----
    Where the implement has a measured `frequency`, all its stiffness is scaled so that mode 1 has it.
    Damping is the material's free-free ratio, the same for every mode. Holds for transverse waves longer than
    the barrel is thick, that is up to about 10 kHz for a wood bat.
    """
    edges, deflection, squares, vectors, stiffening = _solved(line, count, elements)
    omega = np.sqrt(squares)
    bending = _as_polynomials(deflection, vectors[: deflection.N])
    bending *= np.sign(bending[:, -1, :].sum(axis=0))  # positive at the tip (local coordinate 1 of the last element)
    coefficients = np.concatenate([_rigid_polynomials(line, edges), bending], axis=2)
    widths = np.diff(edges)
    coefficients /= widths[None, :, None] ** np.arange(DEGREE, -1, -1)[:, None, None]
    elastic = Piecewise(coefficients[..., 2:], edges)
    frequency = np.concatenate([[0.0, 0.0], omega / (2 * np.pi)])
    damping_rate = np.concatenate([[0.0, 0.0], 2 * line.bat.damping_ratio * omega])
    bending_families: list[Family] = ["bending"] * count
    return Modes(
        families=("rigid", "rigid", *bending_families),
        harmonics=(0, 0, *range(1, count + 1)),
        frequency=frequency,
        damping_rate=damping_rate,
        shapes=Piecewise(coefficients, edges),
        rigid_part=np.eye(2, count + 2),
        dashpots=np.zeros((0, count + 2)),
        compliances=(left_out(line, shapes=elastic, omega=omega, softening=1 / stiffening),),
    )


def bending_frequencies(line: BeamModel, *, count: int, elements: int = ELEMENTS) -> Array:
    """Return the frequencies in Hz of the lowest ``count`` bending modes alone; see `bending_modes`."""
    _, _, squares, _, _ = _solved(line, count, elements)
    return np.asarray(np.sqrt(squares) / (2 * np.pi))


def _solved(line: BeamModel, count: int, elements: int) -> tuple[Array, Any, Array, Array, float]:
    """Return element ends, the deflection's basis, squared angular frequencies, mass-normalised vectors.

    Last comes the factor by which a measured frequency scales the stiffness.
    """
    edges, deflection, rotation = _mesh(line, elements)
    stiffness, inertia = _matrices(line, deflection, rotation)
    squares, vectors = lowest(stiffness, inertia, first=2, last=count + 1, shift=SHIFT * _first_square(line))
    stiffening = 1.0
    if line.bat.frequency is not None:  # stiffness known up to a factor, which does not change the shapes
        stiffening = float((2 * np.pi * line.bat.frequency) ** 2 / _first_measured(line, squares, elements))
    return edges, deflection, stiffening * squares, vectors, stiffening


def _first_measured(line: BeamModel, squares: Array, elements: int) -> float:
    """Return the first squared frequency as measured, before any weights were added."""
    if not line.bat.added:
        return float(squares[0])
    bare = replace(line, bat=line.bat.replaced(added=()), point_masses=line.point_masses[: -len(line.bat.added)])
    _, deflection, rotation = _mesh(bare, elements)
    stiffness, inertia = _matrices(bare, deflection, rotation)
    first, _ = lowest(stiffness, inertia, first=2, last=2, shift=SHIFT * _first_square(bare))
    return float(first[0])


def mesh_matrices(line: BeamModel, *, elements: int = ELEMENTS) -> tuple[Array, Array, float]:
    """Return dense stiffness and mass matrices, and the shift in (rad/s)^2 with which they are solved."""
    _, deflection, rotation = _mesh(line, elements)
    return *_matrices(line, deflection, rotation), SHIFT * _first_square(line)


def _mesh(line: BeamModel, elements: int) -> tuple[Array, Any, Any]:
    """Return element ends, and the bases of deflection and rotation on them."""
    ends = {*line.bat.breakpoints(), *(weight.position for weight in line.point_masses)}
    edges = _element_edges(apart(sorted(ends)), line.bat.length / elements)
    return edges, *_bases(edges)


def _first_square(line: BeamModel) -> float:
    """Return about the square of the first angular frequency, (rad/s)^2: that of an even beam as flexible."""
    places, weights = quadrature(line.bat.breakpoints())
    flexible = float(np.sum(weights / section(line, places).bending_stiffness))
    return EVEN_BEAM / (flexible * moments(line)[0] * line.bat.length**2)


def apart(ends: list[float]) -> tuple[float, ...]:
    """Return increasing ends without those that are as good as the one before; the first and the last stay."""
    kept = [ends[0]]
    kept += [end for before, end in pairwise(ends[:-1]) if end - before > CLOSEST and ends[-1] - end > CLOSEST]
    return (*kept, ends[-1])


def _element_edges(breakpoints: tuple[float, ...], size: float) -> Array:
    """Return element ends: every breakpoint, and between them equal pieces no longer than ``size``."""
    pieces = [np.array([breakpoints[0]])]
    for left, right in pairwise(breakpoints):
        parts = max(1, int(np.ceil((right - left) / size - 1e-9)))
        pieces.append(np.linspace(left, right, parts + 1)[1:])
    return np.concatenate(pieces)


@cache
def _elements() -> tuple[Any, Any]:
    return ElementLinePp(DEGREE), ElementLinePp(DEGREE - 1)


def _bases(edges: Array) -> tuple[Any, Any]:
    mesh = MeshLine(edges)
    quartic, cubic = _elements()
    deflection = Basis(mesh, quartic, intorder=2 * DEGREE + 2)
    return deflection, Basis(mesh, cubic, quadrature=deflection.quadrature)


def _matrices(line: BeamModel, deflection: Any, rotation: Any) -> tuple[Array, Array]:
    """Return dense stiffness and mass matrices, deflections first, then rotations."""
    at = section(line, deflection.global_coordinates()[0])
    lengths = deflection.dx
    w, w_slope = _values_and_slopes(deflection)
    psi, psi_slope = _values_and_slopes(rotation)
    rows, columns = deflection.element_dofs, rotation.element_dofs
    shear, bending = at.shear_stiffness * lengths, at.bending_stiffness * lengths
    size, split = deflection.N + rotation.N, deflection.N
    stiffness, inertia = np.zeros((size, size)), np.zeros((size, size))
    _add(stiffness, shear, (rows, w_slope), (rows, w_slope))
    _add(stiffness, -shear, (rows, w_slope), (columns + split, psi))
    _add(stiffness, -shear, (columns + split, psi), (rows, w_slope))
    _add(stiffness, shear, (columns + split, psi), (columns + split, psi))
    _add(stiffness, bending, (columns + split, psi_slope), (columns + split, psi_slope))
    _add(inertia, at.mass * lengths, (rows, w), (rows, w))
    _add(inertia, at.rotary_inertia * lengths, (columns + split, psi), (columns + split, psi))
    for weight in line.point_masses:  # each sits on an element's end, whose deflection is an unknown of its own
        node = deflection.nodal_dofs[0, np.argmin(np.abs(deflection.mesh.p[0] - weight.position))]
        inertia[node, node] += weight.mass
        if weight.moi:
            tilt = split + rotation.nodal_dofs[0, np.argmin(np.abs(deflection.mesh.p[0] - weight.position))]
            inertia[tilt, tilt] += weight.moi
    return stiffness, inertia


def _values_and_slopes(basis: Any) -> tuple[Array, Array]:
    """Return the basis functions and their derivatives at quadrature points, shape (functions, elements, points)."""
    return np.array([f[0] for f in basis.basis]), np.array([f[0].grad[0] for f in basis.basis])


def _add(matrix: Array, weight: Array, left: tuple[Any, Array], right: tuple[Any, Array]) -> None:
    """Add the integral of weight * left_i * right_j over every element to ``matrix``."""
    (rows, left_values), (columns, right_values) = left, right
    local = (weight * left_values).transpose(1, 0, 2) @ right_values.transpose(1, 2, 0)
    np.add.at(matrix, (rows.T[:, :, None], columns.T[:, None, :]), local)


def _as_polynomials(basis: Any, vectors: Array) -> Array:
    """Return the deflections as polynomials in the local coordinate 0..1, shape (degree + 1, elements, modes)."""
    functions, _ = _values_and_slopes(basis)
    values = np.einsum("ieq,iem->qem", functions, vectors[basis.element_dofs])
    powers = np.vander(basis.X[0], DEGREE + 1)
    return np.asarray(np.tensordot(np.linalg.pinv(powers), values, axes=1))


def _rigid_polynomials(line: BeamModel, edges: Array) -> Array:
    """Return translation 1/sqrt(M) and rotation (x - x_c)/sqrt(I_cm) as local polynomials."""
    mass, first, second = moments(line)
    centre = first / mass
    moi_cm = second - first * centre
    polynomials = np.zeros((DEGREE + 1, len(edges) - 1, 2))
    polynomials[-1, :, 0] = 1 / np.sqrt(mass)
    polynomials[-1, :, 1] = (edges[:-1] - centre) / np.sqrt(moi_cm)
    polynomials[-2, :, 1] = np.diff(edges) / np.sqrt(moi_cm)
    return polynomials
