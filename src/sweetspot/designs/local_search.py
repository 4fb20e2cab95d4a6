"""One bat made as good as it can be in one want, by SLSQP with differences of many bats; searches begin with such."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from sweetspot.designs.constraints import Limit, check_limits
from sweetspot.designs.measures import MEASURES, Bench, MeasuredDesigns
from sweetspot.designs.pareto import DesignSearch, Front, Generation, front_of, search
from sweetspot.designs.variables import ranges
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

STEP = 1e-4
"""Part of a variable's range by which it is moved for a difference: slopes are within 1e-5 of the steepest one."""
ROUNDS, LOOKS = 40, 70
NEARLY, WAYS, POINTS = 5.0, 6, 33
"""From how many of the best bats that miss limits by less than so many grains one goes back to the bat that keeps them,
in how many steps: limits with corners, as the smallest diameter's, leave the solver just outside."""
BETWEEN = 5
"""Bats that are looked for between the best in the first want and the best in another."""
BETWEEN_LOOKS, ON_THE_WAY = 25, 21
"""How often each of them is changed at most, and among how many on the way to the other end its beginning is chosen."""
INSIDE = 0.5
"""Grains by which a polished bat stays inside its limits, so that none is passed by rounding."""


def locally_best(
    bench: Bench, question: DesignSearch, numbers: Array, *, looks: int | None = None
) -> tuple[Array, MeasuredDesigns]:
    """Return the numbers of a bat near a given one that is best in the first want, and its measures.

    It is never worse than the one that was given: it keeps every limit if that one did, or comes nearer to them.

    ``numbers``: of a bat that keeps every limit that a drawing decides, shape (variables,). ``looks``: how many bats
    are tried with their slopes at most; None, or more than `LOOKS`: so many.
    """
    from scipy.optimize import minimize

    most = LOOKS if looks is None else min(looks, LOOKS)
    low, high = ranges(bench.space.variables)
    want, sign = question.wants[0], MEASURES[question.wants[0]].better
    size = 100 * MEASURES[want].grain
    cached: dict[bytes, tuple[Array, Array]] = {}
    tried, ranks = [numbers[None]], [_ranks(_rows(question.limits, bench.measured(numbers), want), sign)]

    def looked(parts: Array) -> tuple[Array, Array]:
        key = parts.tobytes()
        if key not in cached:
            if len(cached) == most:
                raise StopIteration
            here = low + np.clip(parts, 0, 1) * (high - low)
            cached[key] = _with_slopes(bench, here, question.limits, want)
            tried.append(here[None])
            ranks.append(_ranks(cached[key][0][:, None], sign))
        return cached[key]

    def value(parts: Array) -> float:
        return float(-sign * looked(parts)[0][0] / size)

    def slope(parts: Array) -> Array:
        return np.asarray(-sign * looked(parts)[1][0] / size)

    def kept(parts: Array) -> Array:
        return -(looked(parts)[0][1:] + INSIDE) / 100

    def kept_slope(parts: Array) -> Array:
        return -looked(parts)[1][1:] / 100

    limits: Any = [{"type": "ineq", "fun": kept, "jac": kept_slope}] if question.limits else []
    start = (numbers - low) / (high - low)
    with suppress(StopIteration):
        minimize(
            value,
            start,
            jac=slope,
            method="SLSQP",
            bounds=[(0.0, 1.0)] * len(start),
            constraints=limits,
            options={"maxiter": ROUNDS, "ftol": 1e-4},
        )
    every, rank = np.concatenate(tried), np.concatenate(ranks)
    nearly = every[rank[:, 0] > -NEARLY][np.argsort(rank[rank[:, 0] > -NEARLY, 1])[-WAYS:]]
    if len(nearly):
        between = numbers + np.linspace(0, 1, POINTS)[1:, None, None] * (nearly - numbers)
        back = between.reshape(-1, len(numbers))
        every = np.concatenate([every, back])
        rank = np.concatenate([rank, _ranks(_rows(question.limits, bench.measured(back), want), sign)])
    first = every[np.lexsort((rank[:, 1], rank[:, 0]))[-1]]
    return first, bench.measured(first)


def _rows(limits: Sequence[Limit], measured: MeasuredDesigns, want: str) -> Array:
    """Return the want, and below it by how many grains every limit is missed, shape (1 + limits, n)."""
    return np.vstack([measured.values[want][None], _margins(limits, measured)])


def _ranks(rows: Array, sign: int) -> Array:
    """Return the ranks of bats: first the excess over the limits, then the wanted measure, shape (n, 2)."""
    return np.stack([-np.maximum(rows[1:], 0.0).sum(axis=0), sign * rows[0]], axis=1)


def gradient(bench: Bench, numbers: Array, measure: str, *, step: float = STEP) -> Array:
    """Return the slope of a measure by every variable, SI, shape (variables,), from bats on either side."""
    if measure not in MEASURES:
        raise InputError(f"{measure!r} is no measure; allowed are {', '.join(MEASURES)}")
    low, high = ranges(bench.space.variables)
    values = bench.measured(_either_side(numbers, low, high, step)).values[measure]
    count = len(numbers)
    return np.asarray((values[:count] - values[count:]) / (2 * step * (high - low)))


def _with_slopes(bench: Bench, numbers: Array, limits: Sequence[Limit], want: str) -> tuple[Array, Array]:
    """Return the want and every limit's excess of a bat, and their slopes by the parts of the ranges."""
    count = len(numbers)
    every = bench.measured(np.concatenate([numbers[None], _either_side(numbers, *ranges(bench.space.variables), STEP)]))
    rows = _rows(limits, every, want)
    return rows[:, 0], (rows[:, 1 : count + 1] - rows[:, count + 1 :]) / (2 * STEP)


def _either_side(numbers: Array, low: Array, high: Array, step: float) -> Array:
    """Return bats with each variable a step more, then each a step less, shape (2 variables, variables).

    All lie inside the ranges: a bat without a cup is built otherwise than one with the shallowest, and a difference
    across that jump is no slope.
    """
    moved = step * (high - low)
    middle = np.clip(numbers, low + 2 * moved, high - 2 * moved)
    more, less = (np.where(np.eye(len(numbers), dtype=bool), middle + way * moved, numbers) for way in (1, -1))
    return np.concatenate([more, less])


def _margins(limits: Sequence[Limit], measured: MeasuredDesigns) -> Array:
    return np.array([limit.excess(measured.values[limit.measure]) for limit in limits]).reshape(
        len(limits), len(measured)
    )


def search_starts(
    bench: Bench, question: DesignSearch, *, progress: Callable[[int, Front], None] | None = None
) -> Array:
    """Return bats from which a search begins: one that keeps the limits, the best near it in every want, and between.

    No seed changes them, so that fronts of different seeds have them in common.
    """
    first = check_limits(bench, question.limits)
    starts = [first]

    def found(numbers: Array) -> None:
        starts.append(numbers)
        if progress is not None:
            progress(0, front_of(bench, question, np.array(starts)))

    for number in range(len(question.wants)):
        wants = question.wants[number:] + question.wants[:number]
        found(locally_best(bench, DesignSearch(wants, question.limits, question.seed), first)[0])
    for number in range(1, len(question.wants)):
        for between in _between(bench, question, (starts[1], starts[1 + number]), question.wants[number]):
            found(between)
    return np.array(starts)


def _between(bench: Bench, question: DesignSearch, ends: tuple[Array, Array], other: str) -> Iterator[Array]:
    """Yield bats best in the first want of those that reach a part of the way in another, one after the other."""
    measured = bench.measured(np.array(ends)).values[other]
    if (measured[1] - measured[0]) * MEASURES[other].better < MEASURES[other].grain:
        return
    numbers = ends[0]
    for part in np.linspace(0, 1, BETWEEN + 2)[1:-1]:
        level = float(measured[0] + part * (measured[1] - measured[0]))
        more = MEASURES[other].better > 0
        reached = Limit(other, level if more else None, None if more else level, "between the ends")
        asked = DesignSearch(question.wants[:1], (*question.limits, reached), question.seed)
        way = numbers + np.linspace(0, 1, ON_THE_WAY)[:, None] * (ends[1] - numbers)
        begin = way[int(np.argmax(reached.excess(bench.measured(way).values[other]) <= 0))]
        numbers = locally_best(bench, asked, begin, looks=BETWEEN_LOOKS)[0]
        yield numbers


def design_front(
    bench: Bench,
    question: DesignSearch,
    *,
    after: Generation | None = None,
    progress: Callable[[int, Front], None] | None = None,
) -> Front:
    """Return the front of a question, its best in the first want polished.

    ``after``: a search to go on from; see `search`. ``progress``: called with the generations done, 0 while first bats
    are looked for, and the front so far.
    """
    starts = (
        np.zeros((0, len(bench.space.variables)))
        if after is not None
        else search_starts(bench, question, progress=progress)
    )
    front = search(bench, question, starts=starts, after=after, progress=progress)
    numbers, measured = locally_best(bench, question, front.numbers[0])
    return front if np.array_equal(numbers, front.numbers[0]) else _with_first(front, numbers, measured)


def best_of(fronts: Sequence[Front], want: str) -> int:
    """Return the index of the front with the best bat in a want."""
    return int(np.argmax([best_value(front, want) * MEASURES[want].better for front in fronts]))


def best_value(front: Front, want: str) -> float:
    """Return the best value of a want on a front."""
    better = MEASURES[want].better
    return float(better * np.max(better * front.measured.values[want]))


def _with_first(front: Front, numbers: Array, measured: MeasuredDesigns) -> Front:
    """Return a front with another first bat; those that it beats in everything are left out by the caller's eye."""
    both = measured.followed_by(front.measured.rows(range(1, len(front))))
    return Front(np.concatenate([numbers[None], front.numbers[1:]]), both, front.last)
