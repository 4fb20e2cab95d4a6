"""An implement like one of the catalogue, with the length, weight, balance and swing weight that were measured.

For most bats, rackets, clubs and sticks only a ruler, a scale and a finger are at hand. The pattern gives the rest: its
outline, its construction, its materials. The change that gives the weight is reported.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sweetspot.dynamics.beam import BeamModel, beam_model, moments
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.weight_match import Way, drawn_mass, weight_matched
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.laminate import Laminate
from sweetspot.equipment.material import Material
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.stretch import stretched
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError
from sweetspot.plausibility import bounds, fine
from sweetspot.units import format_length, format_mass

TRIED = 1e-3
"""Relative change of a paddle's swing weight by which the change of its balance point is found."""
THICKNESS = (0.75, 1.35)
"""Of blades and walls over the pattern's, where their density cannot meet the weight (assumed)."""


@dataclass(frozen=True)
class Measures:
    """Measured quantities of an implement; None: as the pattern has it at this length.

    Parameters
    ----------
    length : m.
    mass : kg.
    balance_point : m from the butt end.
    moi : kg m^2 about the axis ``moi_axis`` (m from the butt end).
    """

    length: float | None = None
    mass: float | None = None
    balance_point: float | None = None
    moi: float | None = None
    moi_axis: float = 0.0


def scaled_to(pattern: Implement, measures: Measures) -> tuple[Implement, str]:
    """Return an implement like a pattern with the given measures, and the change that gave its weight, in words.

    Density meets the weight first, as far as the material varies; where it cannot, a hollow bat's handle, knob, cap or
    wall (`weight_matched`), a blade's thickness, a stick's wall. A racket has what was measured; a club has its weight
    by its head and, where its balance point is known, by its shaft's wall.

    Raises `InputError` where nothing gives these measures; the message has the possible ones.

    >>> from sweetspot import catalog
    >>> racket, _ = scaled_to(catalog.implement("tennis-racket"), Measures(mass=0.305))
    >>> racket.mass
    0.305
    """
    tool = pattern if measures.length is None else stretched(pattern, measures.length)
    if isinstance(tool, GolfClub):
        return _club(tool, measures)
    if isinstance(tool, Racket):
        return _racket(tool, measures), ""
    if isinstance(tool, Paddle):
        return _paddle(tool, measures), ""
    mass = _mass_of(pattern, tool) if measures.mass is None else measures.mass
    try:
        return _measured(_weighing(tool, mass), measures)
    except InputError:
        if type(tool) not in THICKER:
            raise
    return _measured(_thickened(tool, mass), measures)


def _measured(weighing: tuple[Implement, str], measures: Measures) -> tuple[Implement, str]:
    """Return an implement of the right weight with its balance point and moi; refused where its weight forbids them."""
    tool, remark = weighing
    tool = tool.replaced(balance_point=measures.balance_point)
    if measures.moi is not None:
        tool = tool.replaced(moi=measures.moi, moi_axis=measures.moi_axis)
    beam_model(tool)
    return tool, remark


def _mass_of(pattern: Implement, tool: Implement) -> float:
    """Return the mass of a pattern stretched: in proportion."""
    return rigid_body(beam_model(pattern)).mass * tool.length / pattern.length


def _racket(racket: Racket, measures: Measures) -> Racket:
    """Return a racket as measured; unmeasured quantities: the same distribution of mass, heavier or moved."""
    assert racket.mass is not None and racket.balance_point is not None and racket.moi is not None
    mass = racket.mass if measures.mass is None else measures.mass
    balance = racket.balance_point if measures.balance_point is None else measures.balance_point
    about_centre = racket.moi / racket.mass - (racket.balance_point - racket.moi_axis) ** 2
    axis = racket.moi_axis if measures.moi is None else measures.moi_axis
    moi = mass * (about_centre + (balance - axis) ** 2) if measures.moi is None else measures.moi
    return racket.replaced(mass=mass, balance_point=balance, moi=moi, moi_axis=axis)


def _paddle(paddle: Paddle, measures: Measures) -> Paddle:
    """Return a paddle of measured mass and swing weight, between rim and handle; the latter as the mass, if unknown.

    A balance point stands for the swing weight: at one mass the one is linear in the other.
    """
    paddle = paddle.with_its_rim()
    assert paddle.mass is not None and paddle.moi is not None
    mass = paddle.mass if measures.mass is None else measures.mass
    if measures.moi is not None:
        if measures.balance_point is not None:
            raise InputError("the balance point of a paddle follows from mass and swing weight; leave one of them out")
        return paddle.replaced(mass=mass, moi=measures.moi, moi_axis=measures.moi_axis)
    plain = paddle.replaced(mass=mass, moi=paddle.moi * mass / paddle.mass)
    if measures.balance_point is None:
        return plain
    assert plain.moi is not None
    other = plain.replaced(moi=plain.moi * (1 + TRIED))
    here, there = (rigid_body(beam_model(tool)).balance_point for tool in (plain, other))
    needed = (measures.balance_point - here) / (there - here) * TRIED
    return plain.replaced(moi=plain.moi * (1 + needed))


def _weighing(tool: Implement, mass: float) -> tuple[Implement, str]:
    """Return an implement of a mass, and what was changed for it beside density."""
    tool = tool.replaced(mass=mass, balance_point=None, moi=None)
    if not isinstance(tool, Bat):
        return tool, ""
    tool = weight_matched(tool)
    return tool, tool.remark


def _thickened(tool: Implement, mass: float) -> tuple[Implement, str]:
    """Return an implement of a mass by its thickness; beyond what that can be, density has to make the rest."""
    thicker, what = THICKER[type(tool)]
    way: Way[Implement] = Way(
        what,
        THICKNESS,
        lambda factor: thicker(tool, factor),
        lambda factor: f"{what} {factor:.3f} times as thick as the pattern's",
    )
    factor = way.size_for(mass, drawn_mass)
    if factor is None:
        factor = THICKNESS[0] if mass <= way.weights(drawn_mass)[0] else THICKNESS[1]
    changed = way.changed(factor).replaced(mass=mass, balance_point=None, moi=None)
    return changed, f"Its weight, {format_mass(mass)}, is met where {way.in_words(factor)}."


def _thicker_blade(bat: CricketBat, factor: float) -> CricketBat:
    return bat.replaced(**{name: _scaled(getattr(bat, name), factor) for name in ("spine", "edge")})


def _thicker_wall(stick: HockeyStick, factor: float) -> HockeyStick:
    return stick.replaced(wall=_scaled(stick.wall, factor))


def _thicker_plies(racket: TableTennisRacket, factor: float) -> TableTennisRacket:
    plies = tuple(ply.replaced(thickness=factor * ply.thickness) for ply in racket.blade.plies)
    return racket.replaced(blade=Laminate(plies=plies))


def _scaled(stations: tuple[tuple[float, float], ...], factor: float) -> tuple[tuple[float, float], ...]:
    return tuple((place, factor * size) for place, size in stations)


THICKER: dict[type[Implement], tuple[Callable[..., Implement], str]] = {
    CricketBat: (_thicker_blade, "its blade is"),
    HockeyStick: (_thicker_wall, "its wall is"),
    TableTennisRacket: (_thicker_plies, "its plies are"),
}
"""Part that is made thicker, by kind."""


def _club(club: GolfClub, measures: Measures) -> tuple[Implement, str]:
    """Return a club whose head, and shaft where the balance point is known, make its weight."""
    if measures.moi is not None:
        raise InputError("the swing of a club is described by its balance point or its swing weight; give one of them")
    mass = rigid_body(beam_model(club)).mass if measures.mass is None else measures.mass
    if measures.balance_point is not None:
        club = _balanced(club, mass, measures.balance_point)
    shaft = moments(BeamModel(club, 1.0, 0.0, ()))[0] - club.grip_mass
    head = mass - shaft - club.grip_mass
    parts = (
        f"a grip of {format_mass(club.grip_mass)}, a shaft of {format_mass(shaft)} and a head of {format_mass(head)}"
    )
    if head <= 0 or not bounds("golf-club head.mass").accepts(head):
        least, most = club_weights(club)
        raise InputError(
            f"a club with a shaft of {format_mass(shaft)} and a grip of {format_mass(club.grip_mass)} weighs "
            f"{format_mass(least)} to {format_mass(most)}, by its head; given was {format_mass(mass)}. "
            "Check the weight, the shaft and the balance"
        )
    heavier = head / club.head.mass
    changed = {name: heavier * getattr(club.head, name) for name in ("mass", "moi", "roll_moi")}
    return club.replaced(head=club.head.replaced(**changed)), f"Its weight, {format_mass(mass)}, is {parts}."


def club_weights(club: GolfClub) -> tuple[float, float]:
    """Return the least and the greatest weight that a club with this shaft has, kg: the lightest and heaviest head."""
    lightest, heaviest = fine("golf-club head.mass")
    rest = rigid_body(beam_model(club)).mass - club.head.mass
    return rest + lightest, rest + heaviest


def with_shaft(club: GolfClub, material: Material) -> GolfClub:
    """Return a club with a shaft of another material that bends as before.

    What bends a thin tube is its modulus times its wall, so a stiffer material has a thinner wall.
    """
    thinner = club.material.longitudinal_modulus / material.longitudinal_modulus
    return _with_wall(club.replaced(material=material), thinner)


def _balanced(club: GolfClub, mass: float, balance: float) -> GolfClub:
    """Return a club with the shaft's wall that its weight and balance point need, whatever its head then weighs."""
    from scipy.optimize import brentq

    middle = club.length - club.head.height / 2
    walls = [size for _, size in club.wall]
    thinnest, thickest = fine("golf-club wall")
    factors = (thinnest / min(walls), thickest / max(walls))

    def excess(factor: float) -> float:
        """Return by how much the balance point is too far out, m."""
        mass_of_parts, first, _ = moments(BeamModel(_with_wall(club, factor), 1.0, 0.0, ()))
        return (first + (mass - mass_of_parts) * middle) / mass - balance

    out, near = (excess(factor) for factor in factors)
    if not near <= 0 <= out:
        raise InputError(
            f"a club of {format_mass(mass)} with this shaft can balance {format_length(balance + near)} to "
            f"{format_length(balance + out)} from the butt; given was {format_length(balance)}"
        )
    return _with_wall(club, float(brentq(excess, *factors, xtol=1e-13)))


def _with_wall(club: GolfClub, factor: float) -> GolfClub:
    return club.replaced(wall=_scaled(club.wall, factor))
