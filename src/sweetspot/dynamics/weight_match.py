"""A weight met by a size: which walls, caps, knobs or blades give an implement the weight that it has or shall have.

Metal has one density. Where the drawing of a hollow bat does not weigh what the scale says (`weight_matched`), the wall
of the handle, the knob, the end cap or all walls were drawn wrong; which one is a reported choice (`Bat.remark`).
A bat that shall weigh otherwise (`weighing`) gets another end cap, or other walls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, Literal, TypeVar

from sweetspot.dynamics.beam import BeamModel, beam_model, moments
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import UNMEASURED, Implement
from sweetspot.equipment.shell import Shell, between
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE, format_mass

WeightBy = Literal["handle", "knob", "end cap", "wall"]
ORDER: tuple[WeightBy, ...] = ("handle", "knob", "end cap", "wall")
"""The first that can meet the weight does: what people measure least, and what changes the hit least, comes first."""
HANDLE_WALL = {"metal": (1.2e-3, 3.2e-3), "laminate": (1.5e-3, 6.5e-3)}
"""m by the family of the material (assumed: about 2 mm in metal bats, 3 to 6 mm in composite ones)."""
HEAVIEST_KNOB, HEAVIEST_CAP = 0.150, 0.085
"""kg (assumed: knobs with weights in them; heavy caps of end-loaded bats)."""
WALL_FACTOR = (0.5, 2.0)
BARREL_PART = 0.95
"""Of the greatest diameter: where a bat is wider, it is barrel."""


Tool = TypeVar("Tool", bound=Implement)


@dataclass(frozen=True)
class Way(Generic[Tool]):
    """A size that may be changed to meet a weight; it grows with the size.

    Parameters
    ----------
    name : of the size.
    limits : between which it may lie.
    changed : gives the implement with the size.
    in_words : says the size.
    """

    name: str
    limits: tuple[float, float]
    changed: Callable[[float], Tool]
    in_words: Callable[[float], str]

    def weights(self, weigh: Callable[[Tool], float]) -> tuple[float, float]:
        """Return the least and the most, kg, that can be met this way."""
        low, high = (weigh(self.changed(size)) for size in self.limits)
        return low, high

    def size_for(self, mass: float, weigh: Callable[[Tool], float]) -> float | None:
        """Return the size that has a mass (kg), None where none within the limits has."""
        from scipy.optimize import brentq

        low, high = self.weights(weigh)
        if not low <= mass <= high:
            return None
        return float(brentq(lambda size: weigh(self.changed(size)) - mass, *self.limits, xtol=1e-13))


def first_that_weighs(
    ways: Sequence[Way[Tool]], mass: float, weigh: Callable[[Tool], float]
) -> tuple[Tool, str] | None:
    """Return an implement of a mass (kg) by the first of some ways that can, and the size in words; None: none can."""
    for way in ways:
        size = way.size_for(mass, weigh)
        if size is not None:
            return way.changed(size), way.in_words(size)
    return None


def weight_matched(bat: Bat, by: WeightBy | None = None) -> Bat:
    """Return a hollow bat that has its measured mass at the density of its material.

    A bat whose density alone can meet it, within what its material varies, comes back as it is.

    Raises `InputError` when no requested change gives the mass.

    Parameters
    ----------
    by : what is changed; None: the first of `ORDER` that can, and nothing where density can.
    """
    if bat.shell is None or bat.mass is None:
        return bat
    if by is None and _density_can(bat):
        return bat
    ways = _as_drawn(bat, bat.shell)
    candidates = [ways[name] for name in ((by,) if by is not None else ORDER)]
    if (match := first_that_weighs(candidates, bat.mass, drawn_mass)) is not None:
        changed, how = match
        return changed.replaced(remark=f"The measured weight, {_weighed(bat.mass)}, is met by the drawing where {how}.")
    tried = [f"{way.name}: {' to '.join(map(_weighed, way.weights(drawn_mass)))}" for way in candidates]
    raise InputError(
        f"{bat.name} weighs {_weighed(bat.mass)}, but its drawing can be {'; '.join(tried)}. "
        "Check the weight, the diameters and the wall"
    )


def weighing(bat: Bat, mass: float) -> Bat:
    """Return a hollow bat of another weight, by its end cap where that can be, else by all its walls: see its remark.

    Raises `InputError` when neither can be.

    >>> from sweetspot import catalog
    >>> weighing(catalog.bat("single-wall"), 0.88).remark
    'Its weight, 0.88 kg (31.04 oz), is that with an end cap of 0.03972 kg (1.401 oz).'
    """
    if bat.shell is None:
        raise InputError(f"{bat.name} is solid: other wood makes it lighter or heavier, not a cap")
    match = first_that_weighs(_made_otherwise(bat, bat.shell), mass, _mass_of)
    if match is None:
        low, high = weights(bat)
        raise InputError(
            f"{bat.name} can weigh {format_mass(low)} to {format_mass(high)}; given was {format_mass(mass)}"
        )
    changed, how = match
    return changed.replaced(remark=f"Its weight, {format_mass(mass)}, is that with {how}.")


def weights(bat: Bat) -> tuple[float, float]:
    """Return the least and the most that a hollow bat can weigh, kg, by its end cap or by its walls; see `weighing`."""
    ends = [way.weights(_mass_of) for way in _made_otherwise(bat, _hollow(bat))]
    return min(low for low, _ in ends), max(high for _, high in ends)


def with_wall_factor(bat: Bat, factor: float) -> Bat:
    """Return a hollow bat whose wall is ``factor`` times as thick everywhere; the outside stays as it is.

    What was measured belongs to the original wall, whose density is kept, so a thinner wall makes a lighter bat.
    """
    shell = _hollow(bat)
    if not factor > 0:
        raise InputError(f"wall factor is {factor:g}; allowed is a number above zero")
    return _made_with(bat, shell.scaled(factor), f"{bat.name}, wall × {factor:.3g}")


def barrel_start(bat: Bat) -> float:
    """Return the start of a hollow bat's barrel, m from the knob end: among the outer two thirds of the bat."""
    assert bat.profile is not None
    outer = [(place, size) for place, size in bat.profile if place > bat.length / 3]
    greatest = max(size for _, size in outer)
    return next(place for place, size in outer if size >= BARREL_PART * greatest)


def with_barrel_wall(bat: Bat, factor: float) -> Bat:
    """Return a hollow bat with a barrel wall ``factor`` times as thick; the handle keeps its own, the taper joins them.

    What was measured belongs to the original wall, so a thinner wall makes a lighter bat.
    """
    shell = _hollow(bat)
    start = barrel_start(bat)
    places = sorted({place for place, _ in shell.wall} | {start})
    wall = tuple((place, float(between(shell.wall, place)) * (factor if place >= start else 1.0)) for place in places)
    sleeve = shell.inner_wall
    if sleeve is not None:
        sleeve = sleeve.replaced(wall=tuple((place, factor * size) for place, size in sleeve.wall))
    return bat.replaced(
        **UNMEASURED,
        name=f"{bat.name}, barrel wall × {factor:.3g}",
        shell=shell.replaced(wall=wall, inner_wall=sleeve),
        original=None,
        remark="",
    )


def _hollow(bat: Bat) -> Shell:
    if bat.shell is None:
        raise InputError(f"{bat.name} is solid; a wall can be changed only on a bat with a shell")
    return bat.shell


def _weighed(mass: float) -> str:
    return f"{mass / OUNCE:.1f} oz ({1e3 * mass:.0f} g)"


def _thick(size: float) -> str:
    return f"{1e3 * size:.2f} mm ({size / INCH:.3f} in)"


def drawn_mass(tool: Implement) -> float:
    """Return the mass of an implement as drawn, kg: at the usual density of its material, whatever was measured."""
    gradient = tool.density_gradient if isinstance(tool, Bat) else 0.0
    plain = tool.replaced(mass=None, balance_point=None, moi=None)
    return moments(BeamModel(plain, 1.0, gradient, plain.lumps()))[0]


def _mass_of(bat: Bat) -> float:
    return rigid_body(beam_model(bat)).mass


def _made_with(bat: Bat, shell: Shell, name: str = "") -> Bat:
    """Return a bat made with another shell: measurements on the original fix its density alone."""
    return bat.replaced(**UNMEASURED, name=name or bat.name, shell=shell, original=bat.as_measured(), remark="")


def _density_can(bat: Bat) -> bool:
    assert bat.mass is not None
    others = moments(BeamModel(bat, 0.0, bat.density_gradient, bat.lumps()))[0]
    factor = (bat.mass - others) / (drawn_mass(bat) - others)
    allowed = bat.density_range
    density = factor * allowed.usual
    return allowed.lightest <= density * (1 + 1e-9) and density * (1 - 1e-9) <= allowed.heaviest


def _as_drawn(bat: Bat, shell: Shell) -> dict[WeightBy, Way[Bat]]:
    """Return the ways in which a weighed bat may have been drawn wrong."""

    def put_on(name: WeightBy, field: str, most: float) -> Way[Bat]:
        was = _weighed(getattr(shell, field))
        return Way(
            name,
            (0.0, most),
            lambda mass: bat.replaced(shell=shell.replaced(**{field: mass})),
            lambda mass: f"its {name} of {was} counts as {_weighed(mass)}",
        )

    drawn = _thick(float(shell.wall[0][1]))
    return {
        "handle": Way(
            "handle",
            _handle_walls(bat, shell),
            lambda size: _handle_wall(bat, shell, size),
            lambda size: f"its handle's wall of {drawn} counts as {_thick(size)}",
        ),
        "knob": put_on("knob", "knob_mass", HEAVIEST_KNOB),
        "end cap": put_on("end cap", "end_cap_mass", HEAVIEST_CAP),
        "wall": Way(
            "wall",
            WALL_FACTOR,
            lambda factor: bat.replaced(shell=shell.scaled(factor)),
            lambda factor: f"every wall counts as {factor:.3f} times as thick as drawn",
        ),
    }


def _made_otherwise(bat: Bat, shell: Shell) -> tuple[Way[Bat], ...]:
    """Return how a bat can be made of another weight."""
    return (
        Way(
            "end cap",
            (0.0, HEAVIEST_CAP),
            lambda mass: _made_with(bat, shell.replaced(end_cap_mass=mass)),
            lambda mass: f"an end cap of {format_mass(mass)}",
        ),
        Way(
            "wall",
            WALL_FACTOR,
            lambda factor: with_wall_factor(bat, factor),
            lambda factor: f"walls {factor:.3g} times as thick; no end cap makes it",
        ),
    )


def _handle_walls(bat: Bat, shell: Shell) -> tuple[float, float]:
    assert bat.profile is not None
    narrowest = min(size for _, size in bat.profile) / 2
    made_of = shell.handle_material or bat.material
    least, most = HANDLE_WALL.get(made_of.family, HANDLE_WALL["metal"])
    return least, min(most, 0.9 * narrowest)


def _handle_wall(bat: Bat, shell: Shell, size: float) -> Bat:
    """Return the bat with a handle's wall of ``size`` m; from where the taper begins it runs to the barrel's own."""
    assert bat.profile is not None
    start = barrel_start(bat)
    places = (0.1 * bat.length, *(place for place, _ in bat.profile if 0.1 * bat.length < place < start))
    sizes = [float(between(bat.profile, place)) for place in places]
    tapering = max(place for place, diameter in zip(places, sizes, strict=True) if diameter <= 1.05 * min(sizes))
    stations = tuple((place, thick) for place, thick in shell.wall if place > tapering)
    if not any(place <= start for place, _ in stations):
        stations = ((start, float(between(shell.wall, start))), *stations)
    return bat.replaced(shell=shell.replaced(wall=((0.0, size), (tapering, size), *stations)))
