"""The motions of a paddle as a sandwich plate: rigid, bending, and those of its face.

The head deflects under the ball as a membrane does, so a patch of some size pushes, not a point. Few modes are followed
in time; all the others are faster than any push by a ball, and what they add under the patch is there at once
(`Modes.compliances`): without it the face would be too stiff by half.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.modes import Family, Modes, Surface
from sweetspot.dynamics.over_face import OverFace
from sweetspot.dynamics.plate import (
    PlateHalf,
    PlateMesh,
    PlateProperties,
    Symmetry,
    along_edges,
    plate_half,
    turning_part,
    weights_at,
)
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.implement import AddedMass
from sweetspot.equipment.laminate import laminate_stiffness
from sweetspot.equipment.paddle import HANDLE_STIFFER, Paddle, SoftSpot
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import eigenpairs

COLUMNS = 12
"""Elements from the line to the edge; half as many again move the rebound by less than 0.001 of the incoming speed."""
EVEN_MODES, ODD_MODES = 26, 16
"""Vibrations that are followed in time, alike on both sides of the line and against each other."""
BENDING = 0.6
"""Part of a mode's kinetic energy in the mean motion of each row from which it is the paddle's bending, not its
face's [our choice]; the lowest always is."""
RINGS, SPOKES = 4, 12
"""Places of a patch at which its pressure is taken."""
SAMPLES = 8
"""Points each way in an element, by which the part of it inside a soft spot is counted."""


@dataclass(frozen=True)
class Clamp:
    """A clamp that turns freely and holds the handle as one rigid piece.

    Parameters
    ----------
    axis : m from the butt end, about which it turns.
    reach : m from the butt end, to where it holds the handle.
    moi : kg m^2 of its own about the axis, >= 0; 0: an axle alone.
    """

    axis: float
    reach: float
    moi: float


@dataclass(frozen=True)
class _Half:
    """Vibrations of one symmetry: deflections at the nodes of the half plate and angular frequencies, all of them."""

    vectors: Array
    omega: Array


def plate_modes(beam: BeamModel, *, patch_factor: float = 1.0, clamp: Clamp | None = None) -> Modes:
    """Return the motions of a paddle under the patch that a ball presses: hung freely, or held in a clamp.

    Parameters
    ----------
    beam : of a `Paddle`.
    patch_factor : on the radius of the patch, > 0.
    clamp : that holds the handle; None: the paddle is free.

    Returns
    -------
    Modes
        translation, rotation, the vibrations that are alike on both sides of the line, roll, and those that are not; in
        a clamp the rotation about its axis is the only rigid motion;
        families "bending" and "face", each with rising frequency for either symmetry.

    >>> from sweetspot import beam_model, catalog
    >>> modes = plate_modes(beam_model(catalog.implement("pickleball-paddle")))
    >>> modes.families[:3], bool(290 < modes.frequency[2] < 340)  # Hz, of the first bending mode
    (('rigid', 'rigid', 'bending'), True)
    """
    paddle = beam.bat
    assert isinstance(paddle, Paddle)
    body = rigid_body(beam)
    mesh = mesh_of(paddle)
    halves = _vibrations(paddle, clamp)
    pushed = _under_patches(mesh, radius=patch_factor * paddle.patch)
    shapes = {
        "even": np.einsum("rcn,nm->rcm", pushed["even"], halves["even"].vectors),
        "odd": np.einsum("rcn,nm->rcm", pushed["odd"], halves["odd"].vectors),
    }
    counts: dict[Symmetry, int] = {"even": EVEN_MODES, "odd": ODD_MODES}
    rest = sum(
        np.sum((shapes[kind][..., count:] / halves[kind].omega[count:]) ** 2, axis=-1) for kind, count in counts.items()
    )
    rigid = _rigid_shapes(mesh, body, clamp)
    rolls = rigid.shape[-1] - 1 if clamp is None else rigid.shape[-1]
    columns = np.concatenate(
        [rigid[..., :rolls], shapes["even"][..., :EVEN_MODES], rigid[..., rolls:], shapes["odd"][..., :ODD_MODES]],
        axis=-1,
    )
    columns = columns * _signs(columns)
    felt = OverFace.through(mesh.x, mesh.half_width, columns)
    slow = [np.zeros(rolls), np.zeros(rigid.shape[-1] - rolls)]
    omega = np.concatenate([slow[0], halves["even"].omega[:EVEN_MODES], slow[1], halves["odd"].omega[:ODD_MODES]])
    families, harmonics = _names(mesh, halves["even"], paddle, (len(slow[0]), len(slow[1])))
    count = len(omega)
    rigid_part = np.zeros((3, count))
    rigid_part[(0, 1, 2) if clamp is None else (1,), np.flatnonzero(omega == 0)] = 1.0

    def basis(position: Array, lateral: Array, closing_speed: Array | float | None) -> Array:  # noqa: ARG001 - its patch is given
        if not np.any(lateral):
            return np.zeros((*position.shape, count))
        off_line = felt(position, lateral) - np.asarray(felt.middle(position))
        return np.where(felt.holds(position, lateral)[..., None], off_line, 0.0)

    return Modes(
        families=families,
        harmonics=harmonics,
        frequency=omega / (2 * np.pi),
        damping_rate=2 * paddle.damping_ratio * omega,
        shapes=felt.middle,
        rigid_part=rigid_part,
        dashpots=np.zeros((0, count)),
        surface=Surface(basis, np.eye(count)),
        compliances=(OverFace.through(mesh.x, mesh.half_width, rest[..., None]),),
    )


def vibrations_of(paddle: Paddle) -> tuple[_Half, _Half]:
    """Return all vibrations of a free paddle, even and odd."""
    found = _vibrations(paddle, None)
    return found["even"], found["odd"]


def patch_shapes(mesh: PlateMesh, *, radius: float) -> Array:
    """Return how much of each node's deflection patches feel that is even; see `_under_patches`."""
    return _under_patches(mesh, radius=radius)["even"]


def mesh_of(paddle: Paddle, columns: int = COLUMNS) -> PlateMesh:
    """Return the elements over half of a paddle's outline."""
    places = np.array(paddle.breakpoints())
    return PlateMesh(places, paddle.width_at(places) / 2, columns)


def half_of(paddle: Paddle, mesh: PlateMesh, symmetry: Symmetry) -> PlateHalf:
    """Return half of a paddle's plate with its rim, its handle and what was added to it."""
    middles = mesh.places[mesh.elements].mean(axis=1)
    in_hand = middles[:, 0] < paddle.handle_length
    stiffer = np.where(in_hand, HANDLE_STIFFER, 1.0)
    shear = paddle.shear * stiffer
    if paddle.soft_spot is not None:
        shear = shear * (1 - (1 - paddle.soft_spot.factor) * _part_inside(mesh, paddle.soft_spot))
    handle = paddle.handle_mass / (paddle.handle_length * paddle.handle_width)
    properties = PlateProperties(
        bending=stiffer[:, None, None] * paddle.bending,
        shear=shear,
        mass=paddle.areal_mass + np.where(in_hand, handle, 0.0),
        inertia=np.full(len(middles), paddle.areal_inertia),
    )
    of_head = mesh.x[:-1] >= paddle.handle_length - 1e-9
    rows = np.concatenate([(mesh.x[:-1] + mesh.x[1:])[of_head] / 2, np.full(mesh.columns, paddle.length)])
    added = along_edges(mesh, np.concatenate([mesh.edge[of_head], mesh.tip]), paddle.rim_per_length(rows))
    for weight in paddle.added:
        added += _lead(mesh, weight)
    return plate_half(mesh, properties, added=added, symmetry=symmetry)


def _part_inside(mesh: PlateMesh, spot: SoftSpot) -> Array:
    """Return the part of every element that lies inside a soft spot, shape (elements,)."""
    one_way = (np.arange(SAMPLES) + 0.5) / SAMPLES
    along, across = (grid.ravel() for grid in np.meshgrid(one_way, one_way))
    shares = np.stack([(1 - along) * (1 - across), along * (1 - across), along * across, (1 - along) * across])
    places = np.einsum("kn,ekc->enc", shares, mesh.places[mesh.elements])
    inside = np.hypot(places[..., 0] - spot.position, places[..., 1]) <= spot.radius
    return np.asarray(inside.mean(axis=1))


def _lead(mesh: PlateMesh, weight: AddedMass) -> Array:
    """Return half of a small weight, the other half of which is on the other side of the line, between nodes."""
    nodes, shares = weights_at(mesh, np.array(weight.position), np.array(abs(weight.lateral)))
    matrix = np.zeros((len(mesh.places),) * 2)
    matrix[np.ix_(nodes, nodes)] = weight.mass / 2 * np.outer(shares, shares)
    return matrix


@lru_cache(maxsize=32)
def _vibrations(paddle: Paddle, clamp: Clamp | None) -> dict[Symmetry, _Half]:
    """Return all vibrations of a paddle by their symmetry, rigid motions left out, of 1 kg of modal mass."""
    mesh, found = mesh_of(paddle), dict[Symmetry, _Half]()
    kinds: tuple[tuple[Symmetry, int], ...] = (("even", 2), ("odd", 1)) if clamp is None else (("even", 1), ("odd", 0))
    for symmetry, rigid in kinds:
        half, to_nodes = half_of(paddle, mesh, symmetry), None
        if clamp is not None:
            half, to_nodes = turning_part(half, mesh, axis=clamp.axis, reach=clamp.reach, moi=clamp.moi)
        squares, vectors = eigenpairs(half.stiffness, half.inertia)
        deflections = vectors if to_nodes is None else to_nodes @ vectors
        whole = np.zeros((len(mesh.places), len(squares) - rigid))
        whole[half.nodes] = deflections[:, rigid:] / math.sqrt(2)  # the other half moves as much
        found[symmetry] = _Half(whole, np.sqrt(squares[rigid:]))
    return found


def _under_patches(mesh: PlateMesh, *, radius: float) -> dict[Symmetry, Array]:
    """Return how much of each node's deflection patches around rows and columns feel, (rows, 2 COLUMNS + 1, nodes).

    The pressure is Hertz's, sqrt(1 - (r / a)^2); what of a patch lies off the plate is left out, and the rest pushes.
    """
    x, half = mesh.x, mesh.half_width
    parts = np.linspace(-1.0, 1.0, 2 * mesh.columns + 1)
    along, across, pressure = _patch(radius)
    places = x[:, None, None] + along
    lateral = (half[:, None] * parts)[..., None] + across
    places = np.broadcast_to(places, lateral.shape)
    on = (places >= x[0]) & (places <= x[-1]) & (np.abs(lateral) <= np.interp(places, x, half))
    pushed = np.where(on, pressure, 0.0)
    centre = ~on.any(axis=-1)
    pushed = pushed / np.where(centre, 1.0, pushed.sum(axis=-1))[..., None]
    around, shares = weights_at(mesh, places, np.abs(lateral))
    result: dict[Symmetry, Array] = {}
    rows, columns = np.arange(len(x))[:, None, None, None], np.arange(len(parts))[:, None, None]
    kinds: tuple[tuple[Symmetry, Array], ...] = (("even", np.ones_like(lateral)), ("odd", np.sign(lateral)))
    for symmetry, sign in kinds:
        matrix = np.zeros((len(x), len(parts), len(mesh.places)))
        np.add.at(matrix, (rows, columns, around), (pushed * sign)[..., None] * shares)
        result[symmetry] = matrix
    return result


def _patch(radius: float) -> tuple[Array, Array, Array]:
    """Return places in m along and across from the middle of a patch, and the part of the push at each, shape (n,)."""
    nodes, weights = np.polynomial.legendre.leggauss(RINGS)
    rings = (nodes + 1) / 2
    share = weights * rings * np.sqrt(1 - rings**2)
    angle = 2 * np.pi * (np.arange(SPOKES) + 0.5) / SPOKES
    along, across = (radius * (rings[:, None] * turn(angle)).ravel() for turn in (np.cos, np.sin))
    return along, across, np.repeat(share / share.sum(), SPOKES) / SPOKES


def _rigid_shapes(mesh: PlateMesh, body: RigidBody, clamp: Clamp | None) -> Array:
    """Return the shapes of translation, rotation and roll at rows and columns, shape (rows, 2 columns + 1, 3).

    In a clamp that of the rotation about its axis alone, shape (rows, 2 columns + 1, 1).
    """
    lateral = mesh.half_width[:, None] * np.linspace(-1.0, 1.0, 2 * mesh.columns + 1)
    along = np.broadcast_to(mesh.x[:, None], lateral.shape)
    if clamp is not None:
        return (along - clamp.axis)[..., None] / math.sqrt(body.moi(clamp.axis) + clamp.moi)
    return np.stack(
        [
            np.full(lateral.shape, 1 / math.sqrt(body.mass)),
            (along - body.balance_point) / math.sqrt(body.moi_cm),
            lateral / math.sqrt(body.roll_moi),
        ],
        axis=-1,
    )


def _signs(columns: Array) -> Array:
    """Return the signs that make shapes (rows, columns, n) positive at the tip, on the line or else at its edge."""
    middle, edge = columns[-1, columns.shape[1] // 2], columns[-1, -1]
    at_tip = np.where(np.abs(middle) > 1e-9 * np.abs(columns).max(), middle, edge)
    return np.where(at_tip < 0, -1.0, 1.0)


def face_tone(paddle: Paddle) -> float:
    """Return the tone of a paddle's face in Hz, that people hear as its membrane [technicalpickleball_feel].

    It is the vibration of the family "face" that has the greatest part in the slow deflection of the face's middle,
    s_i^2 / omega_i^2; those that bend the paddle, which the hand feels, are left out.

    >>> from sweetspot import catalog
    >>> bool(900 < face_tone(catalog.implement("pickleball-paddle")) < 1000)
    True
    """
    mesh, even = mesh_of(paddle), _vibrations(paddle, None)["even"]
    nodes, shares = weights_at(mesh, np.array(paddle.outline.middle), np.array(0.0))
    families, _ = _names(mesh, even, paddle, (0, 0))
    of_face = np.array([family == "face" for family in families[:EVEN_MODES]])
    part = (shares @ even.vectors[nodes])[:EVEN_MODES] / even.omega[:EVEN_MODES]
    return float(even.omega[int(np.argmax(np.where(of_face, np.abs(part), 0.0)))] / (2 * np.pi))


def bending_tone(paddle: Paddle) -> float:
    """Return the lowest tone of a paddle hung freely in Hz, which bends it and which the hand feels.

    >>> from sweetspot import catalog
    >>> bool(290 < bending_tone(catalog.implement("pickleball-paddle")) < 340)
    True
    """
    return float(_vibrations(paddle, None)["even"].omega[0] / (2 * np.pi))


TIP_RADIUS = 0.014
"""m, of the tip that presses a face in the test of its deflection (assumed: about that of a coin)."""
DEFLECTED = 1.5875e-3
"""m, 1/16 in: the deflection whose force the test tells [technicalpickleball_power]."""


def face_stiffness(paddle: Paddle) -> float:
    """Return the stiffness in N/m of a face whose rim is held, pressed by a small tip in its middle.

    The plate, and in series with it the dent of one skin in the core, 1 / (8 sqrt(D 2 E / c)): a plate on an elastic
    foundation under a point load, core and skin on the far side standing still [zenkert1997].

    >>> from sweetspot import catalog
    >>> stiffness = face_stiffness(catalog.implement("pickleball-paddle"))
    >>> bool(45 < stiffness * DEFLECTED / 4.448 < 66)  # lbf for 1/16 in; the rules want 42 and more
    True
    """
    mesh = mesh_of(paddle)
    half = half_of(paddle, mesh, "even")
    rim = np.union1d(mesh.edge[mesh.x[:-1] >= paddle.handle_length - 1e-9], mesh.tip)
    free = ~np.isin(half.nodes, rim)
    middle = np.zeros(len(mesh.places))
    along, across, pressure = _patch(TIP_RADIUS)
    nodes, shares = weights_at(mesh, paddle.outline.middle + along, np.abs(across))
    np.add.at(middle, nodes, pressure[:, None] * shares)
    push = middle[half.nodes][free]
    plate = float(push @ np.linalg.solve(half.stiffness[np.ix_(free, free)], push)) / 2
    bending = float(laminate_stiffness(paddle.skin).bending[0, 0])
    dent = 1 / (8 * math.sqrt(bending * 2 * paddle.core_modulus / paddle.core_thickness))
    return 1 / (plate + dent)


def _names(
    mesh: PlateMesh, even: _Half, paddle: Paddle, rigid: tuple[int, int]
) -> tuple[tuple[Family, ...], tuple[int, ...]]:
    """Return families and numbers of all modes: bending where rows move as wholes, else of the face.

    Parameters
    ----------
    rigid : how many rigid motions come before those that are even, and before those that are odd.
    """
    inertia = half_of(paddle, mesh, "even").inertia
    rows = even.vectors[:, :EVEN_MODES].reshape(len(mesh.x), mesh.columns + 1, -1)
    weights = np.ones(mesh.columns + 1)
    weights[[0, -1]] = 0.5
    means = np.repeat(np.einsum("c,rcm->rm", weights / mesh.columns, rows), mesh.columns + 1, axis=0)
    bending = 2 * np.einsum("nm,nk,km->m", means, inertia, means) >= BENDING
    bending[0] = True
    names: list[Family] = ["bending" if bends else "face" for bends in bending]
    still: list[Family] = ["rigid"]
    odd: list[Family] = ["face"]
    families = [*still * rigid[0], *names, *still * rigid[1], *odd * ODD_MODES]
    seen = {"rigid": -1, "bending": 0, "face": 0}
    numbers = []
    for name in families:
        if name != "rigid":
            seen[name] += 1
        numbers.append(max(seen[name], 0))
    return tuple(families), tuple(numbers)
