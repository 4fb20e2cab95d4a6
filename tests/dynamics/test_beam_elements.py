"""Elements of a line beside scikit-fem's of the same kind."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.dynamics.batch.mesh import polynomials
from tests.dense_bending import Basis, gauss_places

EDGES = np.array([0.0, 0.1, 0.13, 0.4, 0.86])


@pytest.mark.parametrize("degree", [1, 3, 4])
def test_functions_and_unknowns_are_those_of_scikit_fem(degree: int) -> None:
    skfem = pytest.importorskip("skfem")
    ours = Basis(EDGES, degree)
    theirs = skfem.Basis(skfem.MeshLine(EDGES), skfem.ElementLinePp(degree), intorder=10)
    places, weights = gauss_places(EDGES)
    assert theirs.global_coordinates()[0] == pytest.approx(places)
    assert theirs.dx == pytest.approx(weights)
    order = [0, *range(2, degree + 1), 1]  # there both ends come first
    values = np.array([theirs.basis[i][0] for i in order])
    slopes = np.array([theirs.basis[i][0].grad[0] for i in order])
    assert values.transpose(1, 2, 0) == pytest.approx(np.asarray(ours.values), abs=1e-12)
    assert slopes.transpose(1, 2, 0) == pytest.approx(ours.slopes, abs=1e-10)
    assert ours.size == theirs.N
    assert len(np.unique(np.stack([ours.numbers, theirs.element_dofs[order].T]).reshape(2, -1), axis=1).T) == theirs.N


def test_what_is_inside_vanishes_at_the_ends() -> None:
    for function in polynomials(4)[1:-1]:
        assert [function(-1.0), function(1.0)] == pytest.approx([0.0, 0.0], abs=1e-15)


def test_a_polynomial_of_the_degree_is_kept() -> None:
    """Least squares on the Gauss points give x^4 back, element by element: exact."""
    basis = Basis(EDGES, 4)
    places, _ = gauss_places(EDGES)
    rows = np.zeros((places.size, basis.size))
    for element, numbers in enumerate(basis.numbers):
        rows[6 * element : 6 * element + 6, numbers] = basis.values[element]
    fitted, *_ = np.linalg.lstsq(rows, places.ravel() ** 4, rcond=None)
    local = basis.local_polynomials(np.asarray(fitted[:, None], np.float64))[:, :, 0]
    t = 0.3
    here = EDGES[:-1] + t * np.diff(EDGES)
    assert t ** np.arange(4, -1, -1) @ local == pytest.approx(here**4, abs=1e-12)
    assert basis.number_at(0.39) == basis.numbers[2, -1] == basis.numbers[3, 0]
