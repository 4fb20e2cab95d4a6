"""What may be changed about a bat, and how numbers become bats."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from sweetspot.dynamics.batch.beams import BeamRow, Beams
from sweetspot.dynamics.batch.reduction import ReducedBats, reduced_beams
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import format_length

DENSITY_SPREAD, MODULUS_SPREAD = 0.05, 0.08
"""Standard deviations of wood of one species, as parts: of density, and of the moduli at one density (assumed)."""


@dataclass(frozen=True)
class Variable:
    """One number that may be changed.

    Parameters
    ----------
    name : for programs: letters, digits and underscores.
    scale : how it is shown: length, ratio, mass, ...
    low, high : its range, SI.
    from_tip : m; where on the bat it is; None: nowhere.
    """

    name: str
    label: str
    scale: str
    low: float
    high: float
    start: float
    from_tip: float | None = None

    def __post_init__(self) -> None:
        if not self.low < self.high:
            where = "" if self.from_tip is None else f" {format_length(self.from_tip)} from the tip"
            raise InputError(
                f"{self.label}{where} may go from {self.low:.4g} to {self.high:.4g}; give a range with some width"
            )


def ranges(variables: Sequence[Variable]) -> tuple[Array, Array]:
    """Return the least and the greatest of every variable, shape (variables,) each."""
    return np.array([variable.low for variable in variables]), np.array([variable.high for variable in variables])


class Space(Protocol):
    """Bats that a few numbers describe."""

    @property
    def variables(self) -> tuple[Variable, ...]:
        """The numbers, in the order of every array."""

    @property
    def present(self) -> Implement:
        """The bat that the batter swings now."""

    def beams(self, numbers: Array) -> Beams:
        """Return the bats of many rows of numbers (n, variables) as beams."""

    def reduced(self, numbers: Array, *, ball: Ball) -> ReducedBats:
        """Return the bats of many rows of numbers (n, variables), ready to be hit."""

    def shapes(self, numbers: Array) -> dict[str, Array]:
        """Return the sizes of the outlines, by measure, each of shape (n,)."""

    def widths_at(self, numbers: Array, position: Array) -> Array:
        """Return the widths at places (n, places) in m from the end of the grip."""

    @property
    def start(self) -> Array:
        """The numbers nearest to the present bat, shape (variables,)."""

    def made(self, numbers: Array, name: str) -> Implement:
        """Return one bat, to be turned, measured and read by everybody else."""


@dataclass(frozen=True)
class ImplementSpace:
    """Hollow bats, rackets, clubs, cricket bats: a few numbers of their own, set by functions.

    ``change``: makes an implement of the present one and the numbers, shape (variables,).
    """

    present: Implement
    variables: tuple[Variable, ...]
    change: Callable[[Implement, Array], Implement]

    def all_made(self, numbers: Array) -> Sequence[Implement]:
        """Return the implements of many rows of numbers."""
        return [self.change(self.present, row) for row in np.asarray(numbers, float)]

    def beams(self, numbers: Array) -> BeamRow:
        """Return the implements of many rows of numbers (n, variables) as beams."""
        return BeamRow([beam_model(implement) for implement in self.all_made(numbers)])

    def reduced(self, numbers: Array, *, ball: Ball) -> ReducedBats:
        """Return the implements of many rows of numbers (n, variables), ready to be hit."""
        return reduced_beams(self.beams(numbers).beams, ball=ball)

    def shapes(self, numbers: Array) -> dict[str, Array]:
        """Return the sizes of the outlines, by measure, each of shape (n,)."""
        made = [sizes_of(implement) for implement in self.all_made(numbers)]
        return {name: np.array([implement[name] for implement in made]) for name in made[0]}

    def widths_at(self, numbers: Array, position: Array) -> Array:
        """Return the widths at places (n, places) in m from the butt end."""
        return np.array(
            [implement.width_at(row) for implement, row in zip(self.all_made(numbers), position, strict=True)]
        )

    def made(self, numbers: Array, name: str) -> Implement:
        """Return one implement."""
        return self.change(self.present, numbers).replaced(name=name)

    @property
    def start(self) -> Array:
        """The numbers of the present implement, shape (variables,)."""
        return np.array([variable.start for variable in self.variables])


def sizes_of(implement: Implement) -> dict[str, float]:
    """Return the sizes of an outline that leagues limit, by measure, m: lengths, and a barrel's or blade's sizes."""
    largest = {"length": implement.length}
    if isinstance(implement, Bat):
        largest["diameter"] = float(implement.width_at(np.array(implement.breakpoints())).max())
    if isinstance(implement, CricketBat):
        sizes = {"blade_width": implement.width, "blade_depth": implement.spine, "blade_edge": implement.edge}
        largest |= {name: max(size for _, size in stations) for name, stations in sizes.items()}
    return largest
