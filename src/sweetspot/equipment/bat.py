"""The bat: its outline, what was drilled into it, and what was measured on it.

Positions are metres from the knob end; the axis figure in the docs fixes origin and directions.
"""

from __future__ import annotations

import math
from typing import Annotated, Self

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import ArrayLike, NDArray
from pydantic import Field, model_validator

from sweetspot.equipment.base import NonNegative, Positive, Validated
from sweetspot.equipment.implement import UNMEASURED, DensityRange, Lump, OfMaterial
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import CrossSection, of_solid, of_walls
from sweetspot.equipment.shell import Shell, Stations, between, check_order
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, format_length
from sweetspot.units.quantities import in_si

LENGTH_RANGE = (0.3, 1.3)
MOST_COEFFICIENTS = 10
DIAMETER_RANGE = (0.005, 0.12)
USUAL_CUP = 1.4 * INCH
"""m, width of a cup where none is named [our choice]."""
WIDEST_CUP = 0.95
"""Of the tip's diameter, which a cup of no named width leaves a rim of [our choice]."""
DEEPEST_PLUG = 0.25
"""Of the length, the most that a knob or an end cap can fill [our choice]: a rod would be part of the wall."""
IMPLAUSIBLE = "give it in the file's own unit, for example '2.5 in' or '64 mm'"


class Bore(Validated):
    """A round hole drilled from the barrel end, perhaps filled, perhaps plugged with the bat's wood.

    Parameters
    ----------
    diameter, depth : m, > 0; ``depth`` is counted from the tip.
    fill : material that fills it; None: empty.
    plug : m of the hole's mouth closed with the bat's own material, less than ``depth``.
    """

    diameter: Positive
    depth: Positive
    fill: Material | None = None
    plug: NonNegative = 0.0

    @model_validator(mode="after")
    def _plug_is_shorter_than_the_hole(self) -> Bore:
        if self.plug >= self.depth:
            raise ValueError(
                f"plug is {self.plug:g} m long but the hole only {self.depth:g} m deep; "
                "shorten the plug or leave the hole out"
            )
        return self


class Cup(Validated):
    """A hollow turned into the barrel end: a paraboloid ``depth`` deep and ``diameter`` wide at the rim."""

    diameter: Positive
    depth: Positive


class PointMass(Validated):
    """A small weight fixed to the bat: ``mass`` in kg at ``position`` in m from the knob end.

    Parameters
    ----------
    on_surface : whether it is known to sit on the bat, as tape and paint do, and not inside it.
    """

    position: NonNegative
    mass: Positive
    on_surface: bool = False


class Bat(OfMaterial):
    """A bat as its maker or owner would describe it; physics functions take it from here.

    Give the outline either as ``profile`` (a round bat made of conical pieces) or as
    ``linear_density`` (a solid round bat of this material with that mass per length).

    Parameters
    ----------
    name, sport, mass, balance_point, moi, moi_axis, fitted, choke, original : as for every `Implement`.
    length : m, 0.3 to 1.3.
    material : of the body.
    profile : (position, diameter) stations in m from 0 to ``length``, positions increasing.
    linear_density : coefficients c0, c1, c2, ... of c0 + c1 x + c2 x^2 + ... in kg/m, x from the knob end.
    outline_assumed : whether the outline is not its own but assumed, as that of others of its kind.
    density_gradient : relative change of density from the middle of the bat to its tip, -0.25 to 0.25.
    bores, cup, shell, point_masses : what is drilled, turned, hollowed and added.
    remark : how the description was made to agree with what was measured; "": it did.
    drawn_shell : the shell as it was drawn, where that remark tells of another; None: as it is.
    grain_slope : rad between the wood's grain and the bat's axis at the handle, 0 to 0.35; 0: straight.
    altered : whether it was changed after its maker had made it, as no rule allows: shaved, rolled, end-loaded, cut.

    Raises
    ------
    InputError
        when sizes are implausible, stations cross, or a hole does not fit into the wood.
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    material: Material
    profile: Stations | None = None
    linear_density: tuple[float, ...] | None = None
    outline_assumed: bool = False
    density_gradient: Annotated[float, Field(ge=-0.25, le=0.25)] = 0.0
    bores: tuple[Bore, ...] = ()
    cup: Cup | None = None
    shell: Shell | None = None
    point_masses: tuple[PointMass, ...] = ()
    original: Bat | None = None
    remark: str = ""
    drawn_shell: Shell | None = None
    grain_slope: Annotated[float, Field(ge=0, le=0.35)] = 0.0
    altered: bool = False

    @model_validator(mode="after")
    def _holds_together(self) -> Bat:
        if (self.profile is None) == (self.linear_density is None):
            raise ValueError("give either a profile or a linear_density, and only one of them")
        if self.profile is not None:
            _check_stations(self.profile, self.length, "profile")
            for position, diameter in self.profile:
                if not DIAMETER_RANGE[0] <= diameter <= DIAMETER_RANGE[1]:
                    raise ValueError(
                        f"profile has diameter {diameter * 1e3:.4g} mm at {position:.4g} m; allowed is "
                        f"{DIAMETER_RANGE[0] * 1e3:g} to {DIAMETER_RANGE[1] * 1e3:g} mm; {IMPLAUSIBLE}"
                    )
        else:
            self._check_linear_density()
        self._check_hollows()
        self._check_places()
        return self

    def _check_linear_density(self) -> None:
        count = len(self.linear_density or ())
        if not 1 <= count <= MOST_COEFFICIENTS:
            raise ValueError(f"linear_density has {count} coefficients; give 1 to {MOST_COEFFICIENTS}")
        if self.shell or self.bores or self.cup:
            raise ValueError("a linear_density describes a solid bat; shell, bore and cup need a profile")
        places = np.linspace(0, self.length, 401)
        diameters = self.diameter_at(places)
        if not np.all(np.isfinite(diameters)) or diameters.min() < DIAMETER_RANGE[0]:
            raise ValueError("linear_density must stay well above zero along the whole bat")
        if diameters.max() > DIAMETER_RANGE[1]:
            raise ValueError(
                f"linear_density makes the bat {diameters.max() * 1e3:.0f} mm thick in "
                f"{self.material.name}; allowed is {DIAMETER_RANGE[1] * 1e3:g} mm"
            )

    def _check_hollows(self) -> None:
        if self.shell is not None:
            self._check_shell(self.shell)
        for bore in self.bores:
            self._check_fits(bore.diameter, bore.depth, "bore")
        if self.cup is not None:
            self._check_fits(self.cup.diameter, self.cup.depth, "cup", mouth_only=True)

    def _check_shell(self, shell: Shell) -> None:
        if self.bores or self.cup:
            raise ValueError("a shell is hollow already; leave out bore and cup")
        _check_stations(shell.wall, self.length, "shell.wall")
        sleeve = shell.inner_wall
        for position in shell.edges():
            if not 0 <= position <= self.length * (1 + 1e-6):
                raise ValueError(f"the shell has something at {position:.4g} m, off the bat of {self.length:.4g} m")
        edges = np.asarray(self.breakpoints())
        walls, radii = self.wall_at(edges), self.diameter_at(edges) / 2
        for position, wall, radius in zip(edges.tolist(), walls.tolist(), radii.tolist(), strict=True):
            if not 0 < wall <= radius:
                raise ValueError(
                    f"shell wall is {wall * 1e3:.3g} mm at {position:.4g} m where the radius is "
                    f"{radius * 1e3:.3g} mm; allowed is more than 0 and no more than the radius"
                )
            if sleeve is not None and sleeve.wall[0][0] <= position <= sleeve.wall[-1][0]:
                thickness = between(sleeve.wall, position)
                if thickness + sleeve.gap > radius - wall:
                    raise ValueError(
                        f"inner wall and gap are {(thickness + sleeve.gap) * 1e3:.3g} mm at {position:.4g} m where the "
                        f"bore of the outer wall is {(radius - wall) * 1e3:.3g} mm in radius; make the sleeve thinner"
                    )
        for what, depth in zip(("knob", "end cap"), shell.depths, strict=True):
            if depth > DEEPEST_PLUG * self.length:
                raise ValueError(
                    f"the {what} is {format_length(depth)} deep; allowed is up to "
                    f"{format_length(DEEPEST_PLUG * self.length)}, a quarter of the bat: count from its end"
                )
        for ring in shell.rings:
            if ring.ends[1] > self.length:
                raise ValueError(f"the ring at {ring.position:.4g} m reaches beyond the tip at {self.length:.4g} m")
            hollow = self._bore_radius(ring.position)
            if ring.depth is not None and ring.depth > hollow:
                raise ValueError(
                    f"the ring at {ring.position:.4g} m is {ring.depth * 1e3:.3g} mm deep where the hollow is "
                    f"{hollow * 1e3:.3g} mm in radius; leave its depth out for a solid disc"
                )

    def _check_fits(self, diameter: float, depth: float, what: str, *, mouth_only: bool = False) -> None:
        if depth >= self.length:
            whole = format_length(self.length)
            raise ValueError(f"{what} is {format_length(depth)} deep but the bat only {whole} long; make it shallower")
        edges = np.asarray(self.breakpoints())
        places = edges[edges >= self.length - (0 if mouth_only else depth)]
        narrowest = float(np.min(self.diameter_at(places)))
        if diameter >= narrowest:
            raise ValueError(
                f"{what} is {format_length(diameter)} wide and has to be narrower than the bat there, "
                f"{format_length(narrowest)}; make it narrower or shallower"
            )

    def _check_places(self) -> None:
        if self.balance_point is not None and not 0.2 < self.balance_point / self.length < 0.95:
            raise ValueError(
                f"balance_point is {format_length(self.balance_point)} from the knob end of a bat of "
                f"{format_length(self.length)}; measure it from the knob end"
            )
        for weight in self.point_masses:
            if weight.position > self.length:
                raise ValueError(
                    f"a point mass sits at {format_length(weight.position)}, beyond the tip at "
                    f"{format_length(self.length)}"
                )
        if self.choke > self.length / 3:
            raise ValueError(
                f"choke is {format_length(self.choke)}; allowed is up to a third of the length, "
                f"{format_length(self.length / 3)}"
            )

    def diameter_at(self, position: ArrayLike) -> NDArray[np.float64]:
        """Return the outer diameter in m at positions in m (array in, array of the same shape out)."""
        position = in_si(position, "position")
        if self.profile is not None:
            stations, diameters = zip(*self.profile, strict=True)
            return np.asarray(np.interp(np.asarray(position, float), stations, diameters))
        assert self.linear_density is not None  # one of the two is given
        mass_per_length = polynomial.polyval(np.asarray(position, float), self.linear_density)
        with np.errstate(invalid="ignore", over="ignore"):
            return np.asarray(np.sqrt(4 * mass_per_length / (math.pi * self.material.density)))

    def width_at(self, position: ArrayLike) -> Array:
        """Return the diameter: a round bat looks the same from all sides."""
        return self.diameter_at(position)

    def material_at(self, position: float) -> Material:
        """Return the material of the bat's body at a position in m: a two-piece bat has its own handle."""
        shell = self.shell
        if shell is None or shell.handle_material is None or shell.joint is None or position > shell.joint:
            return self.material
        return shell.handle_material

    def wall_at(self, position: ArrayLike) -> NDArray[np.float64]:
        """Return the thickness in m of a hollow bat's outer wall at positions in m; a solid bat has its radius."""
        if self.shell is None:
            return self.diameter_at(position) / 2
        return self.shell.wall_at(np.asarray(in_si(position, "position"), float))

    def breakpoints(self) -> tuple[float, ...]:
        """Return the positions, 0 and length included, between which every outline is smooth."""
        edges = {0.0, self.length}
        edges.update(position for position, _ in self.profile or ())
        edges.update(self.shell.edges() if self.shell else ())
        for bore in self.bores:
            edges.update((self.length - bore.depth, self.length - bore.plug))
        if self.cup:
            edges.add(self.length - self.cup.depth)
            for bore in self.bores:  # where the wall of the hole comes out of the cup
                if bore.diameter < self.cup.diameter:
                    edges.add(self.length - self.cup.depth * (1 - (bore.diameter / self.cup.diameter) ** 2))
        return tuple(sorted(edges))

    @property
    def materials(self) -> tuple[Material, ...]:
        """Its own and those of its fills."""
        return (self.material, *(bore.fill for bore in self.bores if bore.fill is not None))

    @property
    def grip_end(self) -> str:
        """What people call the end that the hand holds."""
        return "knob end"

    @property
    def swing_axis(self) -> float:
        """6 in from the knob end, wherever this bat's own moment of inertia was measured."""
        return STANDARD_AXIS

    @property
    def density_range(self) -> DensityRange:
        """Of its material; a laminate may vary in the same proportion."""
        material, laminate = self.material, None if self.shell is None else self.shell.laminate
        usual = material.density if laminate is None else laminate.density
        light, heavy = material.density_range or (material.density, material.density)
        return DensityRange(usual, usual * light / material.density, usual * heavy / material.density)

    def as_drawn(self) -> Bat:
        """Return the bat as its file draws it, where walls or ends were changed so that it weighs what the file says.

        What was measured is left out then. For who finds the walls by more than the weight.
        """
        if self.drawn_shell is None:
            return self
        return self.replaced(
            **UNMEASURED, shell=self.drawn_shell, drawn_shell=None, fitted=(), remark="", original=None
        )

    def section_at(self, position: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m (not exactly at a jump: there the inner side is taken).

        All walls of a hollow bat, sleeve and handle included, are scaled alike; fills are not.
        """
        return self.section_within(position, self.diameter_at(position) / 2, scale)

    def section_within(self, position: Array, outer: Array, scale: Array) -> CrossSection:
        """Return the sections at positions in m of a bat with other outer radii in m, in rows that end in positions."""
        if self.shell is not None:
            return of_walls(self.shell.parts(position, outer, self.material), outer, scale)
        ends = ((bore, self.length - bore.depth, self.length - bore.plug) for bore in self.bores)
        inclusions = [
            (np.where((position > start) & (position <= stop), bore.diameter / 2, 0.0), bore.fill)
            for bore, start, stop in sorted(ends, key=lambda entry: -entry[0].diameter)
        ]
        void = self._void_radius(position)
        return of_solid(self.material, outer=outer, void=void, inclusions=inclusions, scale=scale)

    def _void_radius(self, position: Array) -> Array:
        """Return the radius within which there is nothing at all: in the cup."""
        if self.cup is None:
            return np.zeros_like(position)
        into_cup = 1 - (self.length - position) / self.cup.depth
        return self.cup.diameter / 2 * np.sqrt(np.maximum(into_cup, 0.0))

    def lumps(self) -> tuple[Lump, ...]:
        """Return the weights the description itself names: added ones, knob, joint, rings and end cap of a shell."""
        masses = [Lump(weight.position, weight.mass) for weight in self.point_masses]
        shell = self.shell
        if shell is not None:
            knob, cap = shell.depths
            if shell.knob_mass:
                radius = float(self.diameter_at(knob / 2)) / 2
                masses.append(_plug(knob / 2, shell.knob_mass, depth=knob, radius=radius))
            masses += [Lump(shell.joint, shell.joint_mass)] if shell.joint and shell.joint_mass else []
            masses += [Lump(ring.position, *ring.inertia(self._bore_radius(ring.position))) for ring in shell.rings]
            if shell.end_cap_mass:
                middle = self.length - cap / 2
                masses.append(_plug(middle, shell.end_cap_mass, depth=cap, radius=self._bore_radius(middle)))
        return tuple(masses)

    def _bore_radius(self, position: float) -> float:
        assert self.shell is not None
        return self.shell.bore_at(position, float(self.diameter_at(position)) / 2)

    def drilled(self, *, diameter: float, depth: float) -> Self:
        """Return the bat with an empty hole drilled from the barrel end (m)."""
        return self.changed(f"{self.name}, drilled", bores=(*self.bores, Bore(diameter=diameter, depth=depth)))

    def corked(self, *, diameter: float, depth: float, fill: Material, plug: float = 0.0) -> Self:
        """Return the bat with a hole from the barrel end, filled and plugged (m)."""
        bore = Bore(diameter=diameter, depth=depth, fill=fill, plug=plug)
        return self.changed(f"{self.name}, filled with {fill.name}", bores=(*self.bores, bore))

    def cupped(self, *, diameter: float, depth: float) -> Self:
        """Return the bat with a cupped end (m)."""
        return self.changed(f"{self.name}, cupped", cup=Cup(diameter=diameter, depth=depth))

    def uncupped(self) -> Self:
        """Return the bat with its end left full."""
        return self.changed(f"{self.name}, full end", cup=None)

    def weighted(self, *, position: float, mass: float) -> Self:
        """Return the bat with a small weight (kg) fixed at a position (m)."""
        weights = (*self.point_masses, PointMass(position=position, mass=mass))
        return self.changed(f"{self.name}, weighted", point_masses=weights)

    def reshaped(self, profile: Stations) -> Self:
        """Return the bat turned to another outline from the same wood: (position, diameter) stations in m.

        The last station sets the new length.
        """
        return self.changed(f"{self.name}, reshaped", profile=profile, linear_density=None, length=profile[-1][0])

    def choked_up(self, distance: float) -> Self:
        """Return the bat held further up the handle by ``distance`` (m)."""
        return self.replaced(choke=self.choke + distance)

    def with_mass(self, mass: float) -> Self:
        """Return the same outline in wood of another density, so that the bat weighs ``mass`` (kg).

        A measured balance point or moment of inertia belongs to the old weight and is dropped.
        """
        return self.replaced(mass=mass, balance_point=None, moi=None, fitted=(), original=None)

    def with_material(self, material: Material) -> Self:
        """Return the same outline in another material; what was measured on the old one is dropped."""
        return self.replaced(**UNMEASURED, material=material, density_gradient=0.0, original=None)

    def changed(self, name: str, **changes: object) -> Self:
        """Return a modified bat that remembers the bat its measured values belong to."""
        return self.replaced(**{**UNMEASURED, "fitted": (), "original": self.as_measured(), "name": name, **changes})


def _plug(middle: float, mass: float, *, depth: float, radius: float) -> Lump:
    """Return a solid cylinder along the bat as mass and moments of inertia at its middle (all in SI)."""
    return Lump(middle, mass, mass * (radius**2 / 4 + depth**2 / 12), mass * radius**2 / 2)


def _check_stations(stations: Stations, length: float, what: str) -> None:
    check_order(stations, what)
    first, last = stations[0][0], stations[-1][0]
    if abs(first) > 1e-9 or abs(last - length) > 1e-6 * length:
        raise ValueError(
            f"{what} runs from {format_length(first)} to {format_length(last)} but the bat from 0 to "
            f"{format_length(length)}; give a station at each end"
        )
