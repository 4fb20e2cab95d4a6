"""Bats turned from one piece of wood: an outline that a designer pulls, its cup, knob and length, and the wood."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sweetspot.catalog.files.turned import HANDLE_START, KNOB, TIP
from sweetspot.designs.variables import Variable
from sweetspot.dynamics.batch.beams import Beams, SolidBats
from sweetspot.dynamics.batch.reduction import ReducedBats, reduced_outlines
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import USUAL_CUP, WIDEST_CUP, Bat, Cup
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH, format_length

REFERENCE_LENGTH = 34.0
"""inches of the bat for which the handles' places are given; on others they are moved in proportion."""
FROM_KNOB = (HANDLE_START, 7.0, 12.0)
FROM_TIP = (17.0, 13.5, 10.5, 8.5, 6.5, 4.5, 2.8, 1.2)
"""inches of a 34 in bat where the handles sit."""
GRIP = 3
"""Handles that lie under the hands, where a flare towards the knob is no waist."""
HANDLES = np.array([*FROM_KNOB, *(REFERENCE_LENGTH - inches for inches in FROM_TIP)]) / REFERENCE_LENGTH
"""Parts of the length, from the knob end."""
_ROUND = [(inches, part / TIP[1][1]) for inches, part in TIP[2:]]
BETWEEN = (HANDLES[1:] + HANDLES[:-1]) / 2
SAMPLES = np.sort(np.concatenate([HANDLES, BETWEEN]))
"""Where the curve is turned into stations of conical pieces: at every handle and halfway between."""
STATIONS = np.concatenate(
    [
        [inches / REFERENCE_LENGTH for inches, _ in KNOB],
        SAMPLES,
        [1 - inches / REFERENCE_LENGTH for inches, _ in _ROUND],
    ]
)
"""Parts of the length of every station: the knob's, the curve's, and those of the rounded end."""
FINE = np.linspace(HANDLES[0], HANDLES[-1], 193)
LEAST_CUP = 0.02 * INCH
"""m of depth below which a cup is left out."""
REACH = 0.15
"""Part of its present diameter by which an outline may change at a handle, on the barrel; half of that on the grip."""

KNOB_PART = 0.03
"""Part of the length in which the knob lies."""
MORE: Mapping[str, tuple[str, tuple[float, float]]] = {
    "length": ("length", (20 * INCH, 44 * INCH)),
    "knob": ("diameter of the knob", (0.8 * INCH, 3.5 * INCH)),
    "cup_diameter": ("width of the cup", (0.5 * INCH, 2.2 * INCH)),
}
"""Other variables, each with its label and the range of bats, m."""


def stations(diameters: Array, *, knob: Array, length: Array) -> tuple[Array, Array]:
    """Return positions and diameters of many outlines in m, each of shape (n, 27).

    Between the handles the diameter follows piecewise cubics that never overshoot (Fritsch and Carlson's), so a curve
    swells or thins only where its handles do. Knob and rounded end have the shapes of ordinary turned bats, scaled.

    ``diameters``: at `HANDLES`, m, shape (n, 11). ``knob``, ``length``: diameter of the knob and length of the bat, m,
    shape (n,).
    """
    from scipy.interpolate import PchipInterpolator

    curve = PchipInterpolator(HANDLES, diameters, axis=1)(SAMPLES)
    start = knob[:, None] * np.array([part for _, part in KNOB])
    end = diameters[:, -1:] * np.array([part for _, part in _ROUND])
    return length[:, None] * STATIONS, np.concatenate([start, curve, end], axis=1)


def steepness(diameters: Array, *, length: Array) -> tuple[Array, Array]:
    """Return the steepest slope of the radius and its sharpest bend in 1/m between the handles, each of shape (n,)."""
    from scipy.interpolate import PchipInterpolator

    curve = PchipInterpolator(HANDLES, diameters / 2, axis=1)
    slope = np.abs(curve(FINE, 1)).max(axis=1) / length
    bend = np.abs(curve(FINE, 2)).max(axis=1) / length**2
    return slope, bend


def waist(diameters: Array) -> Array:
    """Return the depth of an outline's deepest waist, m, shape (n,); 0: one swelling."""
    before = np.maximum.accumulate(diameters, axis=1)[:, :-2]
    beyond = np.maximum.accumulate(diameters[:, ::-1], axis=1)[:, ::-1][:, 2:]
    inside = diameters[:, 1:-1]
    deep = np.minimum(before, beyond) - inside
    return np.asarray(np.maximum(deep[:, GRIP - 1 :], 0.0).max(axis=1))


def diameters_of(position: Array, diameter: Array, length: float) -> Array:
    """Return the diameters at the handles of an outline given by stations, m, shape (11,)."""
    return np.interp(HANDLES * length, position, diameter)


@dataclass(frozen=True)
class TurnedSpace:
    """Turned wood bats: diameters at eleven handles, the cup's depth, the density of the wood, and what else is asked.

    ``present``: the batter's bat; its length, knob and width of cup are kept where they are no variables.
    ``variables``: what may be changed; see `turned_space`.
    """

    present: Bat
    variables: tuple[Variable, ...]
    material: Material

    def parts(self, numbers: Array) -> tuple[Array, Array, Array]:
        """Return diameters at the handles (n, 11), depths of the cup and density factors, each (n,)."""
        count = len(HANDLES)
        return numbers[:, :count], numbers[:, count], numbers[:, count + 1]

    def column(self, numbers: Array, name: str, usual: float) -> Array:
        """Return one of `MORE` of many rows of numbers, m of shape (n,); as it is where it is no variable."""
        names = [variable.name for variable in self.variables]
        return numbers[:, names.index(name)] if name in names else np.full(len(numbers), usual)

    def outlines(self, numbers: Array, *, stiffness: Array | float = 1.0) -> SolidBats:
        """Return the outlines of many rows of numbers, side by side."""
        numbers = np.asarray(numbers, float)
        diameters, depth, density = self.parts(numbers)
        count = len(diameters)
        length = self.column(numbers, "length", self.present.length)
        knob = self.column(numbers, "knob", knob_of(self.present))
        place, diameter = stations(diameters, knob=knob, length=length)
        cupped = depth > LEAST_CUP
        nothing = np.zeros((count, 0))
        return SolidBats(
            self.material,
            place,
            diameter,
            density,
            np.broadcast_to(np.asarray(stiffness, float), (count,)),
            np.where(cupped, self._cups(numbers, diameter), 0.0),
            np.where(cupped, depth, 0.0),
            nothing,
            nothing,
        )

    def beams(self, numbers: Array) -> Beams:
        """Return the bats of many rows of numbers (n, variables) as beams."""
        return self.outlines(numbers)

    def reduced(self, numbers: Array, *, ball: Ball) -> ReducedBats:
        """Return the bats of many rows of numbers (n, variables), ready to be hit."""
        return reduced_outlines(self.outlines(numbers), ball=ball)

    def shapes(self, numbers: Array) -> dict[str, Array]:
        """Return greatest and smallest diameter, cup, slope and bend of the outlines, and their widths at places."""
        numbers = np.asarray(numbers, float)
        bats, (diameters, depth, density) = self.outlines(numbers), self.parts(numbers)
        slope, bend = steepness(diameters, length=bats.length)
        return {
            "length": bats.length,
            "diameter": bats.diameter.max(axis=1),
            "handle": diameters[:, :GRIP].min(axis=1),
            "cup_depth": depth,
            "cup_diameter": self._cups(numbers, bats.diameter),
            "knob": self.column(numbers, "knob", knob_of(self.present)),
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
            name=name,
            sport=self.present.sport,
            length=float(bats.length[0]),
            material=self.material,
            profile=profile,
            cup=cup,
            choke=self.present.choke,
        )
        from sweetspot.dynamics.rigid import rigid_body

        return plain.with_mass(rigid_body(beam_model(plain)).mass * float(bats.density_factor[0]))

    @property
    def start(self) -> Array:
        """The numbers nearest to the present bat, shape (variables,)."""
        return np.array([variable.start for variable in self.variables])

    def _cups(self, numbers: Array, diameter: Array) -> Array:
        """Return the widths of the cups: asked for, the present one's, or the usual; no more than their tips allow."""
        usual = USUAL_CUP if self.present.cup is None else self.present.cup.diameter
        return np.minimum(self.column(numbers, "cup_diameter", usual), WIDEST_CUP * diameter[:, -1])


def knob_of(bat: Bat) -> float:
    """Return the greatest diameter of a bat's knob, m."""
    return float(bat.diameter_at(np.linspace(0.0, KNOB_PART * bat.length, 31)).max())


def turned_space(
    bat: Bat,
    *,
    deepest_cup: float = 1.0 * INCH,
    wood: Material | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
) -> TurnedSpace:
    """Return the space of turned bats around a batter's present one.

    ``deepest_cup``: m; 0: no cup. ``wood``: of the bats that can be; None: the present one's. ``ranges``: least and
    most in m of some of `MORE`, which stay as they are otherwise.
    """
    wood = bat.material if wood is None else wood
    if bat.shell is not None or bat.bores or bat.profile is None or bat.material.family != "wood":
        raise InputError(
            f"{bat.name} is not turned from one piece of wood; give a solid bat with a profile to design outlines for"
        )
    if wood.family != "wood":
        raise InputError(f"{bat.name} is turned from one piece, and {wood.name} is no wood; give a species of wood")
    variables = _diameters(bat)
    cup = 0.0 if bat.cup is None else bat.cup.depth
    deepest = max(deepest_cup, cup, 1.1 * LEAST_CUP)
    variables.append(Variable("cup_depth", "depth of the cup", "length", 0.0, deepest, cup))
    light, heavy = wood.density_range or (0.95 * wood.density, 1.05 * wood.density)
    low, high = light / wood.density, heavy / wood.density
    now = beam_model(bat).density_factor * bat.material.density / wood.density
    variables.append(
        Variable("density", "density, times the species' mean", "ratio", low, high, min(max(now, low), high))
    )
    present = {
        "length": bat.length,
        "knob": knob_of(bat),
        "cup_diameter": USUAL_CUP if bat.cup is None else bat.cup.diameter,
    }
    for name, (least, most) in (ranges or {}).items():
        label, ends = MORE[name]
        if not ends[0] <= least < most <= ends[1]:
            raise InputError(
                f"{label} may go from {format_length(least)} to {format_length(most)}; allowed is a range with some "
                f"width inside {format_length(ends[0])} to {format_length(ends[1])}"
            )
        variables.append(Variable(name, label, "length", least, most, min(max(present[name], least), most)))
    return TurnedSpace(bat, tuple(variables), wood)


def _diameters(bat: Bat) -> list[Variable]:
    """Return the diameters at the handles as variables."""
    assert bat.profile is not None
    place, diameter = np.array(bat.profile).T
    variables = []
    for index, (part, size) in enumerate(zip(HANDLES, diameters_of(place, diameter, bat.length), strict=True)):
        reach = REACH / 2 if index < GRIP else REACH
        variables.append(
            Variable(
                f"diameter_{index + 1}",
                "diameter",
                "length",
                size * (1 - reach),
                size * (1 + reach),
                size,
                from_tip=(1 - part) * bat.length,
            )
        )
    return variables
