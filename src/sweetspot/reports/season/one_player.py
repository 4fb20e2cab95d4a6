"""A page to print for one player of a season."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import polars as pl

from sweetspot.answers.records import plain_data
from sweetspot.answers.season import SeasonPlayer
from sweetspot.reports.document import Bullets, Cell, Column, Document, Paragraph, Picture, Table, drawn
from sweetspot.reports.season.words import best_bat_words, few_of_a_kind, player_words
from sweetspot.reports.sentences import Slot, joined
from sweetspot.seasons.standings import MEASURES
from sweetspot.seasons.table_file import CANNOT_TELL

FIGURE = "sweetspot.reports.season.picture:season_figure"
TELLING = 0.05
"""Reliability below which players do not differ, and a percentile would be chance."""


def player_page(player: SeasonPlayer) -> Document:
    """Return one player's page: every measure partly pooled, with its intervals, reliability and rank in the table."""
    answer, row, data = player.season, player.row, player.to_dict()
    number = str(row["batter"])
    name = str(row.get("name") or f"Player {number}")
    balls = answer.counted.filter(pl.col("batter") == number)
    drawing = Picture(
        "player",
        drawn(FIGURE, balls, title=name),
        label=f"Balls of {name}.",
        sheet=drawn(FIGURE, balls, title=""),
    )
    cannot = answer.cannot_tell if row.get("squared_up") is not None else (CANNOT_TELL["fouls"],)
    rare = [Paragraph(sentence, "note") for sentence in few_of_a_kind(answer.rare_shares["batter"])]
    return Document(
        name=f"player-{number}",
        title=name,
        kind="Season of a player",
        blocks=[
            Paragraph(player_words(row)),
            _measures(row),
            *rare,
            drawing,
            *map(Paragraph, best_bat_words(row)),
            Bullets(cannot),
        ],
        drawing=drawing,
        data=plain_data(data),
        rows={key: [value] for key, value in data.items()},
    )


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
