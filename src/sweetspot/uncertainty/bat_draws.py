"""Many bats that one description may mean, reduced at once.

Their beams are followed from a few that are solved (`FollowedBeams`), or each solved where they are fewer. What a ball
feels of the surface (the dent of wood, the hoop modes of a wall) takes far longer, is smooth in what is not known, and
is therefore worked out for the bat as described and for every unknown one standard deviation up and down: each
deviation adds its slope and bend. Hoop modes change places as walls get
thicker, so they are followed by harmonic and by their order within it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sweetspot.calibration.unknowns import Unknown, as_described, deviated
from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import BendingBatch, bending_batch, joined_batches
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.hoop import OtherPatch, hoop_modes
from sweetspot.dynamics.local_compliance import solid_bat_compliance
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.patch import ByPatch, PatchLaw, patch_law
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.followed_beams import FollowedBeams, places_to_solve
from sweetspot.uncertainty.implement_doubt import ImplementDoubt

Surface = Modes | ByPatch
"""What a ball feels besides the beam: hoop modes, or the dent of wood."""
UNFELT = ("knob_mass", "end_mass", "knob_depth", "end_depth", "density_gradient", "balance_point", "gyration")
"""Unknowns that change nothing of the surface."""


@dataclass(frozen=True)
class DrawnBats:
    """Many bats that may be meant, ready to be hit.

    Parameters
    ----------
    surfaces : of the bat as described, then of every unknown one standard deviation up and down.
    deviations : of every bat in those standard deviations, shape (bats, unknowns).
    whole : of a bat of which nothing is unknown, and of any other implement, all motions as described; None: they are
        put together from the others.
    wholes : the same of every unknown of an implement that is no bat, one standard deviation up and down.
    pressing : how many times as fast a hit presses as large a patch as this bat's ball, shape (bats, 1); None: once.
    """

    bending: BendingBatch | FollowedBeams
    surfaces: tuple[Surface, ...]
    deviations: Array
    whole: Modes | None = None
    wholes: tuple[Modes, ...] = ()
    pressing: Array | None = None

    def __len__(self) -> int:
        return len(self.bending)

    @cached_property
    def angular_frequency(self) -> Array:
        """Of rigid motions (0), bending and hoop modes, rad/s, shape (bats, n)."""
        if self.whole is not None:
            return self.followed([modes.angular_frequency for modes in (self.whole, *self.wholes)])
        beams = np.pad(self.bending.omega, ((0, 0), (2, 0)))
        walls = [wall.angular_frequency[order] for wall, order in self.walls]
        return np.hstack([beams, self.followed(walls)]) if walls else beams

    @cached_property
    def damping_rate(self) -> Array:
        """2 zeta omega in 1/s, shape (bats, n)."""
        if self.whole is not None:
            return self.followed([modes.damping_rate for modes in (self.whole, *self.wholes)])
        rate = 2 * self.bending.damping_ratio[:, None] * self.bending.omega
        beams = np.pad(rate, ((0, 0), (2, 0)))
        walls = [wall.damping_rate[order] for wall, order in self.walls]
        return np.hstack([beams, self.followed(walls)]) if walls else beams

    def shapes_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return the shapes at places (bats, places) in m, shape (bats, places, n); see `ReducedBats.shapes_at`."""
        speed = self._pressed(closing_speed)
        if self.whole is not None:
            every = (self.whole, *self.wholes)
            return self.followed(_alike([modes.shape_at(position, closing_speed=speed) for modes in every]))
        beams = self.bending.shapes_at(position)
        if not self.walls:
            return beams
        weights = self._law.weights_at(speed)
        walls = self._each(lambda index: self._felt(index, position, weights))
        return np.concatenate([beams, self.followed(_alike(walls))], axis=2)

    def _felt(self, index: int, position: Array, weights: Array) -> Array:
        """Return the amplitudes of a wall's modes under a patch, in the first wall's order; see `ByPatch.weighted`."""
        wall, order = self.walls[index]
        assert wall.surface is not None and isinstance(wall.surface.basis, OtherPatch)  # of hoop modes
        return wall.surface.basis.felt.weighted(position, weights)[..., order]

    def compliance_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return the instantaneous compliance of the surface, m/N at places (bats, places) in m; never below zero."""
        speed = self._pressed(closing_speed)
        if self.whole is not None:
            every = (self.whole, *self.wholes)
            gives = [modes.compliance_at(position, closing_speed=speed) for modes in every]
            return np.asarray(np.maximum(self.followed(gives), 0.0))
        give = self.bending.left_out_at(position)
        if self.surfaces:
            weights = self._law.weights_at(speed)
            give = give + self.followed(self._each(lambda index: _given(self.surfaces[index], position, weights)))
        return np.asarray(np.maximum(give, 0.0))

    @cached_property
    def _law(self) -> PatchLaw:
        """By which the patch goes with the speed of a hit."""
        first = self.surfaces[0]
        gives = first if isinstance(first, ByPatch) else first.compliances[0]
        assert isinstance(gives, ByPatch)
        return gives.law

    def _each(self, evaluate: Callable[[int], Array]) -> list[Array]:
        """Return something of every surface, worked out once where an unknown changes nothing of it."""
        unique = {id(surface): index for index, surface in enumerate(self.surfaces)}
        values = {key: evaluate(index) for key, index in unique.items()}
        return [values[id(surface)] for surface in self.surfaces]

    def _pressed(self, closing_speed: Array | None) -> Array | None:
        return closing_speed if closing_speed is None or self.pressing is None else closing_speed * self.pressing

    @cached_property
    def walls(self) -> list[tuple[Modes, Sequence[int]]]:
        """Walls with the order in which their modes are those of the first."""
        walls = [surface for surface in self.surfaces if isinstance(surface, Modes)]
        return [(wall, _in_order(wall, walls[0])) for wall in walls]

    def followed(self, values: Sequence[Array]) -> Array:
        """Return values of every bat: of the described one, with slope and bend of each deviation.

        ``values``: of the bat as described, then of every unknown one standard deviation up and down: of one bat, shape
        (n,), or of every bat, shape (bats, ...).
        """
        centre = values[0]
        moved = np.broadcast_to(centre, (len(self), *centre.shape)) if centre.ndim == 1 else centre
        shape = (len(self), *(1,) * (moved.ndim - 1))
        for number, (up, down) in enumerate(zip(values[1::2], values[2::2], strict=True)):
            if up is centre and down is centre:
                continue
            off = self.deviations[:, number].reshape(shape)
            moved = moved + off * ((up - down) / 2) + off**2 * ((up + down) / 2 - centre)
        return np.asarray(moved)


def drawn_bats(
    beam: BeamModel, doubt: ImplementDoubt, normal: Array, *, ball: Ball, threads: int | None = None
) -> DrawnBats:
    """Return bats that deviate from a description.

    Parameters
    ----------
    normal : the independent standard normal numbers behind every bat, shape (bats, numbers).
    threads : workers; None: one per core.
    """
    unknowns, deviations = doubt.unknowns, normal @ doubt.factor.T
    law, sizes = patch_law(ball), np.maximum(np.sqrt(np.diag(doubt.covariance)), 1e-12)
    if not unknowns:
        same = bending_batch(BeamRow([beam]), threads=1)
        return DrawnBats(joined_batches([same] * len(deviations)), (), deviations, all_modes(beam, ball))
    if not isinstance(beam.bat, Bat):
        return _drawn_implements(beam, unknowns, deviations, sizes, ball)
    surface = _surface(beam, law)
    surfaces: list[Surface] = [surface]
    for unknown, step in zip(unknowns, np.diag(sizes), strict=True):
        ends = (deviated(beam, unknowns, sign * step) for sign in (1.0, -1.0))
        surfaces += [surface, surface] if unknown.name in UNFELT else [_surface(end, law) for end in ends]
    return DrawnBats(_drawn_beams(beam, doubt, normal, threads), tuple(surfaces), deviations / sizes)


def _drawn_beams(
    beam: BeamModel, doubt: ImplementDoubt, normal: Array, threads: int | None
) -> BendingBatch | FollowedBeams:
    """Return the beams of these numbers, followed where that means to solve fewer."""
    places = places_to_solve(normal.shape[1])
    followed = len(places) < len(normal)
    rows = (places if followed else normal) @ doubt.factor.T
    beams = [deviated(beam, doubt.unknowns, row) for row in rows]
    solved = bending_batch(BeamRow(beams), threads=threads)
    return FollowedBeams(solved, normal) if followed else solved


def _drawn_implements(
    beam: BeamModel, unknowns: Sequence[Unknown], deviations: Array, sizes: Array, ball: Ball
) -> DrawnBats:
    """Return implements that are no bats: weight, balance and all motions are followed by slope and bend."""
    described = as_described(beam.bat)
    ends = [deviated(described, unknowns, sign * step) for step in np.diag(sizes) for sign in (1.0, -1.0)]
    whole = all_modes(beam, ball)
    count = whole.families.count("bending")  # of all: one mode is followed only where every end has it
    wholes = tuple(all_modes(end, ball, count=count) for end in ends)
    same = joined_batches([bending_batch(BeamRow([beam]), threads=1)] * len(deviations))
    drawn = DrawnBats(same, (), deviations / sizes, whole, wholes)
    return with_bodies(drawn, [rigid_body(model) for model in (beam, *ends)])


def with_bodies(drawn: DrawnBats, bodies: Sequence[RigidBody]) -> DrawnBats:
    """Return implements with the followed mass, balance and moment of inertia of the described one and its ends."""
    mass, balance, moi = (
        drawn.followed([np.array([getattr(body, name)]) for body in bodies])[:, 0]
        for name in ("mass", "balance_point", "moi_cm")
    )
    assert isinstance(drawn.bending, BendingBatch)
    return replace(drawn, bending=replace(drawn.bending, mass=mass, balance_point=balance, moi_cm=moi))


def _alike(shapes: Sequence[Array]) -> list[Array]:
    """Return shapes of modes with the signs of the first's, whose modes they are; shape (bats, places, n) each."""
    first, alike = shapes[0], list(shapes)
    for number, shape in enumerate(shapes):
        against = np.einsum("bpn,bpn->n", shape, first) < 0
        if np.any(against):
            alike[number] = np.where(against, -shape, shape)
    return alike


def _surface(beam: BeamModel, law: PatchLaw) -> Surface:
    """Return the response of a bat's surface to a ball, besides that of the beam; see `all_modes`."""
    assert isinstance(beam.bat, Bat)  # others have their faces among all their modes
    return solid_bat_compliance(beam, law=law) if beam.bat.shell is None else hoop_modes(beam, law=law)


def _given(surface: Surface, position: Array, weights: Array) -> Array:
    """Return the instantaneous compliance of a surface, m/N; see `ByPatch.weighted`."""
    if isinstance(surface, ByPatch):
        return surface.weighted(position, weights)
    gives = [give.weighted(position, weights) for give in surface.compliances if isinstance(give, ByPatch)]
    return np.maximum(sum(gives, np.zeros_like(position)), 0.0)


def _in_order(wall: Modes, first: Modes) -> list[int]:
    """Return the modes of a wall in the order of another's: of one family and harmonic, by frequency."""
    kinds = list(zip(first.families, first.harmonics, strict=True))
    numbered = list(zip(wall.families, wall.harmonics, strict=True))
    ranks = {kind: iter([index for index, other in enumerate(numbered) if other == kind]) for kind in set(kinds)}
    return [next(ranks[kind]) for kind in kinds]
