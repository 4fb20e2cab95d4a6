"""A bat to be shaped for a batter as a question, its search, and one bat of the front with everything around it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sweetspot.analysis.certification.rules import Check, League, check_rules
from sweetspot.answers.answer import Progress
from sweetspot.designs.batter import Batter
from sweetspot.designs.constraints import Limit, findings_of, kept_limits
from sweetspot.designs.gain import Gain, HandleBending, gain_of, handle_bending, present_measured
from sweetspot.designs.local_search import design_front
from sweetspot.designs.measures import Bench, MeasuredDesigns, bench_of
from sweetspot.designs.pareto import GENERATIONS, POPULATION, DesignSearch, Front, resumed
from sweetspot.designs.spaces import space_of
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import read_text
from sweetspot.units import INCH, MPH

Searched = tuple[Bench, DesignSearch, Front | None]
"""A bench, what was looked for on it, and the front; None: no bat keeps every limit."""


@dataclass(frozen=True, kw_only=True)
class DesignQuestion:
    """A bat that is to be shaped for a batter.

    Parameters
    ----------
    bat : the present one, or a racket, club or cricket bat.
    batter, conditions : who swings it, and a hit with it.
    wants : measures that are to be better, one to three.
    keep : measures that stay within 1 % of the present bat's.
    bands : other limits.
    handle : smallest diameter of the grip, m; None: the present one's.
    deepest_cup : that may be turned, m.
    ranges : least and most of what else may change of a turned bat, m.
    materials : that are looked at; empty: the present bat's.
    league : whose rules are kept; None: no league's.
    pick : which bat of the front is reported in full, from 1: the best in the first want.
    seed, population, generations : of the search.
    resume : a saved search to go on from.
    """

    bat: Implement
    batter: Batter
    conditions: Conditions
    wants: tuple[str, ...] = ("exit_speed", "zone")
    keep: tuple[str, ...] = ("mass", "moi", "density")
    bands: tuple[Limit, ...] = ()
    handle: float | None = None
    deepest_cup: float = 1 * INCH
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    materials: tuple[Material, ...] = ()
    league: League | None = None
    pick: int = 1
    seed: int = 1
    population: int = POPULATION
    generations: int = GENERATIONS
    resume: Path | None = None


@dataclass(frozen=True)
class Designed:
    """A design as it came out of the search.

    Parameters
    ----------
    bench : batter, ball and the bats that can be.
    question : what was looked for.
    front : bats none of which is better in everything, the best in the first want first.
    picked : which of them is reported in full.
    now : the present bat on the same bench.
    gain : of the picked one over it.
    bat : the picked one, as everybody else takes it.
    checks : the rules of the ``league`` held against it.
    bent : how far the handles of the present bat and of the picked one are bent; None for other implements.
    """

    bench: Bench
    question: DesignSearch
    front: Front
    picked: int
    now: MeasuredDesigns
    gain: Gain
    bat: Implement
    checks: tuple[Check, ...]
    bent: tuple[HandleBending, HandleBending] | None
    league: League | None = None

    @property
    def numbers(self) -> Array:
        """The picked one's numbers, shape (variables,)."""
        return np.asarray(self.front.numbers[self.picked])

    def value(self, measure: str) -> float:
        """Return a measure of the picked one."""
        return float(self.front.measured.values[measure][self.picked])


def all_searched(
    question: DesignQuestion, progress: Progress | None = None, first: Callable[[Designed], None] | None = None
) -> list[Searched]:
    """Return the front of every material; None where no bat of it keeps every limit, unless that is so of all.

    ``first``: see `sweetspot.answers.design.design_answer`.
    """
    materials: Sequence[Material | None] = question.materials or (None,)
    if question.resume is not None and len(materials) > 1:
        raise InputError(f"resume goes on with one material, and {len(materials)} were given; give the one it was of")
    searches = [_search(question, material) for material in materials]
    found: list[Searched] = []
    faults = []
    for bench, search in searches:
        try:
            found.append((bench, search, _front(question, bench, search, progress, first)))
        except InputError as fault:
            found.append((bench, search, None))
            faults.append(fault)
    if len(faults) == len(searches):
        raise faults[0]
    return found


def _search(question: DesignQuestion, material: Material | None) -> tuple[Bench, DesignSearch]:
    space = space_of(question.bat, deepest_cup=question.deepest_cup, material=material, ranges=question.ranges)
    durable = "durability" in {*question.wants, *(limit.measure for limit in question.bands)}
    bench = bench_of(space, question.batter, question.conditions, durable=durable)
    limits = kept_limits(bench, question.keep, bands=question.bands, league=question.league, handle=question.handle)
    return bench, DesignSearch(question.wants, limits, question.seed, question.population, question.generations)


def _front(
    question: DesignQuestion,
    bench: Bench,
    search: DesignSearch,
    progress: Progress | None,
    first: Callable[[Designed], None] | None,
) -> Front:
    waiting = [] if first is None else [first]
    after = None
    if question.resume is not None:
        text = read_text(question.resume, most=50_000_000, advice="give the search.json of an earlier --out")
        after = resumed(bench, search, text)
    every = search.population
    with (progress or (lambda _: nullcontext()))("designing") as report:

        def grown(generation: int, front: Front) -> None:
            if len(front) and waiting:
                waiting.pop()(_first_design(bench, search, front))
            if report is not None:
                report(generation * every, search.generations * every, _so_far(front))

        return design_front(bench, search, after=after, progress=grown)


def _first_design(bench: Bench, search: DesignSearch, front: Front) -> Designed:
    """Return the best of a front in the first want, with its gain and nothing else."""
    row, now = 0, present_measured(bench)
    bat = bench.space.made(front.numbers[row], f"{bench.space.present.name}, designed")
    gain = gain_of(bench, front.numbers[row], front.measured.rows([row]), now)
    return Designed(bench, search, front, row, now, gain, bat, (), None)


def _so_far(front: Front) -> str:
    if len(front) == 0:
        return "no bat keeps every limit yet"
    values = front.measured.values
    return (
        f"front of {len(front)}: {values['exit_speed'].max() / MPH:.1f} mph over the contacts, zone up to "
        f"{values['zone'].max() / INCH:.1f} in"
    )


def designed_bat(
    bench: Bench, search: DesignSearch, front: Front, *, pick: int = 1, league: League | None = None
) -> Designed:
    """Return a bat of a front with everything around it.

    ``pick``: which one, from 1. ``league``: whose rules it is checked against; None: no league's.

    Raises
    ------
    InputError
        when the front has no such bat.
    """
    if not 1 <= pick <= len(front):
        raise InputError(f"bat {pick} of the front was asked for, which has {len(front)}; allowed is 1 to {len(front)}")
    row, present = pick - 1, bench.space.present
    chosen, now = front.measured.rows([row]), present_measured(bench)
    bat = bench.space.made(front.numbers[row], f"{present.name}, designed")
    checks: list[Check] = []
    if league is not None:
        findings = findings_of(bat, chosen, like=bat, ball=bench.conditions.ball)
        checks = check_rules(league, bat=bat, findings=findings)
    bent = None
    if isinstance(present, Bat) and isinstance(bat, Bat):
        bent = handle_bending(bench, present), handle_bending(bench, bat)
    gain = gain_of(bench, front.numbers[row], chosen, now)
    return Designed(bench, search, front, row, now, gain, bat, tuple(checks), bent, league)
