"""Design's search for better bats: a front that grows, generation by generation, in a process of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from sweetspot.designs.local_search import design_front
from sweetspot.designs.measures import Bench
from sweetspot.designs.pareto import Front
from sweetspot.designs.turned import TurnedSpace
from sweetspot.numerics.arrays import Array
from sweetspot.web.drawings import DrawnOutline
from sweetspot.web.jobs import Say
from sweetspot.web.views.design_state import DesignState, asked, question_of

MEASURED = (
    "exit_speed",
    "best",
    "best_from_tip",
    "zone",
    "sting",
    "swing_time",
    "durability",
    "mass",
    "moi",
    "diameter",
)


@dataclass(frozen=True)
class FrontBat:
    """One bat of a front: its numbers and measures, SI, and its outline where outlines differ."""

    numbers: tuple[float, ...]
    values: Mapping[str, float]
    outline: DrawnOutline | None = None


@dataclass(frozen=True)
class DesignFront:
    """The front after a generation, and the present bat, whose ``key`` is that of the answer."""

    key: str
    generation: int
    generations: int
    wants: tuple[str, ...]
    front: tuple[FrontBat, ...] = ()
    present: Mapping[str, float] = field(default_factory=dict)


def search(state: DesignState, *, after: tuple[int, Array] | None, say: Say) -> DesignFront:
    """Look for better bats: begins a search whose front the page sees growing."""
    task = asked(state)
    question = question_of(state)
    begun = 0 if after is None else after[0]
    if after is not None and begun >= question.generations:  # asked to go on beyond its end
        question = replace(question, generations=min(2000, begun + state.generations))
    nothing = DesignFront(task.key, begun, question.generations, question.wants)
    present = {name: float(task.now.values[name][0]) for name in question.wants}

    def progress_at(generation: int, front: Front) -> DesignFront:
        return replace(nothing, generation=generation, front=_bats(task.bench, front), present=present)

    def grown(generation: int, front: Front) -> None:
        say(progress_at(generation, front), (generation, front.population) if generation else None)

    say(nothing, after)
    front = design_front(task.bench, question, after=after, progress=grown)
    return progress_at(front.generation, front)


def _bats(bench: Bench, front: Front) -> tuple[FrontBat, ...]:
    values = {name: front.measured.values[name] for name in MEASURED if name in front.measured.values}
    numbers = np.asarray(front.numbers)
    outlines: list[DrawnOutline | None] = [None] * len(numbers)
    if isinstance(bench.space, TurnedSpace):
        shapes = bench.space.outlines(numbers)
        outlines = list(map(DrawnOutline, shapes.position, shapes.diameter))
    return tuple(
        FrontBat(tuple(row), {name: float(column[index]) for name, column in values.items()}, outline)
        for index, (row, outline) in enumerate(zip(numbers.tolist(), outlines, strict=True))
    )
