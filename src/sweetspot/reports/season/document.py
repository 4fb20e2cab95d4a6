"""A season as a document: what was read, what to beware of, the league, and who did what."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import polars as pl

from sweetspot.answers.cautions import Caution, cautioned_files
from sweetspot.answers.records import plain_data
from sweetspot.answers.season import SeasonAnswer, SeasonPlayer, SeasonTable
from sweetspot.errors import UnwritableError
from sweetspot.numerics.interval import Interval
from sweetspot.numerics.text_files import harmless
from sweetspot.reports.build_info import made_with
from sweetspot.reports.document import (
    Block,
    Bullets,
    Cell,
    Column,
    Document,
    Paragraph,
    Picture,
    Section,
    Table,
    drawn,
    table_head,
)
from sweetspot.reports.files import write_all
from sweetspot.reports.season.words import (
    best_bat_words,
    few_of_a_kind,
    league_words,
    left_over_words,
    player_words,
    untracked_words,
)
from sweetspot.reports.sentences import Slot, joined, within
from sweetspot.seasons.ball_columns import WITH
from sweetspot.seasons.batters import table_stem
from sweetspot.seasons.home_run_table import HomeRunsOf
from sweetspot.seasons.rows import REASONS
from sweetspot.seasons.season_drag import DragOfMonth
from sweetspot.seasons.standings import MEASURES, Standing
from sweetspot.seasons.table_copies import LEFT_OUT
from sweetspot.seasons.table_file import CANNOT_TELL, WARNINGS, is_parquet
from sweetspot.units import grouped
from sweetspot.units.dimensions import unit_of

SHOWN = 15
"""Players in the printed table."""
FEWEST = 5
"""Balls of a player in the printed table."""
FIRST_ROWS = 5
"""Rows that are named with something to beware of."""
LISTED = {
    "exit_speed": "exit speed",
    "bat_speed": "bat speed",
    "squared_up_ratio": "over the ceiling",
    "squared_up": "squared up",
    "from_best": "from the best place",
    "home_run_here": "home runs a ball",
}
"""Measures in the printed table of players, and what they are called there."""
PICTURED = (
    "A season: exit speed against ceilings, where bats met the ball, and what is left over of tracked distances by "
    "launch angle, exit speed, bearing and park."
)


def unread_of(answer: SeasonAnswer) -> list[str]:
    """Return why files could not be read, each by its name."""
    names = [(Path(unread.file).name, unread.reason) for unread in answer.not_read]
    return [reason if name in reason else f"{name}: {reason}" for name, reason in names]


def season_document(answer: SeasonAnswer) -> Document:
    """Return a season as a document; its JSON has the ledger, warnings, relation, drag and how groups scatter."""
    players = answer.standings.get("batter")
    details: list[Block] = []
    if answer.drag:
        details.append(_drag(answer.drag))
    if words := left_over_words(answer.left_over):
        details.append(Section("left_over", "Tracked distance less carry", [*map(Paragraph, words)]))
    details += _home_runs(answer.home_runs_by)
    if players is not None and (reliability := _reliability(players)).rows:
        rare = few_of_a_kind(answer.rare_shares["batter"])
        details += [reliability, *(Paragraph(words, "note") for words in rare)]
    details.append(Section("cannot", "What such tables cannot tell", [Bullets(answer.cannot_tell)]))
    return Document(
        name="season",
        title="Season",
        kind="Season",
        blocks=[
            *map(Paragraph, league_words(answer)),
            *(Paragraph(f"Not read: {fault}", "warning") for fault in unread_of(answer)),
            _ledger(answer.tables),
            *map(Paragraph, untracked_words(answer)),
            _warnings(answer.warnings),
            *([] if players is None else [_players(players)]),
        ],
        details=details,
        drawing=Picture(
            "season", drawn("sweetspot.reports.season.picture:season_figure", answer.drawn), label=PICTURED
        ),
        data=answer.to_dict(),
        rows=answer.to_frame().to_dict(as_series=False),
        passed=not answer.not_read,
    )


def _ledger(tables: Sequence[SeasonTable]) -> Table:
    reasons = [*(reason for reason in LEFT_OUT if any(reason in table.ledger for table in tables)), *REASONS]
    columns = [Column("table"), Column("rows", right=True), *(Column(reason, right=True) for reason in reasons)]
    counts = [[table.rows, *(table.ledger.get(reason, 0) for reason in reasons)] for table in tables]
    names = [Path(table.file).name for table in tables]
    if len(tables) > 1:
        counts.append([sum(column) for column in zip(*counts, strict=True)])
        names.append("all")
    rows: list[list[Cell]] = [[name, *map(grouped, numbers)] for name, numbers in zip(names, counts, strict=True)]
    return Table("Ledger: every row, and why it counts or not", columns, rows)


def _warnings(cautions: Sequence[Caution]) -> Block:
    if not cautions:
        return Paragraph("Nothing to beware of was found in the tables.", "note")
    rows: list[list[Cell]] = [
        [
            caution.name,
            Path(caution.tables[0].file).name if len(caution.tables) == 1 else f"{len(caution.tables)} tables",
            grouped(caution.rows),
            _first_rows(caution),
            WARNINGS[caution.name] + (f" ({caution.detail})" if caution.detail else ""),
        ]
        for caution in cautions
    ]
    columns = table_head("beware | table | rows > | first of them | what")
    of_csv = any(not is_parquet(Path(file)) for file in cautioned_files(cautions))
    title = "Beware; rows of a CSV file have the numbers that a spreadsheet shows" if of_csv else "Beware"
    return Table(title, columns, rows)


def _first_rows(caution: Caution) -> str:
    """Return the first rows that a caution concerns, of its first table with any; "all": it concerns whole tables."""
    named = [table for table in caution.tables if table.first_rows]
    if not named:
        return "all"
    first = named[0].first_rows[:FIRST_ROWS]
    rows = ", ".join(map(str, first)) + (", …" if caution.rows > len(first) else "")
    return rows if len(caution.tables) == 1 else f"{rows} in {Path(named[0].file).name}"


def _players(players: Standing) -> Block:
    table = players.table.filter(pl.col("balls") >= FEWEST).sort("exit_speed", descending=True).head(SHOWN)
    if table.is_empty():
        return Paragraph(f"No batter has {FEWEST} balls in play, so none is listed here; the tables have all.", "note")
    listed = [name for name in LISTED if name in table.columns and table[name].count()]
    columns = [
        Column("batter"),
        Column("balls", right=True),
        *(Column(LISTED[name], MEASURES[name][0], right=True) for name in listed),
        Column("home runs expected", right=True),
    ]
    rows: list[list[Cell]] = [
        [
            str(row.get("name") or row["batter"]),
            grouped(row["balls"]),
            *(_pooled(row, name) for name in listed),
            None if row["home_runs_expected"] is None else f"{row['home_runs_expected']:.1f}",
        ]
        for row in table.iter_rows(named=True)
    ]
    return Table("Players, partly pooled, with 90 % intervals: the highest exit speeds", columns, rows)


def _pooled(row: Mapping[str, Any], name: str) -> Cell:
    if row[name] is None:
        return None
    scale, low, high = MEASURES[name][0], row[f"{name}_low90"], row[f"{name}_high90"]
    if low is None:  # one ball of each player tells nothing of how balls scatter
        return Slot(row[name], scale, unit=False)
    return within(Interval(row[name], low, high), scale, unit=False)


KINDS_OF_BALLS: Mapping[str, tuple[str, str]] = {
    "launch_angle": ("launch angle", "angle"),
    "pull": ("direction, positive to the pull side", "angle"),
    "home_run_here": ("their chance", "share"),
}
"""What balls are grouped by in `home_runs_by`, and its scale."""


def _home_runs(groups: Mapping[str, Sequence[HomeRunsOf]]) -> list[Table]:
    """Return home runs expected and hit, a table for each grouping with any."""
    tables = []
    for kind, (words, scale) in KINDS_OF_BALLS.items():
        rows: list[list[Cell]] = [
            [
                joined([Slot(group.low, scale).bare, "to", Slot(group.high, scale)]),
                grouped(group.balls),
                f"{group.expected:.1f}",
                grouped(group.hit),
                f"{group.chance_spread:.1f}",
            ]
            for group in groups[kind]
            if group.hit or group.expected >= LEAST_EXPECTED
        ]
        if rows:
            columns = table_head(f"{words} | balls > | expected > | hit > | chance alone, one SD >")
            tables.append(Table(f"Home runs expected and hit, by {words}", columns, rows))
    return tables


def _drag(months: Sequence[DragOfMonth]) -> Table:
    columns = table_head("month | drag over the law's: ratio | standard error: ratio | fly balls > | games >")
    rows: list[list[Cell]] = [
        [month.month, month.drag, month.error, grouped(month.flies), grouped(month.games)] for month in months
    ]
    return Table("The season's own drag, from tracked distances; weather is not known, and is in it", columns, rows)


def _reliability(players: Standing) -> Table:
    """Return how well balls tell players apart: the reliability of each measure of which players have enough balls."""
    counts = (34, 100, 400)
    columns = table_head("measure | players >")
    columns += [Column(f"at {count} balls", right=True) for count in counts]
    rows: list[list[Cell]] = []
    for name, spread in players.spreads.items():
        intervals = [interval for count in counts if (interval := spread.reliability_interval(count)) is not None]
        if intervals:
            label = MEASURES[name][1] if name in MEASURES else f"gain with {name.removeprefix(WITH)}"
            cells = [within(interval, "ratio", digits=2) for interval in intervals]
            rows.append([label, grouped(spread.groups), *cells])
    title = "Reliability: how well so many balls of a player tell him from the others, with 90 % intervals"
    return Table(title, columns, rows)


def write_tables(answer: SeasonAnswer, folder: Path) -> list[str]:
    """Write each grouping's table as CSV and as Parquet and return the files' names.

    Raises
    ------
    InputError
        when one cannot be written.
    """
    contents: dict[Path, bytes] = {}
    for key in answer.standings:
        table = answer.to_frame(answer.question.system, key=key)
        stem = table_stem(key)
        texts = [column.name for column in table if column.dtype == pl.String]
        harmless_table = table.with_columns(pl.col(texts).map_elements(harmless, return_dtype=pl.String))
        contents[folder / f"{stem}.csv"] = harmless_table.write_csv().encode()
        held = io.BytesIO()
        units = {name: unit for name in table.columns if (unit := unit_of(name)) is not None}
        table.write_parquet(held, metadata={"made_with": json.dumps(made_with()), "units": json.dumps(units)})
        contents[folder / f"{stem}.parquet"] = held.getvalue()
    if contents:
        write_all(contents)
    return sorted(path.name for path in contents)


def write_balls(answer: SeasonAnswer, folder: Path) -> str:
    """Write every ball with all answers as CSV, a part after the other, and return the file's name.

    Raises
    ------
    InputError
        when it cannot be written.
    """
    file, balls = folder / BALLS_CSV, answer.balls()
    texts = [name for name, kind in balls.collect_schema().items() if kind == pl.String]
    formula = pl.col(texts).str.contains(FORMULA) & pl.col(texts).cast(pl.Float64, strict=False).is_null()
    quoted = pl.when(formula).then("'" + pl.col(texts)).otherwise(pl.col(texts)).name.keep()
    try:
        balls.with_columns(quoted).sink_csv(file)
    except OSError as error:
        raise UnwritableError(f"{file} cannot be written: {error.strerror or error}") from None
    return file.name


BALLS_CSV = "balls.csv"
FORMULA = r"^[=+\-@\t\r]"
"""Beginnings of texts that a spreadsheet takes as formulas, as `harmless` has them."""
FIGURE = "sweetspot.reports.season.picture:season_figure"
LEAST_EXPECTED = 0.5
"""Home runs expected of balls of a kind below which, and without any hit, it is not listed."""
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
