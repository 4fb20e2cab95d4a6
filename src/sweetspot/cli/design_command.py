"""`sweetspot design`: a bat shaped for a batter, and what it costs."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.batter import DEFAULT_BATTER, BatterOptions
from sweetspot.cli.options.limits import (
    DEFAULT_LIMITS,
    LimitOptions,
    bands_of,
    deepest_cup_of,
    handle_of,
    kept_measures,
    league_of,
    materials_of,
    ranges_of,
)
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import given, refuse_unused
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.design_question import Designed

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
    generations: Annotated[int, Parameter(help="Generations to look at; Ctrl-C ends earlier and keeps the front.")] = 8
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

    Every gain has its interval; --uncertainty is understood and changes nothing.
    """
    from sweetspot import catalog
    from sweetspot.answers.design import design_answer
    from sweetspot.answers.design_question import DesignQuestion
    from sweetspot.catalog.sports import sport
    from sweetspot.cli.options.batter import batter_of
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import present, progress
    from sweetspot.reports.design.document import design_document
    from sweetspot.reports.quantities import reader

    present_bat = catalog.load_implement(bat)
    refuse_unused(given(swing, "same_speed"), "a bat that was changed", "ask report, hit or play of it")
    conditions = conditions_for(present_bat, swing)
    question = DesignQuestion(
        bat=present_bat,
        batter=batter_of(batter, present_bat, conditions),
        conditions=conditions,
        wants=tuple(name.replace("-", "_") for name in want or ("exit-speed", "zone")),
        keep=kept_measures(limit),
        bands=bands_of(limit),
        handle=handle_of(limit),
        deepest_cup=deepest_cup_of(limit, present_bat),
        ranges=ranges_of(limit),
        materials=materials_of(limit),
        league=league_of(present_bat, limit),
        pick=search.pick,
        seed=search.seed,
        population=search.population,
        generations=search.generations,
        resume=search.resume,
    )

    def first(design: Designed) -> None:
        from sweetspot.reports.design.words import first_words
        from sweetspot.reports.sentences import read

        words = first_words(design)
        print(f"sweetspot: {read(words, reader(output.units, sport(present_bat.sport).words))}", file=sys.stderr)

    return present(design_document(design_answer(question, progress=progress, first=first)), output)
