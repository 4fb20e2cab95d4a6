"""Sports as tables for a terminal: what is known, how sure, and the paper's formulas with each sport's numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rich.console import Group
from rich.table import Table
from rich.text import Text

from sweetspot.paper import Row
from sweetspot.report.table import names_table, paper_table
from sweetspot.sport import CERTAINTIES, Known, Limit, Sport

MARK_STYLE = "yellow"


def sports_table(rows: list[dict[str, Any]]) -> Group:
    """Return all sports in short; a star stands behind a speed that no source was read for."""
    shown = [
        {
            "sport": row["key"],
            "ball": row["balls"][0],
            "implements": str(len(row["implements"])),
            "swing m/s": _starred(row["swing_speed_m_s"], row["swing_speed_kind"]),
            "ball m/s": _starred(row["ball_speed_m_s"], row["ball_speed_kind"]),
            **{kind: str(row[kind]) for kind in CERTAINTIES},
        }
        for row in rows
    ]
    return Group(
        names_table(shown, "Sports, and how many of their numbers rest on what"),
        Text("* assumed: recalled, no source was read. `sweetspot sports NAME` shows every number.", style="dim"),
    )


def sport_page(sport: Sport, counts: dict[Any, int], rows: list[Row]) -> Group:
    """Return everything about one sport."""
    parts: list[Any] = [Text(sport.name, style="bold"), _sure(counts), Text()]
    parts += [_stroke(sport), Text()]
    for title, known in (("Speeds", sport.speeds), ("Rules", sport.limits), ("Published numbers", sport.facts)):
        if known:
            parts += [_known_table(known, title), Text()]
    if sport.marks:
        parts += [_marks(sport), Text()]
    if rows:
        parts += [paper_table(rows, title="The paper's formulas with this sport's numbers"), Text()]
    if sport.terms:
        words = [{"word": word, "what it is here": meaning} for word, meaning in sport.terms]
        parts += [names_table(words, "Words"), Text()]
    parts.append(Text("What the model does not cover", style="bold"))
    parts += [Text(f"- {text}") for text in sport.not_covered]
    return Group(*parts)


def _sure(counts: dict[Any, int]) -> Text:
    told = ", ".join(f"{number} {kind}" for kind, number in counts.items() if number)
    return Text(f"How sure: of its numbers, balls and implements included, {told}.", style="dim")


def _stroke(sport: Sport) -> Table:
    stroke, words = sport.stroke, sport.words
    place = f"{100 * stroke.from_tip:.0f} cm from the {words.tip}" if stroke.from_tip else f"at the {words.tip}"
    table = _columns("Usual stroke", "what", "speed", "kind", "source")
    table.add_row(f"{stroke.swing_speed.name}, {place}", *_cells(stroke.swing_speed))
    table.add_row(stroke.ball_speed.name, *_cells(stroke.ball_speed))
    return table


def _known_table(known: Sequence[Known], title: str) -> Table:
    table = _columns(title, "what", "value", "kind", "source")
    for one in known:
        side = f"at {one.side} " if isinstance(one, Limit) else ""
        value, kind, source = _cells(one)
        table.add_row(one.name, Text(side).append(value), kind, source)
    return table


def _marks(sport: Sport) -> Table:
    table = _columns(
        "Court or field, from where the ball is usually hit", "mark", "distance", "height", "a good flight", "source"
    )
    for mark in sport.marks:
        height = mark.height.marked if mark.height else "-"
        good = "passes it in the air" if mark.side == "beyond" else "lands before it"
        table.add_row(mark.name, mark.distance.marked, height, good, mark.distance.source)
    return table


def _columns(title: str, *columns: str) -> Table:
    table = Table(title=title, title_justify="left", title_style="bold", header_style="bold", box=None, pad_edge=False)
    for column in columns:
        table.add_column(column)
    return table


def _cells(one: Known) -> tuple[Text, Text, str]:
    soft = MARK_STYLE if one.kind == "assumed" else ""
    return Text(one.marked, style=soft), Text(one.kind, style=soft), one.source


def _starred(speed: float, kind: str) -> str:
    return f"{speed:.3g}{'*' if kind == 'assumed' else ''}"
