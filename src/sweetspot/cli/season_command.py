"""`sweetspot season`: a season's table, every ball of it."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.weather import DEFAULT_GAMES_AIR, GamesAirOptions
from sweetspot.errors import InputError
from sweetspot.units import grouped

if TYPE_CHECKING:
    from sweetspot.answers.season import SeasonAnswer
    from sweetspot.tables.headings import GivenColumns


@Parameter(name="*")
@dataclass(frozen=True)
class SwungOptions:
    """What was swung, and what else to try."""

    bat: Annotated[str | None, Parameter(help="Bat of all hitters: a name of the catalogue or a TOML file.")] = None
    bats: Annotated[
        Path | None, Parameter(help="CSV with columns batter and bat; a row without a batter is all others' bat.")
    ] = None
    try_bat: Annotated[
        list[str] | None, Parameter(name="--try", help="Another bat that every swing is tried with; may be repeated.")
    ] = None
    flight_only: Annotated[bool, Parameter(negative="", help="Leave the bats out.")] = False

    def named(self) -> dict[str, str] | None:
        """Return the bat of each batter, under "" that of all others; None: nothing was said."""
        from sweetspot.seasons.batters import read_bats

        if self.bat is not None and self.bats is not None:
            raise InputError(
                "--bat and --bats were both given; put the bat of all others into the table, without a batter"
            )
        if self.bats is not None:
            return read_bats(self.bats)
        return None if self.bat is None else {"": self.bat}


@Parameter(name="*")
@dataclass(frozen=True)
class SeasonColumnOptions:
    """What the columns of the tables mean, and whether that is all that is asked."""

    columns: ColumnOptions = DEFAULT_COLUMNS
    show_columns: Annotated[
        bool, Parameter(negative="", help="Print what the columns of the files mean, and stop.")
    ] = False


@Parameter(name="*")
@dataclass(frozen=True)
class WorkOptions:
    """Who does the work, and what of it is done already."""

    resume: Annotated[
        bool, Parameter(negative="", help="Keep answers that are in --out already and of the same plan.")
    ] = False
    workers: Annotated[
        int, Parameter(help="Processes that share the work (needs Dask, sweetspot[cluster]); 0: this one alone.")
    ] = 0
    scheduler: Annotated[
        str | None, Parameter(help="A running Dask scheduler, tcp://HOST:8786, whose workers see the same folders.")
    ] = None

    def __post_init__(self) -> None:
        """Refuse a number of processes that cannot be started."""
        if self.workers < 0:
            raise InputError(f"--workers was given as {self.workers}; allowed is 0 (this process alone) and up")

    @property
    def needs_folder(self) -> str:
        """Why --out must be given; "": it need not."""
        if self.resume:
            return "--resume needs --out, the folder that holds the answers so far"
        if self.workers or self.scheduler:
            return "--workers and --scheduler need --out, the folder that all of them write to"
        return ""


DEFAULT_SWUNG, DEFAULT_SEASON_COLUMNS, DEFAULT_WORK = SwungOptions(), SeasonColumnOptions(), WorkOptions()


def season(
    files: Annotated[list[Path], Parameter(help="Tables: Statcast exports, Trackman, plain; CSV, .csv.gz, Parquet.")],
    /,
    *,
    bats: SwungOptions = DEFAULT_SWUNG,
    columns: SeasonColumnOptions = DEFAULT_SEASON_COLUMNS,
    air: GamesAirOptions = DEFAULT_GAMES_AIR,
    player: Annotated[
        str | None, Parameter(help="A batter's number or name: a page to print of that player alone.")
    ] = None,
    work: WorkOptions = DEFAULT_WORK,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Tell every ball in play of tables of any size: where on the bat it was hit, how far it carries, who did what."""
    given = columns.columns.given()
    if columns.show_columns:
        return _show_columns(files, given)
    if output.out is None and work.needs_folder:
        raise InputError(work.needs_folder)
    from functools import partial

    from sweetspot.answers.season import season_answer
    from sweetspot.answers.season_question import SeasonQuestion, checked_season
    from sweetspot.cli.options.weather import weather_of
    from sweetspot.cli.output import patience, progress
    from sweetspot.seasons.cluster import run_on_cluster

    with patience():
        question = checked_season(
            SeasonQuestion(
                paths=files,
                bats=bats.named(),
                others=bats.try_bat or (),
                contact=not bats.flight_only,
                air=weather_of(air),
                given=given,
                system=output.units or "us",
                player=player,
                folder=output.out,
                resume=work.resume,
            )
        )
    run = partial(run_on_cluster, workers=work.workers, scheduler=work.scheduler)
    try:
        with progress("season") as report:
            answer = season_answer(question, run=run, progress=report)
        return _presented(answer, output)
    except KeyboardInterrupt:
        if output.out is None:
            raise
        words = f"interrupted; what is done lies in {output.out}, and --resume goes on"
        raise KeyboardInterrupt(words) from None


def _presented(answer: SeasonAnswer, output: OutputOptions) -> int:
    from sweetspot.cli.output import present
    from sweetspot.reports.season.document import player_page, season_document, unread_of, write_tables

    if output.out is not None:
        written = write_tables(answer, output.out)
        tables = f"; {', '.join(written)}" if written else ""
        print(f"sweetspot: wrote {output.out}: folders balls, ledger, counted{tables}", file=sys.stderr)
    player = answer.question.player
    code = present(season_document(answer) if player is None else player_page(answer.player(player)), output, long=True)
    for fault in unread_of(answer):
        print(f"sweetspot: not read: {fault}", file=sys.stderr)
    return max(code, int(bool(answer.not_read)))


def _show_columns(files: list[Path], given: GivenColumns) -> int:
    from tempfile import TemporaryDirectory

    from sweetspot.seasons.table_file import open_table

    bad = 0
    with TemporaryDirectory(prefix="sweetspot-season-") as folder:
        for number, path in enumerate(files):
            try:
                table = open_table(path, staging=Path(folder) / str(number), given=given)
            except InputError as error:
                print(f"sweetspot: not read: {error}", file=sys.stderr)
                bad = 1
                continue
            print(f"{path.name}: {table.headings.system}, {grouped(table.lines)} rows")
            for name, column in table.headings.columns.items():
                print(f"  {name:<18}{column.heading}{f' [{column.unit}]' if column.unit else ''}")
            print(f"  passed through: {', '.join(table.headings.passed) or 'nothing'}")
            for note in table.notes:
                print(f"  note: {note}")
    return bad
