"""The bending modes of many beams hung freely: mass properties, modes, and what those leave out.

Timoshenko beams of varying section by finite elements. Strain energy: EI (psi')^2 / 2 + kappa G A (w' - psi)^2 / 2;
kinetic energy: mu w_t^2 / 2 + rho I psi_t^2 / 2, with deflection w and section rotation psi. Deflection is quartic and
rotation cubic on each element, so thin parts do not lock. Breakpoints and point masses are element ends.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from sweetspot.dynamics.batch.beams import Beams, Lumps
from sweetspot.dynamics.batch.bending_kernel import Elements, Points, bend, give_slowly, merged, shapes_at
from sweetspot.dynamics.batch.mesh import MODES, Mesh, least_elements, least_parts
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.dynamics.residual_flexibility import CELLS, extrapolated, joints, just_inside, sample_places, with_corner
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.section import CrossSection
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.gauss_legendre import GAUSS_POINTS, rule
from sweetspot.numerics.piecewise import Piecewise, cubic_spline
from sweetspot.numerics.threads import in_parts

CHUNK = 16
"""Beams worked on together, so that their sections stay near the processor."""
SLACK = 1e-9


@dataclass(frozen=True)
class BendingBatch:
    """Many beams with their motions.

    Parameters
    ----------
    length, mass, balance_point, moi_cm, roll_moi : m, kg, m from the knob end, kg m^2 across and about the line; all of
        shape (beams,).
    omega : rad/s of the bending modes, shape (beams, count).
    damping_ratio : shape (beams,).
    mesh : the elements' ends.
    coefficients : the elastic shapes on every element, of t^4 ... t^0 with t = 0..1, shape (elements, 5, count).
    left_out : m/N that the modes leave out, shape (beams, places).
    sampled_at, corner : where that is known, m, shape (beams, places), and which of the places is a joint's, shape
        (beams,); see `sample_places`.
    """

    length: Array
    mass: Array
    balance_point: Array
    moi_cm: Array
    roll_moi: Array
    omega: Array
    damping_ratio: Array
    mesh: Mesh
    coefficients: Array
    left_out: Array
    sampled_at: Array
    corner: IntArray

    def __len__(self) -> int:
        return len(self.length)

    @property
    def frequency(self) -> Array:
        """Frequencies in Hz, shape (beams, count)."""
        return self.omega / (2 * np.pi)

    def moi(self, axis: Array | float) -> Array:
        """Return moments of inertia in kg m^2 about axes across the beams, m from the knob end, shape (beams,)."""
        return np.asarray(self.moi_cm + self.mass * (axis - self.balance_point) ** 2)

    def body(self, number: int) -> RigidBody:
        """Return one beam as a rigid body."""
        parts = (self.mass, self.balance_point, self.moi_cm, self.roll_moi)
        return RigidBody(*(float(part[number]) for part in parts))

    def shapes_at(self, position: Array) -> Array:
        """Return rigid motions and modes at places (beams, places) in m, shape (beams, places, count + 2)."""
        count = self.omega.shape[1]
        elastic = np.empty((*position.shape, count))
        shapes_at(self.mesh.first_piece, self._left, self._width, self.coefficients, position, elastic)
        shift = (1 / np.sqrt(self.mass))[:, None, None]
        turn = (position - self.balance_point[:, None]) / np.sqrt(self.moi_cm)[:, None]
        return np.concatenate([np.broadcast_to(shift, (*position.shape, 1)), turn[..., None], elastic], axis=2)

    def curvatures_at(self, position: Array) -> Array:
        """Return the modes' second derivatives at places (beams, places) in m, 1/(sqrt(kg) m^2) after `shapes_at`."""
        curvatures = np.empty((*position.shape, self.omega.shape[1]))
        c, second = self.coefficients, np.zeros_like(self.coefficients)
        second[:, 2:] = np.stack([12 * c[:, 0], 6 * c[:, 1], 2 * c[:, 2]], axis=1) / self._width[:, None, None] ** 2
        shapes_at(self.mesh.first_piece, self._left, self._width, second, position, curvatures)
        return curvatures

    def left_out_at(self, position: Array) -> Array:
        """Return the residual compliance of the modes at places (beams, places) in m, m/N; see `left_out`."""
        part = position / self.length[:, None]
        pieces = self.sampled_at.shape[1] - 1
        for beam in np.flatnonzero(self.corner):  # even only up to the joint and after it
            here, at = self.corner[beam] / pieces, self.sampled_at[beam, self.corner[beam]]
            part[beam] = np.interp(position[beam], [0.0, at, self.length[beam]], [0.0, here, 1.0])
        return on_even_splines(self._spline, part)

    def modes(self, number: int) -> Modes:
        """Return one beam's modes."""
        first = self.mesh.first_piece
        inside = slice(first[number], first[number + 1])
        edges = self.mesh.ends[self.mesh.first[number] : self.mesh.first[number + 1]]
        count = self.omega.shape[1]
        rigid = np.zeros((5, len(edges) - 1, 2))
        rigid[-1, :, 0] = 1 / np.sqrt(self.mass[number])
        rigid[-1, :, 1] = (edges[:-1] - self.balance_point[number]) / np.sqrt(self.moi_cm[number])
        rigid[-2, :, 1] = np.diff(edges) / np.sqrt(self.moi_cm[number])
        coefficients = np.concatenate([rigid, self.coefficients[inside].transpose(1, 0, 2)], axis=2)
        coefficients /= np.diff(edges)[None, :, None] ** np.arange(4, -1, -1)[:, None, None]
        omega = np.concatenate([[0.0, 0.0], self.omega[number]])
        bending: list[Family] = ["bending"] * count
        return Modes(
            families=("rigid", "rigid", *bending),
            harmonics=(0, 0, *range(1, count + 1)),
            frequency=omega / (2 * np.pi),
            damping_rate=2 * self.damping_ratio[number] * omega,
            shapes=Piecewise(coefficients, edges),
            rigid_part=np.eye(2, count + 2),
            dashpots=np.zeros((0, count + 2)),
            compliances=(with_corner(self.sampled_at[number], self.left_out[number], int(self.corner[number])),),
        )

    @cached_property
    def _left(self) -> Array:
        return self.mesh.left

    @cached_property
    def _width(self) -> Array:
        return self.mesh.width

    @cached_property
    def _spline(self) -> Array:
        splines = even_splines(self.left_out)
        even = np.linspace(0.0, 1.0, self.left_out.shape[1])
        for beam in np.flatnonzero(self.corner):
            splines[..., beam] = with_corner(even, self.left_out[beam], int(self.corner[beam])).coefficients
        return splines


def bending_batch(
    beams: Beams, *, count: int = MODES, elements: int | None = None, threads: int | None = None
) -> BendingBatch:
    """Return mass properties and the lowest ``count`` bending modes of many free beams.

    Raises `InputError` when a beam has no modes: a mass or stiffness that is not above zero.

    Parameters
    ----------
    beams : outlines side by side (`SolidBats`), or any implements (`BeamRow`).
    count : number of bending modes, >= 1.
    elements : number of finite elements of each at least, None: `least_elements`; more are used where a beam has more
        breakpoints.
    threads : workers; None: one per core.
    """
    parts: dict[int, BendingBatch] = {}
    least = least_elements(count) if elements is None else elements

    def work(which: slice) -> None:
        parts[which.start] = _some(beams.part(which), count, least, which.start)

    in_parts(work, len(beams), size=CHUNK, threads=threads)
    return joined_batches([parts[start] for start in sorted(parts)])


def frequencies_of(beams: Beams, *, count: int, elements: int | None = None) -> Array:
    """Return the frequencies in Hz of the lowest bending modes alone, shape (beams, count); see `bending_batch`."""
    least = least_elements(count) if elements is None else elements
    vibrating = _vibrating(beams, count, least, 0)
    squares = _stiffening(beams, vibrating, least, 0)[:, None] * vibrating.squares
    return np.asarray(np.sqrt(squares) / (2 * np.pi))


def mass_properties(beams: Beams) -> BendingBatch:
    """Return mass, balance and moments of inertia of many beams without any mode: a fiftieth of the work."""
    whole, plain = beams.ends()
    length = _length(plain)
    mesh = _elements(whole, length / least_elements(MODES), _stiffness_at_ends(beams, whole))
    _, body, _, _ = _weighed(beams, mesh, 0)
    return _without_modes(beams, length, mesh, body)


def _without_modes(beams: Beams, length: Array, mesh: Mesh, body: tuple[Array, Array, Array, Array]) -> BendingBatch:
    """Return the batch of beams with this mass, first moment, moment of inertia and roll, and no mode."""
    none = np.zeros((len(beams), 0))
    mass, moment, moi_cm, roll = body
    return BendingBatch(
        length=length,
        mass=mass,
        balance_point=moment / mass,
        moi_cm=moi_cm,
        roll_moi=roll,
        omega=none,
        damping_ratio=beams.damping_ratio,
        mesh=mesh,
        coefficients=np.zeros((len(mesh.left), 5, 0)),
        left_out=none,
        sampled_at=none,
        corner=np.zeros(len(beams), np.int64),
    )


def joined_batches(parts: list[BendingBatch]) -> BendingBatch:
    """Return batches one after the other."""
    if len(parts) == 1:
        return parts[0]
    meshes = [part.mesh for part in parts]
    offsets = np.cumsum([0, *(len(mesh.ends) for mesh in meshes)])
    firsts = [mesh.first[:-1] + offset for mesh, offset in zip(meshes, offsets[:-1], strict=True)]
    mesh = Mesh(np.concatenate([mesh.ends for mesh in meshes]), np.concatenate([*firsts, offsets[-1:]]))
    names = [name for name in BendingBatch.__dataclass_fields__ if name != "mesh"]
    return BendingBatch(**{name: np.concatenate([getattr(part, name) for part in parts]) for name in names}, mesh=mesh)


class _Vibrating(NamedTuple):
    """Beams on their elements: squared angular frequencies as drawn, (rad/s)^2, and all that they came from."""

    whole: Mesh
    plain: Mesh
    stiffness_at_ends: Array
    mesh: Mesh
    body: tuple[Array, Array, Array, Array]
    points: Points
    squares: Array
    coefficients: Array


def _vibrating(beams: Beams, count: int, elements: int, start: int) -> _Vibrating:
    whole, plain = beams.ends()
    at_ends = _stiffness_at_ends(beams, whole)
    mesh = _elements(whole, _length(plain) / elements, at_ends)
    at, body, lumps, places = _weighed(beams, mesh, start)
    points = Points(lumps.mass, lumps.moi, lumps.position, _nodes(mesh, lumps))
    sections = (
        part.reshape(places.shape) for part in (at.mass, at.rotary_inertia, at.bending_stiffness, at.shear_stiffness)
    )
    squares, coefficients = np.empty((len(beams), count)), np.empty((len(mesh.left), 5, count))
    failed = bend(Elements(mesh.first_piece, mesh.width, *sections), mesh.left, points, body[0], squares, coefficients)
    if failed >= 0:
        raise InputError(f"bat {start + failed} has no bending modes; its mass and stiffness must be above zero")
    return _Vibrating(whole, plain, at_ends, mesh, body, points, squares, coefficients)


def _stiffening(beams: Beams, drawn: _Vibrating, elements: int, start: int) -> Array:
    """Return the factors, shape (beams,), of stiffnesses that are known up to them; 1 where all is known.

    A frequency was measured before any weights were added, so mode 1 of the beam without them has it.
    """
    measured = beams.as_measured()
    bare = drawn if measured is beams else _vibrating(measured, 1, elements, start)
    return np.where(np.isnan(beams.frequency), 1.0, (2 * np.pi * beams.frequency) ** 2 / bare.squares[:, 0])


def _some(beams: Beams, count: int, elements: int, start: int) -> BendingBatch:
    drawn = _vibrating(beams, count, elements, start)
    mesh, length, coefficients = drawn.mesh, _length(drawn.plain), drawn.coefficients
    stiffening = _stiffening(beams, drawn, elements, start)
    squares = drawn.squares * stiffening[:, None]
    joint = joints(drawn.whole.left, drawn.stiffness_at_ends, drawn.whole.owner, beams=len(beams))
    sampled_at, corner = sample_places(length, joint)
    sampled = np.empty((*sampled_at.shape, count))
    shapes_at(mesh.first_piece, mesh.left, mesh.width, coefficients, sampled_at, sampled)
    slices = [drawn.plain.divided(length / number) for number in (CELLS, CELLS // 2)]
    slow = extrapolated(*(_slowly(beams, cut, drawn.points, sampled_at) for cut in slices)) / stiffening[:, None]
    left_out = slow - np.einsum("bpm,bm->bp", sampled**2, 1 / squares)
    bending = {"omega": np.sqrt(squares), "coefficients": coefficients, "left_out": left_out}
    return replace(_without_modes(beams, length, mesh, drawn.body), **bending, sampled_at=sampled_at, corner=corner)


def _length(plain: Mesh) -> Array:
    return np.asarray(plain.ends[plain.first[1:] - 1])


def _stiffness_at_ends(beams: Beams, whole: Mesh) -> Array:
    """Return the bending stiffness in N m^2 at the left and the right end of every smooth piece, shape (2, pieces)."""
    places = just_inside(whole.left, whole.width).T
    return beams.section_at(places.ravel(), np.repeat(whole.owner, 2)).bending_stiffness.reshape(-1, 2).T


def _elements(whole: Mesh, size: Array, at_ends: Array) -> Mesh:
    """Return the elements between the ends of what is smooth, with the stiffness there, no longer than a size in m."""
    return whole.divided(size, slack=SLACK, least=least_parts(at_ends, whole.width / size[whole.owner]))


def _weighed(
    beams: Beams, mesh: Mesh, start: int
) -> tuple[CrossSection, tuple[Array, Array, Array, Array], Lumps, Array]:
    """Return the sections at every element's Gauss points, what they weigh together, point masses, and the places."""
    nodes, weights = rule()
    width, lumps = mesh.width, beams.lumps
    places = mesh.left[:, None] + width[:, None] * (nodes + 1) / 2
    at = beams.section_at(places.ravel(), np.repeat(mesh.owner, GAUSS_POINTS))
    body = _bodies(at, places, width[:, None] * weights / 2, mesh.first_piece, lumps, beams.unplaced, start)
    return at, body, lumps, places


def _bodies(
    at: CrossSection, places: Array, weights: Array, first: IntArray, lumps: Lumps, unplaced: Array, start: int
) -> tuple[Array, Array, Array, Array]:
    """Return mass, first moment, moment about the balance point and roll of every beam."""

    def summed(density: Array) -> Array:
        return np.add.reduceat((density.reshape(places.shape) * weights).sum(axis=1), first[:-1])

    x = places.ravel()
    mass = summed(at.mass) + lumps.mass.sum(axis=1)
    if not mass.min() > 0:
        raise InputError(f"bat {start + int(np.argmin(mass))} weighs {mass.min():.4g} kg; allowed is more than 0")
    moment = summed(at.mass * x) + (lumps.mass * lumps.position).sum(axis=1) + unplaced[:, 0]
    second = summed(at.mass * x**2 + at.rotary_inertia) + unplaced[:, 1]
    second = second + (lumps.mass * lumps.position**2 + lumps.moi).sum(axis=1)
    roll = summed(at.roll_inertia) + lumps.roll_moi.sum(axis=1)
    return mass, moment, second - moment * (moment / mass), roll


def _nodes(mesh: Mesh, lumps: Lumps) -> IntArray:
    """Return the element end nearest to every point mass, counted from each beam's first."""
    nearest = np.zeros(lumps.mass.shape, np.int64)
    for beam, column in zip(*np.nonzero(lumps.mass != 0), strict=True):
        ends = mesh.ends[mesh.first[beam] : mesh.first[beam + 1]]
        nearest[beam, column] = np.argmin(np.abs(ends - lumps.position[beam, column]))
    return nearest


def _slowly(beams: Beams, slices: Mesh, points: Points, even: Array) -> Array:
    """Return the compliance under a slow push at places, m/N, shape (beams, places)."""
    most = int(np.diff(slices.first).max()) + even.shape[1]
    cells, counts = np.zeros((len(beams), most)), np.empty(len(beams), np.int64)
    merged(slices.first, slices.ends, even, cells, counts)
    used = np.arange(most) < counts[:, None]
    both = used[:, 1:]
    middle, width = ((cells[:, 1:] + cells[:, :-1]) / 2)[both], np.diff(cells, axis=1)[both]
    owner = np.repeat(np.arange(len(beams)), counts - 1)
    at = beams.section_at(middle, owner)
    first = np.concatenate([[0], np.cumsum(counts - 1)])
    compliance = np.empty_like(even)
    parts = (width, at.mass, at.rotary_inertia, at.bending_stiffness, at.shear_stiffness)
    give_slowly(first, middle, parts, points, even, compliance)
    return compliance


def even_splines(values: Array) -> Array:
    """Return cubic splines through values at even places from 0 to 1, shape (beams, places); see `cubic_spline`."""
    return np.asarray(cubic_spline(np.linspace(0.0, 1.0, values.shape[1]), values.T).coefficients)


def on_even_splines(coefficients: Array, part: Array) -> Array:
    """Return splines (4, pieces, beams) at parts 0..1 of their range, (beams, places) to the same shape."""
    pieces = coefficients.shape[1]
    piece = np.clip((part * pieces).astype(np.int64), 0, pieces - 1)
    t = part - piece / pieces
    beam = np.arange(len(part))[:, None]
    c = coefficients[:, piece, beam]
    return np.asarray(((c[0] * t + c[1]) * t + c[2]) * t + c[3])
