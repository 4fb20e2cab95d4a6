"""Input of a batch: many beams, from outlines side by side or from any implements one by one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Protocol

import numpy as np

from sweetspot.dynamics.batch.mesh import CLOSEST, Mesh, apart, mesh_of
from sweetspot.dynamics.beam import BeamModel, section
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import CrossSection, of_solid
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array, IntArray

APART = 4.0
"""m by which beams stand apart when all are looked up in one row; longer than any of them."""


@dataclass(frozen=True)
class Lumps:
    """Point masses of beams: m, kg and kg m^2 (across and about the line), shapes (beams, k); mass 0: none there."""

    position: Array
    mass: Array
    moi: Array
    roll_moi: Array


class Beams(Protocol):
    """Many beams."""

    def __len__(self) -> int:
        """Return the number of beams."""

    @property
    def lumps(self) -> Lumps:
        """Their point masses."""

    @property
    def unplaced(self) -> Array:
        """First and second moment measured beyond the distribution, kg m and kg m^2, shape (beams, 2)."""

    @property
    def damping_ratio(self) -> Array:
        """Fractions of critical damping of the bending modes, shape (beams,)."""

    @property
    def frequency(self) -> Array:
        """Measured frequencies in Hz of the first mode; nan: not known; shape (beams,)."""

    def ends(self) -> tuple[Mesh, Mesh]:
        """Return the ends of what is smooth: point masses among them, and without."""

    def section_at(self, position: Array, owner: IntArray) -> CrossSection:
        """Return the sections at places in m of the beams whose numbers ``owner`` are, in rising order."""

    def as_measured(self) -> Beams:
        """Return them as their frequencies were measured: before weights were added; themselves where none was."""

    def part(self, which: slice) -> Beams:
        """Return some of them."""


@dataclass(frozen=True)
class SolidBats:
    """Solid round bats of one material, their outlines side by side.

    Raises `InputError` when an outline goes back on itself, is thinner than nothing, or its cup is wider than the wood
    around it.

    Parameters
    ----------
    material : of all of them.
    position, diameter : stations from the knob end to the tip, m, shape (bats, stations), straight lines between.
    density_factor, stiffness_factor : density and moduli over the material's own, shape (bats,).
    cup_diameter, cup_depth : m, 0 for a bat without a cup, shape (bats,).
    weight_position, weight_mass : small weights fixed to the bats, m and kg, shape (bats, k).
    """

    material: Material
    position: Array
    diameter: Array
    density_factor: Array
    stiffness_factor: Array
    cup_diameter: Array
    cup_depth: Array
    weight_position: Array
    weight_mass: Array

    def __post_init__(self) -> None:
        folded = np.argwhere(~(np.diff(self.position, axis=1) > CLOSEST))
        if len(folded):
            bat, place = folded[0]
            raise InputError(
                f"the outline of bat {bat} folds: its station at {self.position[bat, place]:.4g} m is followed by one "
                f"at {self.position[bat, place + 1]:.4g} m; list stations from the knob end outwards"
            )
        thin = np.argwhere(~(self.diameter > 0))
        if len(thin):
            bat, place = thin[0]
            raise InputError(
                f"bat {bat} is {self.diameter[bat, place] * 1e3:.3g} mm thick at {self.position[bat, place]:.4g} m; "
                "allowed is more than 0"
            )
        wide = np.flatnonzero(self.cup_diameter >= self.diameter[:, -1])
        if len(wide):
            bat = wide[0]
            raise InputError(
                f"the cup of bat {bat} is {self.cup_diameter[bat] * 1e3:.4g} mm wide but the bat there only "
                f"{self.diameter[bat, -1] * 1e3:.4g} mm; make it narrower"
            )

    def __len__(self) -> int:
        return len(self.position)

    @property
    def length(self) -> Array:
        """Lengths in m, shape (bats,)."""
        return self.position[:, -1]

    @property
    def lumps(self) -> Lumps:
        """Their small weights."""
        nothing = np.zeros_like(self.weight_mass)
        return Lumps(self.weight_position, self.weight_mass, nothing, nothing)

    @property
    def unplaced(self) -> Array:
        """Zeros: nothing was measured."""
        return np.zeros((len(self), 2))

    @property
    def damping_ratio(self) -> Array:
        """Their material's."""
        return np.full(len(self), self.material.damping_ratio)

    @property
    def frequency(self) -> Array:
        """Not known."""
        return np.full(len(self), np.nan)

    def ends(self) -> tuple[Mesh, Mesh]:
        """Return the ends of what is smooth: point masses among them, and without."""
        cupped = np.where(self.cup_depth > 0, self.length - self.cup_depth, 0.0)[:, None]
        plain = np.concatenate([self.position, cupped], axis=1)
        weighted = np.where(self.weight_mass != 0, self.weight_position, 0.0)
        return _distinct(np.concatenate([plain, weighted], axis=1)), _distinct(plain)

    def section_at(self, position: Array, owner: IntArray) -> CrossSection:
        """Return the sections at places in m of the bats whose numbers ``owner`` are, in rising order."""
        rows = APART * np.arange(len(self))[:, None]
        outer = np.interp(position + APART * owner, (self.position + rows).ravel(), self.diameter.ravel()) / 2
        with np.errstate(divide="ignore", invalid="ignore"):
            into_cup = 1 - (self.length[owner] - position) / self.cup_depth[owner]
        into_cup = np.where(self.cup_depth[owner] > 0, into_cup, 0.0)
        void = self.cup_diameter[owner] / 2 * np.sqrt(np.maximum(into_cup, 0.0))
        solid = of_solid(self.material, outer=outer, void=void, inclusions=(), scale=self.density_factor[owner])
        stiffer = self.stiffness_factor[owner]
        return CrossSection(
            solid.mass,
            solid.rotary_inertia,
            solid.bending_stiffness * stiffer,
            solid.shear_stiffness * stiffer,
            solid.roll_inertia,
        )

    def as_measured(self) -> SolidBats:
        """Return the bats unchanged: nothing was measured."""
        return self

    def part(self, which: slice) -> SolidBats:
        """Return some of them."""
        return SolidBats(self.material, *(getattr(self, field.name)[which] for field in fields(self)[1:]))


@dataclass(frozen=True)
class BeamRow:
    """Any implements, reduced to beams one by one."""

    beams: Sequence[BeamModel]

    def __len__(self) -> int:
        return len(self.beams)

    @property
    def lumps(self) -> Lumps:
        """Everything that sits at one place."""
        most = max(len(beam.point_masses) for beam in self.beams)
        rows = np.zeros((4, len(self), most))
        for number, beam in enumerate(self.beams):
            for index, lump in enumerate(beam.point_masses):
                rows[:, number, index] = lump
        return Lumps(*rows)

    @property
    def unplaced(self) -> Array:
        """First and second moment measured beyond the distribution, kg m and kg m^2, shape (beams, 2)."""
        return np.array([beam.unplaced for beam in self.beams])

    @property
    def damping_ratio(self) -> Array:
        """Fractions of critical damping of the bending modes, shape (beams,)."""
        return np.array([beam.bat.damping_ratio for beam in self.beams])

    @property
    def frequency(self) -> Array:
        """Measured frequencies in Hz of the first mode; nan: not known; shape (beams,)."""
        return np.array([np.nan if beam.bat.frequency is None else beam.bat.frequency for beam in self.beams])

    def ends(self) -> tuple[Mesh, Mesh]:
        """Return the ends of what is smooth: point masses among them, and without."""
        plain = [beam.bat.breakpoints() for beam in self.beams]
        whole = [
            apart(sorted({*ends, *(lump.position for lump in beam.point_masses)}))
            for ends, beam in zip(plain, self.beams, strict=True)
        ]
        return mesh_of([np.array(ends) for ends in whole]), mesh_of([np.array(ends) for ends in plain])

    def section_at(self, position: Array, owner: IntArray) -> CrossSection:
        """Return the sections at places in m of the beams whose numbers ``owner`` are, in rising order."""
        borders = np.searchsorted(owner, np.arange(len(self) + 1))
        sections = [section(beam, position[borders[i] : borders[i + 1]]) for i, beam in enumerate(self.beams)]
        return CrossSection(
            *(np.concatenate([getattr(part, field.name) for part in sections]) for field in fields(CrossSection))
        )

    def as_measured(self) -> Beams:
        """Return them as their frequencies were measured: before weights were added; themselves where none was."""
        if not any(beam.bat.added and beam.bat.frequency is not None for beam in self.beams):
            return self
        return BeamRow(
            [
                replace(beam, bat=beam.bat.replaced(added=()), point_masses=beam.point_masses[: -len(beam.bat.added)])
                if beam.bat.added
                else beam
                for beam in self.beams
            ]
        )

    def part(self, which: slice) -> BeamRow:
        """Return some of them."""
        return BeamRow(self.beams[which])


def _distinct(ends: Array) -> Mesh:
    """Return rows of ends in rising order, without those that are as good as the one before; see `apart`."""
    ends = np.sort(ends, axis=1)
    inner = (np.diff(ends, axis=1)[:, :-1] > CLOSEST) & (ends[:, -1:] - ends[:, 1:-1] > CLOSEST)
    always = np.ones((len(ends), 1), bool)
    chosen = np.concatenate([always, inner, always], axis=1)
    return Mesh(ends[chosen], np.concatenate([[0], np.cumsum(chosen.sum(axis=1))]))
