"""A season in one call: tables in, answers out, whatever their size."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import polars as pl

from sweetspot.catalog.bats import DEFAULT_BAT, load_bat
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.collision.contact_table import tabled_bat
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.flight.air import Air
from sweetspot.seasons.ball_columns import (
    UNKNOWN_BAT,
    WHOSE_BAT,
    SeasonSetting,
    System,
    answer_columns,
    answer_headings,
    answers_of,
    bats_of,
    counted_rows,
)
from sweetspot.seasons.ball_maps import is_home_run
from sweetspot.seasons.balls import balls_of, together
from sweetspot.seasons.contact import LEARNT_FROM, ContactSetting, OtherBat, learnt
from sweetspot.seasons.duplicates import with_duplicates
from sweetspot.seasons.flight_choice import USUAL_FLIGHT, FlightChoice
from sweetspot.seasons.place_relation import PlaceRelation
from sweetspot.seasons.plan import (
    BALLS,
    COUNTED,
    FOLDERS,
    LEDGER,
    Plan,
    Progress,
    plan_fingerprint,
    run_here,
    sweep_plan,
)
from sweetspot.seasons.plane_hits import bat_in_plane
from sweetspot.seasons.rows import DATED, REASONED, REASONS, SIDED, USED, rows_of
from sweetspot.seasons.season_drag import SELECTED, OwnDrag, own_drag
from sweetspot.seasons.survey import Survey, survey_tables
from sweetspot.seasons.table_copies import LEFT_OUT
from sweetspot.seasons.table_file import TableWarning, frame_headings
from sweetspot.seasons.table_look import ENOUGH, NO_CLUB
from sweetspot.seasons.table_reader import PART, parts
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, Headings

DRAG_FROM = 40_000
"""Balls with a distance that the season's drag is learnt from, at most."""
PLACED = ("home_team", "park", "game_kind", "game", "event", "landing_confidence")
"""Quantities that tell where and when a ball was hit, how it ended, and whether its landing was measured."""
MOST_PARTS = 16
"""Parts of all tables that the relation of places is learnt from, at most."""


@dataclass(frozen=True)
class Season:
    """The results of a season.

    ``survey``: the first look at the tables. ``setting``: how; its relation of places and its drag are those learnt.
    ``folder``: of the answers: folders ``balls``, ``ledger`` and ``counted`` of Parquet files. ``own_drag``: that the
    balls fly with; None: that of the setting, for it was given, or no table tells.
    """

    survey: Survey
    setting: SeasonSetting
    folder: Path
    own_drag: OwnDrag | None = None

    def balls(self) -> pl.LazyFrame:
        """Return the balls with all answers beside the tables' own columns; missing where a table lacks a column."""
        return _scanned(self.folder / BALLS)

    def balls_parts(self) -> list[pl.LazyFrame]:
        """Return the same, each task's balls by themselves."""
        return [pl.scan_parquet(file) for file in _files(self.folder / BALLS)]

    def counted(self) -> pl.LazyFrame:
        """Return groups and measures of the balls, in SI."""
        return counted_in(self.folder)

    def counted_parts(self) -> list[pl.LazyFrame]:
        """Return the same, each task's balls by themselves."""
        return [pl.scan_parquet(file) for file in _files(self.folder / COUNTED)]

    def ledger(self) -> pl.LazyFrame:
        """Return the reason of every row of every table; lines that are no rows are counted in the survey alone."""
        return _scanned(self.folder / LEDGER)


def counted_in(folder: Path) -> pl.LazyFrame:
    """Return groups and measures of the balls whose answers lie in a folder, in SI."""
    return _scanned(folder / COUNTED)


def _scanned(folder: Path) -> pl.LazyFrame:
    return pl.concat([pl.scan_parquet(file) for file in _files(folder)], how="diagonal_relaxed")


def _files(folder: Path) -> list[Path]:
    return sorted(folder.glob("[0-9]*.parquet"))


def season_setting(
    *,
    bats: Mapping[str, str | Bat] | None = None,
    others: Sequence[str | Bat] = (),
    air: Air | None = None,
    flights: FlightChoice = USUAL_FLIGHT,
    contact: bool = True,
    system: System = "us",
    threads: int | None = None,
) -> SeasonSetting:
    """Return the setting with which tables are read.

    ``bats``: of each batter, a name of the catalogue, a file or a bat; "" is all others' bat. None: the catalogue's
    usual. ``air``: of games whose weather the tables do not give, at the elevation of fields whose park is not known;
    None: 72 degF and the usual, at sea level. ``flights``: ball, law, drag and field; without it, a baseball with
    its season's drag (`learn_drag`). ``threads``: workers of a task; None: one per core.
    """
    flight = flights.setting(air, threads=threads)
    pitched = flight.ball
    bat_of = {batter: _named(given) for batter, given in (bats or {"": DEFAULT_BAT}).items()}
    tried = [_named(given) for given in others]
    names = {batter: name for batter, (name, _) in bat_of.items()}
    if not contact:
        return SeasonSetting(flight, None, names, system)
    swings = swing_law()
    tables = {
        name: OtherBat(
            name, bat_in_plane(bat, ball=pitched), tabled_bat(bat, ball=pitched).model.body.moi(bat.choke + swings.axis)
        )
        for name, bat in dict([*bat_of.values(), *tried]).items()
        if bat is not None
    }
    swung = [tables[name] for name in dict.fromkeys(names.values()) if name in tables]
    surfaces, mois = tuple(table.surface for table in swung), tuple(table.moi for table in swung)
    others_tried = tuple(tables[name] for name, _ in tried if name in tables)
    return SeasonSetting(
        flight, ContactSetting(pitched, surfaces, mois, others_tried, swings, threads=threads), names, system
    )


def _named(given: str | Bat) -> tuple[str, Bat | None]:
    """Return the name of a bat in columns, and the bat; None for one that is not known."""
    if isinstance(given, str) and given == UNKNOWN_BAT:
        return given, None
    bat, name = (given, given.name) if isinstance(given, Bat) else (load_bat(given), given)
    return Path(name).stem if "/" in name or name.endswith(".toml") else name, bat


def analyse_season(
    paths: Sequence[Path | str],
    *,
    setting: SeasonSetting | None = None,
    folder: Path | str,
    given: GivenColumns = NOTHING_GIVEN,
    resume: bool = False,
    run: Callable[[Plan, Progress | None], None] | None = None,
    progress: Progress | None = None,
) -> Season:
    """Return a season's answers, in a folder.

    ``setting``: how; None: the usual. Its relation of places is learnt from the tables unless it was learnt before.
    ``given``: what a person says of columns that are not understood, ``GivenColumns({"exit_speed": "EV:mph"})``.
    ``run``: does a plan's tasks; None: in this process, two at a time.
    """
    folder = Path(folder)
    replaced = [(folder / name).resolve() for name in FOLDERS]
    if among := [path for path in paths if Path(path).resolve().parent in replaced]:
        raise InputError(f"{among[0]} is one of the answers in {folder}, which are replaced; write to another folder")
    staging = folder / ".tables"
    fresh = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        survey = survey_tables([Path(path) for path in paths], staging=staging, given=given)
        _require_balls(survey)
    except BaseException:
        _withdraw(staging, fresh)
        raise
    chosen = setting or season_setting()
    survey = replace(survey, warnings=(*survey.warnings, *_replaced(survey, chosen)))
    if chosen.flight.field is not None:
        here = ("unknown park", "part off")
        left = [
            warning
            for warning in survey.warnings
            if warning.name not in here or (warning.detail != NO_CLUB and warning.name != here[0])
        ]
        survey = replace(survey, warnings=tuple(left))
    learned = None if chosen.flight.drag is not None else learn_drag(survey, chosen)
    if learned is not None:
        chosen = replace(chosen, flight=replace(chosen.flight, drag=learned.drag))
    swung = any(table.headings.has("bat_speed") for table in survey.tables)
    if chosen.contact is not None and swung and not chosen.contact.relation.balls:
        chosen = replace(chosen, contact=replace(chosen.contact, relation=learn_relation(survey, chosen)))
    plan = Plan(survey.tables, survey.duplicates, chosen, folder)
    plan = replace(plan, fingerprint=plan_fingerprint(survey.tables, chosen, task_rows=plan.task_rows))
    if resume:
        sweep_plan(plan)
    else:
        for name in FOLDERS:
            shutil.rmtree(folder / name, ignore_errors=True)
    try:
        (run or run_here)(plan, progress)
    except InputError:
        if not (folder / BALLS).exists():  # else there is something to resume
            _withdraw(staging, fresh)
        raise
    sweep_plan(plan)  # of workers that were killed, too
    shutil.rmtree(staging, ignore_errors=True)
    return Season(survey, chosen, folder, learned)


def _replaced(survey: Survey, setting: SeasonSetting) -> Iterator[TableWarning]:
    """Yield the columns of tables that answers of the same name replace."""
    ours = {*answer_headings(setting), "table", "table_row"}
    for number, table in enumerate(survey.tables):
        headings = table.headings
        names = [*headings.passed, *(column.heading for column in headings.columns.values())]
        if lost := [name for name in names if name in ours]:
            yield TableWarning("replaced", number, table.rows, detail=", ".join(lost))


def _withdraw(staging: Path, fresh: Sequence[Path]) -> None:
    """Remove the copies of tables, and folders that were made for them, innermost first, where nothing else is in."""
    shutil.rmtree(staging, ignore_errors=True)
    with suppress(OSError):
        for place in fresh:
            place.rmdir()


def _require_balls(survey: Survey) -> None:
    """Refuse tables of which none can be read, or none holds a ball in play, or most balls cannot be."""
    if not survey.tables:
        raise InputError(survey.faults[0][1] if survey.faults else "no table was given; give CSV or Parquet files")
    if not any(counts[USED] for counts in survey.counts):
        why = (
            f"{sum(counts.get(reason, 0) for counts in survey.counts)} {reason} ({words})"
            for reason, words in {**REASONS, **LEFT_OUT}.items()
        )
        raise InputError(
            f"{survey.tables[0].path}: none of {survey.rows} rows is a ball in play with an exit speed: "
            f"{'; '.join(words for words in why if not words.startswith('0 '))}{_unread(survey)}. Look at its "
            "columns with --show-columns"
        )
    refused, used = (sum(counts.get(reason, 0) for counts in survey.counts) for reason in ("impossible", USED))
    if refused >= max(ENOUGH, used):
        doubts = (warning.detail for warning in survey.warnings if warning.name in ("swapped", "unit"))
        raise InputError(
            f"{survey.tables[0].path}: {refused} of {refused + used} balls in play have an exit speed or launch angle "
            f"that cannot be ({next(doubts, 'allowed is 1 to 125 mph and -90 to 90 degrees')}). Mend the headings, or "
            "say what the columns are, as in --column exit_speed=HEADING:km/h"
        )


def _unread(survey: Survey) -> str:
    """Return in words the number of rows without a readable number where one is expected."""
    count = sum(warning.count for warning in survey.warnings if warning.name == "unreadable")
    return f"; {count} rows hold words, or numbers with another unit, where a number should be" if count else ""


def learn_relation(survey: Survey, setting: SeasonSetting) -> PlaceRelation:
    """Return the relation of places along the bat to the pitch's, learnt from an even sample of all tables."""
    assert setting.contact is not None
    frames = [rows for _, rows in _sampled(survey, "bat_speed", most=LEARNT_FROM)]
    balls, bats = [balls_of(rows) for rows in frames], [bats_of(rows, setting) for rows in frames]
    if not balls:
        return setting.contact.relation
    return learnt(together(balls), np.concatenate(bats), setting.contact)


def learn_drag(survey: Survey, setting: SeasonSetting) -> OwnDrag | None:
    """Return the season's own drag over the law's, learnt from the tracked distances of an even sample of all tables.

    None where no table has enough of them, where the balls are home runs, which were selected by their carry, or where
    the distances are no carries of such balls (`own_drag`).
    """
    sample = list(_sampled(survey, "distance", most=DRAG_FROM))
    learned = None
    for _ in range(2):  # the second time from where the first led, for carry is no straight line in drag
        flown_with = 1.0 if learned is None else learned.drag
        bare = replace(setting, contact=None, flight=replace(setting.flight, drag=flown_with))
        counted = [counted_rows(rows, answers_of(rows, bare), headings) for headings, rows in sample]
        if not counted:
            return None
        flown = pl.concat(counted, how="diagonal_relaxed")
        gone = flown.select(is_home_run(pl.col("event")).fill_null(value=False).mean()).item() or 0.0
        learned = None if gone > SELECTED else own_drag(flown.lazy(), flown_with=flown_with)
        if learned is None:
            return None
    return learned


def _sampled(survey: Survey, quantity: str, *, most: int) -> Iterator[tuple[Headings, pl.DataFrame]]:
    """Yield about ``most`` balls with a quantity, of evenly drawn parts of the tables where these are many.

    Each with the headings of its columns.
    """
    having = [table.headings.has(quantity) for table in survey.tables]
    total = sum(counts[USED] for counts, has in zip(survey.counts, having, strict=True) if has)
    places = [
        (number, start)
        for number, table in enumerate(survey.tables)
        if having[number]
        for start in range(0, table.rows, PART)
    ]
    every = max(1, -(-len(places) // max(MOST_PARTS, sum(having))))
    step = max(1, total // every // most)
    for number, table in enumerate(survey.tables):
        starts = [start for mine, start in places[::every] if mine == number]
        measured = [name for name, column in table.headings.columns.items() if column.kind != "text"]
        wanted = ("exit_speed", *measured, *WHOSE_BAT, *REASONED, *SIDED, *DATED, *PLACED)
        for rows in parts(table, quantities=wanted, step=step, starts=starts):
            used = with_duplicates(rows, survey.duplicates[number]).filter(
                (pl.col("reason") == USED) & pl.col(quantity).is_not_null()
            )
            if len(used):
                yield table.headings.only(*wanted), used


def season_columns(
    frame: pl.DataFrame | pl.LazyFrame, *, setting: SeasonSetting | None = None, given: GivenColumns = NOTHING_GIVEN
) -> pl.LazyFrame:
    """Return a table with the answers beside its own columns, for the rows that are used; lazy in, lazy out.

    The relation of places is the setting's: learn it once from a season with `analyse_season`, or take the usual.

    ``frame``: Statcast, Trackman or any other names that are understood. Of a lazy one dates that may begin with the
    day, and whose name ``player_name`` is, are looked at before anything else is read. ``setting``: how; None: the
    usual. ``given``: what a person says of columns that are not understood.

    >>> import polars as pl
    >>> table = pl.DataFrame({"launch_speed": [103.0], "launch_angle": [27.5], "hc_x": [125.42], "hc_y": [50.0]})
    >>> flown = season_columns(table, setting=season_setting(contact=False)).collect()
    >>> bool(390 < flown["carry_ft"][0] < 430)
    True
    """
    if not isinstance(frame, pl.DataFrame | pl.LazyFrame):
        raise InputError(
            f"frame was given as {type(frame).__name__}; give a polars frame: polars.scan_csv or scan_parquet reads a "
            "file, polars.from_pandas takes one of pandas"
        )
    chosen = setting or season_setting()
    lazy = frame.lazy()
    headings = frame_headings(lazy, given=given)

    def answered(part: pl.DataFrame) -> pl.DataFrame:
        rows = rows_of(part, headings)
        used = (rows["reason"] == USED).to_numpy()
        columns = answer_columns(answers_of(rows.filter(used), chosen), chosen)
        fresh = {column.name for column in columns}
        passed = [column for column in part.filter(used).get_columns() if column.name not in fresh]
        return pl.DataFrame([*passed, *columns])

    schema = answered(lazy.clear().collect()).schema
    return lazy.map_batches(answered, schema=schema, streamable=True)
