"""`sweetspot design`: a bat shaped for a batter, and what it costs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.batter import DEFAULT_BATTER, BatterOptions
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import SwingOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.rules import League
    from sweetspot.design.limits import Limit
    from sweetspot.design.measures import Bench
    from sweetspot.design.variables import Space
    from sweetspot.equipment.bat import Bat
    from sweetspot.units import Kind

DEFAULT_SWING = SwingOptions()
Want = Literal["exit-speed", "zone", "best", "sting", "swing-time"]
Kept = Literal["mass", "moi", "balance", "grip", "nothing"]
WITHIN = 0.01


def design(
    bat: Annotated[str, Parameter(help="The batter's present bat: a name of the catalogue or a TOML file.")] = "mlb-a",
    /,
    *,
    want: Annotated[
        list[Want] | None,
        Parameter(
            negative="", help="What to make better; may be given up to three times. Default: exit-speed, then zone."
        ),
    ] = None,
    keep: Annotated[
        list[Kept] | None,
        Parameter(
            negative="", help="What stays within 1 % of the present bat's; may be given again. Default: mass and moi."
        ),
    ] = None,
    mass: Annotated[
        str | None, Parameter(help="Band instead of --keep mass: 30oz:31.5oz, or 30oz: for at least.")
    ] = None,
    moi: Annotated[
        str | None, Parameter(help="Band of the moment of inertia about 6 in: 10500oz*in^2:11000oz*in^2.")
    ] = None,
    balance: Annotated[str | None, Parameter(help="Band of the balance point, from the knob end: 22in:23in.")] = None,
    handle: Annotated[
        str | None, Parameter(help="Smallest diameter of the grip; default: the present one's, for breaking's sake.")
    ] = None,
    cup: Annotated[str, Parameter(help="Deepest cup that may be turned; 0in: none.")] = "1in",
    wood: Annotated[str | None, Parameter(help="Species of the catalogue; default: the present bat's.")] = None,
    league: Annotated[
        str,
        Parameter(help="Whose rules to keep: a league of the catalogue, or nobody. Default: mlb for wood, else ncaa."),
    ] = "",
    batter: BatterOptions = DEFAULT_BATTER,
    pick: Annotated[
        int, Parameter(help="Which bat of the front to tell about, from 1: the best in the first want.")
    ] = 1,
    seed: Annotated[int, Parameter(help="Of the random numbers; the same seed gives the same front.")] = 1,
    population: Annotated[int, Parameter(help="Bats of a generation.")] = 48,
    generations: Annotated[
        int, Parameter(help="Generations to look at; Ctrl-C ends earlier and keeps the front.")
    ] = 30,
    resume: Annotated[Path | None, Parameter(help="search.json of an earlier --out, to go on from.")] = None,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Shape a bat for a batter: where the wood should go, what that gains beside wood that differs, and who pays."""
    from sweetspot import catalog
    from sweetspot.cli.options.batter import batter_of
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import present, progress
    from sweetspot.design.answer import designed, told
    from sweetspot.design.fronts import Front, Question, resumed
    from sweetspot.design.measures import bench_of
    from sweetspot.numerics.text_files import read_text
    from sweetspot.report.design.document import design_document

    if seed < 0:
        raise InputError(f"--seed was given as {seed}; allowed is a whole number from 0 up")
    if pick < 1:
        raise InputError(f"--pick was given as {pick}; allowed is a bat of the front, from 1")
    own = catalog.load_bat(bat)
    if wood is not None:
        own = own.with_material(catalog.material(wood))
    space, rules = _space(own, cup), _league(own, league)
    conditions = conditions_for(own, swing)
    bench = bench_of(space, batter_of(batter, own, conditions), conditions)
    limits = _limits(bench, keep, {"mass": mass, "moi": moi, "balance_point": balance}, handle, rules)
    wants = tuple(name.replace("-", "_") for name in want or ("exit-speed", "zone"))
    question = Question(wants, limits, seed=seed, population=population, generations=generations)
    after = None
    if resume is not None:
        text = read_text(resume, most=50_000_000, advice="give the search.json of an earlier --out")
        after = resumed(bench, question, text)
    with progress("designing") as report:
        done = after[0] if after else 0

        def say(generation: int, front: Front) -> None:
            nonlocal done
            done = generation
            report(generation * population, generations * population, _so_far(front))

        front = designed(bench, question, after=after, progress=say)
    answer = told(bench, question, front, pick=pick, league=rules)
    return present(design_document(answer, complete=front.generation >= generations), output)


def _so_far(front: object) -> str:
    from sweetspot.design.fronts import Front
    from sweetspot.units import INCH, MPH

    assert isinstance(front, Front)
    if len(front) == 0:
        return "no bat keeps every limit yet"
    values = front.measured.values
    return (
        f"front of {len(front)}: {values['exit_speed'].max() / MPH:.1f} mph over the contacts, zone up to "
        f"{values['zone'].max() / INCH:.1f} in"
    )


def _space(bat: Bat, cup: str) -> Space:
    from sweetspot.design.variables import hollow_space, turned_space
    from sweetspot.units import parse

    if bat.shell is not None:
        return hollow_space(bat)
    deepest = parse(cup, "length", "--cup")
    if not 0 <= deepest < bat.length / 4:
        raise InputError(f"--cup was given as {cup}; allowed is 0in to a quarter of the bat")
    return turned_space(bat, deepest_cup=deepest)


def _league(bat: Bat, name: str) -> League | None:
    from sweetspot.catalog.rules import league

    if name == "nobody":
        return None
    return league(name or ("mlb" if bat.material.family == "wood" and bat.shell is None else "ncaa"))


def _limits(
    bench: Bench, keep: list[Kept] | None, bands: dict[str, str | None], handle: str | None, rules: League | None
) -> tuple[Limit, ...]:
    """Return every limit of the question."""
    from sweetspot.design.gain import present_measured
    from sweetspot.design.limits import Limit, band, lathe_limits, league_limits
    from sweetspot.design.variables import TurnedSpace
    from sweetspot.equipment.bat import Bat
    from sweetspot.units import parse

    kinds: dict[str, Kind] = {"mass": "mass", "moi": "moi", "balance_point": "length"}
    present = bench.space.present
    now = present_measured(bench).values
    given = {name: text for name, text in bands.items() if text is not None}
    kept = [{"balance": "balance_point"}.get(name, name) for name in (keep if keep is not None else ("mass", "moi"))]
    found = [band(name, float(now[name][0]), part=WITHIN) for name in kept if name in kinds and name not in given]
    found += [_band_of(name, text, kinds[name]) for name, text in given.items()]
    if rules is not None and isinstance(present, Bat):
        found += league_limits(rules, present)
    if isinstance(bench.space, TurnedSpace):
        least = float(now["handle"][0]) if handle is None else parse(handle, "length", "--handle")
        if "grip" in kept:
            found.append(band("handle", float(now["handle"][0]), part=0.002))
        else:
            found.append(Limit("handle", 0.999 * least, None, "breaking"))
        found += lathe_limits()
    return tuple(found)


def _band_of(name: str, text: str, kind: Kind) -> Limit:
    from sweetspot.design.limits import Limit
    from sweetspot.units import parse

    option = f"--{'balance' if name == 'balance_point' else name}"
    parts = text.split(":")
    if len(parts) != 2 or not any(part.strip() for part in parts):
        raise InputError(
            f"{option} was given as {text!r}; give a band LOW:HIGH, with a unit on either side of the colon"
        )
    low, high = (parse(part, kind, option) if part.strip() else None for part in parts)
    return Limit(name, low, high, "as given")
