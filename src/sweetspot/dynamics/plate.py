"""A sandwich plate that bends and shears, by finite elements on half of a symmetric outline.

Mindlin's plate: the deflection w and the tilts (f, g) of the normal along x and y store

    1/2 int k . D k + S (w_x - f)^2 + S (w_y - g)^2,   k = (f_x, g_y, f_y + g_x).

Elements have four nodes; their shear strain is taken from the middles of their sides, so that a thin plate does not
lock (MITC4 [bathe1985]). Tilts carry no load: they are condensed out (`PlateHalf`), with their rotary inertia.

Where waves are long against sqrt(D / S) a plate bends, where they are short it is a membrane under the tension S. A
paddle of soft core is a membrane nearly everywhere: D / S is a hundredth of a square metre or two.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray

Symmetry = Literal["even", "odd"]
"""Of the deflection across the line: alike on both sides, or against each other."""
GAUSS = 1 / np.sqrt(3.0)
CORNERS = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])


@dataclass(frozen=True)
class PlateMesh:
    """Quadrilaterals over half of an outline, in rows along x and columns from the line to the edge.

    Parameters
    ----------
    x : m, of every row, increasing, shape (rows,).
    half_width : m, from the line to the edge, shape (rows,).
    columns : number of elements across, >= 1.
    """

    x: Array
    half_width: Array
    columns: int

    @property
    def places(self) -> Array:
        """Places of the nodes in m, row after row, shape (nodes, 2)."""
        parts = np.linspace(0.0, 1.0, self.columns + 1)
        across = self.half_width[:, None] * parts
        return np.stack([np.broadcast_to(self.x[:, None], across.shape), across], axis=-1).reshape(-1, 2)

    @property
    def elements(self) -> IntArray:
        """The four nodes of every element, counterclockwise, shape (elements, 4)."""
        wide = self.columns + 1
        first = (np.arange(len(self.x) - 1)[:, None] * wide + np.arange(self.columns)).ravel()
        return np.stack([first, first + wide, first + wide + 1, first + 1], axis=1)

    @property
    def on_line(self) -> IntArray:
        """The nodes on the line of symmetry."""
        return np.arange(len(self.x)) * (self.columns + 1)

    @property
    def edge(self) -> IntArray:
        """Pairs of nodes along the outer edge, shape (rows - 1, 2)."""
        outer = self.on_line + self.columns
        return np.stack([outer[:-1], outer[1:]], axis=1)

    @property
    def tip(self) -> IntArray:
        """Pairs of nodes across the last row, shape (columns, 2)."""
        last = self.on_line[-1] + np.arange(self.columns + 1)
        return np.stack([last[:-1], last[1:]], axis=1)


@dataclass(frozen=True)
class PlateProperties:
    """Stiffness and mass of every element.

    Parameters
    ----------
    bending : D, N m, shape (elements, 3, 3).
    shear : S, N/m, shape (elements,).
    mass, inertia : kg/m^2 and kg, shape (elements,).
    """

    bending: Array
    shear: Array
    mass: Array
    inertia: Array


@dataclass(frozen=True)
class PlateHalf:
    """Half a plate whose deflection is even or odd across the line, by its deflections alone.

    Parameters
    ----------
    stiffness, inertia : shape (n, n), N/m and kg.
    nodes : which of the mesh's nodes deflect, shape (n,).
    """

    stiffness: Array
    inertia: Array
    nodes: IntArray


def plate_half(mesh: PlateMesh, properties: PlateProperties, *, added: Array, symmetry: Symmetry) -> PlateHalf:
    """Return half a plate with added masses; see the module.

    Parameters
    ----------
    added : kg, masses beside the plate's own between nodes of the half, shape (nodes, nodes).
    """
    count = len(mesh.places)
    stiffness, inertia = _assembled(mesh, properties)
    inertia[:count, :count] += added
    held = mesh.on_line + (2 * count if symmetry == "even" else 0)
    if symmetry == "odd":
        held = np.concatenate([held, mesh.on_line + count])
    free = np.setdiff1d(np.arange(3 * count), held)
    nodes = free[free < count]
    tilts = free[free >= count]
    follow = -np.linalg.solve(stiffness[np.ix_(tilts, tilts)], stiffness[np.ix_(tilts, nodes)])
    condensed = stiffness[np.ix_(nodes, nodes)] + stiffness[np.ix_(nodes, tilts)] @ follow
    mass = inertia[np.ix_(nodes, nodes)] + follow.T @ inertia[np.ix_(tilts, tilts)] @ follow
    return PlateHalf((condensed + condensed.T) / 2, (mass + mass.T) / 2, nodes)


def turning_part(half: PlateHalf, mesh: PlateMesh, *, axis: float, reach: float, moi: float) -> tuple[PlateHalf, Array]:
    """Return a half whose rows up to a place are one rigid piece that turns about an axis, and where its nodes are.

    Parameters
    ----------
    axis, reach : m, of the axis across the line, and to where the piece reaches.
    moi : kg m^2, what else turns with it; half of it belongs to this half.

    Returns
    -------
    tuple
        the half in the coordinates (the angle, if it is even, and the other nodes), and the matrix from them to the
        deflections of its nodes.
    """
    x, lateral = mesh.places[half.nodes].T
    inside = x <= reach + 1e-9
    even = bool(np.any(lateral == 0))
    others = np.flatnonzero(~inside)
    to_nodes = np.zeros((len(x), len(others) + even))
    to_nodes[others, np.arange(len(others)) + even] = 1.0
    if even:
        to_nodes[inside, 0] = x[inside] - axis
    stiffness, inertia = (to_nodes.T @ matrix @ to_nodes for matrix in (half.stiffness, half.inertia))
    if even:
        inertia[0, 0] += moi / 2
    return PlateHalf(stiffness, inertia, half.nodes), to_nodes


def _assembled(mesh: PlateMesh, properties: PlateProperties) -> tuple[Array, Array]:
    """Return stiffness and mass matrices of half a plate: all deflections, all tilts along, all tilts across."""
    places, elements = mesh.places, mesh.elements
    count = len(places)
    corners = places[elements]  # (e, 4, 2)
    stiff, heavy = np.zeros((len(elements), 12, 12)), np.zeros((len(elements), 12, 12))
    sides = _side_strains(corners)
    for xi in (-GAUSS, GAUSS):
        for eta in (-GAUSS, GAUSS):
            shape, slope = _shape_functions(xi, eta)
            jacobian = np.einsum("ka,ekb->eab", slope, corners)  # d(x, y) / d(xi, eta), rows xi and eta
            size = np.linalg.det(jacobian)
            inverse = np.linalg.inv(jacobian)
            gradient = np.einsum("eab,kb->eka", inverse, slope)
            curvature = np.zeros((len(elements), 3, 12))
            curvature[:, 0, 4:8] = gradient[:, :, 0]
            curvature[:, 1, 8:] = gradient[:, :, 1]
            curvature[:, 2, 4:8], curvature[:, 2, 8:] = gradient[:, :, 1], gradient[:, :, 0]
            low, high, left, right = sides
            natural = np.stack(
                [((1 - eta) * low + (1 + eta) * high) / 2, ((1 - xi) * left + (1 + xi) * right) / 2], axis=1
            )
            strain = np.einsum("eab,ebm->eam", inverse, natural)
            stiff += np.einsum("eam,eab,ebn,e->emn", curvature, properties.bending, curvature, size)
            stiff += np.einsum("eam,ean,e->emn", strain, strain, size * properties.shear)
            both = np.outer(shape, shape)
            for part, density in ((0, properties.mass), (4, properties.inertia), (8, properties.inertia)):
                heavy[:, part : part + 4, part : part + 4] += (size * density)[:, None, None] * both
    where = np.concatenate([elements, elements + count, elements + 2 * count], axis=1)
    stiffness, inertia = np.zeros((3 * count, 3 * count)), np.zeros((3 * count, 3 * count))
    rows, columns = np.repeat(where, 12, axis=1), np.tile(where, (1, 12))
    np.add.at(stiffness, (rows, columns), stiff.reshape(len(elements), -1))
    np.add.at(inertia, (rows, columns), heavy.reshape(len(elements), -1))
    return stiffness, inertia


def _shape_functions(xi: float, eta: float) -> tuple[Array, Array]:
    """Return the four shape functions and their slopes by xi and eta, shapes (4,) and (4, 2)."""
    along, across = 1 + CORNERS[:, 0] * xi, 1 + CORNERS[:, 1] * eta
    return along * across / 4, np.stack([CORNERS[:, 0] * across, CORNERS[:, 1] * along], axis=1) / 4


def _side_strains(corners: Array) -> tuple[Array, Array, Array, Array]:
    """Return the shear strain along the middles of the sides at eta = -1 and 1, and xi = -1 and 1, (elements, 12) each.

    Natural components: d w / d xi less the tilt along that side.
    """
    found = []
    for xi, eta, axis in ((0.0, -1.0, 0), (0.0, 1.0, 0), (-1.0, 0.0, 1), (1.0, 0.0, 1)):
        shape, slope = _shape_functions(xi, eta)
        along = np.einsum("k,ekb->eb", slope[:, axis], corners)
        strain = np.zeros((len(corners), 12))
        strain[:, :4] = slope[:, axis]
        strain[:, 4:8] = -along[:, :1] * shape
        strain[:, 8:] = -along[:, 1:] * shape
        found.append(strain)
    return found[0], found[1], found[2], found[3]


def along_edges(mesh: PlateMesh, pairs: IntArray, density: Array | float) -> Array:
    """Return the masses between nodes of a line of mass along edges of elements, shape (nodes, nodes), kg.

    Parameters
    ----------
    pairs : nodes at the ends of each edge, shape (edges, 2).
    density : kg/m, one or one for each edge.
    """
    places = mesh.places
    length = np.linalg.norm(places[pairs[:, 1]] - places[pairs[:, 0]], axis=1)
    matrix, part = np.zeros((len(places), len(places))), length * density / 6
    for first, second, times in ((0, 0, 2.0), (1, 1, 2.0), (0, 1, 1.0), (1, 0, 1.0)):
        np.add.at(matrix, (pairs[:, first], pairs[:, second]), times * part)
    return matrix


def weights_at(mesh: PlateMesh, position: Array, lateral: Array) -> tuple[IntArray, Array]:
    """Return the nodes around places on the half plate, and how much of each is there, shapes (..., 4).

    Parameters
    ----------
    position, lateral : m along, and from the line outwards, on the plate; those beyond it are moved to its edge.
    """
    row = np.clip(np.searchsorted(mesh.x, position, side="right") - 1, 0, len(mesh.x) - 2)
    along = np.clip((position - mesh.x[row]) / np.diff(mesh.x)[row], 0.0, 1.0)
    half = (1 - along) * mesh.half_width[row] + along * mesh.half_width[row + 1]
    across = np.clip(lateral / half, 0.0, 1.0) * mesh.columns
    column = np.minimum(across.astype(int), mesh.columns - 1)
    part = across - column
    first = row * (mesh.columns + 1) + column
    nodes = np.stack([first, first + 1, first + mesh.columns + 1, first + mesh.columns + 2], axis=-1)
    shares = np.stack([(1 - along) * (1 - part), (1 - along) * part, along * (1 - part), along * part], axis=-1)
    return nodes, shares
