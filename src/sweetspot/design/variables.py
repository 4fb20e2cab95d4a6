"""What may be changed about a bat, and how numbers become bats."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from sweetspot.design.outline_curve import GRIP, HANDLES, REFERENCE_LENGTH, diameters_of, stations, steepness, waist
from sweetspot.dynamics.batch.beams import BeamRow, Beams, SolidBats
from sweetspot.dynamics.batch.reduction import ReducedBats, reduced_lines, reduced_outlines
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import USUAL_CUP, WIDEST_CUP, Bat, Cup
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH

LEAST_CUP = 0.02 * INCH
"""m of depth below which a cup is left out."""
DENSITY_SPREAD, MODULUS_SPREAD = 0.05, 0.08
"""Standard deviations of wood of one species, as parts: of density, and of the moduli at one density (assumed)."""
REACH = 0.15
"""Part of its present diameter by which an outline may change at a handle, on the barrel; half of that on the grip."""


@dataclass(frozen=True)
class Variable:
    """One number that may be changed.

    Parameters
    ----------
    name : for programs: letters, digits and underscores.
    label : for people.
    scale : how it is shown: length, ratio, mass, ...
    low, high : its range, SI.
    start : of the present bat.
    """

    name: str
    label: str
    scale: str
    low: float
    high: float
    start: float

    def __post_init__(self) -> None:
        if not self.low < self.high:
            raise InputError(
                f"{self.label} may go from {self.low:.4g} to {self.high:.4g}; give a range with some width"
            )


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
        """Return what the outlines themselves say, by measure, each of shape (n,)."""

    def widths_at(self, numbers: Array, position: Array) -> Array:
        """Return the widths at places (n, places) in m from the end of the grip."""

    @property
    def start(self) -> Array:
        """The numbers nearest to the present bat, shape (variables,)."""

    def made(self, numbers: Array, name: str) -> Implement:
        """Return one bat, to be turned, measured and read by everybody else."""


@dataclass(frozen=True)
class TurnedSpace:
    """Turned wood bats: diameters at eleven handles, the cup's depth, and the density of the wood.

    Parameters
    ----------
    present : the batter's bat; its length, knob, species and width of cup are kept.
    variables : what may be changed; see `turned_space`.
    """

    present: Bat
    variables: tuple[Variable, ...]

    def parts(self, numbers: Array) -> tuple[Array, Array, Array]:
        """Return diameters at the handles (n, 11), depths of the cup and density factors, each (n,)."""
        count = len(HANDLES)
        return numbers[:, :count], numbers[:, count], numbers[:, count + 1]

    def outlines(self, numbers: Array, *, stiffness: Array | float = 1.0) -> SolidBats:
        """Return the outlines of many rows of numbers, side by side.

        Parameters
        ----------
        stiffness : moduli over the species' own, one for all or shape (n,).
        """
        diameters, depth, density = self.parts(np.asarray(numbers, float))
        count = len(diameters)
        length = np.full(count, self.present.length)
        place, diameter = stations(diameters, knob=np.full(count, self._knob), length=length)
        cupped = depth > LEAST_CUP
        nothing = np.zeros((count, 0))
        return SolidBats(
            self.present.material, place, diameter, density, np.broadcast_to(np.asarray(stiffness, float), (count,)),
            np.where(cupped, self._cups(diameter), 0.0), np.where(cupped, depth, 0.0), nothing, nothing,
        )  # fmt: skip

    def beams(self, numbers: Array) -> Beams:
        """Return the bats of many rows of numbers (n, variables) as beams."""
        return self.outlines(numbers)

    def reduced(self, numbers: Array, *, ball: Ball) -> ReducedBats:
        """Return the bats of many rows of numbers (n, variables), ready to be hit."""
        return reduced_outlines(self.outlines(numbers), ball=ball)

    def shapes(self, numbers: Array) -> dict[str, Array]:
        """Return greatest and smallest diameter, cup, slope and bend of the outlines, and their widths at places."""
        bats, (diameters, depth, density) = self.outlines(numbers), self.parts(numbers)
        slope, bend = steepness(diameters, length=bats.length)
        return {
            "length": bats.length,
            "diameter": bats.diameter.max(axis=1),
            "handle": diameters[:, :GRIP].min(axis=1),
            "cup_depth": depth,
            "cup_diameter": self._cups(bats.diameter),
            "slope": slope,
            "bend": bend,
            "waist": waist(diameters),
            "density": density,
        }

    def widths_at(self, numbers: Array, position: Array) -> Array:
        """Return the diameters at places (n, places) in m from the knob end."""
        bats = self.outlines(numbers)
        rows = 4.0 * np.arange(len(bats))[:, None]
        return np.interp(position + rows, (bats.position + rows).ravel(), bats.diameter.ravel())

    def made(self, numbers: Array, name: str) -> Bat:
        """Return one bat, to be turned, measured and read by everybody else; its weight fixes the wood's density."""
        bats = self.outlines(numbers[None])
        profile = tuple(zip(bats.position[0].tolist(), bats.diameter[0].tolist(), strict=True))
        cup = Cup(diameter=float(bats.cup_diameter[0]), depth=float(bats.cup_depth[0])) if bats.cup_depth[0] else None
        plain = Bat(
            name=name, sport=self.present.sport, length=self.present.length, material=self.present.material,
            profile=profile, cup=cup, choke=self.present.choke,
        )  # fmt: skip
        from sweetspot.dynamics.rigid import rigid_body

        return plain.with_mass(rigid_body(beam_model(plain)).mass * float(bats.density_factor[0]))

    @property
    def start(self) -> Array:
        """The numbers nearest to the present bat, shape (variables,)."""
        return np.array([one.start for one in self.variables])

    @property
    def _knob(self) -> float:
        return float(self.present.diameter_at(np.linspace(0.0, 0.03 * self.present.length, 31)).max())

    def _cups(self, diameter: Array) -> Array:
        """Return the widths of the cups: the present one's, or the usual, and no more than their tips allow."""
        wide = USUAL_CUP if self.present.cup is None else self.present.cup.diameter
        return np.minimum(wide, WIDEST_CUP * diameter[:, -1])


def turned_space(bat: Bat, *, deepest_cup: float = 1.0 * INCH, keep_grip: bool = False) -> TurnedSpace:
    """Return the space of turned bats around a batter's present one.

    Parameters
    ----------
    bat : of solid wood.
    deepest_cup : m; 0: no cup.
    keep_grip : whether the diameters under the hands stay as they are.

    Raises
    ------
    InputError
        when the bat is hollow, drilled, or given by its mass per length.
    """
    if bat.shell is not None or bat.bores or bat.profile is None or bat.material.family != "wood":
        raise InputError(
            f"{bat.name} is not turned from one piece of wood; give a solid bat with a profile to design outlines for"
        )
    place, diameter = np.array(bat.profile).T
    now = diameters_of(place, diameter, bat.length)
    variables = []
    for index, (part, size) in enumerate(zip(HANDLES, now, strict=True)):
        inches = (1 - part) * bat.length / INCH
        reach = REACH / 2 if index < GRIP else REACH
        reach = 0.002 if keep_grip and index < GRIP else reach
        variables.append(
            Variable(f"diameter_{index + 1}", f"diameter {inches:.1f} in from the tip", "length", size * (1 - reach),
                     size * (1 + reach), size)
        )  # fmt: skip
    cup = 0.0 if bat.cup is None else bat.cup.depth
    deepest = max(deepest_cup, cup, 1.1 * LEAST_CUP)
    variables.append(Variable("cup_depth", "depth of the cup", "length", 0.0, deepest, cup))
    light, heavy = bat.material.density_range or (0.95 * bat.material.density, 1.05 * bat.material.density)
    line = beam_model(bat)
    low, high = light / bat.material.density, heavy / bat.material.density
    variables.append(
        Variable(
            "density", "density, times the species' mean", "ratio", low, high, min(max(line.density_factor, low), high)
        )
    )
    return TurnedSpace(bat, tuple(variables))


@dataclass(frozen=True)
class ImplementSpace:
    """Hollow bats, rackets, clubs, cricket bats: a few numbers of their own, set by functions.

    Parameters
    ----------
    present : the implement as it is.
    variables : what may be changed.
    change : makes an implement of the present one and the numbers, shape (variables,).
    """

    present: Implement
    variables: tuple[Variable, ...]
    change: Callable[[Implement, Array], Implement]

    def all_made(self, numbers: Array) -> Sequence[Implement]:
        """Return the implements of many rows of numbers."""
        return [self.change(self.present, row) for row in np.asarray(numbers, float)]

    def beams(self, numbers: Array) -> BeamRow:
        """Return the implements of many rows of numbers (n, variables) as beams."""
        return BeamRow([beam_model(one) for one in self.all_made(numbers)])

    def reduced(self, numbers: Array, *, ball: Ball) -> ReducedBats:
        """Return the implements of many rows of numbers (n, variables), ready to be hit."""
        return reduced_lines(self.beams(numbers).lines, ball=ball)

    def shapes(self, numbers: Array) -> dict[str, Array]:
        """Return what the outlines themselves say, by measure, each of shape (n,)."""
        made = [sizes_of(one) for one in self.all_made(numbers)]
        return {name: np.array([one[name] for one in made]) for name in made[0]}

    def widths_at(self, numbers: Array, position: Array) -> Array:
        """Return the widths at places (n, places) in m from the butt end."""
        return np.array([one.width_at(row) for one, row in zip(self.all_made(numbers), position, strict=True)])

    def made(self, numbers: Array, name: str) -> Implement:
        """Return one implement."""
        return self.change(self.present, numbers).replaced(name=name)

    @property
    def start(self) -> Array:
        """The numbers of the present implement, shape (variables,)."""
        return np.array([one.start for one in self.variables])


def sizes_of(implement: Implement) -> dict[str, float]:
    """Return what leagues limit of an implement's outline, by measure, m: lengths, and a barrel's or blade's sizes."""
    found = {"length": implement.length}
    if isinstance(implement, Bat):
        found["diameter"] = float(implement.width_at(np.array(implement.breakpoints())).max())
    if isinstance(implement, CricketBat):
        sizes = {"blade_width": implement.width, "blade_depth": implement.spine, "blade_edge": implement.edge}
        found |= {name: max(size for _, size in stations) for name, stations in sizes.items()}
    return found


def hollow_space(bat: Bat) -> ImplementSpace:
    """Return the space of hollow bats like one: four thicknesses of the wall along the barrel, and the end cap.

    Raises
    ------
    InputError
        when the bat has no wall.
    """
    shell = bat.shell
    if shell is None:
        raise InputError(f"{bat.name} has no wall; give a hollow bat")
    places = bat.length - np.array([11.0, 8.0, 5.0, 2.0]) / REFERENCE_LENGTH * bat.length
    now = shell.wall_at(places)
    variables = [
        Variable(f"wall_{index + 1}", f"wall {(bat.length - place) / INCH:.1f} in from the tip", "compression",
                 0.8 * thick, 1.3 * thick, thick)
        for index, (place, thick) in enumerate(zip(places.tolist(), now.tolist(), strict=True))
    ]  # fmt: skip
    cap = shell.end_cap_mass
    variables.append(Variable("end_cap_mass", "mass of the end cap", "mass", 0.3 * cap, max(2 * cap, 0.03), cap))

    def change(implement: Implement, numbers: Array) -> Implement:
        assert isinstance(implement, Bat) and implement.shell is not None
        own = {place: thick for place, thick in implement.shell.wall if place < places[0] - 1e-9}
        wall = {
            **own,
            **dict(zip(places.tolist(), numbers[:4].tolist(), strict=True)),
            implement.length: float(numbers[3]),
        }
        changed = implement.shell.replaced(wall=tuple(sorted(wall.items())), end_cap_mass=float(numbers[4]))
        return implement.replaced(shell=changed, mass=None, balance_point=None, moi=None)

    return ImplementSpace(bat, tuple(variables), change)
