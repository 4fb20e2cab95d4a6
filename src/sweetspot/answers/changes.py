"""Changes to an implement that people ask about: one entry a change, read once, for command, page and Python alike.

What is changed stays the piece that it was: weights come on top, sizes are cut from it, what is not known of it is the
same before and after. The amount of some changes cannot be known. Their entry has a published range; the ends of
it are carried as doubt.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sweetspot.calibration.bat_table import MOISTURES, STIFFER, USUAL_MOISTURE
from sweetspot.calibration.unknowns import barrel_parts
from sweetspot.catalog.materials import material
from sweetspot.dynamics.local_compliance import across_grain
from sweetspot.dynamics.weight_match import barrel_start
from sweetspot.equipment.bat import USUAL_CUP, WIDEST_CUP, Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.implement import AddedMass, Implement
from sweetspot.equipment.laminate import Laminate
from sweetspot.equipment.shell import Shell, Stations, between
from sweetspot.errors import InputError
from sweetspot.plausibility.reading import parse, parse_position
from sweetspot.units import INCH, Kind, format_length

HOLE, PLUG, WIDEST_HOLE = 1 * INCH, 1 * INCH, 3 * INCH
"""m; usual width of a hole and length of the wood that closes a filled one, as in the published tests
[nathan_corknote]; and the widest that is read."""
NEAR_THE_END = 0.5 * INCH
"""m from the end of a bat, where a weight for knob or barrel end sits [our choice]."""
ROLLED = (0.48, 0.74)
"""Part of the resin's stiffness that breaks: slow-pitch bats gain 3 to 5 mph by 500 hits [russell2008breakin], and the
catalogue's gains 3 mph by the first and 5 mph by the second. That the resin between the fibres is what breaks, and no
fibre, is assumed."""
KNOCKED_IN = (0.0, 0.3)
"""Part by which willow gets stiffer across its grain: knocking in took 0.24 % of the batted-ball speed [singh2008], and
the middle of this range does so of the catalogue's bat, its ends nothing and twice that. That the dent alone changes is
assumed: no hardness of a face before and after was read."""
SEPARATOR = re.compile(r"(?<!\d),\s*")
WORDS = re.compile(
    r"\s*(?P<name>[a-z][a-z-]*)?\s*(?P<amount>[^@x×]*?)\s*(?:[x×]\s*(?P<width>[^@]+?)\s*)?"
    r"(?:@\s*(?P<place>.+?)\s*)?$",
    re.IGNORECASE,
)
FILLS: Mapping[str, str] = {"cork": "cork", "rubber": "rubber", "foam": "polyurethane-foam"}
"""Fillings of a drilled bat: how the change is called, and the material of the catalogue."""

Maker = Callable[[Implement, float, float], Implement]
"""Returns an implement changed by an amount at a place, or by a hole of a depth and a width, all in SI."""


@dataclass(frozen=True)
class _Change:
    """One kind of change.

    Parameters
    ----------
    make : see `Maker`.
    kind : of its amount.
    usual : amount where none is written; None: it must be.
    allowed : least and most, SI.
    placed : whether it takes a place, ``@52cm``.
    wide : whether it is a hole, which may have a width behind its depth, ``x 0.75 in``.
    open_range : of the amount where none is written, because it cannot be known.
    example : as it is written.
    """

    make: Maker
    kind: Kind
    allowed: tuple[float, float]
    example: str
    usual: float | None = None
    placed: bool = False
    wide: bool = False
    open_range: tuple[float, float] | None = None


class Changed(NamedTuple):
    """An implement after changes, and the same at both ends of what cannot be known; None: all is known."""

    implement: Implement
    ends: tuple[Implement, Implement] | None = None


def changed(implement: Implement, text: str) -> Changed:
    """Return an implement after changes as people write them: "shaved 0.2 mm", "lead 6 g @ 52 cm, 6 g @ 12 cm".

    Raises `InputError` for a change that is not known, or that this implement cannot have.

    >>> from sweetspot import catalog
    >>> changed(catalog.bat("r161-ash"), "cup 0.9 in, knob-weight 2 oz").implement.name
    'R161, white ash, cup 0.9 in, knob-weight 2 oz'
    """
    name, amounts, open_ended = "", [], False
    low = middle = high = implement
    for part in SEPARATOR.split(text):
        words = WORDS.match(part)
        name = (words["name"] or name).lower() if words else name
        if words is None or name not in CHANGES:
            examples = ", ".join(f'"{change.example}"' for change in CHANGES.values())
            raise InputError(f"{text[:60]!r} names no change that is known; write for example {examples}")
        change = CHANGES[name]
        place = _width(words["width"], part) if change.wide else _place(implement, change, words["place"], part)
        if words["width"] is not None and not change.wide:
            raise InputError(f"{part.strip()!r} has a width, and is no hole; write for example {change.example!r}")
        amount = _amount(change, words["amount"], part)
        low, middle, high = (
            _made(each, name, size, place) for each, size in zip((low, middle, high), amount, strict=True)
        )
        open_ended |= amount[0] < amount[2]
        amounts.append(part.strip() if words["name"] else f"{name} {part.strip()}")
    label = f"{implement.name}, {', '.join(amounts)}"
    return Changed(middle.replaced(name=label), (low, high) if open_ended else None)


def _made(implement: Implement, name: str, amount: float, place: float) -> Implement:
    try:
        return CHANGES[name].make(implement, amount, place)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None


def _amount(change: _Change, written: str, part: str) -> tuple[float, float, float]:
    """Return least, likeliest and most of the amount in SI."""
    if written:
        amount = parse(written, change.kind, "amount")
        low, high = change.allowed
        if not low <= amount <= high:
            raise InputError(f"{part.strip()!r} is more or less than can be; write for example {change.example!r}")
        return amount, amount, amount
    if change.open_range is not None:
        low, high = change.open_range
        return low, (low + high) / 2, high
    if change.usual is None:
        raise InputError(f"{part.strip()!r} says no amount; write for example {change.example!r}")
    return (change.usual,) * 3


def _place(implement: Implement, change: _Change, written: str | None, part: str) -> float:
    if change.placed != (written is not None):
        say = "says no place" if change.placed else "takes no place"
        raise InputError(f"{part.strip()!r} {say}; write for example {change.example!r}")
    return math.nan if written is None else parse_position(written, length=implement.length, what="place")


def _width(written: str | None, part: str) -> float:
    width = HOLE if written is None else parse(written, "length", "bore_diameter")
    if not 0 < width <= WIDEST_HOLE:
        raise InputError(f"{part.strip()!r}: a hole of that width fits no bat; write for example 'cork 10 in x 1 in'")
    return width


def weight_texts(weights: Sequence[str]) -> list[str]:
    """Return the changes that weights stand for: "6 g @ 52 cm" is lead of 6 g there.

    >>> weight_texts(["6g@52cm,6g@12cm"])
    ['lead 6g@52cm,6g@12cm']
    """
    return [f"lead {weight}" for weight in weights]


def _bat(implement: Implement) -> Bat:
    if not isinstance(implement, Bat):
        raise InputError(f"{implement.name} is not a round bat, and only such a bat can be changed so")
    return implement


def _wooden(implement: Implement) -> Bat:
    bat = _bat(implement)
    if bat.shell is not None or bat.material.family != "wood":
        raise InputError(f"{bat.name} is not turned from wood; only such a bat can be changed so")
    return bat


def _shell_of(implement: Implement) -> tuple[Bat, Shell]:
    bat = _bat(implement)
    if bat.shell is None:
        raise InputError(f"{bat.name} is solid and has no wall; only a hollow bat can be changed so")
    return bat, bat.shell


def _lead(implement: Implement, mass: float, place: float) -> Implement:
    """Return an implement with a weight fixed to it."""
    if isinstance(implement, Bat):
        return implement.weighted(position=place, mass=mass)
    weights = (*implement.added, AddedMass(position=place, mass=mass))
    return implement.replaced(added=weights, original=implement)


def _knob_weight(implement: Implement, mass: float, _: float) -> Implement:
    return _lead(implement, mass, NEAR_THE_END)


def _end_load(implement: Implement, mass: float, _: float) -> Implement:
    bat = _bat(implement)
    return bat.weighted(position=bat.length - NEAR_THE_END, mass=mass).replaced(altered=True)


def _shaved(implement: Implement, depth: float, _: float) -> Implement:
    """Return a hollow bat whose innermost wall is that much thinner in the barrel; the outside stays."""
    bat, shell = _shell_of(implement)
    start = barrel_start(bat)

    def thinner(wall: Stations) -> Stations:
        here = {place for place in (start * (1 - 1e-6), start) if wall[0][0] < place < wall[-1][0]}
        places = sorted({place for place, _ in wall} | here)
        cut = [(place, float(between(wall, place)) - (depth if place >= start else 0.0)) for place in places]
        if min(thickness for _, thickness in cut) <= 0:
            raise InputError(f"nothing is left of a wall of {_thinnest(wall, start)} after {1e3 * depth:.2g} mm")
        return tuple(cut)

    sleeve = shell.inner_wall
    if sleeve is None:
        changes: dict[str, object] = {"wall": thinner(shell.wall)}
    else:
        changes = {"inner_wall": sleeve.replaced(wall=thinner(sleeve.wall))}
    return bat.changed(f"{bat.name}, shaved", shell=shell.replaced(**changes), altered=True)


def _thinnest(wall: Stations, start: float) -> str:
    return f"{1e3 * min(thickness for place, thickness in wall if place >= start):.2f} mm"


def _broken_in(implement: Implement, lost: float, _: float) -> Implement:
    """Return a composite bat whose resin has lost a part of its stiffness; the fibres and their stiffness stay."""
    bat, shell = _shell_of(implement)
    sleeve = shell.inner_wall
    if shell.laminate is None and (sleeve is None or sleeve.laminate is None):
        raise InputError(
            f"the barrel of {bat.name} is of {bat.material.name}, in which no resin breaks; use changed an aluminum "
            "bat in the laboratory by less than 1 mph (drane2003)"
        )
    changes: dict[str, object] = {}
    if shell.laminate is not None:
        changes["laminate"] = _softened(shell.laminate, lost)
    if sleeve is not None and sleeve.laminate is not None:
        changes["inner_wall"] = sleeve.replaced(laminate=_softened(sleeve.laminate, lost))
    return bat.changed(f"{bat.name}, broken in", shell=shell.replaced(**changes))


def _rolled(implement: Implement, lost: float, _: float) -> Implement:
    return _bat(_broken_in(implement, lost, 0.0)).replaced(altered=True)


def _softened(laminate: Laminate, lost: float) -> Laminate:
    """Return a laminate whose plies are softer across their fibres and in shear, where the resin carries."""
    plies = []
    for ply in laminate.plies:
        made_of, remaining = ply.material, 1 - lost
        softer = made_of.replaced(
            transverse_modulus=made_of.across * remaining, shear_modulus=made_of.shear * remaining
        )
        plies.append(ply.replaced(material=softer))
    return laminate.replaced(plies=tuple(plies))


def _moist(implement: Implement, moisture: float, _: float) -> Implement:
    """Return a wooden bat that took up water, or dried: from 12 % of its dry weight to another moisture.

    It weighs (1 + u) / 1.12 as much, and E and G fall by 1.5 % for each per cent; see `at_usual_moisture`.
    """
    bat = _wooden(implement)
    heavier = (1 + moisture) / (1 + USUAL_MOISTURE)
    stiffer = math.exp(-STIFFER * (moisture - USUAL_MOISTURE))
    wood = bat.material
    changes: dict[str, object] = {
        "density": wood.density * heavier,
        "longitudinal_modulus": wood.longitudinal_modulus * stiffer,
    }
    if wood.shear_modulus is not None:
        changes["shear_modulus"] = wood.shear_modulus * stiffer
    if wood.density_range is not None:
        low, high = wood.density_range
        changes |= {"density_range": (low * heavier, high * heavier)}
    return bat.changed(f"{bat.name}, moist", material=wood.replaced(**changes))


def _hardened(implement: Implement, stiffer: float, _: float) -> Implement:
    """Return a cricket bat whose willow is stiffer across its grain: the ball dents the face less, and more itself.

    Its weight stays, and its stiffness along the grain, which bends.
    """
    if not isinstance(implement, CricketBat):
        raise InputError(f"{implement.name} is no cricket bat; only its willow is pressed and knocked in")
    willow = implement.material
    harder = willow.replaced(transverse_modulus=(1 + stiffer) * across_grain(willow))
    return implement.replaced(material=harder, original=implement)


def _drilled(implement: Implement, depth: float, width: float) -> Implement:
    return _wooden(implement).drilled(diameter=width, depth=depth)


def _filled(fill: str) -> Maker:
    """Return the change that drills a bat, fills the hole and closes it with wood."""

    def made(implement: Implement, depth: float, width: float) -> Implement:
        bat = _wooden(implement)
        return bat.corked(diameter=width, depth=depth, fill=material(fill), plug=min(PLUG, depth / 2))

    return made


def _cupped(implement: Implement, depth: float, _: float) -> Implement:
    bat = _wooden(implement)
    usual = min(USUAL_CUP, WIDEST_CUP * float(bat.diameter_at(bat.length)))
    return bat.cupped(diameter=usual if bat.cup is None else bat.cup.diameter, depth=depth)


def _cut(implement: Implement, cut: float, _: float) -> Implement:
    """Return a wooden bat sawn off at the barrel end."""
    bat = _wooden(implement)
    profile, end = _outline(bat), bat.length - cut
    stations = tuple((place, size) for place, size in profile if place < end)
    return bat.reshaped((*stations, (end, float(bat.diameter_at(end))))).replaced(altered=True)


def _handle(implement: Implement, thicker: float, _: float) -> Implement:
    """Return a wooden bat whose handle is turned thicker or thinner; the knob and the barrel stay."""
    bat = _wooden(implement)
    profile = _outline(bat)
    places, diameters = np.array(profile).T
    whole = 1 - barrel_parts(profile, bat.length)
    new = diameters + thicker * np.where(places < KNOB * bat.length, 0.0, whole)
    return bat.reshaped(tuple(zip(places.tolist(), new.tolist(), strict=True)))


def _taper(implement: Implement, farther: float, _: float) -> Implement:
    """Return a wooden bat whose taper is turned nearer to the tip, or to the knob; knob and tip stay where they are."""
    bat = _wooden(implement)
    places, diameters = np.array(_outline(bat)).T
    part = places / bat.length
    moved = places + farther * np.interp(part, [0.0, KNOB, 0.3, 0.8, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0])
    if np.any(np.diff(moved) <= 0):
        raise InputError(f"a taper cannot be moved by {format_length(farther)} on {bat.name}; move it by less")
    return bat.reshaped(tuple(zip(moved.tolist(), diameters.tolist(), strict=True)))


def _outline(bat: Bat) -> Stations:
    if bat.profile is None:
        raise InputError(f"{bat.name} has no outline, only a mass per length; give its diameters")
    return bat.profile


KNOB = 0.06
"""Of the length, up to where the knob reaches: 2 in of 33 [our choice]."""
WEIGHT, HOLE_DEPTH = (1e-4, 0.25), (1e-3, 0.51)
CHANGES: dict[str, _Change] = {
    "lead": _Change(_lead, "mass", WEIGHT, "lead 6 g @ 52 cm", placed=True),
    "knob-weight": _Change(_knob_weight, "mass", WEIGHT, "knob-weight 2 oz"),
    "end-load": _Change(_end_load, "mass", WEIGHT, "end-load 1 oz"),
    "cut": _Change(_cut, "length", (1e-3, 0.1), "cut 0.5 in"),
    "shaved": _Change(_shaved, "length", (1e-5, 3e-3), "shaved 0.2 mm"),
    "rolled": _Change(_rolled, "ratio", (0.0, 0.9), "rolled", open_range=ROLLED),
    "broken-in": _Change(_broken_in, "ratio", (0.0, 0.9), "broken-in", open_range=ROLLED),
    "moisture": _Change(_moist, "ratio", MOISTURES, "moisture 14 %"),
    "knocked-in": _Change(_hardened, "ratio", (0.0, 2.0), "knocked-in", open_range=KNOCKED_IN),
    "pressed": _Change(_hardened, "ratio", (0.0, 2.0), "pressed 20 %"),
    "drilled": _Change(_drilled, "length", HOLE_DEPTH, "drilled 10 in", usual=10 * INCH, wide=True),
    **{
        name: _Change(_filled(fill), "length", HOLE_DEPTH, f"{name} 10 in x 1 in", usual=10 * INCH, wide=True)
        for name, fill in FILLS.items()
    },
    "cup": _Change(_cupped, "length", (1e-3, 0.06), "cup 0.9 in"),
    "handle": _Change(_handle, "length", (-5e-3, 1e-2), "handle -0.03 in"),
    "taper": _Change(_taper, "length", (-0.05, 0.05), "taper 1 in"),
}
"""By name; amounts are written with their unit, of a moisture and of rolling in per cent."""
