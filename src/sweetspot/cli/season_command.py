"""`sweetspot season`: a season's table, every ball of it."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.columns import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.weather import DEFAULT_GAMES_AIR, GamesAirOptions
from sweetspot.errors import InputError
from sweetspot.units import grouped

if TYPE_CHECKING:
    from sweetspot.season.season_table import Season
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
        from sweetspot.season.bat_table import read_bats

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
        """Refuse a number of processes that nobody can start."""
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
    from sweetspot.season.batters import require_batter, strangers
    from sweetspot.season.own_tables import tables_of_balls
    from sweetspot.season.season_table import temporary_folder

    given = columns.columns.given()
    if columns.show_columns:
        return _show_columns(files, given)
    if output.out is None and work.needs_folder:
        raise InputError(work.needs_folder)
    files, own = tables_of_balls(files, out=output.out)
    if own:
        shown = ", ".join(path.name for path in own)
        print(f"sweetspot: left out, as season wrote them itself: {shown}", file=sys.stderr)
    names = bats.named()
    if batters := [who for who in names or () if who]:
        for batter in strangers(files, batters, given=given):
            print(f"sweetspot: {batter!r} of {bats.bats} is no batter of the tables", file=sys.stderr)
    if player is not None:
        require_batter(files, player, given=given)

    def computed(folder: Path) -> Season:
        from functools import partial

        from sweetspot.cli.options.weather import weather_of
        from sweetspot.cli.output import patience, progress
        from sweetspot.season.cluster import run_on_cluster
        from sweetspot.season.season_table import analyse_season, season_setting

        with patience():
            setting = season_setting(
                bats=names, others=bats.try_bat or (), contact=not bats.flight_only, system=output.units or "us",
                air=weather_of(air),
            )  # fmt: skip
        run = partial(run_on_cluster, workers=work.workers, scheduler=work.scheduler)
        with progress("season") as report:
            return analyse_season(
                files, setting=setting, folder=folder, given=given, resume=work.resume, run=run, progress=report
            )

    if output.out is not None:
        try:
            return _answered(computed(output.out), output, player)
        except KeyboardInterrupt:
            words = f"interrupted; what is done lies in {output.out}, and --resume goes on"
            raise KeyboardInterrupt(words) from None
    with temporary_folder() as folder:
        return _answered(computed(Path(folder)), output, player)


def _answered(season: Season, output: OutputOptions, player: str | None) -> int:
    from sweetspot.cli.output import present
    from sweetspot.report.season.document import season_document, season_report
    from sweetspot.report.season.one_player import player_page
    from sweetspot.report.season.tables import write_tables

    report = season_report(season)
    if output.out is not None:
        written = write_tables(report, output.out)
        tables = f"; {', '.join(written)}" if written else ""
        print(f"sweetspot: wrote {output.out}: folders balls, ledger, counted{tables}", file=sys.stderr)
    document = season_document(report) if player is None else player_page(report, player)
    code = present(document, output, long=True)
    code = max(code, int(bool(season.survey.faults)))
    for path, reason in season.survey.faults:
        named = "" if path.name in reason else f"{path.name}: "
        print(f"sweetspot: not read: {named}{reason}", file=sys.stderr)
    return code


def _show_columns(files: list[Path], given: GivenColumns) -> int:
    from sweetspot.season.season_table import temporary_folder
    from sweetspot.season.table_file import open_table

    bad = 0
    with temporary_folder() as folder:
        for number, path in enumerate(files):
            try:
                table = open_table(path, staging=Path(folder) / str(number), given=given)
            except InputError as error:
                print(f"sweetspot: not read: {error}", file=sys.stderr)
                bad = 1
                continue
            print(f"{path.name}: {table.headings.system}, {grouped(table.lines)} rows")
            for name, one in table.headings.columns.items():
                print(f"  {name:<18}{one.heading}{f' [{one.unit}]' if one.unit else ''}")
            print(f"  passed through: {', '.join(table.headings.passed) or 'nothing'}")
            for note in table.notes:
                print(f"  note: {note}")
    return bad
