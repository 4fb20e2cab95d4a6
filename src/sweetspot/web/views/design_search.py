"""Design's search for better bats: a front that grows, generation by generation, in a process of its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from sweetspot.designs.local_search import designed
from sweetspot.designs.measures import Bench
from sweetspot.designs.pareto import Front
from sweetspot.designs.turned import TurnedSpace
from sweetspot.web.jobs import Say
from sweetspot.web.views.design_state import DesignState, asked, question_of

SHOWN = ("exit_speed", "best", "best_from_tip", "zone", "sting", "swing_time", "durability", "mass", "moi", "diameter")


def search(state: DesignState, *, after: Any, say: Say) -> dict[str, Any]:
    """Look for better bats: begins a search whose front the page sees growing."""
    task = asked(state)
    question = question_of(state)
    if after is not None and after[0] >= question.generations:  # asked to go on beyond its end
        question = replace(question, generations=min(2000, after[0] + state.generations))

    def progress_at(generation: int, front: Front) -> dict[str, Any]:
        return {
            "key": task.key,
            "generation": generation,
            "generations": question.generations,
            "wants": list(question.wants),
            "front": _front(task.bench, front),
            "present": {name: float(task.now.values[name][0]) for name in question.wants},
        }

    say(
        {
            "key": task.key,
            "generation": 0 if after is None else after[0],
            "generations": question.generations,
            "wants": list(question.wants),
            "front": [],
            "present": {},
        },
        after,
    )

    def grown(generation: int, front: Front) -> None:
        say(progress_at(generation, front), (generation, front.population) if generation else None)

    front = designed(task.bench, question, after=after, progress=grown)
    return progress_at(front.generation, front)


def _front(bench: Bench, front: Front) -> list[dict[str, Any]]:
    """Return every bat of a front: its numbers, what it does, and its outline where outlines differ."""
    values = front.measured.values
    rows = []
    for index, numbers in enumerate(np.asarray(front.numbers)):
        row: dict[str, Any] = {"numbers": numbers.tolist()}
        row["values"] = {name: float(values[name][index]) for name in SHOWN if name in values}
        if isinstance(bench.space, TurnedSpace):
            shape = bench.space.outlines(numbers[None])
            row["outline"] = {"position_m": shape.position[0].tolist(), "diameter_m": shape.diameter[0].tolist()}
        rows.append(row)
    return rows
