"""Bending modes of a bat hung freely: a Timoshenko beam of varying section by finite elements.

Strain energy: EI (psi')^2 / 2 + kappa G A (w' - psi)^2 / 2; kinetic energy: mu w_t^2 / 2 + rho I psi_t^2 / 2,
with deflection w and section rotation psi. Deflection is quartic and rotation cubic on each element, so thin
parts do not lock. The bat's breakpoints and point masses are element ends.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from sweetspot.dynamics.beam import BeamModel, moments, section
from sweetspot.dynamics.beam_elements import Basis, gauss_places
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.dynamics.residual_flexibility import just_inside, left_out
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.eigen import lowest, lowest_values
from sweetspot.numerics.gauss_legendre import quadrature
from sweetspot.numerics.piecewise import Piecewise

ELEMENTS = 16
"""Elements at least for a dozen modes; every bat of the catalogue then has twelve converged to 4e-4 and the first five
to 1e-4. Four dozen on a badminton racket need as many for each: with 29 in all they missed up to 6e-4 of q."""
MODES = 12
WIDENING, WIDENING_OF_SHORT = 0.4, 1.4
"""By how much of its thin end a piece may widen within one element, the second of pieces shorter than half an element,
which bend little. Between a handle of 16 mm and a barrel one element left the first mode 2e-4 too quick, and what was
missed of that slow mode's give counted as give at once, up to 0.018 of q; it is now about 1e-5."""
CLOSEST = 1e-6
"""m; ends nearer to each other than this are one: an element between them would only hold rounding."""
DEGREE = 4
SHIFT = 0.1
"""Part of an even beam's first eigenvalue by which the problem is shifted; the answers do not depend on it."""
EVEN_BEAM = 500.0
"""omega^2 M L^2 (L / EI) of an even free beam: (beta L)^4 = 500.6 (4.7300^4), rounded."""


def bending_modes(line: BeamModel, *, count: int = MODES, elements: int | None = None) -> Modes:
    """Return the two rigid motions and the lowest ``count`` bending modes of a freely hung bat.

    Parameters
    ----------
    line : the bat reduced to a beam.
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

    >>> from sweetspot import beam_model, bending_modes, catalog
    >>> modes = bending_modes(beam_model(catalog.bat("r161-ash")), count=3)
    >>> modes.frequency.round(), modes.nodes(2).round(2)  # Hz; m from the knob end where mode 1 stands still
    (array([   0.,    0.,  172.,  572., 1118.]), array([0.17, 0.67]))
    """
    deflection, squares, vectors, stiffening = _solved(line, count, elements)
    edges = deflection.edges
    omega = np.sqrt(squares)
    bending = deflection.local_polynomials(vectors[: deflection.size])
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


def least_elements(count: int) -> int:
    """Return how many elements ``count`` modes need at least: `ELEMENTS` for every dozen."""
    return ELEMENTS * -(-count // MODES)


def bending_frequencies(line: BeamModel, *, count: int, elements: int | None = None) -> Array:
    """Return the frequencies in Hz of the lowest ``count`` bending modes alone; see `bending_modes`."""
    elements = least_elements(count) if elements is None else elements
    stiffness, inertia = _matrices(line, _edges(line, elements))
    squares = lowest_values(stiffness, inertia, first=2, last=count + 1, shift=SHIFT * _first_square(line))
    return np.asarray(np.sqrt(_stiffening(line, squares, elements) * squares) / (2 * np.pi))


def _solved(line: BeamModel, count: int, elements: int | None) -> tuple[Basis, Array, Array, float]:
    """Return the deflection's basis, squared angular frequencies, mass-normalised vectors.

    Last comes the factor by which a measured frequency scales the stiffness.
    """
    elements = least_elements(count) if elements is None else elements
    edges = _edges(line, elements)
    stiffness, inertia = _matrices(line, edges)
    squares, vectors = lowest(stiffness, inertia, first=2, last=count + 1, shift=SHIFT * _first_square(line))
    stiffening = _stiffening(line, squares, elements)
    return Basis(edges, DEGREE), stiffening * squares, vectors, stiffening


def _stiffening(line: BeamModel, squares: Array, elements: int) -> float:
    """Return the factor of a stiffness that is known up to it, which changes no shape; 1 where all of it is known.

    Parameters
    ----------
    squares : of the angular frequencies as drawn, the lowest first.
    """
    if line.bat.frequency is None:
        return 1.0
    return float((2 * np.pi * line.bat.frequency) ** 2 / _first_measured(line, squares, elements))


def _first_measured(line: BeamModel, squares: Array, elements: int) -> float:
    """Return the first squared frequency as measured, before any weights were added."""
    if not line.bat.added:
        return float(squares[0])
    bare = replace(line, bat=line.bat.replaced(added=()), point_masses=line.point_masses[: -len(line.bat.added)])
    stiffness, inertia = _matrices(bare, _edges(bare, elements))
    return float(lowest_values(stiffness, inertia, first=2, last=2, shift=SHIFT * _first_square(bare))[0])


def mesh_matrices(line: BeamModel, *, elements: int = ELEMENTS) -> tuple[Array, Array, float]:
    """Return dense stiffness and mass matrices, and the shift in (rad/s)^2 with which they are solved."""
    return *_matrices(line, _edges(line, elements)), SHIFT * _first_square(line)


def _edges(line: BeamModel, elements: int) -> Array:
    """Return element ends: the implement's breakpoints, its point masses, and even places between them."""
    ends = np.array(apart(sorted({*line.bat.breakpoints(), *(weight.position for weight in line.point_masses)})))
    width, size = np.diff(ends), line.bat.length / elements
    at_ends = section(line, just_inside(ends[:-1], width).ravel()).bending_stiffness
    return _element_edges(ends, size, least_parts(at_ends.reshape(2, -1), width / size))


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


def least_parts(bending_stiffness: Array, width: Array) -> IntArray:
    """Return into how many elements pieces must be cut at least, for how much they widen.

    Parameters
    ----------
    bending_stiffness : EI in N m^2 at their left and their right ends, shape (2, pieces); its fourth root is taken for
        their width.
    width : of the pieces, in elements, shape (pieces,).

    >>> least_parts(np.array([[1.0, 1.0, 1.0], [1.0, 16.0, 16.0]]), np.array([1.0, 0.2, 1.0])).tolist()
    [1, 1, 3]
    """
    widening = np.exp(np.abs(np.log(bending_stiffness[1] / bending_stiffness[0])) / 4) - 1
    allowed = np.where(width < 0.5, WIDENING_OF_SHORT, WIDENING)
    return np.asarray(np.maximum(1, np.ceil(widening / allowed)), np.int64)


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


def _matrices(line: BeamModel, edges: Array) -> tuple[Array, Array]:
    """Return dense stiffness and mass matrices, deflections first, then rotations."""
    w, psi = Basis(edges, DEGREE), Basis(edges, DEGREE - 1)
    places, lengths = gauss_places(edges)
    at = section(line, places)
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
    for weight in line.point_masses:  # each sits on an element's end, whose deflection is an unknown of its own
        node, tilt = w.number_at(weight.position), w.size + psi.number_at(weight.position)
        inertia[node, node] += weight.mass
        inertia[tilt, tilt] += weight.moi
    return stiffness, inertia


def _add(matrix: Array, weight: Array, left: tuple[IntArray, Array], right: tuple[IntArray, Array]) -> None:
    """Add the integral of weight * left_i * right_j over every element to ``matrix``."""
    (rows, left_values), (columns, right_values) = left, right
    local = (weight[..., None] * left_values).transpose(0, 2, 1) @ right_values
    np.add.at(matrix, (rows[:, :, None], columns[:, None, :]), local)


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
