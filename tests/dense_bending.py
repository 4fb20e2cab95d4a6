"""Bending modes of one bat by dense matrices and LAPACK: the readable twin of the compiled batch.

Strain energy: EI (psi')^2 / 2 + kappa G A (w' - psi)^2 / 2; kinetic energy: mu w_t^2 / 2 + rho I psi_t^2 / 2,
with deflection w quartic and section rotation psi cubic on each element. It shares with the package the elements'
polynomials (held against scikit-fem's) and how many elements a piece gets; matrices, eigenvalues, the measured
frequency, rigid motions and the compliance under a slow push are its own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import scipy.linalg

from sweetspot.dynamics.batch.mesh import ELEMENTS, MODES, apart, at_gauss_points, least_elements, least_parts, powers
from sweetspot.dynamics.beam import BeamModel, moments, section
from sweetspot.dynamics.face_vibration import face_modes
from sweetspot.dynamics.hoop import hoop_modes
from sweetspot.dynamics.local_compliance import blade_compliance, solid_bat_compliance
from sweetspot.dynamics.modes import MOST_MODES, Family, Modes, excited_frequency, joined
from sweetspot.dynamics.patch import patch_law
from sweetspot.dynamics.residual_flexibility import CELLS, extrapolated, joints, just_inside, sample_places, with_corner
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.gauss_legendre import quadrature, rule
from sweetspot.numerics.piecewise import Piecewise

DEGREE = 4
SHIFT = 0.1
"""Part of an even beam's first eigenvalue by which the problem is shifted; the answers do not depend on it."""
EVEN_BEAM = 500.0
"""omega^2 M L^2 (L / EI) of an even free beam: (beta L)^4 = 500.6 (4.7300^4), rounded."""


def dense_modes(beam: BeamModel, *, count: int = MODES, elements: int | None = None) -> Modes:
    """Return the two rigid motions and the lowest ``count`` bending modes of a freely hung bat.

    Parameters
    ----------
    beam : the bat reduced to a beam.
    count : number of bending modes, >= 1.
    elements : number of finite elements at least, None: `least_elements`; more are used where the bat has more
        breakpoints.

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
    deflection, squares, vectors, stiffening = _solved(beam, count, elements)
    edges = deflection.edges
    omega = np.sqrt(squares)
    bending = deflection.local_polynomials(vectors[: deflection.size])
    bending *= np.sign(bending[:, -1, :].sum(axis=0))  # positive at the tip (local coordinate 1 of the last element)
    coefficients = np.concatenate([_rigid_polynomials(beam, edges), bending], axis=2)
    widths = np.diff(edges)
    coefficients /= widths[None, :, None] ** np.arange(DEGREE, -1, -1)[:, None, None]
    elastic = Piecewise(coefficients[..., 2:], edges)
    frequency = np.concatenate([[0.0, 0.0], omega / (2 * np.pi)])
    damping_rate = np.concatenate([[0.0, 0.0], 2 * beam.bat.damping_ratio * omega])
    bending_families: list[Family] = ["bending"] * count
    return Modes(
        families=("rigid", "rigid", *bending_families),
        harmonics=(0, 0, *range(1, count + 1)),
        frequency=frequency,
        damping_rate=damping_rate,
        shapes=Piecewise(coefficients, edges),
        rigid_part=np.eye(2, count + 2),
        dashpots=np.zeros((0, count + 2)),
        compliances=(left_out(beam, shapes=elastic, omega=omega, softening=1 / stiffening),),
    )


def dense_chain(beam: BeamModel, ball: Ball) -> Modes:
    """Return all motions as `all_modes` does, from dense bending modes."""
    law = patch_law(ball)
    if beam.bat.face is not None:
        face, bending, count = face_modes(beam, ball), dense_modes(beam), MODES
        wanted = excited_frequency(bending, face, ball)
        while bending.frequency[-1] < wanted and count < MOST_MODES:
            count += MODES
            bending = dense_modes(beam, count=count)
        if isinstance(beam.bat, CricketBat):
            bending = replace(bending, compliances=(*bending.compliances, blade_compliance(beam, law=law)))
        return joined(bending, face)
    bending = dense_modes(beam)
    if not isinstance(beam.bat, Bat):
        return bending
    if beam.bat.shell is None:
        return replace(bending, compliances=(*bending.compliances, solid_bat_compliance(beam, law=law)))
    return joined(bending, hoop_modes(beam, law=law))


def _solved(beam: BeamModel, count: int, elements: int | None) -> tuple[Basis, Array, Array, float]:
    """Return the deflection's basis, squared angular frequencies, mass-normalised vectors.

    Last comes the factor by which a measured frequency scales the stiffness.
    """
    elements = least_elements(count) if elements is None else elements
    edges = _edges(beam, elements)
    stiffness, inertia = _matrices(beam, edges)
    squares, vectors = lowest(stiffness, inertia, first=2, last=count + 1, shift=SHIFT * _first_square(beam))
    stiffening = _stiffening(beam, squares, elements)
    return Basis(edges, DEGREE), stiffening * squares, vectors, stiffening


def _stiffening(beam: BeamModel, squares: Array, elements: int) -> float:
    """Return the factor of a stiffness that is known up to it, which changes no shape; 1 where all of it is known.

    Parameters
    ----------
    squares : of the angular frequencies as drawn, the lowest first.
    """
    if beam.bat.frequency is None:
        return 1.0
    return float((2 * np.pi * beam.bat.frequency) ** 2 / _first_measured(beam, squares, elements))


def _first_measured(beam: BeamModel, squares: Array, elements: int) -> float:
    """Return the first squared frequency as measured, before any weights were added."""
    if not beam.bat.added:
        return float(squares[0])
    bare = replace(beam, bat=beam.bat.replaced(added=()), point_masses=beam.point_masses[: -len(beam.bat.added)])
    stiffness, inertia = _matrices(bare, _edges(bare, elements))
    return float(lowest(stiffness, inertia, first=2, last=2, shift=SHIFT * _first_square(bare))[0][0])


def mesh_matrices(beam: BeamModel, *, elements: int = ELEMENTS) -> tuple[Array, Array, float]:
    """Return dense stiffness and mass matrices, and the shift in (rad/s)^2 with which they are solved."""
    return *_matrices(beam, _edges(beam, elements)), SHIFT * _first_square(beam)


def _edges(beam: BeamModel, elements: int) -> Array:
    """Return element ends: the implement's breakpoints, its point masses, and even places between them."""
    ends = np.array(apart(sorted({*beam.bat.breakpoints(), *(weight.position for weight in beam.point_masses)})))
    width, size = np.diff(ends), beam.bat.length / elements
    at_ends = section(beam, just_inside(ends[:-1], width).ravel()).bending_stiffness
    return _element_edges(ends, size, least_parts(at_ends.reshape(2, -1), width / size))


def _first_square(beam: BeamModel) -> float:
    """Return about the square of the first angular frequency, (rad/s)^2: that of an even beam as flexible."""
    places, weights = quadrature(beam.bat.breakpoints())
    flexible = float(np.sum(weights / section(beam, places).bending_stiffness))
    return EVEN_BEAM / (flexible * moments(beam)[0] * beam.bat.length**2)


def _element_edges(breakpoints: Array, size: float, least: IntArray) -> Array:
    """Return element ends: every breakpoint, and between them equal pieces no longer than ``size``.

    Parameters
    ----------
    least : into how many at least each is cut.
    """
    pieces = [breakpoints[:1]]
    for (left, right), fewest in zip(pairwise(breakpoints), least, strict=True):
        parts = max(int(fewest), int(np.ceil((right - left) / size - 1e-9)))
        pieces.append(np.linspace(left, right, parts + 1)[1:])
    return np.concatenate(pieces)


def _matrices(beam: BeamModel, edges: Array) -> tuple[Array, Array]:
    """Return dense stiffness and mass matrices, deflections first, then rotations."""
    w, psi = Basis(edges, DEGREE), Basis(edges, DEGREE - 1)
    places, lengths = gauss_places(edges)
    at = section(beam, places)
    rows, columns = w.numbers, psi.numbers + w.size
    shear, bending = at.shear_stiffness * lengths, at.bending_stiffness * lengths
    size = w.size + psi.size
    stiffness, inertia = np.zeros((size, size)), np.zeros((size, size))
    _add(stiffness, shear, (rows, w.slopes), (rows, w.slopes))
    _add(stiffness, -shear, (rows, w.slopes), (columns, psi.values))
    _add(stiffness, -shear, (columns, psi.values), (rows, w.slopes))
    _add(stiffness, shear, (columns, psi.values), (columns, psi.values))
    _add(stiffness, bending, (columns, psi.slopes), (columns, psi.slopes))
    _add(inertia, at.mass * lengths, (rows, w.values), (rows, w.values))
    _add(inertia, at.rotary_inertia * lengths, (columns, psi.values), (columns, psi.values))
    for weight in beam.point_masses:  # each sits on an element's end, whose deflection is an unknown of its own
        node, tilt = w.number_at(weight.position), w.size + psi.number_at(weight.position)
        inertia[node, node] += weight.mass
        inertia[tilt, tilt] += weight.moi
    return stiffness, inertia


def _add(matrix: Array, weight: Array, left: tuple[IntArray, Array], right: tuple[IntArray, Array]) -> None:
    """Add the integral of weight * left_i * right_j over every element to ``matrix``."""
    (rows, left_values), (columns, right_values) = left, right
    local = (weight[..., None] * left_values).transpose(0, 2, 1) @ right_values
    np.add.at(matrix, (rows[:, :, None], columns[:, None, :]), local)


def _rigid_polynomials(beam: BeamModel, edges: Array) -> Array:
    """Return translation 1/sqrt(M) and rotation (x - x_c)/sqrt(I_cm) as local polynomials."""
    mass, first, second = moments(beam)
    centre = first / mass
    moi_cm = second - first * centre
    polynomials = np.zeros((DEGREE + 1, len(edges) - 1, 2))
    polynomials[-1, :, 0] = 1 / np.sqrt(mass)
    polynomials[-1, :, 1] = (edges[:-1] - centre) / np.sqrt(moi_cm)
    polynomials[-2, :, 1] = np.diff(edges) / np.sqrt(moi_cm)
    return polynomials


@dataclass(frozen=True, eq=False)
class Basis:
    """The functions of one degree on all elements of a line, which are continuous where elements meet.

    Parameters
    ----------
    edges : the elements' ends, m, increasing, shape (elements + 1,).
    degree : >= 1.
    """

    edges: Array
    degree: int

    @property
    def size(self) -> int:
        """How many unknowns there are."""
        return self.degree * (len(self.edges) - 1) + 1

    @property
    def numbers(self) -> IntArray:
        """Which unknown belongs to each function of each element, shape (elements, functions)."""
        first = self.degree * np.arange(len(self.edges) - 1)
        return np.asarray(first[:, None] + np.arange(self.degree + 1))

    @property
    def values(self) -> Array:
        """The functions at each element's Gauss points, shape (elements, points, functions)."""
        values, _ = at_gauss_points(self.degree)
        return np.broadcast_to(values, (len(self.edges) - 1, *values.shape))

    @property
    def slopes(self) -> Array:
        """Their derivatives along the line, 1/m, shape (elements, points, functions)."""
        _, slopes = at_gauss_points(self.degree)
        return np.asarray(slopes * (2 / np.diff(self.edges))[:, None, None])

    def number_at(self, place: float) -> int:
        """Return the unknown that is the value at the element end nearest to a place in m."""
        return self.degree * int(np.argmin(np.abs(self.edges - place)))

    def local_polynomials(self, vectors: Array) -> Array:
        """Return functions by their unknowns (size, n) as polynomials of t = 0..1, shape (degree + 1, elements, n)."""
        return np.asarray(np.einsum("pi,eim->pem", powers(self.degree), vectors[self.numbers]))


def gauss_places(edges: Array) -> tuple[Array, Array]:
    """Return places in m and weights in m of every element's Gauss points, both of shape (elements, points)."""
    nodes, weights = rule()
    half = np.diff(edges)[:, None] / 2
    return edges[:-1, None] + half * (nodes + 1), half * weights


def static_compliance(beam: BeamModel, position: Array, *, cells: int = CELLS) -> Array:
    """Return G in m/N at positions in m: displacement under a slow push there, rigid motion left out.

    Parameters
    ----------
    position : m from the knob end, shape (n,).
    cells : slices at least, >= 2. The error of the sums over slices falls with their square, so what half as many
        give tells most of it (Richardson's extrapolation).
    """
    fine, coarse = (_sliced(beam, position, cells=number) for number in (cells, cells // 2))
    return extrapolated(fine, coarse)


def _sliced(beam: BeamModel, position: Array, *, cells: int) -> Array:
    """Return sums over slices for `static_compliance`."""
    given = np.asarray(position, float)
    edges = np.union1d(_slices(beam.bat.breakpoints(), beam.bat.length / cells), given)
    middle, width = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
    at = section(beam, middle)
    lumps = np.array([(lump.position, lump.mass, lump.moi) for lump in beam.point_masses]).reshape(-1, 3)
    # of the sections themselves, so that push and inertia balance exactly
    mass = float(at.mass @ width + lumps[:, 1].sum())
    centre = float((at.mass * middle) @ width + lumps[:, 0] @ lumps[:, 1]) / mass

    def before(per_slice: Array, of_lumps: Array) -> Array:
        """Return the integral from the knob to the middle of each slice, with the point masses passed."""
        whole = per_slice * width
        return np.asarray(np.cumsum(whole) - whole / 2 + (lumps[:, 0] <= middle[:, None]) @ of_lumps)

    arm, lump_arm = middle - centre, lumps[:, 0] - centre
    inertia = before(at.mass, lumps[:, 1])
    moment = before(at.mass * arm, lumps[:, 1] * lump_arm)
    spread, lump_spread = (
        at.mass * (arm**2 + width**2 / 12) + at.rotary_inertia,
        lumps[:, 1] * lump_arm**2 + lumps[:, 2],
    )
    turning, moi = before(spread, lump_spread), float(spread @ width + lump_spread.sum())
    places = given[:, None]
    beyond = places < middle
    turn = (places - centre) / moi
    shear = beyond - inertia / mass - moment * turn
    bending = beyond * (places - middle) - (moment - arm * inertia) / mass - (turning - arm * moment) * turn
    return np.asarray((bending**2 / at.bending_stiffness + shear**2 / at.shear_stiffness) @ width)


def left_out(beam: BeamModel, *, shapes: Piecewise, omega: Array, softening: float = 1.0) -> Piecewise:
    """Return the compliance in m/N by position that elastic modes leave out: G - sum_i s_i^2 / omega_i^2.

    Parameters
    ----------
    shapes, omega : of the modes that are kept, without the rigid motions, 1/sqrt(kg) and rad/s.
    softening : factor on G for a beam whose stiffness was scaled by its inverse.
    """
    ends = np.array(beam.bat.breakpoints())
    at_ends = section(beam, just_inside(ends[:-1], np.diff(ends)).ravel()).bending_stiffness.reshape(2, -1)
    joint = joints(ends[:-1], at_ends, np.zeros(len(ends) - 1, np.int64), beams=1)
    places, corner = (part[0] for part in sample_places(np.array([beam.bat.length]), joint))
    kept = np.asarray(shapes(places)) ** 2 @ omega**-2.0
    return with_corner(places, softening * static_compliance(beam, places) - kept, int(corner))


def _slices(breakpoints: tuple[float, ...], size: float) -> Array:
    """Return every breakpoint and between them equal slices no longer than ``size``."""
    parts = [max(1, int(np.ceil((right - left) / size))) for left, right in pairwise(breakpoints)]
    pieces = [np.linspace(*ends, count + 1)[1:] for ends, count in zip(pairwise(breakpoints), parts, strict=True)]
    return np.concatenate([[breakpoints[0]], *pieces])


def lowest(stiffness: Array, inertia: Array, *, first: int, last: int, shift: float = 0.0) -> tuple[Array, Array]:
    """Return eigenvalues and mass-normalised eigenvectors ``first`` to ``last`` of K v = lambda M v; 0 is the lowest.

    Solved as M v = (K + s M) v / (lambda + s): the lowest are then the largest, and rounding, which is a part of the
    largest eigenvalue, no longer drowns them (the other way round, a short element costs the first mode seven digits).
    """
    size = len(stiffness)
    inverse, vectors = scipy.linalg.eigh(
        inertia, stiffness + shift * inertia, subset_by_index=[size - 1 - last, size - 1 - first]
    )
    inverse, vectors = inverse[::-1], vectors[:, ::-1]
    return 1 / inverse - shift, vectors / inverse**0.5
