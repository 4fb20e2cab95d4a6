"""A page to print for one player of a season."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import polars as pl

from sweetspot.answers.records import plain_data
from sweetspot.answers.season import SeasonAnswer, SeasonPlayer
from sweetspot.reports.document import Bullets, Cell, Column, Document, Paragraph, Picture, Table
from sweetspot.reports.quantities import Reader
from sweetspot.reports.season.document import few_of_a_kind
from sweetspot.reports.sentences import Slot, joined, say
from sweetspot.seasons.standings import MEASURES
from sweetspot.seasons.stat_rows import WITH
from sweetspot.seasons.table_warnings import CANNOT_TELL
from sweetspot.units import grouped

TELLING = 0.05
"""Reliability below which players do not differ, and a percentile would be chance."""
ENDS = ("low90", "high90")
KINDS = (
    ("doubters", "doubter", "doubters"),
    ("mostly_gone", "mostly gone", "mostly gone"),
    ("no_doubters", "no-doubter", "no-doubters"),
)
"""Kinds of home runs: column, and what one and several are called."""


def player_page(player: SeasonPlayer) -> Document:
    """Return one player's page: every measure partly pooled, with its intervals, reliability and rank in the table."""
    answer, row, data = player.season, player.row, player.to_dict()
    number = str(row["batter"])
    name = str(row.get("name") or f"Player {number}")
    drawing = Picture(
        "player",
        partial(_drawn, answer, number, name),
        label=f"Balls of {name}.",
        sheet=partial(_drawn, answer, number, ""),
    )
    balls = "1 ball" if row["balls"] == 1 else f"{grouped(row['balls'])} balls"
    words = "{balls} in play with an exit speed, the hardest fifth at {ev20} on average."
    headline = joined([say(words, balls=balls, ev20=Slot(row["ev20"], "speed")), *_home_runs(row)])
    cannot = answer.cannot_tell if row.get("squared_up") is not None else (CANNOT_TELL["fouls"],)
    rare = [Paragraph(sentence, "note") for sentence in few_of_a_kind(answer.rare_shares["batter"])]
    return Document(
        name=f"player-{number}",
        title=name,
        kind="Season of a player",
        blocks=[Paragraph(headline), _measures(row), *rare, drawing, *_bats(row), Bullets(cannot)],
        drawing=drawing,
        data=plain_data(data),
        rows={key: [value] for key, value in data.items()},
    )


def _home_runs(row: Mapping[str, Any]) -> list[str]:
    """Return a player's home runs in words."""
    counts = []
    if row["home_runs_expected"] is not None:
        counts.append(f"{row['home_runs_expected']:.1f} expected in the parks they were hit in")
    if row["home_runs"] is not None:
        counts.append(f"{grouped(row['home_runs'])} hit")
    kinds = [
        f"{grouped(row[key])} {singular if row[key] == 1 else several}"
        for key, singular, several in KINDS
        if row[key] is not None
    ]
    return [f"Home runs: {'; '.join(filter(None, (', '.join(counts), ', '.join(kinds))))}."] if counts or kinds else []


def _measures(row: Mapping[str, Any]) -> Table:
    heads = ("pooled", "50 %", "90 %", "own mean")
    columns = [
        Column("measure"),
        *(Column(head, right=True) for head in heads),
        Column("reliability", "ratio", 2),
        Column("percentile", right=True),
    ]
    rows: list[list[Cell]] = []
    for name, (scale, words) in MEASURES.items():
        if row.get(name) is None:
            continue
        trust = row[f"{name}_reliability"]

        def ends(width: str, name: str = name, scale: str = scale) -> Cell:
            low, high = row[f"{name}_low{width}"], row[f"{name}_high{width}"]
            return None if low is None else joined([Slot(low, scale).bare, "to", Slot(high, scale)])

        rows.append([
            words, Slot(row[name], scale), ends("50"), ends("90"), Slot(row[f"{name}_mean"], scale),
            trust, f"{row[f'{name}_percentile']:.0f}" if (trust or 0.0) > TELLING else None,
        ])  # fmt: skip
    return Table("Against everybody in the tables", columns, rows)


def _bats(row: Mapping[str, Any]) -> list[Paragraph]:
    gains = {
        name.removeprefix(WITH): value
        for name, value in row.items()
        if name.startswith(WITH) and f"{name}_balls" in row and value is not None
    }
    if not gains:
        return []
    best = max(gains, key=lambda name: gains[name])
    if gains[best] <= 0:
        return [Paragraph("None of the bats tried gives more exit speed than the player's own.")]
    gain, ends = Slot(gains[best], "speed_change", 1, sign=True), [row[f"{WITH}{best}_{end}"] for end in ENDS]
    if None in ends:
        unsure = (
            "Of the bats tried {bat} would serve best: {gain} of exit speed; so few balls do not tell how sure it is."
        )
        return [Paragraph(say(unsure, bat=best, gain=gain))]
    low, high = (Slot(end, "speed_change", 1, sign=True) for end in ends)
    words = say(
        "Of the bats tried {bat} would serve best: {gain} of exit speed on average ({low} to {high} in 90 % by chance "
        "alone; the error of the swing law comes on top).",
        bat=best,
        gain=gain,
        low=low.bare,
        high=high,
    )
    return [Paragraph(words)]


def _drawn(answer: SeasonAnswer, batter: str, name: str, reading: Reader) -> Any:
    from sweetspot.reports.season.picture import season_figure

    return season_figure(answer.counted.filter(pl.col("batter") == batter), title=name, reading=reading)
