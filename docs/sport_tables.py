"""Tables of the sports' pages, written as Markdown from the catalog and the published cases."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial

from tables import escaped, source, table

from sweetspot import validation
from sweetspot.catalog.sports import certainty, sport, sport_implements, sport_names
from sweetspot.equipment.sport import CERTAINTIES, Fact, RuleLimit, Sport
from sweetspot.papers.sports import sport_rows
from sweetspot.reports.paper.statements import stated
from sweetspot.reports.quantities import SI
from sweetspot.validation.cases import Result

CASES: dict[str, tuple[str, ...]] = {
    "softball": ("kensrud2017", "russell2004hoop", "russell2017acoustics"),
    "cricket": ("cross_cricket",),
    "tennis": ("itf_ball", "rsi2006", "cross1997dead", "cross1999racket", "crosslindsey2013"),
    "table-tennis": ("ittf_bounce", "ittf_laws"),
    "badminton": ("badminton_swingweight", "cohen2015", "bwf_laws"),
    "golf": ("shoptalk_smash", "golf_smash_tour", "usga_impact", "tutelman_impact", "trackman_tour", "nathan_golf"),
    "field-hockey": ("hockey2012", "fih_rules"),
    "pickleball": (),
    "squash": (),
}
"""Published cases of each sport, by source."""


def pages() -> dict[str, Callable[[], str]]:
    """Return every included text of the sports' pages by the name of its file."""
    by_sport = {f"sport_{name.replace('-', '_')}": partial(sport_page, name) for name in CASES}
    return {"sports_table": sports_table, **by_sport}


def sports_table() -> str:
    """Return all sports with their usual stroke and how many of their numbers rest on what."""
    rows = []
    for name in sport_names():
        found, counts, implements = sport(name), certainty(name), sport_implements(name)
        stroke = found.stroke
        rows.append(
            (
                found.name,
                found.balls[0],
                implements[0] + (" …" if len(implements) > 1 else ""),
                stroke.swing_speed.marked,
                stroke.ball_speed.marked,
                " / ".join(str(counts[kind]) for kind in CERTAINTIES),
            )
        )
    return table(("sport", "ball", "implement", "swing", "ball arrives at", " / ".join(CERTAINTIES)), rows)


def sport_page(name: str) -> str:
    """Return what is known of a sport, its formulas, its published cases and what the model leaves out."""
    found = sport(name)
    counts = ", ".join(f"{number} {kind}" for kind, number in certainty(name).items() if number)
    parts = [
        f"## What is known, and how sure\n\nOf its numbers, balls and implements included: {counts}.",
        _numbers(found),
    ]
    if found.marks:
        parts.append(_marks(found))
    parts.append("## The paper's formulas\n\n" + _formulas(found))
    if found.terms:
        parts.append(
            "## Words\n\n" + "\n\n".join(f"{escaped(word)}\n: {escaped(meaning)}" for word, meaning in found.terms)
        )
    parts.append("## Published cases\n\n" + _cases(name))
    left_out = "\n".join(f"- {escaped(text)}" for text in found.not_covered)
    parts.append(f"## What the model does not cover\n\n{left_out}")
    return "\n\n".join(parts) + "\n"


def _numbers(found: Sport) -> str:
    stroke = found.stroke
    facts: tuple[Fact, ...] = (stroke.swing_speed, stroke.ball_speed, *found.speeds, *found.limits, *found.facts)

    def row(fact: Fact) -> str:
        side = f"at {fact.side} " if isinstance(fact, RuleLimit) else ""
        cells = (fact.name, f"{side}{fact.marked}", fact.kind, source(fact.source), fact.where)
        return "| " + " | ".join(cell if "](#" in cell else escaped(cell) for cell in cells) + " |"

    return "\n".join(["| | value | kind | source | where |", "|" + " --- |" * 5, *map(row, facts)])


def _marks(found: Sport) -> str:
    rows = [
        (
            mark.name,
            mark.distance.marked,
            mark.height.marked if mark.height else None,
            "passes it in the air" if mark.side == "beyond" else "lands before it",
        )
        for mark in found.marks
    ]
    head = ("court or field", "distance from the stroke", "height", "a good flight")
    return table(head, rows)


def _formulas(found: Sport) -> str:
    rows = [tuple(vars(stated(row, SI)).values())[:-1] for row in sport_rows(found)]
    return table(("eq.", "quantity", "unit", "rule or claim", "formula", "full model", "comment"), rows)


@cache
def _results() -> tuple[Result, ...]:
    return validation.results()


def _cases(name: str) -> str:
    results = [result for result in _results() if result.source in CASES[name]]
    rows = [
        (
            f"{result.name}: {result.quantity}",
            f"{result.printed} {result.unit if result.unit not in result.printed else ''}".strip(),
            f"{result.computed:.4g}",
            f"{result.status}, {result.evidence}",
            f"[{result.source}]",
        )
        for result in results
    ]
    misses = "\n".join(
        f"- **{escaped(result.name)}, {escaped(result.quantity)}:** {escaped(result.expected_miss)}"
        for result in results
        if result.expected_miss
    )
    explained = f"\n\nWhy some miss:\n\n{misses}" if misses else ""
    return table(("case", "printed", "computed", "verdict", "source"), rows) + explained
