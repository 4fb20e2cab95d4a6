"""Bending modes as one would write them with scikit-fem: an Euler-Bernoulli beam of cubic Hermite elements."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.linalg
from skfem import Basis, BilinearForm, ElementLineHermite, MeshLine
from skfem.helpers import dd, ddot

from benchmarks.cases import Array
from sweetspot import BeamModel
from sweetspot.dynamics.beam import section


def frequencies(beam: BeamModel, edges: Array, count: int) -> Array:
    """Return the lowest ``count`` frequencies in Hz above the two rigid motions."""

    @BilinearForm  # type: ignore[untyped-decorator]
    def bending(u: Any, v: Any, w: Any) -> Any:
        return section(beam, np.asarray(w.x[0])).bending_stiffness * ddot(dd(u), dd(v))

    @BilinearForm  # type: ignore[untyped-decorator]
    def inertia(u: Any, v: Any, w: Any) -> Any:
        return section(beam, np.asarray(w.x[0])).mass * u * v

    basis = Basis(MeshLine(edges), ElementLineHermite(), intorder=8)
    stiffness, mass = bending.assemble(basis).toarray(), inertia.assemble(basis).toarray()
    squares = scipy.linalg.eigh(stiffness, mass, subset_by_index=[2, count + 1])[0]
    return np.asarray(np.sqrt(squares) / (2 * np.pi))
