"""Many bats reduced to the inputs of a collision: rigid body, modes, and the surface's instantaneous compliance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sweetspot.dynamics.batch.beams import BeamRow, SolidBats
from sweetspot.dynamics.batch.bending import BendingBatch, bending_batch, even_splines, on_even_splines
from sweetspot.dynamics.batch.mesh import MODES
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.face_vibration import face_modes
from sweetspot.dynamics.hoop import hoop_modes
from sweetspot.dynamics.local_compliance import PLACES, blade_compliance, round_compliance, solid_bat_compliance
from sweetspot.dynamics.modes import MOST_MODES, Modes, excited_frequency, joined
from sweetspot.dynamics.patch import ByPatch, PatchLaw, patch_law
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import cubic_spline
from sweetspot.numerics.threads import in_parts


@dataclass(frozen=True)
class ReducedBats:
    """Many bats, ready to be hit.

    Parameters
    ----------
    bending : mass properties and bending modes.
    local_compliance : of solid wood, m/N, at `PLACES` even places along every bat under patches of ``law``'s radii,
        shape (bats, places, radii); 0 for others.
    law : how the ball's patch goes with the closing speed.
    walls : what a hollow barrel or a striking face adds, one per bat; None: nothing.
    """

    bending: BendingBatch
    local_compliance: Array
    law: PatchLaw
    walls: tuple[Modes | None, ...]

    def __len__(self) -> int:
        return len(self.bending)

    @cached_property
    def angular_frequency(self) -> Array:
        """Of rigid motions (0), bending and hoop modes, rad/s, shape (bats, n); 0 too where a bat has fewer."""
        return self._padded(np.pad(self.bending.omega, ((0, 0), (2, 0))), "angular_frequency")

    @cached_property
    def damping_rate(self) -> Array:
        """2 zeta omega in 1/s, shape (bats, n)."""
        rate = 2 * self.bending.damping_ratio[:, None] * self.bending.omega
        return self._padded(np.pad(rate, ((0, 0), (2, 0))), "damping_rate")

    def shapes_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return the shapes at places (bats, places) in m, shape (bats, places, n), 1/sqrt(kg).

        Parameters
        ----------
        closing_speed : m/s of the hits that feel them, shape (bats, places); None: as at game speed.
        """
        beams = self.bending.shapes_at(position)
        if self._most == 0:
            return beams
        walls = np.zeros((*position.shape, self._most))
        for row, wall in enumerate(self.walls):
            if wall is not None:
                speed = None if closing_speed is None else closing_speed[row]
                walls[row, :, : len(wall)] = wall.shape_at(position[row], closing_speed=speed)
        return np.concatenate([beams, walls], axis=2)

    def compliance_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return the instantaneous compliance of the surface, m/N at places (bats, places) in m; never below zero."""
        give = self.bending.left_out_at(position)
        part, speed = position / self.bending.length[:, None], closing_speed
        local = np.stack([on_even_splines(spline, part) for spline in self._local_splines], axis=-1)
        give = give + np.sum(local * self.law.weights_at(speed), axis=-1)
        for row, wall in enumerate(self.walls):
            if wall is not None:
                give[row] += wall.give_at(position[row], closing_speed=None if speed is None else speed[row])
        return np.asarray(np.maximum(give, 0.0))

    def modes(self, number: int) -> Modes:
        """Return one bat's modes."""
        modes, wall = self.bending.modes(number), self.walls[number]
        if self.local_compliance[number].any():
            places = np.linspace(0.0, self.bending.length[number], PLACES)
            local_compliance = ByPatch(self.law, cubic_spline(places, self.local_compliance[number]))
            modes = replace(modes, compliances=(*modes.compliances, local_compliance))
        return modes if wall is None else joined(modes, wall)

    @cached_property
    def _local_splines(self) -> list[Array]:
        return [even_splines(values) for values in np.moveaxis(self.local_compliance, -1, 0)]

    @cached_property
    def _most(self) -> int:
        return max((len(wall) for wall in self.walls if wall is not None), default=0)

    def _padded(self, beams: Array, name: str) -> Array:
        walls = np.zeros((len(self), self._most))
        for row, wall in enumerate(self.walls):
            if wall is not None:
                walls[row, : len(wall)] = getattr(wall, name)
        return np.concatenate([beams, walls], axis=1)


def reduced_outlines(bats: SolidBats, *, ball: Ball, threads: int | None = None) -> ReducedBats:
    """Return solid bats, their outlines side by side, with their motions under the patch that this ball presses."""
    length = bats.length[:, None]
    rows = np.arange(len(bats))[:, None] * np.ones(PLACES)
    stations = bats.position / length + 2 * np.arange(len(bats))[:, None]
    places = np.linspace(0.0, 1.0, PLACES) + 2 * rows
    radius = np.interp(places, stations.ravel(), bats.diameter.ravel()) / 2
    law = patch_law(ball)
    local_compliance = round_compliance(bats.material, law.radii / radius[..., None], void=0.0) / radius[..., None]
    local_compliance = local_compliance / bats.stiffness_factor[:, None, None]
    return ReducedBats(bending_batch(bats, threads=threads), local_compliance, law, (None,) * len(bats))


def reduced_beams(
    beams: Sequence[BeamModel],
    *,
    ball: Ball,
    patch_factor: float = 1.0,
    count: int | None = None,
    threads: int | None = None,
) -> ReducedBats:
    """Return any implements, reduced to beams, with their motions under the patch that this ball presses.

    See `all_modes`: a face adds roll and its own mode, a hollow barrel its hoop modes; solid wood is dented. All get as
    many bending modes as the one of them that needs most.

    Parameters
    ----------
    threads : workers; None: one per core.
    """
    law = patch_law(ball, factor=patch_factor)
    local_compliance = np.zeros((len(beams), PLACES, len(law.radii)))
    walls, faces = dict[int, Modes](), dict[int, Modes]()

    def along(dented: ByPatch, beam: BeamModel) -> Array:
        return np.asarray(dented.tables(np.linspace(0.0, beam.bat.length, PLACES)))

    def work(part: slice) -> None:
        for number in range(part.start, part.stop):
            beam = beams[number]
            if beam.bat.face is not None:
                walls[number] = faces[number] = face_modes(beam, ball)
            elif isinstance(beam.bat, Bat) and beam.bat.shell is not None:
                walls[number] = hoop_modes(beam, law=law)
            if isinstance(beam.bat, CricketBat):
                local_compliance[number] = along(blade_compliance(beam, law=law), beam)
            elif isinstance(beam.bat, Bat) and beam.bat.shell is None:
                local_compliance[number] = along(solid_bat_compliance(beam, law=law), beam)

    in_parts(work, len(beams), size=4, threads=threads)
    bending, enough = bending_batch(BeamRow(beams), count=count or MODES, threads=threads), count or MODES
    wanted = {} if count else {i: excited_frequency(bending.modes(i), face, ball) for i, face in faces.items()}
    while enough < MOST_MODES and any(bending.frequency[number, -1] < least for number, least in wanted.items()):
        enough += MODES
        bending = bending_batch(BeamRow(beams), count=enough, threads=threads)
    return ReducedBats(bending, local_compliance, law, tuple(walls.get(i) for i in range(len(beams))))
