"""A design from question to bat: what is possible, the best in each want, the front between, one bat picked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sweetspot.analysis.certification.rules import Check, Finding, League, check_rules, construction_findings
from sweetspot.analysis.certification.simulated_test import Certification, certify
from sweetspot.design.breaking import HandleBending, handle_bending
from sweetspot.design.fronts import Front, Question, front_of, search
from sweetspot.design.gain import Gain, gain_of, present_measured
from sweetspot.design.limits import Limit, check_limits
from sweetspot.design.measures import MEASURES, Bench, MeasuredDesigns
from sweetspot.design.polish import polished
from sweetspot.design.variables import sizes_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

BETWEEN = 5
"""Bats that are looked for between the best in the first want and the best in another."""

BETWEEN_LOOKS, ON_THE_WAY = 25, 21
"""How often each of them is changed at most, and among how many on the way to the other end its beginning is chosen."""


@dataclass(frozen=True)
class Designed:
    """A design with everything around it.

    Parameters
    ----------
    bench : batter, ball and the bats that can be.
    question : what was looked for.
    front : bats none of which is better in everything, the best in the first want first.
    picked : which of them is told about.
    now : the present bat on the same bench.
    gain : of the picked one over it.
    bat : the picked one, as everybody else takes it.
    checks : the league's rules held against it.
    bent : how far the handles of the present bat and of the picked one are bent; None for other implements.
    materials : where several were looked at: the name of each and the best of its front in every want; empty: it has
        none, for no bat of it keeps every limit.
    """

    bench: Bench
    question: Question
    front: Front
    picked: int
    now: MeasuredDesigns
    gain: Gain
    bat: Implement
    checks: tuple[Check, ...]
    bent: tuple[HandleBending, HandleBending] | None
    materials: tuple[tuple[str, tuple[float, ...]], ...] = ()

    @property
    def numbers(self) -> Array:
        """The picked one's numbers, shape (variables,)."""
        return np.asarray(self.front.numbers[self.picked])

    def value(self, measure: str) -> float:
        """Return a measure of the picked one."""
        return float(self.front.measured.values[measure][self.picked])


def starts_of(bench: Bench, question: Question, *, progress: Callable[[int, Front], None] | None = None) -> Array:
    """Return bats from which a search begins: one that keeps the limits, the best near it in every want, and between.

    No seed changes them, so that fronts of different seeds have them in common.

    Parameters
    ----------
    progress : called after each with 0 generations done and the front of those that were found.

    Raises
    ------
    InputError
        when limits quarrel; see `check_limits`.
    """
    first = check_limits(bench, question.limits)
    starts = [first]

    def found(numbers: Array) -> None:
        starts.append(numbers)
        if progress is not None:
            progress(0, front_of(bench, question, np.array(starts)))

    for number in range(len(question.wants)):
        wants = question.wants[number:] + question.wants[:number]
        found(polished(bench, Question(wants, question.limits, question.seed), first)[0])
    for number in range(1, len(question.wants)):
        for between in _between(bench, question, (starts[1], starts[1 + number]), question.wants[number]):
            found(between)
    return np.array(starts)


def _between(bench: Bench, question: Question, ends: tuple[Array, Array], other: str) -> Iterator[Array]:
    """Yield bats best in the first want of those that reach a part of the way in another, one after the other.

    Parameters
    ----------
    ends : the best in the first want, and the best in the other.
    """
    measured = bench.measured(np.array(ends)).values[other]
    if (measured[1] - measured[0]) * MEASURES[other].better < MEASURES[other].grain:
        return
    numbers = ends[0]
    for part in np.linspace(0, 1, BETWEEN + 2)[1:-1]:
        level = float(measured[0] + part * (measured[1] - measured[0]))
        more = MEASURES[other].better > 0
        reached = Limit(other, level if more else None, None if more else level, "between the ends")
        asked = Question(question.wants[:1], (*question.limits, reached), question.seed)
        way = numbers + np.linspace(0, 1, ON_THE_WAY)[:, None] * (ends[1] - numbers)
        begin = way[int(np.argmax(reached.excess(bench.measured(way).values[other]) <= 0))]
        numbers = polished(bench, asked, begin, looks=BETWEEN_LOOKS)[0]
        yield numbers


def designed(
    bench: Bench,
    question: Question,
    *,
    after: tuple[int, Array] | None = None,
    progress: Callable[[int, Front], None] | None = None,
) -> Front:
    """Return the front of a question, its best in the first want polished.

    Parameters
    ----------
    after : a search to go on from; see `search`.
    progress : called with the generations done, 0 while first bats are looked for, and the front so far.
    """
    starts = (
        np.zeros((0, len(bench.space.variables)))
        if after is not None
        else starts_of(bench, question, progress=progress)
    )
    front = search(bench, question, starts=starts, after=after, progress=progress)
    numbers, measured = polished(bench, question, front.numbers[0])
    return front if np.array_equal(numbers, front.numbers[0]) else _with_first(front, numbers, measured)


def best_of(fronts: Sequence[Front], want: str) -> int:
    """Return which of several fronts has the best bat in a want."""
    return int(np.argmax([_best(front, want) * MEASURES[want].better for front in fronts]))


def _best(front: Front, want: str) -> float:
    better = MEASURES[want].better
    return float(better * np.max(better * front.measured.values[want]))


def told(
    bench: Bench,
    question: Question,
    front: Front,
    *,
    pick: int,
    league: League | None,
    materials: Sequence[tuple[str, Front | None]] = (),
) -> Designed:
    """Return a design with everything around it.

    Parameters
    ----------
    pick : which bat of the front is told about, from 1.
    league : whose rules are held against it; None: nobody's.
    materials : names and fronts of all that were looked at, where these were several; None: no bat keeps the limits.

    Raises
    ------
    InputError
        when the front has no such bat.
    """
    if not 1 <= pick <= len(front):
        raise InputError(f"bat {pick} of the front was asked for, which has {len(front)}; allowed is 1 to {len(front)}")
    chosen = MeasuredDesigns(
        {name: value[pick - 1 : pick] for name, value in front.measured.values.items()},
        front.measured.curve[pick - 1 : pick], front.measured.worth[pick - 1 : pick],
    )  # fmt: skip
    now = present_measured(bench)
    present = bench.space.present
    bat = bench.space.made(front.numbers[pick - 1], f"{present.name}, designed")
    checks: tuple[Check, ...] = ()
    if league is not None:
        checks = tuple(
            check_rules(league, bat=bat, findings=findings_of(bat, chosen, like=bat, ball=bench.conditions.ball))
        )
    gain = gain_of(bench, front.numbers[pick - 1], chosen, now)
    bent = None
    if isinstance(present, Bat) and isinstance(bat, Bat):
        bent = handle_bending(bench, present), handle_bending(bench, bat)
    beside = [
        (name, () if one is None else tuple(_best(one, want) for want in question.wants)) for name, one in materials
    ]
    return Designed(
        bench, question, front, pick - 1, now, gain, bat, checks, bent, tuple(beside) if len(beside) > 1 else ()
    )


def findings_of(bat: Implement, measured: MeasuredDesigns, *, like: Implement, ball: Ball) -> dict[str, Finding]:
    """Return what a rule can be held against: the drawing's own values, and BBCOR and BPF where it was fired at.

    Parameters
    ----------
    measured : the bat, one row.
    like : whose test says how much the ball's patch and the moment of inertia leave open of BBCOR and BPF: the bat
        itself, or one like it where there is no time for three tests of each.
    """
    if not isinstance(bat, Bat):
        return {name: Finding(size) for name, size in sizes_of(bat).items()}
    known = construction_findings(bat, body=rigid_body(beam_model(bat)))
    values = {name: float(measured.values[name][0]) for name in ("bbcor", "bpf") if name in measured.values}
    left_open = _tested(like, ball).findings() if values and isinstance(like, Bat) else {}
    return {**known, **{name: left_open[name].moved_to(value) for name, value in values.items()}}


@lru_cache(maxsize=32)
def _tested(bat: Bat, ball: Ball) -> Certification:
    return certify(bat, ball=ball)


def _with_first(front: Front, numbers: Array, measured: MeasuredDesigns) -> Front:
    """Return a front with another first bat; those that it beats in everything are left out by the caller's eye."""
    kept: Sequence[int] = range(1, len(front))
    values = {
        name: np.concatenate([value, front.measured.values[name][list(kept)]])
        for name, value in measured.values.items()
    }
    both = MeasuredDesigns(
        values, np.concatenate([measured.curve, front.measured.curve[1:]]),
        np.concatenate([measured.worth, front.measured.worth[1:]]),
    )  # fmt: skip
    return Front(np.concatenate([numbers[None], front.numbers[1:]]), both, front.generation, front.population)
