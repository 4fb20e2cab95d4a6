"""Fronts of bats none of which is better in everything: NSGA-II, one seeded generation after another."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from sweetspot import __version__
from sweetspot.designs.constraints import Limit, near_words
from sweetspot.designs.measures import MEASURES, Bench, MeasuredDesigns
from sweetspot.designs.variables import ranges
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.whole_files import digest

POPULATION, GENERATIONS = 48, 8
STATE = ("generation", "variables", "population", "measured", "curve", "worth")
"""Entries of a saved search that a digest guards."""
NEAR_START = 0.25
"""Part of every range within which the first bats lie around the present one."""


@dataclass(frozen=True)
class DesignSearch:
    """What is looked for.

    ``wants``: keys of `MEASURES` that are to be better, one to three. ``population``, ``generations``: bats of a
    generation, and how many follow each other.
    """

    wants: tuple[str, ...]
    limits: tuple[Limit, ...]
    seed: int = 1
    population: int = POPULATION
    generations: int = GENERATIONS

    def __post_init__(self) -> None:
        allowed = [name for name, measure in MEASURES.items() if measure.better]
        if not 1 <= len(self.wants) <= 3 or len(set(self.wants)) != len(self.wants):
            raise InputError(
                f"{len(self.wants)} wants were given; allowed are one to three different ones of {allowed}"
            )
        for want in self.wants:
            if want not in allowed:
                raise InputError(f"a bat cannot be made better in {want!r}; allowed is one of {', '.join(allowed)}")
        if not (8 <= self.population <= 2000 and 1 <= self.generations <= 2000):
            raise InputError(
                f"{self.generations} generations of {self.population} bats were asked for; allowed are 1 to 2000 of 8 "
                "to 2000"
            )


class Generation(NamedTuple):
    """A whole generation of a search, from which it can go on: its number and its bats.

    What was measured goes along: measured again among other bats, the last digits differ, and with them the search.
    """

    number: int
    numbers: Array
    measured: MeasuredDesigns


@dataclass(frozen=True)
class Front:
    """Bats none of which is better in everything, the best in the first want first.

    ``numbers``: of every bat, shape (n, variables). ``last``: the last generation that was looked at.
    """

    numbers: Array
    measured: MeasuredDesigns
    last: Generation

    @property
    def generation(self) -> int:
        """How many generations were looked at."""
        return self.last.number

    def __len__(self) -> int:
        return len(self.numbers)


def search(
    bench: Bench,
    question: DesignSearch,
    *,
    starts: Array,
    after: Generation | None = None,
    progress: Callable[[int, Front], None] | None = None,
) -> Front:
    """Return the front of bats that keep every limit.

    Every generation has random numbers of its own, from the seed and its number, so that a search that was stopped
    goes on as if it had not been. Ctrl-C ends it with the front that it has.

    ``starts``: numbers of bats that keep the limits, from which it begins, shape (bats, variables); see `check_limits`.
    ``after``: the last generation of an earlier part. ``progress``: called with the number of generations
    done and the front so far.
    """
    variables = bench.space.variables
    low, high = ranges(variables)
    if after is None:
        numbers = _first(question, np.atleast_2d(starts), low, high)
        after = Generation(0, numbers, bench.measured(numbers))
    last = after
    front = _front(question, last)
    try:
        while last.number < question.generations:
            last = _next_generation(bench, question, (low, high), last)
            front = _front(question, last)
            if progress is not None:
                progress(last.number, front)
    except KeyboardInterrupt:
        pass
    if len(front) == 0:
        raise InputError(_nearest_words(question, front.last))
    return front


def front_of(bench: Bench, question: DesignSearch, numbers: Array) -> Front:
    """Return the front of some bats before any generation, shape (bats, variables)."""
    return _front(question, Generation(0, numbers, bench.measured(numbers)))


def _nearest_words(question: DesignSearch, last: Generation) -> str:
    """Return the error that no bat keeps all limits, with the limit that the nearest bat exceeds most."""
    generation, _, measured = last
    missed = np.maximum(excesses(question, measured), 0.0)
    nearest = int(np.argmin(missed.sum(axis=1)))
    limit = question.limits[int(np.argmax(missed[nearest]))]
    near = near_words(limit, measured.values[limit.measure][nearest : nearest + 1])
    looked = f"{generation} generation{'' if generation == 1 else 's'}"
    return (
        f"no bat that keeps every limit was found in {looked}; the nearest has {near} ({limit.why}). "
        "Widen a limit, let more change, or look longer"
    )


def objectives(question: DesignSearch, measured: MeasuredDesigns) -> Array:
    """Return the objectives that are minimized, shape (n, wants)."""
    return np.array([-MEASURES[want].better * measured.values[want] for want in question.wants]).T


def excesses(question: DesignSearch, measured: MeasuredDesigns) -> Array:
    """Return the excess of every bat over every limit in grains, shape (n, limits); 0 or less: kept."""
    if not question.limits:
        return np.full((len(measured), 1), -1.0)
    return np.array([limit.excess(measured.values[limit.measure]) for limit in question.limits]).T


def saved(bench: Bench, question: DesignSearch, front: Front) -> str:
    """Return a search as text, from which it can go on."""
    number, numbers, measured = front.last
    state = {
        "generation": number,
        "variables": [variable.name for variable in bench.space.variables],
        "population": numbers.tolist(),
        "measured": {name: values.tolist() for name, values in measured.values.items()},
        "curve": measured.curve.tolist(),
        "worth": measured.worth.tolist(),
    }
    return json.dumps({"question": fingerprint(bench, question), "digest": _digest_of(state), **state}, indent=1)


def _digest_of(state: Mapping[str, Any]) -> str:
    """Return a hash of the state of a search, so that a number that was changed since is noticed."""
    return digest(json.dumps({name: state[name] for name in STATE}).encode()).hex()


def resumed(bench: Bench, question: DesignSearch, text: str) -> Generation:
    """Return the last generation of a saved search."""
    try:
        state: Any = json.loads(text)
        same = state["question"] == fingerprint(bench, question)
        values = {name: np.array(column, float) for name, column in state["measured"].items()}
        measured = MeasuredDesigns(values, np.array(state["curve"], float), np.array(state["worth"], float))
        last = Generation(int(state["generation"]), np.array(state["population"], float), measured)
        whole = state["digest"] == _digest_of(state)
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(f"this is no saved search: {error}; leave out --resume to begin anew") from None
    if not same:
        raise InputError(
            "the saved search was for another bat, batter, wants, limits or seed, or by another version; begin anew or "
            "ask the same"
        )
    if not whole:
        raise InputError("the saved search was changed since it was written; leave out --resume to begin anew")
    numbers = last.numbers
    if numbers.ndim != 2 or numbers.shape[1] != len(bench.space.variables) or not np.all(np.isfinite(numbers)):
        raise InputError("the saved search holds no generation of bats; begin anew")
    return last


def fingerprint(bench: Bench, question: DesignSearch) -> str:
    """Return a hash of everything that a search depends on, but for how long it lasts."""
    batter = bench.batter
    parts = [
        bench.space.present.model_dump_json(),
        repr(bench.space.variables),
        batter.weight.tobytes().hex(),
        repr((batter.offset, batter.offset_spread, batter.bat_speed, batter.pitch_speed, batter.law)),
        bench.conditions.model_dump_json(),
        repr((question.wants, question.limits, question.seed, question.population)),
        __version__,
    ]
    return hashlib.blake2b("\n".join(parts).encode(), digest_size=16).hexdigest()


def _first(question: DesignSearch, starts: Array, low: Array, high: Array) -> Array:
    """Return the first generation: the bats given, bats between two of them, and bats around them."""
    generator = np.random.default_rng([question.seed, 0])
    count = question.population
    pairs = starts[generator.integers(len(starts), size=(2, count))]
    part = generator.random((count, 1))
    between = part * pairs[0] + (1 - part) * pairs[1]
    spread = NEAR_START * generator.standard_normal((count, len(low))) * generator.random((count, 1)) ** 2
    spread[: count // 4] *= 1e-3
    numbers = np.clip(between + spread * (high - low), low, high)
    different = np.unique(np.clip(starts, low, high), axis=0)
    numbers[: len(different)] = different
    return np.asarray(numbers)


def _next_generation(
    bench: Bench,
    question: DesignSearch,
    ends: tuple[Array, Array],
    parents: Generation,
) -> Generation:
    """Return the survivors of a generation and its children, by pymoo's NSGA-II."""
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.core.population import Population
    from pymoo.core.problem import Problem
    from pymoo.core.termination import NoTermination

    generation, numbers, measured = parents
    count = len(question.wants)
    problem = Problem(
        n_var=len(ends[0]), n_obj=count, n_ieq_constr=max(1, len(question.limits)), xl=ends[0], xu=ends[1]
    )
    algorithm = NSGA2(pop_size=question.population, sampling=Population.new("X", numbers))
    algorithm.setup(problem, termination=NoTermination(), seed=[question.seed, generation + 1], verbose=False)
    first = algorithm.ask()  # without those that are there twice
    rows_kept = _rows(numbers, np.asarray(first.get("X"), float))
    first.set("F", objectives(question, measured)[rows_kept], "G", excesses(question, measured)[rows_kept])
    _evaluated(first)
    algorithm.tell(infills=first)
    children = algorithm.ask()
    fresh = np.asarray(children.get("X"), float)
    seen = bench.measured(fresh)
    children.set("F", objectives(question, seen), "G", excesses(question, seen))
    _evaluated(children)
    every, both = np.concatenate([numbers, fresh]), measured.followed_by(seen)
    algorithm.tell(infills=children)
    rows = _rows(every, np.asarray(algorithm.pop.get("X"), float))
    return Generation(generation + 1, every[rows], both.rows(rows))


def _rows(every: Array, some: Array) -> list[int]:
    """Return the index of each of some rows among all."""
    return [int(np.flatnonzero((every == row).all(axis=1))[0]) for row in some]


def _evaluated(population: Any) -> None:
    for individual in population:
        individual.evaluated.update({"F", "G", "H"})


def _front(question: DesignSearch, last: Generation) -> Front:
    """Return those that keep the limits and that no other beats in everything."""
    _, numbers, measured = last
    allowed = np.flatnonzero((excesses(question, measured) <= 0.0).all(axis=1))
    want = objectives(question, measured)[allowed]
    beaten = np.array([bool(np.any((want <= other).all(axis=1) & (want < other).any(axis=1))) for other in want], bool)
    best = allowed[~beaten] if len(allowed) else allowed
    _, once = np.unique(np.round(objectives(question, measured)[best], 12), axis=0, return_index=True)
    best = best[np.sort(once)]
    order = best[np.argsort(objectives(question, measured)[best, 0], kind="stable")]
    return Front(numbers[order], measured.rows(order), last)
