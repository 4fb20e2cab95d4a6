"""`sweetspot design`: a bat shaped for a batter, and what it costs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.batter import DEFAULT_BATTER, BatterOptions
from sweetspot.cli.options.limits import DEFAULT_LIMITS, LimitOptions, league_of, limits_of, materials_of, space_of
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.cli.options.unused import given, refuse_unused
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.design.fronts import Front, Question
    from sweetspot.design.measures import Bench
    from sweetspot.design.variables import Space

Want = Literal["exit-speed", "zone", "best", "sting", "swing-time", "durability"]


@Parameter(name="*")
@dataclass(frozen=True)
class SearchOptions:
    """How long to look, and for which bat of the front."""

    pick: Annotated[
        int, Parameter(help="Which bat of the front to tell about, from 1: the best in the first want.")
    ] = 1
    seed: Annotated[int, Parameter(help="Of the random numbers; the same seed gives the same front.")] = 1
    population: Annotated[int, Parameter(help="Bats of a generation.")] = 48
    generations: Annotated[int, Parameter(help="Generations to look at; Ctrl-C ends earlier and keeps the front.")] = 30
    resume: Annotated[Path | None, Parameter(help="search.json of an earlier --out, to go on from.")] = None

    def __post_init__(self) -> None:
        """Refuse what cannot be picked or sown."""
        if self.seed < 0:
            raise InputError(f"--seed was given as {self.seed}; allowed is a whole number from 0 up")
        if self.pick < 1:
            raise InputError(f"--pick was given as {self.pick}; allowed is a bat of the front, from 1")


DEFAULT_SEARCH = SearchOptions()


def design(
    bat: Annotated[
        str,
        Parameter(help="The present bat, racket or golf club: a name of the catalogue or a TOML file."),
    ] = "mlb-a",
    /,
    *,
    want: Annotated[
        list[Want] | None,
        Parameter(
            negative="", help="What to make better; may be given up to three times. Default: exit-speed, then zone."
        ),
    ] = None,
    limit: LimitOptions = DEFAULT_LIMITS,
    batter: BatterOptions = DEFAULT_BATTER,
    search: SearchOptions = DEFAULT_SEARCH,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Shape a bat for a batter: where the wood should go, what that gains beside wood that differs, and who pays.

    Every gain is told with its interval; --uncertainty is understood and changes nothing.
    """
    from sweetspot import catalog
    from sweetspot.cli.options.batter import batter_of
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import present
    from sweetspot.design.answer import best_of, told
    from sweetspot.design.fronts import Question
    from sweetspot.design.measures import bench_of
    from sweetspot.report.design.document import design_document

    own = catalog.load_implement(bat)
    materials, rules = materials_of(limit), league_of(own, limit)
    if search.resume is not None and len(materials) > 1:
        raise InputError(f"--resume goes on with one material, and {len(materials)} were given; give the one it was of")
    spaces = [space_of(own, limit, material) for material in materials]
    refuse_unused(given(swing, "same_speed"), "a bat that was changed", "ask report, hit or play of it")
    conditions = conditions_for(own, swing)
    wants = tuple(name.replace("-", "_") for name in want or ("exit-speed", "zone"))
    durable = "durability" in wants or limit.durability is not None
    player = batter_of(batter, own, conditions)

    def asked(space: Space) -> tuple[Bench, Question]:
        bench = bench_of(space, player, conditions, durable=durable)
        return bench, Question(
            wants, limits_of(bench, limit, rules), seed=search.seed, population=search.population,
            generations=search.generations,
        )  # fmt: skip

    questions = [asked(space) for space in spaces]
    fronts = _all_searched(questions, search)
    done = [number for number, front in enumerate(fronts) if front is not None]
    best = done[best_of([front for front in fronts if front is not None], wants[0])]
    (bench, question), front = questions[best], fronts[best]
    assert front is not None
    beside = [(one.name, front) for one, front in zip(materials, fronts, strict=True) if one is not None]
    answer = told(bench, question, front, pick=search.pick, league=rules, materials=beside)
    return present(design_document(answer, complete=front.generation >= search.generations), output)


def _all_searched(questions: Sequence[tuple[Bench, Question]], search: SearchOptions) -> list[Front | None]:
    """Return the front of every question; None where no bat keeps its limits, unless that is so of all."""
    fronts: list[Front | None] = []
    faults = []
    for bench, question in questions:
        try:
            fronts.append(_searched(bench, question, search))
        except InputError as fault:
            fronts.append(None)
            faults.append(fault)
    if len(faults) == len(questions):
        raise faults[0]
    return fronts


def _searched(bench: Bench, question: Question, search: SearchOptions) -> Front:
    """Return the front that the search comes to, which says on the way how far it is."""
    from sweetspot.cli.output import progress
    from sweetspot.design.answer import designed
    from sweetspot.design.fronts import resumed
    from sweetspot.numerics.text_files import read_text

    after = None
    if search.resume is not None:
        text = read_text(search.resume, most=50_000_000, advice="give the search.json of an earlier --out")
        after = resumed(bench, question, text)
    every = search.population
    with progress("designing") as report:
        return designed(
            bench, question, after=after,
            progress=lambda generation, front: report(generation * every, search.generations * every, _so_far(front)),
        )  # fmt: skip


def _so_far(front: Front) -> str:
    from sweetspot.units import INCH, MPH

    if len(front) == 0:
        return "no bat keeps every limit yet"
    values = front.measured.values
    return (
        f"front of {len(front)}: {values['exit_speed'].max() / MPH:.1f} mph over the contacts, zone up to "
        f"{values['zone'].max() / INCH:.1f} in"
    )
