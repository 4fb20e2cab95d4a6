"""The sandwich plate against exact plates and membranes, and by its order of convergence."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot.dynamics.plate import PlateMesh, PlateProperties, Symmetry, along_edges, plate_half, weights_at
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import eigenpairs

SIDE, MASS = 0.4, 3.0
BENDING, POISSON = 100.0, 0.3


def square(cells: int) -> PlateMesh:
    """Return half of a square: ``cells`` along, half as many from the line to the edge."""
    return PlateMesh(np.linspace(0.0, SIDE, cells + 1), np.full(cells + 1, SIDE / 2), cells // 2)


def properties(mesh: PlateMesh, *, shear: float) -> PlateProperties:
    """Return an isotropic plate without rotary inertia."""
    count = len(mesh.elements)
    stiffness = BENDING * np.array([[1.0, POISSON, 0.0], [POISSON, 1.0, 0.0], [0.0, 0.0, (1 - POISSON) / 2]])
    return PlateProperties(
        np.broadcast_to(stiffness, (count, 3, 3)), np.full(count, shear), np.full(count, MASS), np.zeros(count)
    )


def frequencies(mesh: PlateMesh, *, shear: float, symmetry: Symmetry) -> Array:
    """Return the angular frequencies of half a free plate, rigid motions included, rad/s."""
    nothing = np.zeros((len(mesh.places),) * 2)
    half = plate_half(mesh, properties(mesh, shear=shear), added=nothing, symmetry=symmetry)
    return np.sqrt(np.maximum(eigenpairs(half.stiffness, half.inertia)[0], 0.0))


def test_a_thin_free_square_has_its_published_frequencies() -> None:
    """13.468, 19.596, 24.271 of omega a^2 sqrt(rho / D) at nu = 0.3 [other code: Ritz series]; first odd, then even."""
    mesh = square(24)
    size = SIDE**2 * math.sqrt(MASS / BENDING)
    odd, even = (frequencies(mesh, shear=1e7, symmetry=kind) for kind in ("odd", "even"))
    assert odd[1] * size == pytest.approx(13.468, rel=0.01)
    assert even[2] * size == pytest.approx(19.596, rel=0.01)
    assert even[3] * size == pytest.approx(24.271, rel=0.01)


def test_a_stiff_plate_without_shear_stiffness_is_a_membrane() -> None:
    """Exact: where D is large no normal tilts, and free edges have the tone 2 pi c / a, with c^2 = S / rho."""
    mesh = square(24)
    heavy = properties(mesh, shear=1.0)
    stiff = PlateProperties(heavy.bending * 1e4, heavy.shear, heavy.mass, heavy.inertia)
    half = plate_half(mesh, stiff, added=np.zeros((len(mesh.places),) * 2), symmetry="even")
    omega = np.sqrt(np.maximum(eigenpairs(half.stiffness, half.inertia)[0], 0.0))
    exact = 2 * math.pi / SIDE * math.sqrt(1.0 / MASS)
    assert np.abs(omega / exact - 1).min() < 0.01


@pytest.mark.parametrize("shear", [1e3, 1e7])
def test_frequencies_converge_with_the_square_of_the_elements(shear: float) -> None:
    """Exact: order 2, thick or thin."""
    coarse, middle, fine = (frequencies(square(cells), shear=shear, symmetry="even")[2] for cells in (8, 16, 32))
    order = math.log2((coarse - middle) / (middle - fine))
    assert 1.6 < order < 2.6


@pytest.mark.parametrize(("symmetry", "rigid"), [("even", 2), ("odd", 1)])
def test_rigid_motions_cost_nothing(symmetry: Symmetry, rigid: int) -> None:
    mesh = PlateMesh(np.array([0.0, 0.1, 0.15, 0.3, 0.4]), np.array([0.02, 0.02, 0.08, 0.1, 0.06]), 5)
    omega = frequencies(mesh, shear=1e4, symmetry=symmetry)
    assert (omega[:rigid] < 1e-3 * omega[rigid]).all() and omega[rigid] > 0


def test_masses_along_edges_add_up() -> None:
    """Exact: total, first moment along and second moment across of two straight edges."""
    mesh = PlateMesh(np.array([0.0, 0.3, 0.4]), np.array([0.1, 0.1, 0.05]), 4)
    matrix, lateral = along_edges(mesh, mesh.edge, 0.5), mesh.places[:, 1]
    length = 0.3 + math.hypot(0.1, 0.05)
    assert matrix.sum() == pytest.approx(0.5 * length)
    sloped = math.hypot(0.1, 0.05) * (0.1**2 + 0.1 * 0.05 + 0.05**2) / 3
    assert lateral @ matrix @ lateral == pytest.approx(0.5 * (0.3 * 0.1**2 + sloped))


def test_weights_reproduce_a_place() -> None:
    """Exact: the nodes' mean place, by their weights, is the place itself."""
    mesh = square(10)
    nodes, shares = weights_at(mesh, np.array([0.033, 0.4]), np.array([0.11, 0.2]))
    assert np.einsum("pk,pkx->px", shares, mesh.places[nodes]) == pytest.approx(np.array([[0.033, 0.11], [0.4, 0.2]]))
