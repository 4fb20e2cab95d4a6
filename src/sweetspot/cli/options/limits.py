"""What a designed bat has to keep: bands of its weight and balance, its grip, its wood and a league's rules."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.rules import League
    from sweetspot.design.limits import Limit
    from sweetspot.design.measures import Bench
    from sweetspot.design.variables import Space
    from sweetspot.equipment.implement import Implement
    from sweetspot.equipment.material import Material
    from sweetspot.units import Kind

Kept = Literal["mass", "moi", "wood", "balance", "grip", "nothing"]
KINDS: dict[str, Kind] = {"mass": "mass", "moi": "moi", "balance_point": "length", "durability": "ratio"}

EXAMPLES: dict[str, str] = {
    "mass": "30oz:31.5oz", "moi": "10500oz*in^2:11000oz*in^2", "length": "22in:23in", "ratio": "1.1:",
}  # fmt: skip

RANGES = {"cup_diameter": "1in:2in", "knob": "1.7in:2.2in", "length": "33in:34.5in"}


@Parameter(name="*")
@dataclass(frozen=True)
class LimitOptions:
    """Limits of a design."""

    keep: Annotated[
        list[Kept] | None,
        Parameter(
            negative="",
            help="What stays within 1 % of the present bat's; may be given again. Default: mass, moi and wood: its "
            "density.",
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
            name=["--wood", "--material"], negative="",
            help="Species of the catalogue, or a hollow bat's metal or laminate; given again, the best of them is "
            "looked for. Default: the present bat's.",
        ),
    ] = None  # fmt: skip
    league: Annotated[
        str,
        Parameter(
            help="Whose rules to keep: a league of the catalogue, or nobody. Default: the sport's, mlb for wood."
        ),
    ] = ""


DEFAULT_LIMITS = LimitOptions()


def materials_of(options: LimitOptions) -> list[Material | None]:
    """Return the materials that are looked at, each once; None: the present bat's."""
    from sweetspot import catalog

    return [catalog.material(name) for name in dict.fromkeys(options.wood or ())] or [None]


def space_of(bat: Implement, options: LimitOptions, material: Material | None) -> Space:
    """Return what may change of a bat, built of this material."""
    from sweetspot.design.usual_limits import space_of as space_around
    from sweetspot.plausibility import parse

    deepest = parse(options.cup, "length", "--cup")
    if not 0 <= deepest < bat.length / 4:
        raise InputError(f"--cup was given as {options.cup}; allowed is 0in to a quarter of the bat")
    given = {"cup_diameter": options.cup_diameter, "knob": options.knob, "length": options.length}
    ranges = {name: _range_of(name, text) for name, text in given.items() if text is not None}
    return space_around(bat, deepest_cup=deepest, material=material, ranges=ranges)


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

    if options.league == "nobody":
        return None
    usual = usual_league(bat)
    chosen = options.league or usual
    return None if chosen is None else league(chosen)


def limits_of(bench: Bench, options: LimitOptions, rules: League | None) -> tuple[Limit, ...]:
    """Return every limit of the question."""
    from sweetspot.design.usual_limits import kept_limits
    from sweetspot.plausibility import parse

    bands = {"mass": options.mass, "moi": options.moi, "balance_point": options.balance,
             "durability": options.durability}  # fmt: skip
    given = {name: text for name, text in bands.items() if text is not None}
    keep = ("mass", "moi", "wood") if options.keep is None else options.keep
    names = [
        {"balance": "balance_point", "grip": "handle", "wood": "density"}.get(name, name)
        for name in keep
        if name != "nothing"
    ]
    kept = [name for name in names if name not in given]
    limits = [_band_of(name, text, KINDS[name]) for name, text in given.items()]
    handle = None if options.handle is None else parse(options.handle, "length", "--handle")
    return kept_limits(bench, kept, bands=limits, league=rules, handle=handle)


def _band_of(name: str, text: str, kind: Kind) -> Limit:
    from sweetspot.design.limits import Limit
    from sweetspot.plausibility import parse

    option = f"--{'balance' if name == 'balance_point' else name}"
    parts = text.split(":")
    if len(parts) != 2 or not any(part.strip() for part in parts):
        raise InputError(f"{option} was given as {text!r}; give a band LOW:HIGH, such as {EXAMPLES[kind]}")
    low, high = (parse(part, kind, option) if part.strip() else None for part in parts)
    return Limit(name, low, high, "as given")
