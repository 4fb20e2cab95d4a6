"""A season: tables of balls in play of any size; what was read, the league, the groups, and what to beware of."""

from __future__ import annotations

import secrets
import shutil
import tempfile
import weakref
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import polars as pl

from sweetspot.answers.answer import Answer
from sweetspot.answers.cautions import Caution, cautions_of
from sweetspot.answers.records import GRID, INTERNAL
from sweetspot.answers.season_question import SeasonQuestion, checked_season
from sweetspot.collision.contact_table import table_errors, tabled_bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Interval
from sweetspot.seasons.agreement import Agreement, agreement_of
from sweetspot.seasons.ball_maps import is_home_run, known_sum
from sweetspot.seasons.batters import unknown_batter
from sweetspot.seasons.contact import ContactSetting
from sweetspot.seasons.home_run_table import EDGES as HOME_RUN_EDGES
from sweetspot.seasons.home_run_table import HomeRunsOf, home_run_tail, home_runs_by
from sweetspot.seasons.place_relation import SCALE, PlaceRelation
from sweetspot.seasons.plan import Plan, Progress
from sweetspot.seasons.pooling import Spread
from sweetspot.seasons.rows import USED
from sweetspot.seasons.season_drag import (
    EDGES,
    DragOfMonth,
    LeftOver,
    OwnDrag,
    drag_by_month,
    home_runs_with,
    left_over_by,
)
from sweetspot.seasons.season_table import Season, analyse_season
from sweetspot.seasons.standings import (
    OtherBatGain,
    Standing,
    above_expected_parts,
    all_standings,
    bat_gains,
    rare_shares,
)
from sweetspot.seasons.survey import Survey, TrackingBias, tracking_bias
from sweetspot.seasons.swings import SwingSpeeds
from sweetspot.seasons.table_file import cannot_tell
from sweetspot.units import FOOT
from sweetspot.units.dimensions import ANGLE, LENGTH, SPEED, System

MOST_DRAWN = 2_000_000
"""Balls that are held together, for what cannot be added up part by part."""
MOST_NAMED = 8
"""Batters of one name whose numbers are listed."""


@dataclass(frozen=True)
class ColumnMeaning:
    """A column that is understood: how the table calls it, and its unit."""

    heading: str
    unit: str


@dataclass(frozen=True)
class SeasonTable:
    """One table that was read.

    Parameters
    ----------
    system : whose headings it has.
    rows : that it was given with.
    ledger : rows by why they count or not.
    first_day, last_day : None where no date is known.
    columns : those that are understood, by quantity.
    passed_through : headings of the others.
    """

    file: str
    system: str
    rows: int
    ledger: Mapping[str, int]
    first_day: str | None
    last_day: str | None
    columns: Mapping[str, ColumnMeaning]
    passed_through: tuple[str, ...]


@dataclass(frozen=True)
class UnreadFile:
    """A file that cannot be read, and why."""

    file: str
    reason: str


@dataclass(frozen=True)
class PitchOutside:
    """By how much nearer the tip a pitch is met that is so much further outside."""

    outside: Annotated[float, LENGTH]
    nearer_the_tip: Annotated[float, LENGTH]


@dataclass(frozen=True)
class Places:
    """Where along the bat balls are met, see `PlaceRelation`: its weights in SI, and what they mean."""

    weights: Array
    spread_weights: Array
    level_weights: Array
    noise_weights: Array
    bat_speeds: SwingSpeeds
    marginal: tuple[float, float]
    balls: int
    covariance: Annotated[Array, GRID]
    spread_covariance: Annotated[Array, GRID]
    noise_covariance: Annotated[Array, GRID]
    evidence: float
    ranks: tuple[float, ...]
    spread: Annotated[float, LENGTH]
    noise: Annotated[float, SPEED]
    a_pitch_outside: PitchOutside


@dataclass(frozen=True)
class BatErrors:
    """By how much 95 of 100 hits of a bat's table miss the kernel."""

    bat: str
    speed_error: Annotated[float, SPEED]
    angle_error: Annotated[float, ANGLE]


@dataclass(frozen=True)
class SeasonMeans:
    """What all balls together say; None: no table tells.

    Parameters
    ----------
    home_runs, home_runs_expected : that were hit, and with the drag that balls fly with in the parks they were hit in.
    home_runs_by_drag : expected, with what is not known of the season's own drag; absent where the law's was used.
    home_runs_with_usual_drag : expected with the law's drag; absent where that was used.
    home_runs_tail : probability of so few home runs or fewer, or so many or more, whichever is smaller.
    from_best : mean distance from the best place along the bat.
    squared_up, league_squared_up : parts of the balls, against the bat and by the league's formula.
    squared_up_balls, league_squared_up_balls : of how many.
    squared_up_of_the_same : against the bat, of the balls that the league's formula tells of.
    """

    balls: int
    home_runs: int | None
    home_runs_expected: float | None
    from_best: Annotated[float | None, LENGTH]
    squared_up: float | None
    squared_up_balls: int
    league_squared_up: float | None
    league_squared_up_balls: int
    squared_up_of_the_same: float | None
    home_runs_by_drag: Interval | None = None
    home_runs_with_usual_drag: float | None = None
    home_runs_tail: float | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class SeasonAnswer(Answer):
    """The results of a season.

    Parameters
    ----------
    season : every ball's answers.
    standings : tables of groups, by the column they are grouped by.
    counted : groups and measures of the balls.
    drawn : of them evenly some, where they are many: for pictures, drag and what is left over of distances.
    temporary : a folder that is removed with the answer; None: it was asked for.
    untracked : how balls without exit speed bias the mean.
    places : where along the bat balls are met; None: contacts were not asked for.
    surfaces : of the bats' tables.
    other_bats : gains with the bats that were tried.
    drag : by the distances, over the law's, of all balls and of each month.
    own_drag : that the balls fly with; None: the law's, or one that was given.
    left_over : tracked distance less carry, by what balls are compared by.
    home_runs_by : expected and hit, by launch angle, direction to the pull side and chance.
    agreement : how many kinds of balls have the home runs and the distances that the tables tell.
    scatter : how balls and groups scatter, by grouping and measure.
    rare_shares : measures that rest on so few of a kind that their intervals hold less than they say, by grouping.
    cannot_tell : what the tables leave open.
    """

    question: Annotated[SeasonQuestion, INTERNAL]
    season: Annotated[Season, INTERNAL]
    standings: Annotated[Mapping[str, Standing], INTERNAL]
    counted: Annotated[pl.LazyFrame, INTERNAL]
    drawn: Annotated[pl.LazyFrame, INTERNAL]
    tables: tuple[SeasonTable, ...]
    not_read: tuple[UnreadFile, ...]
    warnings: tuple[Caution, ...]
    league: SeasonMeans
    untracked: TrackingBias | None
    places: Places | None
    surfaces: tuple[BatErrors, ...]
    other_bats: tuple[OtherBatGain, ...]
    drag: tuple[DragOfMonth, ...]
    own_drag: OwnDrag | None
    left_over: Mapping[str, tuple[LeftOver, ...]]
    home_runs_by: Mapping[str, tuple[HomeRunsOf, ...]]
    agreement: Agreement
    scatter: Mapping[str, Mapping[str, Spread]]
    rare_shares: Mapping[str, Sequence[str]]
    cannot_tell: tuple[str, ...]
    temporary: Annotated[object, INTERNAL] = None

    def __repr__(self) -> str:
        """Return the amount of data read."""
        return f"<SeasonAnswer of {self.league.balls} balls in play, {len(self.tables)} tables>"

    def balls(self) -> pl.LazyFrame:
        """Return every ball that counts: its own columns and the answers beside them."""
        return self.season.balls()

    def to_frame(self, units: System = "si", *, key: str = "batter") -> pl.DataFrame:
        """Return the table of players, or of another grouping, with the unit in every name; empty where there is none.

        ``key``: column that balls are grouped by, one of `standings.GROUPS`.
        """
        standing = self.standings.get(key)
        return pl.DataFrame() if standing is None else standing.with_units(units)

    def player(self, batter: str) -> SeasonPlayer:
        """Return the results of one batter, by number or name.

        Raises
        ------
        InputError
            for one whom no table has, or a name of several.
        """
        players = self.standings.get("batter")
        if players is None:
            raise InputError("no table has a column of batters, so there is no player to tell of")
        return SeasonPlayer(self, _row_of(players.table, batter))


@dataclass(frozen=True)
class SeasonPlayer(Answer):
    """One player of a season.

    ``season``: whose player it is. ``index``: row in its table of players.
    """

    season: Annotated[SeasonAnswer, INTERNAL]
    index: Annotated[int, INTERNAL]

    @property
    def row(self) -> Mapping[str, Any]:
        """Every measure in SI, without units in the names."""
        return self.season.standings["batter"].table.row(self.index, named=True)

    def to_dict(self, units: System = "si") -> dict[str, object]:
        """Return the player's row of the table of players, with the unit in every name."""
        return self.season.to_frame(units).row(self.index, named=True)


def season_answer(
    question: SeasonQuestion,
    *,
    run: Callable[[Plan, Progress | None], None] | None = None,
    progress: Progress | None = None,
) -> SeasonAnswer:
    """Return the results of a season; groups without balls are left out.

    ``run``: does a plan's tasks; None: in this process, two at a time. ``progress``: called with the rows done and in
    all.

    Raises
    ------
    InputError
        when none of the tables can be read, none holds a ball in play, or `checked_season` refuses the question.
    UnwritableError
        when there is no room for the copy of a CSV file.
    """
    if question.setting is None:
        question = checked_season(question)
    temporary = _TemporaryFolder()
    season = analyse_season(
        question.paths,
        setting=question.setting,
        folder=question.folder or temporary.path,
        given=question.given,
        resume=question.resume,
        run=run,
        progress=progress,
    )
    return replace(_summarised(question, season), temporary=temporary)


class _TemporaryFolder:
    """A folder that is removed with the last object that holds it, or at the end of the process."""

    def __init__(self) -> None:
        self.path = Path(tempfile.gettempdir()) / f"sweetspot-season-{secrets.token_hex(6)}"
        weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)


def _summarised(question: SeasonQuestion, season: Season) -> SeasonAnswer:
    survey, contact = season.survey, season.setting.contact
    parts = above_expected_parts(season.counted_parts())
    counted = pl.concat(parts, how="diagonal_relaxed")
    balls = sum(counts[USED] for counts in survey.counts)
    drawn = counted if balls <= MOST_DRAWN else counted.gather_every(-(-balls // MOST_DRAWN))
    standings = all_standings(parts)
    drag = drag_by_month(drawn, flown_with=season.setting.flight.drag or 1.0)
    left_over = {kind: left_over_by(drawn, kind) for kind in EDGES}
    home_runs = {kind: home_runs_by(counted, kind) for kind in HOME_RUN_EDGES}
    return SeasonAnswer(
        question=question,
        season=season,
        standings=standings,
        counted=counted,
        drawn=drawn,
        tables=tuple(_tables(survey)),
        not_read=tuple(UnreadFile(str(path), reason) for path, reason in survey.faults),
        warnings=cautions_of(survey),
        league=_league(counted, season.own_drag, balls),
        untracked=tracking_bias(survey),
        places=None if contact is None else _places(contact.relation),
        surfaces=() if contact is None else tuple(_errors_of_tables(contact)),
        other_bats=tuple(bat_gains(season)),
        drag=drag,
        own_drag=season.own_drag,
        left_over=left_over,
        home_runs_by=home_runs,
        agreement=agreement_of(home_runs, left_over),
        scatter={key: standing.spreads for key, standing in standings.items()},
        rare_shares={key: rare_shares(standing) for key, standing in standings.items()},
        cannot_tell=cannot_tell(survey.tables),
    )


def _errors_of_tables(contact: ContactSetting) -> Iterator[BatErrors]:
    for surface in (*contact.surfaces, *(other.surface for other in contact.others)):
        yield BatErrors(surface.bat.name, *table_errors(tabled_bat(surface.bat, ball=contact.ball))[:2])


def _tables(survey: Survey) -> Iterator[SeasonTable]:
    for table, counts, days in zip(survey.tables, survey.counts, survey.days, strict=True):
        headings = table.headings
        first, last = (None, None) if days is None else map(str, days)
        columns = {name: ColumnMeaning(column.heading, column.unit) for name, column in headings.columns.items()}
        yield SeasonTable(str(table.path), headings.system, table.lines, counts, first, last, columns, headings.passed)


def _places(relation: PlaceRelation) -> Places:
    nearer = -float(relation.weights[1]) * FOOT / SCALE[0]
    return Places(
        **vars(relation),
        spread=relation.spread,
        noise=relation.noise,
        a_pitch_outside=PitchOutside(FOOT, nearer),
    )


def _league(counted: pl.LazyFrame, drag: OwnDrag | None, balls: int) -> SeasonMeans:
    names = counted.collect_schema().names()
    missing = pl.lit(None, pl.Float64)
    squared_up, by_league, from_best = (
        pl.col(name).cast(pl.Float64) if name in names else missing
        for name in ("squared_up", "league_squared_up", "from_best")
    )
    row = (
        counted.select(
            home_runs=known_sum(is_home_run(pl.col("event"))),
            home_runs_expected=known_sum(pl.col("home_run_here").cast(pl.Float64)),
            from_best=from_best.mean(),
            squared_up=squared_up.mean(),
            squared_up_balls=squared_up.count(),
            league_squared_up=by_league.mean(),
            league_squared_up_balls=by_league.count(),
            squared_up_of_the_same=squared_up.filter(by_league.is_not_null()).mean(),
        )
        .collect(engine="streaming")
        .row(0, named=True)
    )
    with_own = with_usual = None
    if drag is not None:
        with_own = home_runs_with(counted, drag=1.0, error=drag.error / drag.drag)
        with_usual = home_runs_with(counted, drag=1 / drag.drag)
    usual = None if with_usual is None else with_usual.value
    hit, expected = row["home_runs"], row["home_runs_expected"]
    tail = None if hit is None or expected is None else home_run_tail(hit, expected)
    return SeasonMeans(
        balls=balls, **row, home_runs_by_drag=with_own, home_runs_with_usual_drag=usual, home_runs_tail=tail
    )


def _row_of(players: pl.DataFrame, batter: str) -> int:
    """Return the index of the row of a batter's number, or of a name that only one batter has."""
    names = [name for name in ("batter", "name") if name in players.columns]
    for name in names:
        places = (players[name] == batter).arg_true()
        if len(places) > 1:
            numbers = players["batter"].gather(places)
            listed = ", ".join(numbers.head(MOST_NAMED)) + (", …" if len(numbers) > MOST_NAMED else "")
            raise InputError(f"{len(numbers)} batters are called {batter!r}; give the number of one: {listed}")
        if len(places):
            return int(places[0])
    everybody = players[names[0] if batter.isdigit() else names[-1]].drop_nulls().unique(maintain_order=True).to_list()
    raise unknown_batter(batter, everybody)
