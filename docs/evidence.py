"""Tables of `make evidence`: which published numbers notice a constant of the physics that is wrong."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tables import table

MEASURED = Path(__file__).with_name("evidence.json")
WANTED = 2
"""Published numbers that should notice a constant which moves an answer by more than its interval."""
NOTHING_FOUND = "no published number that depends on it enough was found"
REASONS: Mapping[str, str] = {
    "aluminium_7xxx.": "no wall of a published bat is known well enough: a tone goes with its thickness as with its "
    "modulus, and the catalogue's walls are drawn, not measured",
    "carbon_": "makers publish no lay-ups: the catalogue's is assumed, and the tone of no published bat belongs to it",
    "glass_": "as for carbon",
    "limba.": "no blade's veneers were published with its tone",
    "ayous.": "no blade's veneers were published with its tone",
    "inverted.": "rubbers are compared by players, not in numbers; one published bounce is of the ball alone",
    "softball_12in.": "the standards fix the ball and the limit of the bat, and give no bat that was hit with it",
    "cricket.": "published hits are of bats that are not described",
    "TRACKED.backspin": "fitted to tracked distances, and no other source gives the spin of its balls",
}
"""By the beginning of a constant's name: why nothing published can notice it, or too little."""


def _measured() -> dict[str, Any]:
    return dict(json.loads(MEASURED.read_text("utf-8")))


def _greatest_move(constant: Mapping[str, Any]) -> tuple[float, str]:
    """Return the greatest change of an answer in half widths of its interval, and which answer that is."""
    moves = [(size, name) for found in constant["found"] if found["moved"] for size, name in [found["moved"]]]
    return max(moves, default=(0.0, ""))


def _numbers(found: Mapping[str, Any]) -> int:
    return len(found["bats"]) + len(found["others"])


def _fewest(constant: Mapping[str, Any]) -> int:
    """Return how many published numbers notice the factor, of those that move an answer enough, that fewest notice."""
    enough = [found for found in constant["found"] if found["moved"] and found["moved"][0] > 1]
    return min(map(_numbers, enough), default=0)


def _name(constant: Mapping[str, Any]) -> str:
    return f"{Path(constant['file']).stem}: {constant['name']}"


def _moving(constants: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return the constants that move an answer by more than its interval, the greatest move first."""
    moving = [constant for constant in constants if _greatest_move(constant)[0] > 1]
    return sorted(moving, key=lambda constant: -_greatest_move(constant)[0])


def evidence_summary() -> str:
    """Return in a sentence how many constants matter, and how many of them published numbers notice."""
    measured = _measured()
    of, constants = measured["measured"], measured["constants"]
    moving = _moving(constants)
    enough = sum(_fewest(constant) >= WANTED for constant in moving)
    once = sum(_fewest(constant) == 1 for constant in moving)
    used = sum(any(found["moved"] or found["rows"] for found in constant["found"]) for constant in constants)
    low, high = of["factors"]
    return (
        f"**Of {len(constants)} constants, {used} change a row or an answer below. × {low:g} or × {high:g} moves an "
        f"answer by more than its 90 % interval for {len(moving)}; of these, two or more independent published numbers "
        f"notice {enough}, one notices {once}, and none {len(moving) - enough - once}.** (`{of['command']}`, "
        f"{of['date']}, at `{of['commit']}`.)\n"
    )


def evidence_table() -> str:
    """Return every constant that moves an answer by more than its interval, or that a published number notices."""
    constants = _measured()["constants"]
    moving = _moving(constants)
    noticed = [one for one in constants if one not in moving and max(map(_numbers, one["found"])) > 0]
    noticed.sort(key=lambda constant: -max(map(_numbers, constant["found"])))
    rows = []
    for constant in [*moving, *noticed]:
        size, answer = _greatest_move(constant)
        counts = [f"{_numbers(found)} + {len(found['fitted'])}" for found in constant["found"]]
        moved = f"{size:.1f}: {answer}" if answer else "-"
        rows.append((_name(constant), constant["value"], constant["kind"] or "in code", moved, *counts))
    head = ("constant", "value", "kind", "greatest move: of", "× 0.8", "× 1.25")
    return table(head, rows)


def unnoticed_table() -> str:
    """Return the constants that matter and that fewer than two published numbers notice, with the reason."""
    weak = [constant for constant in _moving(_measured()["constants"]) if _fewest(constant) < WANTED]
    rows = [(_name(constant), str(_fewest(constant)), _reason(constant["name"])) for constant in weak]
    return table(("constant", "numbers", "why not more"), rows)


def _reason(name: str) -> str:
    return next((reason for start, reason in REASONS.items() if name.startswith(start)), NOTHING_FOUND)
