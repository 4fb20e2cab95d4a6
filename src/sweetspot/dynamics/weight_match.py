"""A hollow bat's measured weight, met by what its owner is least likely to have measured.

Metal has one density. Where the drawing of a hollow bat does not weigh what the scale says, the wall of the handle, the
knob, the end cap or all walls were drawn wrong; which one is a choice, and is said (`Bat.remark`).
"""

from __future__ import annotations

from typing import Literal

from sweetspot.dynamics.beam import BeamModel, moments
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.shell import Shell, between
from sweetspot.errors import InputError
from sweetspot.units import OUNCE

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


def weight_matched(bat: Bat, by: WeightBy | None = None) -> Bat:
    """Return a hollow bat that has its measured mass at the density of its material.

    A bat whose density alone can meet it, within what its material varies, comes back as it is.

    Parameters
    ----------
    by : what is changed; None: the first of `ORDER` that can, and nothing where density can.

    Raises
    ------
    InputError
        when nothing asked for can meet the mass.
    """
    if bat.shell is None or bat.mass is None:
        return bat
    if by is None and _density_can(bat):
        return bat
    tried = []
    for way in (by,) if by is not None else ORDER:
        attempt = _matched(bat, bat.shell, way)
        if isinstance(attempt, Bat):
            return attempt
        tried.append(f"{way}: {attempt}")
    raise InputError(
        f"{bat.name} weighs {_weighed(bat.mass)}, but its drawing can be {'; '.join(tried)}. "
        "Check the weight, the diameters and the wall"
    )


def barrel_start(bat: Bat) -> float:
    """Return where the barrel of a hollow bat begins, m from the knob end."""
    assert bat.profile is not None
    greatest = max(size for _, size in bat.profile)
    return next(place for place, size in bat.profile if place > bat.length / 3 and size >= BARREL_PART * greatest)


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
        name=f"{bat.name}, barrel wall x {factor:.3g}", shell=shell.replaced(wall=wall, inner_wall=sleeve),
        mass=None, balance_point=None, moi=None, original=None, remark="",
    )  # fmt: skip


def _hollow(bat: Bat) -> Shell:
    if bat.shell is None:
        raise InputError(f"{bat.name} is solid; a wall can be changed only on a bat with a shell")
    return bat.shell


def _weighed(mass: float) -> str:
    return f"{mass / OUNCE:.1f} oz ({1e3 * mass:.0f} g)"


def _drawn_mass(bat: Bat) -> float:
    plain = bat.replaced(mass=None, balance_point=None, moi=None)
    return moments(BeamModel(plain, 1.0, bat.density_gradient, plain.lumps()))[0]


def _density_can(bat: Bat) -> bool:
    assert bat.mass is not None
    others = moments(BeamModel(bat, 0.0, bat.density_gradient, bat.lumps()))[0]
    factor = (bat.mass - others) / (_drawn_mass(bat) - others)
    known = bat.density_range
    return known.lightest <= factor * known.usual * (1 + 1e-9) and factor * known.usual * (1 - 1e-9) <= known.heaviest


def _matched(bat: Bat, shell: Shell, way: WeightBy) -> Bat | str:
    """Return the bat of the measured mass, or what it can weigh this way."""
    from scipy.optimize import brentq

    assert bat.mass is not None
    missing = bat.mass - _drawn_mass(bat)
    if way in ("knob", "end cap"):
        old = shell.knob_mass if way == "knob" else shell.end_cap_mass
        most = HEAVIEST_KNOB if way == "knob" else HEAVIEST_CAP
        if not 0 <= old + missing <= most:
            least = bat.mass - missing
            return f"{_weighed(least - old)} to {_weighed(least - old + most)}"
        field = "knob_mass" if way == "knob" else "end_cap_mass"
        changed = bat.replaced(shell=shell.replaced(**{field: old + missing}))
        return _remarked(changed, f"its {way} of {_weighed(old)} counts as {_weighed(old + missing)}")
    wall_of = _handle_wall if way == "handle" else _all_walls
    low, high = _limits(bat, shell, way)
    target = bat.mass

    def excess(size: float) -> float:
        return _drawn_mass(wall_of(bat, shell, size)) - target

    if not excess(low) <= 0 <= excess(high):
        return f"{_weighed(target + excess(low))} to {_weighed(target + excess(high))}"
    size = float(brentq(excess, low, high, xtol=1e-12))
    changed = wall_of(bat, shell, size)
    if way == "handle":
        drawn = float(shell.wall[0][1])
        return _remarked(changed, f"its handle's wall of {1e3 * drawn:.2f} mm counts as {1e3 * size:.2f} mm")
    return _remarked(changed, f"every wall counts as {size:.3f} times as thick as drawn")


def _remarked(bat: Bat, how: str) -> Bat:
    assert bat.mass is not None
    return bat.replaced(remark=f"The measured weight, {_weighed(bat.mass)}, is met by the drawing where {how}.")


def _limits(bat: Bat, shell: Shell, way: WeightBy) -> tuple[float, float]:
    if way == "wall":
        return WALL_FACTOR
    assert bat.profile is not None
    narrowest = min(size for _, size in bat.profile) / 2
    made_of = shell.handle_material or bat.material
    least, most = HANDLE_WALL.get(made_of.family, HANDLE_WALL["metal"])
    return least, min(most, 0.9 * narrowest)


def _all_walls(bat: Bat, shell: Shell, factor: float) -> Bat:
    return bat.replaced(shell=shell.scaled(factor))


def _handle_wall(bat: Bat, shell: Shell, size: float) -> Bat:
    """Return the bat with a handle's wall of ``size`` m; from where the taper begins it runs to the barrel's own."""
    assert bat.profile is not None
    start = barrel_start(bat)
    handle = min(size for place, size in bat.profile if 0.1 * bat.length < place < start)
    tapering = max(place for place, diameter in bat.profile if place < start and diameter <= 1.05 * handle)
    kept = tuple((place, thick) for place, thick in shell.wall if place > tapering)
    if not any(place <= start for place, _ in kept):
        kept = ((start, float(between(shell.wall, start))), *kept)
    return bat.replaced(shell=shell.replaced(wall=((0.0, size), (tapering, size), *kept)))
