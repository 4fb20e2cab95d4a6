"""Many bats that one description may mean, reduced at once.

Their beams are each solved anew. What a ball feels of the surface (the dent of wood, the hoop modes of a wall) takes
far longer, is smooth in what is not known, and is therefore worked out for the bat as described and for every unknown
one standard deviation up and down: each deviation adds its slope and bend. Hoop modes change places as walls get
thicker, so they are followed by harmonic and by their order within it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sweetspot.calibration.unknowns import Unknown, deviated
from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import BendingBatch, bending_batch, joined_batches
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.dent import dent_compliance
from sweetspot.dynamics.hoop import hoop_modes
from sweetspot.dynamics.mode_assembly import all_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.patch import ByPatch, PatchLaw, patch_law
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array

Surface = Modes | ByPatch
"""What a ball feels besides the beam: hoop modes, or the dent of wood."""
UNFELT = ("knob_mass", "end_mass", "density_gradient")
"""Unknowns that change nothing of the surface."""


@dataclass(frozen=True)
class DrawnBats:
    """Many bats that may be meant, ready to be hit.

    Parameters
    ----------
    bending : mass properties and bending modes.
    surfaces : of the bat as described, then of every unknown one standard deviation up and down.
    deviations : of every bat in those standard deviations, shape (bats, unknowns).
    whole : of a bat of which nothing is unknown, all its motions; None: they are put together from the others.
    pressing : how many times as fast a hit presses as large a patch as this bat's ball, shape (bats, 1); None: once.
    """

    bending: BendingBatch
    surfaces: tuple[Surface, ...]
    deviations: Array
    whole: Modes | None = None
    pressing: Array | None = None

    def __len__(self) -> int:
        return len(self.bending)

    @cached_property
    def angular_frequency(self) -> Array:
        """Of rigid motions (0), bending and hoop modes, rad/s, shape (bats, n)."""
        if self.whole is not None:
            return np.tile(self.whole.angular_frequency, (len(self), 1))
        beams = np.pad(self.bending.omega, ((0, 0), (2, 0)))
        walls = [wall.angular_frequency[order] for wall, order in self._walls]
        return np.hstack([beams, self._deviated(walls)]) if walls else beams

    @cached_property
    def damping_rate(self) -> Array:
        """2 zeta omega in 1/s, shape (bats, n)."""
        if self.whole is not None:
            return np.tile(self.whole.damping_rate, (len(self), 1))
        rate = 2 * self.bending.damping_ratio[:, None] * self.bending.omega
        beams = np.pad(rate, ((0, 0), (2, 0)))
        walls = [wall.damping_rate[order] for wall, order in self._walls]
        return np.hstack([beams, self._deviated(walls)]) if walls else beams

    def shapes_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return the shapes at places (bats, places) in m, shape (bats, places, n); see `ReducedBats.shapes_at`."""
        speed = self._pressed(closing_speed)
        if self.whole is not None:
            return self.whole.shape_at(position, closing_speed=speed)
        beams = self.bending.shapes_at(position)
        walls = [wall.shape_at(position, closing_speed=speed)[..., order] for wall, order in self._walls]
        if not walls:
            return beams
        signed = [shape * np.where(np.sum(shape * walls[0], axis=(0, 1)) < 0, -1.0, 1.0) for shape in walls]
        return np.concatenate([beams, self._deviated(signed)], axis=2)

    def compliance_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return how far the surface gives way at once, m/N at places (bats, places) in m; never below zero."""
        speed = self._pressed(closing_speed)
        if self.whole is not None:
            return self.whole.compliance_at(position, closing_speed=speed)
        give = self.bending.left_out_at(position)
        parts: list[Array] = []
        for surface in self.surfaces:
            if isinstance(surface, ByPatch):
                parts.append(surface(position, speed))
            else:
                parts.append(surface.compliance_at(position, closing_speed=speed))
        if parts:
            give = give + self._deviated(parts)
        return np.asarray(np.maximum(give, 0.0))

    def _pressed(self, closing_speed: Array | None) -> Array | None:
        return closing_speed if closing_speed is None or self.pressing is None else closing_speed * self.pressing

    @cached_property
    def _walls(self) -> list[tuple[Modes, Sequence[int]]]:
        """Walls with the order in which their modes are those of the first."""
        walls = [surface for surface in self.surfaces if isinstance(surface, Modes)]
        return [(wall, _in_order(wall, walls[0])) for wall in walls]

    def _deviated(self, values: list[Array]) -> Array:
        """Return values of every bat: of the described one, with slope and bend of each deviation."""
        centre = np.asarray(values[0])
        found = np.broadcast_to(centre, (len(self), *centre.shape)) if centre.ndim == 1 else centre
        shape = (len(self), *(1,) * (found.ndim - 1))
        for number, (up, down) in enumerate(zip(values[1::2], values[2::2], strict=True)):
            off = self.deviations[:, number].reshape(shape)
            found = found + off * ((up - down) / 2) + off**2 * ((up + down) / 2 - centre)
        return np.asarray(found)


def drawn_bats(
    line: BeamModel,
    unknowns: Sequence[Unknown],
    deviations: Array,
    *,
    spreads: Array,
    ball: Ball,
    threads: int | None = None,
) -> DrawnBats:
    """Return bats that deviate from a description.

    Parameters
    ----------
    line : the bat as described.
    deviations : of every bat, shape (bats, unknowns).
    spreads : one standard deviation of each, shape (unknowns,).
    ball : whose patch presses the surface.
    threads : workers; None: one per core.
    """
    law, sizes = patch_law(ball), np.maximum(spreads, 1e-12)
    if not unknowns:
        same = bending_batch(BeamRow([line]), threads=1)
        return DrawnBats(joined_batches([same] * len(deviations)), (), deviations, all_modes(line, ball))
    lines = [deviated(line, unknowns, row) for row in deviations]
    own = _surface(line, law)
    surfaces: list[Surface] = [own]
    for one, step in zip(unknowns, np.diag(sizes), strict=True):
        ends = (deviated(line, unknowns, sign * step) for sign in (1.0, -1.0))
        surfaces += [own, own] if one.name in UNFELT else [_surface(end, law) for end in ends]
    return DrawnBats(bending_batch(BeamRow(lines), threads=threads), tuple(surfaces), deviations / sizes)


def _surface(line: BeamModel, law: PatchLaw) -> Surface:
    """Return what a ball feels besides the beam of a bat; see `all_modes`."""
    assert isinstance(line.bat, Bat)  # nothing is unknown of others
    return dent_compliance(line, law=law) if line.bat.shell is None else hoop_modes(line, law=law)


def _in_order(wall: Modes, first: Modes) -> list[int]:
    """Return the modes of a wall in the order of another's: of one family and harmonic, by frequency."""
    kinds = list(zip(first.families, first.harmonics, strict=True))
    own = list(zip(wall.families, wall.harmonics, strict=True))
    ranks = {kind: iter([index for index, other in enumerate(own) if other == kind]) for kind in set(kinds)}
    return [next(ranks[kind]) for kind in kinds]
