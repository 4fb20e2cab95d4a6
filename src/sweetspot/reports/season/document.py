"""A season as a document: what was read, what to beware of, the league, and who did what."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl

from sweetspot.answers.season import Caution, Places, SeasonAnswer, SeasonMeans, SeasonTable
from sweetspot.numerics.interval import Interval
from sweetspot.reports.document import Block, Bullets, Cell, Column, Document, Paragraph, Picture, Section, Table
from sweetspot.reports.quantities import Reader
from sweetspot.reports.season.left_over import left_over_words, own_drag_words
from sweetspot.reports.sentences import Sentence, Slot, say, within
from sweetspot.seasons.rows import REASONS
from sweetspot.seasons.season_drag import DragOfMonth
from sweetspot.seasons.standings import MEASURES, Standing
from sweetspot.seasons.stat_rows import WITH
from sweetspot.seasons.table_copies import LEFT_OUT
from sweetspot.seasons.table_file import is_parquet
from sweetspot.seasons.table_warnings import WARNINGS
from sweetspot.units import grouped

SHOWN = 15
"""Players in the printed table."""
FEWEST = 5
"""Balls of a player in the printed table."""
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
    if players is not None and (reliability := _reliability(players)).rows:
        rare = few_of_a_kind(answer.rare_shares["batter"])
        details += [reliability, *(Paragraph(words, "note") for words in rare)]
    details.append(Section("cannot", "What such tables cannot tell", [Bullets(answer.cannot_tell)]))
    return Document(
        name="season",
        title="Season",
        kind="Season",
        blocks=[
            *map(Paragraph, _headline(answer)),
            *(Paragraph(f"Not read: {fault}", "warning") for fault in unread_of(answer)),
            _ledger(answer.tables),
            *_untracked(answer),
            _warnings(answer.warnings),
            *([] if players is None else [_players(players)]),
        ],
        details=details,
        drawing=Picture("season", partial(_drawn, answer), label=PICTURED),
        data=answer.to_dict(),
        rows=answer.to_frame().to_dict(as_series=False),
        passed=not answer.not_read,
    )


def few_of_a_kind(rare: Sequence[str]) -> list[Sentence]:
    """Return which shares are so rare that their intervals are surer than they should be, in words."""
    if not rare:
        return []
    words = (
        "Fewer than three of a kind a player: {shares}. Such intervals of 90 % hold about 84 to 88 %, for the truth "
        "may lie nearer 0 or 100 %."
    )
    return [say(words, shares="; ".join(MEASURES[name][1].partition(":")[0] for name in rare))]


def _headline(answer: SeasonAnswer) -> list[Sentence]:
    league, places = answer.league, answer.places
    files = "one file" if len(answer.tables) == 1 else f"{len(answer.tables)} files"
    rows = sum(table.rows for table in answer.tables)
    counted = "{rows} rows in {files}; {balls} balls in play with an exit speed."
    sentences = [say(counted, rows=grouped(rows), files=files, balls=grouped(league.balls))]
    if league.home_runs_expected is not None and league.home_runs is not None:
        words = "Home runs: {expected} expected in the parks they were hit in, {hit} hit."
        sentences.append(say(words, expected=grouped(league.home_runs_expected), hit=grouped(league.home_runs)))
        sentences += own_drag_words(league, answer.drag)
    if league.squared_up is not None and league.from_best is not None:
        names = answer.season.setting.bat_names
        bats = names[0] if len(names) == 1 else f"{len(names)} bats"
        words = "Squared up (0.80 of what the bat could give): {part} of the balls, against {bats}."
        sentences.append(say(words, part=Slot(league.squared_up, "share"), bats=bats))
        sentences += _by_league_formula(league)
        words = "Balls are met {distance} from the best place on average."
        sentences.append(say(words, distance=Slot(league.from_best, "offset")))
    words = "With {bat} the same swings would have given {gain} of exit speed on average, over {balls} balls."
    for other in answer.other_bats:
        gain = within(Interval(other.gain, other.low, other.high), "speed_change", digits=1, sign=True)
        sentences.append(say(words, bat=other.bat, gain=gain, balls=grouped(other.balls)))
    if places is not None and places.balls:
        sentences.append(_learned(places))
    elif places is not None:
        sentences.append(Sentence((NO_SPEEDS if league.squared_up is None else FEW_SPEEDS,)))
    return sentences


def _by_league_formula(league: SeasonMeans) -> list[Sentence]:
    """Return the league's rate, and of how many balls where its formula lacks the speed of many pitches."""
    if league.league_squared_up is None or league.squared_up_of_the_same is None:
        return []
    words, rate = "By the league's formula, which knows no bat: {league}", Slot(league.league_squared_up, "share")
    if league.league_squared_up_balls > 0.9 * league.squared_up_balls:
        return [say(words + ".", league=rate)]
    words += " of the {balls} balls whose pitch has a speed, {same} of the same against the bat."
    same = Slot(league.squared_up_of_the_same, "share")
    return [say(words, league=rate, balls=grouped(league.league_squared_up_balls), same=same)]


NO_SPEEDS = "No table has bat speeds, so nothing is reported about bats."
FEW_SPEEDS = (
    "Too few balls have a bat speed to learn from them where these batters meet the ball; where batters usually do is "
    "taken instead, so what is reported about bats is rough."
)


def _learned(places: Places) -> Sentence:
    pitch = places.a_pitch_outside
    return say(
        "Learnt from {balls} swings: the ball is met {mean} from the tip on average, scattering by {spread} about what "
        "the pitch's place says; a pitch {further} further outside is met {slope} {way} the tip; exit speeds are "
        "{level} beside the bat's and scatter by {noise} more than measuring errors do.",
        balls=grouped(places.balls),
        mean=Slot(places.marginal[0], "place"),
        spread=Slot(places.spread, "place"),
        further=Slot(pitch.outside, "distance"),
        slope=Slot(abs(pitch.nearer_the_tip), "place"),
        way="nearer" if pitch.nearer_the_tip >= 0 else "further from",
        level=f"{round(100 * float(places.level_weights[0]), 1) + 0.0:+.1f} %",
        noise=Slot(places.noise, "speed"),
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


def _untracked(answer: SeasonAnswer) -> list[Block]:
    """Return in words the effect of balls without exit speed; nothing where there are none."""
    count, bias = sum(table.ledger["untracked"] for table in answer.tables), answer.untracked
    if not count:
        return []
    if bias is None:
        words = "{balls} in play without exit speed; nothing tells how they ended, so what they would change is open."
        return [Paragraph(say(words, balls="1 ball" if count == 1 else f"{grouped(count)} balls"))]
    words = (
        "{share} of the balls in play have no exit speed. Were they hit as tracked ones that ended alike, as "
        "far out, the mean exit speed of all would be {all} instead of {tracked}; most likely they were hit less "
        "hard still."
    )
    speeds = bias.mean_exit_speed_of_all, bias.mean_exit_speed_of_tracked
    of_all, of_tracked = (Slot(speed, "speed") for speed in speeds)
    return [Paragraph(say(words, share=Slot(bias.share, "share", 1), all=of_all, tracked=of_tracked))]


def _warnings(cautions: Sequence[Caution]) -> Block:
    if not cautions:
        return Paragraph("Nothing to beware of was found in the tables.", "note")
    rows: list[list[Cell]] = []
    for caution in cautions:
        first = caution.first_rows[:5]
        where = ", ".join(map(str, first)) + (", …" if caution.rows > len(first) > 0 else "")
        detail = f" ({caution.detail})" if caution.detail else ""
        what = WARNINGS[caution.name] + detail
        rows.append([caution.name, Path(caution.file).name, grouped(caution.rows), where or "all", what])
    columns = [Column("beware"), Column("table"), Column("rows", right=True), Column("first of them"), Column("what")]
    of_csv = any(caution.first_rows and not is_parquet(Path(caution.file)) for caution in cautions)
    title = "Beware; rows of a CSV file have the numbers that a spreadsheet shows" if of_csv else "Beware"
    return Table(title, columns, rows)


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


def _drag(months: Sequence[DragOfMonth]) -> Table:
    columns = [Column("month"), Column("drag over the law's", "ratio"), Column("standard error", "ratio"),
               Column("fly balls", right=True), Column("games", right=True)]  # fmt: skip
    rows: list[list[Cell]] = [
        [month.month, month.drag, month.error, grouped(month.flies), grouped(month.games)] for month in months
    ]
    return Table("The season's own drag, from tracked distances; weather is not known, and is in it", columns, rows)


def _reliability(players: Standing) -> Table:
    """Return how well balls tell players apart: the reliability of each measure."""
    counts = (34, 100, 400)
    columns = [Column("measure"), Column("players", right=True)]
    columns += [Column(f"at {count} balls", "ratio", 2) for count in counts]
    rows: list[list[Cell]] = []
    for name, spread in players.spreads.items():
        reliability = spread.reliability(np.array(counts))
        if spread.groups and np.isfinite(reliability).any():
            label = MEASURES[name][1] if name in MEASURES else f"gain with {name.removeprefix(WITH)}"
            rows.append([label, grouped(spread.groups), *(None if np.isnan(part) else part for part in reliability)])
    return Table("Reliability: how well so many balls of a player tell him from the others", columns, rows)


def _drawn(answer: SeasonAnswer, reading: Reader) -> Any:
    from sweetspot.reports.season.picture import season_figure

    return season_figure(answer.drawn, reading=reading)
