"""Many paddles that one description may mean, each with its own motions.

Modes of a plate lie so close that they change places as mass, rim and core differ: none can be followed. What is
followed is stiffness and inertia in the motions of the paddle as described (`paddle_basis`), and each draw's motions
are solved in those.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.unknowns import as_described, deviated
from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import bending_batch, joined_batches
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.paddle_basis import PaddleBasis, basis_of
from sweetspot.dynamics.paddle_modes import EVEN_MODES, plate_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.bat_draws import DrawnBats, with_bodies
from sweetspot.uncertainty.implement_doubt import ImplementDoubt

RIGID = 2


@dataclass(frozen=True, kw_only=True)
class DrawnPaddles(DrawnBats):
    """Many paddles, ready to be hit on their line.

    Parameters
    ----------
    basis : motions in which theirs are written.
    omega : of all their even motions, rad/s, shape (paddles, n).
    vectors : of these in the basis, shape (paddles, n, n).
    odd_omega : rad/s, of the odd vibrations, shape (paddles, m).
    softer : compliance of the core over that of the described one's, shape (paddles,).
    """

    basis: PaddleBasis
    omega: Array
    vectors: Array
    odd_omega: Array
    softer: Array

    @property
    def angular_frequency(self) -> Array:
        """Of rigid motions (0), even vibrations, roll (0) and odd ones, rad/s, shape (paddles, n)."""
        roll = np.zeros((len(self.omega), 1))
        return np.hstack([self.omega[:, : RIGID + EVEN_MODES], roll, self.odd_omega])

    @property
    def damping_rate(self) -> Array:
        """2 zeta omega in 1/s, shape (paddles, n)."""
        assert self.whole is not None
        return 2 * float(self.whole.damping_ratio[RIGID]) * self.angular_frequency

    def shapes_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:  # noqa: ARG002 - one patch
        """Return the shapes at places (paddles, places) in m on the line, shape (paddles, places, n)."""
        even = self._shapes(position)[..., : RIGID + EVEN_MODES]
        return np.pad(even, ((0, 0), (0, 0), (0, 1 + self.odd_omega.shape[1])))

    def compliance_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:  # noqa: ARG002
        """Return the instantaneous compliance, m/N at places (paddles, places) in m on the line."""
        quick = slice(RIGID + EVEN_MODES, None)
        given = np.sum((self._shapes(position)[..., quick] / self.omega[:, None, quick]) ** 2, axis=-1)
        return np.asarray(given + self.softer[:, None] * np.asarray(self.basis.rest(position))[..., 0])

    def _shapes(self, position: Array) -> Array:
        return np.asarray(np.asarray(self.basis.shapes(position)) @ self.vectors)


def draw_paddles(beam: BeamModel, doubt: ImplementDoubt, normal: Array) -> DrawnBats:
    """Return paddles that deviate from a description.

    Parameters
    ----------
    normal : the independent standard normal numbers behind every paddle, shape (paddles, numbers).
    """
    unknowns, deviations = doubt.unknowns, normal @ doubt.factor.T
    sizes = np.maximum(np.sqrt(np.diag(doubt.covariance)), 1e-12)
    described = as_described(beam.bat)
    ends = [deviated(described, unknowns, sign * step) for step in np.diag(sizes) for sign in (1.0, -1.0)]
    basis = basis_of(beam)
    parts = [basis.matrices(end.bat) for end in (beam, *ends) if isinstance(end.bat, Paddle)]
    same = joined_batches([bending_batch(BeamRow([beam]), threads=1)] * len(deviations))
    plain = DrawnBats(same, (), deviations / sizes, plate_modes(beam))
    stiffness, inertia, odd = (_followed(plain.followed, [part[index] for part in parts]) for index in range(3))
    omega, vectors = _motions(stiffness, inertia)
    core = [unknown.name for unknown in unknowns].index("core_shear")
    drawn = DrawnPaddles(
        bending=same,
        surfaces=(),
        deviations=plain.deviations,
        whole=plain.whole,
        basis=basis,
        omega=omega,
        vectors=vectors,
        odd_omega=np.sqrt(np.maximum(odd, 0.0)),
        softer=np.exp(-deviations[:, core]),
    )
    return with_bodies(drawn, [rigid_body(model) for model in (beam, *ends)])


def _followed(follow: Callable[[Sequence[Array]], Array], values: Sequence[Array]) -> Array:
    """Return arrays of any shape followed by slope and bend, shape (paddles, ...)."""
    shape = values[0].shape
    return follow([value.ravel() for value in values]).reshape(-1, *shape)


def _motions(stiffness: Array, inertia: Array) -> tuple[Array, Array]:
    """Return angular frequencies and vectors of all motions, translation and rotation first, of 1 kg each.

    ``stiffness``, ``inertia``: shape (paddles, n, n), whose first two coordinates are translation and a rotation.
    """
    lower = np.linalg.cholesky(inertia)
    half = np.linalg.solve(lower, stiffness)
    squares, vectors = np.linalg.eigh(np.linalg.solve(lower, np.swapaxes(half, 1, 2)))
    vectors = np.linalg.solve(np.swapaxes(lower, 1, 2), vectors)
    unit = np.eye(stiffness.shape[1])
    along = unit[0] / np.sqrt(inertia[:, :1, 0])
    turning = unit[1] - np.einsum("di,di->d", along, inertia[:, 1])[:, None] * along
    turning /= np.sqrt(np.einsum("di,dij,dj->d", turning, inertia, turning))[:, None]
    vectors[:, :, 0], vectors[:, :, 1] = along, turning
    squares[:, :RIGID] = 0.0
    return np.sqrt(np.maximum(squares, 0.0)), vectors
