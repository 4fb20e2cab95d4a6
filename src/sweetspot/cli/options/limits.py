"""What a designed bat has to keep: bands of its weight and balance, its grip, its wood and a league's rules."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.rules import League
    from sweetspot.designs.constraints import Limit
    from sweetspot.equipment.implement import Implement
    from sweetspot.equipment.material import Material
    from sweetspot.units import Kind

Kept = Literal["mass", "moi", "wood", "balance", "grip", "nothing"]
KINDS: dict[str, Kind] = {"mass": "mass", "moi": "moi", "balance_point": "length", "durability": "ratio"}

BANDS = {"mass": "mass", "moi": "moi", "balance_point": "balance", "durability": "durability"}
"""Options that give a band, by what they limit."""
MEASURED = {"balance": "balance_point", "grip": "handle", "wood": "density"}
"""What people call a measure otherwise."""
EXAMPLES: dict[str, str] = {
    "mass": "30oz:31.5oz",
    "moi": "10500oz*in^2:11000oz*in^2",
    "length": "22in:23in",
    "ratio": "1.1:",
}
RANGES = {"cup_diameter": "1in:2in", "knob": "1.7in:2.2in", "length": "33in:34.5in"}


@Parameter(name="*")
@dataclass(frozen=True)
class LimitOptions:
    """Limits of a design."""

    keep: Annotated[
        list[Kept] | None,
        Parameter(
            negative="",
            help="What stays as it is, within 0.1 %; may be given again. Default: mass, moi and wood: its density.",
        ),
    ] = None
    mass: Annotated[str | None, Parameter(help="Band instead of --keep mass: 30oz:31.5oz, or 30oz: for at least.")] = (
        None
    )
    moi: Annotated[
        str | None, Parameter(help="Band of the moment of inertia about 6 in: 10500oz*in^2:11000oz*in^2.")
    ] = None
    balance: Annotated[str | None, Parameter(help="Band of the balance point, from the knob end: 22in:23in.")] = None
    handle: Annotated[
        str | None, Parameter(help="Smallest diameter of the grip; default: the present one's, for breaking's sake.")
    ] = None
    durability: Annotated[
        str | None,
        Parameter(help="Band of the strain that handle and wall bear over the greatest of these contacts: 1.1: or so."),
    ] = None
    cup: Annotated[str, Parameter(help="Deepest cup that may be turned; 0in: none.")] = "1in"
    cup_diameter: Annotated[
        str | None, Parameter(help="Range in which the cup's width may change: 1in:2in; default: it stays.")
    ] = None
    knob: Annotated[
        str | None, Parameter(help="Range in which the knob's diameter may change: 1.7in:2.2in; default: it stays.")
    ] = None
    length: Annotated[
        str | None, Parameter(help="Range in which the length may change: 33in:34.5in; default: it stays.")
    ] = None
    wood: Annotated[
        list[str] | None,
        Parameter(
            name=["--wood", "--material"],
            negative="",
            help="Species of the catalogue, or a hollow bat's metal or laminate; given again, the best of them is "
            "looked for. Default: the present bat's.",
        ),
    ] = None
    league: Annotated[
        str,
        Parameter(help="Whose rules to keep: a league of the catalogue, or none. Default: the sport's, mlb for wood."),
    ] = ""


DEFAULT_LIMITS = LimitOptions()


def materials_of(options: LimitOptions) -> tuple[Material, ...]:
    """Return the materials that are looked at, each once; none: the present bat's."""
    from sweetspot import catalog

    return tuple(catalog.material(name) for name in dict.fromkeys(options.wood or ()))


def deepest_cup_of(options: LimitOptions, bat: Implement) -> float:
    """Return how deep a cup in m may be turned."""
    from sweetspot.plausibility import parse

    deepest = parse(options.cup, "length", "--cup")
    if not 0 <= deepest < bat.length / 4:
        raise InputError(f"--cup was given as {options.cup}; allowed is 0in to a quarter of the bat")
    return deepest


def ranges_of(options: LimitOptions) -> dict[str, tuple[float, float]]:
    """Return least and most of what may change besides the outline, m."""
    given = {"cup_diameter": options.cup_diameter, "knob": options.knob, "length": options.length}
    return {name: _range_of(name, text) for name, text in given.items() if text is not None}


def _range_of(name: str, text: str) -> tuple[float, float]:
    from sweetspot.plausibility import parse

    option, parts = f"--{name.replace('_', '-')}", text.split(":")
    if len(parts) != 2 or not all(part.strip() for part in parts):
        raise InputError(f"{option} was given as {text!r}; give a range LOW:HIGH, such as {RANGES[name]}")
    low, high = (parse(part, "length", option) for part in parts)
    return low, high


def league_of(bat: Implement, options: LimitOptions) -> League | None:
    """Return the league whose rules are kept, if any."""
    from sweetspot.catalog.rules import league, usual_league

    chosen = None if options.league == "none" else options.league or usual_league(bat)
    return None if chosen is None else league(chosen)


def kept_measures(options: LimitOptions) -> tuple[str, ...]:
    """Return the measures that stay as the present bat has them."""
    keep = ("mass", "moi", "wood") if options.keep is None else options.keep
    names = (MEASURED.get(name, name) for name in keep if name != "nothing")
    return tuple(name for name in names if getattr(options, BANDS.get(name, ""), None) is None)


def bands_of(options: LimitOptions) -> tuple[Limit, ...]:
    """Return the bands that were given."""
    given = {measure: getattr(options, name) for measure, name in BANDS.items()}
    return tuple(_band_of(measure, text, KINDS[measure]) for measure, text in given.items() if text is not None)


def handle_of(options: LimitOptions) -> float | None:
    """Return the smallest diameter in m that the grip may have; None: the present one's."""
    from sweetspot.plausibility import parse

    return None if options.handle is None else parse(options.handle, "length", "--handle")


def _band_of(measure: str, text: str, kind: Kind) -> Limit:
    from sweetspot.designs.constraints import Limit
    from sweetspot.plausibility import parse

    option, parts = f"--{BANDS[measure]}", text.split(":")
    if len(parts) != 2 or not any(part.strip() for part in parts):
        raise InputError(f"{option} was given as {text!r}; give a band LOW:HIGH, such as {EXAMPLES[kind]}")
    low, high = (parse(part, kind, option) if part.strip() else None for part in parts)
    return Limit(measure, low, high, "as given")
