"""A season as a document: what was read, what to beware of, the league, and who did what."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np
import polars as pl

from sweetspot.numerics.interval import Interval
from sweetspot.report.document import Block, Bullets, Cell, Column, Document, Paragraph, Picture, Section, Table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import Reader
from sweetspot.report.season.left_over import KINDS, left_over_by, left_over_words, own_drag_words
from sweetspot.report.season.standing_columns import with_units
from sweetspot.report.sentences import Sentence, Slot, say, within
from sweetspot.season.counted import WITH
from sweetspot.season.csv_copy import LEFT_OUT
from sweetspot.season.gains import Gain, gains_of
from sweetspot.season.maps import known_sum
from sweetspot.season.place_relation import PlaceRelation
from sweetspot.season.rows import REASONS, USED
from sweetspot.season.season_drag import DragOfMonth, drag_by_month
from sweetspot.season.season_table import Season
from sweetspot.season.standings import MEASURES, Standing, above_expected_parts, all_standings, rare_shares
from sweetspot.season.table_warnings import WARNINGS
from sweetspot.season.untracked import Untracked, untracked_bias
from sweetspot.units import FOOT, grouped

SHOWN = 15
"""Players in the printed table."""
MOST_DRAWN = 2_000_000
"""Balls that are held together, for what cannot be added up part by part."""
FEWEST = 5
"""Balls of a player in the printed table."""
LISTED = {
    "exit_speed": "exit speed", "bat_speed": "bat speed", "squared_up_ratio": "over the ceiling",
    "squared_up": "squared up", "from_best": "from the best place", "home_run_here": "home runs a ball",
}  # fmt: skip
"""Measures in the printed table of players, and what they are called there."""
NO_FOULS = (
    "Misses have no exit speed, and fouls seldom all have one, so nothing per contact or per swing can be told; timing "
    "needs the place of the bat in time, which tables seldom hold."
)
SIDE = (
    "Which side of the best place one ball was met on is told by the pitch's place alone; tip_side near 0.5 says that "
    "it cannot be told."
)
CANNOT = (
    SIDE,
    NO_FOULS,
    "Without a bat of each player every ball is judged against one bat; a ceiling then is that bat's, not the player's "
    "own.",
)
"""What a table of batted balls cannot tell."""
PICTURED = (
    "A season: exit speed against ceilings, where bats met the ball, and what is left over of tracked distances by "
    "launch angle, exit speed, bearing and park."
)


@dataclass(frozen=True)
class SeasonReport:
    """What is told of a season.

    Parameters
    ----------
    season : the answers.
    standings : tables of groups.
    drag : by month.
    untracked : how the balls without exit speed bias the mean.
    gains : with the bats that were tried.
    counted : groups and measures of the balls.
    drawn : of them evenly some, where they are many: for pictures, drag and what is left over of distances.
    """

    season: Season
    standings: Mapping[str, Standing]
    drag: tuple[DragOfMonth, ...]
    untracked: Untracked | None
    gains: tuple[Gain, ...]
    counted: pl.LazyFrame
    drawn: pl.LazyFrame


def season_report(season: Season) -> SeasonReport:
    """Return everything that is told of a season; groups that no ball has are left out."""
    parts = above_expected_parts(season.counted_parts())
    counted = pl.concat(parts, how="diagonal_relaxed")
    balls = sum(counts[USED] for counts in season.survey.counts)
    drawn = counted if balls <= MOST_DRAWN else counted.gather_every(-(-balls // MOST_DRAWN))
    return SeasonReport(
        season, all_standings(parts), drag_by_month(drawn), untracked_bias(season.survey),
        tuple(gains_of(season)), counted, drawn,
    )  # fmt: skip


def unread_of(season: Season) -> list[str]:
    """Return why files could not be read, each by its name."""
    return [reason if path.name in reason else f"{path.name}: {reason}" for path, reason in season.survey.faults]


def season_document(report: SeasonReport) -> Document:
    """Return a season as a document; its JSON has the ledger, warnings, relation, drag and how groups scatter."""
    season = report.season
    blocks: list[Block] = [Paragraph(words) for words in _headline(report)]
    blocks += [Paragraph(f"Not read: {fault}", "warning") for fault in unread_of(season)]
    blocks += [_ledger(season), *_untracked(report), _warnings(season)]
    if "batter" in report.standings:
        blocks.append(_players(report.standings["batter"]))
    details: list[Block] = []
    if report.drag:
        details.append(_drag(report.drag))
    if words := left_over_words(report.drawn):
        details.append(Section("left_over", "Tracked distance less carry", [Paragraph(one) for one in words]))
    if (groups := _groups(report)).rows:
        details += [groups, *(Paragraph(words, "note") for words in few_of_a_kind(report.standings["batter"]))]
    details.append(Section("cannot", "What such tables cannot tell", [Bullets(cannot_tell(season))]))
    drawing = Picture("season", partial(_drawn, report), label=PICTURED)
    players = report.standings.get("batter")
    return Document(
        name="season", title="Season", kind="Season", blocks=blocks, details=details, drawing=drawing,
        data=season_json(report),
        rows={} if players is None else with_units(players, system="si").to_dict(as_series=False),
        passed=not season.survey.faults,
    )  # fmt: skip


def cannot_tell(season: Season) -> tuple[str, ...]:
    """Return what the tables of a season cannot tell; one that measures places along the bat tells the side."""
    measured = all(table.headings.has("axial_offset") for table in season.survey.tables)
    return tuple(words for words in CANNOT if words != SIDE or not measured)


def few_of_a_kind(players: Standing) -> list[Sentence]:
    """Return which shares are so rare that their intervals are surer than they should be, in words."""
    rare = [MEASURES[name][1].partition(":")[0] for name in rare_shares(players)]
    if not rare:
        return []
    words = (
        "Fewer than three of a kind a player: {shares}. Such intervals of 90 % hold about 84 to 88 %, for the truth "
        "may lie nearer 0 or 100 %."
    )
    return [say(words, shares="; ".join(rare))]


def _headline(report: SeasonReport) -> list[Sentence]:
    season = report.season
    rows, used = season.survey.rows, sum(counts[USED] for counts in season.survey.counts)
    told = [say("{rows} rows in {files}; {used} balls in play with an exit speed.", rows=grouped(rows),
                files=_files(len(season.survey.tables)), used=grouped(used))]  # fmt: skip
    means = _means(report.counted)
    if np.isfinite(means["home_run_here"]) and np.isfinite(means["home_runs"]):
        told.append(say("Home runs: {expected} expected in the parks they were hit in, {real} hit.",
                        expected=grouped(means['home_run_here']), real=grouped(means['home_runs'])))  # fmt: skip
        told += own_drag_words(report.counted, report.drag)
    if np.isfinite(means.get("squared_up", np.nan)):
        told.append(say("Squared up (0.80 of what the bat could give): {own} of the balls, against {bat}.",
                        own=Slot(means["squared_up"], "share"), bat=_bats(season)))  # fmt: skip
        if np.isfinite(means["league_squared_up"]):
            told.append(_league_s(means))
        told.append(say("Balls are met {distance} from the best place on average.",
                        distance=Slot(means["from_best"], "offset")))  # fmt: skip
    told += [
        say("With {bat} the same swings would have given {gain} of exit speed on average, over {balls} balls.",
            bat=one.bat, gain=within(Interval(one.mean, one.low, one.high), "speed_change", digits=1, sign=True),
            balls=grouped(one.balls))
        for one in report.gains
    ]  # fmt: skip
    if season.setting.contact is not None and season.setting.contact.relation.balls:
        told.append(_relation(season.setting.contact.relation))
    elif season.setting.contact is not None:
        told.append(Sentence((FEW_SPEEDS if np.isfinite(means.get("squared_up", np.nan)) else NO_SPEEDS,)))
    return told


def _league_s(means: Mapping[str, float]) -> Sentence:
    """Return the league's rate, and of how many balls where its formula lacks the speed of many pitches."""
    known, every = means["league_squared_up balls"], means["squared_up balls"]
    words = "By the league's formula, which knows no bat: {league}"
    if known > 0.9 * every:
        return say(words + ".", league=Slot(means["league_squared_up"], "share"))
    return say(
        words + " of the {known} balls whose pitch has a speed, {own} of the same against the bat.",
        league=Slot(means["league_squared_up"], "share"), known=grouped(known),
        own=Slot(means["squared_up of the same"], "share"),
    )  # fmt: skip


NO_SPEEDS = "No table has bat speeds, so nothing is told of bats."
FEW_SPEEDS = (
    "Too few balls have a bat speed to learn from them where these batters meet the ball; where batters usually do is "
    "taken instead, so what is told of bats is rough."
)


def _files(count: int) -> str:
    return "one file" if count == 1 else f"{count} files"


def _bats(season: Season) -> str:
    names = season.setting.bat_names
    return names[0] if len(names) == 1 else f"{len(names)} bats"


def _nearer_the_tip(relation: PlaceRelation) -> float:
    """Return by how much nearer the tip a pitch is met that is a foot further outside, m."""
    return -float(relation.weights[1]) * FOOT / 0.3


def _relation(relation: PlaceRelation) -> Sentence:
    towards_tip = _nearer_the_tip(relation)
    return say(
        "Learnt from {balls} swings: the ball is met {mean} from the tip on average, scattering by {spread} about what "
        "the pitch's place says; a pitch {further} further outside is met {slope} {way} the tip; exit speeds are "
        "{level} beside the bat's and scatter by {noise} more than measuring errors do.",
        balls=grouped(relation.balls), mean=Slot(relation.marginal[0], "place"), spread=Slot(relation.spread, "place"),
        further=Slot(FOOT, "distance"),
        slope=Slot(abs(towards_tip), "place"), way="nearer" if towards_tip >= 0 else "further from",
        level=f"{round(100 * relation.level, 1) + 0.0:+.1f} %",
        noise=Slot(relation.noise, "speed"),
    )  # fmt: skip


def _means(counted: pl.LazyFrame) -> dict[str, float]:
    names = counted.collect_schema().names()
    wanted = [name for name in ("squared_up", "league_squared_up", "from_best") if name in names]
    row = counted.select(
        *(pl.col(name).cast(pl.Float64).mean() for name in wanted),
        *(pl.col(name).count().cast(pl.Float64).alias(f"{name} balls") for name in wanted),
        *([pl.col("squared_up").cast(pl.Float64).filter(pl.col("league_squared_up").is_not_null()).mean()
           .alias("squared_up of the same")] if "league_squared_up" in wanted else []),
        home_run_here=known_sum(pl.col("home_run_here").cast(pl.Float64)),
        home_runs=known_sum(pl.col("event").str.to_lowercase().str.replace_all("[_ ]", "") == "homerun"),
    ).collect(engine="streaming").row(0, named=True)  # fmt: skip
    return {name: np.nan if value is None else value for name, value in row.items()}


def _ledger(season: Season) -> Table:
    survey = season.survey
    reasons = [*(reason for reason in LEFT_OUT if any(reason in counts for counts in survey.counts)), *REASONS]
    columns = [Column("table"), Column("rows", right=True), *(Column(reason, right=True) for reason in reasons)]
    rows: list[list[Cell]] = [
        [table.path.name, grouped(table.lines), *(grouped(counts.get(reason, 0)) for reason in reasons)]
        for table, counts in zip(survey.tables, survey.counts, strict=True)
    ]
    if len(rows) > 1:
        totals = [sum(counts.get(reason, 0) for counts in survey.counts) for reason in reasons]
        rows.append(["all", grouped(survey.rows), *(grouped(total) for total in totals)])
    return Table("Ledger: every row, and why it counts or not", columns, rows)


def _untracked(report: SeasonReport) -> list[Block]:
    """Return what balls without exit speed would change, in words; nothing where there are none."""
    lost = sum(counts["untracked"] for counts in report.season.survey.counts)
    if not lost:
        return []
    if report.untracked is None:
        words = "{balls} in play without exit speed; nothing tells how they ended, so what they would change is open."
        return [Paragraph(say(words, balls="1 ball" if lost == 1 else f"{grouped(lost)} balls"))]
    bias = report.untracked
    words = (
        "{share} of the balls in play have no exit speed. Were they hit as tracked ones that ended alike, as "
        "far out, the mean exit speed of all would be {estimated} instead of {tracked}; most likely they were hit less "
        "hard still."
    )
    return [Paragraph(say(words, share=Slot(bias.share, "share", 1), estimated=Slot(bias.estimated, "speed"),
                          tracked=Slot(bias.tracked, "speed")))]  # fmt: skip


def _warnings(season: Season) -> Block:
    survey = season.survey
    rows: list[list[Cell]] = []
    for warning in survey.warnings:
        table = survey.tables[warning.table].path.name
        where = ", ".join(map(str, warning.rows[:5])) + (", …" if warning.count > len(warning.rows[:5]) > 0 else "")
        where = where or "all"
        detail = f" ({warning.detail})" if warning.detail else ""
        rows.append([warning.name, table, grouped(warning.count), where, WARNINGS[warning.name] + detail])
    if not rows:
        return Paragraph("Nothing to beware of was found in the tables.", "note")
    columns = [Column("beware"), Column("table"), Column("rows", right=True), Column("first of them"), Column("what")]
    shown = any(warning.rows and survey.tables[warning.table].first > 1 for warning in survey.warnings)
    title = "Beware; rows of a CSV file have the numbers that a spreadsheet shows" if shown else "Beware"
    return Table(title, columns, rows)


def _players(players: Standing) -> Block:
    table = players.table.filter(pl.col("balls") >= FEWEST).sort("exit_speed", descending=True).head(SHOWN)
    if table.is_empty():
        return Paragraph(f"No batter has {FEWEST} balls in play, so none is listed here; the tables have all.", "note")
    listed = [name for name in LISTED if name in table.columns and table[name].count()]
    columns = [Column("batter"), Column("balls", right=True),
               *(Column(LISTED[name], MEASURES[name][0], right=True) for name in listed),
               Column("home runs expected", right=True)]  # fmt: skip
    rows: list[list[Cell]] = [
        [
            str(row.get("name") or row["batter"]), grouped(row['balls']),
            *(_pooled(row, name) for name in listed),
            None if row["home_runs_expected"] is None else f"{row['home_runs_expected']:.1f}",
        ]
        for row in table.iter_rows(named=True)
    ]  # fmt: skip
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
        [one.month, one.drag, one.error, grouped(one.flies), grouped(one.games)] for one in months
    ]
    return Table("The season's own drag, from tracked distances; weather is not known, and is in it", columns, rows)


def _groups(report: SeasonReport) -> Table:
    """Return how balls and groups scatter: the reliability of each measure."""
    columns = [Column("measure"), Column("players", right=True), Column("at 34 balls", "ratio", 2),
               Column("at 100 balls", "ratio", 2), Column("at 400 balls", "ratio", 2)]  # fmt: skip
    players = report.standings.get("batter")
    rows: list[list[Cell]] = []
    for name, spread in ({} if players is None else players.spreads).items():
        if spread.groups:
            label = MEASURES[name][1] if name in MEASURES else f"gain with {name.removeprefix(WITH)}"
            trust = [float(spread.reliability(count)) for count in (34, 100, 400)]
            if np.isfinite(trust).any():
                rows.append([label, grouped(spread.groups), *(None if np.isnan(part) else part for part in trust)])
    return Table("Reliability: how well so many balls of a player tell him from the others", columns, rows)


def season_json(report: SeasonReport) -> dict[str, Any]:
    """Return what is told of a season for other programs; SI."""
    season, survey = report.season, report.season.survey
    contact = season.setting.contact
    return cleaned({
        "tables": [
            {
                "file": str(table.path), "system": table.headings.system, "rows": table.lines, "ledger": counts,
                "first_day": days and str(days[0]), "last_day": days and str(days[1]),
                "columns": {name: {"heading": column.heading, "unit": column.unit}
                            for name, column in table.headings.columns.items()},
                "passed_through": list(table.headings.passed),
            }
            for table, counts, days in zip(survey.tables, survey.counts, survey.days, strict=True)
        ],
        "not_read": [{"file": str(path), "reason": reason} for path, reason in survey.faults],
        "warnings": [{"name": one.name, "file": str(survey.tables[one.table].path), "rows": one.count,
                      "first_rows": one.rows, "detail": one.detail} for one in survey.warnings],
        "untracked": None if report.untracked is None else _bias(report.untracked),
        "places": None if contact is None else _places(contact.relation),
        "surfaces": [] if contact is None else [
            {"bat": surface.bat.name, "speed_error_m_s": surface.speed_error, "angle_error_rad": surface.angle_error}
            for surface in (*contact.surfaces, *(other.surface for other in contact.others))
        ],
        "other_bats": [
            {"bat": one.bat, "balls": one.balls, "gain_m_s": one.mean, "low_m_s": one.low, "high_m_s": one.high}
            for one in report.gains
        ],
        "drag": [asdict(one) for one in report.drag],
        "left_over": {kind: left_over_by(report.drawn, kind).to_dicts() for kind in KINDS},
        "scatter": {key: {name: asdict(spread) for name, spread in one.spreads.items()}
                    for key, one in report.standings.items()},
        "rare_shares": {key: rare_shares(one) for key, one in report.standings.items()},
        "cannot_tell": list(cannot_tell(season)),
    })  # fmt: skip


def _bias(untracked: Untracked) -> dict[str, float]:
    return {"share": untracked.share, "explained": untracked.explained,
            "mean_exit_speed_of_tracked_m_s": untracked.tracked,
            "mean_exit_speed_of_all_m_s": untracked.estimated}  # fmt: skip


def _places(relation: PlaceRelation) -> dict[str, Any]:
    outside = {"outside_m": FOOT, "nearer_the_tip_m": _nearer_the_tip(relation)}
    return asdict(relation) | {"spread_m": relation.spread, "noise_m_s": relation.noise, "a_pitch_outside": outside}


def _drawn(report: SeasonReport, reading: Reader) -> Any:
    from sweetspot.report.season.picture import season_figure

    return season_figure(report.drawn, reading=reading)
