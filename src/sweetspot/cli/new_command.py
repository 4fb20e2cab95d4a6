"""`sweetspot new`: a first file for a bat or another implement of one's own."""

from __future__ import annotations

import os
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from sweetspot.errors import InputError

QUESTIONS = {
    "sport": "Sport (baseball, softball, slow-pitch, tennis, cricket, golf, ...)",
    "built": "Built of (wood, maple, ash, birch, bamboo, metal, composite, two-piece)",
    "length": "Length, for example 33 in",
    "mass": "Weight on a scale, for example 31 oz",
    "balance_point": "Balance point from the knob end, for example 22.4 in",
    "barrel": "Greatest diameter of a wooden barrel, for example 2.5 in",
}
"""What is asked of whoever sits at a terminal, in this order; an empty answer leaves it as it is."""
NEEDED = ("length", "mass")
OF_BATS = ("built", "barrel")
"""Asked for bats alone."""


@Parameter(name="*")
@dataclass(frozen=True)
class FactOptions:
    """What is known of an implement without tools."""

    sport: Annotated[str | None, Parameter(help="Its sport: baseball, softball, tennis, ...")] = None
    built: Annotated[
        str | None, Parameter(help="wood or a wood's name, metal, composite, two-piece; for bats alone.")
    ] = None
    length: Annotated[str | None, Parameter(help="Length: 33in.")] = None
    mass: Annotated[str | None, Parameter(help="Weight: 31oz.")] = None
    balance_point: Annotated[str | None, Parameter(help="From the knob end: 22.4in.")] = None
    barrel: Annotated[str | None, Parameter(help="Greatest diameter of a wooden barrel: 2.5in.")] = None


DEFAULT_FACTS = FactOptions()


def new(
    file: Annotated[Path, Parameter(help="File to write, which must not be there yet: my-bat.toml.")],
    /,
    *,
    facts: FactOptions = DEFAULT_FACTS,
    name: Annotated[str, Parameter(help="What people call it.")] = "",
) -> int:
    """Write a first file for your own bat, racket, club or stick: six questions, or options in their place."""
    from sweetspot.catalog.files.new import Facts, new_file
    from sweetspot.reports.files import write_all

    if os.path.lexists(file):
        raise InputError(f"{file} is there already; choose another name")
    given: dict[str, str | None] = asdict(facts)
    missing = [key for key in NEEDED if not given[key]]
    if missing:
        if sys.stdin is None or not sys.stdin.isatty():
            options = " and ".join(f"--{key}" for key in missing)
            raise InputError(f"new needs {options}; only on a terminal it asks")
        given |= _answers(given)
    text = new_file(Facts(**{key: text for key, text in given.items() if text and text.strip()}, name=name), file.name)
    write_all({file: text.encode()})
    print(f"wrote {file}; next: sweetspot report {file}")
    return 0


def _answers(given: dict[str, str | None]) -> dict[str, str | None]:
    """Return the answers to the questions that no option answers."""
    from sweetspot.catalog.files.new import PARENTS

    answers: dict[str, str | None] = {}
    for key, question in QUESTIONS.items():
        sport = (given["sport"] or answers.get("sport") or "baseball").strip().lower()
        if given[key] is None and (sport in PARENTS or key not in OF_BATS):
            answers[key] = _asked(question, needed=key in NEEDED)
    return answers


def _asked(question: str, *, needed: bool) -> str:
    """Return a line typed at the terminal; asked again where it is needed and left empty."""
    while True:
        print(f"{question}{'' if needed else ' [enter: not known]'}: ", end="", file=sys.stderr, flush=True)
        line = sys.stdin.readline()
        if line.strip() or not needed or not line:
            return line.strip()
