"""Paddles that differ a little from one, by the motions of that one: no plate is solved anew for each.

A paddle with another mass, rim or core moves as K' and M' have it. On the line it moves by the shapes that are alike on
both sides, so K' and M' are taken in some dozens of those of the paddle as described: small matrices, smooth in all
that may differ. What they do not have bends so quickly that it yields at once, and goes as one over the core's
shear stiffness.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.over_face import OverFace
from sweetspot.dynamics.paddle_modes import (
    ODD_MODES,
    half_of,
    mesh_of,
    patch_shapes,
    vibrations_of,
)
from sweetspot.dynamics.plate import PlateMesh
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise

VIBRATIONS = 44
"""Even vibrations of the basis: q of a paddle off by a standard deviation in one thing is then within 5e-4 of its own,
in all at once within 2e-3."""


@dataclass(frozen=True)
class PaddleBasis:
    """The motions of a paddle, in which others like it are written.

    Parameters
    ----------
    shapes : translation, rotation and even vibrations under the ball's patch by the place on the line in m, 1/sqrt(kg).
    rest : compliance of all faster ones by the place, m/N.
    even, odd : the same motions, and the odd vibrations, at the nodes of half the plate, shape (nodes, n).
    """

    mesh: PlateMesh
    shapes: Piecewise
    rest: Piecewise
    even: Array
    odd: Array

    def matrices(self, paddle: Paddle) -> tuple[Array, Array, Array]:
        """Return K and M of a paddle of the same outline in the even motions, and the squares of odd frequencies.

        The latter by Rayleigh's quotient of the odd vibrations as they are.
        """
        half, odd = half_of(paddle, self.mesh, "even"), half_of(paddle, self.mesh, "odd")
        stiffness, inertia = (2 * self.even.T @ matrix @ self.even for matrix in (half.stiffness, half.inertia))
        above, below = (np.einsum("ni,nk,ki->i", self.odd, part, self.odd) for part in (odd.stiffness, odd.inertia))
        return stiffness, inertia, above / below


def basis_of(beam: BeamModel) -> PaddleBasis:
    """Return the motions of a paddle in which others like it are written."""
    paddle = beam.bat
    assert isinstance(paddle, Paddle)
    body, mesh = rigid_body(beam), mesh_of(paddle)
    even, odd = vibrations_of(paddle)
    nodes, odd_nodes = (half_of(paddle, mesh, symmetry).nodes for symmetry in ("even", "odd"))
    x = mesh.places[:, 0]
    rigid = np.stack([np.full(len(x), body.mass**-0.5), (x - body.balance_point) / body.moi_cm**0.5], axis=-1)
    whole = np.concatenate([rigid, even.vectors[:, :VIBRATIONS]], axis=1)
    pushed = patch_shapes(mesh, radius=paddle.patch)
    columns = np.einsum("rcn,nm->rcm", pushed, whole)
    quick = np.einsum("rcn,nm->rcm", pushed, even.vectors[:, VIBRATIONS:]) / even.omega[VIBRATIONS:]
    return PaddleBasis(
        mesh=mesh,
        shapes=OverFace.through(mesh.x, mesh.half_width, columns).middle,
        rest=OverFace.through(mesh.x, mesh.half_width, np.sum(quick**2, axis=-1)[..., None]).middle,
        even=whole[nodes],
        odd=odd.vectors[odd_nodes][:, :ODD_MODES],
    )
